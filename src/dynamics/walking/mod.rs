//! Recorded walking: the response of a structural mode to a recorded walk and to a cam, and the cam speed for which the force varies as recorded.

mod follower;
mod mode;
mod programme;
mod speed;
mod spline;

pub use follower::ProgrammeRun;
pub use mode::{Misfit, RepeatedForce};
pub use programme::{Bounds, Followed};
pub use speed::SpeedProgramme;

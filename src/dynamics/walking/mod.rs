//! Walking as it is: the response of a mode to a recorded walk and to a cam, and the speed of the cam with which its force varies as recorded.

mod follower;
mod mode;
mod programme;
mod speed;
mod spline;

pub use follower::ProgrammeRun;
pub use mode::{Misfit, RepeatedForce};
pub use programme::{Bounds, Followed};
pub use speed::SpeedProgramme;

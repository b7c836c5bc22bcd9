//! Recorded walking. The response of a structural mode to a recorded walk is compared with the response to a cam. A cam speed is computed for which
//! the force varies as recorded.

mod follower;
mod mode;
mod programme;
mod speed;
mod spline;

pub use follower::ProgrammeRun;
pub use mode::{Misfit, RepeatedForce};
pub use programme::{Bounds, Followed};
pub use speed::SpeedProgramme;

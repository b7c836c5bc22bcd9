//! Comparison of a cam with a recorded walk. The response of a structural mode to the force of the walk is compared with its response to
//! the force of the cam. A variable cam speed is computed with which the cam reproduces the recorded step times.

mod follower;
mod mode;
mod programme;
mod speed;
mod spline;

pub use follower::ProgrammeRun;
pub use mode::{Misfit, RepeatedForce};
pub use programme::{Bounds, Followed};
pub use speed::SpeedProgramme;

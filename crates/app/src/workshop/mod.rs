//! Files for CAD and manufacturing, if the build includes the feature `cad`.

mod piece;
#[cfg(feature = "cad")]
mod with_cad;
#[cfg(not(feature = "cad"))]
mod without_cad;

pub use piece::{Piece, usual_cutter};
#[cfg(feature = "cad")]
pub use with_cad::*;
#[cfg(not(feature = "cad"))]
pub use without_cad::*;

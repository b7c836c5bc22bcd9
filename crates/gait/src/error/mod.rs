//! Errors of a recording, a force curve or a load model.

mod force;
mod read;

pub use force::ForceError;
pub use gaitcam_base::error::{Error, Fault, Place, Placed, Result, nearest};
pub use read::{CycleColumn, FileKind, ReadError};

//! Force columns of a file before anything is decided about them.

use crate::recording::{Axis, Foot, ForceUnit};

/// A raw column of force with what its name says.
#[derive(Debug)]
pub(super) struct RawForce {
    pub name: String,
    pub axis: Axis,
    pub foot: Option<Foot>,
    pub unit: Option<ForceUnit>,
    pub values: Vec<f64>,
}

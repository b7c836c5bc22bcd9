//! The columns of a table that are read, before time and unit are decided.

use crate::read::vertical::RawForce;
use crate::recording::Note;

/// Raw columns with their time.
#[derive(Debug)]
pub(super) struct Raw {
    /// Times as written, where there is a time column.
    pub times: Option<Vec<f64>>,
    /// Seconds per unit of the times, if the column gives it.
    pub time_unit: Option<f64>,
    /// Whether times count samples.
    pub counts: bool,
    pub forces: Vec<RawForce>,
    pub samples: usize,
    pub skipped: Vec<usize>,
    /// What was guessed in the choice of columns.
    pub notes: Vec<Note>,
}

//! Results of several designs: comparison, and front of a table.

pub mod compare;
pub mod front;

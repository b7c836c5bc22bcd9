//! Results of several designs: side by side, and the best of a table.

pub mod compare;
pub mod front;

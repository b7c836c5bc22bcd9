//! The design in numbers.

pub mod csv;
pub mod json;
pub mod xlsx;

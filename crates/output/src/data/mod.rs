//! The design in numbers.

pub mod csv;
pub mod json;
#[cfg(feature = "xlsx")]
pub mod xlsx;

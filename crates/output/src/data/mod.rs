//! The design as numbers: CSV tables, JSON and workbooks.

pub mod covers;
pub mod csv;
pub mod inspection;
pub mod json;
pub mod xlsx;

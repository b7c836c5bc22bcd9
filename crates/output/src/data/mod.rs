//! The design as numbers: CSV, JSON and workbook.

pub mod csv;
pub mod json;
pub mod xlsx;

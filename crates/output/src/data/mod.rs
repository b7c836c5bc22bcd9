//! The design as numbers: CSV, JSON and workbook.

pub mod covers;
pub mod csv;
pub mod inspection;
pub mod json;
pub mod xlsx;

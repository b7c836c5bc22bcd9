//! Formatting of numbers and text in files and pages.

mod cell;
mod escape;
mod number;

pub use cell::{cell_text, cells, quoted, text_cell};
pub use escape::escaped;
pub use number::{append, append_decimal};

//! Drawing: shapes on a sheet, axes, how they become SVG and PNG.

pub mod axes;
pub mod layout;
pub mod palette;
pub mod picture;
pub mod png;
pub mod sheet;

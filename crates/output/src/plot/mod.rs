//! Drawing: shapes on a sheet, axes, and conversion to SVG and PNG.

pub mod axes;
pub mod layout;
pub mod palette;
pub mod picture;
mod raster;
pub mod sheet;
pub mod text;

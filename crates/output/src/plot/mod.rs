//! Drawing: shapes on a sheet, axes, how they become SVG and PNG.

pub mod axes;
mod coverage;
pub mod layout;
pub mod palette;
pub mod picture;
mod png;
pub mod raster;
pub mod sheet;

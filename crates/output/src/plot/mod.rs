//! Drawing: shapes on a sheet, axes, how they become SVG and PNG.

pub mod axes;
mod coverage;
pub mod layout;
mod outline;
pub mod palette;
pub mod picture;
mod png;
mod raster;
pub mod sheet;
pub mod text;

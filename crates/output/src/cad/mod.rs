//! The cam for CAD, printing and milling.

pub mod biarc;
pub mod cutter;
pub mod drawing;
pub mod dxf;
pub mod gcode;
pub mod groove;
pub mod mesh;
pub mod outline;
mod spline;
pub mod step;
pub mod svg;
mod threemf;
mod triangulate;

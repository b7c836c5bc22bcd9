//! What a design is handed over as: tables, drawings, pictures, a report, solids, a cutter path.
//!
//! Every emitter is pure: it takes a finished [`Synthesis`](gaitcam::synth::Synthesis) and returns text or
//! bytes; writing files is the command's business. Drawings are at true scale in millimetres, tables in
//! SI units with the unit in the column's name, pictures in millimetres and degrees.

#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod biarc;
mod cam_picture;
pub mod csv;
mod curvature_picture;
pub mod cutter;
pub mod dxf;
pub mod folder;
mod force_picture;
mod geometry;
pub mod groove;
pub mod json;
mod outline;
pub mod overlay;
mod panel;
pub mod picture;
pub mod plots;
mod raster;
pub mod recording;
pub mod report;
mod samples;
pub mod sheet;
pub mod solid;
pub mod svg;
pub mod sweep_plots;
pub mod sweep_report;
mod threemf;
pub mod xlsx;

/// How long the work took, s; measured by the caller, since emitters read no clock.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Timing {
    /// The synthesis alone.
    pub solve_s: f64,
    /// Everything up to now.
    pub total_s: f64,
}

//! Output formats of a design: tables, figures and report. Drawings and solids are in the crate `gaitcam_cad`.
//!
//! Every function is pure: it takes a finished [`Design`](gaitcam::synth::Design) and returns text or bytes. The command writes the files.
//! Drawings of the cam are true to scale. Tables are in SI units, with the unit in the name of the column. Figures are in millimetres and
//! degrees.

#![forbid(unsafe_code)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![deny(missing_docs)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

mod data;
pub mod facts;
mod figures;
pub mod gait;
pub mod identified;
#[cfg(feature = "parquet")]
pub mod parquet;
mod plot;
mod pose;
mod raster;
pub mod report;
pub mod simulation;
mod words;

pub use data::{covers as cover_tables, csv, inspection as inspection_data, json, xlsx};
pub use figures::identification::identification;
pub use figures::{cover, inspection, overlay, recording, sweep as sweep_plots};
pub use gaitcam::wording::Language;
pub use plot::picture::{self, Picture};
pub use plot::{palette, sheet};
pub use report::ActiveLimit;
pub use report::laws as laws_report;
pub use report::sweep as sweep_report;

/// Functions for drawings in other crates: sampled motion of a law, target force, and maximum drawn radius of curvature.
pub mod curve {
    pub use super::pose::{largest_radius, motion, target_at};
}

/// Figures of a design.
pub mod plots {
    pub use super::Picture;
    pub use super::figures::cam::cam;
    pub use super::figures::floor::floor;
    pub use super::figures::force::force;
    pub use super::figures::law::svaj;
    pub use super::figures::resonance::{
        Responding, Response, repeated_strides, resonance, responses,
    };
    pub use super::figures::run::run;
    pub use super::figures::speeds::{AtSpeed, speeds};
    pub use super::figures::walkers::walkers;
}

/// Computing times, s. The caller measures them, because output functions have no access to a clock.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Timing {
    /// Time for the synthesis alone, s.
    pub solve_s: f64,
    /// Total time from the start of the run, s.
    pub total_s: f64,
}

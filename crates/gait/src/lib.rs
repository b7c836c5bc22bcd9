//! Recordings of the vertical ground reaction force, their mean cycle, and published load models.
//!
//! [`read`], [`stances`] and [`cycle`] convert a recording from any laboratory to a [`ForceCurve`]. [`force_curve`] does these three steps
//! in one call. [`model`] returns the [`ForceCurve`] of a published load model.
//!
//! ```
//! use gaitcam_gait::{Feet, ReadOptions, force_curve};
//!
//! # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
//! // Two force plates, 10.5 s of walking: nine whole strides.
//! let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
//! assert!((curve.period_s - 2.0 / 1.9).abs() < 0.002);
//! assert!((curve.mean_n() - 700.0).abs() < 7.0);
//! # Ok::<(), gaitcam_gait::error::Error>(())
//! ```
#![forbid(unsafe_code)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![deny(missing_docs)]
#![deny(clippy::missing_errors_doc)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

mod curve;
mod cycle;
pub mod error;
mod generated_walk;
mod interpretation;
mod models;
mod population;
mod quantity;
mod read;
mod recording;
mod source;
mod stance;
mod statistics;
mod step_table;
mod walk;
pub mod wording;

pub use curve::{ForceCurve, SAMPLES};
pub use cycle::{Cycle, JointMean, LeftOut, Trial, cycle, implausible, joint_mean, overlay};
pub use gaitcam_base::units;
pub use generated_walk::StepStatistics;
pub use interpretation::{
    Clock, Column, Contact, Interpretation, MeanStanceCurve, Overlay, Period, RecordedStride,
    StrideReject, coded,
};
pub use models::{FourierForce, ModelInfo, Status, catalogue, model, of_harmonics, series};
pub use population::{
    Population, Walker, WalkerFault, WalkerRow, faults as walker_faults, is_table as is_population,
    read_rows as population_rows, read_table as read_population, write_table as population_csv,
};
pub use read::{
    Cell, NumberTable, PlateFile, joined_plates, metadata_name, of_arrays, plate_of, read,
};
pub use recording::{
    Axis, Channel, ClockSource, CycleSource, DecimalMark, Feet, Foot, ForceUnit, Format, Heels,
    Idle, Kind, MassSource, Note, OpenQuestion, PeriodSource, Processor, ReadOptions, Recording,
    Row, SeparatorName, Storage, Strike, UnitSource, WeightShare,
};
pub use source::{force_curve, one_cycle};
pub use stance::{Point, RejectReason, Rejected, Stance, Stances, stances};
pub use step_table::{StepRow, steps_csv};
pub use walk::{FEWEST_STRIDES, Variability, Walk};

/// Compiles and runs the program in the README as a doctest.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;

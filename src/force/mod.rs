//! The target force: load models and recordings of the vertical ground reaction force, as one periodic curve.
//!
//! A recording goes [`read`] → [`stances`] → [`cycle`] → [`ForceCurve`]; a published load model gives its
//! [`ForceCurve`] at once ([`model`]).

mod curve;
mod cycle;
mod feet;
mod models;
mod plausibility;
mod read;
mod recording;
mod report;
mod stance;

pub use curve::{ForceCurve, SAMPLES};
pub use cycle::{Cycle, Overlay, cycle, force_curve, overlay};
pub use feet::Feet;
pub use models::{ModelInfo, Status, catalogue, fourier, model};
pub use plausibility::doubt;
pub use read::{metadata_name, one_cycle, read};
pub use recording::{Channel, Foot, ForceUnit, ReadOptions, Recording, Row, Strike};
pub use report::{csv, cycle_json, cycle_table, json, spread_rms_n, table};
pub use stance::{Point, Rejected, Stance, Stances, Why, stances};

//! The target force: load models and recordings of the vertical ground reaction force, as one periodic curve.
//!
//! A recording goes [`read`] → [`stances`] → [`cycle`] → [`ForceCurve`]; a published load model gives its
//! [`ForceCurve`] at once ([`model`]).

mod curve;
mod cycle;
mod feet;
mod format;
mod interpretation;
mod joint;
mod kind;
mod models;
mod note;
mod plausibility;
mod quantity;
mod read;
mod recording;
mod report;
mod slopes;
mod source;
mod stance;

pub use curve::{ForceCurve, SAMPLES};
pub use cycle::{Cycle, MeanStanceCurve, Overlay, Period, cycle, overlay};
pub use feet::Feet;
pub use format::{DecimalMark, Format, Processor, SeparatorName, Storage};
pub use interpretation::{Clock, Column, Contact, Interpretation};
pub use joint::{JointMean, LeftOut, Trial, joint_mean};
pub use kind::{Kind, OpenQuestion};
pub use models::{ModelInfo, Status, catalogue, fourier, model};
pub use note::{
    Axis, ClockSource, CycleSource, MassSource, Note, PeriodSource, UnitSource, WeightShare,
};
pub use plausibility::implausible;
pub(crate) use read::{Cell, NumberTable};
pub use read::{metadata_name, of_arrays, one_cycle, read};
pub use recording::{Channel, Foot, ForceUnit, Idle, ReadOptions, Recording, Row, Strike};
pub use report::{
    LABELS, TrialRow, csv, cycle_json, cycle_table, json, spread_rms_n, table, trials_json,
    trials_table,
};
pub(crate) use slopes::slope_corrections;
pub use source::force_curve;
pub use stance::{Point, RejectReason, Rejected, Stance, Stances, stances};

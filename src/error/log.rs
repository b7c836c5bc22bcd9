//! Faults of the log of a running machine.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// Faults of a log.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum LogError {
    /// Neither time nor angle, or no force column.
    NoColumn { columns: String },
    /// Several columns for one quantity.
    ManyColumns { option: String, columns: String },
    /// A column without unit.
    NoUnit {
        column: String,
        unit: String,
        option: String,
    },
    /// A unit of another quantity, or an unknown one.
    UnknownUnit {
        column: String,
        unit: String,
        units: String,
    },
    /// An angle in counts of an encoder.
    Counts { column: String },
    /// A number of counts per turn that is not positive.
    BadCounts { counts: f64 },
    /// Counts per turn without a column of counts.
    NoCounts { columns: String },
    /// Columns of different lengths.
    Lengths {
        column: String,
        count: usize,
        rows: usize,
    },
    /// A constant angle.
    NoMotion { angle: f64 },
    /// A cell that is not a number.
    Value { column: String, typed: String },
    /// Time or angle does not increase.
    Order {
        column: String,
        value: f64,
        before: f64,
    },
    /// Too few rows for a cycle.
    FewRows { rows: usize, least: usize },
    /// A constant force signal.
    NoForce { force: f64 },
    /// A force with clipped peaks.
    Clipped { force: f64, percent: f64 },
    /// Too few whole cycles.
    Short { cycles: f64, least: usize },
    /// Too few samples per cycle.
    Aliased { samples: f64, needed: usize },
    /// A cycle with a gap.
    Gap { cycle: usize, samples: f64 },
    /// No repetition near the speed of the scene.
    NoCycle { speed: Quantity },
    /// The speed changes during the log.
    Drift { first: Quantity, last: Quantity },
    /// The mean cycle changes during the log.
    Changes { cycle: usize, percent: f64 },
    /// Hardly any alternating force.
    NoAlternating { found: Quantity, expected: Quantity },
    /// The force is probably in another unit.
    WrongUnit {
        unit: String,
        found: Quantity,
        expected: Quantity,
    },
    /// The force has another magnitude.
    OtherSize { found: Quantity, expected: Quantity },
    /// The force has the opposite sign.
    WrongSign,
    /// The same log twice.
    Copy { other: String },
    /// A parameter differs from that of another log.
    OtherMachine {
        key: String,
        value: Quantity,
        before: Quantity,
        other: String,
    },
    /// No common parameters explain the logs: force that they do not explain, RMS.
    Inconsistent { together: Quantity, alone: Quantity },
    /// A log of another speed than that of the design.
    OtherSpeed { speed: Quantity, design: Quantity },
    /// The cam does not turn once per cycle.
    NoTurn,
    /// A scene without a target force.
    NoTarget,
}

/// Reasons why a log gives no new cam.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum NoNewCamError {
    /// The repeatable error does not exceed the noise.
    Noise { residual: Quantity, noise: Quantity },
}

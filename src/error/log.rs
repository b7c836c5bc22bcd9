//! Errors in the log of a running machine.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// Errors in the log of a running machine that prevent its evaluation.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum LogError {
    /// The log has neither a time nor an angle column, or it has no force column.
    NoColumn { columns: String },
    /// Several columns match one quantity.
    ManyColumns { option: String, columns: String },
    /// A column has no unit.
    NoUnit {
        column: String,
        unit: String,
        option: String,
    },
    /// A column has an unknown unit, or the unit of another quantity.
    UnknownUnit {
        column: String,
        unit: String,
        units: String,
    },
    /// The angle is given in counts of an encoder.
    Counts { column: String },
    /// The number of counts per turn is not positive.
    BadCounts { counts: f64 },
    /// The counts per turn are given, but there is no column of counts.
    NoCounts { columns: String },
    /// The columns have different lengths.
    Lengths {
        column: String,
        count: usize,
        rows: usize,
    },
    /// The angle is constant.
    NoMotion { angle: f64 },
    /// A cell is not a number between −10⁹ and 10⁹.
    Value { column: String, typed: String },
    /// The values of the time or angle column do not increase.
    Order {
        column: String,
        value: f64,
        before: f64,
    },
    /// The log has too few rows for a cycle.
    FewRows { rows: usize, least: usize },
    /// The force signal is constant.
    NoForce { force: f64 },
    /// The peaks of the force are clipped.
    Clipped { force: f64, percent: f64 },
    /// The log has too few whole cycles.
    Short { cycles: f64, least: usize },
    /// The log has too few samples per cycle.
    Aliased { samples: f64, needed: usize },
    /// A cycle has a gap.
    Gap { cycle: usize, samples: f64 },
    /// The log has no periodic force near the speed of the scene.
    NoCycle { speed: Quantity },
    /// The speed changes during the log.
    Drift { first: Quantity, last: Quantity },
    /// The mean cycle changes during the log.
    Changes { cycle: usize, percent: f64 },
    /// The alternating force is much smaller than expected.
    NoAlternating { found: Quantity, expected: Quantity },
    /// The unit of the force column is probably wrong.
    WrongUnit {
        unit: String,
        found: Quantity,
        expected: Quantity,
    },
    /// The magnitude of the force differs from its expected value, which the scene determines.
    OtherSize { found: Quantity, expected: Quantity },
    /// The force has the opposite sign.
    WrongSign,
    /// A log is given twice.
    Copy { other: String },
    /// A parameter of the machine differs between two logs.
    OtherMachine {
        key: String,
        value: Quantity,
        before: Quantity,
        other: String,
    },
    /// No common set of parameters fits the logs. The values are the RMS residuals of the common fit and of the separate fit.
    Inconsistent { together: Quantity, alone: Quantity },
    /// The speed in the log differs from the design speed.
    OtherSpeed { speed: Quantity, design: Quantity },
    /// The cam does not turn forwards once per cycle.
    NoTurn,
    /// The scene has no target force.
    NoTarget,
}

/// Reasons why no corrected cam is computed from a log.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum NoNewCamError {
    /// The repeatable force error does not exceed the measurement noise.
    Noise { residual: Quantity, noise: Quantity },
}

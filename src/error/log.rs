//! Faults of the log of a running machine: what it shows instead of a steady run.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// What is wrong with a log.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum LogError {
    /// Neither time nor angle, or no force.
    NoColumn { columns: String },
    /// A cell that is no number.
    Value { column: String, typed: String },
    /// Time or angle does not increase.
    Order {
        column: String,
        value: f64,
        before: f64,
    },
    /// Too few rows for a cycle.
    FewRows { rows: usize, least: usize },
    /// A force that stands still.
    NoForce { force: f64 },
    /// A force whose peaks are cut off.
    Clipped { force: f64, percent: f64 },
    /// Too few cycles.
    Short { cycles: f64, least: usize },
    /// Too few samples per cycle.
    Aliased { samples: f64, needed: usize },
    /// A cycle with a gap.
    Gap { cycle: usize, samples: f64 },
    /// Nothing that repeats near the speed of the scene.
    NoCycle { speed: Quantity },
    /// A speed that changes.
    Drift { first: Quantity, last: Quantity },
    /// Another mean cycle after some cycle.
    Changes { cycle: usize, percent: f64 },
    /// Hardly any alternating force.
    NoAlternating { found: Quantity, expected: Quantity },
    /// The force is in another unit.
    WrongUnit {
        unit: String,
        found: Quantity,
        expected: Quantity,
    },
    /// The force is of another size.
    OtherSize { found: Quantity, expected: Quantity },
    /// The force has the other sign.
    WrongSign,
    /// The cam does not turn once per cycle.
    NoTurn,
    /// Nothing to correct a force to.
    NoTarget,
}

/// Why a log gives no new cam.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum NoNewCamError {
    /// What repeats is no more than noise.
    Noise { residual: Quantity, noise: Quantity },
}

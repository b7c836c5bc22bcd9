//! What was found in recordings: tables for people, JSON for programs, csv of the mean cycle.

mod csv;
mod json;
mod table;
mod trials;

pub use csv::csv;
pub use json::{cycle_json, json};
pub use table::{cycle_table, table};
pub use trials::{TrialRow, trials_json, trials_table};

use super::curve::ForceCurve;

/// Labels of the table: messages of the area `gait`.
pub const LABELS: &[&str] = &[
    "format",
    "kind",
    "kind-unknown",
    "rate",
    "mass",
    "mass-unknown",
    "note",
    "channel",
    "channel-columns",
    "stance-columns",
    "rejected",
    "more",
    "no-cycle",
    "cycle",
    "period",
    "mean",
    "warning",
    "spread",
    "repeatability",
    "samples",
    "doubt",
    "doubts",
    "trial-columns",
    "used",
    "left-out",
    "joint-mean",
    "no-joint-mean",
    "as-given",
    "several-sources",
    "one-cycle",
];

/// Root mean square over the cycle of the step-to-step standard deviation, N.
pub fn spread_rms_n(curve: &ForceCurve) -> Option<f64> {
    let s = curve.spread_n.as_ref()?;
    Some((s.iter().map(|x| x * x).sum::<f64>() / s.len().max(1) as f64).sqrt())
}

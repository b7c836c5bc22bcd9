//! `gaitcam synth --verbose`: iterations of the sequence of convex programs.

use gaitcam::cam::Unit;
use gaitcam::synth::Design;
use serde_json::json;

use super::summary::{filled, row};
use crate::{console::language, console::words};

/// Table with one line per iteration, and the reason why the sequence ended.
pub fn text(design: &Design) -> String {
    let solver = &design.solver;
    if solver.steps.is_empty() {
        return row("sequence", &words::text("synth-no-sequence"));
    }
    let length = Unit::length();
    let count = json!({"count": solver.steps.len()});
    let mut out = vec![
        filled("sequence", "synth-sequence", count),
        format!("  {}", words::text("synth-step-head")),
    ];
    for (i, step) in solver.steps.iter().enumerate() {
        out.push(words::decimal(format!(
            "  {:>4} {:>11.6} {} {:>18.10e} {:>20.3e} {:>13.4}",
            i + 1,
            length.factor * step.prime_radius,
            length.name,
            step.merit,
            step.clearance,
            step.taken
        )));
    }
    if let Some(ended) = solver.ended() {
        let why = json!({"why": ended.sentence(language::current())});
        out.push(format!("  {}", words::fill("synth-ended", &why)));
    }
    out.join("\n")
}

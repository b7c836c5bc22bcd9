//! Chart (b): a limit between the points of its rows.

use super::{Watch, footbridge, force_error};
use crate::chart::Chart;
use crate::tiers::{Between, Bound, Task};
use gaitcam::error::Result;
use gaitcam::law::Law;

/// Maximum jerk relative to that of the law without a limit.
const ALLOWED: f64 = 0.5;
const SPANS: usize = 14;
/// Tolerance of the interior-point method.
const TOLERANCE: f64 = 1e-9;

/// Relative excess of |jerk| of a law over `most`; 0 if the limit is satisfied.
pub fn violation(law: &Law, most: f64) -> f64 {
    (peak(law, 3) / most - 1.0).max(0.0)
}

/// Maximum absolute value of a derivative of the lift.
pub fn peak(law: &Law, order: usize) -> f64 {
    let (low, high) = law.extremes(order);
    high.value.max(-low.value)
}

/// Chart of a jerk limit on a quintic of 32 spans with every treatment.
pub fn chart(watch: &Watch) -> Result<Chart> {
    let (target, drive) = footbridge()?;
    let free = Task::quintic(&target, drive, SPANS);
    let most = ALLOWED * peak(&free.free()?, 3);
    let bounds = [Bound { order: 3, most }];
    let task = Task {
        bounds: &bounds,
        ..free
    };
    let best = task.conic(Between::Cone)?.solve(1e-10)?;
    let truth = force_error(&drive, &best, &target);
    let mut rows = Vec::new();
    let mut push = |mut row: crate::chart::Row, law: &Law| {
        let (broken, error) = (violation(law, most), force_error(&drive, law, &target));
        let loss = error / truth - 1.0;
        row.error = broken.max(loss.abs());
        row.note = format!("limit exceeded by {broken:.1e}, force error {loss:+.1e} of the best");
        rows.push(row);
    };
    for count in [1, 2, 4, 8, 16, 32] {
        let (answer, timing) = watch.time(|| task.conic(Between::Samples(count))?.solve(TOLERANCE));
        push(
            timing.row("samples on every span", format!("{count}"), 0.0),
            &answer?,
        );
    }
    for (name, between) in [
        ("Bernstein rows", Between::Coefficients),
        ("exact cones", Between::Cone),
    ] {
        let (answer, timing) = watch.time(|| task.conic(between)?.solve(TOLERANCE));
        push(timing.row(name, format!("{SPANS} spans"), 0.0), &answer?);
    }
    let (answer, timing) = watch.time(|| task.exchange());
    let row = timing.row("exchange at exact extrema", format!("{SPANS} spans"), 0.0);
    push(row.by_default(), &answer?);
    Ok(Chart {
        file: "speed_accuracy_b".to_string(),
        title: "(b) Limits between samples".to_string(),
        task: format!(
            "Quintic of {SPANS} spans on the footbridge force, jerk limited to {:.0} % of the maximum of the unlimited law.",
            100.0 * ALLOWED
        ),
        error: "larger of: true excess over the limit, force error beyond the best possible (both relative)".to_string(),
        advice: "Use the default, exchange. It is exact, certified on the continuous law, and faster than Bernstein rows, cones and all sampling methods. Samples alone do not limit the values between them.".to_string(),
        rows,
        ..Chart::default()
    })
}

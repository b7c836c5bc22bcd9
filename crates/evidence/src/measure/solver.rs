//! Chart (e): settings and sizes of the interior-point solver.

use super::limits::{peak, violation};
use super::{Watch, footbridge, force_error};
use crate::chart::{Chart, Row};
use crate::tiers::{Answer, Between, Bound, Settings, Task};
use gaitcam::drive::Drive;
use gaitcam::error::Result;
use gaitcam::force::ForceCurve;

/// The exact optimum, by which every answer is judged.
struct Truth<'a> {
    target: &'a ForceCurve,
    drive: Drive,
    most: f64,
    error: f64,
}

impl Truth<'_> {
    fn judge(&self, mut row: Row, answer: &Answer) -> Row {
        let broken = violation(&answer.law, self.most);
        let error = force_error(&self.drive, &answer.law, self.target);
        row.error = broken.max((error / self.error - 1.0).abs());
        row.note = format!(
            "{} iterations, limit exceeded by {broken:.1e}, force error {:+.1e}",
            answer.iterations,
            error / self.error - 1.0
        );
        row
    }
}

/// A jerk limit on quintics of 16 to 128 spans, exact cones, under the solver's settings.
pub fn chart(watch: &Watch) -> Result<Chart> {
    let (target, drive) = footbridge()?;
    let mut rows = Vec::new();
    let sizes: &[usize] = if watch.quick {
        &[16, 64]
    } else {
        &[16, 32, 64, 128]
    };
    for &spans in sizes {
        let free = Task::quintic(&target, drive, spans);
        let most = 0.6 * peak(&free.free()?.law, 3);
        let bounds = [Bound { order: 3, most }];
        let task = Task {
            bounds: &bounds,
            ..free
        };
        let (answer, timing) = watch.time(|| task.exchange());
        let answer = answer?;
        let tight = Settings {
            tolerance: 1e-11,
            ..Settings::default()
        };
        let best = task.conic(Between::Cone)?.solve(tight)?;
        let error = force_error(&drive, &best.law, &target);
        let truth = Truth {
            target: &target,
            drive,
            most,
            error,
        };
        let size = format!("{spans} spans");
        let row = timing.row("gaitcam: exchange and refinement", size, 0.0);
        rows.push(truth.judge(row.by_default(), &answer));
        settings(watch, &task, &truth, &mut rows)?;
    }
    Ok(Chart {
        file: "speed_accuracy_e".to_string(),
        title: "(e) Solver settings".to_string(),
        task: "Jerk held to 60 % of the free law's on the footbridge force; all rows at once as exact cones, against the exchange of rows. Settings as named, otherwise 1e-9 with equilibration, presolve and refinement; times include the setting up unless said.".to_string(),
        error: "larger of: true excess over the limit, difference of the force error from the exact cones' at 1e-11 (both relative)".to_string(),
        advice: "Take the default, the exchange of rows with a dual active set: several times faster than the interior point under any setting and exact to 1e-9; of the settings, refinement off saves a third at equal error, equilibration off loses digits.".to_string(),
        rows,
        ..Chart::default()
    })
}

fn settings(watch: &Watch, task: &Task, truth: &Truth, rows: &mut Vec<Row>) -> Result<()> {
    let usual = Settings::default();
    let tolerance = |tolerance| Settings { tolerance, ..usual };
    let (mut unscaled, mut whole, mut unrefined) = (usual, usual, usual);
    unscaled.equilibrate = false;
    whole.presolve = false;
    unrefined.refine = false;
    let variants = [
        ("tolerance 1e-4", tolerance(1e-4)),
        ("tolerance 1e-6", tolerance(1e-6)),
        ("tolerance 1e-9", usual),
        ("tolerance 1e-11", tolerance(1e-11)),
        ("no equilibration", unscaled),
        ("no presolve", whole),
        ("no refinement", unrefined),
    ];
    let size = format!("{} spans", task.spans);
    for (name, settings) in variants {
        let (answer, timing) = watch.time(|| task.conic(Between::Cone)?.solve(settings));
        let row = timing.row(name, size.as_str(), f64::NAN);
        rows.push(match answer {
            Ok(answer) => truth.judge(row, &answer),
            Err(e) => Row {
                note: e.to_string(),
                ..row
            },
        });
    }
    let conic = task.conic(Between::Cone)?;
    let mut prepared = conic.prepare(whole)?;
    let linear = conic.linear_part(task);
    let (answer, timing) = watch.time(|| {
        prepared.update(&linear)?;
        prepared.solve()
    });
    let row = timing.row("data update, structure kept", size, f64::NAN);
    rows.push(truth.judge(row, &answer?));
    Ok(())
}

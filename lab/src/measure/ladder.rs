//! Methods of the solver one by one, and their time against the number of spans.

use std::f64::consts::PI;
use std::path::Path;

use super::limits::{peak, violation};
use super::{footbridge, force_error};
use crate::chart::{self, Across, Chart, Row};
use crate::tiers::{self, Bound, Task};
use crate::timing::{Times, Watch};
use gaitcam::cam::smallest_prime_circle;
use gaitcam::error::Result;
use gaitcam::force::{self, Feet, ForceCurve, ReadOptions};
use gaitcam::law::{Extent, Law, Rise, Segment, program};
use gaitcam::scene;
use gaitcam::synth::synthesise;
use gaitcam_app::folder::Folder;

/// Limits on acceleration and jerk, relative to the peaks of the law without limits.
const HELD: [f64; 3] = [0.95, 0.6, 0.3];
/// Number of spans of the laws in the table.
const SPANS: usize = 32;

/// Row of a method: its name, its problem, and the reference of the error.
fn line(tier: &str, problem: impl Into<String>, timing: Times, error: f64, against: &str) -> Row {
    timing.row(tier, problem, error).noted(against)
}

/// Measures the table and the picture and writes ladder.md, ladder.csv, ladder_spans.svg and .png.
pub fn write(watch: &Watch, folder: &Folder, machine: &str) -> Result<()> {
    let rungs = Chart {
        file: "ladder".to_string(),
        title: "Each solver on its own problems".to_string(),
        task: "The remark names the reference of the error.".to_string(),
        error: "error".to_string(),
        across: Across::Spans,
        rows: [closed_forms(watch)?, programs(watch)?, scenes(watch)?].concat(),
        ..Chart::default()
    };
    let spans = against_spans(watch)?;
    folder.write_picture(&spans.file, &chart::picture(&spans))?;
    let mut page =
        format!("# The ladder of solvers\n\nMeasured by `gaitcam-lab chart`. {machine}\n");
    chart::section(&mut page, &rungs, false);
    chart::section(&mut page, &spans, true);
    folder.write("ladder.csv", chart::csv(&[rungs, spans]).as_bytes())?;
    folder.write("ladder.md", page.as_bytes())
}

/// Rows of the harmonic inversion and of the prime circle in closed form.
fn closed_forms(watch: &Watch) -> Result<Vec<Row>> {
    let (target, drive) = footbridge()?;
    let samples = (0..1000)
        .map(|i| target.at(2.0 * PI * f64::from(i) / 1000.0))
        .collect();
    let thousand = ForceCurve::from_samples("1000 samples", target.period_s, samples)?;
    let (law, timing) = watch.time(|| tiers::spectral(&thousand, drive, 20));
    let mut out = vec![line(
        "spectral",
        "footbridge force, 1000 samples, 20 harmonics",
        timing,
        force_error(&drive, &law?, &target),
        "the force, RMS of the mean",
    )];
    let hump = hump(PI / 3.0)?;
    let limit = PI / 6.0;
    let (circle, timing) = watch.time(|| smallest_prime_circle(&hump, limit, limit, Some(0.0)));
    // 3-4-5 rise and fall of 60° each, 30° on both sides, no offset.
    let exact = 2.636_48;
    out.push(line(
        "prime circle",
        "3-4-5 rise and fall of 60°, 30° on both sides",
        timing,
        (circle.radius / exact - 1.0).abs(),
        "2.63648 (five digits)",
    ));
    Ok(out)
}

fn hump(angle: f64) -> Result<Law> {
    let segment = |motion: Rise, lift: f64, angle: f64| Segment {
        motion,
        lift,
        angle,
    };
    let rest = segment(Rise::from_name("dwell")?, 0.0, 2.0 * PI - 2.0 * angle);
    let poly = Rise::from_name("3-4-5")?;
    program(
        &[
            segment(poly.clone(), 1.0, angle),
            segment(poly, -1.0, angle),
            rest,
        ],
        Extent::TURN,
    )
}

/// Rows of one factorisation, of the certified program by both methods, and of simpler treatments between samples.
fn programs(watch: &Watch) -> Result<Vec<Row>> {
    let (target, drive) = footbridge()?;
    let free = Task::quintic(&target, drive, SPANS);
    let (law, timing) = watch.time(|| free.free());
    let law = law?;
    let mut out = vec![line(
        "equality",
        format!("footbridge force, quintic, {SPANS} spans"),
        timing,
        force_error(&drive, &law, &target),
        "the force, RMS of the mean",
    )];
    for part in HELD {
        let bounds = [2, 3].map(|order| Bound {
            order,
            most: part * peak(&law, order),
        });
        let task = Task {
            bounds: &bounds,
            ..free.clone()
        };
        let (answer, timing) = watch.time(|| task.exchange());
        let ours = answer?;
        let (other, slower) = watch.time(|| task.interior_point());
        let error = |law: &Law| force_error(&drive, law, &target);
        let apart = (error(&ours) / error(&other?) - 1.0).abs();
        let what = format!(
            "the same, acceleration and jerk held to {:.0} %",
            100.0 * part
        );
        out.push(line(
            "qp",
            format!("{what}: active set"),
            timing,
            violation(&ours, bounds[1].most),
            "the jerk limit on a dense scan",
        ));
        out.push(line(
            "qp",
            format!("{what}: interior point"),
            slower,
            apart,
            "force error of the active set",
        ));
    }
    Ok(out)
}

/// Rows of complete syntheses whose method is a cone program or a sequence of programs.
fn scenes(watch: &Watch) -> Result<Vec<Row>> {
    let built_in = scene::built_in("heel_tester_fitted")?;
    let points = Path::new("../data/gait_curves/heel_tester_critical_points.csv");
    let bytes = scene::built_in_file(points).unwrap_or_default();
    let target = force::force_curve(points, bytes, &ReadOptions::default(), Feet::One)?;
    let mut out = Vec::new();
    let cases: [(&'static str, &[&str]); 2] = [
        (
            "a roller of 0.1 mm",
            &["cam.roller_radius=0.1 mm", "limits.curvature=none"],
        ),
        ("a roller of 1 in", &[]),
    ];
    for (roller, changes) in cases {
        let mut table = scene::table(built_in.toml)?;
        for change in changes {
            scene::set(&mut table, change)?;
        }
        let scene = scene::read(&table)?;
        let (design, timing) = watch.time(|| synthesise(&scene, Some(&target)));
        let design = design?;
        let gap = design
            .solver
            .certificate
            .map_or(f64::NAN, |c| c.relative_gap);
        out.push(line(
            design.solver.tier.name(),
            format!(
                "heel_tester_fitted, size minimised, {roller}: prime radius {:.3} mm",
                1e3 * design.cam.follower.prime_radius()
            ),
            timing,
            gap,
            "its own dual bound",
        ));
    }
    Ok(out)
}

/// Chart of time against the number of spans, for the factorisation and for one limit.
fn against_spans(watch: &Watch) -> Result<Chart> {
    let (target, drive) = footbridge()?;
    let sizes: &[usize] = if watch.quick {
        &[8, 32, 128]
    } else {
        &[8, 16, 32, 64, 100, 200, 400]
    };
    let mut rows = Vec::new();
    for &spans in sizes {
        let free = Task::quintic(&target, drive, spans);
        let (answer, timing) = watch.time(|| free.free());
        let mut push = |method: &str, timing: Times| {
            let seconds = timing.median;
            let row = timing.row(method, format!("{spans} spans"), seconds);
            rows.push(Row {
                points: Some(spans),
                ..row
            });
        };
        push("equality: one factorisation", timing);
        let bounds = [Bound {
            order: 2,
            most: 0.8 * peak(&answer?, 2),
        }];
        let task = Task {
            bounds: &bounds,
            ..free
        };
        let (_, timing) = watch.time(|| task.exchange());
        push("qp: acceleration at 80 %", timing);
    }
    Ok(Chart {
        file: "ladder_spans".to_string(),
        title: "Cost and number of spans".to_string(),
        task: "Quintic splines on the footbridge force of 1024 samples.".to_string(),
        error: "time of one run, s, median".to_string(),
        across: Across::Spans,
        advice: "The cost of a factorisation is proportional to the number of spans. With a limit, the cost increases with the number of contact points. A cam needs 8 to 60 spans.".to_string(),
        rows,
        ..Chart::default()
    })
}

//! `gaitcam synth --explain`: every choice of model, the number that decided it, the cost of the next.

pub mod choices;

use std::time::Instant;

use serde_json::{Value, json};

use choices::{choices, chord_error, force_change, force_of_points, run};
use gaitcam::dynamics::{Model, simulate};
use gaitcam::error::Result;
use gaitcam::force::ForceCurve;
use gaitcam::scene::Scene;
use gaitcam::synth::{Design, synthesise};

/// Runs of which the quickest counts.
const RUNS: usize = 5;

/// One line of the explanation.
pub struct Line {
    subject: &'static str,
    chosen: String,
    because: String,
    next: String,
}

/// Explains a design, running the next richer choices.
pub fn lines(
    scene: &Scene,
    target: Option<&ForceCurve>,
    design: &Design,
    points: usize,
) -> Result<Vec<Line>> {
    let mut out = Vec::new();
    let own = quickest(|| synthesise(scene, target)).1;
    for choice in choices(scene, design) {
        let mut next = choice.next;
        if let Some(richer) = &choice.richer {
            let (answer, seconds) = quickest(|| synthesise(richer, target));
            let change = match answer {
                Ok(other) if other.infeasible.is_none() => changed(design, &other),
                Ok(_) => "no law keeps the limits".to_string(),
                Err(fault) => fault.to_string(),
            };
            next = format!("{next}: {change}; {} instead of {}", ms(seconds), ms(own));
        }
        out.push(Line {
            subject: choice.subject,
            chosen: choice.chosen,
            because: choice.because,
            next,
        });
    }
    if design.cam.law.is_closed() {
        out.extend(dynamics(design, points));
    }
    out.push(output(design, points));
    Ok(out)
}

fn changed(design: &Design, other: &Design) -> String {
    let change = force_change(design, other);
    let mean = design.force.mean_n.abs();
    let part = if mean > 0.0 {
        format!(" ({:.4} % of the mean)", 100.0 * change / mean)
    } else {
        String::new()
    };
    format!(
        "the force moves by {change:.4} N RMS{part}, its error from {:.4} to {:.4} N",
        design.force.rms_error_n, other.force.rms_error_n
    )
}

fn dynamics(design: &Design, points: usize) -> Option<Line> {
    let run = run(design, points);
    let chosen = simulate(&run, Model::Auto).ok()?;
    let own = quickest(|| simulate(&run, chosen.model)).1;
    let next = match &chosen.next {
        None => "none".to_string(),
        Some(next) => {
            let seconds = quickest(|| simulate(&run, next.model)).1;
            let change = match &next.failed {
                Some(fault) => fault.to_string(),
                None => format!(
                    "least and largest force move by {:.4} and {:.4} N",
                    next.force_min, next.force_max
                ),
            };
            format!(
                "{}: {change}; {} instead of {}",
                next.model.name(),
                ms(seconds),
                ms(own)
            )
        }
    };
    Some(Line {
        subject: "dynamics",
        chosen: chosen.model.name().to_string(),
        because: chosen.why.sentence(crate::language::current()),
        next,
    })
}

fn output(design: &Design, points: usize) -> Line {
    let distance = |n: usize| {
        let chord = 1e6 * chord_error(&design.cam, n);
        match force_of_points(design, n) {
            Ok(force) => format!(
                "chords {chord:.4} µm from the profile, the force of the points {force:.2e} N RMS from the law's"
            ),
            Err(_) => format!("chords {chord:.4} µm from the profile"),
        }
    };
    let time = |n: usize| ms(quickest(|| design.cam.profile(n)).1);
    Line {
        subject: "points",
        chosen: points.to_string(),
        because: distance(points),
        next: format!(
            "{}: {}; {} instead of {}",
            2 * points,
            distance(2 * points),
            time(2 * points),
            time(points)
        ),
    }
}

/// The answer and the quickest of a few runs, s.
fn quickest<T>(f: impl Fn() -> T) -> (T, f64) {
    let answer = f();
    let best = (0..RUNS)
        .map(|_| {
            let start = Instant::now();
            std::hint::black_box(f());
            start.elapsed().as_secs_f64()
        })
        .fold(f64::INFINITY, f64::min);
    (answer, best)
}

fn ms(seconds: f64) -> String {
    format!("{:.3} ms", 1e3 * seconds)
}

/// For people.
pub fn text(name: &str, lines: &[Line]) -> String {
    let mut out = vec![format!("{name}: model selection")];
    for line in lines {
        out.push(format!("  {:<10}{}", line.subject, line.chosen));
        out.push(format!("            because {}", line.because));
        out.push(format!("            next richer model {}", line.next));
    }
    out.join("\n")
}

/// For programs: `explain` of summary.json.
pub fn json(lines: &[Line]) -> Value {
    lines
        .iter()
        .map(|l| json!({"subject": l.subject, "chosen": l.chosen, "because": l.because, "next": l.next}))
        .collect()
}

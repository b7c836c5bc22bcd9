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

use crate::console::words::fixed;
use crate::{console::language, console::words};

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
                Ok(_) => words::text("explain-no-law"),
                Err(fault) => fault.sentence(language::current()),
            };
            next = instead(&next, &change, seconds, own);
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
    let mut values = json!({"change": fixed(change, 4), "before": fixed(design.force.rms_error_n, 4),
        "after": fixed(other.force.rms_error_n, 4)});
    if mean == 0.0 {
        return words::fill("explain-change", &values);
    }
    values["percent"] = fixed(100.0 * change / mean, 4).into();
    words::fill("explain-change-of-mean", &values)
}

/// The next choice with what it changes and what it costs.
fn instead(next: &str, change: &str, seconds: f64, own: f64) -> String {
    words::fill(
        "explain-instead",
        &json!({"next": next, "change": change, "time": ms(seconds), "own": ms(own)}),
    )
}

fn dynamics(design: &Design, points: usize) -> Option<Line> {
    let run = run(design, points);
    let chosen = simulate(&run, Model::Auto).ok()?;
    let own = quickest(|| simulate(&run, chosen.model)).1;
    let next = match &chosen.next {
        None => words::text("explain-none"),
        Some(next) => {
            let seconds = quickest(|| simulate(&run, next.model)).1;
            let change = match &next.failed {
                Some(fault) => fault.sentence(language::current()),
                None => words::fill(
                    "explain-forces-move",
                    &json!({"least": fixed(next.force_min, 4), "most": fixed(next.force_max, 4)}),
                ),
            };
            instead(
                &crate::console::words::name(next.model.name()),
                &change,
                seconds,
                own,
            )
        }
    };
    Some(Line {
        subject: "dynamics",
        chosen: crate::console::words::name(chosen.model.name()),
        because: chosen.why.sentence(language::current()),
        next,
    })
}

fn output(design: &Design, points: usize) -> Line {
    let distance = |n: usize| {
        let chord = 1e6 * chord_error(&design.cam, n);
        let chord = fixed(chord, 4);
        match force_of_points(design, n) {
            Ok(force) => words::fill(
                "explain-chords-force",
                &json!({"chord": chord, "force": words::power(force, 2)}),
            ),
            Err(_) => words::fill("explain-chords", &json!({"chord": chord})),
        }
    };
    let time = |n: usize| quickest(|| design.cam.profile(n)).1;
    Line {
        subject: "points",
        chosen: points.to_string(),
        because: distance(points),
        next: instead(
            &(2 * points).to_string(),
            &distance(2 * points),
            time(2 * points),
            time(points),
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
    format!("{} ms", fixed(1e3 * seconds, 3))
}

/// For people.
pub fn text(name: &str, lines: &[Line]) -> String {
    let subjects: Vec<String> = lines.iter().map(|l| words::name(l.subject)).collect();
    let width = subjects
        .iter()
        .map(|s| s.chars().count())
        .max()
        .unwrap_or(0);
    let mut out = vec![words::fill("explain-title", &json!({"name": name}))];
    for (line, subject) in lines.iter().zip(&subjects) {
        let because = words::fill("explain-because", &json!({"reason": line.because}));
        let next = words::fill("explain-next", &json!({"next": line.next}));
        out.push(format!("  {subject:<width$}  {}", line.chosen));
        out.push(format!("  {:width$}  {because}", ""));
        out.push(format!("  {:width$}  {next}", ""));
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

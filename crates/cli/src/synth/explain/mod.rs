//! `gaitcam synth --explain`: every choice of model, the number that decided it, the cost of the next.

pub mod choices;

use std::time::Instant;

use serde_json::{Value, json};

use choices::{Choice, choices, chord_error, force_change, force_of_points, run};
use gaitcam::dynamics::{Model, simulate};
use gaitcam::error::Result;
use gaitcam::force::ForceCurve;
use gaitcam::scene::Scene;
use gaitcam::synth::{Design, synthesise};

use crate::console::words::fixed;
use crate::{console::language, console::words};

/// Runs of which the quickest counts.
const RUNS: usize = 5;

/// Explains a design, running the next richer choices.
pub fn lines(
    scene: &Scene,
    target: Option<&ForceCurve>,
    design: &Design,
    points: usize,
) -> Result<Vec<Choice>> {
    let mut out = Vec::new();
    let own = quickest(|| synthesise(scene, target)).1;
    for mut choice in choices(scene, design) {
        if let Some(richer) = &choice.richer {
            let (answer, seconds) = quickest(|| synthesise(richer, target));
            let change = match answer {
                Ok(other) if other.infeasible.is_none() => changed(design, &other),
                Ok(_) => words::text("explain-no-law"),
                Err(fault) => fault.sentence(language::current()),
            };
            choice.next = instead(&choice.next, &change, seconds, own);
        }
        out.push(choice);
    }
    if design.cam.law.is_closed() {
        out.extend(dynamics(design, points));
    }
    out.push(output(design, points));
    Ok(out)
}

fn changed(design: &Design, other: &Design) -> String {
    let newtons = |force: f64| design.problem.drive.newtons(force);
    let [change, mean] = [force_change(design, other), design.force.mean_n.abs()].map(newtons);
    let [before, after] = [design, other].map(|d| newtons(d.force.rms_error_n));
    let mut values = json!({"change": fixed(change, 4), "before": fixed(before, 4),
        "after": fixed(after, 4)});
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

fn dynamics(design: &Design, points: usize) -> Option<Choice> {
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
            instead(&words::name(next.model.name()), &change, seconds, own)
        }
    };
    Some(Choice {
        subject: "dynamics",
        chosen: words::name(chosen.model.name()),
        because: chosen.why.sentence(language::current()),
        next,
        richer: None,
    })
}

fn output(design: &Design, points: usize) -> Choice {
    let distance = |n: usize| {
        let mut values = json!({"chord": fixed(1e6 * chord_error(&design.cam, n), 4)});
        let Ok(force) = force_of_points(design, n) else {
            return words::fill("explain-chords", &values);
        };
        values["force"] = words::power(force, 2).into();
        words::fill("explain-chords-force", &values)
    };
    let time = |n: usize| quickest(|| design.cam.profile(n)).1;
    let twice = 2 * points;
    Choice {
        subject: "points",
        chosen: points.to_string(),
        because: distance(points),
        next: instead(
            &twice.to_string(),
            &distance(twice),
            time(twice),
            time(points),
        ),
        richer: None,
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
pub fn text(name: &str, lines: &[Choice]) -> String {
    let subjects: Vec<String> = lines.iter().map(|l| words::name(l.subject)).collect();
    let width = subjects.iter().map(|s| s.chars().count()).max();
    let width = width.unwrap_or(0);
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
pub fn json(lines: &[Choice]) -> Value {
    lines
        .iter()
        .map(|l| json!({"subject": l.subject, "chosen": l.chosen, "because": l.because, "next": l.next}))
        .collect()
}

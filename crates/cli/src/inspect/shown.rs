//! Results of the inspection of a manufactured cam as text and JSON.

use serde_json::{Value, json};

use crate::console::language;
use crate::console::words::{self, number};
use gaitcam::cam::{Deviation, Inspection, Measures};
use gaitcam::sweep::{Behaviour, MadeCam};
use gaitcam::synth::Design;

fn outliers(inspected: &Inspection) -> impl Iterator<Item = &Deviation> {
    inspected.deviations.iter().filter(|d| d.is_outlier)
}

/// Data of the message about outliers, with at most ten line numbers of the file; `None` without outliers.
fn about_outliers(inspected: &Inspection, lines: &[usize]) -> Option<Value> {
    let most = outliers(inspected)
        .map(|d| d.normal.abs())
        .reduce(f64::max)?;
    let mut rows: Vec<usize> = outliers(inspected).map(|d| lines[d.row]).collect();
    rows.sort_unstable();
    let count = rows.len();
    let mut named: Vec<String> = rows.iter().take(10).map(usize::to_string).collect();
    if count > named.len() {
        named.push("…".to_string());
    }
    let most = number(1e6 * most);
    Some(json!({"count": count, "most": most, "lines": named.join(", ")}))
}

pub(super) fn text(
    design: &Design,
    inspected: &Inspection,
    made: Option<&MadeCam>,
    file_lines: &[usize],
) -> String {
    let measures = design.cam.follower.measures();
    let micro = |x: f64| number(1e6 * x);
    let degrees = |x: f64| number(x.to_degrees());
    let place = |x: f64| measures.place(x, language::current());
    let mut lines = vec![format!("{}:", design.problem.name)];
    let mut line = |key: &str, data: Value| lines.push(format!("  {}", words::fill(key, &data)));
    let centre = inspected.centre.map(words::length);
    line(
        "inspect-fit",
        json!({"points": inspected.deviations.len().to_string(), "turn": degrees(inspected.turn), "x": centre[0], "y": centre[1]}),
    );
    if !inspected.alike.is_empty() {
        let others: Vec<String> = inspected
            .alike
            .iter()
            .map(|t| format!("{}°", degrees(*t)))
            .collect();
        line("inspect-alike", json!({"others": others.join("; ")}));
    }
    if let Some([least, most]) = inspected.extremes() {
        line(
            "inspect-deviation",
            json!({"rms": micro(inspected.rms()), "least": micro(least.normal), "below": place(least.theta),
                "most": micro(most.normal), "above": place(most.theta)}),
        );
    }
    if let Some(outliers) = about_outliers(inspected, file_lines) {
        line("inspect-outliers", outliers);
    }
    if let Some(ends) = inspected.unmeasured {
        let [from, to] = ends.map(place);
        line("inspect-part", json!({"from": from, "to": to}));
    }
    let Some(made) = made else {
        return lines.join("\n");
    };
    let lift = measures.lift(0);
    let left = lift.after(&words::power(lift.factor * made.left, 1));
    line(
        "inspect-waves",
        json!({"waves": made.waves.to_string(), "left": left}),
    );
    lines.extend(comparison(design, made, measures));
    lines.join("\n")
}

/// Row that compares two cams: key of the message, function for the value, unit.
type Compared<'a> = (&'a str, fn(&Behaviour) -> Option<f64>, &'a str);

/// Lines that compare the design with the manufactured cam, one per quantity.
fn comparison(design: &Design, made: &MadeCam, measures: Measures) -> Vec<String> {
    let force = measures.force().name;
    let acceleration = measures.by_time(2).name;
    let all: [Compared; 6] = [
        ("inspect-rms", |b| b.rms_error_n, force),
        ("inspect-max", |b| b.max_error_n, force),
        ("inspect-least-force", |b| Some(b.min_n), force),
        ("inspect-most-force", |b| Some(b.max_n), force),
        (
            "inspect-acceleration",
            |b| Some(b.acceleration),
            acceleration,
        ),
        ("inspect-liftoff", |b| b.liftoff_speed, "rad/s"),
    ];
    let defined = all.iter().filter(|row| row.2 != force || !design.is_idle());
    let line = |(key, value, unit): &Compared| {
        let number = words::number;
        let (before, after) = (number(value(&made.designed)?), number(value(&made.made)?));
        let data = json!({"before": before, "after": after, "unit": unit});
        Some(format!("  {}", words::fill(key, &data)))
    };
    let mut out: Vec<String> = defined.filter_map(line).collect();
    let speed = design.problem.drive.speed.abs();
    let lifts = made.made.liftoff_speed.is_some_and(|w| w < speed);
    if lifts {
        out.push(format!("  {}", words::text("inspect-lifts-off")));
    }
    out
}

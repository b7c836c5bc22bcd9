//! A front as CSV, JSON and text.

use std::path::Path;

use serde_json::{Value, json};

use super::read::Columns;
use super::{Evaluation, FrontArgs, SHOWN, objective};
use crate::console::table::{Side, table};
use crate::console::words;
use gaitcam::sweep::Point;
use gaitcam::sweep::table::text_cell;

pub(super) fn csv(columns: &Columns, front: &[&Point]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing to memory cannot fail.
    let _ = writer.write_record(&columns.names);
    for p in front {
        let _ = writer.write_record(p.cells.iter().map(|c| text_cell(c).into_owned()));
    }
    writer
        .into_inner()
        .ok()
        .and_then(|b| String::from_utf8(b).ok())
        .unwrap_or_default()
}

/// Front as JSON: objectives, designs and best design, in SI units.
pub(super) fn object(
    args: &FrontArgs,
    evaluated: &Evaluation,
    front: &[&Point],
    best: &Point,
) -> Value {
    let named = |maximised: bool| -> Vec<&str> {
        let all = evaluated.objectives.iter();
        all.filter(|o| o.maximised == maximised)
            .map(|o| o.name.as_str())
            .collect()
    };
    let point = |p: &Point| {
        let mut out = json!({"row": p.row});
        for (objective, cost) in evaluated.objectives.iter().zip(&p.values) {
            out[&objective.name] = json!(objective.value(*cost));
        }
        out
    };
    let points: Vec<Value> = front.iter().map(|p| point(p)).collect();
    let missing = evaluated
        .missing
        .iter()
        .map(|rows| [rows.start, rows.end - 1]);
    json!({"file": args.file.display().to_string(), "rows": evaluated.kept.seen,
        "missing_rows": missing.collect::<Vec<_>>(),
        "candidates": evaluated.kept.candidates, "not_for_high_speed_left_out": evaluated.left_out,
        "minimise": named(false), "maximise": named(true), "front": points, "best": point(best)})
}

/// Label of a row: the name of its recording if recordings are varied, otherwise the row number.
pub(super) fn row_name(columns: &Columns, point: &Point) -> String {
    let recording = columns.names.iter().position(|n| n == "gait.file");
    let file = recording.map(|c| Path::new(&point.cells[c]));
    match file.and_then(Path::file_name) {
        Some(name) => name.to_string_lossy().into_owned(),
        None => point.row.to_string(),
    }
}

pub(super) fn text(
    args: &FrontArgs,
    evaluated: &Evaluation,
    front: &[&Point],
    best: &Point,
) -> String {
    let kept = &evaluated.kept;
    let mut out = vec![words::fill(
        "front-counts",
        &json!({"file": args.file.display().to_string(), "candidates": kept.candidates.to_string(),
            "seen": kept.seen.to_string(), "front": front.len().to_string()}),
    )];
    let labels = evaluated.objectives.iter().map(objective::label);
    let head = std::iter::once(words::text("front-row")).chain(labels);
    let mut rows = vec![head.chain([String::new()]).collect()];
    for p in front.iter().take(SHOWN) {
        let both = evaluated.objectives.iter().zip(&p.values);
        let values = both.map(|(o, cost)| objective::shown(o, *cost));
        let mark = match p.row == best.row {
            true => words::text("front-best"),
            false => String::new(),
        };
        let name = std::iter::once(row_name(&evaluated.columns, p));
        rows.push(name.chain(values).chain([mark]).collect());
    }
    out.push(table(&rows, &[Side::Right]));
    if front.len() > SHOWN {
        let more = json!({"count": front.len() - SHOWN, "row": best.row.to_string()});
        out.push(words::fill("front-more", &more));
    }
    out.join("\n")
}

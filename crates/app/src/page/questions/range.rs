//! Verdicts of the designs over a range of values of one key, which the page shows on its slider.

use serde::Deserialize;
use serde_json::{Value, json};
use toml::Table;

use crate::page::edit::{Edit, apply};
use crate::page::questions::design::{Input, changed};
use crate::page::sources::Files;
use gaitcam::cam::Verdict;
use gaitcam::error::Result;
use gaitcam::scene::keys::{self, Kind};

/// Time, s, after which no further design is started. The page requests the values in several blocks and can stop between two blocks.
const BLOCK: f64 = 0.12;
/// Maximum number of checks of the stop condition in the search of one design. Unlike a time limit, this number gives the same verdicts on every
/// machine.
const LOOKS: usize = 3000;
/// Maximum number of values in one request.
const MOST: usize = 200;

/// Request for the verdicts over a range of values of one key.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Span {
    /// TOML text of the scene.
    pub scene: String,
    /// Changes of the scene, applied in order.
    #[serde(default)]
    pub changes: Vec<Edit>,
    /// Dotted key of the varied value.
    pub key: String,
    /// First value, in `unit`.
    pub from: f64,
    /// Last value, in `unit`.
    pub to: f64,
    /// Number of values, equally spaced.
    pub count: usize,
    /// Unit after the number in a scene file, including the space before it. It is empty for a count.
    #[serde(default)]
    pub unit: String,
}

/// Verdicts of the designs for all values, in the order of the values: `[[20.0, "unacceptable"], …]`.
///
/// The list contains at least one entry. It is shorter than requested if the time limit of a block is reached. The verdict is "unknown" if
/// the search ended early and the design did not pass its checks. It is "fault" if no design can be computed with this value.
///
/// # Errors
///
/// The text of the scene is not TOML, or a change cannot be applied to it.
pub fn range(files: &Files, span: &Span) -> Result<Value> {
    let table = changed(files, &span.scene, &span.changes)?;
    let end = files.host.seconds() + BLOCK;
    let mut verdicts: Vec<(f64, &str)> = Vec::new();
    for value in values(span) {
        let is_late = files.host.seconds() >= end || files.host.halt().is_asked();
        if is_late && !verdicts.is_empty() {
            break;
        }
        verdicts.push((value, verdict(files, &table, span, value)));
    }
    Ok(json!({ "values": verdicts }))
}

/// Equally spaced values of the key. Counts are rounded to whole numbers. Equal values appear once.
fn values(span: &Span) -> Vec<f64> {
    let count = span.count.clamp(1, MOST);
    let step = (span.to - span.from) / count.saturating_sub(1).max(1) as f64;
    let whole = keys::find(&span.key).is_some_and(|k| matches!(k.kind, Kind::Count(..)));
    let at = (0..count).map(|i| span.from + step * i as f64);
    let mut all: Vec<f64> = at.map(|x| if whole { x.round() } else { x }).collect();
    all.dedup();
    all
}

fn verdict(files: &Files, table: &Table, span: &Span, value: f64) -> &'static str {
    let mut table = table.clone();
    let edit = Edit::Set {
        key: span.key.clone(),
        value: format!("{value}{}", span.unit),
    };
    if apply(&mut table, &edit, &|table| Ok(files.scene(table)?.0)).is_err() {
        return "fault";
    }
    let halt = files.host.halt().or_after(LOOKS);
    let input = Input::read(files, table);
    let Ok(made) = input.and_then(|i| i.design(files, &halt)) else {
        return "fault";
    };
    let design = &made.design;
    let is_passing = design.verdict != Verdict::Unacceptable;
    match &design.infeasible {
        _ if halt.was_heard() && !is_passing => "unknown",
        Some(_) => "infeasible",
        None => design.verdict.name(),
    }
}

//! Changes of values that make a design acceptable.

use serde::Serialize;
use serde_json::{Value, json};

use super::design::{Which, made, reasons, shown};
use crate::page::sources::Files;
use crate::page::{table, words};
use gaitcam::error::Result;
use gaitcam::scene::{Scene, keys};
use gaitcam::synth::{Design, Relaxation, Search, in_units};

/// A change that is sufficient for a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Change {
    key: &'static str,
    /// `goal` if the change allows a larger force error, else `limit`.
    kind: &'static str,
    /// Cost of a changed goal: the allowed force error in per cent; null for a limit.
    cost: Option<f64>,
    from: String,
    /// Value for display; null if no value of this key alone is sufficient.
    to: Option<String>,
    /// Value as written in a scene file.
    value: Option<String>,
}

/// Suggestions from the conflict only, before each value is checked with the full design.
pub fn first_remedies(design: &Design, scene: &Scene) -> Vec<Change> {
    let own = match &design.infeasible {
        Some(infeasible) if design.relaxations.is_empty() => &infeasible.relaxations,
        _ => &design.relaxations,
    };
    remedies(design, scene, own)
}

fn remedies(design: &Design, scene: &Scene, list: &[Relaxation]) -> Vec<Change> {
    let measures = design.cam.follower.measures();
    let shown = |r: &Relaxation, x: f64| in_units(measures, r.limit, x, words::current());
    let mut changes: Vec<Change> = list
        .iter()
        .map(|r| Change {
            key: r.key,
            kind: if r.is_goal() { "goal" } else { "limit" },
            cost: r.to.filter(|_| r.is_goal()).map(|to| 100.0 * to),
            from: shown(r, r.from),
            to: r.to.map(|to| shown(r, to)),
            value: r.to.and_then(|to| value(r.key, scene, to)),
        })
        .collect();
    // Changes that allow a larger force error are listed last.
    changes.sort_by_key(|change| change.kind == "goal");
    changes
}

/// Number of a key as written in a scene file.
fn value(key: &str, scene: &Scene, x: f64) -> Option<String> {
    let row = keys::find(key)?;
    let written = keys::Value::Number(x).to_toml(row.dimension(scene));
    Some(written.as_str().map_or(written.to_string(), str::to_string))
}

/// Changes that are sufficient for a design. Each is checked with the full design.
///
/// # Errors
///
/// Faults of the scene and of its force.
pub fn relax(files: &Files, which: &Which) -> Result<Value> {
    let made = made(files, table(&which.scene)?)?;
    let language = words::current();
    let search = Search::until(files.host.halt());
    let tried = made.design.clone().relaxed_with(&search);
    let list = |list: &[Relaxation]| remedies(&tried, &made.scene, list);
    Ok(json!({
        "reasons": shown(&reasons(&tried, language), language),
        "relaxations": list(&tried.relaxations),
        "together": list(&tried.together),
    }))
}

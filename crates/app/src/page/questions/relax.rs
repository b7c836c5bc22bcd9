//! Changes of single values that make a design acceptable.

use serde::Serialize;
use serde_json::{Value, json};

use super::design::{Which, made, reasons, shown};
use crate::page::sources::Files;
use crate::page::{table, words};
use gaitcam::error::Result;
use gaitcam::scene::{Scene, keys};
use gaitcam::synth::{Design, Relaxation, Search, in_units};

/// Suggested change of one value of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Change {
    key: &'static str,
    /// `goal` if the change permits a larger force error, otherwise `limit`.
    kind: &'static str,
    /// Permitted force error after the change, in per cent of the mean force; `None` if the change concerns a limit.
    cost: Option<f64>,
    from: String,
    /// New value as text with its unit; `None` if no value of this key is sufficient alone.
    to: Option<String>,
    /// New value as written in a scene file.
    value: Option<String>,
}

/// Suggested changes from the analysis of the conflicting limits. A full design has not confirmed them yet.
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

/// Numeric value of a key, as text for a scene file; `None` for an unknown key.
fn value(key: &str, scene: &Scene, x: f64) -> Option<String> {
    let row = keys::find(key)?;
    let written = keys::Value::Number(x).to_toml(row.dimension(scene));
    Some(written.as_str().map_or(written.to_string(), str::to_string))
}

/// Changes that make the design of a scene acceptable. A full design has confirmed each change.
///
/// # Errors
///
/// The scene or its force is invalid.
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

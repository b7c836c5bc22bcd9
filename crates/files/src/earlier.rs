//! Which files of an earlier result in the same folder do not belong to the new one.

use std::fs;
use std::path::Path;

use crate::files;

/// What `simulate` adds to the design that it runs.
const OF_RUN: [&str; 2] = ["dynamics.csv", "simulation.json"];

/// Every file that `synth` may write, and so may remove.
pub(crate) fn of_design() -> Vec<&'static str> {
    files::ALL.iter().map(|file| file.name).collect()
}

/// Names of the files that an earlier result may have left in `folder` and that do not belong to a result of
/// `scene` (as TOML); none where the folder holds no result.
pub fn stale(folder: &Path, scene: &str) -> Vec<&'static str> {
    let design = holds_design(folder);
    if !design && !holds(folder, "simulation.json", ["model", "lost_fraction"]) {
        return Vec::new();
    }
    let run: &[&str] = if is_of(folder, scene) { &[] } else { &OF_RUN };
    let own = if design { of_design() } else { Vec::new() };
    [own, run.to_vec()].concat()
}

/// Names of the files of a design of another scene than `scene` (as TOML) in `folder`; a run
/// is not written there.
pub fn of_another_design(folder: &Path, scene: &str) -> Vec<&'static str> {
    if holds_design(folder) && !is_of(folder, scene) {
        of_design()
    } else {
        Vec::new()
    }
}

fn holds_design(folder: &Path) -> bool {
    holds(folder, "summary.json", ["outcome", "solver"])
}

/// Whether a file of the folder is a JSON object with these keys.
fn holds(folder: &Path, name: &str, keys: [&str; 2]) -> bool {
    let bytes = fs::read(folder.join(name)).unwrap_or_default();
    let object = serde_json::from_slice::<serde_json::Value>(&bytes);
    object.is_ok_and(|o| keys.iter().all(|key| o.get(key).is_some()))
}

/// Whether the folder's result is of this scene.
fn is_of(folder: &Path, scene: &str) -> bool {
    ["scene.toml", "scene.used.toml"]
        .iter()
        .any(|name| fs::read_to_string(folder.join(name)).is_ok_and(|text| text == scene))
}

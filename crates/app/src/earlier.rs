//! Files of earlier results that do not belong to the new result in the same folder.

use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use crate::files;
use crate::lock::is_plain;

/// File name of the resolved scene.
pub(crate) const SCENE: &str = "scene.toml";
/// File name of the resolved scene if the scene was read from `scene.toml` in the same folder.
pub(crate) const SCENE_BESIDE_INPUT: &str = "scene.used.toml";
/// Files that `simulate` adds to the folder of a design.
pub const OF_RUN: [&str; 7] = [
    "dynamics.csv",
    "dynamics.xlsx",
    "simulation.json",
    "speeds.csv",
    "speeds.svg",
    "speeds.png",
    "programme.csv",
];

/// Files that `inspect` adds to the folder of a design.
pub const OF_INSPECTION: [&str; 6] = [
    "inspection.csv",
    "inspection.json",
    "deviation.svg",
    "deviation.png",
    "deviation_polar.svg",
    "deviation_polar.png",
];

/// Files that `identify` writes.
pub const OF_IDENTIFICATION: [&str; 4] = [
    "identified.toml",
    "identify.json",
    "identify.svg",
    "identify.png",
];

/// Name of the file with the target force, if the force was given as arrays instead of a file.
pub const FORCE: &str = "force.csv";

/// Name of the summary. This file is absent while the folder contains files of different results.
pub(crate) const SUMMARY: &str = "summary.json";

/// Maximum number of cams in a set of `gaitcam cover`.
pub const MOST_CAMS: usize = 50;

/// Tables and figures of `gaitcam cover`. The first file is absent while the folder contains files of different results.
pub const OF_COVER: [&str; 6] = [
    "cover.csv",
    "assignment.csv",
    "folds.csv",
    "cover.svg",
    "cover.png",
    "cycles.csv",
];

/// File name of the scene for one cam in a set of `cams` cams. `cam` is counted from 1.
pub fn scene_of_cover(cams: usize, cam: usize) -> String {
    format!("cams_{cams}/cam_{cam}.toml")
}

/// Names of all files that `gaitcam cover` can write, for any number of cams.
pub fn of_cover() -> impl Iterator<Item = &'static str> {
    static SCENES: LazyLock<Vec<String>> = LazyLock::new(|| {
        let numbers = (1..=MOST_CAMS).flat_map(|cams| (1..=cams).map(move |cam| (cams, cam)));
        numbers
            .map(|(cams, cam)| scene_of_cover(cams, cam))
            .collect()
    });
    OF_COVER
        .into_iter()
        .chain(SCENES.iter().map(String::as_str))
}

/// Names of all files that any result can contain.
pub(crate) fn own() -> impl Iterator<Item = &'static str> {
    let design = files::ALL.iter().map(|file| file.name);
    let rest = [SCENE, SCENE_BESIDE_INPUT, FORCE].into_iter().chain(OF_RUN);
    let added = OF_INSPECTION.into_iter().chain(OF_IDENTIFICATION);
    design.chain(rest).chain(added).chain(of_cover())
}

/// Whether the file is written after all other files of its result. It is absent while its folder contains files of different results.
pub(crate) fn is_last(name: &str) -> bool {
    name == SUMMARY || name == OF_COVER[0]
}

/// Names of all files of a design that `synth` may write or remove. The scene is not included.
pub fn of_design() -> Vec<&'static str> {
    files::ALL.iter().map(|file| file.name).collect()
}

/// Names of files of an earlier result in `folder` that do not belong to a new result. `scene` is the scene of the new result, as TOML
/// text. The list is empty if the folder contains no earlier result.
pub fn stale(folder: &Path, scene: &str) -> Vec<&'static str> {
    let design = holds_design(folder);
    if !design && !holds(folder, "simulation.json", ["model", "lost_fraction"]) {
        return Vec::new();
    }
    let run: &[&str] = if is_of(folder, scene) { &[] } else { &OF_RUN };
    let own = if design { of_design() } else { Vec::new() };
    [own, run.to_vec()].concat()
}

/// Names of the design files in `folder` if they belong to a scene other than `scene` (TOML text), otherwise an empty list. A simulation
/// removes these files when it writes its own.
pub fn of_another_design(folder: &Path, scene: &str) -> Vec<&'static str> {
    if holds_design(folder) && !is_of(folder, scene) {
        of_design()
    } else {
        Vec::new()
    }
}

fn holds_design(folder: &Path) -> bool {
    holds(folder, SUMMARY, ["outcome", "solver"])
}

/// Whether the file `name` in the folder contains a JSON object with both keys.
fn holds(folder: &Path, name: &str, keys: [&str; 2]) -> bool {
    let bytes = content(&folder.join(name));
    let object = serde_json::from_slice::<serde_json::Value>(&bytes);
    object.is_ok_and(|o| keys.iter().all(|key| o.get(key).is_some()))
}

/// Whether the result in the folder was computed from this scene (TOML text).
fn is_of(folder: &Path, scene: &str) -> bool {
    [SCENE, SCENE_BESIDE_INPUT]
        .iter()
        .any(|name| content(&folder.join(name)) == scene.as_bytes())
}

/// Content of a regular file. The result is empty for pipes, devices and unreadable files.
fn content(path: &Path) -> Vec<u8> {
    match is_plain(path) {
        true => fs::read(path).unwrap_or_default(),
        false => Vec::new(),
    }
}

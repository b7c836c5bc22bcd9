//! Which files of an earlier result in the same folder do not belong to the new one.

use std::fs;
use std::path::Path;

/// Every file that `synth` may write, and so may remove.
pub const OF_DESIGN: [&str; 21] = [
    "law.csv",
    "profile.csv",
    "second_profile.csv",
    "profile.dxf",
    "profile.svg",
    "svaj.svg",
    "svaj.png",
    "force.svg",
    "force.png",
    "cam.svg",
    "cam.png",
    "profile.stl",
    "profile.3mf",
    "profile.xlsx",
    "cam.step",
    "profile_arcs.dxf",
    "groove_upper.stl",
    "groove_lower.stl",
    "cutter.csv",
    "report.html",
    "summary.json",
];
/// What `simulate` adds to the design that it runs.
const OF_RUN: [&str; 2] = ["dynamics.csv", "simulation.json"];

/// Names of the files that an earlier result may have left in `folder` and that do not belong to a result of
/// `scene` (as TOML); none where the folder holds no result.
pub fn stale(folder: &Path, scene: &str) -> Vec<&'static str> {
    let summary = fs::read(folder.join("summary.json")).unwrap_or_default();
    let ours = serde_json::from_slice::<serde_json::Value>(&summary)
        .is_ok_and(|s| s.get("outcome").is_some() && s.get("solver").is_some());
    if !ours {
        return Vec::new();
    }
    let same = ["scene.toml", "scene.used.toml"]
        .iter()
        .any(|name| fs::read_to_string(folder.join(name)).is_ok_and(|text| text == scene));
    let run: &[&str] = if same { &[] } else { &OF_RUN };
    [&OF_DESIGN, run].concat()
}

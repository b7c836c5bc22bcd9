//! What an earlier run left in the folder of a result.

use std::fs;
use std::path::Path;

use gaitcam_output::folder::Folder;

/// Every file that `synth` may write, and so may remove.
const OF_DESIGN: [&str; 20] = [
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
    "profile_arcs.dxf",
    "groove_upper.stl",
    "groove_lower.stl",
    "cutter.csv",
    "report.html",
    "summary.json",
];
/// What `simulate` adds to the design that it runs.
const OF_RUN: [&str; 2] = ["dynamics.csv", "simulation.json"];

/// Whose files lie in a folder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Earlier {
    /// No result of `synth`: nothing there is ours to remove.
    None,
    /// A result of the scene that is designed now.
    SameScene,
    /// A result of another scene.
    OtherScene,
}

/// Looks into a folder before the result of `scene` (as TOML) is written there.
pub fn earlier(folder: &Path, scene: &str) -> Earlier {
    let summary = fs::read(folder.join("summary.json")).unwrap_or_default();
    let ours = serde_json::from_slice::<serde_json::Value>(&summary)
        .is_ok_and(|s| s.get("outcome").is_some() && s.get("solver").is_some());
    if !ours {
        return Earlier::None;
    }
    match fs::read_to_string(folder.join("scene.toml")) {
        Ok(text) if text == scene => Earlier::SameScene,
        _ => Earlier::OtherScene,
    }
}

/// Removes what belongs to an earlier result, once the new one is in place.
pub fn clear(folder: &Folder, earlier: Earlier) {
    if earlier != Earlier::None {
        folder.remove_others(&OF_DESIGN);
    }
    if earlier == Earlier::OtherScene {
        folder.remove_others(&OF_RUN);
    }
    folder.remove_partials(&OF_DESIGN);
    folder.remove_partials(&["scene.toml", ".gaitcam", "dynamics.csv", "simulation.json"]);
}

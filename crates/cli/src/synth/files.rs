//! What `synth` writes into its folder.

use std::path::Path;

use crate::error::CliError;
use crate::input::Input;
use crate::language;
use crate::result_folder::ResultFolder;
use gaitcam::error::Result;
use gaitcam::synth::Design;
use gaitcam_output::{self as output, Timing};

/// The scene as it was settled.
const SCENE: &str = "scene.toml";
/// The same where the input itself has that name.
const SCENE_BESIDE_INPUT: &str = "scene.used.toml";

/// Tables, drawings, pictures and the report; of an infeasible design, which has no profile, the report only.
pub fn write(
    folder: &ResultFolder,
    design: &Design,
    points: usize,
    png: bool,
    time: Timing,
) -> Result<()> {
    if design.infeasible.is_none() {
        tables(folder, design, points)?;
        folder.write(
            "profile.dxf",
            &output::dxf::profile(design, points, output::dxf::Content::All),
        )?;
        let outline = output::svg::profile(design, points);
        folder.write("profile.svg", outline.as_bytes())?;
        pictures(folder, design, png)?;
    }
    let report = output::report::html(design, time, language::current());
    folder.write("report.html", report.as_bytes())
}

fn tables(folder: &ResultFolder, design: &Design, points: usize) -> Result<()> {
    folder.write("law.csv", output::csv::law(design, points).as_bytes())?;
    let profile = output::csv::profile(design, points);
    folder.write("profile.csv", profile.as_bytes())?;
    if let Some(pair) = &design.conjugate {
        let second = output::csv::points(&pair.second_profile(points));
        folder.write("second_profile.csv", second.as_bytes())?;
    }
    Ok(())
}

fn pictures(folder: &ResultFolder, design: &Design, png: bool) -> Result<()> {
    let language = language::current();
    for (name, picture) in [
        ("svaj", output::plots::svaj(design, language)),
        ("force", output::plots::force(design, language)),
        ("cam", output::plots::cam(design, language)),
    ] {
        folder.write(&format!("{name}.svg"), picture.svg().as_bytes())?;
        if png {
            folder.write(&format!("{name}.png"), &picture.png())?;
        }
    }
    Ok(())
}

/// Writes the settled scene: `scene.toml`, or `scene.used.toml` where the scene was read from that place.
pub fn write_scene(folder: &ResultFolder, input: &Input, text: &str) -> Result<()> {
    let own = folder.path().join(SCENE);
    let name = if input.file.as_deref().is_some_and(|f| same(f, &own)) {
        SCENE_BESIDE_INPUT
    } else {
        SCENE
    };
    folder.write(name, text.as_bytes())
}

/// Refuses a folder in which the result would replace one of its own inputs.
pub fn check_inputs_stay(folder: &Path, input: &Input) -> Result<()> {
    let inputs = [input.file.clone(), input.recording()];
    for path in inputs.into_iter().flatten() {
        let beside = path.file_name().map(|name| folder.join(name));
        let replaced = beside.is_some_and(|b| same(&path, &b) && !b.ends_with(SCENE));
        if replaced && is_written(&path) {
            let file = path.display().to_string();
            return Err(CliError::Replaced { file }.flag("--out"));
        }
    }
    Ok(())
}

/// Whether results have a file of this name.
fn is_written(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let name = name.as_ref();
    super::earlier::OF_DESIGN.contains(&name) || name == SCENE_BESIDE_INPUT
}

fn same(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

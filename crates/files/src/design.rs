//! The files of a design in its folder.

use std::path::{Path, PathBuf};

use gaitcam::error::{FileError, Placed, Result};
use gaitcam::synth::Design;
use gaitcam_output::{self as output, Language, Timing};
use serde_json::Value;

use crate::earlier;
pub use crate::earlier::of_another_design;
use crate::result_folder::{ResultFolder, Sink};
use crate::scene::Input;
use crate::workshop::{self, Remark};

/// The scene as it was settled.
const SCENE: &str = "scene.toml";
/// The same where the input itself has that name.
const SCENE_BESIDE_INPUT: &str = "scene.used.toml";

/// Rows of law.csv and profile.csv where nobody says how many.
pub const ROWS: usize = 1440;

/// What is written of a design.
#[derive(Debug, Clone, Copy)]
pub struct Contents {
    /// Rows of law.csv and profile.csv.
    pub points: usize,
    /// Pictures as PNG beside SVG.
    pub png: bool,
    /// Solids, arcs and a workbook for manufacturing.
    pub solid: bool,
    /// Radius of a cutter whose path is written, m.
    pub tool: Option<f64>,
    /// Half the diameter of a wire and its spark gap, m: its path is written.
    pub wire: Option<f64>,
    /// Layers of the DXF drawings.
    pub drawn: gaitcam_cad::dxf::Content,
    /// As what profile.dxf has the edges.
    pub curves: gaitcam_cad::dxf::Curves,
    /// What stands in the title block of the drawing beside the design.
    pub title: gaitcam_cad::drawing::Title,
    /// Language of pictures and report.
    pub language: Language,
}

impl Default for Contents {
    fn default() -> Contents {
        Contents {
            points: ROWS,
            png: true,
            solid: false,
            tool: None,
            wire: None,
            drawn: gaitcam_cad::dxf::Content::All,
            curves: gaitcam_cad::dxf::Curves::default(),
            title: gaitcam_cad::drawing::Title::default(),
            language: Language::En,
        }
    }
}

/// Writes tables, drawings, pictures, the report and what else is wanted; of an infeasible design, which has no
/// profile, the report only. Returns what could not be made, and why.
///
/// # Errors
/// Files that cannot be written; a cutter that has no path.
pub fn write(
    folder: &impl Sink,
    design: &Design,
    contents: Contents,
    time: Timing,
) -> Result<Vec<Remark>> {
    let language = contents.language;
    let mut remarks = Vec::new();
    let report = output::report::html(design, time, language);
    folder.write("report.html", report.as_bytes())?;
    if design.infeasible.is_some() {
        return Ok(remarks);
    }
    tables(folder, design, contents.points)?;
    folder.write(
        "profile.dxf",
        &gaitcam_cad::dxf::profile_as(design, contents.points, contents.drawn, contents.curves),
    )?;
    let outline = gaitcam_cad::svg::profile(design, contents.points);
    folder.write("profile.svg", outline.as_bytes())?;
    pictures(folder, design, contents)?;
    if contents.solid {
        remarks = workshop::write(folder, design, time, contents)?;
    }
    if let Some(radius) = contents.tool {
        remarks.extend(workshop::cutter(folder, design, radius, contents.points)?);
    }
    if let Some(radius) = contents.wire {
        remarks.extend(workshop::wire(folder, design, radius)?);
    }
    Ok(remarks)
}

/// `summary.json`: the design in numbers, and the scene that it was made from.
pub fn summary(design: &Design, scene: &toml::Table, time: Timing) -> Value {
    let mut out = output::json::summary(design, time);
    out["scene"] = serde_json::to_value(scene).unwrap_or_default();
    out
}

/// Writes scene and summary and puts the whole result into place.
///
/// # Errors
/// Files that cannot be written or moved.
pub fn finish(
    folder: ResultFolder,
    input: &Input,
    scene: &toml::Table,
    summary: &Value,
) -> Result<PathBuf> {
    let scene = toml::to_string(scene).unwrap_or_default();
    write_scene(&folder, input, &scene)?;
    let text = serde_json::to_string_pretty(summary).unwrap_or_default();
    folder.write("summary.json", text.as_bytes())?;
    let path = folder.path().to_path_buf();
    let stale = earlier::stale(&path, &scene);
    folder.commit(&stale)?;
    Ok(path)
}

fn tables(folder: &impl Sink, design: &Design, points: usize) -> Result<()> {
    folder.write("law.csv", output::csv::law(design, points).as_bytes())?;
    let profile = output::csv::profile(design, points);
    folder.write("profile.csv", profile.as_bytes())?;
    if let Some(pair) = &design.conjugate {
        let second = output::csv::points(&pair.second_profile(points));
        folder.write("second_profile.csv", second.as_bytes())?;
    }
    Ok(())
}

fn pictures(folder: &impl Sink, design: &Design, contents: Contents) -> Result<()> {
    let language = contents.language;
    for (name, picture) in [
        ("svaj", output::plots::svaj(design, language)),
        ("force", output::plots::force(design, language)),
        ("cam", output::plots::cam(design, language)),
    ] {
        folder.write(&format!("{name}.svg"), picture.svg().as_bytes())?;
        if contents.png {
            folder.write(&format!("{name}.png"), &picture.png())?;
        }
    }
    Ok(())
}

/// Writes the settled scene: `scene.toml`, or `scene.used.toml` where the scene was read from that place.
///
/// # Errors
/// A file that cannot be written.
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
///
/// # Errors
/// The input that would be replaced.
pub fn check_inputs_stay(folder: &Path, input: &Input) -> Result<()> {
    let inputs = [input.file.clone(), input.recording()];
    for path in inputs.into_iter().flatten().chain(input.motions()) {
        let beside = path.file_name().map(|name| folder.join(name));
        let replaced = beside.is_some_and(|b| same(&path, &b) && !b.ends_with(SCENE));
        if replaced && is_written(&path) {
            let file = path.display().to_string();
            return Err(FileError::Replaced { file }.in_file(folder));
        }
    }
    Ok(())
}

/// Whether results have a file of this name.
fn is_written(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let name = name.as_ref();
    earlier::of_design().contains(&name) || name == SCENE_BESIDE_INPUT
}

fn same(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

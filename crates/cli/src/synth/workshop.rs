//! What a workshop takes: solids, arcs, a workbook, a cutter's path.

use serde_json::{Value, json};

use crate::result_folder::ResultFolder;
use crate::{language, words};
use gaitcam::cam::{Measures, Wall};
use gaitcam::error::{Error, Result};
use gaitcam::synth::Design;
use gaitcam_output::{self as output, Timing, cutter::Gouge};

/// Vertices of a solid's profile and of the polylines beside the arcs.
const VERTICES: usize = 720;
/// Largest distance of the fitted arcs from the profile, m.
const ARCS: f64 = 1e-6;
/// Triangles of a groove's wall: along the groove for every turn, and through its depth.
const ALONG: usize = 720;
const THROUGH: usize = 8;

/// Writes cam.step, profile.stl, profile.3mf, profile_arcs.dxf and profile.xlsx (a barrel: its walls as STL).
/// Returns what could not be written, and why.
pub fn write(folder: &ResultFolder, design: &Design, time: Timing) -> Result<Vec<String>> {
    let mut remarks = Vec::new();
    folder.write(
        "profile.xlsx",
        &output::xlsx::workbook(design, time, crate::language::current())?,
    )?;
    if let Some(groove) = &design.groove {
        for (name, wall) in [("upper", Wall::Upper), ("lower", Wall::Lower)] {
            let mesh = output::groove::wall(groove, wall, ALONG, THROUGH);
            let bytes = output::solid::binary_stl(&mesh)?;
            folder.write(&format!("groove_{name}.stl"), &bytes)?;
        }
        return Ok(remarks);
    }
    let plate = output::solid::Plate {
        thickness: design.thickness,
        bore: design.bore,
        points: VERTICES,
    };
    match output::solid::stl(design, plate) {
        Ok(bytes) => {
            folder.write("profile.stl", &bytes)?;
            folder.write("profile.3mf", &output::solid::threemf(design, plate)?)?;
        }
        Err(fault) => remarks.push(words::fill("synth-no-solid", &said(&fault))),
    }
    match output::step::plate(design, design.thickness) {
        Ok(bytes) => folder.write("cam.step", &bytes)?,
        Err(fault) => remarks.push(words::fill("synth-no-step", &said(&fault))),
    }
    let options = output::dxf::Options {
        points: VERTICES,
        version: output::dxf::Version::R2000,
        bore: design.bore,
        content: output::dxf::Content::All,
    };
    match output::dxf::arcs(design, ARCS, options) {
        Some(drawing) => {
            folder.write("profile_arcs.dxf", &drawing.bytes)?;
            let deviation = words::power(1e3 * drawing.deviation, 2);
            let arcs = json!({"arcs": drawing.arcs, "deviation": deviation});
            remarks.push(words::fill("synth-arcs", &arcs));
        }
        None => remarks.push(words::text("synth-no-arcs")),
    }
    Ok(remarks)
}

/// Writes cutter.csv and says where the cutter would gouge.
pub fn cutter(
    folder: &ResultFolder,
    design: &Design,
    radius: f64,
    points: usize,
) -> Result<Vec<String>> {
    let path = output::cutter::path(design, radius, points)?;
    folder.write("cutter.csv", output::cutter::csv(&path).as_bytes())?;
    let measures = design.cam.follower.measures();
    let words = |g: &Gouge| gouge(g, measures);
    Ok(path.gouges.iter().map(words).collect())
}

fn said(fault: &Error) -> Value {
    json!({"fault": fault.sentence(language::current())})
}

fn gouge(gouge: &Gouge, measures: Measures) -> String {
    let place = |at: f64| words::decimal(measures.place(at, 2));
    match gouge {
        Gouge::Hollow { at, radius } => words::fill(
            "synth-gouge-hollow",
            &json!({"at": place(*at), "radius": words::fixed(1e3 * radius, 4)}),
        ),
        Gouge::Elsewhere { at, damaged, depth } => words::fill(
            "synth-gouge-elsewhere",
            &json!({"at": place(*at), "damaged": place(*damaged), "depth": words::fixed(1e3 * depth, 4)}),
        ),
        Gouge::Undercut { at } => words::fill("synth-gouge-undercut", &json!({"at": place(*at)})),
    }
}

//! What a workshop takes: solids, arcs, a workbook, a cutter's path.

use crate::result_folder::ResultFolder;
use gaitcam::cam::{Measures, Wall};
use gaitcam::error::Result;
use gaitcam::synth::Synthesis;
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
pub fn write(folder: &ResultFolder, design: &Synthesis, time: Timing) -> Result<Vec<String>> {
    let mut remarks = Vec::new();
    folder.write("profile.xlsx", &output::xlsx::workbook(design, time)?)?;
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
        Err(fault) => remarks.push(format!("no solid: {fault}")),
    }
    match output::step::plate(design, design.thickness) {
        Ok(bytes) => folder.write("cam.step", &bytes)?,
        Err(fault) => remarks.push(format!("no STEP file: {fault}")),
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
            remarks.push(format!(
                "profile_arcs.dxf: {} arcs, {:.2e} mm from the profile at most",
                drawing.arcs,
                1e3 * drawing.deviation
            ));
        }
        None => remarks.push("no arcs: the profile is not smooth enough for them".to_string()),
    }
    Ok(remarks)
}

/// Writes cutter.csv and says where the cutter would gouge.
pub fn cutter(
    folder: &ResultFolder,
    design: &Synthesis,
    radius: f64,
    points: usize,
) -> Result<Vec<String>> {
    let path = output::cutter::path(design, radius, points)?;
    folder.write("cutter.csv", output::cutter::csv(&path).as_bytes())?;
    let measures = design.cam.follower.measures();
    let words = |g: &Gouge| gouge(g, measures);
    Ok(path.gouges.iter().map(words).collect())
}

fn gouge(gouge: &Gouge, measures: Measures) -> String {
    let place = |at: f64| measures.place(at, 2);
    match gouge {
        Gouge::Hollow { at, radius } => format!(
            "the cutter radius is too large for the concave profile at {}: {:.4} mm maximum",
            place(*at),
            1e3 * radius
        ),
        Gouge::Elsewhere { at, damaged, depth } => format!(
            "at {} the cutter gouges the profile by {:.4} mm at {}",
            place(*at),
            1e3 * depth,
            place(*damaged)
        ),
        Gouge::Undercut { at } => format!(
            "the profile is undercut at {}: it cannot be cut",
            place(*at)
        ),
    }
}

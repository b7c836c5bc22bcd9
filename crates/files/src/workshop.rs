//! What a workshop takes: solids, arcs, a workbook, a cutter's path.

use gaitcam::cam::Wall;
use gaitcam::error::{Error, Result};
use gaitcam::synth::Design;
use gaitcam_cad::cutter::Gouge;
use gaitcam_output::{self as output, Timing};

use crate::design::Contents;
use crate::result_folder::Sink;

/// Vertices of a solid's profile and of the polylines beside the arcs.
const VERTICES: usize = 720;
/// Largest distance of the fitted arcs from the profile, m.
const ARCS: f64 = 1e-6;
/// Triangles of a groove's wall: along the groove for every turn, and through its depth.
const ALONG: usize = 720;
const THROUGH: usize = 8;

/// What is to be known of the files for manufacturing.
#[derive(Debug, Clone, PartialEq)]
pub enum Remark {
    /// There is no solid.
    NoSolid(Error),
    /// There is no STEP file.
    NoStep(Error),
    /// Arcs in profile_arcs.dxf.
    Arcs {
        /// How many.
        arcs: usize,
        /// Largest distance from the profile, m.
        deviation: f64,
    },
    /// There are none.
    NoArcs,
    /// No hole has room to balance a cam.
    NoBalanceHole,
    /// The cutter damages the profile.
    Gouge(Gouge),
    /// There is no program for the cutter or the wire.
    NoProgram(Error),
}

/// Writes cam.step, profile.stl, profile.3mf, profile_arcs.dxf, profile.xlsx and drawing.pdf (a barrel: its walls
/// as STL).
/// Returns what could not be written, and why.
pub fn write(
    folder: &impl Sink,
    design: &Design,
    time: Timing,
    contents: Contents,
) -> Result<Vec<Remark>> {
    let mut remarks = Vec::new();
    folder.write(
        "profile.xlsx",
        &output::xlsx::workbook(design, time, contents.language)?,
    )?;
    if design.making.balance && design.balance_holes().contains(&None) {
        remarks.push(Remark::NoBalanceHole);
    }
    let drawing = gaitcam_cad::drawing::pdf(design, &contents.title, contents.language);
    folder.write("drawing.pdf", &drawing)?;
    if let Some(groove) = &design.groove {
        for (name, wall) in [("upper", Wall::Upper), ("lower", Wall::Lower)] {
            let mesh = gaitcam_cad::solid::wall(groove, wall, ALONG, THROUGH);
            let bytes = gaitcam_cad::solid::binary_stl(&mesh)?;
            folder.write(&format!("groove_{name}.stl"), &bytes)?;
        }
        remarks.extend(step(folder, design)?);
        return Ok(remarks);
    }
    let plate = gaitcam_cad::solid::Plate {
        thickness: design.thickness,
        bore: design.bore,
        points: VERTICES,
    };
    match gaitcam_cad::solid::stl(design, plate) {
        Ok(bytes) => {
            folder.write("profile.stl", &bytes)?;
            folder.write("profile.3mf", &gaitcam_cad::solid::threemf(design, plate)?)?;
        }
        Err(fault) => remarks.push(Remark::NoSolid(fault)),
    }
    remarks.extend(step(folder, design)?);
    let options = gaitcam_cad::dxf::Options {
        points: VERTICES,
        version: gaitcam_cad::dxf::Version::R2000,
        bore: design.bore,
        content: contents.drawn,
    };
    match gaitcam_cad::dxf::arcs(design, ARCS, options) {
        Some(drawing) => {
            folder.write("profile_arcs.dxf", &drawing.bytes)?;
            remarks.push(Remark::Arcs {
                arcs: drawing.arcs,
                deviation: drawing.deviation,
            });
        }
        None => remarks.push(Remark::NoArcs),
    }
    Ok(remarks)
}

/// Writes cam.step, or says why not.
fn step(folder: &impl Sink, design: &Design) -> Result<Option<Remark>> {
    match gaitcam_cad::step::solid(design) {
        Ok(bytes) => {
            folder.write("cam.step", &bytes)?;
            Ok(None)
        }
        Err(fault) => Ok(Some(Remark::NoStep(fault))),
    }
}

/// Writes cutter.csv and says where the cutter would gouge; where it does not, the programs for it as well.
pub fn cutter(
    folder: &impl Sink,
    design: &Design,
    radius: f64,
    points: usize,
) -> Result<Vec<Remark>> {
    let path = gaitcam_cad::cutter::path(design, radius, points)?;
    folder.write("cutter.csv", gaitcam_cad::cutter::csv(&path).as_bytes())?;
    if !path.gouges.is_empty() {
        return Ok(path.gouges.into_iter().map(Remark::Gouge).collect());
    }
    match gaitcam_cad::gcode::milling(design, radius) {
        Ok(programs) => {
            for program in programs {
                folder.write(program.file, program.text.as_bytes())?;
            }
            Ok(Vec::new())
        }
        Err(fault) => Ok(vec![Remark::NoProgram(fault)]),
    }
}

/// Writes wire.nc, or says why not.
pub fn wire(folder: &impl Sink, design: &Design, radius: f64) -> Result<Option<Remark>> {
    match gaitcam_cad::gcode::wire(design, radius) {
        Ok(program) => {
            folder.write(program.file, program.text.as_bytes())?;
            Ok(None)
        }
        Err(fault) => Ok(Some(Remark::NoProgram(fault))),
    }
}

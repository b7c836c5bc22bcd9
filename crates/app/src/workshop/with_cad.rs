//! Files for CAD and the workshop: options and functions that make them.

use gaitcam::cam::Wall;
use gaitcam::error::{Error, Result};
use gaitcam::scene::Scene;
use gaitcam::synth::Design;
use gaitcam_cad::cutter::{self, Gouge};
use gaitcam_cad::drawing::{self, Title, revision};
use gaitcam_cad::ecam::{self, Dialect, ElectronicCam};
use gaitcam_cad::{Units, dxf, gcode, solid, step, svg};
use gaitcam_output::{Language, Timing, xlsx};
use serde_json::{Value, json};

use super::piece::{Piece, usual_cutter};

/// Number of vertices of the profile of a solid.
const VERTICES: usize = 720;
/// Number of triangles of the wall of a groove: along the groove per turn, and over its depth.
const WALL: [usize; 2] = [720, 8];

/// Content of a file, if it can be made, with remarks on it.
pub(crate) type Made = Result<(Option<Vec<u8>>, Vec<Remark>)>;

/// Options of the files for the workshop.
#[derive(Debug, Clone, Copy, Default)]
pub struct Workshop {
    /// Whether solids, a drawing and a workbook for manufacturing are written.
    pub solid: bool,
    /// Radius of the cutter for the path, m.
    pub tool: Option<f64>,
    /// Depth of a pass of the cutter, m; without it the operator sets the depth.
    pub pass: Option<f64>,
    /// Half the diameter of a wire plus the spark gap, m.
    pub wire: Option<f64>,
    /// Controllers for which an electronic cam is written.
    pub ecam: Option<Dialect>,
    /// Layers of the DXF drawings.
    pub drawn: dxf::Content,
    /// Representation of the edges in profile.dxf: arcs or splines.
    pub curves: dxf::Curves,
    /// Unit of the drawing, of DXF files and of programs.
    pub units: Units,
    /// Title block of the drawing.
    pub title: drawing::Title,
}

/// A remark on the files for manufacturing.
#[derive(Debug, Clone, PartialEq)]
pub enum Remark {
    /// The solid cannot be made.
    NoSolid(Error),
    /// The STEP file cannot be made.
    NoStep(Error),
    /// The cutter damages the profile.
    Gouge(Gouge),
    /// Force error of the electronic cam with its controller.
    Ecam(ElectronicCam),
    /// The electronic cam cannot be made.
    NoEcam(Error),
    /// The program for cutter or wire cannot be made.
    NoProgram(Error),
}

impl Remark {
    /// Whether this remark means that there is no program for the cutter.
    pub fn forbids_program(&self) -> bool {
        matches!(self, Remark::Gouge(_) | Remark::NoProgram(_))
    }

    /// Reason why a file could not be made, if the remark contains one.
    pub fn into_fault(self) -> Option<Error> {
        match self {
            Remark::NoSolid(fault)
            | Remark::NoStep(fault)
            | Remark::NoEcam(fault)
            | Remark::NoProgram(fault) => Some(fault),
            Remark::Ecam(_) | Remark::Gouge(_) => None,
        }
    }
}

fn made(bytes: impl Into<Vec<u8>>) -> Made {
    Ok((Some(bytes.into()), Vec::new()))
}

fn or_remark(made: Result<impl Into<Vec<u8>>>, remark: fn(Error) -> Remark) -> Made {
    Ok(match made {
        Ok(bytes) => (Some(bytes.into()), Vec::new()),
        Err(fault) => (None, vec![remark(fault)]),
    })
}

impl Workshop {
    /// Whether a file is requested.
    pub(crate) fn asks(&self, piece: Piece) -> bool {
        match piece {
            Piece::Dxf | Piece::Svg => true,
            Piece::Sheet
            | Piece::Stl
            | Piece::ThreeMf
            | Piece::Wall(_)
            | Piece::Step
            | Piece::Workbook => self.solid,
            Piece::Cutter | Piece::Program(_) => self.tool.is_some(),
            Piece::Wire => self.wire.is_some(),
            Piece::Ecam(k) => self.ecam == Some(Dialect::ALL[k]),
        }
    }

    /// Makes a file of a design; `points` is the number of rows of its tables.
    pub(crate) fn make(
        &self,
        piece: Piece,
        design: &Design,
        time: Timing,
        points: usize,
        language: Language,
    ) -> Made {
        let plate = || solid::Plate {
            thickness: design.problem.cam.thickness,
            bore: design.problem.cam.hole(),
            points: VERTICES,
        };
        match piece {
            Piece::Dxf => made(dxf::profile(
                design,
                points,
                self.drawn,
                self.curves,
                self.units,
            )),
            Piece::Svg => made(svg::profile(design, points)),
            Piece::Sheet => self.sheet(design, language),
            Piece::Stl => or_remark(solid::stl(design, plate()), Remark::NoSolid),
            Piece::ThreeMf => or_remark(solid::threemf(design, plate()), Remark::NoSolid),
            Piece::Wall(wall) => groove(design, wall),
            Piece::Step => or_remark(step::solid(design), Remark::NoStep),
            Piece::Workbook => made(xlsx::workbook(design, time, language)?),
            Piece::Cutter => self.path(design, points),
            Piece::Program(cam) => self.program(design, cam),
            Piece::Wire => {
                let radius = self.wire.unwrap_or_default();
                or_remark(gcode::wire(design, radius, self.units), Remark::NoProgram)
            }
            Piece::Ecam(k) => electronic(design, Dialect::ALL[k]),
        }
    }

    fn sheet(&self, design: &Design, language: Language) -> Made {
        let title = Title {
            units: self.units,
            ..self.title
        };
        Ok((drawing::pdf(design, &title, language), Vec::new()))
    }

    fn tool(&self, design: &Design) -> f64 {
        self.tool.unwrap_or_else(|| usual_cutter(design))
    }

    fn path(&self, design: &Design, points: usize) -> Made {
        let path = cutter::path(design, self.tool(design), points)?;
        let bytes = cutter::csv(&path).into_bytes();
        let gouges = path.gouges.into_iter().map(Remark::Gouge);
        Ok((Some(bytes), gouges.collect()))
    }

    /// Program for the first or the second cam.
    fn program(&self, design: &Design, cam: usize) -> Made {
        let cut = gcode::Milling {
            tool: self.tool(design),
            pass: self.pass,
            units: self.units,
        };
        match gcode::milling(design, &cut) {
            Ok(programs) => Ok((
                programs.into_iter().nth(cam).map(String::into_bytes),
                Vec::new(),
            )),
            Err(fault) => Ok((None, vec![Remark::NoProgram(fault)])),
        }
    }
}

fn groove(design: &Design, wall: Wall) -> Made {
    match &design.groove {
        Some(groove) => made(solid::binary_stl(&solid::wall(
            groove, wall, WALL[0], WALL[1],
        ))?),
        None => Ok((None, Vec::new())),
    }
}

/// Electronic cam as JSON, with the path or name of the file: number of intervals, force error with the controller, and its part that the file adds.
pub fn ecam_json(cam: &ElectronicCam, file: &str) -> Value {
    let replayed = cam.replayed;
    json!({
        "dialect": cam.dialect.name(),
        "file": file,
        "points": cam.intervals,
        "rms_error_n": replayed.error,
        "added_rms_n": replayed.added,
        "added_percent": 100.0 * replayed.share,
    })
}

fn electronic(design: &Design, dialect: Dialect) -> Made {
    Ok(match ecam::make(design, dialect, None) {
        Ok(made) => {
            let text = made.text.clone().into_bytes();
            (Some(text), vec![Remark::Ecam(made)])
        }
        Err(fault) => (None, vec![Remark::NoEcam(fault)]),
    })
}

/// Title block for a drawing of a scene without a file. `whole` is its table in which the rows of every motion replace the file name.
pub fn title(scene: &Scene, whole: &toml::Table) -> Title {
    let usual = Title::default();
    Title {
        revision: Some(revision(&toml::to_string(whole).unwrap_or_default())),
        accuracy: scene.rms.unwrap_or(usual.accuracy),
        ..usual
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::ALL;

    #[test]
    fn electronic_cams_have_the_names_of_their_dialects() {
        let names: Vec<&str> = ALL
            .iter()
            .filter(|f| f.name.starts_with("ecam_"))
            .map(|f| f.name)
            .collect();
        assert_eq!(names, Dialect::ALL.map(Dialect::file));
    }
}

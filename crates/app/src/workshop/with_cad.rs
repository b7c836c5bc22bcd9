//! Options of the files for CAD and manufacturing, and the functions that make these files.

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

/// Number of vertices of the profile in a mesh.
const VERTICES: usize = 720;
/// Numbers of strips in the mesh of a groove's wall: along the groove per turn, and over its depth.
const WALL: [usize; 2] = [720, 8];

/// Content of a file with remarks on the file. The content is `None` if the file cannot be made.
pub(crate) type Exported = Result<(Option<Vec<u8>>, Vec<Remark>)>;

/// Options of the files for CAD and manufacturing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Workshop {
    /// Whether solids, a workshop drawing and a workbook are written.
    pub solid: bool,
    /// Radius of the milling cutter, m; `None` if no path and no program are written.
    pub tool: Option<f64>,
    /// Depth of one pass of the milling cutter, m; `None` if the operator sets the depth.
    pub pass: Option<f64>,
    /// Half the wire diameter plus the spark gap, m; `None` if no program for wire cutting is written.
    pub wire: Option<f64>,
    /// Controller for which an electronic cam is written; `None` if no electronic cam is written.
    pub ecam: Option<Dialect>,
    /// Selection of the layers in DXF drawings.
    pub drawn: dxf::Content,
    /// Kind of curve that represents the edges in `profile.dxf`.
    pub curves: dxf::Curves,
    /// Unit of lengths in the workshop drawing, in DXF files and in programs.
    pub units: Units,
    /// Entries of the title block of the workshop drawing.
    pub title: drawing::Title,
}

/// Remark on a file for CAD or manufacturing.
#[derive(Debug, Clone, PartialEq)]
pub enum Remark {
    /// The STL or 3MF mesh cannot be made, for this reason.
    NoSolid(Error),
    /// The STEP file cannot be made, for this reason.
    NoStep(Error),
    /// The cutter damages the profile.
    Gouge(Gouge),
    /// The electronic cam was written. Its data include the force error with the controller.
    Ecam(ElectronicCam),
    /// The electronic cam cannot be made, for this reason.
    NoEcam(Error),
    /// The program for milling or wire cutting cannot be made, for this reason.
    NoProgram(Error),
}

impl Remark {
    /// Whether the remark prevents a program for the milling cutter.
    pub fn forbids_program(&self) -> bool {
        matches!(self, Remark::Gouge(_) | Remark::NoProgram(_))
    }

    /// Reason why a file could not be made; `None` for remarks on files that were made.
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

fn made(bytes: impl Into<Vec<u8>>) -> Exported {
    Ok((Some(bytes.into()), Vec::new()))
}

fn or_remark(made: Result<impl Into<Vec<u8>>>, remark: fn(Error) -> Remark) -> Exported {
    Ok(match made {
        Ok(bytes) => (Some(bytes.into()), Vec::new()),
        Err(fault) => (None, vec![remark(fault)]),
    })
}

impl Workshop {
    /// Whether the options request the file.
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

    /// Makes one file of a design. `points` is the number of rows of tables and of vertices of drawings.
    pub(crate) fn make(
        &self,
        piece: Piece,
        design: &Design,
        time: Timing,
        points: usize,
        language: Language,
    ) -> Exported {
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

    fn sheet(&self, design: &Design, language: Language) -> Exported {
        let title = Title {
            units: self.units,
            ..self.title
        };
        Ok((drawing::pdf(design, &title, language), Vec::new()))
    }

    fn tool(&self, design: &Design) -> f64 {
        self.tool.unwrap_or_else(|| usual_cutter(design))
    }

    fn path(&self, design: &Design, points: usize) -> Exported {
        let path = cutter::path(design, self.tool(design), points)?;
        let bytes = cutter::csv(&path).into_bytes();
        let gouges = path.gouges.into_iter().map(Remark::Gouge);
        Ok((Some(bytes), gouges.collect()))
    }

    /// Program for milling the first cam (0) or the second cam (1).
    fn program(&self, design: &Design, cam: usize) -> Exported {
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

fn groove(design: &Design, wall: Wall) -> Exported {
    match &design.groove {
        Some(groove) => made(solid::binary_stl(&solid::wall(
            groove, wall, WALL[0], WALL[1],
        ))?),
        None => Ok((None, Vec::new())),
    }
}

/// JSON data of an electronic cam: dialect, file (path or name), number of intervals and RMS force error, N. The RMS difference from the
/// force of the law is given in N and in per cent.
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

fn electronic(design: &Design, dialect: Dialect) -> Exported {
    Ok(match ecam::make(design, dialect, None) {
        Ok(made) => {
            let text = made.text.clone().into_bytes();
            (Some(text), vec![Remark::Ecam(made)])
        }
        Err(fault) => (None, vec![Remark::NoEcam(fault)]),
    })
}

/// Entries of the title block for a scene that was not read from a file. In `whole`, the table of the scene, the file names of motions are replaced
/// by the rows of the files.
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

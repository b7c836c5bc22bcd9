//! What the files of a design are to contain, and remarks on them for the user.

use gaitcam::error::Error;
use gaitcam_cad::cutter::Gouge;
use gaitcam_cad::ecam::{Dialect, ElectronicCam};
use gaitcam_cad::{Units, drawing, dxf};
use gaitcam_output::Language;

/// Rows of law.csv and profile.csv unless the user asks for another number.
pub const ROWS: usize = 1440;

/// What the files of a design are to contain.
#[derive(Debug, Clone, Copy)]
pub struct Contents {
    /// Rows of law.csv and profile.csv.
    pub points: usize,
    /// Pictures as PNG too.
    pub png: bool,
    /// Solids, arcs and a workbook for manufacturing.
    pub solid: bool,
    /// Radius of a cutter whose path is written, m.
    pub tool: Option<f64>,
    /// Depth of a pass of that cutter, m; without it the operator brings the cutter to depth.
    pub pass: Option<f64>,
    /// Half the diameter of a wire and its spark gap, m: its path is written.
    pub wire: Option<f64>,
    /// For which controller an electronic cam is written.
    pub ecam: Option<Dialect>,
    /// Layers of the DXF drawings.
    pub drawn: dxf::Content,
    /// Edges of profile.dxf as arcs or splines.
    pub curves: dxf::Curves,
    /// Unit of the drawing, of DXF and of programs.
    pub units: Units,
    /// Title block of the drawing.
    pub title: drawing::Title,
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
            pass: None,
            wire: None,
            ecam: None,
            drawn: dxf::Content::All,
            curves: dxf::Curves::default(),
            units: Units::default(),
            title: drawing::Title::default(),
            language: Language::En,
        }
    }
}

/// A remark on the files for manufacturing.
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
    /// What the controller makes of its electronic cam.
    Ecam(ElectronicCam),
    /// There is no electronic cam.
    NoEcam(Error),
    /// There is no program for the cutter or the wire.
    NoProgram(Error),
}

impl Remark {
    /// Why a file could not be made, if the remark is about that.
    pub fn into_fault(self) -> Option<Error> {
        match self {
            Remark::NoSolid(fault)
            | Remark::NoStep(fault)
            | Remark::NoEcam(fault)
            | Remark::NoProgram(fault) => Some(fault),
            Remark::Arcs { .. }
            | Remark::NoArcs
            | Remark::NoBalanceHole
            | Remark::Ecam(_)
            | Remark::Gouge(_) => None,
        }
    }
}

//! Options of `gaitcam synth` for CAD and manufacturing files.

use crate::console::lengths::Lengths;
use clap::{Args, ValueEnum};

pub use super::remark::sentence;
use crate::ecam;
use crate::input::{self, Input};
use gaitcam::error::Result;
use gaitcam::units::Dimension;
use gaitcam_app::Workshop;
use gaitcam_cad::Units;
use gaitcam_cad::drawing::Title;
use gaitcam_cad::dxf::{Content, Curves};
use gaitcam_cad::ecam::Dialect;

/// Arguments for CAD and manufacturing files.
#[derive(Args, Debug, Default)]
#[command(next_help_heading = "Manufacturing files")]
pub struct WorkshopArgs {
    /// Also write manufacturing files: drawing (PDF), solid (STEP, STL, 3MF), workbook (XLSX)
    #[arg(long)]
    pub solid: bool,
    /// Omit reference lines from DXF drawings: circles, marks, pitch curve (layers REF_*)
    #[arg(long)]
    pub cut_only: bool,
    /// Draw the edges of profile.dxf as arcs (R12), as splines (R2000), or as lines within 0.002 mm (R12)
    #[arg(long, value_name = "CURVES", value_enum, default_value_t = Dxf::Arcs)]
    pub dxf: Dxf,
    /// Also write an electronic cam: program text or table of points for a motion controller
    #[arg(long, value_name = "DIALECT", value_parser = ecam::dialects())]
    pub ecam: Option<Dialect>,
    /// Also write the path of a cutter of this radius: --tool '6 mm'
    #[arg(long, value_name = "RADIUS")]
    pub tool: Option<String>,
    /// Depth of pass of the cutter; cutter.nc then contains Z, spindle and feeds
    #[arg(long, value_name = "DEPTH", requires = "tool")]
    pub pass: Option<String>,
    /// Also write the path of a cutting wire with this radius, spark gap included: --wire '0.14 mm'
    #[arg(long, value_name = "RADIUS")]
    pub wire: Option<String>,
    /// Unit of lengths in DXF, drawing and programs, and in messages, reports and pictures
    #[arg(long, value_name = "UNIT", value_enum, default_value_t = Lengths::Mm, help_heading = "Printed output")]
    pub units: Lengths,
}

/// Type of the edges in profile.dxf.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub enum Dxf {
    #[default]
    Arcs,
    Splines,
    Lines,
}

impl WorkshopArgs {
    /// Options for the manufacturing files, from the arguments. The title block is empty.
    pub fn asked(&self) -> Result<Workshop> {
        let length = |name, typed: &Option<String>| {
            input::positive(name, typed.as_deref(), Dimension::Length)
        };
        Ok(Workshop {
            solid: self.solid,
            tool: length("--tool", &self.tool)?,
            pass: length("--pass", &self.pass)?,
            wire: length("--wire", &self.wire)?,
            ecam: self.ecam,
            drawn: self.drawn(),
            curves: self.curves(),
            units: self.units(),
            title: Title::default(),
        })
    }

    /// Unit of length in DXF files, drawing and programs.
    fn units(&self) -> Units {
        match self.units {
            Lengths::Mm => Units::Millimetres,
            Lengths::Inch => Units::Inches,
        }
    }

    /// Type of the curves in profile.dxf.
    fn curves(&self) -> Curves {
        match self.dxf {
            Dxf::Arcs => Curves::Arcs,
            Dxf::Splines => Curves::Splines,
            Dxf::Lines => Curves::Lines,
        }
    }

    /// Content of the DXF drawings: all lines, or only the edges to be cut.
    fn drawn(&self) -> Content {
        if self.cut_only {
            Content::CutOnly
        } else {
            Content::All
        }
    }
}

/// The options with the title block of a scene added.
pub fn titled(workshop: Workshop, input: &Input) -> Workshop {
    Workshop {
        title: input.title(),
        ..workshop
    }
}

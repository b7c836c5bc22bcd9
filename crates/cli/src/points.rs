//! `gaitcam points`: writes the profile of a design as points for the command "curve through points" of a CAD program.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use serde_json::json;

use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::terminal::{print, report};
use crate::console::words;
use crate::input::SceneArgs;
use crate::input::made::CamInMachine;
use gaitcam::cam::Cam;
use gaitcam::error::{Placed, Result, SceneError};
use gaitcam_app::folder::write_whole;
use gaitcam_output as output;

/// Default number of points of a profile.
const USUAL: u32 = 720;

const EXAMPLES: &str = "Examples:
  gaitcam points out/footbridge --cad solidworks
  gaitcam points out/heel_tester --cad inventor --units inch
  gaitcam points out/footbridge --cad fusion --out cam.csv";

/// Arguments of `gaitcam points`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct PointsArgs {
    /// The design: a folder or summary.json of synth, a scene file or the name of a built-in scene
    #[arg(value_name = "RESULT")]
    design: PathBuf,
    /// The CAD program: solidworks (x y z with tabs), inventor (workbook with the unit in its first cell), fusion (centimetres), plain (with a
    /// header)
    #[arg(long, value_enum)]
    cad: Program,
    /// Unit of the coordinates (default: mm; fusion reads cm)
    #[arg(long, value_enum)]
    units: Option<Unit>,
    /// Number of points
    #[arg(long, value_name = "N", default_value_t = USUAL, value_parser = clap::value_parser!(u32).range(16..=100_000))]
    count: u32,
    /// Write to this file instead of the folder of the design
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Supported CAD programs. Each one requires a different file format for "curve through points".
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Program {
    // "Curve through XYZ points": x y z separated by tabs, no header
    Solidworks,
    // "Import points": a workbook with the unit in its first cell
    Inventor,
    // "Import spline CSV": x,y,z in centimetres, no header
    Fusion,
    // CSV text x,y,z with a header line
    Plain,
}

/// Units of length for the coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Unit {
    // Millimetres
    Mm,
    // Metres
    M,
    // Inches
    Inch,
}

impl Program {
    fn file(self) -> &'static str {
        match self {
            Program::Solidworks => "points_solidworks.txt",
            Program::Inventor => "points_inventor.xlsx",
            Program::Fusion => "points_fusion.csv",
            Program::Plain => "points.csv",
        }
    }

    /// Content of the file with these points. `unit` is the unit of their coordinates.
    fn bytes(self, points: &[[f64; 2]], unit: &str) -> Result<Vec<u8>> {
        let rows = |separator: &str| -> String {
            let row = |[x, y]: &[f64; 2]| format!("{x:.9}{separator}{y:.9}{separator}0\n");
            points.iter().map(row).collect()
        };
        Ok(match self {
            Program::Solidworks => rows("\t").into_bytes(),
            Program::Fusion => rows(",").into_bytes(),
            Program::Plain => format!("x_{unit},y_{unit},z_{unit}\n{}", rows(",")).into_bytes(),
            Program::Inventor => output::xlsx::points(unit, points)?,
        })
    }
}

impl Unit {
    /// Name of the unit, and number of units per metre.
    fn scale(self) -> (&'static str, f64) {
        match self {
            Unit::Mm => ("mm", 1e3),
            Unit::M => ("m", 1.0),
            Unit::Inch => ("in", 1.0 / 0.0254),
        }
    }
}

/// Writes the points of the profile, and of the second profile of a pair. The exit code is 3 if the design has no cam.
///
/// # Errors
/// The input is invalid, `--units` is given for Fusion (which reads only centimetres), or a file cannot be written.
pub fn run(args: &PointsArgs) -> Result<u8> {
    if args.cad == Program::Fusion && args.units.is_some() {
        return Err(SceneError::PointsOfFusion.at_argument("--units"));
    }
    let made = CamInMachine::read(&SceneArgs::of(args.design.clone()), &[])?;
    let design = made.design()?.0.built()?;
    if let Some(why) = design.no_cam(language::current()) {
        report(words::fill("ecam-no-cam", &json!({"why": why})));
        return Ok(NO_SUCH_CAM);
    }
    let place = match &args.out {
        Some(out) => out.clone(),
        None => made.folder(&args.design)?.join(args.cad.file()),
    };
    written(args, &design.cam, &place)?;
    if let Some(pair) = &design.conjugate {
        let name = place.file_name().unwrap_or_default().to_string_lossy();
        written(
            args,
            &pair.second,
            &place.with_file_name(format!("second_{name}")),
        )?;
    }
    Ok(BUILT)
}

/// Writes the points of one profile. For a closed profile, the first point is repeated at the end.
fn written(args: &PointsArgs, cam: &Cam, place: &Path) -> Result<()> {
    let (unit, per_metre) = match args.cad {
        Program::Fusion => ("cm", 1e2),
        _ => args.units.unwrap_or(Unit::Mm).scale(),
    };
    let profile = cam.profile(args.count as usize);
    let mut points: Vec<[f64; 2]> = profile
        .iter()
        .map(|p| [p.x, p.y].map(|x| per_metre * x))
        .collect();
    if cam.law.is_closed() && !cam.follower.is_unrolled() {
        points.extend(points.first().copied());
    }
    write_whole(place, &args.cad.bytes(&points, unit)?)?;
    let file = place.display().to_string();
    print(&words::fill(
        "points-file",
        &json!({"file": file, "count": points.len(), "unit": unit}),
    ));
    Ok(())
}

//! `gaitcam inspect`: compares measured points of a manufactured cam with its design, and computes the deviations of the profile and the
//! resulting force.

mod shown;

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};

use crate::console::error::CliError;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::lengths::LengthArgs;
use crate::console::terminal::{print, print_json, report};
use crate::console::words;
use crate::input::made::CamInMachine;
use crate::input::{self, SceneArgs};
use crate::synth::files_in;
use gaitcam::cam::Inspection;
use gaitcam::error::{Place, Placed, Result};
use gaitcam::sweep::MadeCam;
use gaitcam::synth::{Design, sentences};
use gaitcam::units::Dimension;
use gaitcam_app::design::OF_INSPECTION;
use gaitcam_app::measured::{self, Points};
use gaitcam_app::{PATIENCE, ResultFolder, inputs};
use gaitcam_output::{inspection, inspection_data};
use shown::text;

const EXAMPLES: &str = "Examples:
  gaitcam inspect out/footbridge measured.csv
  gaitcam inspect scenes/heel_tester.toml centres.csv --ball '1 mm' --out out/inspected";

/// Arguments of `gaitcam inspect`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct InspectArgs {
    /// The design: a folder or summary.json of synth, a scene file or the name of a built-in scene
    #[arg(value_name = "RESULT")]
    design: PathBuf,
    /// Measured points of the profile in the coordinates of the measuring machine: a csv with the columns
    /// x_mm,y_mm or angle_deg,radius_mm (or m, in, rad), one point per line, in any order
    #[arg(value_name = "FILE")]
    measured: PathBuf,
    /// The points are centres of a probing ball of this radius: --ball '1 mm'
    #[arg(long, value_name = "RADIUS")]
    ball: Option<String>,
    /// Change a value of the scene, or drive and machine of a result: --set 'drive.speed=60 rpm' (may be repeated)
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Folder for the files (default: the design's folder, or out/NAME_inspected)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    lengths: LengthArgs,
    /// Print inspection.json instead of the text summary; without --out no file is written
    #[arg(long)]
    pub json: bool,
}

/// Fits the measured points to the design and writes a table, pictures and a summary. The exit code is 3 if the design has no cam.
pub fn run(args: &InspectArgs) -> Result<u8> {
    args.lengths.units.display();
    let ball = input::quantity("--ball", args.ball.as_deref(), Dimension::Length)?.unwrap_or(0.0);
    if ball < 0.0 {
        let typed = args.ball.clone().unwrap_or_default();
        return Err(CliError::NegativeBall { typed }.at_argument("--ball"));
    }
    let points = measured::read(&args.measured)?;
    let named = SceneArgs {
        scene: Some(args.design.clone()),
        set: args.set.clone(),
    };
    let made = CamInMachine::read(&named, &[])?;
    let place = folder(args, &made.input)?;
    if let Some(place) = &place {
        inputs::check_in(place, OF_INSPECTION)?;
    }
    let design = made.design()?.0.built()?;
    if let Some(infeasible) = &design.infeasible {
        let why = sentences(&infeasible.reasons, language::current());
        report(words::fill("inspect-no-cam", &json!({"why": why})));
        return Ok(NO_SUCH_CAM);
    }
    let inspected = design
        .cam
        .inspect(&points.xy, ball)
        .map_err(|e| e.at(Place::File(args.measured.clone())))?;
    let made = MadeCam::of(&design, &inspected);
    let json = inspection_data::json(&design, &inspected, made.as_ref(), &points.lines);
    let place = match place {
        Some(path) => Some(write(
            &path,
            (&design, &inspected, made.as_ref()),
            (&points, &json),
        )?),
        None => None,
    };
    if args.json {
        print_json(&json);
        return Ok(BUILT);
    }
    print(&text(&design, &inspected, made.as_ref(), &points.lines));
    if let Some(place) = place {
        print(&files_in(&place, "deviation.svg"));
    }
    Ok(BUILT)
}

/// Folder for the files; `None` if only the summary is printed.
fn folder(args: &InspectArgs, input: &input::Input) -> Result<Option<PathBuf>> {
    match &args.out {
        Some(out) => Ok(Some(out.clone())),
        None if args.json => Ok(None),
        None if args.design.is_dir() => Ok(Some(args.design.clone())),
        None => input::result_folder(input, None, "_inspected").map(Some),
    }
}

type Results<'a> = (&'a Design, &'a Inspection, Option<&'a MadeCam>);

fn write(
    path: &Path,
    (design, inspected, made): Results,
    (points, json): (&Points, &Value),
) -> Result<PathBuf> {
    let folder = ResultFolder::open(path, PATIENCE)?;
    let table = inspection_data::table(inspected, &points.lines);
    folder.write("inspection.csv", table.csv().as_bytes())?;
    let text = serde_json::to_string_pretty(json).unwrap_or_default();
    folder.write("inspection.json", text.as_bytes())?;
    let pictures = [
        (
            "deviation",
            inspection::diagram(design, inspected, made, language::current()),
        ),
        (
            "deviation_polar",
            inspection::polar(design, inspected, language::current()),
        ),
    ];
    for (name, picture) in pictures {
        folder.write(&format!("{name}.svg"), picture.svg().as_bytes())?;
        folder.write(&format!("{name}.png"), &picture.png())?;
    }
    let place = folder.path().to_path_buf();
    folder.commit(&[])?;
    Ok(place)
}

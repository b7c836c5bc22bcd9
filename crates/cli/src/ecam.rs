//! `gaitcam ecam`: writes a design as the program text or table of a motion controller and computes the force error with this controller.

use std::f64::consts::TAU;
use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use serde_json::json;

use crate::console::error::CliError;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::terminal::{print, print_json, report};
use crate::console::words;
use crate::input::SceneArgs;
use crate::input::made::CamInMachine;
use crate::walk::{dampings, list};
use gaitcam::cam::Verdict;
use gaitcam::dynamics::{Misfit, RepeatedForce};
use gaitcam::error::{Placed, Result};
use gaitcam::force::Walk;
use gaitcam::synth::Design;
use gaitcam_app::folder::write_whole;
use gaitcam_app::workshop::ecam_json;
use gaitcam_app::{PATIENCE, ResultFolder};
use gaitcam_cad::ecam::{self, Dialect, ElectronicCam, Interpolation, Number};

/// Smallest added force error that is printed, % of the mean force. For a smaller error, the message states only that it is below this
/// value.
const LEAST_SHARE: f64 = 1e-3;

const EXAMPLES: &str = "Examples:
  gaitcam ecam out/footbridge --dialect codesys
  gaitcam ecam out/footbridge --dialect codesys --name heel --out heel.st
  gaitcam ecam out/footbridge --dialect rockwell --points 120
  gaitcam ecam out/walk --dialect codesys --strides 16";

/// Arguments of `gaitcam ecam`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct EcamArgs {
    /// The design: a folder or summary.json of synth, a scene file or the name of a built-in scene
    #[arg(value_name = "RESULT")]
    design: PathBuf,
    /// Controller: codesys, twincat (structured text); segments (ends of polynomials); rockwell (CAM array); csv (positions)
    #[arg(long, value_parser = dialects())]
    dialect: Dialect,
    /// Number of equal intervals per cycle (default: the smallest number that reproduces the law)
    #[arg(long, value_name = "N")]
    points: Option<usize>,
    /// Write to this file instead of the folder of the design
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Name of the cam in the controller's program, for a second cam in one project (default: gaitcam)
    #[arg(long, value_name = "NAME")]
    name: Option<String>,
    /// Write the law of this number of consecutive recorded strides, for a servo axis, instead of one mean stride
    #[arg(long, value_name = "N")]
    strides: Option<usize>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Parses the name of a dialect on the command line.
pub fn dialects() -> impl TypedValueParser<Value = Dialect> {
    let is = |d: &Dialect, name: &str| d.name() == name || d.other_names().contains(&name);
    let named = move |name: String| Dialect::ALL.into_iter().find(|d| is(d, &name));
    let value = |d: Dialect| PossibleValue::new(d.name()).aliases(d.other_names());
    PossibleValuesParser::new(Dialect::ALL.map(value))
        .map(move |name| named(name).unwrap_or(Dialect::Csv))
}

/// Writes the file of the electronic cam. The exit code is 3 if the design has no cam.
pub fn run(args: &EcamArgs) -> Result<u8> {
    let made = CamInMachine::read(&SceneArgs::of(args.design.clone()), &[])?;
    let design = made.design()?.0.built()?;
    if let Some(why) = design.no_cam(language::current()) {
        report(words::fill("ecam-no-cam", &json!({"why": why})));
        return Ok(NO_SUCH_CAM);
    }
    let several = args.strides.map(|count| of_strides(&made, &design, count));
    let several = several.transpose()?;
    if let Some(Several { design, .. }) = &several
        && design.verdict == Verdict::Unacceptable
    {
        let why = design.reason(language::current());
        report(words::fill("ecam-no-strides", &json!({"why": why})));
        return Ok(NO_SUCH_CAM);
    }
    let carried = several.as_ref().map_or(&design, |s| &s.design);
    let cam = ecam::make(carried, args.dialect, args.points)?;
    let cam = match &args.name {
        Some(name) => cam.named(name)?,
        None => cam,
    };
    let file = written(args, &made, &cam)?;
    if args.json {
        let mut out = ecam_json(&cam, &file);
        if let Some(several) = &several {
            out["strides"] = json!({"count": args.strides, "duration_s": several.duration_s, "misfit": several.misfits});
        }
        print_json(&out);
        return Ok(BUILT);
    }
    print(&sentence(&cam));
    if let Some(several) = &several {
        print(&several.sentence());
    }
    print(&words::fill("ecam-file", &json!({"file": file})));
    Ok(BUILT)
}

/// Writes the file to the path given by the user, otherwise to the folder of the design. Returns the path of the file.
fn written(args: &EcamArgs, made: &CamInMachine, cam: &ElectronicCam) -> Result<String> {
    if let Some(out) = &args.out {
        write_whole(out, cam.text.as_bytes())?;
        return Ok(out.display().to_string());
    }
    let path = made.folder(&args.design)?;
    let folder = ResultFolder::open(&path, PATIENCE)?;
    folder.write(cam.dialect.file(), cam.text.as_bytes())?;
    let file = folder.path().join(cam.dialect.file()).display().to_string();
    folder.commit(&[])?;
    Ok(file)
}

/// Design for several recorded strides in one cycle.
struct Several {
    design: Design,
    duration_s: f64,
    misfits: [Misfit; 3],
}

/// Design for `count` consecutive recorded strides. The misfits compare two responses of a lightly damped mode: to the force of this
/// design, and to all recorded strides.
fn of_strides(made: &CamInMachine, design: &Design, count: usize) -> Result<Several> {
    let walk = design.walk();
    let recorded = walk.as_ref().map_or(0, Walk::strides);
    let few = || CliError::StridesMissing { count, recorded }.at_argument("--strides");
    let several = design.of_strides(&made.input.scene, count)?;
    let ((several, part), walk) = several.zip(walk).ok_or_else(few)?;
    let force = several.force_curve();
    let drive = &several.problem.drive;
    let samples = part.samples();
    let at = |i: usize| drive.newtons(force.eval(TAU * i as f64 / samples as f64));
    let force: Vec<f64> = (0..samples).map(at).collect();
    let own = RepeatedForce::new(&force, part.duration_s, count);
    Ok(Several {
        misfits: RepeatedForce::of(&walk).misfits(&own),
        duration_s: part.duration_s,
        design: several,
    })
}

impl Several {
    fn sentence(&self) -> String {
        let of = &self.misfits;
        words::fill(
            "ecam-strides",
            &json!({"duration": words::number(self.duration_s), "dampings": dampings(of), "misfit": list(of, |m| m.misfit),
                "peak": list(of, |m| m.peak_ratio)}),
        )
    }
}

/// Sentence that states the force error caused by the controller's interpolation and number format.
pub fn sentence(cam: &ElectronicCam) -> String {
    let carries = cam.dialect.carries();
    let curve = words::text(match carries.interpolation {
        Interpolation::Quintic => "ecam-quintic",
        Interpolation::CubicSpline => "ecam-cubic",
    });
    let number = match carries.number {
        Number::Single => "REAL",
        Number::Double => "LREAL",
    };
    let replayed = cam.replayed;
    let error = replayed.error.or(replayed.added).unwrap_or_default();
    let key = match (replayed.error, replayed.added) {
        (Some(_), _) => "ecam-force",
        (None, Some(_)) => "ecam-law",
        (None, None) => "ecam-acceleration",
    };
    let fields = json!({
        "file": cam.dialect.file(),
        "points": cam.intervals,
        "curve": curve,
        "number": number,
        "error": words::number(error),
        "added": match 100.0 * replayed.share {
            share if share < LEAST_SHARE => words::fill("ecam-below", &json!({"least": words::number(LEAST_SHARE)})),
            share => words::number(share),
        },
    });
    words::fill(key, &fields)
}

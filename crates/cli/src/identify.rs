//! `gaitcam identify` estimates the parameters of a machine from logs of the running machine. `gaitcam recut` designs a corrected cam
//! from such logs.

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use serde_json::json;
use toml::Table;

use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::terminal::{print, print_json, report};
use crate::console::words;
use crate::input::made::CamInMachine;
use crate::input::searching::TimeLimit;
use crate::input::{self, SceneArgs};
use crate::synth::{self, SynthArgs, files_in};
use gaitcam::error::Result;
use gaitcam::identify::{Identified, Log, LogOptions};
use gaitcam::scene::set_value;
use gaitcam::synth::Design;
use gaitcam_app::design::{OF_IDENTIFICATION, of_design};
use gaitcam_app::read::read_bytes;
use gaitcam_app::{Input, PATIENCE, ResultFolder, inputs};
use gaitcam_output::{identification, identified};

const IDENTIFY: &str = "Examples:
  gaitcam identify out/footbridge log.csv
  gaitcam identify spring-bench slow.csv fast.csv
  gaitcam identify out/footbridge plc.csv --angle Encoder --counts-per-turn 4096";
const RECUT: &str = "Examples:
  gaitcam recut out/footbridge log.csv
  gaitcam recut out/footbridge log.csv --out out/second
  gaitcam recut out/footbridge first.csv second.csv";

/// Arguments of `gaitcam identify`.
#[derive(Args, Debug)]
#[command(after_help = IDENTIFY)]
pub struct IdentifyArgs {
    #[command(flatten)]
    run: LoggedArgs,
    /// Folder for the files (default out/NAME_identified)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print identify.json instead of the text summary; without --out no file is written
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `gaitcam recut`.
#[derive(Args, Debug)]
#[command(after_help = RECUT)]
pub struct RecutArgs {
    #[command(flatten)]
    run: LoggedArgs,
    #[command(flatten)]
    time: TimeLimit,
    /// Folder for the files (default out/NAME_recut)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print summary.json instead of the text summary; without --out no file is written
    #[arg(long)]
    pub json: bool,
    /// Write no PNG pictures
    #[arg(long)]
    no_png: bool,
}

/// A design and the logs of its machine.
#[derive(Args, Debug)]
struct LoggedArgs {
    /// The design: a folder or summary.json of synth, a scene file or the name of a built-in scene
    #[arg(value_name = "RESULT")]
    design: PathBuf,
    /// Logs of the running machine (csv, at any speed): force and time or cam angle, optionally speed and torque.
    /// Columns are recognised by name and unit
    #[arg(value_name = "FILE", required = true)]
    logs: Vec<PathBuf>,
    #[command(flatten)]
    columns: ColumnArgs,
}

/// Names or numbers of the columns in the logs.
#[derive(Args, Debug)]
struct ColumnArgs {
    /// Name or number of the time column
    #[arg(long, value_name = "COLUMN")]
    time: Option<String>,
    /// Name or number of the column of the cam angle
    #[arg(long, value_name = "COLUMN")]
    angle: Option<String>,
    /// Name or number of the column of the load cell's force
    #[arg(long, value_name = "COLUMN")]
    force: Option<String>,
    /// Name or number of the column of the cam's speed
    #[arg(long, value_name = "COLUMN")]
    speed: Option<String>,
    /// Name or number of the column of the torque at the camshaft
    #[arg(long, value_name = "COLUMN")]
    torque: Option<String>,
    /// Encoder counts per turn of the cam, if the cam angle is in counts
    #[arg(long, value_name = "N")]
    counts_per_turn: Option<f64>,
}

/// A design and the logs of the machine that runs it.
struct Run {
    input: Input,
    design: Design,
    logs: Vec<Log>,
    /// Folder for the files; `None` if only JSON data is printed.
    folder: Option<PathBuf>,
}

impl LoggedArgs {
    /// Reads the design and its logs, and checks that the files `names` can be written to the folder. If the design has no cam, the
    /// function reports the reason and returns `None`.
    fn read<'a>(
        &self,
        place: impl Fn(&Input) -> Result<Option<PathBuf>>,
        names: impl IntoIterator<Item = &'a str>,
    ) -> Result<Option<Run>> {
        let columns = &self.columns;
        let options = LogOptions {
            time: columns.time.clone(),
            angle: columns.angle.clone(),
            force: columns.force.clone(),
            speed: columns.speed.clone(),
            torque: columns.torque.clone(),
            counts_per_turn: columns.counts_per_turn,
        };
        let read = |path: &PathBuf| Log::read(path, &read_bytes(path)?, &options);
        let logs = self.logs.iter().map(read).collect::<Result<Vec<Log>>>()?;
        let made = CamInMachine::read(&SceneArgs::of(self.design.clone()), &[])?;
        let folder = place(&made.input)?;
        if let Some(folder) = &folder {
            inputs::check_in(folder, names)?;
        }
        let design = made.design()?.0.built()?;
        if let Some(why) = design.no_cam(language::current()) {
            report(words::fill("identify-no-cam", &json!({"why": why})));
            return Ok(None);
        }
        Ok(Some(Run {
            input: made.input,
            design,
            logs,
            folder,
        }))
    }
}

/// Identifies the machine and writes a scene, JSON data and a picture. The exit code is 3 if the design has no cam.
pub fn identify(args: &IdentifyArgs) -> Result<u8> {
    let place = |input: &Input| folder(input, args.out.as_deref(), args.json, "_identified");
    let Some(run) = args.run.read(place, OF_IDENTIFICATION)? else {
        return Ok(NO_SUCH_CAM);
    };
    let Run {
        input,
        design,
        logs,
        folder,
    } = run;
    let found = gaitcam::identify::identify(&design, &input.scene, &logs)?;
    let write = |path: PathBuf| write(&path, &input, &design, &found);
    let folder = folder.map(write).transpose()?;
    if args.json {
        print_json(&serde_json::to_value(&found).unwrap_or_default());
        return Ok(BUILT);
    }
    let lines = identified::lines(&input.scene, &found, language::current());
    print(&lines.join("\n  "));
    if let Some(folder) = folder {
        print(&files_in(&folder, "identify.svg"));
    }
    Ok(BUILT)
}

/// Folder for the files; `None` if only JSON data is printed.
fn folder(input: &Input, out: Option<&Path>, json: bool, ending: &str) -> Result<Option<PathBuf>> {
    match (out, json) {
        (None, true) => Ok(None),
        (out, _) => input::result_folder(input, out, ending).map(Some),
    }
}

fn write(path: &Path, input: &Input, design: &Design, found: &Identified) -> Result<PathBuf> {
    let scene = found.scene(&input.scene)?.to_table();
    let known = found.parameters.iter().filter(|p| p.identifiable);
    let scene = carried(&scene, input, known.map(|p| p.key))?;
    let folder = ResultFolder::open(path, PATIENCE)?;
    let scene = toml::to_string(&scene).unwrap_or_default();
    folder.write("identified.toml", scene.as_bytes())?;
    let text = serde_json::to_string_pretty(found).unwrap_or_default();
    folder.write("identify.json", text.as_bytes())?;
    let picture = identification(design, found, language::current());
    folder.write("identify.svg", picture.svg().as_bytes())?;
    folder.write("identify.png", &picture.png())?;
    let place = folder.path().to_path_buf();
    folder.commit(&[])?;
    Ok(place)
}

/// Scene of the input with absolute paths, in which the values of `keys` are replaced by their values in the scene `from`.
fn carried<'a>(from: &Table, input: &Input, keys: impl Iterator<Item = &'a str>) -> Result<Table> {
    let mut out = input.resolved();
    for key in keys {
        let mut parts = key.split('.');
        let first = parts.next().and_then(|p| from.get(p));
        let value = parts.fold(first, |at, part| at.and_then(|t| t.get(part)));
        if let Some(value) = value {
            set_value(&mut out, key, value.clone())?;
        }
    }
    Ok(out)
}

/// Designs the corrected cam and writes the same files as `synth`. The exit code is 3 if there is no feasible cam, or if the repeatable
/// error cannot be distinguished from noise.
pub fn recut(args: &RecutArgs) -> Result<u8> {
    let start = Instant::now();
    let place = |input: &Input| folder(input, args.out.as_deref(), args.json, "_recut");
    let Some(run) = args.run.read(place, of_design())? else {
        return Ok(NO_SUCH_CAM);
    };
    let Run {
        input,
        design,
        logs,
        folder: out,
    } = run;
    let target = input.target()?;
    let search = gaitcam::synth::Search::until(args.time.of_design());
    let (scene, figures, found) =
        gaitcam::identify::recut(&design, &input.scene, target.as_ref(), &logs, &search)?;
    let key = "machine.learned_force";
    let table = carried(&scene.to_table(), &input, std::iter::once(key))?;
    let next = Input::new(table, input.files.clone(), None)?;
    let synth = SynthArgs {
        time: args.time,
        out,
        json: args.json,
        no_png: args.no_png,
        ..SynthArgs::default()
    };
    let number = words::number;
    let (before, after) = (figures.before_rms_n, figures.predicted_rms_n);
    let line = json!({"before": number(before), "after": number(after)});
    let mut lines = vec![words::fill("recut-error", &line)];
    lines.extend(identified::no_angle(&found, language::current()));
    synth::designed(&synth, &next, start, Some(("recut", json!(figures), lines)))
}

//! `gaitcam synth`: designs a cam for a force curve or for a programme of classical laws, checks it and writes its files.

mod explain;
mod front;
mod no_cam;
mod remark;
mod reports;
mod sequence;
mod summary;
mod workshop;

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use serde_json::Value;

use crate::console::error::CliError;
use crate::console::exit_code;
use crate::console::language;
use crate::console::terminal::{print, print_json};
use crate::input::searching::TimeLimit;
use crate::input::{self, Input, SceneArgs};
use gaitcam::error::{Place, Placed, Result};
use gaitcam::force::ForceCurve;
use gaitcam::halt::Halt;
use gaitcam::synth::{self, Design, Outcome, Search};
use gaitcam_app::design::{self, check_inputs_stay};
use gaitcam_app::files::{self, Source};
use gaitcam_app::{Contents, ResultFolder};
use gaitcam_output::Timing;
pub use no_cam::{files_in, no_cam};
use workshop::WorkshopArgs;

const EXAMPLES: &str = "Examples:
  gaitcam synth
  gaitcam synth scenes/heel_tester.toml --out out/heel
  gaitcam synth my.toml --set 'limits.stroke=40 mm' --set drive.mass=auto
  gaitcam synth my.toml --json | python3 -m json.tool
  gaitcam synth my.toml --solid --tool '3 mm' --pass '2 mm'
  gaitcam synth my.toml --solid --units inch
  gaitcam synth my.toml --front force_error:prime_radius";

/// Headings of options in the help text.
const FILES: &str = "Files";
const PRINTED: &str = "Printed output";

/// Arguments of `gaitcam synth`.
#[derive(Args, Debug, Default)]
#[command(after_help = EXAMPLES)]
pub struct SynthArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub time: TimeLimit,
    /// Folder for the files (default out/NAME)
    #[arg(long, value_name = "DIR", help_heading = FILES)]
    pub out: Option<PathBuf>,
    /// Print summary.json instead of the text summary; without --out no file is written
    #[arg(long, help_heading = PRINTED)]
    pub json: bool,
    /// Write no PNG pictures
    #[arg(long, help_heading = FILES)]
    pub no_png: bool,
    /// Print every step of a sequence of convex programs
    #[arg(short, long, help_heading = PRINTED)]
    pub verbose: bool,
    /// Explain the selection of each model and the rejection of others
    #[arg(long, help_heading = PRINTED)]
    pub explain: bool,
    /// Number of rows of law.csv and profile.csv (default 1440), or of points of the front (default 20)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=1_000_000), help_heading = FILES)]
    pub points: Option<u32>,
    /// Compute a Pareto front instead of one cam: force_error:prime_radius, or :jerk, :acceleration, :velocity, :stroke,
    /// :torque, :power, :hertz_pressure, :liftoff_speed
    #[arg(long, value_name = "A:B")]
    pub front: Option<String>,
    #[command(flatten)]
    pub workshop: WorkshopArgs,
}

/// Default number of rows of law.csv and profile.csv.
const ROWS: u32 = 1440;
/// Minimum number of rows of law.csv and profile.csv.
const FEWEST_ROWS: u32 = 16;

/// Options and folder of the requested files. They are checked before the design begins.
struct Request {
    contents: Contents,
    folder: Option<ResultFolder>,
}

/// A design with its computing times and additional data.
struct Answer {
    design: Design,
    solve_s: f64,
    start: Instant,
    more: Option<More>,
}

/// Designs the cam and writes its files. The exit code is 3 if there is no feasible cam.
pub fn run(args: &SynthArgs) -> Result<u8> {
    args.workshop.units.display();
    if let Some(pair) = &args.front {
        return front::run(args, pair);
    }
    let start = Instant::now();
    let waiting = args.time.of_input(args.json);
    // A time limit given by the user also applies to the reading of the input.
    let limit = waiting.as_ref().map(|_| args.time.of_design());
    let input = input::scene(&args.scene)?;
    let target = || {
        let target = input.target();
        drop(waiting);
        target
    };
    design_of(args, &input, target, (start, limit), None)
}

/// Additional data of a design: key in summary.json, its value, and lines for the console.
pub type More = (&'static str, Value, Vec<String>);

/// Designs the cam of a scene that was already read, and writes its files as [`run`] does. `more` is added to the output.
pub fn designed(args: &SynthArgs, input: &Input, start: Instant, more: Option<More>) -> Result<u8> {
    design_of(args, input, || input.target(), (start, None), more)
}

fn design_of(
    args: &SynthArgs,
    input: &Input,
    target: impl FnOnce() -> Result<Option<ForceCurve>>,
    (start, limit): (Instant, Option<Halt>),
    more: Option<More>,
) -> Result<u8> {
    let points = rows(args)?;
    let workshop = args.workshop.asked()?;
    let request = Request {
        contents: Contents {
            points,
            png: !args.no_png,
            language: language::current(),
            workshop: workshop::titled(workshop, input),
        },
        folder: folder(args, input)?,
    };
    // Arguments and folder are checked before a recording is read.
    let target = target()?;
    let solving = Instant::now();
    let shown = args.time.shown();
    let search = Search::until(limit.unwrap_or_else(|| args.time.of_design()));
    let outcome = synth::answer(&input.scene, target.as_ref(), &search)?;
    let solve_s = solving.elapsed().as_secs_f64();
    let outcome = outcome.relaxed_with(&search);
    drop(shown);
    let design = match outcome {
        Outcome::Built(design) => *design,
        Outcome::NoCam(why) => {
            return no_cam(args.json, input, request.folder, &why, start);
        }
    };
    let answer = Answer {
        design,
        solve_s,
        start,
        more,
    };
    hand_over(args, input, request, &answer)?;
    let design = &answer.design;
    Ok(exit_code::of(design.verdict))
}

fn rows(args: &SynthArgs) -> Result<usize> {
    let rows = args.points.unwrap_or(ROWS);
    if rows < FEWEST_ROWS {
        let least = FEWEST_ROWS;
        return Err(CliError::FewRows { rows, least }.at_argument("--points"));
    }
    Ok(rows as usize)
}

/// Folder of the result; `None` if only the summary is printed.
fn folder(args: &SynthArgs, input: &Input) -> Result<Option<ResultFolder>> {
    if args.json && args.out.is_none() {
        return Ok(None);
    }
    let path = input::result_folder(input, args.out.as_deref(), "")?;
    check_inputs_stay(&path, input, &[])
        .map_err(|e| e.placed(Place::Argument("--out".to_string())))?;
    ResultFolder::open(&path, args.time.patience()).map(Some)
}

impl Answer {
    fn time(&self) -> Timing {
        Timing {
            solve_s: self.solve_s,
            total_s: self.start.elapsed().as_secs_f64(),
        }
    }
}

/// Writes the files of a design and prints its summary.
fn hand_over(args: &SynthArgs, input: &Input, request: Request, answer: &Answer) -> Result<()> {
    let design = &answer.design;
    let mut remarks = Vec::new();
    if let Some(folder) = &request.folder {
        let source = Source::new(design, answer.time(), &request.contents);
        remarks = files::write(&source, |name, bytes| folder.write(name, bytes))?;
    }
    let mut explained = None;
    if args.explain && design.infeasible.is_none() {
        explained = Some(explain::lines(design, request.contents.points));
    }
    let scene = input.resolved();
    let time = answer.time();
    let mut json = design::summary(design, &scene, time);
    if let Some(lines) = &explained {
        json["explain"] = explain::json(lines);
    }
    if let Some((key, value, _)) = &answer.more {
        json[*key] = value.clone();
    }
    let place = match request.folder {
        Some(folder) => Some(design::finish(folder, input, &scene, &json)?),
        None => None,
    };
    if args.json {
        print_json(&json);
        return Ok(());
    }
    print(&summary::text(design, time, args.verbose));
    if args.verbose {
        print(&sequence::text(design));
    }
    if let Some(lines) = &explained {
        print(&explain::text(&design.problem.name, lines));
    }
    if let Some((_, _, lines)) = &answer.more {
        print(&format!("  {}", lines.join("\n  ")));
    }
    let measures = design.cam.follower.measures();
    for remark in &remarks {
        print(&summary::row("note", &workshop::sentence(remark, measures)));
    }
    if let Some(place) = place {
        print(&files_in(&place, "report.html"));
    }
    Ok(())
}

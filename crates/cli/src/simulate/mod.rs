//! `gaitcam simulate`: simulates the cam from the points of its exported profile instead of the exact law of the design.

mod speeds;

use std::f64::consts::PI;
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use serde_json::json;

use crate::console::error::CliError;
use crate::console::exit_code::{self, NO_SUCH_CAM};
use crate::console::language;
use crate::console::lengths::LengthArgs;
use crate::console::terminal::{print, print_json, report};
use crate::console::words;
use crate::input::made::{CamInMachine, Flag};
use crate::input::{self, SceneArgs};
use crate::synth::{files_in, no_cam};
use crate::walk::programme;
use gaitcam::dynamics::{Model, Outcome, Run, simulate};
use gaitcam::error::{Error, Place, Placed, Result};
use gaitcam::scene::Scene;
use gaitcam::synth::{self, Design};
use gaitcam_app::design::{OF_RUN, finish, of_another_design, summary, write_scene};
use gaitcam_app::inputs;
use gaitcam_app::{PATIENCE, ResultFolder};
use gaitcam_output::report::{Running, html_of_run};
use gaitcam_output::xlsx;
use gaitcam_output::{Timing, csv, simulation};

const EXAMPLES: &str = "Examples:
  gaitcam simulate scenes/footbridge.toml
  gaitcam simulate out/footbridge --speed '96 rpm'
  gaitcam simulate out/footbridge --speeds '1.4 Hz:2.3 Hz:10'
  gaitcam simulate out/walk --speed-programme speed.csv
  gaitcam simulate scenes/heel_tester.toml --model flexible --natural-frequency '60 Hz'
  gaitcam simulate scenes/thesis_iteration_3.toml --set 'drive.speed=300 rpm' --restitution 0.5";

/// Arguments of `gaitcam simulate`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct SimulateArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// Simulate the cam as manufactured at this speed of the shaft: --speed '96 rpm'
    #[arg(long, value_name = "SPEED")]
    speed: Option<String>,
    /// Simulate the cam as manufactured at several speeds (first, last, number): --speeds '1.4 Hz:2.3 Hz:10'
    #[arg(long, value_name = "RANGE", conflicts_with = "speed")]
    speeds: Option<String>,
    /// Simulate the cam as designed at a speed that varies over time, with the motor if the scene has one: speed.csv with time_s,speed_rad_per_s
    #[arg(long, value_name = "SPEED.csv", conflicts_with_all = ["speed", "speeds"])]
    speed_programme: Option<PathBuf>,
    /// Dynamic model: auto (the simplest sufficient model), rigid, flexible, contact
    #[arg(long, default_value = "auto")]
    model: String,
    /// Folder for dynamics.csv, dynamics.xlsx, simulation.json and report.html (default out/NAME)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    lengths: LengthArgs,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
    /// First natural frequency of the follower train: "60 Hz"
    #[arg(long, value_name = "HZ")]
    natural_frequency: Option<String>,
    /// Damping ratio of the follower train (default: value of the scene, or 0.05)
    #[arg(long, value_name = "RATIO")]
    damping_ratio: Option<String>,
    /// Coefficient of friction between cam and follower (default: value of the scene, or 0)
    #[arg(long, value_name = "MU")]
    friction: Option<String>,
    /// Coefficient of restitution of an impact, 0 … 1 (default: value of the scene, or 0)
    #[arg(long, value_name = "E")]
    restitution: Option<String>,
    /// Angle of a second, equal cam behind the first on the same shaft: "180 deg"
    #[arg(long, value_name = "ANGLE")]
    second_cam: Option<String>,
}

impl SimulateArgs {
    /// Flags of the command line that set keys of the machine. Flags that are not given are omitted.
    fn machine(&self) -> Vec<Flag<'_>> {
        [
            ("--speed", "drive.speed", &self.speed),
            (
                "--natural-frequency",
                "machine.natural_frequency",
                &self.natural_frequency,
            ),
            (
                "--damping-ratio",
                "machine.damping_ratio",
                &self.damping_ratio,
            ),
            ("--friction", "machine.friction", &self.friction),
            ("--restitution", "machine.restitution", &self.restitution),
            ("--second-cam", "machine.second_cam", &self.second_cam),
        ]
        .into_iter()
        .filter_map(|(name, key, value)| {
            Some(Flag {
                name,
                key,
                value: value.as_deref()?,
            })
        })
        .collect()
    }
}

/// Designs the cam of the scene or result folder, samples its profile as for the output files, and simulates the sampled cam. The exit code
/// is 3 if there is no cam, a limit is violated or contact is lost.
pub fn run(args: &SimulateArgs) -> Result<u8> {
    args.lengths.units.display();
    let model = Model::parse(&args.model).ok_or_else(|| {
        let typed = args.model.clone();
        CliError::NoModel { typed }.at_argument("--model")
    })?;
    if let Some(speeds) = &args.speeds {
        return speeds::run(args, speeds, model);
    }
    let start = Instant::now();
    let made = CamInMachine::read(&args.scene, &args.machine())?;
    if let Some(path) = &args.speed_programme {
        return programme::run(&made, path, &folder(args, &made)?, args.json);
    }
    let input = &made.input;
    let folder = ResultFolder::open(&folder(args, &made)?, PATIENCE)?;
    let scene = toml::to_string(&input.resolved()).unwrap_or_default();
    let others = of_another_design(folder.path(), &scene);
    inputs::check_in(folder.path(), OF_RUN.into_iter().chain(["report.html"]))?;
    // A complete result of the same scene is kept.
    let stays = others.is_empty() && folder.path().join("summary.json").exists();
    let solving = Instant::now();
    let (outcome, untargeted) = made.design()?;
    let design = match outcome {
        synth::Outcome::Built(design) => *design,
        synth::Outcome::NoCam(why) => {
            return no_cam(args.json, input, (!stays).then_some(folder), &why, start);
        }
    };
    let solve_s = solving.elapsed().as_secs_f64();
    if let Some(why) = design.no_cam(language::current()) {
        report(words::fill("simulate-no-cam", &json!({"why": why})));
        if args.json {
            print_json(&json!({"model": null, "outcome": "infeasible", "why": why}));
        }
        if !stays {
            let total_s = start.elapsed().as_secs_f64();
            let scene = input.resolved();
            let summary = summary(&design, &scene, Timing { solve_s, total_s });
            let place = finish(folder, input, &scene, &summary)?;
            if !args.json {
                print(&files_in(&place, "summary.json"));
            }
        }
        return Ok(NO_SUCH_CAM);
    }
    let run = emitted(args, &made.running, &design)?;
    let outcome = simulate(&run, model)?;
    let design = design.judged_in(&outcome);
    let running = Running {
        outcome: &outcome,
        second_cam: run.machine.second_cam,
    };
    let time = Timing {
        solve_s,
        total_s: start.elapsed().as_secs_f64(),
    };
    let mut json = simulation::json(&outcome);
    json["verdict"] = design.verdict.name().into();
    json["speed_rad_per_s"] = run.drive.speed.into();
    let text = serde_json::to_string_pretty(&json).unwrap_or_default();
    let columns = simulation::columns(&outcome);
    folder.write("dynamics.csv", csv::text(&columns).as_bytes())?;
    folder.write("dynamics.xlsx", &xlsx::table("dynamics", &columns)?)?;
    folder.write("simulation.json", text.as_bytes())?;
    let page = html_of_run(&design, time, &running, language::current());
    folder.write("report.html", page.as_bytes())?;
    write_scene(&folder, input, &scene)?;
    let place = folder.path().to_path_buf();
    folder.commit(&others)?;
    if args.json {
        print_json(&json);
    } else {
        let untargeted = untargeted.map(|e| no_target(&e));
        let unused = args
            .machine()
            .into_iter()
            .filter_map(|f| made.unused(f.key));
        let remarks = remark(args, &made, &design)
            .into_iter()
            .chain(unused)
            .chain(untargeted);
        describe(&design, remarks, &outcome);
        print(&files_in(&place, "report.html"));
    }
    Ok(exit_code::of(design.verdict))
}

/// Sentence that states why the simulated force is not compared with a target.
fn no_target(why: &Error) -> String {
    let why = why.sentence(language::current());
    words::fill("simulate-no-target", &json!({"why": why}))
}

/// Prints the verdict, its reason, remarks, and the table of the simulation.
fn describe(design: &Design, remarks: impl Iterator<Item = String>, outcome: &Outcome) {
    let verdict = words::name(design.verdict.name());
    print(&format!("{}: {verdict}", design.problem.name));
    print(&format!("  {}", design.reason(language::current())));
    for remark in remarks {
        print(&format!("  {remark}"));
    }
    let measures = design.cam.follower.measures();
    print(&simulation::table(outcome, measures, language::current()));
}

/// Folder for the files: the folder given by `--out`. Without this option, the files of an unchanged result folder are written into this
/// folder. In all other cases, the folder is `out/NAME`, or `out/NAME_run` for a changed machine.
fn folder(args: &SimulateArgs, made: &CamInMachine) -> Result<PathBuf> {
    match (&args.out, &args.scene.scene) {
        (None, Some(result)) if result.is_dir() && !made.other_machine => Ok(result.clone()),
        (out, _) => {
            let ending = if made.other_machine { "_run" } else { "" };
            input::result_folder(&made.input, out.as_deref(), ending)
        }
    }
}

/// Remark that the cam of the result runs in a changed machine, or that the cam was designed again for another speed. `None` in other
/// cases.
fn remark(args: &SimulateArgs, made: &CamInMachine, design: &Design) -> Option<String> {
    if made.other_machine {
        let rpm = words::number(design.problem.drive.speed * 30.0 / PI);
        return Some(words::fill("simulate-as-made", &json!({"rpm": rpm})));
    }
    let speed = |change: &String| change.trim_start().starts_with("drive.speed");
    let again = design.target().is_some() && args.scene.set.iter().any(speed);
    again.then(|| words::text("simulate-designed-again"))
}

/// Simulation input: the profile of the design as written to the files, with the machine of this run.
fn emitted(args: &SimulateArgs, scene: &Scene, design: &Design) -> Result<Run> {
    let run = design.emitted(&scene.machine, design.problem.drive);
    run.map_err(|e| match args.natural_frequency {
        Some(_) => e.placed(Place::Argument("--natural-frequency".to_string())),
        None => e,
    })
}

//! `gaitcam simulate`: runs the emitted cam, not the law it came from.

use std::f64::consts::TAU;
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use serde_json::json;

use crate::error::CliError;
use crate::exit_code::{self, NO_SUCH_CAM};
use crate::input::{self, Input, SceneArgs};
use crate::result_folder::ResultFolder;
use crate::searching;
use crate::synth::files_in;
use crate::terminal::{print, print_json, report};
use crate::words;
use gaitcam::drive::Drive;
use gaitcam::dynamics::Train;
use gaitcam::dynamics::hertz::STEEL;
use gaitcam::dynamics::{Face, Machine, Model, Run, simulate};
use gaitcam::error::Result;
use gaitcam::scene::{MachineSpec, Scene};
use gaitcam::synth::{Design, sentences, synthesise_with};
use gaitcam::units::Dimension;
use gaitcam_output::Timing;
use gaitcam_output::report::{Running, html_of_run};

/// Rows of the emitted profile that is run.
const POINTS: usize = 1440;

const EXAMPLES: &str = "Examples:
  gaitcam simulate scenes/footbridge.toml
  gaitcam simulate scenes/heel_tester.toml --model flexible --natural-frequency '60 Hz'
  gaitcam simulate scenes/thesis_iteration_3.toml --set 'drive.speed=300 rpm' --restitution 0.5";

/// Which scene, on which machine, by which model.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct SimulateArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// auto (the simplest that is sufficient), rigid, flexible, contact
    #[arg(long, default_value = "auto")]
    model: String,
    /// Folder for dynamics.csv, simulation.json and report.html (default out/NAME)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
    /// First natural frequency of the follower train: "60 Hz"
    #[arg(long, value_name = "HZ", allow_hyphen_values = true)]
    natural_frequency: Option<String>,
    /// Damping ratio of the follower train (default: that of the scene, else 0.05)
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true)]
    damping_ratio: Option<String>,
    /// Coefficient of friction between cam and follower (default: that of the scene, else 0)
    #[arg(long, value_name = "MU", allow_hyphen_values = true)]
    friction: Option<String>,
    /// Coefficient of restitution of an impact, 0 … 1 (default: that of the scene, else 0)
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    restitution: Option<String>,
    /// Angle by which a second, equal cam follows on the same shaft: "180 deg"
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    second_cam: Option<String>,
}

/// Designs the scene's cam, emits its profile and runs that; exit code 3 when there is no cam to run, or one
/// that is unacceptable, be it for contact lost in this run.
pub fn run(args: &SimulateArgs) -> Result<u8> {
    let model = Model::parse(&args.model).ok_or_else(|| {
        let typed = args.model.clone();
        CliError::NoModel { typed }.flag("--model")
    })?;
    let start = Instant::now();
    let input = input::scene(&args.scene)?;
    let folder = ResultFolder::open(&input.result_folder(args.out.as_deref(), "")?)?;
    let target = input.target()?;
    let solving = Instant::now();
    let mut design = synthesise_with(&input.scene, target.as_ref(), &searching::shared())?;
    let solve_s = solving.elapsed().as_secs_f64();
    if let Some(why) = no_cam(&design) {
        report(words::fill("simulate-no-cam", &json!({"why": why})));
        if args.json {
            print_json(&json!({"model": null, "outcome": "infeasible", "why": why}));
        }
        return Ok(NO_SUCH_CAM);
    }
    let run = prepared(args, &input, &design)?;
    let outcome = simulate(&run, model)?;
    if outcome.contact_lost && contact_is_judged(&input.scene) {
        design.loses_contact(outcome.lost_fraction);
    }
    let running = Running {
        outcome: &outcome,
        second_cam: run.machine.second_cam,
    };
    let time = Timing {
        solve_s,
        total_s: start.elapsed().as_secs_f64(),
    };
    let mut json = outcome.json();
    json["verdict"] = design.verdict.name().into();
    let text = serde_json::to_string_pretty(&json).unwrap_or_default();
    folder.write("dynamics.csv", outcome.csv().as_bytes())?;
    folder.write("simulation.json", text.as_bytes())?;
    let page = html_of_run(&design, time, &running, crate::language::current());
    folder.write("report.html", page.as_bytes())?;
    let place = folder.path().to_path_buf();
    folder.commit(&[])?;
    if args.json {
        print_json(&json);
    } else {
        print(&format!(
            "{}: {}",
            design.name,
            words::name(design.verdict.name())
        ));
        print(&format!("  {}", design.reason(crate::language::current())));
        print(&outcome.table(run.cam.follower.measures(), crate::language::current()));
        print(&files_in(&place, "report.html"));
    }
    Ok(exit_code::of(design.verdict))
}

/// Whether the scene leaves it to the verdict that contact is kept.
fn contact_is_judged(scene: &Scene) -> bool {
    let limits = &scene.limits;
    !limits.unjudged.contact_force && limits.force_min.is_none_or(|low| low >= 0.0)
}

/// Why a design has no cam that could run.
fn no_cam(design: &Design) -> Option<String> {
    let language = crate::language::current();
    if let Some(infeasible) = &design.infeasible {
        return Some(sentences(&infeasible.reasons, language));
    }
    let undercut = design.cam.follower.is_flat() && design.cam.curvature().undercut;
    undercut.then(|| sentences(&design.reasons, language))
}

/// The emitted profile of the design on the machine.
fn prepared(args: &SimulateArgs, input: &Input, design: &Design) -> Result<Run> {
    let mut machine = machine(args, &input.scene, &design.drive)?;
    machine.groove_floor = design.groove.as_ref().map(|groove| groove.depth().0);
    machine.conjugate = design.conjugate.as_ref().map(|pair| pair.second.clone());
    let angles = (0..POINTS).map(|i| TAU * i as f64 / POINTS as f64);
    Ok(Run {
        profile: design.cam.profile(POINTS),
        target: design
            .target
            .as_ref()
            .map(|t| angles.map(|theta| t.at(theta)).collect()),
        cam: design.cam.clone(),
        drive: design.drive,
        machine,
    })
}

/// The scene's machine, with what the command line says in its place.
fn machine(args: &SimulateArgs, scene: &Scene, drive: &Drive) -> Result<Machine> {
    let given = |flag: &str, text: &Option<String>, dimension| {
        input::quantity(flag, text.as_deref(), dimension)
    };
    let spec = &scene.machine;
    let mut machine = Machine::default();
    let hz = given(
        "--natural-frequency",
        &args.natural_frequency,
        Dimension::Frequency,
    )?;
    let ratio = given("--damping-ratio", &args.damping_ratio, Dimension::Ratio)?
        .unwrap_or(spec.damping_ratio);
    machine.train = match hz {
        Some(hz) => {
            let placed = input::at_flag("--natural-frequency");
            Some(Train::from_frequency(drive, hz, ratio).map_err(placed)?)
        }
        None => MachineSpec {
            damping_ratio: ratio,
            ..spec.clone()
        }
        .train(drive)?,
    };
    let friction = given("--friction", &args.friction, Dimension::Ratio)?;
    if friction.is_some_and(|mu| mu < 0.0) {
        let typed = args.friction.clone().unwrap_or_default();
        return Err(CliError::NegativeFriction { typed }.flag("--friction"));
    }
    machine.friction = friction.unwrap_or(spec.friction);
    let e =
        given("--restitution", &args.restitution, Dimension::Ratio)?.unwrap_or(spec.restitution);
    if !(0.0..=1.0).contains(&e) {
        return Err(CliError::Restitution { value: e }.flag("--restitution"));
    }
    machine.restitution = e;
    machine.second_cam =
        given("--second-cam", &args.second_cam, Dimension::Angle)?.or(spec.second_cam);
    machine.face = Some(Face {
        length: scene.cam.thickness,
        cam: STEEL,
        follower: STEEL,
    });
    Ok(machine)
}

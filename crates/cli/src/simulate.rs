//! `gaitcam simulate`: runs the emitted cam, not the law it came from.

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;

use super::{BUILT, NO_SUCH_CAM, SceneArgs, input, say};
use gaitcam::drive::Drive;
use gaitcam::dynamics::hertz::STEEL;
use gaitcam::dynamics::impact::Restitution;
use gaitcam::dynamics::train::Train;
use gaitcam::dynamics::{Face, Machine, Model, Run, simulate};
use gaitcam::error::{Error, Place, Result};
use gaitcam::scene::{MachineSpec, Scene};
use gaitcam::synth::synthesise;
use gaitcam::units::{Dimension, parse};
use gaitcam_output::Timing;
use gaitcam_output::folder::Folder;
use gaitcam_output::report::{Running, html_of_run};

/// Rows of the emitted profile that is run.
const POINTS: usize = 1440;

#[derive(Args, Debug)]
pub struct SimulateArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// auto (the least that is enough), rigid, flexible, contact
    #[arg(long, default_value = "auto")]
    model: String,
    /// Folder for dynamics.csv, simulation.json and report.html (default out/NAME)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// First natural frequency of the follower train: "60 Hz"
    #[arg(long, value_name = "HZ", allow_hyphen_values = true)]
    natural_frequency: Option<String>,
    /// Damping ratio of the follower train (0.05 where the scene says nothing)
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true)]
    damping_ratio: Option<String>,
    /// Coefficient of friction where cam and follower rub (0 where the scene says nothing)
    #[arg(long, value_name = "MU", allow_hyphen_values = true)]
    friction: Option<String>,
    /// Coefficient of restitution of a landing, 0 … 1 (0 where the scene says nothing)
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    restitution: Option<String>,
    /// Angle by which a second, equal cam follows on the same shaft: "180 deg"
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    second_cam: Option<String>,
}

/// Designs the scene's cam, emits its profile and runs that.
pub fn run(args: &SimulateArgs) -> Result<u8> {
    let model = Model::parse(&args.model).ok_or_else(|| {
        Error::argument("--model", format!("\"{}\" is not a model", args.model))
            .help("write auto, rigid, flexible or contact")
    })?;
    let start = Instant::now();
    let input = input::scene(&args.scene)?;
    let out = args
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from("out").join(&input.scene.name));
    let folder = Folder::open(&out)?;
    let target = input.target()?;
    let solving = Instant::now();
    let design = synthesise(&input.scene, target.as_ref())?;
    let solve_s = solving.elapsed().as_secs_f64();
    if let Some(infeasible) = &design.infeasible {
        eprintln!("gaitcam: there is no cam to run: {}", infeasible.words());
        return Ok(NO_SUCH_CAM);
    }
    if design.cam.follower.is_flat() && design.cam.curvature().undercut {
        eprintln!("gaitcam: there is no cam to run: {}", design.reason());
        return Ok(NO_SUCH_CAM);
    }
    let mut machine = machine(args, &input.scene, &design.drive)?;
    machine.conjugate = design.conjugate.as_ref().map(|pair| pair.second.clone());
    let run = Run {
        profile: design.cam.profile(POINTS),
        target: design.target.as_ref().map(|t| {
            (0..POINTS)
                .map(|i| t.at(std::f64::consts::TAU * i as f64 / POINTS as f64))
                .collect()
        }),
        cam: design.cam.clone(),
        drive: design.drive,
        machine,
    };
    let outcome = simulate(&run, model)?;
    folder.write("dynamics.csv", outcome.csv().as_bytes())?;
    let json = serde_json::to_string_pretty(&outcome.json()).unwrap_or_default();
    folder.write("simulation.json", json.as_bytes())?;
    let running = Running {
        outcome: &outcome,
        second_cam: run.machine.second_cam,
    };
    let time = Timing {
        solve_s,
        total_s: start.elapsed().as_secs_f64(),
    };
    let page = html_of_run(&design, time, &running);
    folder.write("report.html", page.as_bytes())?;
    if args.json {
        say(&json);
    } else {
        say(&outcome.table(run.cam.follower.measures()));
        say(&format!(
            "Files in {}; open {} first.",
            folder.path().display(),
            folder.path().join("report.html").display()
        ));
    }
    Ok(BUILT)
}

/// The scene's machine, with what the command line says in its place.
fn machine(args: &SimulateArgs, scene: &Scene, drive: &Drive) -> Result<Machine> {
    let given = |flag: &str, text: &Option<String>, dimension| -> Result<Option<f64>> {
        text.as_deref()
            .map(|t| parse(t, dimension).map_err(|e| e.at(Place::Argument(flag.to_string()))))
            .transpose()
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
            let place = Place::Argument("--natural-frequency".to_string());
            Some(Train::from_frequency(drive, hz, ratio).map_err(|e| e.at(place))?)
        }
        None => MachineSpec {
            damping_ratio: ratio,
            ..spec.clone()
        }
        .train(drive)?,
    };
    machine.friction =
        given("--friction", &args.friction, Dimension::Ratio)?.unwrap_or(spec.friction);
    let e =
        given("--restitution", &args.restitution, Dimension::Ratio)?.unwrap_or(spec.restitution);
    if !(0.0..=1.0).contains(&e) {
        return Err(
            Error::argument("--restitution", format!("{e} is outside 0 … 1"))
                .help("0 lands without a bounce, 1 loses nothing"),
        );
    }
    machine.restitution = Restitution::Prescribed(e);
    machine.second_cam =
        given("--second-cam", &args.second_cam, Dimension::Angle)?.or(spec.second_cam);
    machine.face = Some(Face {
        length: scene.cam.thickness,
        cam: STEEL,
        follower: STEEL,
    });
    Ok(machine)
}

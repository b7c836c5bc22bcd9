//! `gaitcam walk`: computes the speed programme with which a cam has the step times of a recorded walk.

pub mod programme;

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};

use crate::console::error::CliError;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::terminal::{print, print_json, report};
use crate::console::words::{self, fixed, number};
use crate::input::made::CamInMachine;
use crate::input::{self, SceneArgs};
use gaitcam::LimitKind;
use gaitcam::drive::DriveKind;
use gaitcam::dynamics::{
    Bounds, Followed, Misfit, ProgrammeRun, RepeatedForce, Run, SpeedProgramme,
};
use gaitcam::error::{Placed, Result};
use gaitcam::force::{
    FEWEST_STRIDES, Feet, Interpretation, OpenQuestion, ReadOptions, StepStatistics, Walk,
    force_curve,
};
use gaitcam::scene::content;
use gaitcam::synth::Design;
use gaitcam::units::Dimension;
use gaitcam_app::disk::metadata;
use gaitcam_app::folder::write_whole;
use gaitcam_app::{Disk, inputs};
use gaitcam_output::csv;
use gaitcam_output::plots::{Responding, Response, repeated_strides, responses};

const EXAMPLES: &str = "Examples:
  gaitcam walk out/walk walk.mot
  gaitcam walk out/walk walk.mot --out speed.csv --max-acceleration '10 rad/s^2'
  gaitcam walk footbridge --generate 128 --step-time-cv '2.5 %'
  gaitcam simulate out/walk --speed-programme speed.csv";

/// Maximum number of strides that can be generated.
const MOST_GENERATED: i64 = 2048;
/// Maximum coefficient of variation of generated step times and amplitudes. The limit prevents step times near zero.
const MOST_VARIED: f64 = 0.15;

/// Arguments of `gaitcam walk`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct WalkArgs {
    /// The design: a folder or summary.json of synth, a scene file or the name of a built-in scene
    #[arg(value_name = "RESULT")]
    design: PathBuf,
    /// A recording with eight or more consecutive strides (default: the recording of the design)
    #[arg(value_name = "RECORDING")]
    recording: Option<PathBuf>,
    /// Generate this number of strides with the statistics of human steps, instead of a recording
    #[arg(long, value_name = "STRIDES", conflicts_with = "recording", value_parser = clap::value_parser!(u16).range(FEWEST_STRIDES as i64..=MOST_GENERATED))]
    generate: Option<u16>,
    /// Coefficient of variation of the generated step times (default "3 %")
    #[arg(long, value_name = "CV", requires = "generate")]
    step_time_cv: Option<String>,
    /// Coefficient of variation of the amplitude of the generated force (default 0)
    #[arg(long, value_name = "CV", requires = "generate")]
    amplitude_cv: Option<String>,
    /// Seed of the generated steps
    #[arg(long, default_value_t = 1, requires = "generate")]
    seed: u64,
    /// File for the programme; pictures of the response (svg, png) are written to the same folder
    #[arg(long, value_name = "SPEED.csv", default_value = "speed.csv")]
    out: PathBuf,
    /// Maximum angular acceleration of the camshaft: "10 rad/s^2"
    #[arg(long, value_name = "ACCELERATION")]
    max_acceleration: Option<String>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Computes the speed programme, and writes its file and a picture. The exit code is 3 if the design has no cam.
pub fn run(args: &WalkArgs) -> Result<u8> {
    let most = args.max_acceleration.as_deref();
    let acceleration = input::positive("--max-acceleration", most, Dimension::AngularAcceleration)?;
    let made = CamInMachine::read(&SceneArgs::of(args.design.clone()), &[])?;
    let design = made.design()?.0.built()?;
    if let Some(why) = design.no_cam(language::current()) {
        report(words::fill("walk-no-cam", &json!({"why": why})));
        return Ok(NO_SUCH_CAM);
    }
    let statistics = args
        .generate
        .map(|strides| statistics(args, strides.into()));
    let statistics = statistics.transpose()?;
    let walk = match (&args.recording, &statistics) {
        (Some(path), _) => recorded(path)?,
        (None, Some(statistics)) => design
            .generated_walk(statistics)
            .ok_or_else(|| CliError::NothingToWalk.at_argument("--generate"))?,
        (None, None) => design
            .walk()
            .ok_or_else(|| CliError::NoWalk.at_argument("RECORDING"))?,
    };
    let walk = on_cam(walk, &design);
    let drive = &design.problem.drive;
    let force_min = made.running.limits[LimitKind::ForceMin].map_or(0.0, |f| drive.newtons(f));
    let bounds = Bounds {
        acceleration: acceleration.unwrap_or(f64::INFINITY),
        force_min,
    };
    let run = design.emitted(&made.running.machine, *drive)?;
    let steps = design.problem.steps_per_turn.unwrap_or(2);
    let own = design.walk().filter(|_| args.generate.is_none());
    let middle = own.map_or(0.5, |own| own.middle());
    let found = Followed::new(&run, &walk, steps, -design.problem.phase, middle, bounds)?;
    let even = steady(&run, &walk, steps)?;
    write_whole(&args.out, table(&found).as_bytes())?;
    let of_walk = match args.generate {
        Some(_) => Responding::Generated,
        None => Responding::Recorded,
    };
    picture(&design, (of_walk, &walk), &found, &even, &args.out)?;
    let mut facts = json(&walk, &found, &even);
    facts["generated"] = json!(statistics);
    if args.json {
        print_json(&facts);
        return Ok(BUILT);
    }
    let first = match args.generate {
        Some(_) => "walk-generated",
        None => "walk-strides",
    };
    lines(first, &walk, &found, &even)
        .iter()
        .for_each(|line| print(line));
    let file = args.out.display().to_string();
    print(&words::fill("walk-file", &json!({"file": file})));
    Ok(BUILT)
}

/// Reads the consecutive strides of a recording.
fn recorded(path: &Path) -> Result<Walk> {
    inputs::note(path);
    let bytes = content(&Disk::default(), path)?;
    let options = ReadOptions {
        metadata: metadata(path),
        ..ReadOptions::default()
    };
    let curve = force_curve(path, &bytes, &options, Feet::Both)?;
    let understood = curve.recording.as_deref();
    if understood.is_some_and(|u| u.doubts().contains(&OpenQuestion::Clipped)) {
        return Err(CliError::ClippedWalk.in_file(path));
    }
    let strides = understood.map_or(0, Interpretation::longest_run);
    curve.walk.ok_or_else(|| {
        let needed = FEWEST_STRIDES;
        CliError::FewStrides { strides, needed }.in_file(path)
    })
}

/// Statistics of the generated steps, from the arguments and the default values.
fn statistics(args: &WalkArgs, strides: usize) -> Result<StepStatistics> {
    let usual = StepStatistics::default();
    let share = |flag, text: &Option<String>| match input::quantity(
        flag,
        text.as_deref(),
        Dimension::Percent,
    )? {
        Some(x) if !(0.0..=MOST_VARIED).contains(&x) => {
            let most = format!("{} %", number(100.0 * MOST_VARIED));
            Err(CliError::VariesTooMuch { most }.at_argument(flag))
        }
        given => Ok(given),
    };
    Ok(StepStatistics {
        strides,
        step_time_cv: share("--step-time-cv", &args.step_time_cv)?.unwrap_or(usual.step_time_cv),
        amplitude_cv: share("--amplitude-cv", &args.amplitude_cv)?.unwrap_or(usual.amplitude_cv),
        seed: args.seed,
    })
}

/// The walk in the machine of a design. For a moving axis, the force of the walk is scaled to the mean force of the cam. This mean force
/// corresponds to the weight of the walker.
fn on_cam(walk: Walk, design: &Design) -> Walk {
    let drive = &design.problem.drive;
    if drive.kind != DriveKind::MovingAxis {
        return walk;
    }
    let force = walk.force_n();
    let mean = force.iter().sum::<f64>() / force.len() as f64;
    walk.scaled(drive.newtons(drive.rest_force) / mean)
}

/// Force of the cam at constant speed, and three misfits, one per damping ratio. Each misfit compares the response of a vibration mode to
/// this force with its response to the recorded walk.
fn steady(run: &Run, walk: &Walk, steps: usize) -> Result<(RepeatedForce, [Misfit; 3])> {
    let mut still = run.clone();
    still.machine.motor = None;
    let turns = 2.0 * walk.strides() as f64 / steps as f64;
    let speed = std::f64::consts::TAU * turns / walk.duration_s;
    let count = walk.samples();
    let time = (0..=count).map(|i| walk.duration_s * i as f64 / count as f64);
    let even = SpeedProgramme::new(time.collect(), vec![speed; count + 1])?;
    let even = ProgrammeRun::new(&still, &even, 0.0)?;
    let force = RepeatedForce::new(&even.force_n[..count], walk.duration_s, walk.strides());
    let off = RepeatedForce::of(walk).misfits(&force);
    Ok((force, off))
}

/// Content of `speed.csv`: the speed programme, the cam angle and the recorded force.
fn table(found: &Followed) -> String {
    csv::text(&vec![
        ("time_s", found.programme.time_s.clone()),
        ("speed_rad_per_s", found.programme.speed.clone()),
        ("angle_rad", found.run.angle.clone()),
        ("walk_n", found.walk_n.clone()),
    ])
}

fn picture(
    design: &Design,
    (of_walk, walk): (Responding, &Walk),
    found: &Followed,
    even: &(RepeatedForce, [Misfit; 3]),
    place: &Path,
) -> Result<()> {
    let count = walk.samples();
    let force = &found.run.force_n[..count];
    let programme = RepeatedForce::new(force, walk.duration_s, walk.strides());
    let all = [
        (of_walk, RepeatedForce::of(walk)),
        (Responding::Cam, even.0.clone()),
        (Responding::Programme, programme),
    ];
    let all = all.map(|(of, force)| Response { of, force });
    let all: Vec<Response> = all.into_iter().chain(repeated_strides(walk)).collect();
    let picture = responses(&design.problem.name, &all, language::current());
    write_whole(&place.with_extension("svg"), picture.svg().as_bytes())?;
    write_whole(&place.with_extension("png"), &picture.png())
}

/// Minimum and maximum of the values. An empty list gives +∞ and −∞.
pub fn ends(values: &[f64]) -> [f64; 2] {
    let ends = [f64::INFINITY, f64::NEG_INFINITY];
    values
        .iter()
        .fold(ends, |[low, high], x| [low.min(*x), high.max(*x)])
}

/// Maximum absolute value of a list. An empty list gives 0.
pub fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| most.max(x.abs()))
}

fn json(walk: &Walk, found: &Followed, even: &(RepeatedForce, [Misfit; 3])) -> Value {
    let run = &found.run;
    let ([low, high], [least, most]) = (ends(&run.speed), ends(&run.force_n));
    json!({
        "strides": walk.strides(), "runs": walk.runs.len(), "duration_s": walk.duration_s,
        "step_frequency_hz": walk.step_frequency_hz(),
        "variability": walk.variability(), "changes_pace": walk.changes_pace(),
        "misfit": found.misfits, "constant_speed": even.1,
        "step_error_s": found.step_error_s,
        "force": {"min": least, "max": most, "rms_error_n": found.rms_error_n},
        "amplitude_cv": amplitude_cv(walk, found),
        "speed": {"min_rad_per_s": low, "max_rad_per_s": high, "acceleration_max_rad_per_s2": largest(&run.acceleration)},
        "torque_max_n_m": largest(&run.torque),
        "contact_lost": run.contact_lost,
    })
}

/// Coefficient of variation of the cam's force amplitude at the step frequency, when the cam runs with the speed programme.
fn amplitude_cv(walk: &Walk, found: &Followed) -> f64 {
    let own = walk.with_force(&found.run.force_n[..walk.samples()]);
    own.variability().amplitude_cv
}

/// One value of each misfit as text with three decimals. `value` selects the value, such as the misfit itself or its peak ratio.
pub fn list(of: &[Misfit], value: impl Fn(&Misfit) -> f64) -> String {
    let all: Vec<String> = of.iter().map(|m| fixed(value(m), 3)).collect();
    all.join("  ")
}

/// Damping ratios of the misfits, %, as one text.
pub fn dampings(of: &[Misfit]) -> String {
    let all: Vec<String> = of.iter().map(|m| number(100.0 * m.damping_ratio)).collect();
    all.join("  ")
}

fn lines(
    first: &str,
    walk: &Walk,
    found: &Followed,
    even: &(RepeatedForce, [Misfit; 3]),
) -> Vec<String> {
    let run = &found.run;
    let ([low, high], [least, most]) = (ends(&run.speed), ends(&run.force_n));
    let percent = |x: f64| fixed(100.0 * x, 1);
    let of = walk.variability();
    let mut out = vec![
        words::fill(
            first,
            &json!({"strides": of.strides, "duration": number(walk.duration_s), "time": percent(of.step_time_cv),
                "error": number(1e3 * found.step_error_s)}),
        ),
        words::fill(
            "walk-misfit",
            &json!({"dampings": dampings(&found.misfits), "misfit": list(&found.misfits, |m| m.misfit),
                "peak": list(&found.misfits, |m| m.peak_ratio)}),
        ),
        words::fill(
            "walk-constant",
            &json!({"misfit": list(&even.1, |m| m.misfit), "peak": list(&even.1, |m| m.peak_ratio)}),
        ),
        words::fill(
            "walk-motion",
            &json!({"low": number(low), "high": number(high), "acceleration": number(largest(&run.acceleration)),
                "torque": number(largest(&run.torque))}),
        ),
        words::fill(
            "walk-force",
            &json!({"low": number(least), "high": number(most), "error": number(found.rms_error_n)}),
        ),
        words::fill(
            "walk-amplitude",
            &json!({"own": percent(amplitude_cv(walk, found)), "recorded": percent(of.amplitude_cv)}),
        ),
    ];
    if walk.changes_pace() {
        out.push(words::fill(
            "walk-pace",
            &json!({"change": percent(of.drift)}),
        ));
    }
    out
}

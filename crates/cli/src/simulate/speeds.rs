//! One cam as it is made at several speeds: `speeds.csv` and its table.

use std::f64::consts::TAU;
use std::fmt::Write;
use std::time::Instant;

use serde_json::{Value, json};

use super::{SimulateArgs, machine};
use crate::console::error::CliError;
use crate::console::language;
use crate::console::terminal::{print, print_json, report};
use crate::console::words;
use crate::console::{exit_code, exit_code::NO_SUCH_CAM};
use crate::input::made::Made;
use crate::input::{self, at_flag};
use crate::synth::{files_in, no_cam};
use gaitcam::Problem;
use gaitcam::dynamics::{Model, Outcome, simulate};
use gaitcam::error::{Placed, Result, is_no_cam};
use gaitcam::scene::Source;
use gaitcam::synth::Design;
use gaitcam::units::{Dimension, parse};
use gaitcam_files::design::write_scene;
use gaitcam_files::{PATIENCE, ResultFolder};

/// Most speeds of a table.
const MOST: usize = 1000;
/// Samples of the target.
const SAMPLES: usize = 1440;
const COLUMNS: &str =
    "speed_rad_per_s,rms_error_n,dlf_1,dlf_2,dlf_3,dlf_4,torque_max_n_m,contact_lost,ripple";

/// The cam at one speed.
struct AtSpeed {
    speed: f64,
    outcome: Outcome,
    load_factors: Option<[f64; 4]>,
}

/// Runs the cam of the arguments at each of `speeds`, FIRST:LAST:COUNT.
pub fn run(args: &SimulateArgs, speeds: &str, model: Model) -> Result<u8> {
    let (speeds, start) = (read(speeds)?, Instant::now());
    let made = Made::read(&args.scene, None)?;
    let place = input::result_folder(&made.input, args.out.as_deref(), "_speeds")?;
    let folder = ResultFolder::open(&place, PATIENCE)?;
    let design = match made.design() {
        Err(error) if is_no_cam(&error) => {
            return no_cam(args.json, &made.input, Some(folder), &error, start);
        }
        design => design?,
    };
    if let Some(why) = design.no_cam(language::current()) {
        report(words::fill("simulate-no-cam", &json!({"why": why})));
        return Ok(NO_SUCH_CAM);
    }
    let rows = speeds.iter().map(|w| at(args, &made, &design, *w, model));
    let rows = rows.collect::<Result<Vec<_>>>()?;
    folder.write("speeds.csv", csv(&rows).as_bytes())?;
    let scene = toml::to_string(&made.input.resolved()).unwrap_or_default();
    write_scene(&folder, &made.input, &scene)?;
    let place = folder.path().to_path_buf();
    folder.commit(&[])?;
    if args.json {
        print_json(&Value::Array(rows.iter().map(AtSpeed::json).collect()));
    } else {
        print(&table(&rows));
        print(&files_in(&place, "speeds.csv"));
    }
    Ok(exit_code::of(design.verdict))
}

/// Speeds at equal steps, rad/s; a frequency is that of the turns.
fn read(text: &str) -> Result<Vec<f64>> {
    let fault = || {
        let typed = text.to_string();
        CliError::Speeds { typed, most: MOST }.at_argument("--speeds")
    };
    let parts: Vec<&str> = text.split(':').map(str::trim).collect();
    let &[first, last, count] = &parts[..] else {
        return Err(fault());
    };
    // One unit may stand behind all: 1.4:2.3:10 Hz.
    let (count, unit) = count.split_once(' ').unwrap_or((count, ""));
    let count: usize = count.parse().map_err(|_| fault())?;
    let speed = |text: &str| {
        let text = format!("{text} {unit}");
        let turns = parse(&text, Dimension::Frequency).map(|hz| TAU * hz);
        turns.or_else(|_| parse(&text, Dimension::AngularSpeed).map_err(at_flag("--speeds")))
    };
    let (first, last) = (speed(first)?, speed(last)?);
    if !(2..=MOST).contains(&count) || first <= 0.0 || last <= 0.0 {
        return Err(fault());
    }
    let at = |i: usize| first + (last - first) * i as f64 / (count - 1) as f64;
    Ok((0..count).map(at).collect())
}

/// The emitted cam at a speed, against the target of that speed where a load model gives one.
fn at(
    args: &SimulateArgs,
    made: &Made,
    design: &Design,
    speed: f64,
    model: Model,
) -> Result<AtSpeed> {
    let mut scene = made.running.clone();
    scene.drive.speed = Some(speed);
    let factors = design.load_factors();
    let steps = factors.first().map_or(1.0, |f| (1.0 / f.of_step).round());
    let mut of_model = None;
    if let Some(gait) = &mut scene.gait
        && matches!(gait.source, Source::Model(_))
    {
        gait.step_frequency = Some(steps * speed / TAU);
        of_model = gait.model_force()?;
    }
    let force = of_model.as_ref().or(design.target_in_time());
    let problem = Problem::resolve(&scene, force)?;
    let mut run = design.emitted(&machine(args, &scene.machine)?, problem.drive)?;
    if of_model.is_some() {
        let target = problem.at_phase(design.phase).target;
        let angle = |i: usize| TAU * i as f64 / SAMPLES as f64;
        run.target = target.map(|t| (0..SAMPLES).map(|i| t.curve.at(angle(i))).collect());
    }
    let outcome = simulate(&run, model)?;
    let weight = design.weight_n.filter(|w| *w > 0.0 && !factors.is_empty());
    let load_factors = weight.map(|weight| {
        [1, 2, 3, 4].map(|k| amplitude(&outcome, steps * f64::from(k), speed) / weight)
    });
    Ok(AtSpeed {
        speed,
        outcome,
        load_factors,
    })
}

/// Amplitude of a harmonic of the turn in the force over time, N.
fn amplitude(outcome: &Outcome, harmonic: f64, speed: f64) -> f64 {
    let (mut cosine, mut sine, mut sum) = (0.0, 0.0, 0.0);
    for row in &outcome.rows {
        let (s, c) = (harmonic * speed * row.time).sin_cos();
        // Rows lie at equal angles.
        let time = 1.0 / row.speed.abs();
        cosine += time * row.contact_force * c;
        sine += time * row.contact_force * s;
        sum += time;
    }
    2.0 * cosine.hypot(sine) / sum
}

impl AtSpeed {
    /// Largest absolute torque of the cam on the shaft, N·m.
    fn torque(&self) -> f64 {
        let torque = self.outcome.torque;
        torque.max.max(-torque.min)
    }

    fn ripple(&self) -> f64 {
        self.outcome.shaft.map_or(0.0, |s| s.ripple)
    }

    fn json(&self) -> Value {
        let factor = |k: usize| self.load_factors.map(|f| f[k]);
        json!({
            "speed_rad_per_s": self.speed,
            "rms_error_n": self.outcome.force.rms_error,
            "dlf_1": factor(0), "dlf_2": factor(1), "dlf_3": factor(2), "dlf_4": factor(3),
            "torque_max_n_m": self.torque(),
            "contact_lost": self.outcome.contact_lost,
            "ripple": self.ripple(),
        })
    }
}

fn csv(rows: &[AtSpeed]) -> String {
    let mut out = format!("{COLUMNS}\n");
    for row in rows {
        let row = row.json();
        let cell = |name: &str| match &row[name] {
            Value::Null => String::new(),
            value => value.to_string(),
        };
        let cells: Vec<String> = COLUMNS.split(',').map(cell).collect();
        let _ = writeln!(out, "{}", cells.join(","));
    }
    out
}

fn table(rows: &[AtSpeed]) -> String {
    let head = words::text("simulate-speeds-head");
    rows.iter().fold(head, |mut out, row| {
        let rms = row.outcome.force.rms_error;
        let rms = rms.map_or("—".to_string(), |e| words::fixed(e, 2));
        let factors = row.load_factors.map_or("—".to_string(), |f| {
            f.map(|x| words::fixed(x, 3)).join(" ")
        });
        let lost = match row.outcome.contact_lost {
            true => words::text("simulate-speeds-lost"),
            false => String::new(),
        };
        let rpm = words::fixed(row.speed * 30.0 / std::f64::consts::PI, 2);
        let (torque, ripple) = (
            words::fixed(row.torque(), 3),
            words::fixed(100.0 * row.ripple(), 2),
        );
        let line = format!("\n{rpm:>9} {rms:>11} {torque:>10} {ripple:>8}  {factors}  {lost}");
        out.push_str(line.trim_end());
        out
    })
}

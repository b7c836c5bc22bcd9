//! Simulation of one manufactured cam at several speeds: `speeds.csv`, table and picture.

use std::f64::consts::{PI, TAU};
use std::time::Instant;

use serde_json::{Value, json};

use super::{SimulateArgs, no_target};
use crate::console::error::CliError;
use crate::console::language;
use crate::console::table::{
    Side::{Left, Right},
    table,
};
use crate::console::terminal::{print, print_json, report};
use crate::console::words;
use crate::console::{exit_code, exit_code::NO_SUCH_CAM};
use crate::input::made::CamInMachine;
use crate::input::{self, at_flag};
use crate::synth::{files_in, no_cam};
use gaitcam::cam::Measures;
use gaitcam::dynamics::{Model, Outcome, simulate};
use gaitcam::error::{DynamicsError, Error, Placed, Result};
use gaitcam::sweep::{Field, Records};
use gaitcam::synth::{self, Design};
use gaitcam::units::{Dimension, parse};
use gaitcam_app::design::{OF_RUN, put_on, write_scene};
use gaitcam_app::inputs;
use gaitcam_app::{PATIENCE, ResultFolder};
use gaitcam_output::plots::{self, AtSpeed};

/// Maximum number of speeds in `--speeds`.
const MOST: usize = 1000;
const COLUMNS: &str =
    "speed_rad_per_s,rms_error_n,dlf_1,dlf_2,dlf_3,dlf_4,torque_max_n_m,contact_lost,ripple";

/// Row of the table: the results at one speed. If the motor cannot turn the shaft at this speed, `stands` contains the reason.
struct Row {
    at: AtSpeed,
    stands: Option<String>,
}

/// Simulates the cam at each of `speeds`, which has the form FIRST:LAST:COUNT.
pub fn run(args: &SimulateArgs, speeds: &str, model: Model) -> Result<u8> {
    let start = Instant::now();
    let made = CamInMachine::read(&args.scene, &args.machine())?;
    let speeds = read(speeds, made.running.cam.is_straight())?;
    let place = input::result_folder(&made.input, args.out.as_deref(), "_speeds")?;
    let folder = ResultFolder::open(&place, PATIENCE)?;
    inputs::check_in(folder.path(), OF_RUN)?;
    let design = match made.design()?.0 {
        synth::Outcome::Built(design) => *design,
        synth::Outcome::NoCam(why) => {
            return no_cam(args.json, &made.input, Some(folder), &why, start);
        }
    };
    if let Some(why) = design.no_cam(language::current()) {
        report(words::fill("simulate-no-cam", &json!({"why": why})));
        return Ok(NO_SUCH_CAM);
    }
    let mut untargeted = None;
    let mut row = |w: &f64| at(&made, &design, *w, model, &mut untargeted);
    let rows = speeds.iter().map(&mut row).collect::<Result<Vec<Row>>>()?;
    let measures = design.cam.follower.measures();
    let ran: Vec<AtSpeed> = rows.iter().map(|r| r.at).collect();
    let picture = plots::speeds(&design.problem.name, &ran, measures, language::current());
    folder.write("speeds.csv", csv(&rows).as_bytes())?;
    folder.write("speeds.svg", picture.svg().as_bytes())?;
    folder.write("speeds.png", &picture.png())?;
    let scene = toml::to_string(&made.input.resolved()).unwrap_or_default();
    write_scene(&folder, &made.input, &scene)?;
    let place = folder.path().to_path_buf();
    folder.commit(&[])?;
    if args.json {
        print_json(&Value::Array(rows.iter().map(Row::json).collect()));
    } else {
        print(&text(&rows, measures));
        if let Some(why) = untargeted {
            print(&no_target(&why));
        }
        print(&files_in(&place, "speeds.png"));
    }
    Ok(exit_code::of(design.verdict))
}

/// Equally spaced speeds, rad/s (m/s for a translating cam), from text of the form FIRST:LAST:COUNT. Values in Hz are turns per second.
fn read(text: &str, straight: bool) -> Result<Vec<f64>> {
    let fault = || {
        let typed = text.to_string();
        CliError::Speeds { typed, most: MOST }.at_argument("--speeds")
    };
    let parts: Vec<&str> = text.split(':').map(str::trim).collect();
    let &[first, last, count] = &parts[..] else {
        return Err(fault());
    };
    // A single unit at the end applies to both speeds: 1.4:2.3:10 Hz.
    let (count, unit) = count.split_once(' ').unwrap_or((count, ""));
    let count: usize = count.parse().map_err(|_| fault())?;
    let speed = |text: &str| {
        let text = format!("{text} {unit}");
        if straight {
            return parse(&text, Dimension::Speed).map_err(at_flag("--speeds"));
        }
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

/// Simulates the cam at one speed. If a load model is given, the force is compared with its target at this speed.
fn at(
    made: &CamInMachine,
    design: &Design,
    speed: f64,
    model: Model,
    untargeted: &mut Option<Error>,
) -> Result<Row> {
    let mut scene = made.running.clone();
    scene.drive.speed = Some(speed);
    let (moved, missing) = put_on(design.clone(), &scene)?;
    if let Some(why) = missing {
        untargeted.get_or_insert(why);
    }
    let run = moved.emitted(&scene.machine, moved.problem.drive)?;
    let outcome = match simulate(&run, model) {
        Ok(outcome) => outcome,
        Err(error) if stands(&error) => {
            return Ok(Row {
                at: AtSpeed {
                    speed,
                    torque: f64::NAN,
                    ..AtSpeed::default()
                },
                stands: Some(error.sentence(language::current())),
            });
        }
        Err(error) => return Err(error),
    };
    let factors = design.load_factors();
    let steps = factors.first().map_or(1.0, |f| (1.0 / f.of_step).round());
    let weight = design
        .problem
        .weight_n
        .filter(|w| *w > 0.0 && !factors.is_empty());
    let period = design.cam.law.extent().1 / speed;
    let own = |k: f64| amplitude(&outcome, steps * k * TAU / period) / outcome.lever;
    let torque = outcome.torque;
    let at = AtSpeed {
        speed,
        rms_error: outcome.force.rms_error.map(|e| e / outcome.lever),
        load_factors: weight.map(|weight| [1.0, 2.0, 3.0, 4.0].map(|k| own(k) / weight)),
        target_factors: target_factors(&moved),
        torque: torque.max.max(-torque.min),
        ripple: outcome.shaft.map_or(0.0, |s| s.ripple),
        contact_lost: outcome.contact_lost,
    };
    Ok(Row { at, stands: None })
}

/// Whether the error states that the motor cannot turn the shaft at the requested speed.
fn stands(error: &Error) -> bool {
    use DynamicsError::{NoLoadSpeed, Stalls, StallsAnyway};
    let fault = error.fault::<DynamicsError>();
    fault.is_some_and(|f| matches!(f, Stalls { .. } | StallsAnyway | NoLoadSpeed { .. }))
}

/// Dynamic load factors of the target for harmonics 1 to 4 of the step frequency; `None` if one of these harmonics is absent.
fn target_factors(design: &Design) -> Option<[f64; 4]> {
    let factors = design.load_factors();
    let of_step = |k: f64| factors.iter().find(|f| f.of_step == k).map(|f| f.target);
    let four: Option<Vec<f64>> = [1.0, 2.0, 3.0, 4.0].into_iter().map(of_step).collect();
    four?.try_into().ok()
}

/// Amplitude of the sinusoidal component of the contact force at the angular frequency `frequency`, rad/s. It has the unit of the contact
/// force.
fn amplitude(outcome: &Outcome, frequency: f64) -> f64 {
    let (mut cosine, mut sine, mut sum) = (0.0, 0.0, 0.0);
    for row in &outcome.rows {
        let (s, c) = libm::sincos(frequency * row.time);
        // The rows are spaced equally in angle, so each row is weighted by its time step.
        let time = 1.0 / row.speed.abs();
        cosine += time * row.contact_force * c;
        sine += time * row.contact_force * s;
        sum += time;
    }
    2.0 * libm::hypot(cosine, sine) / sum
}

impl Row {
    fn json(&self) -> Value {
        let at = &self.at;
        let factor = |k: usize| at.load_factors.map(|f| f[k]);
        let turns = self.stands.is_none();
        json!({
            "speed_rad_per_s": at.speed,
            "rms_error_n": at.rms_error,
            "dlf_1": factor(0), "dlf_2": factor(1), "dlf_3": factor(2), "dlf_4": factor(3),
            "torque_max_n_m": turns.then_some(at.torque),
            "contact_lost": turns.then_some(at.contact_lost),
            "ripple": turns.then_some(at.ripple),
        })
    }

    /// Texts of this row for the console table. `speed` is the text of the first cell.
    fn cells(&self, speed: String) -> Vec<String> {
        let at = &self.at;
        if let Some(why) = &self.stands {
            let why = words::fill("simulate-speeds-none", &json!({"why": why}));
            return [vec![speed], vec![String::new(); 4], vec![why]].concat();
        }
        let dash = || "—".to_string();
        let rms = at.rms_error.map_or_else(dash, words::number);
        let factors = at
            .load_factors
            .map_or_else(dash, |f| f.map(|x| words::fixed(x, 3)).join(" "));
        let lost = match at.contact_lost {
            true => words::text("simulate-speeds-lost"),
            false => String::new(),
        };
        let (torque, ripple) = (words::number(at.torque), words::number(100.0 * at.ripple));
        vec![speed, rms, torque, ripple, factors, lost]
    }
}

fn csv(rows: &[Row]) -> String {
    let rows: Vec<Value> = rows.iter().map(Row::json).collect();
    let lost = |row: &Value| match row["contact_lost"].as_bool() {
        Some(true) => "true",
        Some(false) => "false",
        None => "",
    };
    let field = |name: &str| match name {
        "contact_lost" => Field::words(name, rows.iter().map(lost)),
        _ => {
            let number = |row: &Value| row[name].as_f64().unwrap_or(f64::NAN);
            Field::numbers(name, rows.iter().map(number).collect())
        }
    };
    let fields = COLUMNS.split(',').map(field).collect();
    Records { fields }.csv()
}

fn text(rows: &[Row], measures: Measures) -> String {
    let (unit, factor) = match measures {
        Measures::Straight => ("m/s", 1.0),
        Measures::Translating | Measures::Oscillating => ("rpm", 30.0 / PI),
    };
    let names = ["error", "torque", "ripple", "factors"];
    let names = names.map(|name| words::text(&format!("simulate-speeds-{name}")));
    let head = [vec![unit.to_string()], names.to_vec(), vec![String::new()]].concat();
    let rows = rows
        .iter()
        .map(|row| row.cells(words::number(factor * row.at.speed)));
    let all: Vec<_> = std::iter::once(head).chain(rows).collect();
    table(&all, &[Right, Right, Right, Right, Left])
}

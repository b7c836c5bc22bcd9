//! `gaitcam simulate --speed-programme`: simulates the cam as designed with a speed that varies over time.

use std::path::Path;

use serde_json::{Value, json};

use super::{dampings, ends, largest, list};
use crate::console::error::CliError;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::terminal::{print, print_json, report};
use crate::console::words::{self, number};
use crate::input::made::CamInMachine;
use crate::synth::files_in;
use gaitcam::LimitKind;
use gaitcam::drive::Drive;
use gaitcam::dynamics::{Misfit, ProgrammeRun, SpeedProgramme};
use gaitcam::error::{Placed, Result};
use gaitcam::scene::Limits;
use gaitcam_app::read::read_text;
use gaitcam_app::{PATIENCE, ResultFolder, inputs};
use gaitcam_output::csv;

/// Columns of a speed programme that was read from a file.
struct Rows {
    programme: SpeedProgramme,
    start: f64,
    walk_n: Option<Vec<f64>>,
}

/// Simulates a cam with the speed programme in the file `path` and writes `programme.csv`. The exit code is 3 if contact is lost or a
/// limit is violated.
pub fn run(made: &CamInMachine, path: &Path, folder: &Path, as_json: bool) -> Result<u8> {
    inputs::note(path);
    let rows = read(path)?;
    let folder = ResultFolder::open(folder, PATIENCE)?;
    inputs::check_in(folder.path(), ["programme.csv"])?;
    let design = made.design()?.0.built()?;
    if let Some(why) = design.no_cam(language::current()) {
        report(words::fill("simulate-no-cam", &json!({"why": why})));
        return Ok(NO_SUCH_CAM);
    }
    let emitted = design.emitted(&made.running.machine, design.problem.drive)?;
    let run = ProgrammeRun::new(&emitted, &rows.programme, rows.start)?;
    let steps = design.problem.steps_per_turn.unwrap_or(2);
    let turns = (run.angle[run.angle.len() - 1] - rows.start) / std::f64::consts::TAU;
    let strides = (0.5 * turns * steps as f64).round() as usize;
    let misfits = match &rows.walk_n {
        Some(recorded) if strides > 0 => Some(run.misfits(recorded, strides)),
        _ => None,
    };
    let broken = broken(&run, &made.running.limits, &design.problem.drive);
    let columns = vec![
        ("time_s", run.time_s.clone()),
        ("theta_rad", run.angle.clone()),
        ("speed_rad_per_s", run.speed.clone()),
        ("acceleration_rad_per_s2", run.acceleration.clone()),
        ("follower_velocity_m_per_s", run.follower_velocity.clone()),
        (
            "follower_acceleration_m_per_s2",
            run.follower_acceleration.clone(),
        ),
        ("contact_force_n", run.force_n.clone()),
        ("torque_n_m", run.torque.clone()),
    ];
    folder.write("programme.csv", csv::text(&columns).as_bytes())?;
    let place = folder.path().to_path_buf();
    folder.commit(&[])?;
    let error = rows.walk_n.as_ref().map(|recorded| run.rms_error(recorded));
    let passes = broken.is_empty() && !run.contact_lost;
    if as_json {
        print_json(&data(&run, error, misfits.as_ref(), &broken));
    } else {
        let all = lines(&design.problem.name, &run, error, misfits.as_ref(), &broken);
        all.iter().for_each(|line| print(line));
        print(&files_in(&place, "programme.csv"));
    }
    Ok(if passes { BUILT } else { NO_SUCH_CAM })
}

/// Limits of motion, force, torque and power that are violated, each with the worst value and the bound.
fn broken(run: &ProgrammeRun, limits: &Limits, drive: &Drive) -> Vec<(LimitKind, f64, f64)> {
    let [least, most] = ends(&run.force_n);
    let power = run.torque.iter().zip(&run.speed);
    let power: Vec<f64> = power.map(|(torque, speed)| torque * speed).collect();
    let newtons = |kind: LimitKind| limits[kind].map(|bound| drive.newtons(bound));
    let plain = |kind: LimitKind, of: &[f64]| (kind, largest(of), 1.0, limits[kind]);
    let all = [
        (
            LimitKind::ForceMin,
            least,
            -1.0,
            newtons(LimitKind::ForceMin),
        ),
        (LimitKind::ForceMax, most, 1.0, newtons(LimitKind::ForceMax)),
        plain(LimitKind::Velocity, &run.follower_velocity),
        plain(LimitKind::Acceleration, &run.follower_acceleration),
        plain(LimitKind::Torque, &run.torque),
        plain(LimitKind::Power, &power),
    ];
    let over = all.into_iter().filter_map(|(kind, worst, sign, bound)| {
        let bound = bound.filter(|bound| sign * worst > sign * bound)?;
        Some((kind, worst, bound))
    });
    over.collect()
}

/// Reads a speed programme with the columns `time_s` and `speed_rad_per_s`. The columns `angle_rad` and `walk_n` are optional.
fn read(path: &Path) -> Result<Rows> {
    let text = read_text(path)?;
    let mut lines = text
        .lines()
        .filter(|l| !l.trim().is_empty() && !l.starts_with('#'));
    let names: Vec<&str> = lines
        .next()
        .unwrap_or("")
        .split(',')
        .map(str::trim)
        .collect();
    let place = |name: &str| names.iter().position(|n| *n == name);
    let missing = |column: &str| {
        let column = column.to_string();
        CliError::ProgrammeColumn { column }.in_file(path)
    };
    let needed = |name: &str| place(name).ok_or_else(|| missing(name));
    let (time, speed) = (needed("time_s")?, needed("speed_rad_per_s")?);
    let rows: Vec<Vec<&str>> = lines
        .map(|l| l.split(',').map(str::trim).collect())
        .collect();
    let column = |at: usize| -> Result<Vec<f64>> {
        let number = |(i, row): (usize, &Vec<&str>)| {
            let cell = row.get(at).copied().unwrap_or("");
            let fault = || {
                let (row, cell) = (i as u64 + 1, cell.to_string());
                CliError::RowNotNumber { row, cell }.in_file(path)
            };
            cell.parse::<f64>().map_err(|_| fault())
        };
        rows.iter().enumerate().map(number).collect()
    };
    let start = match place("angle_rad") {
        Some(at) => column(at)?.first().copied().unwrap_or(0.0),
        None => 0.0,
    };
    let programme = SpeedProgramme::new(column(time)?, column(speed)?);
    Ok(Rows {
        programme: programme.map_err(|e| e.in_file(path))?,
        start,
        walk_n: place("walk_n").map(column).transpose()?,
    })
}

fn data(
    run: &ProgrammeRun,
    error: Option<f64>,
    misfits: Option<&[Misfit; 3]>,
    broken: &[(LimitKind, f64, f64)],
) -> Value {
    let ([low, high], [least, most]) = (ends(&run.speed), ends(&run.force_n));
    let broken: Vec<Value> = broken
        .iter()
        .map(|(kind, worst, limit)| json!({"limit": kind.name(), "worst": worst, "bound": limit}))
        .collect();
    json!({
        "model": "rigid", "contact_lost": run.contact_lost,
        "duration_s": run.time_s[run.time_s.len() - 1] - run.time_s[0],
        "force": {"min": least, "max": most, "rms_error_n": error},
        "speed": {"min_rad_per_s": low, "max_rad_per_s": high, "acceleration_max_rad_per_s2": largest(&run.acceleration)},
        "torque_max_n_m": largest(&run.torque),
        "misfit": misfits, "broken": broken,
    })
}

fn lines(
    name: &str,
    run: &ProgrammeRun,
    error: Option<f64>,
    misfits: Option<&[Misfit; 3]>,
    broken: &[(LimitKind, f64, f64)],
) -> Vec<String> {
    let ([low, high], [least, most]) = (ends(&run.speed), ends(&run.force_n));
    let verdict = match (run.contact_lost, broken.is_empty()) {
        (true, _) => words::text("programme-lost"),
        (false, true) => words::text("programme-kept"),
        (false, false) => words::text("programme-broken"),
    };
    let mut out = vec![
        format!("{name}: {verdict}"),
        words::fill(
            "walk-motion",
            &json!({"low": number(low), "high": number(high), "acceleration": number(largest(&run.acceleration)),
                "torque": number(largest(&run.torque))}),
        ),
    ];
    out.push(match error {
        Some(error) => words::fill(
            "walk-force",
            &json!({"low": number(least), "high": number(most), "error": number(error)}),
        ),
        None => words::fill(
            "programme-force",
            &json!({"low": number(least), "high": number(most)}),
        ),
    });
    if let Some(misfits) = misfits {
        out.push(words::fill(
            "walk-misfit",
            &json!({"dampings": dampings(misfits), "misfit": list(misfits, |m| m.misfit), "peak": list(misfits, |m| m.peak_ratio)}),
        ));
    }
    for (kind, worst, bound) in broken {
        let (limit, worst, bound) = (words::name(kind.name()), number(*worst), number(*bound));
        out.push(words::fill(
            "programme-limit",
            &json!({"limit": limit, "worst": worst, "bound": bound}),
        ));
    }
    out
}

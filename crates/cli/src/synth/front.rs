//! `gaitcam synth --front`: what one good costs in another, as a table and a picture.

use serde_json::json;

use super::SynthArgs;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::terminal::{print, print_json, report};
use crate::console::words::{self, fixed};
use crate::input;
use gaitcam::error::Result;
use gaitcam::synth::{Against, Trade, trade};
use gaitcam_output::folder::Folder;
use gaitcam_output::sweep_plots::{self, Quantity};

/// Points of the front when nothing is said.
const POINTS: u32 = 20;
/// Columns of front.csv beside the quantity traded.
const COLUMNS: [&str; 13] = [
    "rms_error_n",
    "rms_error_percent_of_mean",
    "max_error_n",
    "prime_radius_m",
    "stroke_m",
    "torque_max_n_m",
    "torque_rms_n_m",
    "power_max_w",
    "power_mean_w",
    "liftoff_speed_rad_per_s",
    "hertz_pressure_max_pa",
    "tier",
    "verdict",
];

/// Computes the front and writes front.csv, front.svg and front.png; exit code 3 when it is empty.
pub fn run(args: &SynthArgs, pair: &str) -> Result<u8> {
    let against = Against::from_pair(pair).map_err(input::at_flag("--front"))?;
    let input = input::scene(&args.scene)?;
    let folder = Folder::open(&input::result_folder(
        &input,
        args.out.as_deref(),
        "-front",
    )?)?;
    let target = input.target()?;
    let points = args.points.unwrap_or(POINTS) as usize;
    let front = trade(&input.scene, target.as_ref(), against, points)?;
    if front.is_empty() {
        report(words::text("trade-none"));
        return Ok(NO_SUCH_CAM);
    }
    folder.write("front.csv", csv(against, &front).as_bytes())?;
    let column = |name: &str, of: &dyn Fn(&Trade) -> f64| Quantity {
        label: words::column(name),
        values: front.iter().map(of).collect(),
        words: Vec::new(),
    };
    let (unit, factor) = shown_in(against);
    let x = Quantity {
        label: format!("{}, {unit}", quantity_name(against)),
        ..column(against.column(), &|t| factor * against.of(&t.design))
    };
    let y = column("force_rms_error_n", &|t| t.design.force.rms_error_n);
    let line: Vec<(f64, f64)> = x
        .values
        .iter()
        .copied()
        .zip(y.values.iter().copied())
        .collect();
    let title = title(&input.scene.name, against);
    let picture = sweep_plots::front(&title, &x, &y, &line, None)
        .in_language(crate::console::language::current());
    folder.write("front.svg", picture.svg().as_bytes())?;
    folder.write("front.png", &picture.png())?;
    if args.json {
        let rows: Vec<_> = front
            .iter()
            .map(|t| {
                json!({against.column(): against.of(&t.design), "allowed": t.allowed,
                    "rms_error_n": t.design.force.rms_error_n,
                    "max_error_n": t.design.force.max_error_n,
                    "tier": t.design.solver.tier.name(), "verdict": t.design.verdict.name()})
            })
            .collect();
        print_json(&rows.into());
    } else {
        print(&table(&input.scene.name, against, &front));
        print(&super::files_in(folder.path(), "front.png"));
    }
    Ok(BUILT)
}

fn quantity_name(against: Against) -> String {
    let name = Against::NAMES
        .iter()
        .find(|n| n.1 == against)
        .map_or("", |n| n.0);
    words::text(&format!("trade-{}", name.replace('_', "-")))
}

fn title(name: &str, against: Against) -> String {
    let said = json!({"name": name, "quantity": quantity_name(against)});
    words::fill("trade-title", &said)
}

/// The unit in which people read it, and SI's factor to it.
fn shown_in(against: Against) -> (&'static str, f64) {
    match against {
        Against::PrimeRadius | Against::Stroke => ("mm", 1e3),
        Against::Velocity => ("m/s", 1.0),
        Against::Acceleration => ("m/s²", 1.0),
        Against::Jerk => ("m/s³", 1.0),
        Against::Torque => ("N·m", 1.0),
        Against::Power => ("W", 1.0),
        Against::HertzPressure => ("MPa", 1e-6),
        Against::LiftoffSpeed => ("rad/s", 1.0),
    }
}

fn csv(against: Against, front: &[Trade]) -> String {
    let mut out = format!("allowed_{},{}", against.column(), against.column());
    for name in COLUMNS.iter().filter(|n| **n != against.column()) {
        out.push(',');
        out.push_str(name);
    }
    out.push('\n');
    for t in front {
        let (d, f) = (&t.design, &t.design.force);
        let m = d.machine();
        let known = |x: Option<f64>| x.map_or_else(String::new, |x| x.to_string());
        let cells = [
            f.rms_error_n.to_string(),
            f.rms_error_percent_of_mean.to_string(),
            f.max_error_n.to_string(),
            d.cam.follower.prime_radius().to_string(),
            d.cam.law.stroke().to_string(),
            known(m.torque_max_n_m),
            known(m.torque_rms_n_m),
            known(m.power_max_w),
            known(m.power_mean_w),
            known(m.liftoff_speed_rad_per_s),
            known(m.hertz_pressure_max_pa),
            d.solver.tier.name().to_string(),
            d.verdict.name().to_string(),
        ];
        out.push_str(&format!("{},{}", t.allowed, against.of(d)));
        for (name, cell) in COLUMNS.iter().zip(cells) {
            if *name != against.column() {
                out.push(',');
                out.push_str(&cell);
            }
        }
        out.push('\n');
    }
    out
}

fn table(name: &str, against: Against, front: &[Trade]) -> String {
    let (unit, factor) = shown_in(against);
    let mut out = vec![
        title(name, against),
        format!(
            "  {:>16} {unit:<5} {:>14} {:>12}",
            quantity_name(against),
            words::text("trade-rms"),
            words::text("trade-percent")
        ),
    ];
    for t in front {
        let f = &t.design.force;
        out.push(format!(
            "  {:>16} {:<5} {:>14} {:>12}",
            fixed(factor * against.of(&t.design), 4),
            "",
            fixed(f.rms_error_n, 4),
            fixed(f.rms_error_percent_of_mean, 4)
        ));
    }
    out.join("\n")
}

//! The table of several results: one column each, every cell with its unit.

use serde_json::Value;

use super::read::Design;
use crate::console::words;
use gaitcam::synth;
use gaitcam::wording::people;

/// Cell of a result that has no such number.
const NONE: &str = "—";

/// Content of a row.
enum Cell {
    /// A figure of [`FIGURES`](gaitcam::synth::FIGURES) by its column, with so many decimals.
    Figure(&'static str, usize),
    /// Anything else.
    Other(fn(&Design) -> String),
}

use Cell::{Figure, Other};

const ROWS: [(&str, Cell); 24] = [
    ("compare-verdict", Other(|d| word(&d.summary["verdict"]))),
    ("compare-outcome", Other(|d| outcome(&d.summary["outcome"]))),
    ("compare-law", Other(|d| word(&d.summary["law"]["family"]))),
    (
        "compare-follower",
        Other(|d| word(&d.summary["cam"]["follower"])),
    ),
    ("compare-rms", Figure("force_rms_error_n", 4)),
    ("compare-percent", Figure("force_rms_error_percent", 3)),
    ("compare-largest", Figure("force_max_error_n", 3)),
    ("compare-force-min", Figure("force_min_n", 2)),
    ("compare-force-max", Figure("force_max_n", 2)),
    ("compare-mass", Other(mass)),
    ("compare-speed", Other(speed)),
    ("compare-stroke", Other(|d| lift(d, &["stroke_m"], 0))),
    (
        "compare-a",
        Other(|d| lift(d, &["a_max_m_per_rad2", "a_min_m_per_rad2"], 2)),
    ),
    (
        "compare-j",
        Other(|d| lift(d, &["j_max_m_per_rad3", "j_min_m_per_rad3"], 3)),
    ),
    ("compare-base-radius", Figure("base_radius_m", 3)),
    ("compare-convex", Figure("rho_min_m", 3)),
    ("compare-pressure-angle", Other(pressure_angle)),
    ("compare-face-width", Figure("face_width_m", 3)),
    ("compare-torque-max", Figure("torque_max_n_m", 4)),
    ("compare-torque-rms", Figure("torque_rms_n_m", 4)),
    ("compare-power-max", Figure("power_max_w", 3)),
    ("compare-power-mean", Figure("power_mean_w", 3)),
    ("compare-lift-off", Figure("liftoff_speed_rad_per_s", 4)),
    ("compare-hertz", Figure("hertz_pressure_max_pa", 1)),
];

/// Headings with one cell per design.
pub fn rows(designs: &[Design]) -> Vec<(String, Vec<String>)> {
    let cell = |cell: &Cell, d: &Design| match cell {
        Figure(column, decimals) => figure(d, column, *decimals),
        Other(make) => make(d),
    };
    let cells = |own: &Cell| designs.iter().map(|d| cell(own, d)).collect();
    let rows = ROWS.iter();
    rows.map(|(heading, own)| (words::text(heading), cells(own)))
        .collect()
}

/// A figure as summary.json has it; that of a force only where one was to be met.
fn figure(d: &Design, column: &str, decimals: usize) -> String {
    let Some(figure) = synth::Figure::of_column(column) else {
        return NONE.to_string();
    };
    let (unit, factor) = people(figure.unit);
    let value = number(&d.summary[figure.section][figure.key]);
    let value = value.filter(|_| figure.section != "force" || d.has_target());
    shown(value.map(|x| factor * x), decimals, unit)
}

fn word(value: &Value) -> String {
    value.as_str().map_or_else(|| NONE.to_string(), words::name)
}

fn outcome(value: &Value) -> String {
    match value.as_str() {
        Some("built") => words::text("compare-built"),
        Some("infeasible") => words::text("compare-infeasible"),
        _ => word(value),
    }
}

fn shown(value: Option<f64>, decimals: usize, unit: &str) -> String {
    match value {
        None => NONE.to_string(),
        Some(x) if x.is_infinite() => "∞".to_string(),
        Some(x) => format!("{} {unit}", words::fixed(x, decimals)),
    }
}

/// A number of summary.json; `"inf"` is infinite.
fn number(value: &Value) -> Option<f64> {
    match value.as_str() {
        Some("inf") => Some(f64::INFINITY),
        Some("-inf") => Some(f64::NEG_INFINITY),
        _ => value.as_f64(),
    }
}

fn mass(d: &Design) -> String {
    let value = number(&d.summary["drive"]["mass_kg"]).filter(|m| *m != 0.0);
    shown(value, 3, if d.swings() { "kg·m²" } else { "kg" })
}

fn speed(d: &Design) -> String {
    let unit = if d.slides() { "m/s" } else { "rad/s" };
    shown(number(&d.summary["drive"]["speed_rad_per_s"]), 4, unit)
}

/// The largest magnitude of a derivative of the lift by the cam's motion, in the units of the follower.
fn lift(d: &Design, keys: &[&str], order: i32) -> String {
    let values = keys
        .iter()
        .filter_map(|key| number(&d.summary["law"][*key]));
    let largest = values.map(f64::abs).reduce(f64::max);
    let (factor, lift, per) = match (d.swings(), d.slides()) {
        (true, false) => (1f64.to_degrees(), "°", "rad"),
        (false, false) => (1e3, "mm", "rad"),
        (false, true) => (1e3 * 1e-3_f64.powi(order), "mm", "mm"),
        (true, true) => (1f64.to_degrees() * 1e-3_f64.powi(order), "°", "mm"),
    };
    let unit = match order {
        0 => lift.to_string(),
        2 => format!("{lift}/{per}²"),
        _ => format!("{lift}/{per}³"),
    };
    shown(largest.map(|x| factor * x), 3, &unit)
}

fn pressure_angle(d: &Design) -> String {
    let keys = ["pressure_angle_max_rad", "pressure_angle_min_rad"];
    let angles = keys
        .iter()
        .filter_map(|key| number(&d.summary["cam"][*key]));
    let largest = angles.map(f64::abs).reduce(f64::max);
    shown(largest.map(f64::to_degrees), 2, "°")
}

/// As Markdown, for compare.md.
pub fn markdown(designs: &[Design]) -> String {
    let names: Vec<&str> = designs.iter().map(|d| d.name.as_str()).collect();
    let mut out = format!("| | {} |\n", names.join(" | "));
    out.push_str(&format!("|---{}|\n", "|---".repeat(names.len())));
    for (heading, cells) in rows(designs) {
        out.push_str(&format!("| {heading} | {} |\n", cells.join(" | ")));
    }
    out
}

/// In columns, for the console.
pub fn text(designs: &[Design]) -> String {
    let mut lines = vec![(
        String::new(),
        designs.iter().map(|d| d.name.clone()).collect(),
    )];
    lines.extend(rows(designs));
    let width = |text: &str| text.chars().count();
    let heading = lines.iter().map(|l| width(&l.0)).max().unwrap_or(0);
    let columns: Vec<usize> = (0..designs.len())
        .map(|k| lines.iter().map(|l| width(&l.1[k])).max().unwrap_or(0))
        .collect();
    let line = |(name, cells): &(String, Vec<String>)| {
        let cells = cells
            .iter()
            .zip(&columns)
            .map(|(c, w)| format!("  {c:>w$}"));
        format!("{name:<heading$}{}", cells.collect::<String>())
    };
    lines.iter().map(line).collect::<Vec<_>>().join("\n")
}

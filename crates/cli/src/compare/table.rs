//! The table of several results: one column each, every cell with its unit.

use serde_json::Value;

use super::read::Design;
use crate::console::words;

/// What stands where a result has no such number.
const NONE: &str = "—";

/// Headings with one cell per design.
pub fn rows(designs: &[Design]) -> Vec<(String, Vec<String>)> {
    type Cell = fn(&Design) -> String;
    let cells: [(&'static str, Cell); 24] = [
        ("compare-verdict", |d| word(&d.summary["verdict"])),
        ("compare-outcome", |d| outcome(&d.summary["outcome"])),
        ("compare-law", |d| word(&d.summary["law"]["family"])),
        ("compare-follower", |d| word(&d.summary["cam"]["follower"])),
        ("compare-rms", |d| force(d, "rms_error_n", 4, "N")),
        ("compare-percent", |d| {
            force(d, "rms_error_percent_of_mean", 3, "%")
        }),
        ("compare-largest", |d| force(d, "max_error_n", 3, "N")),
        ("compare-force-min", |d| force(d, "min_n", 2, "N")),
        ("compare-force-max", |d| force(d, "max_n", 2, "N")),
        ("compare-mass", mass),
        ("compare-speed", speed),
        ("compare-stroke", |d| lift(d, &["stroke_m"], 0)),
        ("compare-a", |d| {
            lift(d, &["a_max_m_per_rad2", "a_min_m_per_rad2"], 2)
        }),
        ("compare-j", |d| {
            lift(d, &["j_max_m_per_rad3", "j_min_m_per_rad3"], 3)
        }),
        ("compare-base-radius", |d| millimetres(d, "base_radius_m")),
        ("compare-convex", |d| millimetres(d, "rho_min_m")),
        ("compare-pressure-angle", pressure_angle),
        ("compare-face-width", |d| millimetres(d, "face_width_m")),
        ("compare-torque-max", |d| {
            machine(d, "torque_max_n_m", 1.0, 4, "N·m")
        }),
        ("compare-torque-rms", |d| {
            machine(d, "torque_rms_n_m", 1.0, 4, "N·m")
        }),
        ("compare-power-max", |d| {
            machine(d, "power_max_w", 1.0, 3, "W")
        }),
        ("compare-power-mean", |d| {
            machine(d, "power_mean_w", 1.0, 3, "W")
        }),
        ("compare-lift-off", |d| {
            machine(d, "liftoff_speed_rad_per_s", 1.0, 4, "rad/s")
        }),
        ("compare-hertz", |d| {
            machine(d, "hertz_pressure_max_pa", 1e-6, 1, "MPa")
        }),
    ];
    cells
        .iter()
        .map(|(heading, cell)| (words::text(heading), designs.iter().map(cell).collect()))
        .collect()
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

fn force(d: &Design, key: &str, decimals: usize, unit: &str) -> String {
    let value = number(&d.summary["force"][key]).filter(|_| d.has_target());
    shown(value, decimals, unit)
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

/// What the design asks of the machine.
fn machine(d: &Design, key: &str, factor: f64, decimals: usize, unit: &str) -> String {
    let value = number(&d.summary["machine"][key]).map(|x| factor * x);
    shown(value, decimals, unit)
}

fn millimetres(d: &Design, key: &str) -> String {
    shown(number(&d.summary["cam"][key]).map(|x| 1e3 * x), 3, "mm")
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

//! Comparison of several results in a table with one column per result. Every cell includes its unit.

use serde_json::Value;

use super::read::Design;
use crate::console::table::{Side, table as in_columns};
use crate::console::{language, words};
use gaitcam::synth::{FIGURES, Figure};
use gaitcam_output::sweep_report::Table;

/// Content of a cell without a value.
const NONE: &str = "—";

/// Fraction of the maximum force below which a force counts as zero.
const ROUNDING: f64 = 1e-9;

/// Function that returns the text of a cell for a design.
type Cell = fn(&Design) -> String;

/// Table rows with words instead of numbers. Each entry contains the key of the heading and the function that returns the text of a cell.
const WORDS: [(&str, Cell); 4] = [
    ("compare-verdict", |d| word(&d.summary["verdict"])),
    ("compare-outcome", |d| outcome(&d.summary["outcome"])),
    ("compare-law", |d| word(&d.summary["law"]["family"])),
    ("compare-follower", |d| word(&d.summary["cam"]["follower"])),
];

/// Quantities whose maximum and minimum are in summary.json. Each entry contains the column, the section of summary.json, the two keys of
/// the extremes, and the order of the derivative. The extremes are derivatives with respect to the cam angle. They are converted to time
/// derivatives with the speed of the cam.
const EXTREMES: [(&str, &str, [&str; 2], i32); 4] = [
    (
        "velocity_max_m_per_s",
        "law",
        ["v_max_m_per_rad", "v_min_m_per_rad"],
        1,
    ),
    (
        "acceleration_max_m_per_s2",
        "law",
        ["a_max_m_per_rad2", "a_min_m_per_rad2"],
        2,
    ),
    (
        "jerk_max_m_per_s3",
        "law",
        ["j_max_m_per_rad3", "j_min_m_per_rad3"],
        3,
    ),
    (
        "pressure_angle_max_rad",
        "cam",
        ["pressure_angle_max_rad", "pressure_angle_min_rad"],
        0,
    ),
];

/// Rows of the table as (heading, one cell per design). A row is omitted if no design has the quantity.
pub fn rows(designs: &[Design]) -> Vec<(String, Vec<String>)> {
    let language = language::current();
    let words = WORDS.iter().map(|(heading, cell)| {
        let cells = designs.iter().map(cell).collect();
        (words::text(heading), cells)
    });
    let figures = FIGURES.iter().map(|figure| {
        let cell = |d: &Design| match value(figure, d) {
            Some(x) => figure.text(x, d.measures(), language),
            None => NONE.to_string(),
        };
        (figure.label(language), designs.iter().map(cell).collect())
    });
    let is_known = |row: &(String, Vec<String>)| row.1.iter().any(|cell| cell != NONE);
    words.chain(figures).filter(is_known).collect()
}

/// Value of a quantity in summary.json; `None` if it is undefined. Force quantities are undefined without a target force. A mass of zero is
/// undefined.
fn value(figure: &Figure, d: &Design) -> Option<f64> {
    if let Some((_, section, keys, order)) = EXTREMES.iter().find(|row| row.0 == figure.column) {
        let ends = keys
            .iter()
            .filter_map(|key| number(&d.summary[*section][*key]));
        let speed = number(&d.summary["drive"]["speed_rad_per_s"])?;
        return Some(ends.map(f64::abs).reduce(f64::max)? * speed.powi(*order));
    }
    let value = number(&d.summary[figure.section][figure.key])?;
    // A minimum force of zero contains a rounding error that is proportional to the maximum force.
    let most = number(&d.summary["force"]["max_n"]).unwrap_or(0.0);
    let value = match figure.section {
        "force" if value.abs() < ROUNDING * most => 0.0,
        _ => value,
    };
    let exists = match figure.section {
        "force" => d.has_target(),
        _ => figure.column != "mass_kg" || value != 0.0,
    };
    exists.then_some(value)
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

/// Converts a value of summary.json to a number. The strings `"inf"` and `"-inf"` become infinite.
fn number(value: &Value) -> Option<f64> {
    match value.as_str() {
        Some("inf") => Some(f64::INFINITY),
        Some("-inf") => Some(f64::NEG_INFINITY),
        _ => value.as_f64(),
    }
}

/// Table with one column per design.
pub fn table(designs: &[Design]) -> Table {
    let names = designs.iter().map(|d| d.name.clone());
    let row = |(heading, cells): (String, Vec<String>)| [vec![heading], cells].concat();
    Table {
        head: std::iter::once(String::new()).chain(names).collect(),
        rows: rows(designs).into_iter().map(row).collect(),
    }
}

/// Table as Markdown, for compare.md.
pub fn markdown(designs: &[Design]) -> String {
    let Table { head, rows } = table(designs);
    let mut out = format!("| {} |\n{}|\n", head.join(" | "), "|---".repeat(head.len()));
    for cells in rows {
        out.push_str(&format!("| {} |\n", cells.join(" | ")));
    }
    out
}

/// Table with aligned columns, for the console.
pub fn text(designs: &[Design]) -> String {
    let Table { head, rows } = table(designs);
    let lines: Vec<Vec<String>> = std::iter::once(head).chain(rows).collect();
    in_columns(&lines, &[Side::Left, Side::Right])
}

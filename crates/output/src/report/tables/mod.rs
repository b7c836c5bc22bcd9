//! Tables of the report: checks, active limits, numbers of the design, solution.

mod design;
mod solution;

pub use design::numbers;
pub use solution::solution;

use std::fmt::Write;

use super::heading;
use crate::words::Words;
use gaitcam::cam::{Check, Measures};
use gaitcam::criterion::Criterion;
use gaitcam::synth::{Design, unit};
use gaitcam_base::text::escaped;

/// Distance from a limit, as a fraction of the limit, up to which a satisfied limit counts as reached.
const ON_THE_LIMIT: f64 = 0.005;

/// Formats a value as text in the customary unit of its criterion. For an unknown criterion, the text is the SI value without a unit.
pub fn shown(measures: Measures, limit: Criterion, value: f64, words: &Words) -> String {
    let unit = unit(measures, limit);
    let value = unit.factor * value;
    // Rounding errors are shown as zero.
    let value = if value.abs() < 1e-9 { 0.0 } else { value };
    unit.after(&words.number(value))
}

/// Distance of the worst value from its limit, as a fraction of the limit. The distance is negative if the limit is violated, and
/// infinite if the limit is zero and not reached.
fn margin(check: &Check) -> f64 {
    let gap = (check.worst - check.limit).abs();
    let share = if check.limit == 0.0 {
        if gap == 0.0 { 0.0 } else { f64::INFINITY }
    } else {
        gap / check.limit.abs()
    };
    if check.pass { share } else { -share }
}

/// State of a check: `violated`, `at-limit` or `satisfied`.
pub fn state(check: &Check) -> &'static str {
    if !check.pass {
        "violated"
    } else if margin(check) <= ON_THE_LIMIT {
        "at-limit"
    } else {
        "satisfied"
    }
}

/// Limit, and position of the worst value, in SI units. The limit is `None` if it is only a rounding tolerance. The position is `None` if
/// the value applies to the whole cycle.
pub fn limit_and_place(check: &Check) -> (Option<f64>, Option<f64>) {
    let is_rounding = matches!(
        check.name,
        Criterion::Interference | Criterion::SecondInterference
    );
    let is_of_cycle = check.name == Criterion::RmsError;
    (
        (!is_rounding).then_some(check.limit),
        (!is_of_cycle).then_some(check.at),
    )
}

/// Opens an HTML table and writes the names of its columns. Columns with an index of at least `numbers` are aligned to the right.
pub fn open(out: &mut String, columns: &[String], numbers: usize) {
    out.push_str("<div class=\"scroll\" tabindex=\"0\"><table>\n<thead><tr>");
    for (i, name) in columns.iter().enumerate() {
        let class = if i < numbers { "" } else { " class=\"n\"" };
        let _ = write!(out, "<th scope=\"col\"{class}>{}</th>", escaped(name));
    }
    out.push_str("</tr></thead>\n<tbody>\n");
}

pub fn close(out: &mut String) {
    out.push_str("</tbody></table></div>\n");
}

/// Opens a row of an HTML table and writes the name of the row into its first cell.
pub fn row(out: &mut String, name: &str) {
    let _ = write!(out, "<tr><th scope=\"row\">{}</th>", escaped(name));
}

/// Writes `values` as the remaining cells of a table row and closes the row.
pub fn cells(out: &mut String, values: &[impl AsRef<str>]) {
    for value in values {
        let _ = write!(out, "<td class=\"n\">{}</td>", escaped(value.as_ref()));
    }
    out.push_str("</tr>\n");
}

/// Writes the table of all checks with coloured states.
pub fn checks(out: &mut String, synthesis: &Design, words: &Words) {
    if synthesis.checks.is_empty() {
        return;
    }
    let measures = synthesis.cam.follower.measures();
    heading(out, &words.text("report-checks"));
    let columns = [
        "report-check",
        "report-state",
        "report-worst",
        "report-limit",
        "report-margin",
        "report-place",
    ];
    open(out, &columns.map(|key| words.text(key)), 2);
    for check in &synthesis.checks {
        let margin = margin(check);
        let (light, state) = match state(check) {
            "violated" => ("bad", "report-violated"),
            "at-limit" => ("fair", "report-at-limit"),
            _ => ("good", "report-satisfied"),
        };
        let margin = if margin.is_finite() {
            let sign = if margin < 0.0 { "−" } else { "+" };
            format!("{sign}{} %", words.fixed(100.0 * margin.abs(), 1))
        } else {
            "—".into()
        };
        row(out, &words.name(check.name.name()));
        let _ = write!(
            out,
            "<td class=\"state\"><span class=\"{light}\"><span class=\"dot\"></span>{}</span></td>",
            escaped(&words.text(state))
        );
        let worst = shown(measures, check.name, check.worst, words);
        let none = || "—".to_string();
        let (limit, at) = limit_and_place(check);
        let limit = limit.map_or_else(none, |x| shown(measures, check.name, x, words));
        let place = at.map_or_else(none, |at| measures.place(at, words.language()));
        cells(out, &[worst, limit, margin, place]);
    }
    close(out);
}

/// An active limit: criterion, multiplier with the maximum absolute value, position of this multiplier, and number of active points.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs)] // the names are the documentation
pub struct ActiveLimit {
    pub limit: Criterion,
    pub multiplier: f64,
    pub at: f64,
    pub points: usize,
}

impl ActiveLimit {
    /// The active limits of a design. Each limit is listed once.
    pub fn all(design: &Design) -> Vec<ActiveLimit> {
        let mut all: Vec<ActiveLimit> = Vec::new();
        for b in &design.binding {
            let Some(known) = all.iter_mut().find(|a| a.limit == b.limit) else {
                all.push(ActiveLimit {
                    limit: b.limit,
                    multiplier: b.multiplier,
                    at: b.at,
                    points: 1,
                });
                continue;
            };
            known.points += 1;
            if b.multiplier.abs() > known.multiplier.abs() {
                (known.multiplier, known.at) = (b.multiplier, b.at);
            }
        }
        all
    }
}

/// Writes the table of the active limits, which determine the law.
pub fn active(out: &mut String, synthesis: &Design, words: &Words) {
    heading(out, &words.text("report-active-limits"));
    if synthesis.binding.is_empty() {
        super::paragraph(out, &words.text("report-no-active-limits"));
        return;
    }
    let columns = [
        "report-limit",
        "report-times",
        "report-multiplier",
        "report-place",
    ];
    open(out, &columns.map(|key| words.text(key)), 1);
    let measures = synthesis.cam.follower.measures();
    for a in ActiveLimit::all(synthesis) {
        row(out, &words.name(a.limit.name()));
        let (points, place) = (a.points.to_string(), measures.place(a.at, words.language()));
        cells(out, &[points, words.number(a.multiplier), place]);
    }
    close(out);
    note(out, &words.text("report-multiplier-note"));
    easing(out, synthesis, words);
}

fn note(out: &mut String, text: &str) {
    let _ = writeln!(out, "<p class=\"note\">{}</p>", escaped(text));
}

/// Writes, for each active limit, the predicted value of the objective after this limit is relaxed by one percent.
fn easing(out: &mut String, synthesis: &Design, words: &Words) {
    if synthesis.easing.is_empty() {
        return;
    }
    let head = escaped(&words.text("report-sensitivity"));
    let _ = writeln!(out, "<h3>{head}</h3>");
    let columns = [
        "report-limit",
        "report-from",
        "report-to",
        "report-objective",
        "report-now",
        "report-predicted",
    ];
    open(out, &columns.map(|key| words.text(key)), 1);
    let measures = synthesis.cam.follower.measures();
    for e in &synthesis.easing {
        let (name, unit, factor) = e.in_words(measures, words.language());
        row(out, &words.name(e.limit.name()));
        let [from, to] = [e.from, e.to].map(|x| shown(measures, e.limit, x, words));
        let [before, after] =
            [e.before, e.after].map(|x| format!("{} {unit}", words.number(factor * x)));
        cells(out, &[from, to, name, before, after]);
    }
    close(out);
}

/// Rows of a table with two columns: name and value.
pub(super) type Rows = Vec<(String, String)>;

/// Writes a table with the columns name and value below its heading.
pub(super) fn table(out: &mut String, words: &Words, name: &str, rows: &Rows) {
    let name = escaped(&words.text(name));
    let _ = write!(out, "<div><h3>{name}</h3><table>");
    for (name, value) in rows {
        row(out, name);
        let _ = write!(out, "<td>{}</td></tr>", escaped(value));
    }
    out.push_str("</table></div>\n");
}

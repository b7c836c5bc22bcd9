//! Table of several recordings, with one line each, and their joint mean.

use serde_json::{Value, json};

use super::table::Lines;
use gaitcam::error::Error;
use gaitcam::force::{ForceCurve, Interpretation, JointMean, LeftOut, coded};
use gaitcam::wording::{Language, Messages};

/// Maximum length of a file name in the table, characters.
const NAME: usize = 40;

/// One line in the table of several recordings.
///
/// ```
/// use gaitcam::force::{Feet, model};
/// use gaitcam_output::gait::{TrialRow, trials_table};
/// use gaitcam::wording::Language;
///
/// let curve = model("young", Some(1.85), 700.0, Feet::Both)?;
/// let row = TrialRow { name: "a.csv", understood: None, curve: Some(&curve), fault: None, left_out: None };
/// assert!(trials_table(&[row], None, Language::En).contains("a.csv"));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct TrialRow<'a> {
    /// Path of the file, as given.
    pub name: &'a str,
    /// Interpretation of the recording; `None` if it cannot be read or contains exactly one cycle.
    pub understood: Option<&'a Interpretation>,
    /// Mean cycle, or the only cycle of the file; `None` if the recording has no cycle.
    pub curve: Option<&'a ForceCurve>,
    /// Error because of which the recording has no cycle.
    pub fault: Option<&'a Error>,
    /// Reason for the exclusion from the joint mean; `None` if the recording is included.
    pub left_out: Option<&'a LeftOut>,
}

/// Table of several recordings as text, with the joint mean at the end.
pub fn trials_table(rows: &[TrialRow], joint: Option<&JointMean>, language: Language) -> String {
    let mut out = Lines::new(language);
    write_rows(&mut out, rows);
    write_joint(&mut out, joint);
    out.text
}

fn write_rows(out: &mut Lines, rows: &[TrialRow]) {
    let head = out.words.text("gait-trial-columns");
    let head = head.split("  ").map(|c| c.trim().to_string());
    let mut table: Vec<Vec<String>> = vec![head.filter(|c| !c.is_empty()).collect()];
    table.extend(rows.iter().map(|row| cells(out.words, row)));
    let width = |column: usize| {
        let cells = table.iter().filter_map(|row| row.get(column));
        cells.map(|c| c.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..table[0].len()).map(width).collect();
    for row in &table {
        // Text is aligned left and numbers are aligned right. The last column is not padded, because its text may be long.
        let cell = |(k, (cell, &wide)): (usize, (&String, &usize))| match k {
            0 | 1 => format!("{cell:<wide$}  "),
            _ if k + 1 == widths.len() => cell.clone(),
            _ => format!("{cell:>wide$}  "),
        };
        let cells = row.iter().zip(&widths).enumerate().map(cell);
        out.line(cells.collect::<String>());
    }
}

/// Cells of a row: file, kind, contacts used and rejected, stride time, mass, mean force, number of notes, inclusion in the joint mean.
fn cells(words: &Messages, row: &TrialRow) -> Vec<String> {
    let kind = row.understood.and_then(|u| u.kind);
    let kind = match (kind, row.curve, row.understood) {
        (Some(kind), _, _) => words.sentence("kind", &kind),
        (None, Some(_), None) => words.text("gait-as-given"),
        _ => "-".to_string(),
    };
    let mut cells = vec![shortened(row.name), kind];
    cells.extend(numbers(words, row));
    cells.push(part(words, row));
    cells
}

/// File name in the table. If the name is too long, its beginning is omitted, because the end distinguishes the files of a folder.
fn shortened(name: &str) -> String {
    let count = name.chars().count();
    if count <= NAME {
        return name.to_string();
    }
    let end: String = name.chars().skip(count - NAME + 1).collect();
    format!("…{end}")
}

fn numbers(words: &Messages, row: &TrialRow) -> [String; 6] {
    let none = || "-".to_string();
    let (used, rejected) = row.understood.map_or((none(), none()), |u| {
        let (used, rejected) = u.counts();
        (used.to_string(), rejected.to_string())
    });
    let curve = row.curve;
    let mass = row.understood.and_then(|u| u.mass).map(|m| m.0);
    let mass = mass.or(curve.and_then(|c| c.mass_kg));
    let notes = row.understood.map(|u| u.warnings.len().to_string());
    [
        used,
        rejected,
        curve.map_or_else(none, |c| words.fixed(c.period_s, 3)),
        mass.map_or_else(none, |kg| words.fixed(kg, 1)),
        curve.map_or_else(none, |c| words.fixed(c.mean_n(), 1)),
        notes.unwrap_or_else(none),
    ]
}

/// Text stating that the recording is included in the joint mean, or why it is excluded.
fn part(words: &Messages, row: &TrialRow) -> String {
    let reason = match (row.fault, row.left_out) {
        (Some(fault), _) => fault.what(words.language()),
        (None, Some(left_out)) => words.sentence("left-out", left_out),
        (None, None) => return words.text("gait-used"),
    };
    words.sentence("gait", &json!({"left-out": {"reason": reason}}))
}

fn write_joint(out: &mut Lines, joint: Option<&JointMean>) {
    let words = out.words;
    let Some(joint) = joint else {
        return out.line(format_args!("\n{}", words.text("gait-no-joint-mean")));
    };
    let (trials, cycles) = (joint.trials(), joint.cycles);
    let numbers = json!({"trials": trials, "cycles": cycles, "movement": joint.kind});
    let head = json!({"joint-mean": numbers});
    out.line(format_args!("\n{}", words.sentence("gait", &head)));
    out.period(joint.curve.period_s, joint.period_spread_s);
    let from = joint.mass_from.map(|f| words.sentence("mass-from", &f));
    let from = from.unwrap_or_else(|| words.text("gait-several-sources"));
    let mass = words.fixed(joint.mass_kg, 1);
    out.row("gait-mass", format_args!("{mass} kg ({from})"));
    out.mean(&joint.curve, joint.mass_kg);
    out.notes("gait-warning", &joint.notes);
    out.spread(&joint.curve, joint.repeatability_n, joint.mass_kg);
}

/// JSON data of several recordings and of their joint mean. `objects` contains the data of each recording, to which `in_mean` and
/// `left_out` are added.
pub fn trials_json(rows: &[TrialRow], objects: Vec<Value>, joint: Option<&JointMean>) -> Value {
    let recordings: Vec<Value> = rows
        .iter()
        .zip(objects)
        .map(|(row, mut object)| {
            let fault = row.fault.map(|f| json!({"code": f.code(), "data": {}}));
            let left_out = fault.or(row.left_out.map(coded));
            object["in_mean"] = json!(left_out.is_none());
            object["left_out"] = json!(left_out);
            object
        })
        .collect();
    let mean = joint.map(|j| {
        let warnings: Vec<Value> = j.notes.iter().map(coded).collect();
        json!({
            "recordings": j.trials(), "cycles": j.cycles, "kind": j.kind,
            "period_s": j.curve.period_s, "period_spread_s": j.period_spread_s,
            "mean_n": j.curve.mean_n(), "mass_kg": j.mass_kg, "mass_from": j.mass_from,
            "spread_rms_n": j.curve.spread_rms_n(), "repeatability_n": j.repeatability_n,
            "warnings": warnings,
        })
    });
    json!({"recordings": recordings, "joint_mean": mean})
}

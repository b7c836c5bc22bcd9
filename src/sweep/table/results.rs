//! Result of one scene of a sweep, as a row of the table.

use crate::cam::Verdict;
use crate::force::Interpretation;
use crate::problem::Target;
use crate::synth::{Design, FIGURES, Figures, Tier};

/// Names of the numeric columns, in the order of [`FIGURES`] and in SI units. A missing number is NaN in Rust, empty in CSV, and null in
/// Parquet.
pub const NUMBERS: [&str; FIGURES.len()] = {
    let mut names = [""; FIGURES.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = FIGURES[i].column;
        i += 1;
    }
    names
};

/// Names of the columns of words. These columns follow the numeric columns. `outcome` is `built`, `infeasible` or `error`. `tier` is the
/// solution method, `binding` contains the active or conflicting limits, and `failed` the violated limits. `warnings` contains the codes of
/// the warnings about the recording.
pub const WORDS: [&str; 7] = [
    "outcome", "verdict", "tier", "binding", "failed", "error", "warnings",
];

/// Index of the first of three numeric columns that have values even if no cam was designed.
const TARGET_MEAN: usize = column("target_mean_n");
const MASS: usize = column("mass_kg");
const SPEED: usize = column("speed_rad_per_s");

/// Indices of the numeric columns that have values only for a design with a target force.
const OF_TARGET: [usize; 4] = [
    column("force_rms_error_n"),
    column("force_rms_error_percent"),
    column("force_max_error_n"),
    TARGET_MEAN,
];

/// Index of the numeric column with a name. An unknown name is an error at compile time.
const fn column(name: &str) -> usize {
    let mut place = 0;
    while !is_same(NUMBERS[place].as_bytes(), name.as_bytes()) {
        place += 1;
    }
    place
}

const fn is_same(a: &[u8], b: &[u8]) -> bool {
    let mut same = 0;
    while same < a.len() && same < b.len() && a[same] == b[same] {
        same += 1;
    }
    same == a.len() && same == b.len()
}

/// Name of the last column, which contains the computing time of the row, s. Other columns do not differ between runs.
pub const TIME: &str = "time_s";

/// Outcome of the computation of a row.
///
/// ```
/// use gaitcam::sweep::Outcome;
///
/// assert_eq!(Outcome::Infeasible.name(), "infeasible");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Outcome {
    /// A cam was designed. Its verdict states whether it is usable.
    Built,
    /// No cam was designed, because the limits are infeasible.
    Infeasible,
    /// No cam was designed, because the scene is invalid or the computation failed, for example at its time limit.
    Error,
}

impl Outcome {
    /// Name of the outcome in a table.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// Result of one scene of a sweep, as a row of the table.
///
/// ```
/// use gaitcam::sweep::{NUMBERS, Outcome, Row};
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let row = Row::of(&design);
/// let stroke = NUMBERS.iter().position(|name| *name == "stroke_m").unwrap();
/// assert_eq!((row.outcome, row.numbers[stroke]), (Outcome::Built, design.cam.law.stroke()));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Numbers in the order of [`NUMBERS`]; NaN if missing.
    pub numbers: [f64; NUMBERS.len()],
    /// Outcome of the design.
    pub outcome: Outcome,
    /// Verdict on the design; `None` if the outcome is an error.
    pub verdict: Option<Verdict>,
    /// Method by which the law was computed; `None` without a designed cam.
    pub tier: Option<Tier>,
    /// Names of the active or conflicting limits, joined by `+`.
    pub binding: String,
    /// Names of the limits that the cam violates, joined by `+`.
    pub failed: String,
    /// Error because of which no cam was designed; empty without an error.
    pub error: String,
    /// Codes of the warnings about the recording, joined by `+`; empty without warnings.
    pub warnings: String,
    /// Computing time of the row, s.
    pub time_s: f64,
}

impl Row {
    /// Cells of the row in the columns [`WORDS`]; a cell without a value is empty.
    pub fn words(&self) -> [&str; WORDS.len()] {
        [
            self.outcome.name(),
            self.verdict.map_or("", Verdict::name),
            self.tier.map_or("", Tier::name),
            &self.binding,
            &self.failed,
            &self.error,
            &self.warnings,
        ]
    }

    /// Row with the message of an error and without results.
    pub fn error(what: String) -> Row {
        Row {
            numbers: [f64::NAN; NUMBERS.len()],
            outcome: Outcome::Error,
            verdict: None,
            tier: None,
            binding: String::new(),
            failed: String::new(),
            error: what.replace(['\n', '\r'], " "),
            warnings: String::new(),
            time_s: 0.0,
        }
    }

    /// Row of a harmonic design that was computed in closed form and satisfies all limits.
    pub(crate) fn spectral(figures: &Figures, target: Option<&Target>) -> Row {
        Row {
            numbers: FIGURES.each_ref().map(|f| f.value(figures)),
            warnings: target.map(|t| warnings(t.recording())).unwrap_or_default(),
            outcome: Outcome::Built,
            verdict: Some(Verdict::Acceptable),
            tier: Some(Tier::Spectral),
            ..Row::error(String::new())
        }
    }

    /// Row of a design. For an infeasible scene, the row contains only values that are known without a cam, such as mean target force, mass
    /// and speed.
    pub fn of(design: &Design) -> Row {
        let mut row = Row::error(String::new());
        let recording = design.target().and_then(|t| t.recording.as_deref());
        row.warnings = warnings(recording);
        if let Some(infeasible) = &design.infeasible {
            row.numbers[TARGET_MEAN] = design.target().map_or(f64::NAN, |t| t.mean_n());
            row.numbers[MASS] = design.problem.drive.mass;
            row.numbers[SPEED] = design.problem.drive.speed;
            row.outcome = Outcome::Infeasible;
            row.binding = joined(infeasible.names().into_iter());
            row.verdict = Some(Verdict::Unacceptable);
            return row;
        }
        let figures = Figures::of(design);
        row.numbers = FIGURES.each_ref().map(|f| f.value(&figures));
        if design.target().is_none() {
            for column in OF_TARGET {
                row.numbers[column] = f64::NAN;
            }
        }
        row.outcome = Outcome::Built;
        row.verdict = Some(design.verdict);
        row.tier = Some(design.solver.tier);
        row.binding = joined(design.binding.iter().map(|b| b.limit.name().to_string()));
        let failed = design.checks.iter().filter(|c| !c.pass);
        row.failed = joined(failed.map(|c| c.name.name().to_string()));
        row
    }
}

/// Codes of the warnings about a recording, joined by `+`; empty without a recording.
fn warnings(recording: Option<&Interpretation>) -> String {
    let codes = recording.map(Interpretation::codes);
    codes.unwrap_or_default().join("+")
}

/// Distinct names, joined by `+` in the order of their first occurrence.
fn joined(names: impl Iterator<Item = String>) -> String {
    let mut list: Vec<String> = Vec::new();
    for name in names {
        if !list.contains(&name) {
            list.push(name);
        }
    }
    list.join("+")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stand_in_the_order_of_their_columns() {
        let mut row = Row::error("wrong\nhere".to_string());
        assert_eq!(row.words(), ["error", "", "", "", "", "wrong here", ""]);
        (row.outcome, row.verdict, row.tier) =
            (Outcome::Built, Some(Verdict::Acceptable), Some(Tier::Qp));
        (row.binding, row.error) = ("stroke+jerk".to_string(), String::new());
        let words = ["built", "acceptable", "qp", "stroke+jerk", "", "", ""];
        assert_eq!(row.words(), words);
    }
}

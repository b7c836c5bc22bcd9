//! Results of many scenes as columns.

use crate::cam::Verdict;
use crate::force::ForceCurve;
use crate::synth::spectral::HarmonicTarget;
use crate::synth::{Design, FIGURES, Figures, Tier};

/// Columns of numbers, SI: those of [`FIGURES`]. A number that does not exist is NaN here, empty in CSV and null in
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

/// Columns of words, between the numbers and the time: outcome `built`, `infeasible` or `error`, the
/// verdict, the solver's tier, active (or conflicting) limits, limits that fail, what went wrong, and codes of
/// the warnings about the recording.
pub const WORDS: [&str; 7] = [
    "outcome", "verdict", "tier", "binding", "failed", "error", "warnings",
];

/// The last column: time of the row, s. Only this column differs from run to run.
pub const TIME: &str = "time_s";

/// Outcome of a row.
///
/// ```
/// use gaitcam::sweep::Outcome;
///
/// assert_eq!(Outcome::Infeasible.name(), "infeasible");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// A cam was designed; the verdict says how good it is.
    Built,
    /// The limits are infeasible.
    Infeasible,
    /// The scene itself is at fault.
    Error,
}

impl Outcome {
    const ALL: [Outcome; 3] = [Outcome::Built, Outcome::Infeasible, Outcome::Error];

    /// The word of the table.
    pub fn name(self) -> &'static str {
        match self {
            Outcome::Built => "built",
            Outcome::Infeasible => "infeasible",
            Outcome::Error => "error",
        }
    }
}

const VERDICTS: [Verdict; 3] = [
    Verdict::Acceptable,
    Verdict::NotForHighSpeed,
    Verdict::Unacceptable,
];
const TIERS: [Tier; 5] = [
    Tier::Spectral,
    Tier::Equality,
    Tier::Qp,
    Tier::Socp,
    Tier::Scp,
];
/// Code of a verdict or tier that does not exist.
const NONE: u8 = 255;

/// One row of the table.
///
/// ```
/// use gaitcam::sweep::{NUMBERS, Outcome, Row};
/// use gaitcam::{scene, synthesise};
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
    /// In the order of [`NUMBERS`].
    pub numbers: [f64; NUMBERS.len()],
    /// Its outcome.
    pub outcome: Outcome,
    /// The class of the cam, where one was built.
    pub verdict: Option<Verdict>,
    /// The solution method.
    pub tier: Option<Tier>,
    /// Active or conflicting limits, joined by `+`.
    pub binding: String,
    /// Limits that the cam violates, joined by `+`.
    pub failed: String,
    /// What is wrong with the scene.
    pub error: String,
    /// Codes of the warnings about its recording, joined by `+`.
    pub warnings: String,
    /// Its time, s.
    pub time_s: f64,
}

impl Row {
    /// A scene at fault.
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

    /// The row of a spectral design that keeps every limit, for a force.
    pub(crate) fn spectral(figures: &Figures, target: &HarmonicTarget) -> Row {
        Row {
            numbers: FIGURES.each_ref().map(|f| f.value(figures)),
            warnings: target.curve().map(warnings).unwrap_or_default(),
            outcome: Outcome::Built,
            verdict: Some(Verdict::Acceptable),
            tier: Some(Tier::Spectral),
            ..Row::error(String::new())
        }
    }

    /// The row of a finished design. An infeasible one has no cam, so only its demand is given.
    pub fn of(design: &Design) -> Row {
        let mut row = Row::error(String::new());
        row.warnings = design.target.as_ref().map(warnings).unwrap_or_default();
        if let Some(infeasible) = &design.infeasible {
            row.numbers[3] = design.target.as_ref().map_or(f64::NAN, |t| t.mean_n());
            row.numbers[7] = design.drive.mass;
            row.numbers[8] = design.drive.speed;
            row.outcome = Outcome::Infeasible;
            row.binding = joined(infeasible.names().into_iter());
            row.verdict = Some(Verdict::Unacceptable);
            return row;
        }
        let figures = Figures::of(design);
        row.numbers = FIGURES.each_ref().map(|f| f.value(&figures));
        if design.target.is_none() {
            // Without a target there is no force error.
            for number in &mut row.numbers[..4] {
                *number = f64::NAN;
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

/// Codes of the warnings about the recording of a force.
fn warnings(target: &ForceCurve) -> String {
    let codes = target.recording.as_ref().map(|r| r.codes());
    codes.unwrap_or_default().join("+")
}

/// Names joined by `+`, each once.
fn joined(names: impl Iterator<Item = String>) -> String {
    let mut list: Vec<String> = Vec::new();
    for name in names {
        if !list.contains(&name) {
            list.push(name);
        }
    }
    list.join("+")
}

/// Text of the few rows that have any, by row number.
type Sparse = Vec<(u32, String)>;

/// Results of many rows.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Results {
    numbers: Vec<Vec<f64>>,
    outcome: Vec<u8>,
    verdict: Vec<u8>,
    tier: Vec<u8>,
    texts: [Sparse; 4],
    time_s: Vec<f64>,
}

fn position<T: PartialEq>(list: &[T], item: &T) -> u8 {
    list.iter()
        .position(|x| x == item)
        .map_or(NONE, |i| i as u8)
}

impl Results {
    /// No rows yet, with room for some.
    pub fn with_capacity(rows: usize) -> Results {
        Results {
            numbers: (NUMBERS.iter().map(|_| Vec::with_capacity(rows))).collect(),
            outcome: Vec::with_capacity(rows),
            verdict: Vec::with_capacity(rows),
            tier: Vec::with_capacity(rows),
            texts: Default::default(),
            time_s: Vec::with_capacity(rows),
        }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.outcome.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.outcome.is_empty()
    }

    /// Adds a row.
    pub fn push(&mut self, row: Row) {
        let at = self.len() as u32;
        for (column, x) in self.numbers.iter_mut().zip(row.numbers) {
            column.push(x);
        }
        self.outcome.push(position(&Outcome::ALL, &row.outcome));
        self.verdict
            .push(row.verdict.map_or(NONE, |v| position(&VERDICTS, &v)));
        self.tier
            .push(row.tier.map_or(NONE, |t| position(&TIERS, &t)));
        for (texts, text) in
            self.texts
                .iter_mut()
                .zip([row.binding, row.failed, row.error, row.warnings])
        {
            if !text.is_empty() {
                texts.push((at, text));
            }
        }
        self.time_s.push(row.time_s);
    }

    /// A column of [`NUMBERS`].
    pub fn numbers(&self, column: usize) -> &[f64] {
        &self.numbers[column]
    }

    /// Time of each row, s.
    pub fn times(&self) -> &[f64] {
        &self.time_s
    }

    /// Outcome of a row.
    pub fn outcome(&self, row: usize) -> Outcome {
        *Outcome::ALL
            .get(self.outcome[row] as usize)
            .unwrap_or(&Outcome::Error)
    }

    /// A column of [`WORDS`] for all rows; empty where there is none.
    pub fn words(&self, column: usize) -> Vec<&str> {
        let coded = |codes: &[u8], name: &dyn Fn(usize) -> &'static str| -> Vec<&str> {
            codes
                .iter()
                .map(|&c| if c == NONE { "" } else { name(c as usize) })
                .collect()
        };
        match column {
            0 => coded(&self.outcome, &|c| {
                Outcome::ALL.get(c).map_or("", |o| o.name())
            }),
            1 => coded(&self.verdict, &|c| VERDICTS.get(c).map_or("", |v| v.name())),
            2 => coded(&self.tier, &|c| TIERS.get(c).map_or("", |t| t.name())),
            _ => {
                let mut out = vec![""; self.len()];
                for (row, text) in &self.texts[column - 3] {
                    if let Some(cell) = out.get_mut(*row as usize) {
                        *cell = text;
                    }
                }
                out
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn some() -> Results {
        let mut r = Results::with_capacity(3);
        r.push(Row::error("wrong\nhere".to_string()));
        let mut row = Row::error(String::new());
        row.numbers = [0.1; NUMBERS.len()];
        (row.outcome, row.verdict, row.tier) =
            (Outcome::Built, Some(Verdict::Acceptable), Some(Tier::Qp));
        row.binding = "stroke+jerk".to_string();
        r.push(row);
        r
    }

    #[test]
    fn columns_hold_what_rows_say() {
        let r = some();
        assert_eq!(r.words(5), ["wrong here", ""]);
        assert_eq!(r.words(3), ["", "stroke+jerk"]);
        assert_eq!(r.words(2), ["", "qp"]);
        assert!(r.numbers(0)[0].is_nan() && r.numbers(0)[1] == 0.1);
    }
}

//! Parts of the report for use in other pages: key figures, checks, animated cam.

use serde::Serialize;

pub use super::motion::Motion;
use super::{animation, cards_of, motion, tables};
use crate::words;
use gaitcam::criterion::Criterion;
use gaitcam::synth::{Design, unit};
use gaitcam::wording::Language;

/// Key figure of the report: name, value with unit, and remark.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Figure {
    /// Name of the key figure.
    pub name: String,
    /// Value with its unit.
    pub value: String,
    /// Remark below the value; may be empty.
    pub more: String,
}

/// Key figures at the top of the report, such as force error, stroke, base radius, minimum radius of curvature and speed.
pub fn figures(design: &Design, language: Language) -> Vec<Figure> {
    let cards = cards_of(design, &words::words(language)).into_iter();
    let figure = |(name, value, more)| Figure { name, value, more };
    cards.map(figure).collect()
}

/// Result of a check of the design, in customary units.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Checked {
    /// Key of the checked criterion, as in `summary.json`.
    pub key: &'static str,
    /// Name of the criterion.
    pub name: String,
    /// State of the check: `satisfied`, `at-limit` or `violated`.
    pub state: &'static str,
    /// Worst value over the cycle.
    pub value: f64,
    /// Limit of the value; `None` if the limit is only a rounding tolerance.
    pub limit: Option<f64>,
    /// Unit of value and limit.
    pub unit: &'static str,
    /// Position of the worst value, with its unit; empty if the value applies to the whole cycle.
    pub place: String,
}

/// Results of all checks of a design.
pub fn checks(design: &Design, language: Language) -> Vec<Checked> {
    let measures = design.cam.follower.measures();
    let of = |check: &gaitcam::cam::Check| {
        let unit = unit(measures, check.name);
        let (limit, at) = tables::limit_and_place(check);
        Checked {
            key: check.name.name(),
            name: name(check.name.name(), language),
            state: tables::state(check),
            value: unit.factor * check.worst,
            limit: limit.map(|x| unit.factor * x),
            unit: unit.name,
            place: at.map_or(String::new(), |at| measures.place(at, language)),
        }
    };
    design.checks.iter().map(of).collect()
}

/// The cam with its follower as SVG in mm, y upwards. The moving parts have the ids `cam-turning`, `cam-follower`, `cam-second`,
/// `cam-push` and `cam-contact`.
pub fn drawing(design: &Design, language: Language) -> String {
    let mut out = String::with_capacity(1 << 16);
    animation::drawing(&mut out, design, None, &words::words(language));
    out
}

/// Positions of the moving parts of [`drawing`] at equal steps over one turn, with lift and force. Lengths are in mm, forces in N and
/// angles in degrees.
pub fn motion(design: &Design) -> Motion {
    motion::motion(design, None).without_readings()
}

/// Formats the value of a criterion as text in its customary unit. `value` is in SI units.
pub fn shown(design: &Design, limit: Criterion, value: f64, language: Language) -> String {
    let measures = design.cam.follower.measures();
    tables::shown(measures, limit, value, &words::words(language))
}

/// Name of a limit, follower or law in a language. `typed` is its name in a scene file.
pub fn name(typed: &str, language: Language) -> String {
    words::words(language).name(typed)
}

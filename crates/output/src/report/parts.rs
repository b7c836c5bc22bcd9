//! Parts of the report for other pages: figures, tables, the cam in motion.

use serde::Serialize;

pub use super::motion::Motion;
use super::{animation, cards_of, motion, tables};
use crate::Timing;
use crate::words;
use gaitcam::criterion::Criterion;
use gaitcam::synth::Design;
use gaitcam::wording::Language;

/// A main figure of the report.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Figure {
    /// Name of the figure.
    pub name: String,
    /// Value of the figure with its unit.
    pub value: String,
    /// Remark below the value; may be empty.
    pub more: String,
}

/// The figures at the top: force error, force, stroke, base circle, smallest radius, speed.
pub fn figures(design: &Design, language: Language) -> Vec<Figure> {
    let cards = cards_of(design, &words::words(language)).into_iter();
    let figure = |(name, value, more)| Figure { name, value, more };
    cards.map(figure).collect()
}

/// Checks, active limits, data and solution as HTML sections.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Tables {
    /// Every check with its margin.
    pub checks: String,
    /// Active limits and the gain from relaxing them.
    pub active: String,
    /// Drive, law, cam and loads in numbers.
    pub data: String,
    /// Solution method and certificate.
    pub solution: String,
}

/// The tables of a design.
pub fn tables(design: &Design, time: Timing, language: Language) -> Tables {
    let words = words::words(language);
    let of = |write: &dyn Fn(&mut String)| {
        let mut out = String::new();
        write(&mut out);
        out
    };
    Tables {
        checks: of(&|out| tables::checks(out, design, &words)),
        active: of(&|out| tables::active(out, design, &words)),
        data: of(&|out| tables::numbers(out, design, &words)),
        solution: of(&|out| tables::solution(out, design, time, &words)),
    }
}

/// The cam with its follower as SVG in mm, y up; its moving parts have the ids `cam-turning`, `cam-follower`,
/// `cam-second`, `cam-push` and `cam-contact`.
pub fn drawing(design: &Design, language: Language) -> String {
    let mut out = String::with_capacity(1 << 16);
    animation::drawing(&mut out, design, None, &words::words(language));
    out
}

/// Positions of those parts at equal steps of one turn, with the values there; mm, N, degrees.
pub fn motion(design: &Design) -> Motion {
    motion::motion(design, None).without_readings()
}

/// A value of a limit in its customary unit.
pub fn shown(design: &Design, limit: Criterion, value: f64, language: Language) -> String {
    let measures = design.cam.follower.measures();
    tables::shown(measures, limit, value, &words::words(language))
}

/// The name of a limit, follower or law in a language.
pub fn name(typed: &str, language: Language) -> String {
    words::words(language).name(typed)
}

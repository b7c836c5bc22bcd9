//! Stances and contacts: what is found in a recording.

use crate::force::recording::Foot;

/// One point of a stance: force and fraction of the stance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Force, N.
    pub force_n: f64,
    /// Time since heel strike over the duration of the stance, 0 to 1.
    pub at: f64,
}

/// A whole stance of one foot.
#[derive(Debug, Clone, PartialEq)]
pub struct Stance {
    /// Channel of the recording.
    pub channel: usize,
    /// The foot, where the file says or implies it.
    pub foot: Option<Foot>,
    /// Heel strike, s from the first sample.
    pub start_s: f64,
    /// Toe-off, s from the first sample.
    pub end_s: f64,
    /// Loading peak (the only one of a stance with one hump).
    pub p1: Point,
    /// Mid-stance valley, if the stance has two humps.
    pub valley: Option<Point>,
    /// Push-off peak, if the stance has two humps.
    pub p2: Option<Point>,
    /// Integral of the force over the stance, N s.
    pub impulse_ns: f64,
    /// Mass of the walker, kg, where this stance has its own (tables of stances).
    pub mass_kg: Option<f64>,
}

/// Why a contact is not used.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Why {
    /// The recording starts inside it.
    CutAtStart,
    /// The recording ends inside it.
    CutAtEnd,
    /// A sliver of a contact at the edge of the recording: no stance, cut or not.
    Scrap,
    /// The plate was loaded from the first sample to the last.
    NeverUnloaded,
    /// Samples are missing inside it.
    Missing,
    /// It lasts too short for a step.
    Touch,
    /// One short hump.
    Running,
    /// It lasts too long for a step.
    Standing,
    /// Longer than the others: the other foot came onto the same plate.
    CrossOver,
    /// Two plates carried the foot at the same time.
    Shared,
    /// Only a part of the foot was on the plate.
    Partial,
}

impl Why {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Why::CutAtStart => "cut: the recording starts inside the stance",
            Why::CutAtEnd => "cut: the recording ends inside the stance",
            Why::Scrap => "scrap: a sliver of a contact at the edge of the recording, not counted",
            Why::NeverUnloaded => "never unloaded: standing, or both feet on one plate",
            Why::Missing => "samples are missing inside the stance",
            Why::Touch => "too short for a step",
            Why::Running => "running: one short hump",
            Why::Standing => "standing: too long for a step",
            Why::CrossOver => "cross-over: too long for one foot, both feet on one plate",
            Why::Shared => "shared: the foot lay across two plates",
            Why::Partial => "partial: too little force for a whole foot",
        }
    }
}

/// A contact that is not used.
#[derive(Debug, Clone, PartialEq)]
pub struct Rejected {
    /// Channel of the recording.
    pub channel: usize,
    /// Start, s.
    pub from_s: f64,
    /// End, s.
    pub to_s: f64,
    /// The reason.
    pub why: Why,
}

/// All contacts of a recording, each used or rejected, in order of time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Stances {
    /// Whole walking stances.
    pub used: Vec<Stance>,
    /// The others.
    pub rejected: Vec<Rejected>,
}

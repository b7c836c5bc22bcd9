//! Stances: when a foot stands on a plate, which of these contacts are whole walking steps, and why the
//! others are not.

use super::contact::{Contact, contacts};
use super::feet::name_feet;
use super::recording::{Foot, Recording};
use super::shape::{Shape, shape};
use super::verdict::{Usual, missing, shared, verdict};

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

/// Finds the stances of a recording.
pub fn stances(recording: &Recording) -> Stances {
    let live = || {
        recording
            .channels
            .iter()
            .enumerate()
            .filter(|(_, c)| c.idle.is_none())
    };
    let mut contacts: Vec<Contact> = live()
        .filter(|(_, c)| c.rows.is_empty())
        .flat_map(|(i, c)| contacts(i, c, recording.rate_hz))
        .collect();
    contacts.sort_by(|a, b| a.start_s.total_cmp(&b.start_s));
    let usual = Usual::of(&contacts, recording.mass_kg);
    let shared = shared(&contacts, recording);
    let mut out = Stances::default();
    for (contact, shared) in contacts.iter().zip(shared) {
        let channel = &recording.channels[contact.channel];
        let force = &channel.force_n;
        let shape = shape(force, recording.rate_hz, contact.start_s, contact.end_s);
        let why = verdict(contact, &shape, &usual, shared)
            .or_else(|| missing(contact, channel, recording));
        match why {
            None => out.used.push(stance(contact, &shape, channel.foot, None)),
            Some(why) => out.rejected.push(Rejected {
                channel: contact.channel,
                from_s: contact.start_s,
                to_s: contact.end_s,
                why,
            }),
        }
    }
    for (i, c) in live() {
        out.used.extend(c.rows.iter().map(|row| {
            let contact = Contact {
                channel: i,
                start_s: row.from as f64 / recording.rate_hz,
                end_s: (row.to - 1) as f64 / recording.rate_hz,
                peak_n: 0.0,
                cut: None,
            };
            let shape = shape(
                &c.force_n,
                recording.rate_hz,
                contact.start_s,
                contact.end_s,
            );
            stance(&contact, &shape, c.foot, row.mass_kg)
        }));
    }
    name_feet(&mut out.used, recording);
    out
}

fn stance(contact: &Contact, shape: &Shape, foot: Option<Foot>, mass_kg: Option<f64>) -> Stance {
    Stance {
        channel: contact.channel,
        foot,
        start_s: contact.start_s,
        end_s: contact.end_s,
        p1: shape.p1,
        valley: shape.valley,
        p2: shape.p2,
        impulse_ns: shape.impulse_ns,
        mass_kg,
    }
}

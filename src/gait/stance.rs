//! Stances: when a foot stands on a plate, which of these contacts are whole walking steps, and why the
//! others are not.

use super::feet::name_feet;
use super::recording::{Channel, Foot, Recording};
use super::shape::{Shape, shape};
use crate::units::G;

/// Force from which a foot is on the plate, N; the README of the recordings counts stances so.
const CONTACT_N: f64 = 20.0;
/// Contact is over below this part of the contact threshold, so that noise does not part a stance.
const HYSTERESIS: f64 = 0.5;
/// Noise of the unloaded plate is kept this many standard deviations below the threshold.
const NOISE_MARGIN: f64 = 6.0;
/// Contacts parted by less than this are one, s.
const DIP_S: f64 = 0.04;
/// A contact shorter than this is no step, s.
const TOUCH_S: f64 = 0.1;
/// A stance in running is shorter than this, s.
const RUNNING_S: f64 = 0.3;
/// A contact longer than this is standing, s.
const STANDING_S: f64 = 1.8;
/// A contact this many times longer than the middle one holds more than one step.
const LONG: f64 = 1.5;
/// Missing samples up to this long are bridged, s.
const BRIDGED_S: f64 = 0.05;

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

/// A span of contact on one channel, before it is judged.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Contact {
    channel: usize,
    start_s: f64,
    end_s: f64,
    peak_n: f64,
    cut: Option<Why>,
}

impl Contact {
    fn duration_s(&self) -> f64 {
        self.end_s - self.start_s
    }
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

/// Spans above the threshold, their ends placed between the samples where the force crosses it.
fn contacts(index: usize, channel: &Channel, rate_hz: f64) -> Vec<Contact> {
    let force = &channel.force_n;
    let on = CONTACT_N.max(NOISE_MARGIN * channel.noise_n);
    let off = HYSTERESIS * on;
    let crossing = |i: usize| {
        let (a, b) = (force[i], force[i + 1]);
        (i as f64 + ((on - a) / (b - a)).clamp(0.0, 1.0)) / rate_hz
    };
    let mut found: Vec<Contact> = Vec::new();
    let mut i = 0;
    while i < force.len() {
        if force[i] <= on {
            i += 1;
            continue;
        }
        let first = i;
        let mut last = i; // last sample above `on`
        let mut peak_n = 0.0f64;
        while i < force.len() && force[i] > off {
            if force[i] > on {
                last = i;
            }
            peak_n = peak_n.max(force[i]);
            i += 1;
        }
        let cut_start = first == 0;
        let cut_end = i == force.len();
        let contact = Contact {
            channel: index,
            start_s: if cut_start { 0.0 } else { crossing(first - 1) },
            end_s: if last + 1 < force.len() {
                crossing(last)
            } else {
                last as f64 / rate_hz
            },
            peak_n,
            cut: match (cut_start, cut_end) {
                (true, true) if last as f64 > STANDING_S * rate_hz => Some(Why::NeverUnloaded),
                (true, _) => Some(Why::CutAtStart),
                (false, true) => Some(Why::CutAtEnd),
                (false, false) => None,
            },
        };
        match found.last_mut() {
            Some(before) if contact.start_s - before.end_s < DIP_S => {
                before.end_s = contact.end_s;
                before.peak_n = before.peak_n.max(peak_n);
                before.cut = before.cut.or(contact.cut);
            }
            _ => found.push(contact),
        }
    }
    // Ripples of the unloaded plate just above the threshold are no contacts.
    found.retain(|c| c.peak_n > 2.0 * on || c.duration_s() > TOUCH_S);
    found
}

/// What whole contacts of the recording are like.
struct Usual {
    duration_s: Option<f64>,
    peak_n: Option<f64>,
    weight_n: Option<f64>,
}

impl Usual {
    fn of(contacts: &[Contact], mass_kg: Option<f64>) -> Self {
        let top = contacts.iter().map(|c| c.peak_n).fold(0.0, f64::max);
        let whole = contacts.iter().filter(|c| {
            c.cut.is_none()
                && (TOUCH_S..STANDING_S).contains(&c.duration_s())
                && c.peak_n > 0.4 * top
        });
        let (durations, peaks): (Vec<f64>, Vec<f64>) =
            whole.map(|c| (c.duration_s(), c.peak_n)).unzip();
        Usual {
            duration_s: (durations.len() >= 2).then(|| low_median(durations)),
            peak_n: (peaks.len() >= 2).then(|| low_median(peaks)),
            weight_n: mass_kg.map(|m| m * G),
        }
    }
}

/// The lower of the two middle values, so that one long contact of two does not count as usual.
fn low_median(mut v: Vec<f64>) -> f64 {
    v.sort_by(f64::total_cmp);
    v[(v.len() - 1) / 2]
}

fn verdict(contact: &Contact, shape: &Shape, usual: &Usual, shared: bool) -> Option<Why> {
    if contact.cut.is_some() {
        return contact.cut;
    }
    let duration = contact.duration_s();
    if duration < TOUCH_S {
        return Some(Why::Touch);
    }
    let weak = usual.peak_n.is_some_and(|p| contact.peak_n < 0.5 * p)
        || usual.weight_n.is_some_and(|w| contact.peak_n < 0.5 * w);
    let hard = usual.weight_n.is_some_and(|w| contact.peak_n > 1.7 * w);
    let one_hump = shape.valley.is_none();
    if one_hump && (duration < RUNNING_S || hard && duration < 1.3 * RUNNING_S) && !weak {
        return Some(Why::Running);
    }
    if duration > STANDING_S {
        return Some(Why::Standing);
    }
    if usual.duration_s.is_some_and(|d| duration > LONG * d) && duration > 0.8 {
        return Some(Why::CrossOver);
    }
    if shape.humps > 3
        && duration > 0.9
        && usual.weight_n.is_none_or(|w| contact.peak_n > 0.8 * w)
        && shape.holds_two_steps
    {
        return Some(Why::CrossOver);
    }
    if shared {
        return Some(Why::Shared);
    }
    weak.then_some(Why::Partial)
}

/// Contacts that stand for most of their time beside one on another plate: one foot on two plates.
///
/// Sides that are named (insoles, split belts) cannot share a foot.
fn shared(contacts: &[Contact], recording: &Recording) -> Vec<bool> {
    let mut shared = vec![false; contacts.len()];
    let is_plate = |c: &Contact| recording.channels[c.channel].foot.is_none();
    for (i, a) in contacts.iter().enumerate() {
        let later = contacts.iter().enumerate().skip(i + 1);
        for (j, b) in later.take_while(|(_, b)| b.start_s < a.end_s) {
            let both = a.end_s.min(b.end_s) - b.start_s;
            let longer = a.duration_s().max(b.duration_s());
            let whole = a.cut.is_none() && b.cut.is_none();
            if whole && is_plate(a) && is_plate(b) && a.channel != b.channel && both > 0.7 * longer
            {
                shared[i] = true;
                shared[j] = true;
            }
        }
    }
    shared
}

fn missing(contact: &Contact, channel: &Channel, recording: &Recording) -> Option<Why> {
    let rate = recording.rate_hz;
    let inside =
        |from: f64, to: f64| to - from > BRIDGED_S && from < contact.end_s && to > contact.start_s;
    let lacks = channel
        .missing
        .iter()
        .any(|&(a, b)| inside(a as f64 / rate, b as f64 / rate));
    let gaps = recording.gaps_s.iter().any(|&(a, b)| inside(a, b));
    (lacks || gaps).then_some(Why::Missing)
}

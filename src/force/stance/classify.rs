//! Classification of contacts: whole walking stances, and the reason why another contact is none.

use super::contact::{Contact, STANDING_S, TOUCH_S};
use super::shape::Shape;
use super::types::RejectReason;
use crate::force::recording::{Channel, Recording};
use crate::units::G;

/// A stance in running is shorter than this, s.
const RUNNING_S: f64 = 0.3;
/// A contact this many times longer than the middle one holds more than one step.
const LONG: f64 = 1.5;
/// A cut contact shorter than this part of a whole one is no stance.
const FRAGMENT: f64 = 0.25;
/// Missing samples up to this long are bridged, s.
const BRIDGED_S: f64 = 0.05;

/// What whole contacts of the recording are like.
pub(super) struct Usual {
    /// Duration of a whole contact, s, if there is one at all.
    whole_s: Option<f64>,
    /// The same where two or more agree on it.
    duration_s: Option<f64>,
    peak_n: Option<f64>,
    weight_n: Option<f64>,
}

impl Usual {
    pub fn of(contacts: &[Contact], mass_kg: Option<f64>) -> Self {
        let top = contacts.iter().map(|c| c.peak_n).fold(0.0, f64::max);
        let whole = contacts.iter().filter(|c| {
            c.cut.is_none()
                && (TOUCH_S..STANDING_S).contains(&c.duration_s())
                && c.peak_n > 0.4 * top
        });
        let (durations, peaks): (Vec<f64>, Vec<f64>) =
            whole.map(|c| (c.duration_s(), c.peak_n)).unzip();
        Usual {
            whole_s: (!durations.is_empty()).then(|| low_median(durations.clone())),
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

/// Why a contact is no whole walking stance; `None` where it is one.
pub(super) fn rejection(
    contact: &Contact,
    shape: &Shape,
    usual: &Usual,
    shared: bool,
) -> Option<RejectReason> {
    let duration = contact.duration_s();
    if let Some(cut) = contact.cut {
        let fragment = usual.whole_s.is_some_and(|d| duration < FRAGMENT * d);
        return Some(if fragment {
            RejectReason::EdgeFragment
        } else {
            cut
        });
    }
    if duration < TOUCH_S {
        return Some(RejectReason::TooShort);
    }
    let weak = usual.peak_n.is_some_and(|p| contact.peak_n < 0.5 * p)
        || usual.weight_n.is_some_and(|w| contact.peak_n < 0.5 * w);
    let hard = usual.weight_n.is_some_and(|w| contact.peak_n > 1.7 * w);
    let one_hump = shape.valley.is_none();
    if one_hump && (duration < RUNNING_S || hard && duration < 1.3 * RUNNING_S) && !weak {
        return Some(RejectReason::Running);
    }
    if duration > STANDING_S {
        return Some(RejectReason::Standing);
    }
    if usual.duration_s.is_some_and(|d| duration > LONG * d) && duration > 0.8 {
        return Some(RejectReason::CrossOver);
    }
    if shape.humps > 3
        && duration > 0.9
        && usual.weight_n.is_none_or(|w| contact.peak_n > 0.8 * w)
        && shape.holds_two_steps
    {
        return Some(RejectReason::CrossOver);
    }
    if shared {
        return Some(RejectReason::TwoPlates);
    }
    weak.then_some(RejectReason::PartialContact)
}

/// Contacts that stand for most of their time beside one on another plate: one foot on two plates.
///
/// Sides that are named (insoles, split belts) cannot share a foot.
pub(super) fn shared(contacts: &[Contact], recording: &Recording) -> Vec<bool> {
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

/// Whether samples are missing inside a contact.
pub(super) fn missing(
    contact: &Contact,
    channel: &Channel,
    recording: &Recording,
) -> Option<RejectReason> {
    let rate = recording.rate_hz;
    let inside =
        |from: f64, to: f64| to - from > BRIDGED_S && from < contact.end_s && to > contact.start_s;
    let lacks = channel
        .missing
        .iter()
        .any(|&(a, b)| inside(a as f64 / rate, b as f64 / rate));
    let gaps = recording.gaps_s.iter().any(|&(a, b)| inside(a, b));
    (lacks || gaps).then_some(RejectReason::MissingSamples)
}

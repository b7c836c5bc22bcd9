//! Classification of contacts as whole stances or as rejected contacts, with the reason for the rejection.

use super::contact::{Contact, SLOW_STEP_S, STANDING_S, TOUCH_S};
use super::shape::Shape;
use super::types::RejectReason;
use crate::recording::{Channel, Kind, Recording};
use crate::statistics::ranked;
use crate::units::G;

/// Maximum duration of a contact in running, s.
const LONGEST_RUNNING_S: f64 = 0.5;
/// A contact includes more than one step if its duration exceeds this multiple of the typical duration.
const LONG: f64 = 1.5;
/// Value used instead of `LONG` for a contact whose force has more peaks than the force of one foot.
const LONG_WITH_HUMPS: f64 = 1.15;
/// Minimum duration of a contact that may include steps of both feet, s.
const TWO_STEPS_S: f64 = 0.8;
/// An incomplete contact at an end of the recording is a fragment if it is shorter than this fraction of the typical duration.
const FRAGMENT: f64 = 0.25;
/// Maximum duration, s, of missing samples in an accepted contact.
const BRIDGED_S: f64 = 0.05;
/// A contact is cross-talk if its peak force is below this fraction of the peak force of a simultaneous contact on another plate.
const CROSS_TALK: f64 = 0.3;
/// Two contacts on different plates belong to the same foot if they overlap for more than this fraction of the shorter contact. In walking,
/// both feet are on the ground only for less than a third of a stance at its start and at its end.
const SHARED: f64 = 0.4;
/// Maximum total duration of two overlapping contacts that form one stance, s.
const WHOLE_S: f64 = 0.85;
/// Number of main contacts before and after a contact from which its typical duration is computed.
const FELLOWS: usize = 4;
/// A contact may be a whole step if its peak force exceeds this fraction of the maximum force of the recording.
const MAIN: f64 = 0.5;

/// Typical durations and forces of the whole contacts of the recording.
pub(super) struct Usual {
    /// Indices and durations, s, of the main contacts (likely whole steps), in order of time.
    main: Vec<(usize, f64)>,
    peak_n: Option<f64>,
    weight_n: Option<f64>,
    slow: bool,
    insoles: bool,
}

impl Usual {
    pub fn of(contacts: &[Contact], recording: &Recording) -> Self {
        let top = contacts.iter().map(|c| c.peak_n).fold(0.0, f64::max);
        let slow = recording.kind == Some(Kind::Walking) || slow_steps(contacts, top);
        let longest = if slow { SLOW_STEP_S } else { STANDING_S };
        let main: Vec<(usize, f64)> = contacts
            .iter()
            .enumerate()
            .filter(|(_, c)| c.cut.is_none() && c.peak_n > MAIN * top)
            .filter(|(_, c)| (TOUCH_S..longest).contains(&c.duration_s()))
            .map(|(i, c)| (i, c.duration_s()))
            .collect();
        let peaks: Vec<f64> = main.iter().map(|(i, _)| contacts[*i].peak_n).collect();
        Usual {
            peak_n: low_median(peaks),
            weight_n: recording.mass_kg.map(|m| m * G),
            main,
            slow,
            insoles: recording.insole,
        }
    }

    /// Whether two overlapping contacts are together short enough to be one stance. Their total duration is compared with the typical
    /// duration of adjacent contacts. Without adjacent contacts, the limit is `WHOLE_S`.
    fn is_one_stance(&self, i: usize, j: usize, together_s: f64) -> bool {
        let others = self.about(i).filter(|(k, _)| *k != i && *k != j);
        let usual = low_median(others.map(|m| m.1).collect());
        together_s < usual.map_or(WHOLE_S, |s| 1.2 * s)
    }

    /// Typical duration, s, of the contacts near the contact with index `place`.
    fn duration_s(&self, place: usize) -> Option<f64> {
        low_median(self.about(place).map(|m| m.1).collect())
    }

    /// The main contacts near the contact with index `place`, in order of time.
    fn about(&self, place: usize) -> impl Iterator<Item = &(usize, f64)> {
        let at = self.main.partition_point(|(i, _)| *i < place);
        let from = at.saturating_sub(FELLOWS);
        let to = (at + FELLOWS + 1).min(self.main.len());
        self.main[from..to].iter()
    }
}

/// Whether the contacts are steps of a very slow walker: at least three similar contacts that are longer than the limit for standing.
fn slow_steps(contacts: &[Contact], top: f64) -> bool {
    let long: Vec<&Contact> = contacts
        .iter()
        .filter(|c| c.cut.is_none() && c.peak_n > 0.8 * top)
        .collect();
    let Some(usual) = low_median(long.iter().map(|c| c.duration_s()).collect()) else {
        return false;
    };
    let alike = |c: &&&Contact| (c.duration_s() / usual - 1.0).abs() < 0.15;
    let count = long.iter().filter(alike).count();
    (STANDING_S..SLOW_STEP_S).contains(&usual) && count >= 3 && 5 * count >= 4 * long.len()
}

/// Median. For an even number of values, it is the lower of the two middle values. The longer one of two contacts is therefore not typical.
fn low_median(values: Vec<f64>) -> Option<f64> {
    let rank = values.len().checked_sub(1)? / 2;
    ranked(values, rank)
}

/// A contact with its index, its force shape, and its relation to the load on other plates.
pub(super) struct Judged<'a> {
    pub place: usize,
    pub contact: &'a Contact,
    pub shape: &'a Shape,
    pub beside: Beside,
}

/// Reason why a contact is not a whole stance of walking or, if requested, of running; `None` if it is a whole stance.
pub(super) fn rejection(judged: &Judged, usual: &Usual, kind: Kind) -> Option<RejectReason> {
    let (contact, shape) = (judged.contact, judged.shape);
    let duration = contact.duration_s();
    let typical = usual.duration_s(judged.place);
    if let Some(cut) = contact.cut {
        let fragment = typical.is_some_and(|d| duration < FRAGMENT * d);
        return Some(if fragment {
            RejectReason::EdgeFragment
        } else {
            cut
        });
    }
    if judged.beside == Beside::CrossTalk {
        return Some(RejectReason::CrossTalk);
    }
    if duration < TOUCH_S {
        return Some(RejectReason::TooShort);
    }
    let weak = usual.peak_n.is_some_and(|p| contact.peak_n < 0.5 * p)
        || usual.weight_n.is_some_and(|w| contact.peak_n < 0.5 * w);
    let reason = match kind {
        Kind::Running => (duration > LONGEST_RUNNING_S).then_some(RejectReason::Standing),
        _ => too_long(duration, shape, typical, usual),
    };
    if reason.is_some() {
        return reason;
    }
    if judged.beside == Beside::Shared {
        return Some(RejectReason::TwoPlates);
    }
    weak.then_some(RejectReason::PartialContact)
}

/// Reason for the rejection of a contact that is longer than one step; `None` for other contacts.
fn too_long(
    duration: f64,
    shape: &Shape,
    typical: Option<f64>,
    usual: &Usual,
) -> Option<RejectReason> {
    let longest = if usual.slow { SLOW_STEP_S } else { STANDING_S };
    if duration > longest {
        // The load of a standing person has no separate peaks.
        let walks = !usual.insoles && shape.humps >= 3 && usual.main.len() >= 3;
        return Some(if walks {
            RejectReason::CrossOver
        } else {
            RejectReason::Standing
        });
    }
    let longer = |factor: f64| typical.is_some_and(|d| duration > factor * d);
    if longer(LONG) && duration > TWO_STEPS_S {
        return Some(RejectReason::CrossOver);
    }
    let alone = usual.main.len() < 3 && duration > TWO_STEPS_S;
    // In the middle of a stance, the force of one foot has its valley. A maximum there means double support.
    if shape.peaks_in_the_middle && duration > TWO_STEPS_S && !usual.slow {
        return Some(RejectReason::CrossOver);
    }
    let both = shape.humps >= 3 && (longer(LONG_WITH_HUMPS) || alone);
    (both || shape.humps > 4 && duration > TWO_STEPS_S).then_some(RejectReason::CrossOver)
}

/// Relation of a contact to the load on the other plates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Beside {
    /// During the contact, other plates are unloaded, or they are loaded only by the other foot at the start or the end of the contact.
    Apart,
    /// The load on another plate belongs to the same foot.
    Shared,
    /// The contact is cross-talk from a foot on another plate.
    CrossTalk,
}

/// Relation of each contact to simultaneous contacts on other plates: one foot on two plates, or cross-talk between the amplifiers.
///
/// A foot can be on two belts, but not on two insoles.
pub(super) fn beside(contacts: &[Contact], shapes: &[Shape], usual: &Usual) -> Vec<Beside> {
    let mut found = vec![Beside::Apart; contacts.len()];
    for (i, a) in contacts.iter().enumerate() {
        let later = contacts.iter().enumerate().skip(i + 1);
        for (j, b) in later.take_while(|(_, b)| b.start_s < a.end_s) {
            let both = a.end_s.min(b.end_s) - b.start_s;
            let shorter = a.duration_s().min(b.duration_s());
            let together = b.end_s.max(a.end_s) - a.start_s;
            let halves = shapes[i].valley.is_none() && shapes[j].valley.is_none()
                || shapes[i].is_early() && shapes[j].is_late();
            let one_foot = halves && both > 0.1 * shorter && usual.is_one_stance(i, j, together);
            if a.channel == b.channel || both < SHARED * shorter && !one_foot {
                continue;
            }
            let (low, high) = if a.peak_n < b.peak_n { (i, j) } else { (j, i) };
            let weak = contacts[low].peak_n < CROSS_TALK * contacts[high].peak_n;
            if weak {
                found[low] = Beside::CrossTalk;
            } else if !usual.insoles && a.cut.is_none() && b.cut.is_none() {
                for k in [i, j] {
                    if found[k] == Beside::Apart {
                        found[k] = Beside::Shared;
                    }
                }
            }
        }
    }
    found
}

/// Reason for the rejection of a contact in which more than `BRIDGED_S` is missing; `None` for other contacts.
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

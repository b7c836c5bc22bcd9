//! Recognition of the kind of movement from contact times, flight phases, duty factor, peaks and repetition.
//!
//! Walking has a duty factor above one half and no flight phase. Running has a duty factor below one half and contacts of 0.1 to 0.35 s
//! (Nilsson and Thorstensson 1989; Keller et al. 1996).

use super::contact::{Contact, STANDING_S, TOUCH_S};
use super::shape::Shape;
use crate::recording::{Foot, Idle, Kind, Recording};
use crate::statistics::{mean_and_deviation, median};
use crate::units::G;

/// Minimum duration of a contact in walking, s.
const SHORT_S: f64 = 0.33;
/// Duration of a contact below which running is likely, s.
const BRISK_S: f64 = 0.42;
/// Duty factor below which the movement is running.
const RUNNING_DUTY: f64 = 0.5;
/// Maximum stride time that implies running, s.
const RUNNING_STRIDE_S: f64 = 0.6;
/// Ratio of the maximum to the mean of a force with one peak, above which the movement is not walking. The ratio is 1.57 for a half sine,
/// and about 1.25 for a walker with a single peak.
const PEAKED: f64 = 1.45;
/// Peak force, in body weights, above which the movement is not walking.
const HARD_BW: f64 = 1.75;
/// Range of the flight time of a runner, s.
const FLIGHT_S: std::ops::Range<f64> = 0.02..0.3;
/// Range of the flight time of a jump, s.
const AIRBORNE_S: std::ops::Range<f64> = 0.08..1.0;
/// Minimum duration of standing before a jump, s.
const BEFORE_JUMP_S: f64 = 0.8;
/// A flight is a jump if the peak force after it exceeds this multiple of the median force before it.
const LANDING: f64 = 1.6;
/// Maximum time from contact to the impact peak of a landing from a height, s. It is less than the time to push-off in the shortest walking
/// contact (0.32 s, which is 0.76 of `BRISK_S`). In synthetic landings, the time is 0.06 s. Measured landings were not available.
const IMPACT_S: f64 = 0.25;
/// Ratio of the impact peak to the mean force of the contact, above which the contact is a landing. It is at most 1.67 for fast walking
/// (1.7 to 2.3 m/s, Pataky et al. 2008), and 2.6 to 3.6 for synthetic landings.
const DROP: f64 = 1.9;
/// A first peak before this fraction of the contact indicates a landing. In walking, the fraction is 0.18 to 0.3.
const EARLY: f64 = 0.155;
/// Maximum number of contacts from which no rhythm can be determined.
const FEW: usize = 2;
/// Maximum time between the landings of the two feet in a jump, s.
const TOGETHER_S: f64 = 0.08;
/// A contact is a step if its peak force exceeds this fraction of the maximum force of the recording.
const MAIN: f64 = 0.4;
/// Maximum coefficient of variation of the total force in quiet standing.
const QUIET: f64 = 0.12;
/// The person is seated if the force is below this fraction of the weight.
const SEATED: f64 = 0.6;
/// Number of equally spaced times at which the total force is evaluated to determine its level.
const LOOKS: usize = 400;

/// Running, jumping or sit-to-stand, if the contacts show such a movement; `None` if the stances must determine the movement.
pub(super) fn ballistic(
    contacts: &[Contact],
    shapes: &[Shape],
    recording: &Recording,
) -> Option<Kind> {
    if lands_together(contacts, recording) {
        let stood = median(contacts.iter().map(Contact::duration_s).collect());
        let sits = stood.is_some_and(|s| s > STANDING_S);
        return Some(if sits {
            Kind::SitToStand
        } else {
            Kind::Jumping
        });
    }
    let top = contacts.iter().map(|c| c.peak_n).fold(0.0, f64::max);
    if jumps(contacts, recording) || drops(contacts, shapes, MAIN * top) {
        return Some(Kind::Jumping);
    }
    let main: Vec<(&Contact, &Shape)> = contacts
        .iter()
        .zip(shapes)
        .filter(|(c, _)| c.cut.is_none() && c.peak_n > MAIN * top)
        .filter(|(c, _)| (TOUCH_S..STANDING_S).contains(&c.duration_s()))
        .collect();
    let duration = median(main.iter().map(|(c, _)| c.duration_s()).collect())?;
    let peaked = main
        .iter()
        .filter(|(c, s)| s.valley.is_none() && peakedness(c, s) > PEAKED);
    let peaked = 2 * peaked.count() > main.len();
    let duty = duty(&main);
    let weight = recording.mass_kg.map(|m| m * G);
    let hard = weight.is_some_and(|w| top > HARD_BW * w);
    let runs = duration < SHORT_S
        || duty.is_some_and(|(duty, stride)| {
            duty < RUNNING_DUTY || duration < BRISK_S && stride < RUNNING_STRIDE_S
        })
        || duration < BRISK_S && (peaked || hard || flies(&main));
    if runs {
        return Some(Kind::Running);
    }
    // A few contacts do not show a rhythm. If their force rises immediately, they are landings of a jump on one leg.
    let lands = |(_, s): &(&Contact, &Shape)| s.p1.at < EARLY;
    if main.len() <= FEW && !main.is_empty() && main.iter().all(lands) {
        return Some(Kind::Jumping);
    }
    // Hops on the spot last as long as steps, but each has a single sharp peak.
    (peaked && main.len() >= 2).then_some(Kind::Jumping)
}

/// Kind of movement in a recording without a whole stance.
pub(super) fn without_stance(contacts: &[Contact], recording: &Recording) -> Option<Kind> {
    let constant = |i: &Idle| matches!(i, Idle::Constant { level } if level.value.abs() > 150.0);
    let stands = (recording.channels.iter()).any(|c| c.idle.as_ref().is_some_and(constant));
    let Some(longest) = (contacts.iter()).max_by(|a, b| a.duration_s().total_cmp(&b.duration_s()))
    else {
        return stands.then_some(Kind::Standing);
    };
    let duration = longest.duration_s();
    if duration < STANDING_S && !(longest.cut.is_some() && duration > 1.0) {
        return None;
    }
    let levels = levels(recording, longest.start_s, longest.end_s, LOOKS);
    let mut sorted = levels.clone();
    sorted.sort_by(f64::total_cmp);
    let at = |q: f64| sorted[((sorted.len() - 1) as f64 * q) as usize];
    let top = levels.iter().copied().fold(0.0, f64::max);
    let early = &levels[..levels.len() / 4];
    let lands = early.iter().copied().fold(0.0, f64::max) > 1.9 * at(0.5);
    if lands && longest.start_s > 0.0 {
        return Some(Kind::Jumping);
    }
    if steady(&levels) {
        return Some(Kind::Standing);
    }
    // Rising from a seat shows two constant levels: the force when seated and when standing.
    let (low, high) = (at(0.08), at(0.9));
    let near = |x: f64| {
        let close = levels.iter().filter(|l| (*l - x).abs() < 0.15 * high);
        close.count() as f64 / levels.len() as f64
    };
    let two = low < SEATED * high && near(low) > 0.08 && near(high) > 0.15 && top < 1.7 * high;
    let seated_at_an_end = longest.cut.is_some() || duration > 3.0;
    Some(if two && seated_at_an_end {
        Kind::SitToStand
    } else if steady(&levels[levels.len() / 2..]) {
        Kind::Standing
    } else {
        Kind::Other
    })
}

/// Whether several levels of force are nearly equal.
fn steady(levels: &[f64]) -> bool {
    let (mean, deviation) = mean_and_deviation(levels);
    deviation < QUIET * mean
}

/// Ratio of the maximum force to the mean force of the contact.
fn peakedness(contact: &Contact, shape: &Shape) -> f64 {
    let mean = shape.impulse_ns / contact.duration_s().max(1e-9);
    contact.peak_n / mean.max(1e-9)
}

/// Median duty factor and median stride time, s, from repeated contacts on the same channel.
fn duty(main: &[(&Contact, &Shape)]) -> Option<(f64, f64)> {
    let mut all = Vec::new();
    for (i, (a, _)) in main.iter().enumerate() {
        let next = main[i + 1..].iter().find(|(b, _)| b.channel == a.channel);
        if let Some((b, _)) = next {
            let stride = b.start_s - a.start_s;
            // A longer time between two contacts is a pause, not a swing phase.
            if stride < 3.5 * a.duration_s().max(0.15) {
                all.push((a.duration_s() / stride, stride));
            }
        }
    }
    let duties = all.iter().map(|a| a.0).collect();
    let strides = all.iter().map(|a| a.1).collect();
    Some((median(duties)?, median(strides)?))
}

/// Whether a flight phase separates most adjacent contacts on different channels.
fn flies(main: &[(&Contact, &Shape)]) -> bool {
    let pairs: Vec<f64> = main
        .windows(2)
        .filter(|w| w[0].0.channel != w[1].0.channel)
        .map(|w| w[1].0.start_s - w[0].0.end_s)
        .collect();
    let flights = pairs.iter().filter(|g| FLIGHT_S.contains(g)).count();
    flights > 0 && 2 * flights > pairs.len()
}

/// Whether the person stands, leaves the plates and lands on them again.
fn jumps(contacts: &[Contact], recording: &Recording) -> bool {
    let spans = loaded_spans(contacts);
    spans.windows(2).any(|w| {
        let ((from, to), (landing, end)) = (w[0], w[1]);
        let stood = to - from > BEFORE_JUMP_S;
        if !(stood && AIRBORNE_S.contains(&(landing - to))) {
            return false;
        }
        let Some(level) = median(levels(recording, from, to, LOOKS)) else {
            return false;
        };
        let first = levels(recording, landing, end.min(landing + 0.5), LOOKS);
        first.into_iter().fold(0.0, f64::max) > LANDING * level
    })
}

/// Whether most contacts with a peak above `least`, N, are landings from a height. In a landing, the contact is long, and the maximum force
/// occurs early and is much larger than the mean force.
fn drops(contacts: &[Contact], shapes: &[Shape], least: f64) -> bool {
    let main: Vec<bool> = contacts
        .iter()
        .zip(shapes)
        .filter(|(c, _)| c.peak_n > least && c.start_s > 0.0)
        .map(|(c, s)| {
            let at_once = s.p1.at * c.duration_s() < IMPACT_S && s.p1.force_n > 0.99 * c.peak_n;
            at_once && c.duration_s() > BRISK_S && peakedness(c, s) > DROP
        })
        .collect();
    2 * main.iter().filter(|lands| **lands).count() > main.len()
}

/// Whether most contacts of the left and the right foot begin and end at the same time.
fn lands_together(contacts: &[Contact], recording: &Recording) -> bool {
    let of = |foot: Foot| -> Vec<&Contact> {
        let own = |c: &&Contact| recording.channels[c.channel].foot == Some(foot);
        let whole = |c: &&Contact| c.cut.is_none() && c.duration_s() > TOUCH_S;
        contacts.iter().filter(own).filter(whole).collect()
    };
    let (left, right) = (of(Foot::Left), of(Foot::Right));
    let alike = |a: &Contact, b: &Contact| {
        (a.start_s - b.start_s).abs() < TOGETHER_S && (a.end_s - b.end_s).abs() < 2.0 * TOGETHER_S
    };
    // Contacts are in order of time, so the index of the partner is close in the list.
    let mut from = 0;
    let mut together = 0;
    for a in &left {
        while from < right.len() && right[from].start_s < a.start_s - TOGETHER_S {
            from += 1;
        }
        together += usize::from(right.get(from).is_some_and(|b| alike(a, b)));
    }
    together > 0 && 2 * together > left.len().max(right.len())
}

/// Time spans in which any channel is loaded, s.
fn loaded_spans(contacts: &[Contact]) -> Vec<(f64, f64)> {
    let mut spans: Vec<(f64, f64)> = Vec::new();
    for c in contacts {
        match spans.last_mut() {
            Some(last) if c.start_s <= last.1 => last.1 = last.1.max(c.end_s),
            _ => spans.push((c.start_s, c.end_s)),
        }
    }
    spans
}

/// Total force of the loaded channels, N, at `count` equally spaced times of a span.
fn levels(recording: &Recording, from_s: f64, to_s: f64, count: usize) -> Vec<f64> {
    let at = |k: usize| {
        let t = from_s + (to_s - from_s) * (k as f64 + 0.5) / count as f64;
        let i = (t * recording.rate_hz) as usize;
        let forces = recording.live().map(|(_, c)| c.force_n.get(i));
        forces.map(|f| f.copied().unwrap_or(0.0)).sum::<f64>()
    };
    (0..count).map(at).collect()
}

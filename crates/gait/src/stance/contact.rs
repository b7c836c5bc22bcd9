//! Contacts before classification: spans in which the force of a channel exceeds the contact threshold.

use super::types::RejectReason;
use crate::recording::Channel;

/// Contact threshold, N: the usual value in gait laboratories.
const CONTACT_N: f64 = 20.0;
/// A contact ends when the force falls below this fraction of the contact threshold. The fraction is less than 1, so that noise does not
/// split a stance.
const HYSTERESIS: f64 = 0.5;
/// Minimum distance between contact threshold and unloaded reading, in standard deviations of the noise.
const NOISE_MARGIN: f64 = 6.0;
/// Minimum duration of a step, s.
pub(super) const TOUCH_S: f64 = 0.1;
/// Minimum duration of standing, s.
pub(super) const STANDING_S: f64 = 1.8;
/// Maximum duration of a step of a very slow walker, s.
pub(super) const SLOW_STEP_S: f64 = 4.0;
/// Maximum duration of an interruption that does not end a contact, s.
const DIP_S: f64 = 0.04;
/// Minimum duration, s, for which the force rises monotonically after a heel strike.
const LANDING_S: f64 = 0.02;

/// Contact on one channel, before classification.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contact {
    pub channel: usize,
    pub start_s: f64,
    pub end_s: f64,
    pub peak_n: f64,
    pub cut: Option<RejectReason>,
}

impl Contact {
    pub fn duration_s(&self) -> f64 {
        self.end_s - self.start_s
    }
}

/// Contacts of a channel. The start and the end are interpolated between samples.
pub(super) fn contacts(index: usize, channel: &Channel, rate_hz: f64) -> Vec<Contact> {
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
        let cut_start = first == 0 && !lands(force.iter(), on, rate_hz);
        let cut_end = i == force.len() && !lands(force.iter().rev(), on, rate_hz);
        let contact = Contact {
            channel: index,
            start_s: if first == 0 { 0.0 } else { crossing(first - 1) },
            end_s: if last + 1 < force.len() {
                crossing(last)
            } else {
                last as f64 / rate_hz
            },
            peak_n,
            cut: match (cut_start, cut_end) {
                (true, true) if last as f64 > STANDING_S * rate_hz => {
                    Some(RejectReason::NeverUnloaded)
                }
                (true, _) => Some(RejectReason::CutAtStart),
                (false, true) => Some(RejectReason::CutAtEnd),
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
    // Fluctuations of the unloaded plate just above the threshold are not contacts.
    found.retain(|c| c.peak_n > 2.0 * on || c.duration_s() > TOUCH_S);
    found
}

/// Whether a contact at the start of a recording is complete, because the recording starts at the heel strike. This is so if the first
/// sample is just above the threshold and the force then rises fast. For a contact at the end of a recording, which must end with the
/// toe-off, `force` contains the samples in reversed order.
fn lands<'a>(force: impl Iterator<Item = &'a f64>, on: f64, rate_hz: f64) -> bool {
    let samples = ((LANDING_S * rate_hz) as usize).max(2);
    let first: Vec<f64> = force.take(samples + 1).copied().collect();
    let rises = first.windows(2).all(|w| w[1] > w[0]);
    match (first.first(), first.last()) {
        (Some(&a), Some(&b)) => a <= 1.5 * on && b > 2.0 * a && rises,
        _ => false,
    }
}

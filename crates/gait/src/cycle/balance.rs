//! Mean total force of a walker, N, over the time in which the forces of both feet are recorded.
//!
//! Over a whole stride, the mean total force equals the weight. If the plates are loaded for a whole stride, their total force is averaged
//! over the stride. Otherwise, the total force is averaged over two half strides. They follow from a stance of one foot (the first foot)
//! and the next stance of the other foot (the second foot):
//!
//! - from the previous toe-off of the second foot to the toe-off of the first foot;
//! - from the heel strike of the second foot to the next heel strike of the first foot.
//!
//! The stride time determines only the start of the first interval and the end of the second. An error in the stride time therefore hardly
//! changes the mean force.

use super::average::whole_span;
use crate::recording::Recording;
use crate::stance::{Footfall, Stances, footfalls, same_foot};
use crate::statistics::mean;

/// Maximum difference between the impulses of the two stances, as a fraction of their sum.
const UNEVEN: f64 = 0.05;

/// If the total force falls below this fraction of its mean, the plates are assumed not to record both feet all the time.
const LOADED: f64 = 0.3;
/// Maximum fraction of a stride by which a recording may be shorter than the stride.
const LACKING: f64 = 0.02;

/// Mean force of all plates, N, over whole strides. `None` for a single plate, for a recording shorter than a stride, or if the total force
/// is sometimes far below its mean.
fn mean_of_plates(recording: &Recording, period_s: f64) -> Option<f64> {
    let plates: Vec<&[f64]> = recording.live().map(|(_, c)| &c.force_n[..]).collect();
    let samples = plates.iter().map(|p| p.len()).min()?;
    let total = |i: usize| plates.iter().map(|p| p[i]).sum::<f64>();
    let total: Vec<f64> = (0..samples).map(total).collect();
    let least = LOADED * mean(&total);
    let stride = (period_s * recording.rate_hz).round();
    let length = (stride as usize).min(samples);
    let is_long = length >= 10 && length as f64 > (1.0 - LACKING) * stride;
    if plates.len() < 2 || !is_long || total.iter().any(|x| *x <= least) {
        return None;
    }
    let strides = total.windows(length).step_by((length / 4).max(1));
    Some(mean(&strides.map(mean).collect::<Vec<f64>>()))
}

/// Mean total force, N, for a given stride time, s. If the plates are not loaded for a whole stride, it is computed from pairs of
/// consecutive whole stances with similar impulses. The impulses must be similar, because two half strides of a limping walker are not
/// equivalent to a stride.
///
/// `None` for running, for a table of stances, or without such a pair.
pub(super) fn mean_total(recording: &Recording, stances: &Stances, period_s: f64) -> Option<f64> {
    if recording.has_rows() || recording.runs() {
        return None;
    }
    if let Some(force) = mean_of_plates(recording, period_s) {
        return Some(force);
    }
    let impulse = |fall: &Footfall, from_s: f64, to_s: f64| impulse(recording, fall, from_s, to_s);
    let whole = |f: &Footfall| f.rejected.is_none() && !f.unlike;
    let falls = footfalls(recording, stances);
    let in_turn = falls.windows(2).filter(|w| {
        let [a, b] = [w[0], w[1]];
        let other = same_foot(&a, &b, false) == Some(false) && a.channel != b.channel;
        whole(&a) && whole(&b) && other && b.start_s < a.end_s && a.end_s < b.end_s
    });
    let even = in_turn.filter(|w| {
        let [a, b] = [w[0], w[1]].map(|f| impulse(&f, f.start_s, f.end_s));
        (a - b).abs() < UNEVEN * (a + b)
    });
    let total = even.map(|w| {
        let [a, b] = [w[0], w[1]];
        let spans = [
            (b.end_s - period_s, a.end_s),
            (b.start_s, a.start_s + period_s),
        ];
        let both = |(from, to)| impulse(&a, from, to) + impulse(&b, from, to);
        let lengths: f64 = spans.iter().map(|(from, to)| to - from).sum();
        spans.map(both).iter().sum::<f64>() / lengths
    });
    let force = mean(&total.collect::<Vec<f64>>());
    (force.is_finite() && force > 0.0).then_some(force)
}

/// Integral of the force of a contact over a time span, N s.
fn impulse(recording: &Recording, fall: &Footfall, from_s: f64, to_s: f64) -> f64 {
    let channel = &recording.channels[fall.channel];
    let rate = recording.rate_hz;
    let (start, end) = whole_span(channel, rate, fall.start_s, fall.end_s);
    let at = |s: f64| {
        ((s.clamp(start, end) * rate).round().max(0.0) as usize).min(channel.force_n.len())
    };
    let samples = channel.force_n.get(at(from_s)..at(to_s)).unwrap_or(&[]);
    samples.iter().sum::<f64>() / rate
}

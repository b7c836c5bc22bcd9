//! Mean total force of a walker while both feet are on record, from two whole stances in turn.
//!
//! Over a stride it is the weight. Two stances in turn show the total force from the toe-off of the foot before to that of
//! the first, and from the heel strike of the second to the next one: two half strides. Their mean force hardly depends on
//! the stride time, which only places their outer ends; the impulse of both stances over the stride time does.

use super::average::whole_span;
use crate::recording::Recording;
use crate::stance::{Footfall, Stances, footfalls, same_foot};
use crate::statistics::mean;

/// Largest part of their sum by which the impulses of two stances may differ.
const UNEVEN: f64 = 0.05;

/// Mean total force, N, at a stride time; `None` without two whole stances in turn that carry alike: of a limping walker
/// two half strides are no whole one.
pub(super) fn mean_total(recording: &Recording, stances: &Stances, period_s: f64) -> Option<f64> {
    if recording.has_rows() || recording.runs() {
        return None;
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

/// Integral of the force of a contact within a span, N s.
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

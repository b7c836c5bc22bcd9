//! One cycle from a recorded stance that fills only a part of the turn.

use std::f64::consts::TAU;

use super::average::{Mean, at, whole_span};
use super::single::stances_of;
use crate::curve::{ForceCurve, SAMPLES};
use crate::error::Result;
use crate::quantity::seconds;
use crate::recording::{Feet, Note, Recording};
use crate::stance::{Stance, Stances};
use crate::statistics::mean;

/// A stance counts as the whole recording if it fills more than this fraction of the recording.
const WHOLE: f64 = 0.97;

/// The mean stance is not stretched if its duration differs from the duration of the span by less than this fraction.
const NEARLY: f64 = 0.05;

/// One cycle in which the mean stance fills a span, rad, and the force is zero in the rest of the turn. `None` without a whole stance, or
/// if the only stance is the whole recording.
///
/// Without a `period`, s, the duration of the stance is unchanged. `feet` only selects the stances of one side, because the span contains
/// one stance.
///
/// # Errors
///
/// The period is not positive; there is no stance of this side.
pub fn stance_in_span(
    name: &str,
    recording: &Recording,
    stances: &Stances,
    span_rad: f64,
    period_s: Option<f64>,
    feet: Feet,
) -> Result<Option<ForceCurve>> {
    if stances.used.is_empty() {
        return Ok(None);
    }
    let used = stances_of(stances, feet.foot())?;
    let rate = recording.rate_hz;
    let whole = |s: &Stance| whole_span(&recording.channels[s.channel], rate, s.start_s, s.end_s);
    let spans: Vec<(f64, f64)> = used.iter().map(|s| whole(s)).collect();
    let durations: Vec<f64> = spans.iter().map(|(from, to)| to - from).collect();
    let is_whole = durations.len() == 1 && durations[0] > WHOLE * recording.duration_s;
    let (Some(&(from, to)), false) = (spans.first(), is_whole) else {
        return Ok(None);
    };
    let mut average = Mean::new();
    let mut row = vec![0.0; SAMPLES];
    for (stance, (from, to)) in used.iter().zip(&spans) {
        let force = &recording.channels[stance.channel].force_n;
        for (k, x) in row.iter_mut().enumerate() {
            let share = k as f64 / (SAMPLES - 1) as f64;
            *x = at(force, (from + share * (to - from)) * rate);
        }
        average.add(&row);
    }
    let (stance, spread) = average.finish();
    let span = span_rad / TAU;
    let period = period_s.unwrap_or(mean(&durations) / span);
    // A stance that nearly fills the span is not stretched, so that its impulse is unchanged.
    let own = mean(&durations) / period;
    let share = if (own / span - 1.0).abs() < NEARLY {
        own
    } else {
        span
    };
    let over_turn = |row: &[f64]| -> Vec<f64> {
        let phase = |k: usize| k as f64 / SAMPLES as f64 / share;
        let force = |x: f64| {
            if x > 1.0 {
                0.0
            } else {
                at(row, x * (SAMPLES - 1) as f64)
            }
        };
        (0..SAMPLES).map(|k| force(phase(k))).collect()
    };
    let mut curve = ForceCurve::from_samples(name, period, over_turn(&stance))?;
    curve.spread_n = spread.map(|spread| over_turn(&spread));
    curve.mass_kg = recording.mass_kg;
    let noise = |s: &&Stance| recording.channels[s.channel].noise_n.powi(2);
    let count = used.len() as f64;
    curve.noise_n = Some((share * used.iter().map(noise).sum::<f64>()).sqrt() / count);
    let [from, to] = [from, to].map(|t| seconds(recording.start_s + t));
    let stances = used.len();
    curve.notes = recording.notes.clone();
    curve
        .notes
        .push(Note::StanceFillsSpan { stances, from, to });
    Ok(Some(curve))
}

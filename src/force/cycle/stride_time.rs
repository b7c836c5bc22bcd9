//! How long a stride lasts, where it was built from single stances.

use super::average::MeanStance;
use crate::force::note::PeriodSource;
use crate::force::recording::{Foot, Recording};
use crate::force::stance::{Stances, footfalls, same_foot};
use crate::units::G;

/// Part of a stride that a foot is on the ground, where nothing in the recording says it (normal walking).
const DUTY: f64 = 0.62;

/// Whether the recording is a table of single stances.
pub(super) fn has_rows(recording: &Recording) -> bool {
    recording.channels.iter().any(|c| !c.rows.is_empty())
}

/// Duration of a stride, s, and what it was taken from.
///
/// One foot's own consecutive heel strikes give it, else those that the file marks, else doubled steps; else a
/// known mass, since both feet together carry it (impulse of both = M g T); else the usual part of a stride that
/// a foot stands.
pub(super) fn stride_time(
    recording: &Recording,
    stances: &Stances,
    impulse_ns: f64,
    stance: &MeanStance,
) -> (f64, PeriodSource) {
    if !has_rows(recording) {
        let strikes = strikes(recording, stances, stance.duration_s);
        if let Some(found) = strikes {
            return found;
        }
    }
    if let Some(mass) = recording.mass_kg {
        let period = impulse_ns / (mass * G);
        // A stride shorter than its stance or longer than a pause tells of a wrong mass.
        if (1.1..3.0).contains(&(period / stance.duration_s)) {
            return (period, PeriodSource::Impulse);
        }
    }
    (stance.duration_s / DUTY, PeriodSource::UsualDuty)
}

/// Duration of a stride from heel strikes, s.
fn strikes(recording: &Recording, stances: &Stances, stance_s: f64) -> Option<(f64, PeriodSource)> {
    let falls = footfalls(recording, stances);
    let is_stride = |s: f64| (1.0..2.5).contains(&(s / stance_s));
    // Feet that land together (a jump, standing) are not in step.
    let is_step = |s: f64| (0.4..1.2).contains(&(s / stance_s));
    let mut own: Vec<f64> = Vec::new();
    let mut steps: Vec<f64> = Vec::new();
    // The step before, if the foot changed with it.
    let mut before = None;
    for w in falls.windows(2) {
        let time = w[1].start_s - w[0].start_s;
        let step = match same_foot(&w[0], &w[1]) {
            Some(true) if is_stride(time) => {
                own.push(time);
                None
            }
            Some(false) if is_step(time) => Some(time),
            _ => None,
        };
        if let (Some(a), Some(b)) = (before, step) {
            own.push(a + b);
        }
        steps.extend(step);
        before = step;
    }
    if let Some(stride) = median(own) {
        return Some((stride, PeriodSource::HeelStrikes));
    }
    let marked = marked_strides(recording).into_iter();
    if let Some(stride) = median(marked.filter(|s| is_stride(*s)).collect()) {
        return Some((stride, PeriodSource::MarkedStrikes));
    }
    let mean = steps.iter().sum::<f64>() / steps.len() as f64;
    (!steps.is_empty()).then_some((2.0 * mean, PeriodSource::DoubledSteps))
}

/// Times between the strikes of either foot that the file marks, s.
fn marked_strides(recording: &Recording) -> Vec<f64> {
    let of = |foot: Foot| -> Vec<f64> {
        let own = recording.strikes.iter().filter(|s| s.foot == foot);
        own.map(|s| s.at_s).collect()
    };
    let pairs = [of(Foot::Left), of(Foot::Right)];
    let times = pairs.iter().flat_map(|at| at.windows(2));
    times.map(|w| w[1] - w[0]).collect()
}

/// The middle value, or the mean of the two middle ones.
pub(super) fn median(mut v: Vec<f64>) -> Option<f64> {
    v.sort_by(f64::total_cmp);
    let (a, b) = (v.len().checked_sub(1)? / 2, v.len() / 2);
    Some(0.5 * (v[a] + v[b]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_of_two_is_their_mean() {
        assert_eq!(median(vec![1.2, 1.0]), Some(1.1));
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(Vec::new()), None);
    }
}

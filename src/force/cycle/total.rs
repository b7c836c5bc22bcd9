//! Walking on one plate that both feet share, as on a treadmill with one belt: the total force, never zero.

use super::average::{Mean, at, periodic};
use crate::force::curve::SAMPLES;
use crate::force::recording::Recording;
use crate::force::stance::{RejectReason, Rejected, Stances};

/// A total force that moves less than this part of its mean is standing.
const STEADY: f64 = 0.05;
/// Steps whose duration is further than this from the middle one are not averaged.
const ODD_STEP: f64 = 0.25;
/// Fewest regular steps that make a walk.
const FEWEST_STEPS: usize = 6;
/// Part of a stride about its ends over which it is blended with its neighbours.
const BLEND: f64 = 0.04;
/// Durations of a step that a walker can keep, s.
const STEP_S: std::ops::Range<f64> = 0.3..1.2;

/// The mean stride of a total force.
pub(super) struct TotalStride {
    pub period_s: f64,
    pub force_n: Vec<f64>,
    pub spread_n: Option<Vec<f64>>,
    pub strides: usize,
}

/// Averages the strides of a channel that is loaded throughout, or from the moment it is stepped on;
/// `None` where nobody walks on it.
///
/// A step is the time between two rises of the force through its mean; a stride is two steps, so that
/// a difference between the feet is kept. Which foot begins is not known.
pub(super) fn total_stride(recording: &Recording, stances: &Stances) -> Option<TotalStride> {
    let long = |r: &&Rejected| {
        let lasting = matches!(
            r.reason,
            RejectReason::NeverUnloaded
                | RejectReason::Standing
                | RejectReason::CrossOver
                | RejectReason::CutAtStart
                | RejectReason::CutAtEnd
        );
        lasting && r.to_s - r.from_s > FEWEST_STEPS as f64 * STEP_S.start
    };
    let loaded = (stances.rejected.iter().filter(long))
        .max_by(|a, b| (a.to_s - a.from_s).total_cmp(&(b.to_s - b.from_s)))?;
    let whole = &recording.channels.get(loaded.channel)?.force_n;
    let sample = |s: f64| ((s * recording.rate_hz) as usize).min(whole.len());
    let force = match loaded.reason {
        RejectReason::NeverUnloaded => &whole[..],
        _ => &whole[sample(loaded.from_s)..sample(loaded.to_s)],
    };
    let n = force.len() as f64;
    let mean = force.iter().sum::<f64>() / n;
    let deviation = (force.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n).sqrt();
    if deviation < STEADY * mean {
        return None;
    }
    let rises = rises(force, mean, 0.5 * deviation);
    let steps: Vec<f64> = rises
        .windows(2)
        .map(|w| (w[1] - w[0]) / recording.rate_hz)
        .collect();
    let mut sorted = steps.clone();
    sorted.sort_by(f64::total_cmp);
    let usual = *sorted.get(sorted.len() / 2)?;
    let regular = |s: &f64| (s / usual - 1.0).abs() < ODD_STEP;
    let count = steps.iter().filter(|s| regular(s)).count();
    if !STEP_S.contains(&usual) || count < FEWEST_STEPS || 4 * count < 3 * steps.len() {
        return None;
    }
    let mut average = Mean::new();
    let mut row = vec![0.0; SAMPLES];
    let (mut period, mut strides) = (0.0, 0usize);
    for (pair, ends) in steps.windows(2).zip(rises.windows(3)).step_by(2) {
        if !pair.iter().all(regular) {
            continue;
        }
        // All in samples; the recording goes on beyond both ends.
        let length = ends[2] - ends[0];
        let half = (BLEND * length).min(ends[0]).min(n - 1.0 - ends[2]);
        periodic(&mut row, ends[0], length, half, |t| at(force, t));
        average.add(&row);
        period += pair[0] + pair[1];
        strides += 1;
    }
    let (force_n, spread_n) = average.finish();
    (strides > 0).then(|| TotalStride {
        period_s: period / strides as f64,
        force_n,
        spread_n,
        strides,
    })
}

/// Places, in samples, where the force rises through a level after having been `margin` below it.
fn rises(force: &[f64], level: f64, margin: f64) -> Vec<f64> {
    let mut places = Vec::new();
    let mut low = false;
    let mut crossing = None;
    for (i, w) in force.windows(2).enumerate() {
        low |= w[0] < level - margin;
        if low && w[0] <= level && w[1] > level {
            crossing = Some(i as f64 + (level - w[0]) / (w[1] - w[0]));
        }
        // The rise counts once the force is as far above.
        if low && w[1] > level + margin {
            places.extend(crossing.take());
            low = false;
        }
    }
    places
}

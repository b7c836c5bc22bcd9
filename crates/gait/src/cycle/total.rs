//! Strides of a person who walks on one plate with both feet, as on a treadmill with one belt. The total force is never zero.

use super::Average;
use super::average::{BLEND, Mean, at, periodic};
use crate::curve::SAMPLES;
use crate::quantity::seconds;
use crate::recording::{CycleSource, Note, PeriodSource, Recording};
use crate::stance::{RejectReason, Rejected, Stances, footfalls};
use crate::statistics::{mean, mean_and_deviation, ranked};
use crate::walk::Walk;

/// The person is standing if the coefficient of variation of the total force is below this value.
const STEADY: f64 = 0.05;
/// A step is not averaged if its duration differs from the median by more than this fraction.
const ODD_STEP: f64 = 0.25;
/// Minimum number of regular steps in a recording of walking.
const FEWEST_STEPS: usize = 5;
/// Range of step durations of a walker, s.
const STEP_S: std::ops::Range<f64> = 0.3..1.2;
/// Range of step durations of a runner, s.
const RUNNING_STEP_S: std::ops::Range<f64> = 0.15..0.55;
/// Step duration, s, and relative variation of the total force. If both values are exceeded, the periodic force is not walking.
const SLOW: (f64, f64) = (0.85, 0.25);

/// Averages the strides of a channel that is loaded from the first sample, or from the moment at which the walker steps on the plate.
/// `None` without a periodic total force.
///
/// The force is smoothed over half a step. A step is the time between two moments at which the smoothed force rises through its mean. A
/// stride is two steps, so that a difference between the feet remains visible. It is unknown which foot is the first.
///
/// If `stated`, the user states that the column is the total of both feet. This total may fall to zero.
pub(super) fn total_stride(
    recording: &Recording,
    stances: &Stances,
    stated: bool,
) -> Option<Average> {
    let force = if stated {
        stated_total(recording, stances)?
    } else {
        lasting_load(recording, stances)?
    };
    strides_of(force, recording)
}

/// Minimum total force of a walker on the plates, as a fraction of the mean.
const ON_THE_PLATES: f64 = 0.3;

/// Averages the strides of the sum of all plates from the first to the last contact. Feet may cross two plates, as on the belts of a
/// treadmill. `None` if the plates do not carry the walker all the time, or if the sum is not periodic.
pub(super) fn total_of_plates(recording: &Recording, stances: &Stances) -> Option<Average> {
    let (from, to) = first_to_last(recording, stances, |_| true)?;
    let count = recording.live().map(|(_, c)| c.force_n.len()).min()?;
    let sample = |s: f64| ((s * recording.rate_hz) as usize).min(count);
    let mut sum = vec![0.0; sample(to).checked_sub(sample(from))?];
    for (_, channel) in recording.live() {
        for (sum, f) in sum.iter_mut().zip(&channel.force_n[sample(from)..]) {
            *sum += f;
        }
    }
    let lowest = sum.iter().copied().fold(f64::INFINITY, f64::min);
    if lowest < ON_THE_PLATES * mean(&sum) {
        return None;
    }
    strides_of(&sum, recording)
}

/// Time span, s, from the start of the first contact to the end of the last contact on the included channels.
fn first_to_last(
    recording: &Recording,
    stances: &Stances,
    counts: impl Fn(usize) -> bool,
) -> Option<(f64, f64)> {
    let all = footfalls(recording, stances).into_iter();
    all.filter(|f| counts(f.channel))
        .map(|f| (f.start_s, f.end_s))
        .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}

/// Force of the channel with the total force, from its first contact to its last contact.
fn stated_total<'a>(recording: &'a Recording, stances: &Stances) -> Option<&'a [f64]> {
    let mut live = recording.live();
    let (index, channel) = live.next().filter(|_| live.next().is_none())?;
    let (from, to) = first_to_last(recording, stances, |c| c == index)?;
    let sample = |s: f64| ((s * recording.rate_hz) as usize).min(channel.force_n.len());
    channel.force_n.get(sample(from)..sample(to))
}

/// Force during the longest rejected contact that is too long for one foot; `None` without such a contact.
fn lasting_load<'a>(recording: &'a Recording, stances: &Stances) -> Option<&'a [f64]> {
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
    Some(match loaded.reason {
        RejectReason::NeverUnloaded => &whole[..],
        _ => &whole[sample(loaded.from_s)..sample(loaded.to_s)],
    })
}

fn strides_of(force: &[f64], recording: &Recording) -> Option<Average> {
    let n = force.len() as f64;
    let (level, deviation) = mean_and_deviation(force);
    if deviation < STEADY * level {
        return None;
    }
    let range = if recording.runs() {
        RUNNING_STEP_S
    } else {
        STEP_S
    };
    let step_s = step_by_repetition(force, level, recording.rate_hz, &range)?;
    // Averaging over half a step preserves the first harmonic of the step frequency, for any shape of the peaks.
    let half = ((0.5 * step_s * recording.rate_hz) as usize).max(1);
    let rises = rises(force, half, level, 0.25 * deviation);
    let steps: Vec<f64> = rises
        .windows(2)
        .map(|w| (w[1] - w[0]) / recording.rate_hz)
        .collect();
    let usual = ranked(steps.clone(), steps.len() / 2)?;
    let regular = |s: &f64| (s / usual - 1.0).abs() < ODD_STEP;
    let count = steps.iter().filter(|s| regular(s)).count();
    if usual > SLOW.0 && deviation > SLOW.1 * level {
        return None;
    }
    if !range.contains(&usual) || count < FEWEST_STEPS || 4 * count < 3 * steps.len() {
        return None;
    }
    let mut average = Mean::new();
    let mut row = vec![0.0; SAMPLES];
    let mut durations: Vec<f64> = Vec::new();
    let mut strikes: Vec<[f64; 3]> = Vec::new();
    for (pair, ends) in steps.windows(2).zip(rises.windows(3)).step_by(2) {
        if !pair.iter().all(regular) {
            continue;
        }
        // All values are in samples. The blend uses samples beyond both ends of the stride, so its half width is limited by the recording.
        let length = ends[2] - ends[0];
        let half = (BLEND * length).min(ends[0]).min(n - 1.0 - ends[2]);
        periodic(&mut row, ends[0], length, half, |t| at(force, t));
        average.add(&row);
        durations.push(pair[0] + pair[1]);
        strikes.push([0, 1, 2].map(|k| ends[k] / recording.rate_hz));
    }
    // Because at least three of four steps are regular, at least one pair consists of regular steps.
    let strides = durations.len();
    let source = CycleSource::TotalForce { strides };
    let from = PeriodSource::TotalForce;
    let note = other_speeds(&steps, usual, n / recording.rate_hz);
    let walk = Walk::of(&strikes, false, |_, t| at(force, t * recording.rate_hz));
    Some(Average {
        note,
        walk,
        ..Average::of_cycles(average, &durations, from, source)
    })
}

/// Maximum fraction of the duration of a recording that may be without regular steps. Above this fraction, a note is added.
const OTHER_SPEED: f64 = 0.15;

/// Note that the regular steps do not fill the duration of the force, s; `None` if they do. One step at either end may be missing. The
/// other steps were not detected, are irregular, or have another speed.
fn other_speeds(steps: &[f64], usual: f64, duration_s: f64) -> Option<Note> {
    let regular = || steps.iter().filter(|s| (*s / usual - 1.0).abs() < ODD_STEP);
    // A step of double duration consists of two steps at this speed. The rise between them was too small to be detected.
    let doubled = (steps.iter()).filter(|s| (0.5 * *s / usual - 1.0).abs() < ODD_STEP);
    let used = regular().count();
    let stances = (duration_s / usual) as usize;
    let changes = (used + 2 * doubled.count() + 2) as f64 <= (1.0 - OTHER_SPEED) * stances as f64;
    changes.then(|| Note::SpeedChanges {
        used,
        stances,
        low: seconds(regular().copied().fold(f64::INFINITY, f64::min)),
        high: seconds(regular().copied().fold(0.0, f64::max)),
    })
}

/// Maximum duration of a total force that is searched for repetition, s, and sampling rate for this search, Hz.
const LOOKED_AT: (f64, f64) = (60.0, 100.0);
/// Minimum autocorrelation of a total force at a lag of one step.
const REPEATS: f64 = 0.3;
/// Fraction of the maximum autocorrelation above which a shorter lag counts as the step. The lag of the maximum is then a multiple of the
/// step.
const NEARLY: f64 = 0.8;

/// Duration of a step, s, from the lag of the maximum autocorrelation; `None` if the force is not periodic.
fn step_by_repetition(
    force: &[f64],
    mean: f64,
    rate_hz: f64,
    range: &std::ops::Range<f64>,
) -> Option<f64> {
    let thin = ((rate_hz / LOOKED_AT.1) as usize).max(1);
    let rate = rate_hz / thin as f64;
    let most = (LOOKED_AT.0 * rate) as usize;
    let x: Vec<f64> = force
        .iter()
        .step_by(thin)
        .take(most)
        .map(|f| f - mean)
        .collect();
    let power = x.iter().map(|x| x * x).sum::<f64>() / x.len() as f64;
    let lags = (range.start * rate) as usize..((range.end * rate) as usize).min(x.len() / 2);
    let first = lags.start;
    let likeness: Vec<f64> = lags
        .map(|lag| {
            let pairs = x.iter().zip(&x[lag..]);
            pairs.map(|(a, b)| a * b).sum::<f64>() / ((x.len() - lag) as f64 * power)
        })
        .collect();
    let best = likeness.iter().copied().fold(0.0, f64::max);
    let is_crest = |k: usize| {
        let at = |k: usize| likeness.get(k).copied().unwrap_or(f64::NEG_INFINITY);
        k > 0 && at(k) >= at(k - 1) && at(k) > at(k + 1) && at(k) > NEARLY * best
    };
    let crest = (0..likeness.len()).find(|&k| is_crest(k))?;
    (best > REPEATS).then(|| (first + crest) as f64 / rate)
}

/// Positions, in samples, at which a moving mean over about `half` samples rises through `level`. The mean must first be more than `margin`
/// below the level and then more than `margin` above it.
fn rises(force: &[f64], half: usize, level: f64, margin: f64) -> Vec<f64> {
    let width = half.max(2) / 2;
    let count = (2 * width + 1) as f64;
    let mut places = Vec::new();
    let mut low = false;
    let mut crossing = None;
    if force.len() <= 2 * width + 1 {
        return places;
    }
    let mut sum: f64 = force[..2 * width + 1].iter().sum();
    for i in width + 1..force.len() - width {
        let before = sum / count;
        sum += force[i + width] - force[i - width - 1];
        let now = sum / count;
        low |= before < level - margin;
        if low && before <= level && now > level {
            crossing = Some((i - 1) as f64 + (level - before) / (now - before));
        }
        // The rise is accepted when the moving mean exceeds the level by the margin.
        if low && now > level + margin {
            places.extend(crossing.take());
            low = false;
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rise_is_placed_between_the_samples_that_it_crosses() {
        // The means over three samples are 0 … 0, 1, 2, 3 … 3, and back. They cross 0.5 between samples 4 and 5, and between samples 11 and
        // 12.
        let low = [0.0; 6];
        let force = [&low[..], &[3.0; 4], &low[..3], &[3.0; 5]].concat();
        assert_eq!(rises(&force, 2, 0.5, 0.4), [4.5, 11.5]);
    }
}

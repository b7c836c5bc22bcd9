//! Conversion of raw plate readings to upward force: missing samples, sign, unloaded baseline, constant channels.

mod clipped;
mod drift;
mod missing;

use crate::quantity::{newtons, seconds};
use crate::recording::{Channel, Idle, Note};
use crate::statistics::{ends, mean_and_deviation, median, ranked, sample};
use clipped::clipped;
use drift::{SMALLEST_N, drift};
use missing::fill;

/// A channel is nearly constant if its maximum and minimum readings differ by less than this value, N.
const TOUCHED_N: f64 = 30.0;

/// In a recording shorter than this duration, s, a nearly constant reading may be a load.
const STEP_S: f64 = 0.4;

/// A level above this fraction of the maximum reading is a load.
const LOADED: f64 = 0.15;

/// Factor by which the number of readings may increase if the unloaded band is twice as wide. Above this factor, the band is too narrow.
const BROAD: f64 = 1.2;

/// Constants for a span with a nearly constant reading, from which the unloaded level is computed. The first two are its minimum duration,
/// s, and the duration of each end that is omitted, s. The third is the minimum difference, N, between its mean and the most frequent
/// level.
const REST: (f64, f64, f64) = (0.2, 0.05, 1.0);

/// Duration of each end of a recording that is examined, s, and a difference of levels, N. If the unloaded level during the walk exceeds
/// the level at the ends by more than this difference, a note is added.
const ENDS: (f64, f64) = (0.2, 8.0);

/// Maximum number of readings from which baseline and sign are determined. Longer recordings are thinned evenly.
const SAMPLE: usize = 1 << 15;

/// Maximum number of readings that are examined for clipping, and the sampling rate, Hz, to which faster readings are thinned.
const CLIPPED: (usize, f64) = (1 << 14, 200.0);

/// Converts raw readings in newtons, of either sign, to a channel. NaN means a missing sample.
///
/// The sign is chosen so that the load is positive. The unloaded baseline is the most frequent level at the unloaded end of the range of
/// readings. If there is no such level, it is the mean of the samples in `zero` (first, one past the last), if these vary little. `zero`
/// contains the samples that the file marks as unloaded. A constant channel is marked as idle, and its readings are unchanged.
pub(super) fn channel(
    name: String,
    mut raw: Vec<f64>,
    rate_hz: f64,
    zero: Option<(usize, usize)>,
    notes: &mut Vec<Note>,
) -> Channel {
    let filled = fill(&mut raw, rate_hz);
    let missing: usize = filled.bridged.iter().map(|(a, b)| b - a).sum();
    let at = |(count, i): (usize, usize)| (name.clone(), count, seconds(i as f64 / rate_hz));
    if filled.unloaded {
        let column = name.clone();
        notes.push(Note::MissingIsUnloaded { column });
    }
    if let Some((column, count, first)) = filled.spikes.map(at) {
        notes.push(Note::SpikesRemoved {
            column,
            count,
            first,
        });
    }
    if let Some((column, count, first)) = filled.drop_outs.map(at) {
        notes.push(Note::DropOuts {
            column,
            count,
            first,
        });
    }
    let samples = raw.len();
    let mut out = Channel {
        name,
        force_n: raw,
        missing: filled.bridged,
        ..Channel::default()
    };
    if 2 * missing > samples {
        out.idle = Some(Idle::MostlyEmpty { missing, samples });
        return out;
    }
    let slope = drift(&out.force_n, rate_hz);
    let drifts = (slope * samples as f64).abs() > SMALLEST_N;
    let removed = if drifts { slope } else { 0.0 };
    let step = samples / SAMPLE + 1;
    let mut thin = sample(&out.force_n, SAMPLE);
    without(&mut thin, removed * step as f64);
    out.idle = idle(&thin, samples as f64 / rate_hz);
    if out.idle.is_some() {
        return out;
    }
    let sign = if loads_downwards(&thin) { -1.0 } else { 1.0 };
    without(&mut out.force_n, removed);
    if sign < 0.0 {
        for x in out.force_n.iter_mut().chain(&mut thin) {
            *x = -*x + 0.0; // avoids signed zeros
        }
    }
    let found = baseline(&thin, &out.force_n, rate_hz);
    let every = ((rate_hz / CLIPPED.1) as usize).max(1);
    let some = out.force_n.iter().step_by(every).take(CLIPPED.0).copied();
    let mut even: Vec<f64> = some.collect();
    without(&mut even, sign * (slope - removed) * every as f64);
    let stops = clipped(&even, rate_hz / every as f64, found.map_or(0.0, |f| f.1));
    let note = |level: f64| (out.name.clone(), newtons(level));
    if let Some((column, level)) = stops.map(note) {
        notes.push(Note::Clipped { column, level });
    }
    if drifts {
        let (column, rise) = note(sign * slope * rate_hz);
        notes.push(Note::DriftRemoved { column, rise });
    }
    if let Some((level, noise)) = found.or_else(|| quiet(out.force_n.get(zero?.0..zero?.1)?)) {
        if let Some(at_ends) = level_at_ends(&out.force_n, rate_hz).filter(|l| level - l > ENDS.1) {
            let (column, level) = note(level);
            let at_ends = newtons(at_ends);
            notes.push(Note::UnloadedDiffers {
                column,
                level,
                at_ends,
            });
        }
        out.baseline_n = level;
        out.noise_n = noise;
        for x in &mut out.force_n {
            *x -= level;
        }
    }
    out
}

/// Subtracts a drift, N per sample, from the readings.
fn without(readings: &mut [f64], slope: f64) {
    if slope != 0.0 {
        for (i, x) in readings.iter_mut().enumerate() {
            *x -= slope * i as f64;
        }
    }
}

/// Reason for excluding a channel with these readings; `None` if it is included.
fn idle(thin: &[f64], duration_s: f64) -> Option<Idle> {
    let Some((low, high)) = ends(thin) else {
        return Some(Idle::Empty);
    };
    // Within a fraction of a step, even the load of a plate is nearly constant.
    let is_brief = duration_s < STEP_S && high > low;
    let level = if high - low < TOUCHED_N && !is_brief {
        let level = ranked(thin.to_vec(), thin.len() / 2)?;
        if level.abs() < 3.0 * TOUCHED_N {
            return Some(Idle::NeverLoaded);
        }
        level
    } else {
        stuck_level(thin)?
    };
    let level = newtons(level);
    Some(Idle::Constant { level })
}

/// Large value that most samples have exactly and that no sample clearly exceeds, as in a saturated amplifier.
///
/// Quiet standing has no such value, because the force is larger when the person lands or rises before standing. Method: majority vote of
/// Boyer and Moore (1991).
fn stuck_level(thin: &[f64]) -> Option<f64> {
    let (most, _) = thin.iter().fold((0.0, 0), |(most, votes), &x| match votes {
        0 => (x, 1),
        _ if x == most => (most, votes + 1),
        _ => (most, votes - 1),
    });
    let same = || thin.iter().filter(|&&x| x == most).count();
    let exceeded = || (thin.iter()).any(|x| x * most.signum() > most.abs() + TOUCHED_N);
    (most.abs() > 10.0 * TOUCHED_N && 2 * same() > thin.len() && !exceeded()).then_some(most)
}

/// Whether the loaded readings are negative. If the readings extend much further to one side of zero, this side is the load. Otherwise the
/// unloaded end of the range is the end with the higher density of readings.
fn loads_downwards(thin: &[f64]) -> bool {
    let (low, high) = ends(thin).unwrap_or_default();
    if low >= 0.0 || low.abs() < 0.2 * high.abs() {
        return false;
    }
    if high <= 0.0 || high.abs() < 0.2 * low.abs() {
        return true;
    }
    let (band, part) = (0.04 * (high - low), 0.3 * (high - low));
    crowd(thin, high - part, high, band).1 > crowd(thin, low, low + part, band).1
}

/// Level between `from` and `to` with the maximum number of samples within half a `band`, and this number of samples.
fn crowd(thin: &[f64], from: f64, to: f64, band: f64) -> (f64, usize) {
    let is_near = |x: &f64| (from..=to + band).contains(x);
    let mut sorted: Vec<f64> = thin.iter().copied().filter(is_near).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let mut best = (from, 0);
    let mut end = 0;
    for (start, &x) in sorted.iter().enumerate() {
        while end < sorted.len() && sorted[end] <= x + band {
            end += 1;
        }
        if x <= to && end - start > best.1 {
            best = (sorted[(start + end) / 2], end - start);
        }
    }
    best
}

/// Unloaded level and its standard deviation, N, for readings whose load is positive; `None` if the plate was never unloaded.
///
/// At least 4 % of the samples must be at the level. A level far from zero must also last for a fifth of a second. A constant reading under
/// a loaded foot does not last so long.
fn baseline(thin: &[f64], force: &[f64], rate_hz: f64) -> Option<(f64, f64)> {
    let (low, high) = ends(thin)?;
    let range = high - low;
    let band = (0.03 * range).max(6.0);
    let (level, count) = crowd(thin, low, low + 0.3 * range, band);
    if count * 25 < thin.len() || count < 5 {
        return None;
    }
    if level.abs() > (0.1 * range).max(30.0) {
        // The level is a load, not an offset, if it is far above zero, or if readings are clearly below it when the plate is unloaded.
        let below = thin.iter().filter(|x| **x < level - band).count();
        if level > LOADED * high || level > 0.0 && 200 * below > thin.len() {
            return None;
        }
        let held = (0.2 * rate_hz).max(3.0) as usize;
        if longest_run(force, level - 0.5 * band, level + 0.5 * band) < held {
            return None;
        }
    }
    // Mains hum is wider than the band, and its most frequent readings are at the ends of the band. The level is then the median of the
    // readings in the band.
    let near = thin.iter().copied().filter(|x| (x - level).abs() <= band);
    let near: Vec<f64> = near.collect();
    let level = match median(near.clone()) {
        Some(middle) if near.len() as f64 > BROAD * count as f64 => middle,
        _ => level,
    };
    let rest = resting_level(force, level, 2.0 * band, rate_hz);
    let level = rest
        .filter(|rest| (rest - level).abs() > REST.2)
        .unwrap_or(level);
    let off = near.iter().map(|x| (x - level).abs());
    let off: Vec<f64> = off.filter(|d| *d <= band).collect();
    let middle = off.len() / 2;
    Some((level, 1.4826 * ranked(off, middle)?))
}

/// Mean reading, N, of all spans in which the reading stays near a level; `None` if there is no such span. The first and the last 0.05 s of
/// a span, in which a foot lands or leaves, are omitted. At least 0.2 s must remain.
fn resting_level(force: &[f64], level: f64, band: f64, rate_hz: f64) -> Option<f64> {
    let edge = (REST.1 * rate_hz) as usize;
    let spans = force.chunk_by(|a, b| (a - level).abs() <= band && (b - level).abs() <= band);
    let quiet = spans.filter(|span| span.len() as f64 > REST.0 * rate_hz + 2.0 * edge as f64);
    let quiet: Vec<f64> = quiet
        .flat_map(|s| &s[edge..s.len() - edge])
        .copied()
        .collect();
    (!quiet.is_empty()).then(|| mean_and_deviation(&quiet).0)
}

/// Mean level and standard deviation, N, of samples that should be unloaded. `None` if the samples vary or their mean is 100 N or more.
fn quiet(force: &[f64]) -> Option<(f64, f64)> {
    let (mean, deviation) = mean_and_deviation(force);
    (force.len() >= 2 && deviation < 5.0 && mean.abs() < 100.0).then_some((mean, deviation))
}

/// Unloaded level, N, at both ends of a recording; `None` if the ends are loaded or differ.
fn level_at_ends(force: &[f64], rate_hz: f64) -> Option<f64> {
    let count = (ENDS.0 * rate_hz) as usize;
    let first = quiet(force.get(..count)?)?;
    let last = quiet(&force[force.len() - count..])?;
    ((first.0 - last.0).abs() < 3.0).then_some(0.5 * (first.0 + last.0))
}

fn longest_run(force: &[f64], low: f64, high: f64) -> usize {
    let mut longest = 0;
    let mut run = 0;
    for x in force {
        run = if (low..=high).contains(x) { run + 1 } else { 0 };
        longest = longest.max(run);
    }
    longest
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Ten stances of 0.6 s in strides of 1 s at 100 Hz, with a peak of 800 N.
    fn walk() -> Vec<f64> {
        let foot = |i: usize| {
            let t = (i % 100) as f64 / 60.0;
            if t < 1.0 { 800.0 * (PI * t).sin() } else { 0.0 }
        };
        (0..1000).map(foot).collect()
    }

    #[test]
    fn sign_and_offset_are_removed_whatever_they_are() {
        for (sign, offset) in [
            (1.0, 0.0),
            (-1.0, 0.0),
            (1.0, -19.7),
            (-1.0, 14.0),
            (-1.0, 250.0),
            (1.0, 120.0),
        ] {
            let raw = walk().iter().map(|f| sign * f + offset).collect();
            let c = channel(String::new(), raw, 100.0, None, &mut Vec::new());
            let worst = c
                .force_n
                .iter()
                .zip(walk())
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max);
            assert!(worst < 1e-9, "{sign} {offset}: {worst}");
            assert!((c.baseline_n - sign * offset).abs() < 1e-9);
        }
    }

    #[test]
    fn force_of_both_feet_that_never_falls_to_zero_keeps_its_level() {
        let raw: Vec<f64> = (0..2000)
            .map(|i| 700.0 + 250.0 * (f64::from(i) * 0.115).sin())
            .collect();
        let c = channel(String::new(), raw.clone(), 100.0, None, &mut Vec::new());
        assert_eq!(c.baseline_n, 0.0);
        assert!(c.force_n == raw);
    }

    #[test]
    fn standing_before_a_jump_is_no_offset() {
        // A second of standing, half a second in the air, a landing.
        let raw: Vec<f64> = (0..2000)
            .map(|i| match i {
                0..1000 => 690.0 + 3.0 * (0.05 * f64::from(i)).sin(),
                1000..1500 => 2.0,
                1500..1600 => 4700.0 * (PI * f64::from(i - 1500) / 100.0).sin(),
                _ => 690.0,
            })
            .collect();
        let c = channel(String::new(), raw, 1000.0, None, &mut Vec::new());
        assert!(c.baseline_n.abs() < 10.0, "{}", c.baseline_n);
    }

    #[test]
    fn dead_plates_are_named() {
        let idle = |v: Vec<f64>| channel(String::new(), v, 100.0, None, &mut Vec::new()).idle;
        let constant = |level: f64| {
            let level = newtons(level);
            Some(Idle::Constant { level })
        };
        assert_eq!(idle(vec![-0.0; 50]), Some(Idle::NeverLoaded));
        assert_eq!(idle(vec![812.0; 50]), constant(812.0));
        assert!(matches!(
            idle(vec![f64::NAN; 50]),
            Some(Idle::MostlyEmpty { .. })
        ));
        let mut half = vec![5000.0; 80];
        half.extend((0..40).map(|i| f64::from(i) * 20.0));
        assert_eq!(idle(half), constant(5000.0));
    }
}

//! Missing samples. Between contacts, missing samples mean an unloaded plate. Elsewhere, they are interpolated.
//!
//! Two kinds of readings also count as missing. A spike consists of one or a few samples that differ strongly from the samples before and
//! after it. Zeros in the middle of a load are lost packets.

use std::ops::Range;

/// Minimum duration, s, of a run of missing samples on an unloaded plate. A swing phase is not shorter.
const UNLOADED_S: f64 = 0.1;
/// Maximum reading next to a run of missing samples on an unloaded plate, as a fraction of the maximum reading of the recording.
const LOW: f64 = 0.3;
/// Time before or after a run of missing samples, s, and change of the force, N. A larger change within this time means a toe-off or heel
/// strike.
const EDGE: (f64, f64) = (0.015, 10.0);

/// Minimum sampling rate for the detection of spikes, Hz. At this rate, every sample is similar to an adjacent sample, because an impact
/// lasts 10 ms or more.
const DENSE_HZ: f64 = 180.0;
/// Minimum difference between a spike and the samples on both sides. It is given as a fraction of the maximum level that lasts longer than
/// a spike, and in N.
const SPIKE: (f64, f64) = (0.5, 100.0);
/// Maximum duration of a spike, s, and maximum number of its samples. At a low sampling rate, a spike is a single sample.
const LASTS: (f64, usize) = (0.0061, 6);
/// Maximum fraction of the samples that are spikes. A larger fraction is treated as noise.
const RARE: f64 = 0.005;

/// Maximum duration, s, of zeros between loaded readings that cannot be a swing phase, and minimum sampling rate, Hz, at which they are
/// detected.
const DROP_OUT: (f64, f64) = (0.08, 90.0);

/// Description of the samples that were filled.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Filled {
    /// Runs that were interpolated linearly: index of the first sample, and index of the last sample plus 1.
    pub bridged: Vec<(usize, usize)>,
    /// Whether some runs were interpreted as an unloaded plate.
    pub unloaded: bool,
    /// Number of spikes, and index of the first spike.
    pub spikes: Option<(usize, usize)>,
    /// Number of runs of lost samples, and start of the first run.
    pub drop_outs: Option<(usize, usize)>,
}

/// Marks spikes and lost packets as missing, and fills all missing samples: with zero where the plate is unloaded, otherwise by linear
/// interpolation. At the ends of the recording, the nearest value is repeated.
pub(super) fn fill(force: &mut [f64], rate_hz: f64) -> Filled {
    let spikes = remove_spikes(force, rate_hz);
    let reach = force.iter().copied().filter(|x| x.is_finite());
    let reach = reach.fold(0.0, |m: f64, x| m.max(x.abs()));
    let mut filled = Filled {
        spikes,
        drop_outs: remove_drop_outs(force, LOW * reach, rate_hz),
        ..Filled::default()
    };
    let mut from = 0;
    while let Some(start) = force[from..].iter().position(|x| !x.is_finite()) {
        let start = from + start;
        let end = force[start..].iter().position(|x| x.is_finite());
        let run = start..end.map_or(force.len(), |e| start + e);
        from = run.end;
        if is_unloaded(force, &run, reach, rate_hz) {
            force[run].fill(0.0);
            filled.unloaded = true;
        } else {
            bridge(force, &run);
            filled.bridged.push((run.start, run.end));
        }
    }
    filled
}

/// Whether the plate is unloaded during a run of missing samples. In this case, a foot leaves the plate before the run, and a foot lands
/// after it. At an end of the recording, the condition for this side of the run is omitted.
fn is_unloaded(force: &[f64], run: &Range<usize>, reach: f64, rate_hz: f64) -> bool {
    let apart = ((EDGE.0 * rate_hz).round() as usize).max(1);
    let is_edge = |near: usize, far: Option<usize>| {
        let far = far.and_then(|i| force.get(i)).filter(|x| x.is_finite());
        let rises = far.is_none_or(|x| x.abs() > force[near].abs() + EDGE.1);
        force[near].abs() < LOW * reach && rises
    };
    let before = run
        .start
        .checked_sub(1)
        .map(|near| is_edge(near, near.checked_sub(apart)));
    let after = (run.end < force.len()).then(|| is_edge(run.end, Some(run.end + apart)));
    let is_long = run.len() as f64 > UNLOADED_S * rate_hz;
    let mut edges = [before, after].into_iter().flatten();
    is_long && before.or(after).is_some() && edges.all(|edge| edge)
}

fn bridge(force: &mut [f64], run: &Range<usize>) {
    let before = run.start.checked_sub(1).map(|b| force[b]);
    let after = force.get(run.end).copied();
    let [a, b] = [before.or(after), after.or(before)].map(|x| x.unwrap_or(0.0));
    let steps = (run.len() + 1) as f64;
    for (k, x) in force[run.clone()].iter_mut().enumerate() {
        *x = a + (b - a) * (k as f64 + 1.0) / steps;
    }
}

/// Marks short runs of zeros between loaded readings as missing. Returns the number of runs and the start of the first run.
fn remove_drop_outs(force: &mut [f64], loaded: f64, rate_hz: f64) -> Option<(usize, usize)> {
    if rate_hz < DROP_OUT.1 {
        return None;
    }
    let (mut found, mut from) = (None, 1);
    while let Some(start) = force.get(from..)?.iter().position(|x| *x == 0.0) {
        let start = from + start;
        let Some(length) = force[start..].iter().position(|x| *x != 0.0) else {
            break;
        };
        let end = start + length;
        let is_loaded = |x: f64| x.abs() > loaded;
        let is_short = length as f64 <= DROP_OUT.0 * rate_hz;
        if is_short && is_loaded(force[start - 1]) && is_loaded(force[end]) {
            force[start..end].fill(f64::NAN);
            let (count, first) = found.unwrap_or((0, start));
            found = Some((count + 1, first));
        }
        from = end + 1;
    }
    found
}

/// Marks spikes as missing. Returns the number of spikes and the index of the first spike.
fn remove_spikes(force: &mut [f64], rate_hz: f64) -> Option<(usize, usize)> {
    if rate_hz < DENSE_HZ {
        return None;
    }
    let longest = ((LASTS.0 * rate_hz) as usize).clamp(1, LASTS.1);
    let held = |w: &[f64]| {
        let sign = w[0].signum();
        w.iter().map(|x| x * sign).fold(f64::INFINITY, f64::min)
    };
    let held = force.windows(longest + 1).map(held).fold(0.0, f64::max);
    let least = SPIKE.1.max(SPIKE.0 * held);
    let most = (RARE * force.len() as f64) as usize;
    let mut places = Vec::new();
    let mut from = 1;
    while from + 1 < force.len() && places.len() <= most {
        let end = (force[from] - force[from - 1])
            .abs()
            .gt(&least)
            .then(|| spike(&force[from - 1..], least, longest));
        match end.flatten() {
            Some(length) => {
                places.push(from..from + length);
                from += length;
            }
            None => from += 1,
        }
    }
    let first = places.first()?.start;
    if places.iter().map(Range::len).sum::<usize>() > most.max(longest) {
        return None;
    }
    for place in &places {
        force[place.clone()].fill(f64::NAN);
    }
    Some((places.len(), first))
}

/// Number of samples of a spike that begins after the first given sample. All samples of the spike differ strongly from the samples before
/// and after it.
fn spike(samples: &[f64], least: f64, longest: usize) -> Option<usize> {
    let rises = samples[1] > samples[0];
    let is_far = |x: f64, level: f64| (if rises { x - level } else { level - x }) > least;
    (1..=longest.min(samples.len().saturating_sub(2))).find(|&n| {
        let after = samples[n + 1];
        samples[1..=n]
            .iter()
            .all(|x| is_far(*x, samples[0]) && is_far(*x, after))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn missing_samples_are_bridged_and_reported() {
        let nan = f64::NAN;
        let mut v = vec![nan, 1.0, nan, nan, 4.0, nan];
        let filled = fill(&mut v, 100.0);
        assert_eq!(filled.bridged, [(0, 1), (2, 4), (5, 6)]);
        assert_eq!(v, [1.0, 1.0, 2.0, 3.0, 4.0, 4.0]);
    }

    /// A stance of 0.6 s every second at 200 Hz, with a peak of 700 N, above an unloaded level.
    fn walk(level: f64) -> Vec<f64> {
        let foot = |i: usize| {
            let t = (i % 200) as f64 / 120.0;
            let x = std::f64::consts::PI * t;
            if t < 1.0 { 700.0 * x.sin() } else { 0.0 }
        };
        (0..1000).map(|i| level + foot(i)).collect()
    }

    #[test]
    fn missing_swings_are_unloaded_and_gaps_elsewhere_are_bridged() {
        let swings: Vec<f64> = walk(0.0)[130..]
            .iter()
            .map(|&x| if x < 20.0 { f64::NAN } else { x })
            .collect();
        let mut v = swings.clone();
        let filled = fill(&mut v, 200.0);
        assert!(filled.unloaded && filled.bridged.is_empty());
        assert!(
            swings
                .iter()
                .zip(&v)
                .all(|(a, b)| a == b || a.is_nan() && *b == 0.0)
        );
        // Lost samples of a plate that reads 60 N unloaded, and of a stance.
        for lost in [140..180, 40..70] {
            let mut v = walk(60.0);
            v[lost.clone()].fill(f64::NAN);
            let filled = fill(&mut v, 200.0);
            assert_eq!(filled.bridged, [(lost.start, lost.end)]);
            assert!(v[lost].iter().all(|x| *x > 50.0));
        }
    }

    #[test]
    fn single_samples_far_from_both_neighbours_are_spikes() {
        let clean = walk(5.0);
        let mut v = clean.clone();
        for (i, x) in [(30, 4000.0), (150, -900.0), (460, 0.0)] {
            v[i] = x;
        }
        let filled = fill(&mut v, 200.0);
        assert_eq!(filled.spikes, Some((3, 30)));
        let off = clean.iter().zip(&v).map(|(a, b)| (a - b).abs());
        assert!(off.fold(0.0, f64::max) < 2.0);
        assert_eq!(fill(&mut walk(5.0), 200.0), Filled::default());
    }

    #[test]
    fn zeros_within_a_load_are_lost_samples() {
        let clean = walk(0.0);
        let mut v = clean.clone();
        for lost in [30..42, 260..270] {
            v[lost].fill(0.0);
        }
        let filled = fill(&mut v, 200.0);
        assert_eq!(filled.drop_outs, Some((2, 30)));
        assert_eq!(filled.bridged, [(30, 42), (260, 270)]);
        let off = clean.iter().zip(&v).map(|(a, b)| (a - b).abs());
        assert!(off.fold(0.0, f64::max) < 40.0);
        assert_eq!(fill(&mut walk(0.0), 200.0), Filled::default());
    }
}

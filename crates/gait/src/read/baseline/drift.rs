//! Drift: an unloaded reading that increases or decreases steadily during a recording.

use crate::statistics::{median, ranked};

/// Duration of a window, s, in which the foot of a walker leaves the plate at least once. In a shorter recording, a window is a fraction of
/// the recording.
const WINDOW_S: f64 = 2.0;
/// Minimum number of windows from which a drift is determined.
const FEWEST: usize = 4;
/// Maximum deviation of the unloaded level from a straight line, N.
const STRAIGHT_N: f64 = 6.0;

/// A drift with a smaller total change, N, is not removed but treated as part of the baseline.
pub(super) const SMALLEST_N: f64 = 15.0;

/// Slope of the unloaded level, N per sample, for readings of either sign; 0 without a steady drift.
pub(super) fn drift(force: &[f64], rate_hz: f64) -> f64 {
    let even = |sign: f64, slope: f64| -> Vec<f64> {
        let all = force.iter().enumerate();
        match (sign > 0.0, slope != 0.0) {
            (true, false) => force.to_vec(),
            _ => all.map(|(i, x)| sign * (x - slope * i as f64)).collect(),
        }
    };
    let of = |sign: f64, slope: f64| Some(sign * upwards(&even(sign, slope), rate_hz)?);
    let found = [1.0, -1.0]
        .into_iter()
        .find_map(|sign| Some((sign, of(sign, 0.0)?)));
    let Some((sign, slope)) = found else {
        return 0.0;
    };
    // A steep drift changes the percentile within a window. The slope is therefore computed again after its removal.
    let steep = (slope * force.len() as f64).abs() > SMALLEST_N;
    let rest = if steep { of(sign, slope) } else { None };
    slope + rest.unwrap_or(0.0)
}

/// Slope of the unloaded level, N per sample, for readings whose load is positive.
///
/// The level of a window is its 10th percentile. The slope is the median over pairs of windows (Theil–Sen estimator). A few windows in
/// which the plate is always loaded do not affect the slope.
fn upwards(force: &[f64], rate_hz: f64) -> Option<f64> {
    let length = ((WINDOW_S * rate_hz) as usize).min(force.len() / (FEWEST + 1));
    let level = |window: &[f64]| ranked(window.to_vec(), length / 10);
    let levels: Vec<f64> = force
        .chunks_exact(length.max(1))
        .filter_map(level)
        .collect();
    if levels.len() < FEWEST || length < 10 {
        return None;
    }
    let windows = || levels.iter().enumerate().step_by(levels.len() / 200 + 1);
    let pairs = windows().flat_map(|(i, a)| {
        let later = windows().filter(move |(j, _)| *j > i);
        later.map(move |(j, b)| (b - a) / (j - i) as f64)
    });
    let slope = median(pairs.collect())?;
    let change = slope * levels.len() as f64;
    let rests: Vec<f64> = windows()
        .map(|(i, level)| level - slope * i as f64)
        .collect();
    let rest = median(rests.clone())?;
    let off = rests
        .iter()
        .filter(|r| (*r - rest).abs() > STRAIGHT_N)
        .count();
    let reach = force.iter().copied().fold(0.0, f64::max);
    let unloaded = (rest + 0.5 * change).abs() < 0.3 * reach;
    (5 * off <= rests.len() && unloaded).then(|| slope / length as f64)
}

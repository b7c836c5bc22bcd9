//! Clipping: the amplifier or converter is limited to a level below the peaks of the force.
//!
//! After noise, gain, resampling and removal of drift, clipping appears as many readings at one level, none above it, and few just below
//! it.

use super::crowd;
use crate::statistics::median;

/// Readings above this fraction of the maximum reading are examined.
const UPPER: f64 = 0.6;
/// Half width of the band that counts as one level: as a fraction of the maximum reading, and in standard deviations of the noise.
const WIDTH: (f64, f64) = (0.004, 2.5);
/// Maximum number of readings above the level, as a fraction of the number of readings at the level.
const ABOVE: f64 = 0.03;
/// Minimum ratio of the number of readings at the level to the number just below it, in bands of equal width. The first value is for three
/// or more contacts. The ratio is 2.4 for a parabola and less than 3.3 for synthetic walkers, runners and jumpers. The second value is for
/// one or two contacts, because a flat peak has a larger ratio. It is 5.3 for a decrease with the fourth power of time.
const CROWDED: (f64, f64) = (3.5, 6.0);
/// Minimum number of readings at the level that means clipping.
const FEWEST: usize = 8;
/// Minimum time at the level within a contact that means clipping, s.
const HELD_S: f64 = 0.03;

/// Level at which the readings are clipped, N, after removal of drift; `None` without clipping. `unloaded_n` is the standard deviation of
/// the unloaded reading, N.
pub(super) fn clipped(force: &[f64], rate_hz: f64, unloaded_n: f64) -> Option<f64> {
    let top = force.iter().copied().fold(0.0, f64::max);
    let noise = unloaded_n.max(noise(force, UPPER * top));
    let half = (WIDTH.0 * top).max(WIDTH.1 * noise);
    // If the level is just below the peaks, many readings are within this width below it. Without later processing, all clipped readings
    // are exactly at the level, so a narrow width is examined as well.
    [half, 0.5 * resolution(force, UPPER * top)]
        .into_iter()
        .filter(|half| half.is_finite())
        .find_map(|half| stops_at(force, rate_hz, top, half))
}

/// Level, N, at which the readings are clipped, if readings within `half`, N, of a level count as equal.
fn stops_at(force: &[f64], rate_hz: f64, top: f64, half: f64) -> Option<f64> {
    let (level, at) = crowd(force, UPPER * top, top, 2.0 * half);
    let within = |low: f64, high: f64| force.iter().filter(|x| **x > low && **x <= high).count();
    let below = within(level - 3.0 * half, level - half).max(1);
    let above = within(level + half, top);
    let contacts = force.split(|x| *x < 0.5 * top);
    let reach = contacts.filter(|c| c.iter().any(|x| *x >= level - half));
    let contacts = reach.count().max(1);
    let crowded = if contacts > 2 { CROWDED.0 } else { CROWDED.1 };
    let stops = above as f64 <= ABOVE * at as f64 && at as f64 > crowded * below as f64;
    let held_s = at as f64 / rate_hz / contacts as f64;
    (stops && at >= FEWEST && held_s > HELD_S).then_some(level)
}

/// Resolution of the converter, N: the minimum difference between two unequal readings above the level `least`.
fn resolution(force: &[f64], least: f64) -> f64 {
    let mut upper: Vec<f64> = force.iter().copied().filter(|x| *x > least).collect();
    upper.sort_unstable_by(f64::total_cmp);
    let steps = upper.windows(2).map(|w| w[1] - w[0]);
    let rounding = least * 1e-12;
    steps
        .filter(|s| *s > rounding)
        .fold(f64::INFINITY, f64::min)
}

/// Standard deviation of white noise, N, in readings above a level. It is computed from second differences, in which the contribution of
/// the force is small.
fn noise(force: &[f64], least: f64) -> f64 {
    let upper = force.windows(3).filter(|w| w.iter().all(|x| *x > least));
    let bends = upper.map(|w| (w[0] - 2.0 * w[1] + w[2]).abs());
    1.4826 * median(bends.collect()).unwrap_or(0.0) / 6f64.sqrt()
}

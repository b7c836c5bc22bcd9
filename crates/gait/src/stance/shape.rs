//! Shape of the force in a stance: two peaks, the valley between the peaks, and the impulse.

use super::types::Point;
use crate::statistics::ends;

/// Minimum depth of a valley below the lower peak, as a fraction of the maximum force.
const VALLEY: f64 = 0.01;

/// Both feet are on the plate if the force at mid-stance exceeds the forces at the quarters of the stance by this factor.
const DOUBLE_SUPPORT: f64 = 1.12;

/// Peaks, valley and impulse of a stance.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shape {
    pub p1: Point,
    pub valley: Option<Point>,
    pub p2: Option<Point>,
    pub impulse_ns: f64,
    /// Number of peaks whose prominence is at least a tenth of the maximum force.
    pub humps: usize,
    /// Whether the maximum force is in the middle fifth and clearly above the force at the quarters.
    pub peaks_in_the_middle: bool,
    /// Fraction of the contact at which half of the impulse is reached.
    middle: f64,
}

impl Shape {
    /// Whether most of the impulse is in the first part of the contact, because only the heel is on the plate.
    pub fn is_early(&self) -> bool {
        self.middle < 0.46
    }

    /// Whether most of the impulse is in the last part of the contact.
    pub fn is_late(&self) -> bool {
        self.middle > 0.54
    }
}

/// Determines the shape of the force between two times, s from the first sample.
///
/// The valley is between 15 % and 85 % of the stance. It is the point that is deepest below the lower of two maxima: the maximum before the
/// point and the maximum after the point. These maxima are the peaks. If the valley is insignificant, the stance has one peak.
///
/// `noise_n` is the standard deviation of the unloaded reading, N. An interpolated peak exceeds the samples at most by this value.
pub(super) fn shape(
    force: &[f64],
    rate_hz: f64,
    (start_s, end_s): (f64, f64),
    noise_n: f64,
) -> Shape {
    let last = force.len().saturating_sub(1);
    let from = ((start_s * rate_hz).ceil() as usize).min(last);
    let to = ((end_s * rate_hz).floor() as usize).clamp(from, last);
    let samples = force.get(from..=to).unwrap_or(&[]);
    let duration = (end_s - start_s).max(1.0 / rate_hz);
    let point = |i: usize| {
        let (force_n, shift) = vertex(samples, i, noise_n);
        let at = ((from + i) as f64 + shift) / rate_hz - start_s;
        Point {
            force_n,
            at: (at / duration).clamp(0.0, 1.0),
        }
    };
    let sum = samples.iter().sum::<f64>();
    let top = ends(samples).map_or(0.0, |(_, top)| top);
    let highest = samples.iter().position(|y| *y == top).unwrap_or(0);
    let top = top.max(0.0);
    let n = samples.len();
    let at_quarter = |k: usize| samples.get(k * n / 4).copied().unwrap_or(0.0);
    let flanks = at_quarter(1).max(at_quarter(3));
    let is_in_the_middle = (2 * n..3 * n).contains(&(5 * highest));
    let valley = valley(samples, highest, VALLEY * top);
    Shape {
        p1: point(valley.map_or(highest, |v| v[0])),
        valley: valley.map(|v| point(v[1])),
        p2: valley.map(|v| point(v[2])),
        impulse_ns: sum / rate_hz,
        humps: humps(samples, 0.1 * top),
        peaks_in_the_middle: is_in_the_middle && top > DOUBLE_SUPPORT * flanks,
        middle: middle_of_impulse(samples, 0.5 * sum),
    }
}

/// Fraction of the samples after which half of their sum is reached.
fn middle_of_impulse(samples: &[f64], half: f64) -> f64 {
    let mut sum = 0.0;
    let reached = samples.iter().position(|x| {
        sum += x;
        sum >= half
    });
    reached.unwrap_or(0) as f64 / samples.len().max(1) as f64
}

/// Vertex of the parabola through a sample and the samples before and after it: force, N, and shift from the sample, in samples.
///
/// If the sample is not an extremum, the sample itself is returned. At a steep flank, the vertex would be much too high. The force
/// therefore exceeds the sample at most by the noise.
fn vertex(samples: &[f64], i: usize, noise_n: f64) -> (f64, f64) {
    let around = i.checked_sub(1).and_then(|j| samples.get(j..j + 3));
    let Some(&[a, y, b]) = around else {
        return (samples.get(i).copied().unwrap_or(0.0), 0.0);
    };
    let bend = a - 2.0 * y + b;
    if (a - y) * (b - y) <= 0.0 || bend == 0.0 {
        return (y, 0.0);
    }
    let shift = 0.5 * (a - b) / bend;
    let above = -0.25 * (a - b) * shift;
    (y + above.clamp(-noise_n, noise_n), shift)
}

/// Valley in the middle part of the stance, and the highest samples before and after it. One of these samples is the maximum of the stance.
/// The other sample is searched from the opposite end of the stance. `None` if the valley is not deeper than `least`, N.
fn valley(samples: &[f64], highest: usize, least: f64) -> Option<[usize; 3]> {
    let n = samples.len();
    let middle = (15 * n).div_ceil(100)..(85 * n) / 100;
    let (mut best, mut deepest) = (None, least);
    let mut before = 0;
    for at in 1..highest {
        let depth = samples[before] - samples[at];
        if depth < 0.0 {
            before = at;
        } else if depth > deepest && middle.contains(&at) {
            (best, deepest) = (Some([before, at, highest]), depth);
        }
    }
    let earlier = deepest;
    let mut after = n.saturating_sub(1);
    for at in (highest + 1..after).rev() {
        let depth = samples[after] - samples[at];
        if depth <= 0.0 {
            after = at;
        } else if depth > earlier && depth >= deepest && middle.contains(&at) {
            (best, deepest) = (Some([highest, at, after]), depth);
        }
    }
    best
}

/// Number of maxima with a prominence of at least `height` on both sides.
fn humps(samples: &[f64], height: f64) -> usize {
    let (mut count, mut rising) = (0, true);
    let mut extreme = 0.0f64;
    for &y in samples {
        if rising {
            extreme = extreme.max(y);
            if y < extreme - height {
                count += 1;
                rising = false;
                extreme = y;
            }
        } else {
            extreme = extreme.min(y);
            if y > extreme + height {
                rising = true;
                extreme = y;
            }
        }
    }
    count + usize::from(rising && extreme > height)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn peaks_and_valley_of_a_known_stance_are_placed_between_the_samples() {
        // F = 1000 (sin πx + 0.35 sin 3πx): extrema where cos πx (1 - 3·1.05 + 4.2·cos²πx) = 0.
        let n = 61;
        let f = |x: f64| 1000.0 * ((PI * x).sin() + 0.35 * (3.0 * PI * x).sin());
        let v: Vec<f64> = (0..n).map(|i| f(f64::from(i) / 60.0)).collect();
        let s = shape(&v, 100.0, (0.0, 0.6), 0.0);
        let x = (2.15f64 / 4.2).sqrt().acos() / PI;
        assert!((s.p1.at - x).abs() < 2e-3, "{s:?}");
        assert!((s.p1.force_n - f(x)).abs() < 1.0, "{s:?}");
        assert!((s.valley.unwrap().at - 0.5).abs() < 1e-9);
        assert!((s.valley.unwrap().force_n - 650.0).abs() < 1e-9);
        assert!((s.p2.unwrap().at - (1.0 - x)).abs() < 2e-3);
        assert_eq!(s.humps, 2);
    }

    #[test]
    fn a_steep_flank_does_not_throw_the_peak_above_the_samples() {
        // The parabola through 999, 1000 and 500 has its vertex 62 N above them.
        let v = [0.0, 600.0, 999.0, 1000.0, 500.0, 200.0, 0.0];
        let s = shape(&v, 60.0, (0.0, 0.1), 2.0);
        assert!((1000.0..=1002.0).contains(&s.p1.force_n), "{s:?}");
    }

    #[test]
    fn one_hump_has_no_valley() {
        let v: Vec<f64> = (0..=60)
            .map(|i| 1500.0 * (PI * f64::from(i) / 60.0).sin())
            .collect();
        let s = shape(&v, 240.0, (0.0, 0.25), 0.0);
        assert!(s.valley.is_none() && s.p2.is_none());
        assert!((s.p1.at - 0.5).abs() < 1e-9 && (s.p1.force_n - 1500.0).abs() < 1e-9);
        assert!((s.impulse_ns - 1500.0 * 0.25 * 2.0 / PI).abs() < 0.1);
    }
}

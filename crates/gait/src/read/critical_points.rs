//! A cycle from its critical points. The curve has a horizontal tangent at each peak and valley and is monotone between the points.

use crate::curve::{ForceCurve, SAMPLES};
use crate::error::{ReadError, Result};
use crate::quantity::seconds;

/// A curve through critical points. It has horizontal tangents at peaks and valleys and is monotone between the points.
pub(super) fn critical(
    name: &str,
    times: &[f64],
    force: &[f64],
    period: Option<f64>,
) -> Result<ForceCurve> {
    let period = period.ok_or(ReadError::CyclePeriodMissing)?;
    let first = times.first().copied().unwrap_or(0.0);
    let points: Vec<(f64, f64)> = times
        .iter()
        .zip(force)
        .map(|(t, f)| (t - first, *f))
        .collect();
    if points.windows(2).any(|w| w[1].0 <= w[0].0) || points.len() < 2 {
        return Err(ReadError::PointsNotRising.into());
    }
    through(name, points, period)
}

/// Piecewise cubic through the points of one period, sampled at equal phases.
///
/// The slopes are periodic and computed by the method of Fritsch and Butland. The curve is monotone between points, and its slope is zero
/// at extrema.
pub(super) fn through(name: &str, mut points: Vec<(f64, f64)>, period: f64) -> Result<ForceCurve> {
    let (last, first) = (points[points.len() - 1], points[0]);
    if last.0 > period * (1.0 + 1e-9) {
        let (at, period) = (seconds(last.0), seconds(period));
        return Err(ReadError::PointBeyondPeriod { at, period }.into());
    }
    if last.0 > period * (1.0 - 1e-9) {
        points.pop();
    }
    points.push((period, first.1));
    let n = points.len() - 1;
    let chord = |i: usize| (points[i + 1].1 - points[i].1) / (points[i + 1].0 - points[i].0);
    let width = |i: usize| points[i + 1].0 - points[i].0;
    let slope = |i: usize| {
        let (a, b) = ((i + n - 1) % n, i % n);
        let (da, db) = (chord(a), chord(b));
        if da * db <= 0.0 {
            return 0.0;
        }
        let (wa, wb) = (2.0 * width(b) + width(a), width(b) + 2.0 * width(a));
        (wa + wb) / (wa / da + wb / db)
    };
    let mut piece = 0;
    let force = (0..SAMPLES).map(|k| {
        let t = period * k as f64 / SAMPLES as f64;
        while piece + 1 < n && points[piece + 1].0 <= t {
            piece += 1;
        }
        let h = width(piece);
        let x = (t - points[piece].0) / h;
        let (a, b) = (points[piece].1, points[piece + 1].1);
        let (p, q) = (h * slope(piece), h * slope(piece + 1));
        // Cubic Hermite basis.
        let y = x - 1.0;
        a * (1.0 + 2.0 * x) * y * y + b * x * x * (3.0 - 2.0 * x) + p * x * y * y + q * x * x * y
    });
    ForceCurve::from_samples(name, period, force.collect())
}

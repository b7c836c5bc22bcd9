//! Interpolation of points by clamped cubic B-splines. The end conditions are of the type "not a knot". The first two spans therefore have
//! the same cubic polynomial. The last two spans also have the same cubic polynomial.

use std::ops::Range;

/// Minimum number of spans of a spline.
pub const FEWEST: usize = 4;

/// Spline space with interpolation points at 0, 1, … `spans`. The interpolation matrix is factorised once and used for all right-hand sides.
pub struct Interpolant {
    spans: usize,
    /// LU factors of the banded matrix: row i contains the columns i − 3 … i + 3.
    rows: Vec<[f64; 7]>,
}

/// Maximum number of columns on each side of the diagonal.
const BAND: usize = 3;

impl Interpolant {
    /// Creates the space for a number of spans, which must be at least [`FEWEST`].
    pub fn new(spans: usize) -> Self {
        let n = spans + 1;
        let mut rows = vec![[0.0; 2 * BAND + 1]; n];
        for (i, row) in rows.iter_mut().enumerate() {
            let (first, weights) = basis(spans, i as f64);
            for (k, w) in weights.into_iter().enumerate() {
                // The end rows have only one nonzero weight. Their other weights are zeros outside the band.
                if let Some(place) = (first + k + BAND).checked_sub(i).filter(|p| *p <= 2 * BAND) {
                    row[place] = w;
                }
            }
        }
        // The matrix is totally positive, so elimination needs no exchange of rows (de Boor).
        for i in 0..n {
            for below in i + 1..(i + 1 + BAND).min(n) {
                let factor = rows[below][BAND + i - below] / rows[i][BAND];
                rows[below][BAND + i - below] = factor;
                for column in i + 1..(i + 1 + BAND).min(n) {
                    let take = factor * rows[i][BAND + column - i];
                    rows[below][BAND + column - below] -= take;
                }
            }
        }
        Interpolant { spans, rows }
    }

    /// Control points of the spline that interpolates `points`. The spline has the value `points[i]` at the parameter i, where each span has the
    /// length 1.
    pub fn control<const D: usize>(&self, points: &[[f64; D]]) -> Vec<[f64; D]> {
        let n = self.spans + 1;
        let mut out = points.to_vec();
        for i in 0..n {
            for j in i.saturating_sub(BAND)..i {
                let factor = self.rows[i][BAND + j - i];
                let other = out[j];
                for (x, y) in out[i].iter_mut().zip(other) {
                    *x -= factor * y;
                }
            }
        }
        for i in (0..n).rev() {
            for j in i + 1..(i + 1 + BAND).min(n) {
                let factor = self.rows[i][BAND + j - i];
                let other = out[j];
                for (x, y) in out[i].iter_mut().zip(other) {
                    *x -= factor * y;
                }
            }
            for x in &mut out[i] {
                *x /= self.rows[i][BAND];
            }
        }
        out
    }

    /// Value at `x`, between 0 and the number of spans, of the spline with the given control points.
    pub fn at<const D: usize>(&self, control: &[[f64; D]], x: f64) -> [f64; D] {
        let (first, weights) = basis(self.spans, x);
        let mut out = [0.0; D];
        for (k, w) in weights.into_iter().enumerate() {
            for d in 0..D {
                out[d] += w * control[first + k][d];
            }
        }
        out
    }

    /// Knots of the space, each as a multiplicity and a value.
    pub fn knots(&self) -> Vec<(usize, f64)> {
        knots(self.spans)
    }
}

/// Multiplicities and values of the knots of a space: 0, 2, 3 … spans − 2, spans.
fn knots(spans: usize) -> Vec<(usize, f64)> {
    clamped(2..spans - 1, spans)
}

/// Multiplicities and values of the knots of a clamped cubic spline on 0 … `spans`, with the given inner knots.
pub fn clamped(inner: Range<usize>, spans: usize) -> Vec<(usize, f64)> {
    let mut out = vec![(4, 0.0)];
    out.extend(inner.map(|k| (1, k as f64)));
    out.push((4, spans as f64));
    out
}

/// Basis functions that can be nonzero at `x`: the index of the first of these four functions, and their values at `x` (Cox–de Boor).
fn basis(spans: usize, x: f64) -> (usize, [f64; 4]) {
    // Knot k of the full knot sequence, with multiple knots repeated.
    let knot = |k: usize| match k {
        0..=3 => 0.0,
        k if k <= spans => (k - 2) as f64,
        _ => spans as f64,
    };
    let span = if x < 2.0 {
        3
    } else {
        (x as usize + 2).min(spans)
    };
    let mut out = [1.0, 0.0, 0.0, 0.0];
    for degree in 1..=3 {
        let mut saved = 0.0;
        for (r, value) in out.iter_mut().enumerate().take(degree) {
            let (right, left) = (knot(span + r + 1), knot(span + 1 + r - degree));
            let part = *value / (right - left);
            *value = saved + (right - x) * part;
            saved = (x - left) * part;
        }
        out[degree] = saved;
    }
    (span - 3, out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubics_are_reproduced_and_the_sine_is_met_to_the_fourth_order() {
        let cubic = |x: f64| [1.0 - x + 0.3 * x * x - 0.01 * x * x * x];
        for spans in [4, 5, 9] {
            let space = Interpolant::new(spans);
            let points: Vec<[f64; 1]> = (0..=spans).map(|i| cubic(i as f64)).collect();
            let control = space.control(&points);
            for i in 0..=40 {
                let x = spans as f64 * f64::from(i) / 40.0;
                assert!(
                    (space.at(&control, x)[0] - cubic(x)[0]).abs() < 1e-12,
                    "{spans} {x}"
                );
            }
        }
        let error = |spans: usize| {
            let at = |i: f64| [(i / spans as f64).sin()];
            let space = Interpolant::new(spans);
            let points: Vec<[f64; 1]> = (0..=spans).map(|i| at(i as f64)).collect();
            let control = space.control(&points);
            let of = |i: usize| {
                let x = spans as f64 * i as f64 / 999.0;
                (space.at(&control, x)[0] - at(x)[0]).abs()
            };
            (0..1000).map(of).fold(0.0, f64::max)
        };
        let ratio = error(16) / error(32);
        assert!((10.0..40.0).contains(&ratio), "{ratio}");
    }
}

//! Values and extremes of the sum Σ aₙ cos nθ + bₙ sin nθ, n = 1 …

use std::f64::consts::TAU;

use super::{Extreme, fourier};

/// Minimum number of grid points per period of the highest harmonic.
const POINTS_PER_WAVE: usize = 16;
/// Minimum number of grid points.
const FEWEST_POINTS: usize = 64;
/// Maximum number of steps within a cell. Newton's method needs three or four steps. Bisection needs the maximum number.
const STEPS: usize = 40;
/// Newton step, rad, below which a parabola gives the value of the maximum with an error below rounding errors.
const FLAT: f64 = 1e-5;

/// Value, first and second derivative at `x` of each of several sums, all with the same number of terms.
pub fn harmonic_sums<const K: usize>(sums: [&[(f64, f64)]; K], x: f64) -> [[f64; 3]; K] {
    let (sin, cos) = libm::sincos(x);
    let (mut c, mut s) = (1.0, 0.0);
    let mut out = [[0.0; 3]; K];
    for i in 0..sums[0].len() {
        (c, s) = (c * cos - s * sin, s * cos + c * sin);
        let n = (i + 1) as f64;
        for (terms, out) in sums.iter().zip(&mut out) {
            let (a, b) = terms[i];
            let (even, odd) = (a * c + b * s, b * c - a * s);
            out[0] += even;
            out[1] += n * odd;
            out[2] -= n * n * even;
        }
    }
    out
}

/// Values of the sum at equal steps over the turn. Their number is a power of two, at least 16 per period of the highest harmonic.
pub fn harmonic_values(terms: &[(f64, f64)]) -> Vec<f64> {
    fourier::samples(terms, 0, grid_for(terms.len()))
}

/// Number of grid points for a number of harmonics.
fn grid_for(harmonics: usize) -> usize {
    let least = POINTS_PER_WAVE * harmonics;
    least.max(FEWEST_POINTS).next_power_of_two()
}

/// Minimum and maximum of the sum, exact up to rounding errors. Newton's method is used in every cell of the grid that may contain an
/// extreme. Between grid points, the sum exceeds the higher end value of the cell by at most h²/8·max|f″|, and max|f″| ≤ Σ n²·√(aₙ² + bₙ²).
pub fn harmonic_extremes(terms: &[(f64, f64)]) -> (Extreme, Extreme) {
    let waves = (1..).zip(terms);
    let bend: f64 = waves
        .map(|(n, t)| f64::from(n * n) * libm::hypot(t.0, t.1))
        .sum();
    if bend == 0.0 {
        return (NOTHING, NOTHING);
    }
    let grid = grid_for(terms.len());
    let [values, slopes] = [0, 1].map(|order| fourier::samples(terms, order, grid));
    let (mut low, mut high) = (values[0], values[0]);
    for &v in &values {
        low = if v < low { v } else { low };
        high = if v > high { v } else { high };
    }
    let step = TAU / values.len() as f64;
    let reach = 0.125 * step * step * bend;
    let search = |sign| Search {
        terms,
        slopes: &slopes,
        step,
        sign,
        best: f64::NEG_INFINITY,
        at: 0.0,
        searched: None,
    };
    let (mut lowest, mut highest) = (search(-1.0), search(1.0));
    for (i, &value) in values.iter().enumerate() {
        if value <= low + reach {
            lowest.around(i, value);
        }
        if value >= high - reach {
            highest.around(i, value);
        }
    }
    (lowest.found(), highest.found())
}

/// Extreme of the zero function, which has no terms.
const NOTHING: Extreme = Extreme {
    value: 0.0,
    at: 0.0,
};

/// Search for the maximum of sign·f among the cells of a grid over the turn.
struct Search<'a> {
    terms: &'a [(f64, f64)],
    /// Values of f′ at the points of the grid.
    slopes: &'a [f64],
    step: f64,
    sign: f64,
    best: f64,
    at: f64,
    /// The cell that was searched last, given by the grid point at its end.
    searched: Option<usize>,
}

impl Search<'_> {
    /// Considers a grid point with its value, and searches the cells on both sides of the point.
    fn around(&mut self, i: usize, value: f64) {
        self.take(self.sign * value, i as f64 * self.step);
        for end in [i, i + 1] {
            if self.searched != Some(end) {
                self.searched = Some(end);
                self.crest(end);
            }
        }
    }

    fn take(&mut self, value: f64, at: f64) {
        if value > self.best {
            (self.best, self.at) = (value, at);
        }
    }

    fn found(&self) -> Extreme {
        Extreme {
            value: self.sign * self.best,
            at: self.at.rem_euclid(TAU),
        }
    }

    /// Searches for the maximum in the cell before grid point `i`, if sign·f rises at the start of the cell and falls at its end. The
    /// method is Newton's method for f′ from a linear estimate, with bisection as a safeguard.
    fn crest(&mut self, i: usize) {
        let points = self.slopes.len();
        let ends = [i + points - 1, i].map(|i| self.sign * self.slopes[i % points]);
        if ends[0] < 0.0 || ends[1] > 0.0 {
            return;
        }
        let (mut low, mut high) = ((i as f64 - 1.0) * self.step, i as f64 * self.step);
        let part = ends[0] / (ends[0] - ends[1]);
        let mut x = if part.is_finite() {
            low + part * self.step
        } else {
            low
        };
        for _ in 0..STEPS {
            let [sum] = harmonic_sums([self.terms], x);
            let [value, slope, bend] = sum.map(|f| self.sign * f);
            let newton = -slope / bend;
            if bend < 0.0 && newton.abs() < FLAT {
                // The error of the parabola is below rounding errors.
                self.take(value + 0.5 * newton * slope, x + newton);
                return;
            }
            if slope > 0.0 {
                low = x;
            } else {
                high = x;
            }
            let next = x + newton;
            x = if bend < 0.0 && next > low && next < high {
                next
            } else {
                0.5 * (low + high)
            };
        }
        self.take(self.sign * harmonic_sums([self.terms], x)[0][0], x);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::bernstein::binomial;

    /// (1 + cos θ)ᵏ = Σ C(2k, k − n) cos nθ · 2^(1−k) + its mean, with the values 2ᵏ at 0 and 0 at π.
    #[test]
    fn powers_of_one_plus_cosine_have_known_extremes() {
        for k in 1..=12 {
            let scale = 2.0_f64.powi(1 - k as i32);
            let (sin, cos) = 0.3_f64.sin_cos();
            let mut turned = (1.0, 0.0);
            let terms: Vec<(f64, f64)> = (1..=k)
                .map(|n| {
                    turned = (
                        turned.0 * cos - turned.1 * sin,
                        turned.1 * cos + turned.0 * sin,
                    );
                    let a = scale * binomial(2 * k, k - n);
                    (a * turned.0, a * turned.1)
                })
                .collect();
            let mean = 0.5 * scale * binomial(2 * k, k);
            let (low, high) = harmonic_extremes(&terms);
            let most = 2.0_f64.powi(k as i32);
            assert!(
                (high.value + mean - most).abs() < 1e-13 * most,
                "{k}: {high:?}"
            );
            assert!((low.value + mean).abs() < 1e-13 * most, "{k}: {low:?}");
            assert!((high.at - 0.3).abs() < 1e-6, "{k}: {high:?}");
        }
        assert_eq!(harmonic_extremes(&[]).1.value, 0.0);
    }

    #[test]
    fn every_extreme_is_at_least_what_a_fine_grid_sees() {
        for case in 0..60_u32 {
            let count = 1 + case % 12;
            let terms: Vec<(f64, f64)> = (1..=count)
                .map(|n| (f64::from(7 * n + case).sin(), f64::from(3 * n * case).cos()))
                .collect();
            let (low, high) = harmonic_extremes(&terms);
            let size = high.value - low.value;
            for i in 0..5000 {
                let value = harmonic_sums([&terms], TAU * f64::from(i) / 5000.0)[0][0];
                assert!(value <= high.value + 1e-13 * size && value >= low.value - 1e-13 * size);
            }
            for end in [low, high] {
                let [[value, slope, _]] = harmonic_sums([&terms], end.at);
                assert!((value - end.value).abs() < 1e-13 * size, "{case}");
                assert!(slope.abs() < 1e-4 * size, "{case}");
            }
        }
    }
}

//! Basis functions of a law. A linear functional of a law is stored as a row of weights, one for each coefficient.

use crate::poly::{PiecewisePoly, SplineSpace, Wave, add_taylor, subdivide};
use std::f64::consts::TAU;

/// Maximum number of Bernstein coefficients of a piece that are stored on the stack. More coefficients are stored on the heap.
pub const WIDEST: usize = 12;

/// Linear functional of the law: Σ value·coefficient over the entries (index of the coefficient, value).
pub type Entries = Vec<(usize, f64)>;

/// Weights of the law and its derivatives: `weight` for the derivative `order`, and 0 for all others.
pub fn only(order: usize, weight: f64) -> [f64; 5] {
    let mut weights = [0.0; 5];
    weights[order] = weight;
    weights
}

/// Linear family of laws: every law is Σ xᵢ·(basis function i).
#[derive(Debug, Clone)]
pub enum Basis {
    /// B-splines, periodic over one turn or open.
    Spline {
        /// Degree, breaks and continuity of the splines.
        space: SplineSpace,
        /// Whether the law is periodic.
        closed: bool,
    },
    /// Harmonics over one turn. The coefficients are the mean, then cosine and sine of harmonics 1 … count.
    Harmonic {
        /// Number of harmonics in the sum.
        count: usize,
    },
}

impl Basis {
    /// Number of coefficients of a law.
    #[inline]
    pub fn columns(&self) -> usize {
        match self {
            Basis::Spline { space, .. } => space.dimension(),
            Basis::Harmonic { count } => 2 * count + 1,
        }
    }

    /// Half-bandwidth and number of border rows of the Gram matrices.
    pub fn pattern(&self) -> (usize, usize) {
        match self {
            Basis::Spline {
                space,
                closed: true,
            } => (space.degree(), space.degree()),
            Basis::Spline {
                space,
                closed: false,
            } => (space.degree(), 0),
            Basis::Harmonic { count } => (0, 2 * count + 1),
        }
    }

    /// The combination Σ wₖ s⁽ᵏ⁾ as a piecewise polynomial. Sinusoids are replaced by Taylor polynomials with remainders below rounding
    /// errors. For sinusoids, weights above w₃ are ignored.
    pub fn combination(&self, x: &[f64], weights: &[f64; 5]) -> PiecewisePoly {
        match self {
            Basis::Spline { space, .. } => {
                let last = weights.iter().rposition(|w| *w != 0.0).unwrap_or(0);
                let mut orders = vec![space.spline(&x[..space.dimension()])];
                for k in 0..last {
                    orders.push(orders[k].derivative());
                }
                let mut terms: Vec<_> = weights.iter().copied().zip(&orders).collect();
                if weights[last] != 0.0 {
                    terms.retain(|t| t.0 != 0.0);
                }
                PiecewisePoly::combine(&terms, 0.0)
            }
            Basis::Harmonic { count } => {
                let mean = PiecewisePoly::new(vec![0.0, TAU], 0, vec![x[0]]);
                let wave = |n: usize| Wave {
                    rate: (n + 1) as f64,
                    cos: x[2 * n + 1],
                    sin: x[2 * n + 2],
                };
                let (mean, waves) = subdivide(&mean, &[(0..*count).map(wave).collect()]);
                let [s, v, a, j, _] = *weights;
                let mean = PiecewisePoly::combine(&[(s, &mean)], 0.0);
                add_taylor(mean, &waves, [s, v, a, j])
            }
        }
    }

    /// Minimum of the derivative `order` of the law over its whole range.
    pub(crate) fn least(&self, x: &[f64], order: usize) -> f64 {
        self.combination(x, &only(order, 1.0)).extremes().0.value
    }

    /// Breaks of the pieces on which the basis is smooth, rad.
    pub fn breaks(&self) -> Vec<f64> {
        match self {
            Basis::Spline { space, .. } => {
                let mut out: Vec<f64> = space.spans().iter().map(|s| s.start).collect();
                out.extend(space.spans().last().map(|s| s.start + s.width));
                out
            }
            Basis::Harmonic { count } => {
                // Two pieces per wave of the highest harmonic are sufficient for a quadrature of degree 7.
                let n = (2 * count).max(4);
                (0..=n)
                    .map(|i| std::f64::consts::TAU * i as f64 / n as f64)
                    .collect()
            }
        }
    }

    /// Piece of [`Basis::breaks`] that contains an angle of the first turn, and position u ∈ [0, 1] on this piece.
    pub fn locate(&self, theta: f64) -> (usize, f64) {
        match self {
            Basis::Spline { space, .. } => space.locate(theta),
            Basis::Harmonic { .. } => {
                let breaks = self.breaks();
                let i = breaks[1..breaks.len() - 1].partition_point(|b| *b <= theta);
                (i, (theta - breaks[i]) / (breaks[i + 1] - breaks[i]))
            }
        }
    }

    /// Coefficients of the law after the constant `by` is added to its lift.
    pub fn raised(&self, mut x: Vec<f64>, by: f64) -> Vec<f64> {
        match self {
            Basis::Spline { .. } => x.iter_mut().for_each(|c| *c += by),
            Basis::Harmonic { .. } => x[0] += by,
        }
        x
    }

    /// Row of w₀s + w₁v + w₂a + w₃j (and of the fourth derivative if `weights` has five entries) at u ∈ [0, 1] on the piece `i` of
    /// [`Basis::breaks`].
    pub fn row_on(&self, i: usize, u: f64, weights: &[f64]) -> Entries {
        match self {
            Basis::Spline { space, .. } => match space.degree() {
                // Loops of constant length take a third of the time. Quintics are the default.
                5 => row_on_span(space, 5, (i, u), weights),
                degree => row_on_span(space, degree, (i, u), weights),
            },
            Basis::Harmonic { .. } => {
                let b = self.breaks();
                self.row(b[i] + u * (b[i + 1] - b[i]), weights)
            }
        }
    }

    /// Row of Σ wₖ s⁽ᵏ⁾ at an angle, rad. At a break, the piece to the right is used.
    pub fn row(&self, theta: f64, weights: &[f64]) -> Entries {
        match self {
            Basis::Spline { space, closed } => {
                let spans = space.spans();
                let (start, end) = (
                    spans[0].start,
                    spans.last().map_or(0.0, |s| s.start + s.width),
                );
                let theta = if *closed && !(start..end).contains(&theta) {
                    start + (theta - start).rem_euclid(end - start)
                } else {
                    theta
                };
                let (i, u) = space.locate(theta);
                self.row_on(i, u, weights)
            }
            Basis::Harmonic { count } => {
                let mut out = vec![(0, weights[0])];
                for n in 1..=*count {
                    let r = n as f64;
                    let (sin, cos) = libm::sincos(r * theta);
                    // dᵏ/dθᵏ cos(rθ) = rᵏ cos(rθ + kπ/2).
                    let cosine = [cos, -sin, -cos, sin];
                    let sine = [sin, cos, -sin, -cos];
                    let sum = |table: [f64; 4]| -> f64 {
                        (0..weights.len())
                            .map(|k| weights[k] * r.powi(k as i32) * table[k % 4])
                            .sum()
                    };
                    out.push((2 * n - 1, sum(cosine)));
                    out.push((2 * n, sum(sine)));
                }
                out
            }
        }
    }
}

/// Row of Σ wₖ s⁽ᵏ⁾ at u on a span, for splines of degree `degree`.
#[inline(always)]
fn row_on_span(
    space: &SplineSpace,
    degree: usize,
    (span, u): (usize, f64),
    weights: &[f64],
) -> Entries {
    let n = degree + 1;
    let rate = 1.0 / space.spans()[span].width;
    let (mut short, mut long) = ([0.0; WIDEST * (WIDEST + 3)], Vec::new());
    let room = if n <= WIDEST {
        &mut short[..n * (n + 3)]
    } else {
        long.resize(n * (n + 3), 0.0);
        &mut long[..]
    };
    let (sums, room) = room.split_at_mut(n);
    let (steps, room) = room.split_at_mut(n);
    let (basis, rows) = room.split_at_mut(n);
    rows.copy_from_slice(space.extraction(span));
    let highest = weights.iter().rposition(|w| *w != 0.0).unwrap_or(0);
    let mut scale = 1.0;
    for (order, &weight) in weights.iter().enumerate().take(n.min(highest + 1)) {
        let left = n - order;
        if order > 0 {
            scale *= left as f64 * rate;
            differentiate(rows, n, left);
        }
        if order == 1 {
            rows.chunks_exact_mut(n).take(left).for_each(by_steps);
        }
        if weight != 0.0 {
            bernstein_basis(u, &mut basis[..left]);
            let into = if order == 0 { &mut *sums } else { &mut *steps };
            for (row, b) in rows.chunks_exact(n).zip(&basis[..left]) {
                let b = weight * scale * b;
                for (sum, value) in into.iter_mut().zip(row) {
                    *sum += b * value;
                }
            }
        }
    }
    if highest > 0 {
        let mut before = 0.0;
        for (sum, step) in sums.iter_mut().zip(&*steps) {
            *sum += before - step;
            before = *step;
        }
    }
    on_unknowns(space, span, sums)
}

/// Subtracts each of the first `left` rows from the next row and stores the difference in its place. The differences are the Bernstein
/// coefficients of the derivative of all B-splines on a span, without the factor of the degree. The differences are computed before
/// multiplication to avoid cancellation.
#[inline(always)]
fn differentiate(rows: &mut [f64], n: usize, left: usize) {
    for k in 0..left {
        let (own, next) = rows[k * n..].split_at_mut(n);
        for (own, next) in own.iter_mut().zip(next) {
            *own = *next - *own;
        }
    }
}

/// Converts weights dᵢ of coefficients cᵢ to weights of the steps cᵢ₊₁ − cᵢ. The sum of the dᵢ must be 0, so Σ dᵢ cᵢ = −Σ (d₀ + … +
/// dᵢ)(cᵢ₊₁ − cᵢ). If the jerk is small relative to the stroke, the sum Σ dᵢ cᵢ would have a large relative rounding error.
#[inline(always)]
pub fn by_steps(weights: &mut [f64]) {
    let mut sum = 0.0;
    for weight in weights.iter_mut() {
        sum -= *weight;
        *weight = sum;
    }
    // The last sum is only a rounding error, because no step follows the last coefficient.
    if let Some(last) = weights.last_mut() {
        *last = 0.0;
    }
}

/// Converts weights of the B-splines on a span to entries with the indices of their coefficients.
fn on_unknowns(space: &SplineSpace, span: usize, values: &[f64]) -> Entries {
    let (first, all) = (space.index(span, 0), space.dimension());
    // With few spans, one coefficient may occur twice on a span of a periodic spline. Its weights are then added.
    if values.len() > all {
        let mut out = Entries::with_capacity(all);
        for (i, &value) in values.iter().enumerate() {
            add(&mut out, ((first + i) % all, value));
        }
        return out;
    }
    let around = |at: usize| if at < all { at } else { at - all };
    let places = (first..).map(around);
    places.zip(values.iter().copied()).collect()
}

/// Values of the Bernstein polynomials of degree `out.len()` − 1 at u.
fn bernstein_basis(u: f64, out: &mut [f64]) {
    let v = 1.0 - u;
    out[0] = 1.0;
    for m in 1..out.len() {
        out[m] = u * out[m - 1];
        for k in (1..m).rev() {
            out[k] = u * out[k - 1] + v * out[k];
        }
        out[0] *= v;
    }
}

/// Adds one entry to a row. Values with the same index are added.
pub fn add(to: &mut Entries, (index, value): (usize, f64)) {
    match to.iter_mut().find(|e| e.0 == index) {
        Some(e) => e.1 += value,
        None => to.push((index, value)),
    }
}

/// Dense row of length `n` with the given entries.
pub fn dense(entries: &Entries, n: usize) -> Vec<f64> {
    let mut out = vec![0.0; n];
    for &(i, a) in entries {
        out[i] += a;
    }
    out
}

/// Value of the linear functional `entries` for the coefficients x: Σ value·xᵢ.
#[inline]
pub fn apply(entries: &Entries, x: &[f64]) -> f64 {
    entries.iter().map(|&(i, v)| v * x[i]).sum()
}

/// Maximum magnitude of the terms of a row for coefficients of typical size `length`. For a row with further variables only, it is
/// `length`.
pub fn row_unit(entries: &Entries, length: f64) -> f64 {
    let unit = entries
        .iter()
        .fold(0.0_f64, |m, e| m.max((e.1 * length).abs()));
    if unit > 0.0 { unit } else { length }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_on_a_span_are_those_of_the_space() {
        let breaks = [0.0, 0.4, 1.3, 2.0, 2.2, 4.0];
        for space in [
            SplineSpace::periodic_uniform(5, 9, 4.0),
            SplineSpace::periodic_uniform(5, 3, 4.0),
            SplineSpace::periodic(4, &breaks, &[1, 3, 1, 2, 2]),
            SplineSpace::clamped(3, &breaks, &[1, 2, 1, 1]),
            SplineSpace::clamped(WIDEST + 1, &breaks, &[1; 4]),
        ] {
            let x: Vec<f64> = (0..space.dimension())
                .map(|i| ((i * i) % 7) as f64 - 2.0)
                .collect();
            let basis = Basis::Spline {
                space: space.clone(),
                closed: false,
            };
            for weights in [
                [1.0, 0.0, 0.0, 0.0],
                [0.3, -1.0, 0.0, 0.1],
                [0.0, 0.0, 0.0, 1.0],
            ] {
                for span in 0..space.spans().len() {
                    for u in [0.0, 0.3, 1.0] {
                        let values = space.row(span, u, &weights);
                        let terms = values.iter().enumerate();
                        let terms = terms.map(|(k, v)| v * x[space.index(span, k)]);
                        let size: f64 = terms.clone().map(f64::abs).sum();
                        let value = apply(&basis.row_on(span, u, &weights), &x);
                        assert!((value - terms.sum::<f64>()).abs() <= 1e-11 * size);
                    }
                }
            }
        }
    }
}

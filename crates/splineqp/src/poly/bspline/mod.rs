//! B-splines on arbitrary knots, periodic or clamped, in Bernstein form on every span.
//!
//! On a span, degree + 1 basis functions are not zero. The *extraction matrix* of the span contains their Bernstein coefficients. Every
//! linear functional of a spline at one point (value, derivative, limit) is a row with entries for these adjacent coefficients.

mod knots;

use super::PiecewisePoly;

/// A non-empty knot span and its basis functions.
///
/// ```
/// use splineqp::poly::SplineSpace;
///
/// let space = SplineSpace::periodic_uniform(3, 4, 2.0);
/// assert_eq!((space.spans()[1].start, space.spans()[1].width), (0.5, 0.5));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// Left end of the span.
    pub start: f64,
    /// Length of the span. It is positive.
    pub width: f64,
    /// Index of the first of the degree + 1 basis functions on the span, before reduction modulo the dimension.
    pub first: usize,
    /// Index of the extraction matrix of the span.
    matrix: usize,
}

impl Span {
    /// Index of the extraction matrix. Spans with the same index have the same knot pattern and the same matrix.
    #[inline]
    pub fn matrix(&self) -> usize {
        self.matrix
    }
}

/// Space of splines of one degree on a knot vector.
///
/// ```
/// use splineqp::poly::SplineSpace;
///
/// // Cubics over four spans of a turn: one coefficient a span.
/// let space = SplineSpace::periodic_uniform(3, 4, std::f64::consts::TAU);
/// assert_eq!(space.spans().len(), 4);
/// assert_eq!(space.degree(), 3);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SplineSpace {
    degree: usize,
    dimension: usize,
    spans: Vec<Span>,
    /// Extraction matrices with (degree+1)² entries each. Entry [k*(degree+1) + i] is the Bernstein coefficient k of the local basis
    /// function i. Uniform spans share one matrix.
    matrices: Vec<Vec<f64>>,
    /// Knots of one turn of a periodic space, in units of `unit`; empty for a clamped space. The next field is the length of the turn.
    turn: Vec<f64>,
    period: f64,
    /// Length of the unit in which the knots and the period are stored.
    unit: f64,
}

impl SplineSpace {
    /// Spline space of the derivatives of a periodic space, on the same knots, and the factors f. If a spline has the coefficients c, its
    /// derivative has the coefficients fᵢ (cᵢ − cᵢ₋₁), with cyclic indices. `None` for a clamped space, for degree 0, and if splines may
    /// jump at a break of full multiplicity.
    pub fn derivative(&self) -> Option<(SplineSpace, Vec<f64>)> {
        let (n, q) = (self.dimension, self.degree);
        if self.turn.is_empty() || q == 0 {
            return None;
        }
        let knot = |i: usize| self.turn[i % n] + self.period * (i / n) as f64;
        let factors: Vec<f64> = (0..n)
            .map(|i| q as f64 / ((knot(i + q) - knot(i)) * self.unit))
            .collect();
        if factors.iter().any(|f| !f.is_finite()) {
            return None;
        }
        if self.unit == 1.0 {
            let space = SplineSpace::around(q - 1, self.turn.clone(), self.period);
            return Some((space, factors));
        }
        let mut space = SplineSpace::in_whole_numbers(q - 1, n);
        space.stretch(self.period * self.unit);
        Some((space, factors))
    }

    /// Degree of the splines.
    #[inline]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Number of coefficients of a spline.
    #[inline]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Knots of one turn of a periodic space, with multiple knots repeated; empty for a clamped space.
    pub fn knots(&self) -> Vec<f64> {
        self.turn.iter().map(|knot| knot * self.unit).collect()
    }

    /// Non-empty spans in ascending order.
    #[inline]
    pub fn spans(&self) -> &[Span] {
        &self.spans
    }

    /// Index of the span that contains `x`, and position u ∈ [0, 1] in this span.
    #[inline]
    pub fn locate(&self, x: f64) -> (usize, f64) {
        let i = self.spans[1..].partition_point(|s| s.start <= x);
        (i, (x - self.spans[i].start) / self.spans[i].width)
    }

    /// Extraction matrix of a span with (degree+1)² entries. Entry `[k*(degree+1) + i]` is the Bernstein coefficient k of the local basis
    /// function i.
    #[inline]
    pub fn extraction(&self, span: usize) -> &[f64] {
        &self.matrices[self.spans[span].matrix]
    }

    /// Coefficient index of the local basis function `i` of a span.
    #[inline]
    pub fn index(&self, span: usize, i: usize) -> usize {
        (self.spans[span].first + i) % self.dimension
    }

    /// Whether the space is periodic and all its spans have the same width and knot pattern.
    #[inline]
    pub fn is_uniform(&self) -> bool {
        let first = &self.spans[0];
        let alike = |s: &Span| {
            s.matrix == first.matrix && (s.width - first.width).abs() <= 1e-14 * first.width
        };
        self.dimension == self.spans.len() && self.spans.iter().all(alike)
    }

    /// Converts weights of the Bernstein coefficients to weights of the local basis functions, for one span.
    pub fn pull_back(&self, span: usize, bernstein_weights: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        let rows = self.extraction(span).chunks_exact(self.degree + 1);
        for (row, weight) in rows.zip(bernstein_weights) {
            for (value, e) in out.iter_mut().zip(row) {
                *value += weight * e;
            }
        }
    }

    /// Value of Σ wₖ dᵏs/dxᵏ at the position u ∈ [0, 1] of a span, as weights of the local basis functions. The wₖ are `weights`, and s is
    /// the spline.
    pub fn row(&self, span: usize, u: f64, weights: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.degree + 1];
        self.values(span, &[u], weights, &mut out);
        out
    }

    /// The weights that `row` returns, for all positions `places` of the span. The weights of one local function at all places are
    /// consecutive in `out`.
    pub fn values(&self, span: usize, places: &[f64], weights: &[f64], out: &mut [f64]) {
        let (n, count) = (self.degree + 1, places.len());
        let width = self.spans[span].width;
        let extraction = self.extraction(span);
        out.fill(0.0);
        let mut basis = vec![0.0; n * count];
        let mut coefficients = vec![0.0; n];
        for (order, &weight) in weights.iter().enumerate().take(n) {
            if weight == 0.0 {
                continue;
            }
            let m = self.degree - order;
            bernstein_basis(m, places, &mut basis);
            let scale: f64 = (m + 1..n).map(|d| d as f64 / width).product();
            for (i, own) in out.chunks_exact_mut(count).enumerate() {
                for (c, e) in coefficients
                    .iter_mut()
                    .zip(extraction[i..].iter().step_by(n))
                {
                    *c = weight * scale * e;
                }
                for left in (m + 1..n).rev() {
                    for k in 0..left {
                        coefficients[k] = coefficients[k + 1] - coefficients[k];
                    }
                }
                for (c, values) in coefficients[..=m].iter().zip(basis.chunks_exact(count)) {
                    for (o, b) in own.iter_mut().zip(values) {
                        *o += c * b;
                    }
                }
            }
        }
    }

    /// The spline with the given coefficients as a piecewise polynomial.
    ///
    /// # Panics
    ///
    /// If the number of `coefficients` differs from the dimension.
    pub fn spline(&self, coefficients: &[f64]) -> PiecewisePoly {
        assert_eq!(coefficients.len(), self.dimension);
        let mut breaks = Vec::with_capacity(self.spans.len() + 1);
        breaks.extend(self.spans.iter().map(|s| s.start));
        breaks.push(self.spans.last().map_or(0.0, |s| s.start + s.width));
        // Loops of constant length take half the time.
        let coef = match self.degree + 1 {
            6 => self.bernstein(6, coefficients),
            n => self.bernstein(n, coefficients),
        };
        PiecewisePoly::new(breaks, self.degree, coef)
    }

    /// Bernstein coefficients of all spans, `n` per span.
    #[inline(always)]
    fn bernstein(&self, n: usize, coefficients: &[f64]) -> Vec<f64> {
        let mut coef = Vec::with_capacity(self.spans.len() * n);
        let mut local = vec![0.0; n];
        for (i, span) in self.spans.iter().enumerate() {
            let mut at = span.first;
            for c in &mut local {
                *c = coefficients[at];
                at = if at + 1 == self.dimension { 0 } else { at + 1 };
            }
            for row in self.extraction(i).chunks_exact(n) {
                let mut sum = 0.0;
                for (e, c) in row.iter().zip(&local[..n]) {
                    sum += e * c;
                }
                coef.push(sum);
            }
        }
        coef
    }
}

/// Values of the m + 1 Bernstein polynomials of degree m at `places`. The values of one polynomial are consecutive in `out`.
fn bernstein_basis(m: usize, places: &[f64], out: &mut [f64]) {
    let count = places.len();
    out[..count].fill(1.0);
    for r in 1..=m {
        out[r * count..(r + 1) * count].fill(0.0);
        for k in (1..=r).rev() {
            let (below, own) = out.split_at_mut(k * count);
            let below = &below[(k - 1) * count..];
            for ((b, left), u) in own.iter_mut().zip(below).zip(places) {
                *b = left * u + *b * (1.0 - u);
            }
        }
        for (b, u) in out.iter_mut().zip(places) {
            *b *= 1.0 - u;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// B-spline by the Cox–de Boor definition, an independent method for comparison.
    fn cox(knots: &[f64], i: usize, p: usize, x: f64) -> f64 {
        if p == 0 {
            return f64::from(u8::from(knots[i] <= x && x < knots[i + 1]));
        }
        let term = |num: f64, den: f64, f: f64| if den > 0.0 { num / den * f } else { 0.0 };
        term(
            x - knots[i],
            knots[i + p] - knots[i],
            cox(knots, i, p - 1, x),
        ) + term(
            knots[i + p + 1] - x,
            knots[i + p + 1] - knots[i + 1],
            cox(knots, i + 1, p - 1, x),
        )
    }

    #[test]
    fn clamped_splines_agree_with_the_recursion() {
        for degree in 1..=7 {
            let breaks = [0.0, 0.3, 0.5, 1.1, 2.0];
            let multiplicity = [1, 2.min(degree), 1];
            let space = SplineSpace::clamped(degree, &breaks, &multiplicity);
            let mut knots = vec![0.0; degree + 1];
            for (b, m) in breaks[1..4].iter().zip(multiplicity) {
                knots.extend(std::iter::repeat_n(*b, m));
            }
            knots.extend(vec![2.0; degree + 1]);
            for i in 0..space.dimension() {
                let mut c = vec![0.0; space.dimension()];
                c[i] = 1.0;
                let spline = space.spline(&c);
                for x in [0.0, 0.1, 0.3, 0.42, 0.5, 0.9, 1.1, 1.5, 1.999] {
                    let expected = cox(&knots, i, degree, x);
                    assert!(
                        (spline.eval(x) - expected).abs() < 1e-13,
                        "{degree} {i} {x}"
                    );
                }
            }
        }
    }

    #[test]
    fn periodic_splines_join_smoothly_everywhere_and_sum_to_one() {
        for (degree, n) in [(3, 4), (5, 3), (5, 8), (7, 5), (9, 3), (4, 1)] {
            let mut breaks: Vec<f64> = (0..=n).map(|i| f64::from(i) / f64::from(n)).collect();
            if n > 3 {
                breaks[1] += 0.05;
            }
            let space = SplineSpace::periodic(degree, &breaks, &vec![1; n as usize]);
            assert_eq!(space.dimension(), n as usize);
            let one = space.spline(&vec![1.0; space.dimension()]);
            assert!((one.eval(0.37) - 1.0).abs() < 1e-13);
            let c: Vec<f64> = (0..space.dimension())
                .map(|i| ((i * i) % 7) as f64 - 2.0)
                .collect();
            let mut f = space.spline(&c);
            for order in 0..degree {
                for i in 0..f.pieces() {
                    let next = (i + 1) % f.pieces();
                    let (end, start) = (f.piece(i)[f.degree()], f.piece(next)[0]);
                    let scale = f.extremes().1.value.abs().max(1.0);
                    assert!(
                        (end - start).abs() < 1e-10 * scale,
                        "degree {degree} n {n} order {order}"
                    );
                }
                f = f.derivative();
            }
        }
    }

    #[test]
    fn differences_of_coefficients_are_those_of_the_derivative() {
        let breaks = [0.0, 0.1, 0.35, 0.5, 0.52, 1.0];
        for space in [
            SplineSpace::periodic_uniform(5, 9, 2.0),
            SplineSpace::periodic_uniform(3, 2, 1.0),
            SplineSpace::periodic(5, &breaks, &[1, 3, 1, 2, 3]),
        ] {
            let mut c: Vec<f64> = (0..space.dimension())
                .map(|i| ((i * i) % 7) as f64 - 2.0)
                .collect();
            let mut f = space.spline(&c);
            let mut own = space.clone();
            for _ in 0..3 {
                let (next, factors) = own.derivative().unwrap();
                let n = c.len();
                c = (0..n)
                    .map(|i| factors[i] * (c[i] - c[(i + n - 1) % n]))
                    .collect();
                f = f.derivative();
                let spline = next.spline(&c);
                let size = f.extremes().1.value.abs();
                for k in 0..200 {
                    let x = 0.005 * f64::from(k) + 0.0013;
                    assert!((spline.eval(x) - f.eval(x)).abs() < 1e-11 * size, "{x}");
                }
                own = next;
            }
        }
        assert!(
            SplineSpace::periodic(3, &[0.0, 1.0, 2.0], &[1, 4])
                .derivative()
                .is_none()
        );
        assert!(
            SplineSpace::clamped(3, &[0.0, 1.0], &[])
                .derivative()
                .is_none()
        );
    }

    #[test]
    fn rows_differentiate_like_the_spline_itself() {
        let space = SplineSpace::periodic_uniform(5, 7, 2.0);
        let c: Vec<f64> = (0..7).map(|i| f64::from(i * i % 5)).collect();
        let mut f = space.spline(&c);
        for order in 0..4 {
            for x in [0.0, 0.2, 0.77, 1.3, 1.99] {
                let (span, u) = space.locate(x);
                let mut w = [0.0; 4];
                w[order] = 1.0;
                let row = space.row(span, u, &w);
                let value: f64 = (0..6).map(|i| row[i] * c[space.index(span, i)]).sum();
                assert!((value - f.eval(x)).abs() < 1e-9, "{order} {x}");
            }
            f = f.derivative();
        }
    }
}

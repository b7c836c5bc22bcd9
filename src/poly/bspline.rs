//! B-splines on arbitrary knots, periodic or clamped, seen piece by piece in Bernstein form.
//!
//! On one span the degree + 1 basis functions that live there are polynomials; the *extraction matrix*
//! of the span writes them in Bernstein form. Everything linear in a spline (values, derivatives, limits)
//! then becomes a short row on a few neighbouring coefficients.

use super::PiecewisePoly;

/// One non-empty knot span and the basis functions on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// Left end.
    pub start: f64,
    /// Length, positive.
    pub width: f64,
    /// Index of the first of the degree + 1 basis functions on the span (before wrapping).
    pub first: usize,
    /// Which extraction matrix the span uses.
    matrix: usize,
}

impl Span {
    /// Spans with equal numbers look alike: same knots around them, so same rows.
    pub fn matrix(&self) -> usize {
        self.matrix
    }
}

/// A space of splines of one degree on a knot vector.
///
/// ```
/// use gaitcam::poly::SplineSpace;
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
    /// Extraction matrices, (degree+1)² each, entry [k*(degree+1) + i]: Bernstein coefficient k of local
    /// basis function i. Uniform spans share one.
    matrices: Vec<Vec<f64>>,
    /// Knots of one turn of a periodic space, and its length; empty for a clamped one.
    turn: Vec<f64>,
    period: f64,
    /// Length of the knots' own unit.
    unit: f64,
}

impl SplineSpace {
    /// Periodic splines on one period: `breaks[0] ..= breaks[n]`, where the last break is the first one
    /// period later; `multiplicity[i]` (1 … degree + 1) is that of break i, 0 ≤ i < n. A break of
    /// multiplicity m joins with degree − m continuous derivatives.
    ///
    /// # Panics
    /// When breaks do not increase or lengths do not fit: a fault of the caller.
    pub fn periodic(degree: usize, breaks: &[f64], multiplicity: &[usize]) -> Self {
        let n = breaks.len() - 1;
        assert!(n >= 1 && multiplicity.len() == n);
        let one_turn: Vec<f64> = (0..n)
            .flat_map(|i| std::iter::repeat_n(breaks[i], multiplicity[i]))
            .collect();
        SplineSpace::around(degree, one_turn, breaks[n] - breaks[0])
    }

    fn around(degree: usize, one_turn: Vec<f64>, period: f64) -> Self {
        let dimension = one_turn.len();
        // Enough copies of the turn on both sides for the widest support.
        let turns = degree / dimension + 2;
        let knots: Vec<f64> = (0..2 * turns + 1)
            .flat_map(|t| {
                let shift = (t as f64 - turns as f64) * period;
                one_turn.iter().map(move |k| k + shift)
            })
            .collect();
        let offset = turns * dimension;
        let mut space = SplineSpace {
            degree,
            dimension,
            spans: Vec::new(),
            matrices: Vec::new(),
            turn: one_turn,
            period,
            unit: 1.0,
        };
        for j in 0..dimension {
            let at = offset + j;
            if knots[at + 1] > knots[at] {
                // Basis functions at−degree ..= at, counted modulo the dimension.
                let first = (at - degree) % dimension;
                space.push_span(&knots, at, first);
            }
        }
        space
    }

    /// Periodic splines on `n` equal spans of [0, period], as smooth as the degree allows.
    pub fn periodic_uniform(degree: usize, n: usize, period: f64) -> Self {
        let mut space = SplineSpace::in_whole_numbers(degree, n);
        space.stretch(period);
        space
    }

    /// Periodic splines with a knot at 0, 1 … n − 1: every span sees the same pattern, so all share a matrix.
    fn in_whole_numbers(degree: usize, n: usize) -> Self {
        let around: Vec<f64> = (0..2 * degree).map(|k| k as f64).collect();
        let turns = degree / n + 1;
        let spans = (0..n).map(|i| Span {
            start: i as f64,
            width: 1.0,
            first: (i + turns * n - degree) % n,
            matrix: 0,
        });
        SplineSpace {
            degree,
            dimension: n,
            spans: spans.collect(),
            matrices: vec![extraction(degree, &around)],
            turn: (0..n).map(|i| i as f64).collect(),
            period: n as f64,
            unit: 1.0,
        }
    }

    /// Gives a uniform space in whole numbers its length.
    fn stretch(&mut self, length: f64) {
        let n = self.dimension as f64;
        for span in &mut self.spans {
            (span.start, span.width) = (length * span.start / n, length / n);
        }
        // length·n/n need not be the length: the last break is set, not computed.
        if let Some(last) = self.spans.last_mut() {
            last.width = length - last.start;
        }
        self.unit = length / n;
    }

    /// The space of the derivatives of a periodic space, on the same knots, with the factors f of
    /// c′ᵢ = fᵢ (cᵢ − cᵢ₋₁), indices counted round.
    ///
    /// `None` for a clamped space, for degree 0 and where a break of full multiplicity lets splines jump.
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

    /// Splines on an open interval: full freedom at both ends, `multiplicity[i]` at inner break i + 1.
    ///
    /// # Panics
    /// When breaks do not increase or lengths do not fit: a fault of the caller.
    pub fn clamped(degree: usize, breaks: &[f64], multiplicity: &[usize]) -> Self {
        let n = breaks.len() - 1;
        assert!(n >= 1 && multiplicity.len() == n - 1);
        let mut knots = vec![breaks[0]; degree + 1];
        for i in 1..n {
            knots.extend(std::iter::repeat_n(breaks[i], multiplicity[i - 1]));
        }
        knots.extend(std::iter::repeat_n(breaks[n], degree + 1));
        let dimension = knots.len() - degree - 1;
        let mut space = SplineSpace {
            degree,
            dimension,
            spans: Vec::new(),
            matrices: Vec::new(),
            turn: Vec::new(),
            period: 0.0,
            unit: 1.0,
        };
        for at in degree..dimension {
            if knots[at + 1] > knots[at] {
                space.push_span(&knots, at, at - degree);
            }
        }
        space
    }

    fn push_span(&mut self, knots: &[f64], at: usize, first: usize) {
        let (start, width) = (knots[at], knots[at + 1] - knots[at]);
        let local = &knots[at + 1 - self.degree..=at + self.degree];
        // Equal knot patterns share a matrix; the previous span's is the likeliest twin.
        let same = self.spans.last().filter(|s| {
            let previous = &knots[at - self.degree..at + self.degree];
            (s.start + s.width - start).abs() < 1e-15
                && previous
                    .windows(2)
                    .zip(local.windows(2))
                    .all(|(p, q)| ((p[1] - p[0]) - (q[1] - q[0])).abs() <= 1e-14 * width)
        });
        let matrix = match same {
            Some(s) => s.matrix,
            None => {
                self.matrices.push(extraction(self.degree, local));
                self.matrices.len() - 1
            }
        };
        self.spans.push(Span {
            start,
            width,
            first,
            matrix,
        });
    }

    /// Degree of the pieces.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Number of coefficients.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Knots of one turn of a periodic space, a multiple one as often as it counts; empty for a clamped space.
    pub fn knots(&self) -> Vec<f64> {
        self.turn.iter().map(|knot| knot * self.unit).collect()
    }

    /// The non-empty spans in order.
    pub fn spans(&self) -> &[Span] {
        &self.spans
    }

    /// Index of the span that holds `x` and u ∈ [0, 1] within it.
    pub fn locate(&self, x: f64) -> (usize, f64) {
        let i = self.spans[1..].partition_point(|s| s.start <= x);
        (i, (x - self.spans[i].start) / self.spans[i].width)
    }

    /// Extraction matrix of a span, (degree+1)², entry `[k*(degree+1) + i]` as documented above.
    pub fn extraction(&self, span: usize) -> &[f64] {
        &self.matrices[self.spans[span].matrix]
    }

    /// Coefficient index of local basis function `i` on a span.
    pub fn index(&self, span: usize, i: usize) -> usize {
        (self.spans[span].first + i) % self.dimension
    }

    /// Turns weights on a span's Bernstein coefficients into weights on its local basis functions.
    pub fn pull_back(&self, span: usize, bernstein_weights: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        let rows = self.extraction(span).chunks_exact(self.degree + 1);
        for (row, weight) in rows.zip(bernstein_weights) {
            for (value, e) in out.iter_mut().zip(row) {
                *value += weight * e;
            }
        }
    }

    /// Weights on a span's local basis functions of Σ wₖ dᵏ/dxᵏ at u ∈ [0, 1] of the span.
    pub fn row(&self, span: usize, u: f64, weights: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.degree + 1];
        self.values(span, &[u], weights, &mut out);
        out
    }

    /// The same at many `places`: each local function's values there, one function after the other, into
    /// `out`.
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
    /// When `coefficients` is not as long as the dimension.
    pub fn spline(&self, coefficients: &[f64]) -> PiecewisePoly {
        assert_eq!(coefficients.len(), self.dimension);
        let n = self.degree + 1;
        let mut breaks: Vec<f64> = self.spans.iter().map(|s| s.start).collect();
        breaks.push(self.spans.last().map_or(0.0, |s| s.start + s.width));
        let mut coef = Vec::with_capacity(self.spans.len() * n);
        let mut local = vec![0.0; n];
        for (i, span) in self.spans.iter().enumerate() {
            let mut at = span.first;
            for c in &mut local {
                *c = coefficients[at];
                at = if at + 1 == self.dimension { 0 } else { at + 1 };
            }
            let rows = self.extraction(i).chunks_exact(n);
            coef.extend(
                rows.map(|row| -> f64 { row.iter().zip(&local).map(|(e, c)| e * c).sum() }),
            );
        }
        PiecewisePoly::new(breaks, self.degree, coef)
    }
}

/// The m + 1 Bernstein polynomials of degree m at `places`, one polynomial after the other.
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

/// Extraction matrix from the 2·degree knots around the span [local[d−1], local[d]], by blossoming: the
/// k-th Bernstein coefficient is the polar form at (left ×(d−k), right ×k).
fn extraction(degree: usize, local: &[f64]) -> Vec<f64> {
    let n = degree + 1;
    let mut matrix = vec![0.0; n * n];
    if degree == 0 {
        matrix[0] = 1.0;
        return matrix;
    }
    let (left, right) = (local[degree - 1], local[degree]);
    // Row j holds what entry j of the de Boor triangle takes of each basis function.
    let mut triangle = vec![0.0; n * n];
    for k in 0..n {
        triangle.fill(0.0);
        triangle.iter_mut().step_by(n + 1).for_each(|d| *d = 1.0);
        for r in 1..n {
            let x = if r <= k { right } else { left };
            for j in (r..n).rev() {
                // Knots of the de Boor triangle: t_{j} and t_{j + degree − r + 1} of the full vector.
                let (a, b) = (local[j - 1], local[j + degree - r]);
                let t = (x - a) / (b - a);
                let (before, own) = triangle.split_at_mut(j * n);
                for (d, e) in own[..n].iter_mut().zip(&before[(j - 1) * n..]) {
                    *d = (1.0 - t) * e + t * *d;
                }
            }
        }
        matrix[k * n..(k + 1) * n].copy_from_slice(&triangle[degree * n..]);
    }
    matrix
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cox–de Boor, the definition: an independent route to the same numbers.
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

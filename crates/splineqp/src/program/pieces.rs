//! Derivatives of the law in Bernstein form on all spans, and the maxima of the left sides of limits.

use super::Limit;
use crate::Names;
use crate::basis::{WIDEST, by_steps};
use crate::poly::{Peak, Span, SplineSpace, bernstein};

/// Bernstein coefficients of s, v, a, j and the fourth derivative on every span, up to the highest order in any limit.
///
/// Row k contains coefficient k of all spans, so each operation processes all spans together.
pub struct Pieces {
    spans: usize,
    degree: usize,
    /// Rows of coefficients of s, then of v and so on. Each derivative has one row fewer than the previous one.
    rows: Vec<f64>,
}

/// Bernstein coefficients of a function on every span, and the maximum coefficient of each span.
#[derive(Default)]
pub struct Curve {
    spans: usize,
    rows: Vec<f64>,
    tops: Vec<f64>,
}

impl Pieces {
    pub fn new(space: &SplineSpace, x: &[f64], highest: usize) -> Self {
        let (spans, degree) = (space.spans().len(), space.degree());
        let highest = highest.min(degree);
        let before = |order: usize| spans * (0..order).map(|k| degree + 1 - k).sum::<usize>();
        let mut rows = Vec::with_capacity(before(highest + 1));
        rows.resize(before(1), 0.0);
        fill(space, &around(space, x), &mut rows, degree + 1, |span| {
            space.extraction(span).to_vec()
        });
        if highest > 0 {
            rows.resize(before(2), 0.0);
            let steps: Vec<f64> = (around(space, x).windows(2)).map(|c| c[1] - c[0]).collect();
            fill(space, &steps, &mut rows[before(1)..], degree, |span| {
                of_steps(space, span)
            });
        }
        let rates: Vec<f64> = space.spans().iter().map(|s| 1.0 / s.width).collect();
        for order in 2..=highest {
            let factor = (degree + 1 - order) as f64;
            for k in 0..=degree - order {
                let (from, to) = (before(order - 1) + k * spans, rows.len());
                rows.resize(to + spans, 0.0);
                let (lower, own) = rows.split_at_mut(to);
                let (left, right) = lower[from..from + 2 * spans].split_at(spans);
                for (((d, left), right), rate) in own.iter_mut().zip(left).zip(right).zip(&rates) {
                    *d = factor * rate * (right - left);
                }
            }
        }
        Pieces {
            spans,
            degree,
            rows,
        }
    }

    /// Rows of Bernstein coefficients of the derivative `order`.
    fn of_order(&self, order: usize) -> &[f64] {
        let before: usize = (0..order).map(|k| self.degree + 1 - k).sum();
        &self.rows[before * self.spans..][..(self.degree + 1 - order) * self.spans]
    }

    /// Calls `visit` for each local maximum of the left side of a limit above `level`, within the domain of the limit.
    pub fn peaks_above<N: Names>(
        &self,
        space: &SplineSpace,
        limit: &Limit<N>,
        level: f64,
        room: &mut Curve,
        mut visit: impl FnMut(Peak),
    ) {
        self.each_above(space, limit, level, room, |curve, piece| {
            let span = &space.spans()[piece];
            curve.peaks_above(piece, span, limit, level, |u, value| {
                visit(Peak {
                    piece,
                    u,
                    at: span.start + u * span.width,
                    value,
                });
            });
        });
    }

    /// Calls `visit` for each piece in the domain of a limit on which the left side of the limit may exceed `level`.
    pub fn each_above<N: Names>(
        &self,
        space: &SplineSpace,
        limit: &Limit<N>,
        level: f64,
        room: &mut Curve,
        mut visit: impl FnMut(&Curve, usize),
    ) {
        self.left_side(limit, room);
        for (piece, (span, top)) in space.spans().iter().zip(&room.tops).enumerate() {
            let in_domain = span.start + span.width > limit.domain.0 && span.start < limit.domain.1;
            if *top > level && in_domain {
                visit(room, piece);
            }
        }
    }

    /// Bernstein coefficients of Σ wₖ s⁽ᵏ⁾ on every span, all with the same degree.
    fn left_side<N: Names>(&self, limit: &Limit<N>, curve: &mut Curve) {
        let lowest = limit.weights.iter().position(|w| *w != 0.0).unwrap_or(0);
        let n = (self.degree + 1).saturating_sub(lowest).max(1);
        let Curve { spans, rows, tops } = curve;
        *spans = self.spans;
        rows.clear();
        rows.resize(n * self.spans, 0.0);
        let mut lifted = Vec::new();
        for (order, &weight) in limit.weights.iter().enumerate().skip(lowest) {
            if weight == 0.0 || order > self.degree {
                continue;
            }
            let mut own = self.of_order(order);
            if own.len() < rows.len() {
                lifted.clear();
                lifted.extend_from_slice(own);
                while lifted.len() < rows.len() {
                    elevate(&mut lifted, self.spans);
                }
                own = &lifted;
            }
            for (sum, b) in rows.iter_mut().zip(own) {
                *sum += weight * b;
            }
        }
        let (first, others) = rows.split_at(self.spans);
        tops.clear();
        tops.extend_from_slice(first);
        for row in others.chunks_exact(self.spans) {
            for (top, b) in tops.iter_mut().zip(row) {
                *top = if *b > *top { *b } else { *top };
            }
        }
    }
}

impl Curve {
    /// Bernstein coefficients of the function on one piece.
    pub fn on<'a>(&self, piece: usize, room: &'a mut [f64; WIDEST]) -> &'a [f64] {
        let rows = self.rows.chunks_exact(self.spans);
        let n = rows.len();
        for (b, row) in room.iter_mut().zip(rows) {
            *b = row[piece];
        }
        &room[..n]
    }

    /// Calls `visit` for each local maximum above `level` on one piece, within the domain of `limit`.
    fn peaks_above<N: Names>(
        &self,
        piece: usize,
        span: &Span,
        limit: &Limit<N>,
        level: f64,
        mut visit: impl FnMut(f64, f64),
    ) {
        let (mut own, mut beside) = ([0.0; WIDEST], [0.0; WIDEST]);
        let b = self.on(piece, &mut own);
        let from = (limit.domain.0 - span.start) / span.width;
        let to = (limit.domain.1 - span.start) / span.width;
        if from >= 1.0 || to <= 0.0 {
            return;
        }
        if from > 0.0 || to < 1.0 {
            let (from, to) = (from.max(0.0), to.min(1.0));
            let inside = bernstein::between(b, from, to);
            bernstein::peaks_above(&inside, level, |u, value| {
                visit(from + u * (to - from), value);
            });
            return;
        }
        // If the curve is continuous over a break, the end of a piece is a maximum only if the adjacent end of the next piece is also a
        // maximum. The left one of these two ends is used.
        let n = b.len();
        let climbs_on = piece + 1 < self.spans && n > 1 && {
            let next = self.on(piece + 1, &mut beside);
            // Because of rounding, the curve may appear to rise beyond a maximum on the break.
            let flat = bernstein::rounding(next);
            joins(b[n - 1], next[0], level) && next[1] > next[0] + flat
        };
        let came_down = piece > 0 && n > 1 && {
            let end = self.rows[(n - 1) * self.spans + piece - 1];
            joins(end, b[0], level)
        };
        bernstein::peaks_above(b, level, |u, value| {
            if !(u == 1.0 && climbs_on || u == 0.0 && came_down) {
                visit(u, value);
            }
        });
    }
}

/// Spline coefficients in cyclic order. The first coefficients are repeated at the end, so that the coefficients of each span are
/// contiguous.
fn around(space: &SplineSpace, x: &[f64]) -> Vec<f64> {
    let mut around = Vec::with_capacity(space.dimension() + space.degree());
    around.extend_from_slice(&x[..space.dimension()]);
    (0..space.degree()).for_each(|i| around.push(around[i]));
    around
}

/// Matrix, by rows, that converts the differences of consecutive spline coefficients to the Bernstein coefficients of the velocity on a
/// span.
fn of_steps(space: &SplineSpace, span: usize) -> Vec<f64> {
    let n = space.degree() + 1;
    let factor = space.degree() as f64 / space.spans()[span].width;
    let lift = space.extraction(span);
    let mut weights = Vec::with_capacity(n * (n - 1));
    for (own, next) in lift.chunks_exact(n).zip(lift[n..].chunks_exact(n)) {
        let from = weights.len();
        weights.extend(
            own.iter()
                .zip(next)
                .map(|(own, next)| factor * (next - own)),
        );
        by_steps(&mut weights[from..]);
        weights.pop();
    }
    weights
}

/// Writes the Bernstein coefficients of a function on all spans, one row per coefficient. Each coefficient is the inner product of `n`
/// weights of the span and `n` consecutive values of `own`.
fn fill(
    space: &SplineSpace,
    own: &[f64],
    rows: &mut [f64],
    n: usize,
    weights: impl Fn(usize) -> Vec<f64>,
) {
    let (spans, turn) = (space.spans(), space.dimension());
    let mut begin = 0;
    while begin < spans.len() {
        let first = space.index(begin, 0);
        // Consecutive spans with equal weights, each shifted by one coefficient.
        let alike = (spans[begin..].iter().enumerate()).take_while(|(i, span)| {
            span.matrix() == spans[begin].matrix()
                && span.first == spans[begin].first + i
                && first + i < turn
        });
        let run = alike.count();
        let weights = weights(begin);
        for (row, weights) in (rows.chunks_exact_mut(spans.len())).zip(weights.chunks_exact(n)) {
            let (row, own) = (&mut row[begin..begin + run], &own[first..]);
            match n {
                5 => products(row, own, &weights[..5]),
                6 => products(row, own, &weights[..6]),
                _ => products(row, own, weights),
            }
        }
        begin += run;
    }
}

/// Inner products of the weights with consecutive coefficients, starting at each coefficient.
#[inline(always)]
fn products(out: &mut [f64], coefficients: &[f64], weights: &[f64]) {
    for (out, own) in out.iter_mut().zip(coefficients.windows(weights.len())) {
        *out = weights.iter().zip(own).map(|(w, c)| w * c).sum();
    }
}

/// Whether the values on both sides of a break are equal up to rounding errors, relative to the larger of |`left`| and |`level`|.
fn joins(left: f64, right: f64, level: f64) -> bool {
    (left - right).abs() <= 1e-12 * left.abs().max(level.abs())
}

/// Raises the degree of the polynomials by one. Each row contains one Bernstein coefficient of all spans.
fn elevate(rows: &mut Vec<f64>, spans: usize) {
    let m = rows.len() / spans;
    rows.extend_from_within((m - 1) * spans..);
    for i in (1..m).rev() {
        let t = i as f64 / m as f64;
        let (before, own) = rows.split_at_mut(i * spans);
        for (b, left) in own[..spans].iter_mut().zip(&before[(i - 1) * spans..]) {
            *b = t * left + (1.0 - t) * *b;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::Basis;

    /// Spline spaces for tests: a uniform space, a space with fewer spans than B-splines on a span, a space with breaks of any
    /// multiplicity, and an open space.
    fn spaces() -> [SplineSpace; 4] {
        let breaks = [0.0, 0.4, 1.3, 2.0, 2.2, 4.0];
        [
            SplineSpace::periodic_uniform(5, 9, 4.0),
            SplineSpace::periodic_uniform(5, 3, 4.0),
            SplineSpace::periodic(4, &breaks, &[1, 3, 1, 2, 2]),
            SplineSpace::clamped(5, &breaks, &[1, 2, 1, 1]),
        ]
    }

    #[test]
    fn maxima_are_those_of_the_piecewise_polynomial() {
        for space in spaces() {
            let x: Vec<f64> = (0..space.dimension())
                .map(|i| ((i * i) % 7) as f64 - 2.0)
                .collect();
            let pieces = Pieces::new(&space, &x, 3);
            let basis = Basis::Spline {
                space: space.clone(),
                closed: false,
            };
            for [s, v, a, j] in [
                [0.0, 0.0, 1.0, 0.0],
                [0.0, 0.0, 0.0, -1.0],
                [1.0, -0.5, 0.2, 0.0],
            ] {
                let curve = basis.combination(&x, &[s, v, a, j, 0.0]);
                let (low, high) = curve.extremes();
                let limit = Limit {
                    domain: (0.0, 4.0),
                    ..Limit::<()>::on("peak", [s, v, a, j, 0.0]).at_most(0.0)
                };
                let size = high.value.max(-low.value);
                let mut most = f64::NEG_INFINITY;
                let level = low.value - size;
                pieces.peaks_above(&space, &limit, level, &mut Curve::default(), |peak| {
                    most = most.max(peak.value);
                    let [b, e] = [0, 1].map(|k| curve.breaks()[peak.piece + k]);
                    assert!((b + peak.u * (e - b) - peak.at).abs() < 1e-12);
                    let here = bernstein::eval(curve.piece(peak.piece), peak.u);
                    assert!((here - peak.value).abs() < 1e-11 * size);
                });
                assert!((most - high.value).abs() < 1e-11 * size);
            }
        }
    }
}

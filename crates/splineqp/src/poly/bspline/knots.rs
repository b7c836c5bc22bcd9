//! Spline spaces from knot vectors: spans and their extraction matrices.

use std::borrow::Cow;
use std::sync::OnceLock;

use super::{Span, SplineSpace};

impl SplineSpace {
    /// Periodic splines on one period `breaks[0] ..= breaks[n]`. The last break is the first break, shifted by the period. The knot at
    /// break i, 0 ≤ i < n, has the multiplicity `multiplicity[i]` (1 … degree + 1). At a break of multiplicity m, degree − m derivatives
    /// are continuous.
    ///
    /// # Panics
    ///
    /// If the breaks do not increase or the lengths do not match, which is an error of the caller.
    pub fn periodic(degree: usize, breaks: &[f64], multiplicity: &[usize]) -> Self {
        let n = breaks.len() - 1;
        assert!(n >= 1 && multiplicity.len() == n);
        let one_turn: Vec<f64> = (0..n)
            .flat_map(|i| std::iter::repeat_n(breaks[i], multiplicity[i]))
            .collect();
        SplineSpace::around(degree, one_turn, breaks[n] - breaks[0])
    }

    pub(super) fn around(degree: usize, one_turn: Vec<f64>, period: f64) -> Self {
        let dimension = one_turn.len();
        // Copies of the turn on both sides, to contain the widest support.
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

    /// Periodic splines on `n` equal spans of [0, period]. At the breaks, degree − 1 derivatives are continuous.
    pub fn periodic_uniform(degree: usize, n: usize, period: f64) -> Self {
        let mut space = SplineSpace::in_whole_numbers(degree, n);
        space.stretch(period);
        space
    }

    /// Periodic splines with knots at 0, 1 … n − 1. All spans have the same knot pattern and share an extraction matrix.
    pub(super) fn in_whole_numbers(degree: usize, n: usize) -> Self {
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
            matrices: vec![uniform(degree).into_owned()],
            turn: (0..n).map(|i| i as f64).collect(),
            period: n as f64,
            unit: 1.0,
        }
    }

    /// Scales a uniform space with integer knots to the period `length`.
    pub(super) fn stretch(&mut self, length: f64) {
        let n = self.dimension as f64;
        for span in &mut self.spans {
            (span.start, span.width) = (length * span.start / n, length / n);
        }
        // length·n/n may differ from the length by a rounding error, so the last break is set exactly.
        if let Some(last) = self.spans.last_mut() {
            last.width = length - last.start;
        }
        self.unit = length / n;
    }

    /// Splines on an interval, without conditions at its ends. The knot at the inner break i + 1 has the multiplicity `multiplicity[i]`.
    ///
    /// # Panics
    ///
    /// If the breaks do not increase or the lengths do not match, which is an error of the caller.
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
        // Spans with the same knot pattern share a matrix. Only the previous span is compared.
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
}

/// Extraction matrix of a span with equally spaced knots. The matrices of common degrees are computed only once.
fn uniform(degree: usize) -> Cow<'static, [f64]> {
    static USUAL: [OnceLock<Vec<f64>>; 10] = [const { OnceLock::new() }; 10];
    let own = || {
        let around: Vec<f64> = (0..2 * degree).map(|k| k as f64).collect();
        extraction(degree, &around)
    };
    match USUAL.get(degree) {
        Some(known) => known.get_or_init(own).into(),
        None => own().into(),
    }
}

/// Extraction matrix from the 2·degree knots around the span [local[d−1], local[d]], by blossoming. Bernstein coefficient k is a value of
/// the polar form (blossom): d − k arguments equal the left end of the span, and k arguments equal the right end.
fn extraction(degree: usize, local: &[f64]) -> Vec<f64> {
    let n = degree + 1;
    let mut matrix = vec![0.0; n * n];
    if degree == 0 {
        matrix[0] = 1.0;
        return matrix;
    }
    let (left, right) = (local[degree - 1], local[degree]);
    // Row j contains the weights of the basis functions in entry j of the de Boor triangle.
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

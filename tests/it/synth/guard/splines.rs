//! Periodic B-splines by the recursion of Cox and de Boor, on breaks of any multiplicity; Gauss points.

use std::f64::consts::{PI, TAU};

/// Number of orders: s, v, a, j.
pub const ORDERS: usize = 4;

/// Periodic splines of one degree over a turn.
pub struct Splines {
    degree: usize,
    breaks: Vec<f64>,
    /// Knots in [0, 2π), repeated by multiplicity.
    knots: Vec<f64>,
    /// Last knot at each break.
    last: Vec<isize>,
}

impl Splines {
    /// Splines on `breaks` from 0 to 2π. `multiplicity` is given for all breaks except the last, which equals the first one turn later.
    pub fn new(degree: usize, breaks: Vec<f64>, multiplicity: &[usize]) -> Self {
        let (mut knots, mut last) = (Vec::new(), Vec::new());
        for (at, times) in breaks.iter().zip(multiplicity) {
            knots.extend(std::iter::repeat_n(*at, *times));
            last.push(knots.len() as isize - 1);
        }
        Splines {
            degree,
            breaks,
            knots,
            last,
        }
    }

    /// Splines of equal spans over a turn.
    pub fn equal(degree: usize, spans: usize) -> Self {
        let breaks = (0..=spans).map(|i| TAU * i as f64 / spans as f64).collect();
        Splines::new(degree, breaks, &vec![1; spans])
    }

    /// Number of basis functions.
    pub fn count(&self) -> usize {
        self.knots.len()
    }

    pub fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    pub fn spans(&self) -> usize {
        self.breaks.len() - 1
    }

    /// Span of an angle. A break belongs to the span after it.
    pub fn span_of(&self, theta: f64) -> usize {
        let after = self.breaks.partition_point(|b| *b <= theta);
        after.clamp(1, self.spans()) - 1
    }

    fn knot(&self, k: isize) -> f64 {
        let n = self.knots.len() as isize;
        self.knots[k.rem_euclid(n) as usize] + TAU * k.div_euclid(n) as f64
    }

    /// Indices of the basis functions that are not zero on a span.
    pub fn columns(&self, span: usize) -> impl Iterator<Item = usize> + '_ {
        let (first, n) = (
            self.last[span] - self.degree as isize,
            self.count() as isize,
        );
        (0..=self.degree as isize).map(move |k| (first + k).rem_euclid(n) as usize)
    }

    /// Derivatives of order 0 to 3 of these functions at an angle of the span, ends included.
    pub fn values(&self, span: usize, theta: f64) -> [Vec<f64>; ORDERS] {
        let (p, m) = (self.degree, self.last[span]);
        // N[k] is B with m − q + k as its first knot, k = 0 … q.
        let mut plain = vec![vec![1.0]];
        for q in 1..=p {
            let below = &plain[q - 1];
            plain.push(self.raised(m, q, below, |left, right, low, high| {
                (theta - left.0) * low / left.1 + (right.0 - theta) * high / right.1
            }));
        }
        std::array::from_fn(|order| {
            if order > p {
                return vec![0.0; p + 1];
            }
            let mut n = plain[p - order].clone();
            for q in p - order + 1..=p {
                n = self.raised(m, q, &n, |left, right, low, high| {
                    q as f64 * (low / left.1 - high / right.1)
                });
            }
            n
        })
    }

    /// Step from degree q − 1 to q: `rule((first knot, width), (last knot, width), lower, higher)`.
    fn raised(
        &self,
        m: isize,
        q: usize,
        below: &[f64],
        rule: impl Fn((f64, f64), (f64, f64), f64, f64) -> f64,
    ) -> Vec<f64> {
        let q = q as isize;
        let one = |k: isize| {
            let j = m - q + k;
            let left = (self.knot(j), self.knot(j + q) - self.knot(j));
            let right = (
                self.knot(j + q + 1),
                self.knot(j + q + 1) - self.knot(j + 1),
            );
            let low = if k > 0 { below[k as usize - 1] } else { 0.0 };
            let high = if k < q { below[k as usize] } else { 0.0 };
            let (left, right) = (
                if k > 0 { left } else { (0.0, 1.0) },
                if k < q { right } else { (0.0, 1.0) },
            );
            rule(left, right, low, high)
        };
        (0..=q).map(one).collect()
    }

    /// Row over all coefficients of Σ wₖ s⁽ᵏ⁾ at an angle of a span.
    pub fn row(&self, span: usize, theta: f64, weights: [f64; ORDERS]) -> Vec<f64> {
        let values = self.values(span, theta);
        let mut row = vec![0.0; self.count()];
        for (k, column) in self.columns(span).enumerate() {
            row[column] += (0..ORDERS).map(|d| weights[d] * values[d][k]).sum::<f64>();
        }
        row
    }

    /// s, v, a, j of the law with these coefficients.
    pub fn law(&self, span: usize, theta: f64, x: &[f64]) -> [f64; ORDERS] {
        let values = self.values(span, theta);
        std::array::from_fn(|d| {
            let columns = self.columns(span).zip(&values[d]);
            columns.map(|(i, b)| x[i] * b).sum()
        })
    }
}

/// Nodes and weights of Gaussian quadrature on [0, 1], by Newton's method on the Legendre polynomial.
pub fn gauss(n: usize) -> Vec<(f64, f64)> {
    let node = |i: usize| {
        let mut x = (PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..60 {
            let (mut p, mut before) = (1.0, 0.0);
            for k in 0..n {
                let k = k as f64;
                (p, before) = (((2.0 * k + 1.0) * x * p - k * before) / (k + 1.0), p);
            }
            slope = n as f64 * (x * p - before) / (x * x - 1.0);
            x -= p / slope;
        }
        (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(node).collect()
}

#[test]
fn functions_sum_to_one_and_derivatives_are_slopes() {
    let breaks = vec![0.0, 0.7, 1.9, 3.0, 4.4, 5.0, 5.9, TAU];
    for degree in 3..=7 {
        let splines = Splines::new(degree, breaks.clone(), &[1, 2, 1, 1, 1, 2, 1]);
        let x: Vec<f64> = (0..splines.count())
            .map(|i| (1.7 * i as f64).sin())
            .collect();
        for theta in [0.0, 0.3, 0.71, 2.2, 4.0, 5.5, 6.2] {
            let span = splines.span_of(theta);
            let at = splines.values(span, theta);
            assert!((at[0].iter().sum::<f64>() - 1.0).abs() < 1e-14);
            let d = 1e-5;
            let (here, next) = (
                splines.law(span, theta, &x),
                splines.law(span, theta + d, &x),
            );
            let middle = splines.law(span, theta + 0.5 * d, &x);
            for k in 0..3 {
                let slope = (next[k] - here[k]) / d;
                assert!((slope - middle[k + 1]).abs() < 1e-4 * (1.0 + middle[k + 1].abs()));
            }
        }
    }
    let rule = gauss(5);
    let integral: f64 = rule.iter().map(|(x, w)| w * x.powi(9)).sum();
    assert!((integral - 0.1).abs() < 1e-15, "{integral}");
}

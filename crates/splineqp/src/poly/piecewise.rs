//! Piecewise polynomials on consecutive intervals.

use super::{Extreme, bernstein};
use serde::Serialize;

/// Piecewise polynomial on `breaks[0] ..= breaks[n]`. Each piece is in Bernstein form on its interval.
///
/// The pieces need not be continuous at the breaks. At a break, the piece to its right determines the value.
///
/// ```
/// use splineqp::poly::PiecewisePoly;
///
/// // 4 x (1 − x) on [0, 1], in Bernstein form.
/// let hump = PiecewisePoly::new(vec![0.0, 1.0], 2, vec![0.0, 2.0, 0.0]);
/// let (low, high) = hump.extremes();
/// assert!((high.at - 0.5).abs() < 1e-12 && (high.value - 1.0).abs() < 1e-12);
/// assert_eq!(low.value, 0.0);
/// assert!((hump.integral() - 2.0 / 3.0).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PiecewisePoly {
    breaks: Vec<f64>,
    degree: usize,
    /// Bernstein coefficients by rows: piece i starts at `coef[i*(degree+1)]`.
    #[serde(rename = "coefficients")]
    coef: Vec<f64>,
}

/// Relative difference below which two values are equal up to rounding errors.
const SAME: f64 = 1e-12;

/// Minimum and maximum of the values that were compared so far.
struct Range {
    low: Extreme,
    high: Extreme,
}

impl Range {
    /// Updates the extremes. Of two values that are equal up to rounding errors, the first is kept.
    fn take(&mut self, at: f64, value: f64) {
        let tie = SAME * value.abs();
        if value < self.low.value {
            let farther = value < self.low.value - tie;
            let at = if farther { at } else { self.low.at };
            self.low = Extreme { at, value };
        }
        if value > self.high.value {
            let farther = value > self.high.value + tie;
            let at = if farther { at } else { self.high.at };
            self.high = Extreme { at, value };
        }
    }
}

/// Local maximum of a piecewise polynomial. The index of the piece distinguishes the two sides of a break.
///
/// ```
/// use splineqp::poly::PiecewisePoly;
///
/// // 4u(1 − u) has its maximum 1 at u = 1/2.
/// let arc = PiecewisePoly::new(vec![0.0, 1.0], 2, vec![0.0, 2.0, 0.0]);
/// let peaks = arc.peaks_above(0.5, 0.0, 1.0);
/// assert!((peaks[0].at - 0.5).abs() < 1e-9 && (peaks[0].value - 1.0).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Peak {
    /// Index of the piece on which the maximum is.
    pub piece: usize,
    /// Position u on the piece, from 0 at its start to 1 at its end.
    pub u: f64,
    /// Abscissa of the maximum, in the units of the breaks.
    pub at: f64,
    /// Value of the function at the maximum.
    pub value: f64,
}

impl Peak {
    /// Peak with the value 0 at a given position.
    pub fn place(piece: usize, u: f64, at: f64) -> Peak {
        let value = 0.0;
        Peak {
            piece,
            u,
            at,
            value,
        }
    }
}

impl PiecewisePoly {
    /// Creates the function from increasing breaks (n + 1) and n·(degree + 1) Bernstein coefficients, piece by piece.
    ///
    /// # Panics
    ///
    /// If the lengths do not match or the breaks do not increase, which is an error of the caller.
    pub fn new(breaks: Vec<f64>, degree: usize, coef: Vec<f64>) -> Self {
        assert!(breaks.len() >= 2 && coef.len() == (breaks.len() - 1) * (degree + 1));
        assert!(
            breaks.windows(2).all(|w| w[0] < w[1]),
            "breaks must increase"
        );
        PiecewisePoly {
            breaks,
            degree,
            coef,
        }
    }

    /// Function with the same breaks and the given Bernstein coefficients.
    fn with_pieces(&self, degree: usize, coef: Vec<f64>) -> Self {
        PiecewisePoly {
            breaks: self.breaks.clone(),
            degree,
            coef,
        }
    }

    /// Breaks in ascending order. The number of breaks is the number of pieces plus one.
    #[inline]
    pub fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    /// Degree of the polynomials of all pieces.
    #[inline]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Number of polynomial pieces.
    #[inline]
    pub fn pieces(&self) -> usize {
        self.breaks.len() - 1
    }

    /// Bernstein coefficients of piece `i`.
    #[inline]
    pub fn piece(&self, i: usize) -> &[f64] {
        &self.coef[i * (self.degree + 1)..(i + 1) * (self.degree + 1)]
    }

    /// Bernstein coefficients of all pieces, piece by piece.
    #[inline]
    pub fn coefficients(&self) -> &[f64] {
        &self.coef
    }

    /// Index of the piece that contains `x`, and position u ∈ [0, 1] on it. Outside the breaks, it is the first or the last piece, and u is
    /// outside [0, 1].
    #[inline]
    pub fn locate(&self, x: f64) -> (usize, f64) {
        let i = self.breaks[1..self.breaks.len() - 1].partition_point(|&b| b <= x);
        let (a, b) = (self.breaks[i], self.breaks[i + 1]);
        (i, (x - a) / (b - a))
    }

    /// Value at `x`. Outside the breaks, the end pieces are extended.
    #[inline]
    pub fn eval(&self, x: f64) -> f64 {
        let (i, u) = self.locate(x);
        bernstein::eval(self.piece(i), u)
    }

    /// Derivative of every piece. Jumps at breaks are ignored.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let n = self.degree;
        if n == 0 {
            return self.map(0, |_, _| vec![0.0]);
        }
        let mut coef = Vec::with_capacity(self.pieces() * n);
        for (b, ends) in self.coef.chunks_exact(n + 1).zip(self.breaks.windows(2)) {
            let scale = n as f64 / (ends[1] - ends[0]);
            coef.extend(b.windows(2).map(|w| (w[1] - w[0]) * scale));
        }
        self.with_pieces(n - 1, coef)
    }

    /// Integral over the range from the first to the last break.
    pub fn integral(&self) -> f64 {
        let n = (self.degree + 1) as f64;
        (0..self.pieces())
            .map(|i| self.piece(i).iter().sum::<f64>() / n * (self.breaks[i + 1] - self.breaks[i]))
            .sum()
    }

    /// Exact integral of the square over the whole range.
    pub fn integral_of_square(&self) -> f64 {
        let gram = bernstein::gram(self.degree);
        (self
            .coef
            .chunks_exact(self.degree + 1)
            .zip(self.breaks.windows(2)))
        .map(|(b, ends)| bernstein::square(&gram, b) * (ends[1] - ends[0]))
        .sum()
    }

    /// Applies `f(coefficients, width)` to every piece. The result has the degree `degree`.
    pub fn map(&self, degree: usize, f: impl Fn(&[f64], f64) -> Vec<f64>) -> Self {
        let mut coef = Vec::with_capacity(self.pieces() * (degree + 1));
        for i in 0..self.pieces() {
            let piece = f(self.piece(i), self.breaks[i + 1] - self.breaks[i]);
            coef.extend(bernstein::elevate(&piece, degree));
        }
        self.with_pieces(degree, coef)
    }

    /// Weighted sum of functions with the same breaks, plus a constant.
    ///
    /// # Panics
    ///
    /// If the breaks differ.
    pub fn combine(terms: &[(f64, &PiecewisePoly)], constant: f64) -> Self {
        let first = terms[0].1;
        let degree = terms.iter().map(|t| t.1.degree).max().unwrap_or(0);
        let mut coef = vec![constant; first.pieces() * (degree + 1)];
        for (weight, p) in terms {
            assert_eq!(p.breaks, first.breaks, "sums need equal breaks");
            if *weight == 0.0 {
                continue;
            }
            if p.degree == degree {
                coef.iter_mut()
                    .zip(&p.coef)
                    .for_each(|(c, x)| *c += weight * x);
                continue;
            }
            for i in 0..p.pieces() {
                let lifted = bernstein::elevate(p.piece(i), degree);
                for (k, x) in lifted.iter().enumerate() {
                    coef[i * (degree + 1) + k] += weight * x;
                }
            }
        }
        first.with_pieces(degree, coef)
    }

    /// Product of two functions with the same breaks.
    ///
    /// # Panics
    ///
    /// If the breaks differ.
    #[must_use]
    pub fn times(&self, other: &PiecewisePoly) -> Self {
        assert_eq!(self.breaks, other.breaks, "products need equal breaks");
        let degree = self.degree + other.degree;
        let coef = (0..self.pieces())
            .flat_map(|i| bernstein::product(self.piece(i), other.piece(i)))
            .collect();
        self.with_pieces(degree, coef)
    }

    /// Minimum and maximum over the whole range, from the roots of the derivative and the values on both sides of every break.
    pub fn extremes(&self) -> (Extreme, Extreme) {
        let start = Extreme {
            at: self.breaks[0],
            value: self.piece(0)[0],
        };
        let mut range = Range {
            low: start,
            high: start,
        };
        // The ends of the pieces are evaluated first. A piece whose hull lies between the minimum and the maximum end value contains no
        // extreme.
        let (mut lowest_end, mut highest_end) = (start.value, start.value);
        for b in self.coef.chunks_exact(self.degree + 1) {
            for end in [b[0], b[self.degree]] {
                lowest_end = if end < lowest_end { end } else { lowest_end };
                highest_end = if end > highest_end { end } else { highest_end };
            }
        }
        let mut critical = Vec::new();
        for i in 0..self.pieces() {
            let b = self.piece(i);
            let (a, width) = (self.breaks[i], self.breaks[i + 1] - self.breaks[i]);
            range.take(a, b[0]);
            range.take(a + width, b[self.degree]);
            let (least, most) = bernstein::hull(b);
            let lower = least < range.low.value && least < lowest_end;
            if lower || most > range.high.value && most > highest_end {
                critical.clear();
                bernstein::add_critical(b, &mut critical);
                for &u in &critical {
                    range.take(a + u * width, bernstein::eval(b, u));
                }
            }
        }
        (range.low, range.high)
    }

    /// Local maxima above `level` on [from, to], limited to the range of the breaks. An end of a piece counts as a maximum if the function
    /// rises towards it.
    pub fn peaks_above(&self, level: f64, from: f64, to: f64) -> Vec<Peak> {
        let mut out = Vec::new();
        for i in 0..self.pieces() {
            let (a, width) = (self.breaks[i], self.breaks[i + 1] - self.breaks[i]);
            let (lo, hi) = ((from - a) / width, (to - a) / width);
            if bernstein::hull(self.piece(i)).1 <= level || lo >= 1.0 || hi <= 0.0 {
                continue;
            }
            let (lo, hi) = (lo.max(0.0), hi.min(1.0));
            let whole = lo == 0.0 && hi == 1.0;
            let clipped = if whole {
                self.piece(i).to_vec()
            } else {
                bernstein::between(self.piece(i), lo, hi)
            };
            bernstein::peaks_above(&clipped, level, |u, value| {
                let u = lo + u * (hi - lo);
                out.push(Peak {
                    piece: i,
                    u,
                    at: a + u * width,
                    value,
                });
            });
        }
        out
    }

    /// The function with its pieces divided at further breaks within the range.
    #[must_use]
    pub fn cut_at(&self, further: &[f64]) -> Self {
        if further == self.breaks {
            return self.clone();
        }
        let mut breaks = vec![self.breaks[0]];
        let mut coef = Vec::new();
        let mut k = further.partition_point(|&x| x <= self.breaks[0]);
        for i in 0..self.pieces() {
            let (a, b) = (self.breaks[i], self.breaks[i + 1]);
            let mut rest = self.piece(i).to_vec();
            let mut at = a;
            while k < further.len() && further[k] < b {
                let x = further[k];
                k += 1;
                if x <= at {
                    continue;
                }
                let (left, right) = bernstein::split(&rest, (x - at) / (b - at));
                coef.extend(left);
                breaks.push(x);
                rest = right;
                at = x;
            }
            while k < further.len() && further[k] <= b {
                k += 1;
            }
            coef.extend(rest);
            breaks.push(b);
        }
        PiecewisePoly {
            breaks,
            degree: self.degree,
            coef,
        }
    }

    /// Points at which the function changes sign, in ascending order, including jumps from one sign to the other.
    pub fn roots(&self) -> Vec<f64> {
        let mut out: Vec<f64> = Vec::new();
        for i in 0..self.pieces() {
            let b = self.piece(i);
            let (a, width) = (self.breaks[i], self.breaks[i + 1] - self.breaks[i]);
            if i > 0 {
                let before = self.piece(i - 1)[self.degree];
                if before * b[0] < 0.0 || (b[0] == 0.0 && before != 0.0) {
                    out.push(a);
                }
            }
            out.extend(bernstein::roots(b).into_iter().map(|u| a + u * width));
        }
        out.dedup_by(|x, y| (*x - *y).abs() <= 1e-14 * (1.0 + x.abs()));
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x(1−x)(x−2) on two pieces, with the extremes at 1 ± 1/√3.
    fn cubic() -> PiecewisePoly {
        let on = |a: f64, w: f64| {
            let f = |x: f64| [x, 1.0 - x, x - 2.0];
            let (p, q) = (f(a), f(a + w));
            let lines: Vec<[f64; 2]> = (0..3).map(|k| [p[k], q[k]]).collect();
            bernstein::product(&bernstein::product(&lines[0], &lines[1]), &lines[2])
        };
        let coef = [on(0.0, 0.75), on(0.75, 1.25)].concat();
        PiecewisePoly::new(vec![0.0, 0.75, 2.0], 3, coef)
    }

    #[test]
    fn extremes_are_the_roots_of_the_derivative() {
        let p = cubic();
        let (low, high) = p.extremes();
        let r = 1.0 / 3.0_f64.sqrt();
        assert!((low.at - (1.0 - r)).abs() < 1e-14 && (high.at - (1.0 + r)).abs() < 1e-14);
        assert!((high.value - 2.0 * r / 3.0).abs() < 1e-15);
        assert_eq!(p.roots().len(), 1);
        assert!((p.roots()[0] - 1.0).abs() < 1e-14);
        let peaks = p.peaks_above(0.1, 0.0, 2.0);
        assert_eq!(peaks.len(), 1);
        assert!((peaks[0].at - high.at).abs() < 1e-14);
        let clipped = p.peaks_above(0.1, 0.0, 1.5);
        assert!((clipped[0].at - 1.5).abs() < 1e-15 && (clipped[0].value - 0.375).abs() < 1e-14);
        let cut = p.cut_at(&[0.0, 0.1, 0.75, 1.9, 2.0]);
        assert_eq!(cut.pieces(), 4);
        assert!(
            [0.05, 0.5, 1.0, 1.95]
                .iter()
                .all(|&x| (cut.eval(x) - p.eval(x)).abs() < 1e-15)
        );
    }

    #[test]
    fn integrals_match_closed_forms() {
        let p = cubic();
        assert!(p.integral().abs() < 1e-15);
        // ∫₀² (x(1−x)(x−2))² dx = 16/105.
        assert!((p.integral_of_square() - 16.0 / 105.0).abs() < 1e-14);
    }
}

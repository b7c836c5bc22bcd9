//! Least-squares approximation of cells by polynomials.

use super::{Cells, Ends, restricted};
use crate::poly::{bernstein, gauss_legendre};

/// Distance, in cells, below which a break coincides with the end of a cell.
const SAME: f64 = 1e-11;

impl Cells {
    /// Least-squares approximation of the function by a polynomial of degree `degree` on every range between breaks of the first period.
    /// The result contains the values of the polynomials at the degree + 1 nodes of [`gauss_legendre`], range by range. Replacing the
    /// function by the approximation does not change its integrals with polynomials of this degree. The discontinuities between the cells
    /// therefore cause no error.
    ///
    /// # Panics
    ///
    /// If the degree is above 9, because the rounding errors of the powers would be too large.
    pub fn nearest(&self, breaks: &[f64], degree: usize) -> Vec<f64> {
        match degree {
            0 => Nearest::<1>::new(self, breaks).values(),
            1 => Nearest::<2>::new(self, breaks).values(),
            2 => Nearest::<3>::new(self, breaks).values(),
            3 => Nearest::<4>::new(self, breaks).values(),
            4 => Nearest::<5>::new(self, breaks).values(),
            5 => Nearest::<6>::new(self, breaks).values(),
            6 => Nearest::<7>::new(self, breaks).values(),
            7 => Nearest::<8>::new(self, breaks).values(),
            8 => Nearest::<9>::new(self, breaks).values(),
            9 => Nearest::<10>::new(self, breaks).values(),
            _ => panic!("no nearest polynomial of degree {degree}"),
        }
    }
}

/// Approximation by polynomials of degree N − 1, from the moments ∫ f xʲ dx with x ∈ [−1, 1] on the range.
///
/// On whole cells of the width w, the function f is a sum of Hermite cubics. Each end X of a cell, with the value f and the slope s, has
/// one even and one odd cubic. The contribution of an end to the integral over the cell on its right is
///
/// ```text
/// ∫ f xʲ = Σₖ C(j, k) Xʲ⁻ᵏ wᵏ⁺¹ (aₖ f + bₖ s),   aₖ = ∫₀¹ (1 − 3t² + 2t³) tᵏ,   bₖ = ∫₀¹ (t − 2t² + t³) tᵏ
/// ```
///
/// In its contribution to the cell on its left, the last factor is (−1)ᵏ (aₖ f − bₖ s). The moments are therefore combinations of the sums
/// Σ Xᵃ f and Σ Xᵃ s over the ends. The first and the last end have a cell on one side only.
struct Nearest<'a, const N: usize> {
    cells: &'a Cells,
    breaks: &'a [f64],
    /// Binomial coefficient C(j, k) times the factor of each entry of [`Sums`], indexed by j and k.
    shares: [[[f64; 4]; N]; N],
    /// Contribution of each moment to the values at the nodes.
    values: [[f64; N]; N],
}

/// Four sums for each power a. The first sum is Xᵃ f over both sides of all ends. The second sum is Xᵃ f at the first end minus Xᵃ f at the
/// last end. The other two sums contain s instead of f.
type Sums<const N: usize> = [[f64; 4]; N];

impl<'a, const N: usize> Nearest<'a, N> {
    fn new(cells: &'a Cells, breaks: &'a [f64]) -> Self {
        let mut shares = [[[0.0; 4]; N]; N];
        for (j, row) in shares.iter_mut().enumerate() {
            for (k, share) in row.iter_mut().enumerate().take(j + 1) {
                let [one, two, three, four] =
                    [1, 2, 3, 4].map(|more| bernstein::binomial(j, k) / (k + more) as f64);
                // The factor 0.5 divides the moments by the length 2 of the range.
                let value = 0.5 * (one - 3.0 * three + 2.0 * four);
                let slope = 0.5 * (two - 2.0 * three + four);
                *share = if k % 2 == 0 {
                    [value, 0.0, 0.0, slope]
                } else {
                    [0.0, value, slope, 0.0]
                };
            }
        }
        let mut values = [[0.0; N]; N];
        for (place, x) in places(N - 1).into_iter().enumerate() {
            let own = by_moments::<N>(x);
            values
                .iter_mut()
                .zip(own)
                .for_each(|(row, v)| row[place] = v);
        }
        Nearest {
            cells,
            breaks,
            shares,
            values,
        }
    }

    /// Values of the approximation at the nodes, range by range.
    fn values(self) -> Vec<f64> {
        let scale = self.cells.per_length();
        let mut out = Vec::with_capacity(N * (self.breaks.len() - 1));
        for ends in self.breaks.windows(2) {
            let moments = self.moments((ends[0] * scale, ends[1] * scale));
            let mut values = [0.0; N];
            for (by, moment) in self.values.iter().zip(moments) {
                for place in 0..N {
                    values[place] += by[place] * moment;
                }
            }
            out.extend_from_slice(&values);
        }
        out
    }

    /// Adds the contribution of cells with the given sums. `width` is the width of a cell if the range has the length 2. `moments` has one
    /// column per sum.
    #[inline(always)]
    fn add(&self, sums: &Sums<N>, width: f64, moments: &mut [[f64; 4]; N]) {
        let mut power = width;
        for k in 0..N {
            for j in k..N {
                for m in 0..4 {
                    moments[j][m] += power * self.shares[j][k][m] * sums[j - k][m];
                }
            }
            power *= width;
        }
    }

    /// Moments of a range whose ends are given in cells.
    #[inline(always)]
    fn moments(&self, (first, last): (f64, f64)) -> [f64; N] {
        let (middle, by) = (0.5 * (first + last), 2.0 / (last - first));
        let mut moments = [[0.0; 4]; N];
        let most = self.cells.count() as f64;
        let (start, end) = ((first - SAME).ceil(), (last + SAME).floor().min(most));
        let parts = if start < end {
            let whole = start as usize..=end as usize;
            let (f, s) = (&self.cells.values[whole.clone()], &self.cells.slopes[whole]);
            let sums = sums(f, s, (start - middle) * by, by);
            self.add(&sums, by, &mut moments);
            [(first, start), (end, last)]
        } else {
            let between = start.clamp(first, last);
            [(first, between), (between, last)]
        };
        for (from, to) in parts {
            if to - from <= SAME {
                continue;
            }
            let i = self.cells.cell(0.5 * (from + to));
            let base = i as f64;
            let [f0, s0, f1, s1] = part_of(&self.cells.cubic(i), (from - base, to - base));
            let (x, width) = ((from - middle) * by, (to - from) * by);
            let sums = sums(&[f0, f1], &[s0, s1], x, width);
            self.add(&sums, width, &mut moments);
        }
        let mut out = [0.0; N];
        for j in 0..N {
            let [a, b, c, d] = moments[j];
            out[j] = (a + b) + (c + d);
        }
        out
    }
}

/// Nodes on [−1, 1] of the quadrature rule with `degree` + 1 nodes.
fn places(degree: usize) -> Vec<f64> {
    let rule = gauss_legendre(degree + 1);
    rule.into_iter().map(|(u, _)| 2.0 * u - 1.0).collect()
}

/// Values and slopes at both ends of a part of a cubic cell. The slopes are derivatives with respect to a coordinate from 0 to 1 on the
/// part.
#[inline(always)]
fn part_of(b: &[f64; 4], range: (f64, f64)) -> Ends {
    let mut c = [0.0; 4];
    restricted(b, range, &mut c);
    [c[0], 3.0 * (c[1] - c[0]), c[3], 3.0 * (c[3] - c[2])]
}

/// Sums over cells with the given values and slopes at their ends. The first end is at x = `first`, and the width of a cell is `step`.
fn sums<const N: usize>(values: &[f64], slopes: &[f64], first: f64, step: f64) -> Sums<N> {
    let n = values.len() - 1;
    let last = first + n as f64 * step;
    let starts: [[f64; N]; 2] = [values, slopes].map(|y| powers(&y[..n], first, step));
    let mut ends = [values[0], values[n], slopes[0], slopes[n]];
    let mut out = [[0.0; 4]; N];
    for a in 0..N {
        let [f0, f1, s0, s1] = ends;
        let both = [
            2.0 * starts[0][a] + (f1 - f0),
            2.0 * starts[1][a] + (s1 - s0),
        ];
        out[a] = [both[0], f0 - f1, both[1], s0 - s1];
        for (end, x) in ends.iter_mut().zip([first, last, first, last]) {
            *end *= x;
        }
    }
    out
}

/// Sums Σ xᵃ y for each power a, with x = `first`, `first` + `step`, …
fn powers<const N: usize>(y: &[f64], first: f64, step: f64) -> [f64; N] {
    let mut sums = [0.0; N];
    for (i, y) in y.iter().enumerate() {
        let (x, mut own) = (first + i as f64 * step, *y);
        for sum in &mut sums {
            *sum += own;
            own *= x;
        }
    }
    sums
}

/// Factors with which the moments of a function f on [−1, 1] contribute to the value at x of its least-squares polynomial Σₖ (2k + 1) Pₖ(x)
/// ∫ f Pₖ. The moments and integrals are divided by the length 2.
fn by_moments<const N: usize>(x: f64) -> [f64; N] {
    let mut out = [0.0; N];
    // Coefficients and value of each Legendre polynomial.
    let (mut before, mut own) = ([0.0; N], [0.0; N]);
    let (mut value_before, mut value) = (0.0, 1.0);
    own[0] = 1.0;
    for k in 0..N {
        for (out, c) in out.iter_mut().zip(&own) {
            *out += (2 * k + 1) as f64 * value * c;
        }
        let n = k as f64;
        let (rise, fall) = ((2.0 * n + 1.0) / (n + 1.0), n / (n + 1.0));
        let mut next = [0.0; N];
        for j in 0..N {
            let lower = if j > 0 { own[j - 1] } else { 0.0 };
            next[j] = rise * lower - fall * before[j];
        }
        (before, own) = (own, next);
        (value_before, value) = (value, rise * x * value - fall * value_before);
    }
    out
}

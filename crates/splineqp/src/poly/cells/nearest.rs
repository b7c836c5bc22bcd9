//! The polynomials nearest to cells in the mean.

use pulp::{Arch, Simd, WithSimd};

use super::rule::{Rule, cubic, restricted};
use super::{Cells, Ends};
use crate::poly::{bernstein, gauss_legendre};

/// Highest degree of a nearest polynomial.
const HIGHEST: usize = 30;
/// A break nearer than this to the end of a cell, in cells, stands there.
const SAME: f64 = 1e-11;

impl Cells {
    /// The polynomial of a degree nearest to the function on every range between breaks of the first period, in the mean:
    /// its values at the nodes of [`gauss_legendre`] for that degree, degree + 1 of them or more, range by range. Integrals
    /// against polynomials of that degree are those of the function itself: its kinks between the cells cost no accuracy.
    pub fn nearest(&self, breaks: &[f64], degree: usize) -> Vec<f64> {
        match degree {
            3 => Arch::new().dispatch(Usual::<4>::new(self, breaks)),
            4 => Arch::new().dispatch(Usual::<5>::new(self, breaks)),
            5 => Arch::new().dispatch(Usual::<6>::new(self, breaks)),
            6 => Arch::new().dispatch(Usual::<7>::new(self, breaks)),
            7 => Arch::new().dispatch(Usual::<8>::new(self, breaks)),
            _ => self.any_nearest(breaks, degree),
        }
    }

    /// The same of any degree, by Legendre's polynomials at quadrature nodes of every cell.
    pub(super) fn any_nearest(&self, breaks: &[f64], degree: usize) -> Vec<f64> {
        let places = places(degree);
        let moments = &mut [0.0; HIGHEST + 1][..=degree];
        let mut out = Vec::with_capacity(places.len() * (breaks.len() - 1));
        for ends in breaks.windows(2) {
            let ends = (ends[0] * self.per_length(), ends[1] * self.per_length());
            match (degree + 5).div_ceil(2) {
                0..=4 => self.moments(&Rule::<4>::new(), ends, moments),
                5..=6 => self.moments(&Rule::<6>::new(), ends, moments),
                7..=8 => self.moments(&Rule::<8>::new(), ends, moments),
                9..=12 => self.moments(&Rule::<12>::new(), ends, moments),
                _ => self.moments(&Rule::<18>::new(), ends, moments),
            }
            for &place in &places {
                let mut value = 0.0;
                each_legendre(degree, [place], |k, [p]| {
                    value += (2 * k + 1) as f64 * moments[k] * p;
                });
                out.push(value);
            }
        }
        out
    }

    /// ∫ of the function times Legendre's polynomials over a range, as parts of its length; its ends in cells.
    fn moments<const Q: usize>(
        &self,
        rule: &Rule<Q>,
        (first, last): (f64, f64),
        moments: &mut [f64],
    ) {
        let n = self.count();
        let step = last - first;
        let mut sums = [[0.0; Q]; HIGHEST + 1];
        let mut a = first;
        while a < last {
            let i = self.cell(a);
            // A rounding short of a cell's end is that end.
            let b = if i + 1 == n {
                last
            } else {
                (i as f64 + 1.0).min(last)
            };
            let whole = a == i as f64 && b == i as f64 + 1.0;
            let values = if whole {
                rule.on_cell(&self.ends(i))
            } else {
                rule.places(a - i as f64, b - i as f64)
                    .map(|u| cubic(&self.cubic(i), u))
            };
            let part = (b - a) / step;
            let weighed: [f64; Q] = std::array::from_fn(|q| part * rule.weights[q] * values[q]);
            let x = rule
                .places((a - first) / step, (b - first) / step)
                .map(|u| 2.0 * u - 1.0);
            each_legendre(moments.len() - 1, x, |k, p| {
                for q in 0..Q {
                    sums[k][q] += weighed[q] * p[q];
                }
            });
            a = b;
        }
        for (moment, sum) in moments.iter_mut().zip(&sums) {
            *moment = sum.iter().sum();
        }
    }
}

/// Polynomials of the usual degrees, N − 1, by moments ∫ f xʲ dx with x ∈ [−1, 1] on the range: few enough for powers.
///
/// On whole cells of the width w, f is the sum of Hermite's cubics about their ends X, one even and one odd. On the right
/// of an end
///
/// ```text
/// ∫ f xʲ = Σₖ C(j, k) Xʲ⁻ᵏ wᵏ⁺¹ (aₖ f + bₖ s),   aₖ = ∫₀¹ (1 − 3t² + 2t³) tᵏ,   bₖ = ∫₀¹ (t − 2t² + t³) tᵏ
/// ```
///
/// and on its left (−1)ᵏ (aₖ f − bₖ s). So the sums Σ Xᵃ f and Σ Xᵃ s over the ends, several side by side, are all that is
/// to be done for each cell; the first and the last end have one side only.
struct Usual<'a, const N: usize> {
    cells: &'a Cells,
    breaks: &'a [f64],
    /// C(j, k) times what belongs to each of the [`Sums`], of j and k.
    shares: [[[f64; 4]; N]; N],
    /// Values at the places by each moment.
    values: [[f64; N]; N],
}

/// Of Xᵃ f: both sides of the ends together, and the first end less the last; of Xᵃ s the same.
type Sums<const N: usize> = [[f64; 4]; N];

impl<'a, const N: usize> Usual<'a, N> {
    fn new(cells: &'a Cells, breaks: &'a [f64]) -> Self {
        let mut shares = [[[0.0; 4]; N]; N];
        for (j, row) in shares.iter_mut().enumerate() {
            for (k, share) in row.iter_mut().enumerate().take(j + 1) {
                let [one, two, three, four] =
                    [1, 2, 3, 4].map(|more| bernstein::binomial(j, k) / (k + more) as f64);
                // Parts of the length 2.
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
        Usual {
            cells,
            breaks,
            shares,
            values,
        }
    }

    /// Adds the part of cells whose sums are given, of the width `width` on the range; moments by sum.
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

    /// A range's moments; its ends in cells.
    #[inline(always)]
    fn moments<S: Simd>(&self, simd: S, (first, last): (f64, f64)) -> [f64; N] {
        let (middle, by) = (0.5 * (first + last), 2.0 / (last - first));
        let mut moments = [[0.0; 4]; N];
        let most = self.cells.count() as f64;
        let (start, end) = ((first - SAME).ceil(), (last + SAME).floor().min(most));
        let parts = if start < end {
            let whole = start as usize..=end as usize;
            let (f, s) = (&self.cells.values[whole.clone()], &self.cells.slopes[whole]);
            let sums = sums(simd, f, s, (start - middle) * by, by);
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
            let sums = sums(simd, &[f0, f1], &[s0, s1], x, width);
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

impl<const N: usize> WithSimd for Usual<'_, N> {
    type Output = Vec<f64>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Vec<f64> {
        let scale = self.cells.per_length();
        let mut out = Vec::with_capacity(N * (self.breaks.len() - 1));
        for ends in self.breaks.windows(2) {
            let moments = self.moments(simd, (ends[0] * scale, ends[1] * scale));
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
}

/// The nodes for a degree on [−1, 1].
fn places(degree: usize) -> Vec<f64> {
    let rule = gauss_legendre(degree + 1);
    rule.into_iter().map(|(u, _)| 2.0 * u - 1.0).collect()
}

/// A cubic's ends on a part of its cell, the slopes by that part.
#[inline(always)]
fn part_of(b: &[f64; 4], range: (f64, f64)) -> Ends {
    let mut c = [0.0; 4];
    restricted(b, range, &mut c);
    [c[0], 3.0 * (c[1] - c[0]), c[3], 3.0 * (c[3] - c[2])]
}

/// The sums over cells with these values and slopes at their ends, the first of them at x = `first`, a cell `step` wide.
#[inline(always)]
fn sums<S: Simd, const N: usize>(
    simd: S,
    values: &[f64],
    slopes: &[f64],
    first: f64,
    step: f64,
) -> Sums<N> {
    let n = values.len() - 1;
    let last = first + n as f64 * step;
    let starts: [[f64; N]; 2] = [
        powers(simd, &values[..n], first, step),
        powers(simd, &slopes[..n], first, step),
    ];
    let mut ends = [values[0], values[n], slopes[0], slopes[n]];
    let mut out = [[0.0; 4]; N];
    for a in 0..N {
        let [f0, f1, s0, s1] = ends;
        out[a] = [
            2.0 * starts[0][a] + (f1 - f0),
            f0 - f1,
            2.0 * starts[1][a] + (s1 - s0),
            s0 - s1,
        ];
        for (end, x) in ends.iter_mut().zip([first, last, first, last]) {
            *end *= x;
        }
    }
    out
}

/// Σ xᵃ y for each power a, with x from `first` on by `step`.
#[inline(always)]
fn powers<S: Simd, const N: usize>(simd: S, y: &[f64], first: f64, step: f64) -> [f64; N] {
    const COUNT: [f64; 16] = [
        0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0,
    ];
    let lanes = simd.partial_load_f64s(&COUNT[..S::F64_LANES]);
    let lanes = simd.mul_add_f64s(simd.splat_f64s(step), lanes, simd.splat_f64s(first));
    let mut sums = [simd.splat_f64s(0.0); N];
    let (full, rest) = S::as_simd_f64s(y);
    for i in 0..full.len() + usize::from(!rest.is_empty()) {
        let mut own = if i < full.len() {
            full[i]
        } else {
            simd.partial_load_f64s(rest)
        };
        let by = simd.splat_f64s((i * S::F64_LANES) as f64 * step);
        let x = simd.add_f64s(lanes, by);
        for sum in &mut sums {
            *sum = simd.add_f64s(*sum, own);
            own = simd.mul_f64s(own, x);
        }
    }
    let mut out = [0.0; N];
    for a in 0..N {
        out[a] = simd.reduce_sum_f64s(sums[a]);
    }
    out
}

/// The value at x of the polynomial nearest to a function on [−1, 1] by each of its moments, these as parts of the length 2:
/// Σₖ (2k + 1) Pₖ(x) ∫ f Pₖ.
fn by_moments<const N: usize>(x: f64) -> [f64; N] {
    let mut out = [0.0; N];
    // Coefficients and value of each Legendre polynomial.
    let (mut before, mut own) = ([0.0; N], [0.0; N]);
    own[0] = 1.0;
    each_legendre(N - 1, [x], |k, [p]| {
        for (out, c) in out.iter_mut().zip(&own) {
            *out += (2 * k + 1) as f64 * p * c;
        }
        let n = k as f64;
        let (rise, fall) = ((2.0 * n + 1.0) / (n + 1.0), n / (n + 1.0));
        let mut next = [0.0; N];
        for j in 0..N {
            let lower = if j > 0 { own[j - 1] } else { 0.0 };
            next[j] = rise * lower - fall * before[j];
        }
        (before, own) = (own, next);
    });
    out
}

/// Visits Legendre's polynomials of degree 0 … `degree` at x ∈ [−1, 1].
#[inline(always)]
fn each_legendre<const Q: usize>(
    degree: usize,
    x: [f64; Q],
    mut visit: impl FnMut(usize, [f64; Q]),
) {
    let (mut before, mut p) = ([0.0; Q], [1.0; Q]);
    for k in 0..=degree {
        visit(k, p);
        let n = k as f64;
        let (rise, fall) = ((2.0 * n + 1.0) / (n + 1.0), n / (n + 1.0));
        let next = std::array::from_fn(|q| rise * x[q] * p[q] - fall * before[q]);
        (before, p) = (p, next);
    }
}

//! A smooth periodic function as cubics on equal cells: its best polynomial approximations and its distance from polynomials.
//!
//! A target force has a thousand cells and a law some ten pieces, so sums over cells determine the cost: cells, or the nodes of
//! a quadrature rule on one cell, are processed in vector lanes.

mod distance;
mod nearest;
mod rule;
#[cfg(test)]
mod tests;

use pulp::{Arch, Simd, WithSimd};

/// A function of period `length`, a cubic on each of n equal cells: a cubic Hermite spline.
///
/// ```
/// use splineqp::poly::Cells;
///
/// // Level at 0 and at 1, with values 0 and 1 there.
/// let cells = Cells::new(vec![0.0, 1.0, 0.0], vec![0.0; 3], 2.0);
/// assert!((cells.at(0.5) - 0.5).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Cells {
    /// At the ends of the cells, n + 1 of them: the last is the first again.
    values: Vec<f64>,
    /// Slopes there, by a cell.
    slopes: Vec<f64>,
    length: f64,
}

/// Value and slope at the start of a cell, then at its end.
type Ends = [f64; 4];

impl Cells {
    /// The function with these values and slopes (by a cell) at the ends of its cells, the first of which begins at 0: one
    /// more than cells, the last of them the first again.
    pub fn new(values: Vec<f64>, slopes: Vec<f64>, length: f64) -> Self {
        Cells {
            values,
            slopes,
            length,
        }
    }

    /// Number of cells.
    pub fn count(&self) -> usize {
        self.values.len() - 1
    }

    /// Bernstein coefficients of the cubic on a cell.
    pub fn cubic(&self, cell: usize) -> [f64; 4] {
        by_ends(self.ends(cell))
    }

    /// Value at a place of the first period.
    pub fn at(&self, x: f64) -> f64 {
        self.at_place(x * self.per_length())
    }

    /// Values at places u ∈ [0, 1] of a range of the first period, given with their weights.
    pub fn on(&self, (start, width): (f64, f64), places: &[(f64, f64)], out: &mut [f64]) {
        let (first, step) = (start * self.per_length(), width * self.per_length());
        for (f, (u, _)) in out.iter_mut().zip(places) {
            *f = self.at_place(first + u * step);
        }
    }

    /// Mean over the period of the squared distance from a constant.
    pub fn mean_square_from(&self, level: f64) -> f64 {
        let square = Arch::new().dispatch(SquareFrom { cells: self, level });
        square / self.count() as f64
    }

    /// Cells a unit of length.
    fn per_length(&self) -> f64 {
        self.count() as f64 / self.length
    }

    /// The cell that a place, in cells, lies on.
    fn cell(&self, place: f64) -> usize {
        (place as u32 as usize).min(self.count() - 1)
    }

    fn ends(&self, cell: usize) -> Ends {
        let (f, s) = (&self.values, &self.slopes);
        [f[cell], s[cell], f[cell + 1], s[cell + 1]]
    }

    /// Value at a place in cells.
    fn at_place(&self, place: f64) -> f64 {
        let i = self.cell(place);
        rule::cubic(&self.cubic(i), place - i as f64)
    }
}

/// Bernstein coefficients of a cubic by value and slope at its start, then at its end.
pub fn by_ends([f0, s0, f1, s1]: Ends) -> [f64; 4] {
    const THIRD: f64 = 1.0 / 3.0;
    [f0, f0 + THIRD * s0, f1 - THIRD * s1, f1]
}

/// Σ over cells of the mean of (f − level)²: with y = f − level, the slopes s and ′ for the next end,
///
/// ```text
/// Σ (312 y² + 108 y y′ + 26 (s y′ − y s′) + 8 s² − 6 s s′)/420
/// ```
struct SquareFrom<'a> {
    cells: &'a Cells,
    level: f64,
}

impl WithSimd for SquareFrom<'_> {
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> f64 {
        let n = self.cells.count();
        let (f, s) = (&self.cells.values, &self.cells.slopes);
        let (here, here_rest) = S::as_simd_f64s(&f[..n]);
        let (next, next_rest) = S::as_simd_f64s(&f[1..]);
        let (slope, slope_rest) = S::as_simd_f64s(&s[..n]);
        let (next_slope, next_slope_rest) = S::as_simd_f64s(&s[1..]);
        let mut sums = [simd.splat_f64s(0.0); 2];
        for (i, y) in here.iter().enumerate() {
            let ends = [*y, slope[i], next[i], next_slope[i]];
            add_square(simd, ends, self.level, &mut sums);
        }
        let mut sum = simd.reduce_sum_f64s(simd.add_f64s(sums[0], sums[1]));
        for (i, y) in here_rest.iter().enumerate() {
            let ends = [*y, slope_rest[i], next_rest[i], next_slope_rest[i]];
            let mut sums = [0.0; 2];
            add_square(pulp::Scalar::new(), ends, self.level, &mut sums);
            sum += sums[0] + sums[1];
        }
        sum / 420.0
    }
}

#[inline(always)]
fn add_square<S: Simd>(simd: S, [y, s, y1, s1]: [S::f64s; 4], level: f64, sums: &mut [S::f64s; 2]) {
    let number = |x: f64| simd.splat_f64s(x);
    let [y, y1] = [y, y1].map(|y| simd.sub_f64s(y, number(level)));
    let by_value = simd.mul_add_f64s(number(-26.0), s1, simd.mul_f64s(number(108.0), y1));
    let by_value = simd.mul_add_f64s(number(312.0), y, by_value);
    let by_slope = simd.mul_add_f64s(number(-6.0), s1, simd.mul_f64s(number(26.0), y1));
    let by_slope = simd.mul_add_f64s(number(8.0), s, by_slope);
    sums[0] = simd.mul_add_f64s(y, by_value, sums[0]);
    sums[1] = simd.mul_add_f64s(s, by_slope, sums[1]);
}

//! A periodic function as cubics on equal cells, integrated against polynomials and held against them.
//!
//! A wanted force has a thousand cells and a law some ten pieces, so sums over cells are what costs: nodes of a
//! quadrature rule stand side by side in fixed arrays, which the compiler works on together.

mod distance;
mod rule;
#[cfg(test)]
mod tests;

use pulp::{Arch, NullaryFnOnce};

use rule::{Rule, cubic};

/// More cells on a range than this leave a polynomial of the range all but a quartic on each.
const MANY_CELLS: f64 = 24.0;
/// Quadrature nodes on a cell then.
const FEW_NODES: usize = 4;
/// Highest degree of a nearest polynomial.
const HIGHEST: usize = 30;

/// A function of period `length`: a cubic in Bernstein form on each of n equal cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Cells {
    cubics: Vec<[f64; 4]>,
    length: f64,
}

impl Cells {
    /// Cubics in their order over one period, which begins at 0.
    pub fn new(cubics: Vec<[f64; 4]>, length: f64) -> Self {
        Cells { cubics, length }
    }

    /// Value at a place of the first period.
    pub fn at(&self, x: f64) -> f64 {
        let place = x * self.per_length();
        let i = self.cell(place);
        cubic(&self.cubics[i], place - i as f64)
    }

    /// Values at places u ∈ [0, 1] of a range of the first period, given with their weights.
    pub fn on(&self, (start, width): (f64, f64), places: &[(f64, f64)], out: &mut [f64]) {
        let (first, step) = (start * self.per_length(), width * self.per_length());
        for (f, (u, _)) in out.iter_mut().zip(places) {
            let place = first + u * step;
            let i = self.cell(place);
            *f = cubic(&self.cubics[i], place - i as f64);
        }
    }

    /// The polynomial of a degree nearest to the function on a range of the first period, in the mean, at places
    /// u ∈ [0, 1] of it given with their weights. Integrals against polynomials of that degree are those of the
    /// function itself: its kinks between the cells cost no accuracy.
    pub fn nearest(
        &self,
        (start, width): (f64, f64),
        degree: usize,
        places: &[(f64, f64)],
        out: &mut [f64],
    ) {
        let range = (start * self.per_length(), width * self.per_length());
        let moments = &mut [0.0; HIGHEST + 1][..=degree];
        let nodes = if range.1 > MANY_CELLS {
            FEW_NODES
        } else {
            (degree + 5).div_ceil(2)
        };
        match (nodes, degree) {
            (0..=4, 5) => self.usual_moments::<4, 6>(range, moments),
            (0..=4, 7) => self.usual_moments::<4, 8>(range, moments),
            (0..=6, 5) => self.usual_moments::<6, 6>(range, moments),
            _ => self.any_moments(nodes, range, moments),
        }
        for (f, (place, _)) in out.iter_mut().zip(places) {
            let x = [2.0 * place - 1.0];
            *f = 0.0;
            each_legendre(degree, x, |k, [p]| {
                *f += (2 * k + 1) as f64 * moments[k] * p
            });
        }
    }

    /// [`Cells::moments`] of few polynomials by sums of powers: a few operations a cell, and digits enough.
    fn usual_moments<const Q: usize, const N: usize>(
        &self,
        (first, step): (f64, f64),
        moments: &mut [f64],
    ) {
        let rule = Rule::<Q>::new();
        let last = first + step;
        let mut powers = [0.0; N];
        let mut add_part = |from: f64, to: f64| {
            let i = self.cell(0.5 * (from + to));
            let share = (to - from) / step;
            let places = rule.places((from - first) / step, (to - first) / step);
            let within = rule.places(from - i as f64, to - i as f64);
            for q in 0..Q {
                let mut part = share * rule.weights[q] * cubic(&self.cubics[i], within[q]);
                for power in &mut powers {
                    *power += part;
                    part *= 2.0 * places[q] - 1.0;
                }
            }
        };
        let (start, end) = (first.ceil(), last.floor().min(self.cubics.len() as f64));
        if start >= end {
            let middle = start.clamp(first, last);
            add_part(first, middle);
            add_part(middle, last);
        } else {
            add_part(first, start);
            add_part(end, last);
            let sums = Arch::new().dispatch(Powers::<Q, N> {
                rule: &rule,
                cells: &self.cubics[start as usize..end as usize],
                first: 2.0 * (start - first) / step - 1.0,
                step: 2.0 / step,
            });
            for (power, sum) in powers.iter_mut().zip(sums) {
                *power += sum / step;
            }
        }
        // ∫ f xʲ P of the next degree from those of the two before, all j at once.
        let (mut before, mut own) = ([0.0; N], powers);
        for (k, moment) in moments.iter_mut().enumerate() {
            *moment = own[0];
            let n = k as f64;
            let (rise, fall) = ((2.0 * n + 1.0) / (n + 1.0), n / (n + 1.0));
            let mut next = [0.0; N];
            for j in 0..N - 1 - k {
                next[j] = rise * own[j + 1] - fall * before[j];
            }
            (before, own) = (own, next);
        }
    }

    fn any_moments(&self, nodes: usize, range: (f64, f64), moments: &mut [f64]) {
        match nodes {
            0..=4 => self.moments(&Rule::<4>::new(), range, moments),
            5..=6 => self.moments(&Rule::<6>::new(), range, moments),
            7..=8 => self.moments(&Rule::<8>::new(), range, moments),
            9..=12 => self.moments(&Rule::<12>::new(), range, moments),
            _ => self.moments(&Rule::<18>::new(), range, moments),
        }
    }

    /// ∫ of the function times Legendre's polynomials over a range, as parts of its length; the range in cells.
    fn moments<const Q: usize>(
        &self,
        rule: &Rule<Q>,
        (first, step): (f64, f64),
        moments: &mut [f64],
    ) {
        let n = self.cubics.len();
        let last = first + step;
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
                rule.on_cell(&self.cubics[i])
            } else {
                rule.places(a - i as f64, b - i as f64)
                    .map(|u| cubic(&self.cubics[i], u))
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

    /// Mean over the period of the squared distance from a constant.
    pub fn mean_square_from(&self, level: f64) -> f64 {
        let rule = Rule::<4>::new();
        let mut sums = [0.0; 4];
        for c in &self.cubics {
            let values = rule.on_cell(c);
            for q in 0..4 {
                sums[q] += (values[q] - level) * (values[q] - level);
            }
        }
        let weighed = sums.iter().zip(&rule.weights).map(|(s, w)| s * w);
        weighed.sum::<f64>() / self.cubics.len() as f64
    }

    /// Cells a unit of length.
    fn per_length(&self) -> f64 {
        self.cubics.len() as f64 / self.length
    }

    fn cell(&self, place: f64) -> usize {
        (place as u32 as usize).min(self.cubics.len() - 1)
    }
}

/// Sums over whole cells of ∫ f xʲ dx, in cells, with x from `first` at the first cell's start on by `step` a cell.
struct Powers<'a, const Q: usize, const N: usize> {
    rule: &'a Rule<Q>,
    cells: &'a [[f64; 4]],
    first: f64,
    step: f64,
}

impl<const Q: usize, const N: usize> NullaryFnOnce for Powers<'_, Q, N> {
    type Output = [f64; N];

    #[inline(always)]
    fn call(self) -> [f64; N] {
        let mut sums = [[0.0; Q]; N];
        for (i, c) in self.cells.iter().enumerate() {
            let from = self.first + i as f64 * self.step;
            let x = self.rule.places(from, from + self.step);
            let mut part = self.rule.on_cell(c);
            for sum in &mut sums {
                for q in 0..Q {
                    sum[q] += part[q];
                    part[q] *= x[q];
                }
            }
        }
        sums.map(|sum| sum.iter().zip(&self.rule.weights).map(|(s, w)| s * w).sum())
    }
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

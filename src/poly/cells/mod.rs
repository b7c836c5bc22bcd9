//! A periodic function as cubics on equal cells, integrated against polynomials and held against them.
//!
//! A wanted force has a thousand cells and a law some ten pieces, so sums over cells are what costs: nodes of a
//! quadrature rule stand side by side in fixed arrays, which the compiler works on together.

mod distance;
mod nearest;
mod rule;
#[cfg(test)]
mod tests;

use pulp::{Arch, NullaryFnOnce};

use rule::{Rule, cubic};

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

    /// Mean over the period of the squared distance from a constant.
    pub fn mean_square_from(&self, level: f64) -> f64 {
        Arch::new().dispatch(SquareFrom {
            cells: &self.cubics,
            level,
        }) / self.cubics.len() as f64
    }

    /// Cells a unit of length.
    fn per_length(&self) -> f64 {
        self.cubics.len() as f64 / self.length
    }

    fn cell(&self, place: f64) -> usize {
        (place as u32 as usize).min(self.cubics.len() - 1)
    }
}

/// Σ over cells of the mean of (f − level)², at four nodes side by side.
struct SquareFrom<'a> {
    cells: &'a [[f64; 4]],
    level: f64,
}

impl NullaryFnOnce for SquareFrom<'_> {
    type Output = f64;

    #[inline(always)]
    fn call(self) -> f64 {
        let rule = Rule::<4>::new();
        let mut sums = [0.0; 4];
        for c in self.cells {
            let values = rule.on_cell(c);
            for q in 0..4 {
                sums[q] += (values[q] - self.level) * (values[q] - self.level);
            }
        }
        sums.iter().zip(&rule.weights).map(|(s, w)| s * w).sum()
    }
}

//! The demands in a step: a small dense system E K⁻¹ Eᵀ beside the banded factor of K.

use super::system::Line;
use crate::synth::qp::band::{ArrowFactor, ArrowMatrix};

/// A demand whose pivot is below this many roundings of its own size follows from those before it.
const DEPENDENT: f64 = 1e4;

/// K⁻¹Eᵀ and the factor of E K⁻¹ Eᵀ.
pub struct Demands {
    /// Weight with which the outer products of demands at one angle stand in K.
    stiffness: f64,
    widest: usize,
    solved: Vec<Vec<f64>>,
    /// Rows of the lower triangle; a demand that follows from others has a zero pivot.
    lower: Vec<Vec<f64>>,
}

impl Demands {
    /// Makes the matrix regular where the demands settle what it leaves open: their outer products move no step that
    /// keeps them.
    pub fn stiffen(demands: &[Line], matrix: &mut ArrowMatrix) -> f64 {
        let widest = matrix.pattern().0 + 1;
        let weight = 1.0;
        for demand in demands.iter().filter(|d| d.entries.len() <= widest) {
            for (p, &(i, a)) in demand.entries.iter().enumerate() {
                for &(j, b) in &demand.entries[..=p] {
                    matrix.add(i, j, weight * a * b);
                }
            }
        }
        weight
    }

    pub fn new(demands: &[Line], factor: &ArrowFactor, stiffness: f64) -> Self {
        let n = factor.dimension();
        let mut solved = Vec::with_capacity(demands.len());
        for demand in demands {
            let mut column = vec![0.0; n];
            demand.add_to(&mut column, 1.0);
            factor.solve(&mut column);
            solved.push(column);
        }
        let mut lower: Vec<Vec<f64>> = Vec::with_capacity(demands.len());
        for (i, demand) in demands.iter().enumerate() {
            let mut row: Vec<f64> = solved[..=i].iter().map(|y| demand.of(y)).collect();
            let own = row[i];
            for j in 0..=i {
                let mut sum = row[j];
                for k in 0..j {
                    let other = if j == i { row[k] } else { lower[j][k] };
                    sum -= row[k] * other;
                }
                row[j] = if j < i {
                    if lower[j][j] > 0.0 {
                        sum / lower[j][j]
                    } else {
                        0.0
                    }
                } else if sum > DEPENDENT * f64::EPSILON * own {
                    sum.sqrt()
                } else {
                    0.0
                };
            }
            lower.push(row);
        }
        Demands {
            stiffness,
            widest: factor.pattern().0 + 1,
            solved,
            lower,
        }
    }

    /// Solves K u + Eᵀν = x, E u = y in place of x; returns ν.
    pub fn solve(
        &self,
        demands: &[Line],
        factor: &ArrowFactor,
        x: &mut [f64],
        y: &[f64],
    ) -> Vec<f64> {
        for (demand, &y) in demands.iter().zip(y) {
            if demand.entries.len() <= self.widest {
                demand.add_to(x, self.stiffness * y);
            }
        }
        factor.solve(x);
        let mut nu: Vec<f64> = (demands.iter().zip(y))
            .map(|(demand, &y)| demand.of(x) - y)
            .collect();
        let pivot = |i: usize| self.lower[i][i];
        for i in 0..nu.len() {
            for k in 0..i {
                nu[i] -= self.lower[i][k] * nu[k];
            }
            nu[i] = if pivot(i) > 0.0 {
                nu[i] / pivot(i)
            } else {
                0.0
            };
        }
        for i in (0..nu.len()).rev() {
            for k in i + 1..nu.len() {
                nu[i] -= self.lower[k][i] * nu[k];
            }
            nu[i] = if pivot(i) > 0.0 {
                nu[i] / pivot(i)
            } else {
                0.0
            };
        }
        for (column, &nu) in self.solved.iter().zip(&nu) {
            for (x, &c) in x.iter_mut().zip(column) {
                *x -= nu * c;
            }
        }
        nu
    }
}

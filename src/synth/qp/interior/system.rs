//! The program as the iterations see it, and what they return.

use super::chain::{self, Windowed};
use super::cone::Cone;
use super::demands::Demands;
use super::scaled::Base;
use crate::synth::qp::band::{ArrowFactor, ArrowMatrix};
use std::sync::Arc;

/// Part of the largest pivot that keeps directions which nothing holds.
const HELD: f64 = 2e-11;
/// … that is raised by this factor while there is no factor.
const RAISED: f64 = 1e3;
const RAISES: usize = 4;

/// Σ entries·u against a bound.
pub struct Line {
    pub entries: Vec<(usize, f64)>,
    pub bound: f64,
}

impl Line {
    pub fn new(entries: Vec<(usize, f64)>, bound: f64) -> Self {
        Line { entries, bound }
    }

    pub fn of(&self, u: &[f64]) -> f64 {
        self.entries.iter().map(|&(i, a)| a * u[i]).sum()
    }

    /// Adds `by` times the row to a vector.
    pub fn add_to(&self, out: &mut [f64], by: f64) {
        for &(i, a) in &self.entries {
            out[i] += a * by;
        }
    }
}

/// H and the rows, as what has its cost in proportion to the spans.
pub enum Matrix {
    /// Over the coefficients of the lift.
    Banded(ArrowMatrix, Vec<Line>),
    /// Over those of its derivatives too.
    Chained(Arc<Base>, Windowed),
}

/// ½uᵀHu + qᵀu under demands, rows and a cone of three unknowns.
pub struct System {
    pub matrix: Matrix,
    pub gradient: Vec<f64>,
    /// Its largest entry.
    pub size: f64,
    pub demands: Vec<Line>,
    /// Bound of each row.
    pub bounds: Vec<f64>,
    pub cone: Option<[usize; 3]>,
    /// Size of the objective where unknowns count from.
    pub value: f64,
}

/// Unknowns and multipliers of the rows.
pub struct Found {
    pub unknowns: Vec<f64>,
    pub pushes: Vec<f64>,
    pub iterations: usize,
    /// Where another solution with a few rows more can go on.
    pub midway: Option<Midway>,
}

/// A point well inside: unknowns, multipliers and the mean of slack times push; a row of today that was none then has
/// no push.
pub struct Midway {
    pub u: Vec<f64>,
    pub nu: Vec<f64>,
    pub z: Vec<Option<f64>>,
    pub mean: f64,
    pub cone: Option<Cone>,
}

/// The factor of H + Σ weight·aaᵀ under the demands.
pub enum Factor {
    Banded(ArrowFactor, Demands),
    Chained(chain::Factor),
}

impl System {
    /// Hu.
    pub fn times(&self, u: &[f64]) -> Vec<f64> {
        match &self.matrix {
            Matrix::Banded(matrix, _) => matrix.times(u),
            Matrix::Chained(base, _) => base.chain.times(u),
        }
    }

    /// The value of each row.
    pub fn rows(&self, u: &[f64]) -> Vec<f64> {
        match &self.matrix {
            Matrix::Banded(_, rows) => rows.iter().map(|row| row.of(u)).collect(),
            Matrix::Chained(base, rows) => rows.values(&base.chain.layout, u),
        }
    }

    /// Adds each row `by` times to a vector.
    pub fn add_rows(&self, by: &[f64], out: &mut [f64]) {
        match &self.matrix {
            Matrix::Banded(_, rows) => {
                rows.iter()
                    .zip(by)
                    .for_each(|(row, &by)| row.add_to(out, by));
            }
            Matrix::Chained(base, rows) => rows.add_to(&base.chain.layout, by, out),
        }
    }

    /// Largest entry of a gradient that the unknowns do not balance among themselves.
    pub fn unbalanced(&self, gradient: &[f64]) -> f64 {
        match &self.matrix {
            Matrix::Banded(..) => gradient.iter().fold(0.0, |m, g| m.max(g.abs())),
            Matrix::Chained(base, _) => base.chain.unbalanced(gradient),
        }
    }

    /// The factor with these weights of the rows and of the cone's unknowns.
    pub fn factor(&self, weights: &[f64], cone: Option<[[f64; 3]; 3]>) -> Option<Factor> {
        let mut added = Vec::new();
        if let (Some(columns), Some(weight)) = (self.cone, cone) {
            for p in 0..3 {
                for q in 0..3 {
                    added.push((columns[p], columns[q], weight[p][q]));
                }
            }
        }
        match &self.matrix {
            Matrix::Banded(matrix, rows) => self.banded_factor(matrix, rows, weights, &added),
            Matrix::Chained(base, rows) => {
                let factor = base.chain.factor(rows, weights, &self.demands, &added);
                factor.map(Factor::Chained)
            }
        }
    }

    fn banded_factor(
        &self,
        hessian: &ArrowMatrix,
        rows: &[Line],
        weights: &[f64],
        added: &[(usize, usize, f64)],
    ) -> Option<Factor> {
        let mut matrix = hessian.clone();
        for (row, weight) in rows.iter().zip(weights) {
            for (p, &(i, a)) in row.entries.iter().enumerate() {
                let weighed = a * weight;
                for &(j, b) in &row.entries[..=p] {
                    matrix.add(i, j, weighed * b);
                }
            }
        }
        for &(i, j, value) in added.iter().filter(|e| e.0 >= e.1) {
            matrix.add(i, j, value);
        }
        let stiffness = Demands::stiffen(&self.demands, &mut matrix);
        let mut held = HELD * hessian.largest_diagonal().max(1.0);
        for _ in 0..RAISES {
            let mut regular = matrix.clone();
            for i in 0..regular.dimension() {
                regular.add(i, i, held);
            }
            if let Some(factor) = regular.factor() {
                let demands = Demands::new(&self.demands, &factor, stiffness);
                return Some(Factor::Banded(factor, demands));
            }
            held *= RAISED;
        }
        None
    }

    /// Solves K u + Eᵀν = x, E u = y in place of x; returns ν.
    pub fn solve(&self, factor: &Factor, x: &mut [f64], y: &[f64]) -> Vec<f64> {
        match (factor, &self.matrix) {
            (Factor::Banded(factor, demands), _) => demands.solve(&self.demands, factor, x, y),
            (Factor::Chained(factor), Matrix::Chained(base, _)) => factor.solve(&base.chain, x, y),
            (Factor::Chained(_), Matrix::Banded(..)) => Vec::new(),
        }
    }
}

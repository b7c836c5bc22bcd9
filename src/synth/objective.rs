//! Quadratic objectives: distance of the force to the target, and energies of derivatives.

use super::band::ArrowMatrix;
use super::basis::{Basis, Entries};
use crate::poly::gauss_legendre;

/// ½xᵀHx + gᵀx + constant.
#[derive(Debug, Clone)]
pub struct Quadratic {
    /// H.
    pub hessian: ArrowMatrix,
    /// g.
    pub gradient: Vec<f64>,
    /// The constant, so that the value means something.
    pub constant: f64,
}

impl Quadratic {
    /// Nothing yet.
    pub fn zero(basis: &Basis) -> Self {
        let (band, border) = basis.pattern();
        let n = basis.columns();
        Quadratic {
            hessian: ArrowMatrix::zero(n, band, border),
            gradient: vec![0.0; n],
            constant: 0.0,
        }
    }

    /// Adds ½·mean over the law of weight(θ)·(w·svaj − wanted(θ))², with at least `nodes` quadrature
    /// nodes on every piece of the basis. `weights` holds w₀ … w₄ of s … the fourth derivative.
    pub fn add_distance(
        &mut self,
        basis: &Basis,
        weights: &[f64],
        nodes: usize,
        wanted: impl Fn(f64) -> f64,
        weight: impl Fn(f64) -> f64,
    ) {
        let breaks = basis.breaks();
        let total = breaks[breaks.len() - 1] - breaks[0];
        let rule = gauss_legendre(nodes);
        let mut table = RowTable::default();
        for i in 0..breaks.len() - 1 {
            let width = breaks[i + 1] - breaks[i];
            let rows = table.rows(basis, i, width, &rule, weights);
            for ((u, w), row) in rule.iter().zip(rows) {
                let theta = breaks[i] + u * width;
                let factor = w * width / total * weight(theta);
                let b = wanted(theta);
                self.add_row(row, factor, b);
            }
        }
    }

    fn add_row(&mut self, row: &Entries, factor: f64, b: f64) {
        self.constant += 0.5 * factor * b * b;
        for (p, &(i, a)) in row.iter().enumerate() {
            self.gradient[i] -= factor * b * a;
            for &(j, c) in &row[..=p] {
                self.hessian.add(i, j, factor * a * c);
            }
        }
    }

    /// Adds ½·factor·mean of the squared derivative of the given order (2 = acceleration … 4).
    pub fn add_energy(&mut self, basis: &Basis, order: usize, factor: f64) {
        let mut weights = [0.0; 5];
        weights[order] = factor.sqrt();
        let degree = match basis {
            Basis::Spline { space, .. } => space.degree(),
            Basis::Harmonic { .. } => 8,
        };
        self.add_distance(basis, &weights, degree + 1, |_| 0.0, |_| 1.0);
    }

    /// The value at `x`.
    pub fn value(&self, x: &[f64]) -> f64 {
        let hx = self.hessian.times(x);
        hx.iter().zip(x).map(|(h, x)| 0.5 * h * x).sum::<f64>()
            + self.gradient.iter().zip(x).map(|(g, x)| g * x).sum::<f64>()
            + self.constant
    }
}

/// Rows at the quadrature nodes of one piece; on equal spans they only shift.
#[derive(Default)]
struct RowTable {
    rows: Vec<Entries>,
    width: f64,
    matrix: Option<usize>,
}

impl RowTable {
    fn rows(
        &mut self,
        basis: &Basis,
        piece: usize,
        width: f64,
        rule: &[(f64, f64)],
        weights: &[f64],
    ) -> &[Entries] {
        if let Basis::Spline { space, .. } = basis {
            let matrix = space.spans()[piece].matrix();
            let narrow = space.dimension() <= space.degree();
            if !narrow && self.matrix == Some(matrix) && (width - self.width).abs() <= 1e-14 * width
            {
                for row in &mut self.rows {
                    for (k, entry) in row.iter_mut().enumerate() {
                        entry.0 = space.index(piece, k);
                    }
                }
                return &self.rows;
            }
            self.matrix = Some(matrix);
            self.width = width;
        }
        self.rows = rule
            .iter()
            .map(|&(u, _)| basis.row_on(piece, u, weights))
            .collect();
        &self.rows
    }
}

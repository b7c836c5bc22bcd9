//! Quadratic objectives: distance of the force to the target, and energies of derivatives.

use super::band::ArrowMatrix;
use super::basis::{Basis, Entries};
use super::lifted::Lifted;
use crate::poly::{SplineSpace, gauss_legendre};

/// ½xᵀHx + gᵀx + constant.
#[derive(Debug, Clone)]
pub struct Quadratic {
    /// H.
    pub hessian: ArrowMatrix,
    /// g.
    pub gradient: Vec<f64>,
    /// The constant, so that the value means something.
    pub constant: f64,
    /// The same over the coefficients of the derivatives too, where the spans are many.
    pub lifted: Option<Lifted>,
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
            lifted: Lifted::new(basis),
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
        weight: Option<&dyn Fn(f64) -> f64>,
    ) {
        let breaks = basis.breaks();
        let total = breaks[breaks.len() - 1] - breaks[0];
        let rule = gauss_legendre(nodes);
        // (share of the mean, wanted value) at a node of a piece.
        let asked = |i: usize, u: f64, w: f64| {
            let width = breaks[i + 1] - breaks[i];
            let theta = breaks[i] + u * width;
            (
                w * width / total * weight.map_or(1.0, |f| f(theta)),
                wanted(theta),
            )
        };
        let Basis::Spline { space, .. } = basis else {
            for i in 0..breaks.len() - 1 {
                for &(u, w) in &rule {
                    let (factor, b) = asked(i, u, w);
                    self.add_row(&basis.row_on(i, u, weights), factor, b);
                }
            }
            return;
        };
        let n = space.degree() + 1;
        let mut table = RowTable::default();
        let mut gram = vec![0.0; n * n];
        let mut pull = vec![0.0; n];
        for i in 0..breaks.len() - 1 {
            let (rows, as_before) = table.rows(space, i, &rule, weights);
            // Equal spans under one weight differ only in what is wanted.
            let known = as_before && weight.is_none();
            if !known {
                gram.fill(0.0);
            }
            pull.fill(0.0);
            for (row, &(u, w)) in rows.chunks_exact(n).zip(&rule) {
                let (factor, b) = asked(i, u, w);
                self.constant += 0.5 * factor * b * b;
                for (p, a) in pull.iter_mut().zip(row) {
                    *p -= factor * b * a;
                }
                if !known {
                    for (k, &a) in row.iter().enumerate() {
                        for (g, c) in gram[k * n..=k * n + k].iter_mut().zip(row) {
                            *g += factor * a * c;
                        }
                    }
                }
            }
            self.add_span(space, i, &gram, &pull);
        }
        self.lifted = self.lifted.take().filter(|l| l.carries(weights));
        if let Some(lifted) = &mut self.lifted {
            lifted.add_distance(weights, &rule, asked);
        }
    }

    /// Adds ½xᵀGx + pᵀx of the local functions of one span; G by its lower triangle.
    fn add_span(&mut self, space: &SplineSpace, span: usize, gram: &[f64], pull: &[f64]) {
        let n = space.degree() + 1;
        for k in 0..n {
            let i = space.index(span, k);
            self.gradient[i] += pull[k];
            for l in 0..=k {
                let j = space.index(span, l);
                // On few spans two functions of a span are one coefficient: both halves meet on the diagonal.
                let twice = if i == j && k != l { 2.0 } else { 1.0 };
                self.hessian.add(i, j, twice * gram[k * n + l]);
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
        self.add_distance(basis, &weights, degree + 1, |_| 0.0, None);
    }

    /// The value at `x`.
    pub fn value(&self, x: &[f64]) -> f64 {
        if let Some(lifted) = &self.lifted {
            return lifted.value(x) + self.constant;
        }
        let hx = self.hessian.times(x);
        hx.iter().zip(x).map(|(h, x)| 0.5 * h * x).sum::<f64>()
            + self.gradient.iter().zip(x).map(|(g, x)| g * x).sum::<f64>()
            + self.constant
    }
}

/// Rows at the quadrature nodes of one span, one after another; spans that look alike share them.
#[derive(Default)]
struct RowTable {
    rows: Vec<f64>,
    width: f64,
    matrix: Option<usize>,
}

impl RowTable {
    fn rows(
        &mut self,
        space: &SplineSpace,
        span: usize,
        rule: &[(f64, f64)],
        weights: &[f64],
    ) -> (&[f64], bool) {
        let this = &space.spans()[span];
        let same = self.matrix == Some(this.matrix())
            && (this.width - self.width).abs() <= 1e-14 * this.width;
        if !same {
            self.matrix = Some(this.matrix());
            self.width = this.width;
            self.rows.clear();
            for &(u, _) in rule {
                self.rows.extend(space.row(span, u, weights));
            }
        }
        (&self.rows, same)
    }
}

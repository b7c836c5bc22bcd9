//! Program with all its rows given in advance, for the interior-point method.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverStatus, SupportedConeT,
};

use super::{Between, Bound, Task, refused};
use gaitcam::error::Result;
use gaitcam::law::Law;
use splineqp::{Basis, Entries, Failure, Stop};

/// Conic program with all rows given in advance: minimise ½xᵀHx + gᵀx with b − Ax in cones.
pub struct Conic {
    basis: Basis,
    n: usize,
    columns: usize,
    length: f64,
    hessian: Vec<(usize, usize, f64)>,
    gradient: Vec<f64>,
    rows: Vec<(Entries, f64)>,
    cones: Vec<SupportedConeT<f64>>,
}

impl Task<'_> {
    /// Conic program of the task with all rows given in advance.
    ///
    /// # Errors
    ///
    /// [`Between::Cone`] for a derivative that is not quadratic on a span.
    pub fn conic(&self, between: Between) -> Result<Conic> {
        let basis = self.basis();
        let target = self.target();
        let force = self.distance(&target, &basis);
        let n = basis.columns();
        let mut conic = Conic {
            length: self.length(&target),
            basis,
            n,
            columns: n,
            hessian: force.hessian.lower_entries(),
            gradient: force.gradient,
            rows: Vec::new(),
            cones: Vec::new(),
        };
        if self.drive.spring_rate == 0.0 {
            // Neither force nor limits depend on the absolute lift, so one coefficient is fixed at 0.
            conic.rows.push((vec![(n - 1, 1.0)], 0.0));
            conic.cones.push(SupportedConeT::ZeroConeT(1));
        }
        for bound in self.bounds {
            match between {
                Between::Samples(count) => conic.sampled(bound, count),
                Between::Coefficients => conic.coefficients(bound, self.degree),
                Between::Cone if self.degree == bound.order + 2 => conic.cones(bound),
                Between::Cone => {
                    return Err(crate::fault(format!(
                        "derivative {} of degree {} is not quadratic on a span",
                        bound.order, self.degree
                    )));
                }
            }
        }
        Ok(conic)
    }
}

impl Conic {
    fn pieces(&self) -> usize {
        self.basis.breaks().len() - 1
    }

    /// Adds rows for both signs of a sample: ±row ≤ most, divided by `most`.
    fn both(&mut self, row: &Entries, most: f64) {
        for sign in [1.0, -1.0] {
            let scaled = row
                .iter()
                .map(|&(i, v)| (i, sign * v * self.length / most))
                .collect();
            self.rows.push((scaled, 1.0));
        }
    }

    fn sampled(&mut self, bound: &Bound, count: usize) {
        let mut weights = [0.0; 5];
        weights[bound.order] = 1.0;
        for piece in 0..self.pieces() {
            for k in 0..count {
                let u = (k as f64 + 0.5) / count as f64;
                let row = self.basis.row_on(piece, u, &weights);
                self.both(&row, bound.most);
            }
        }
        let rows = 2 * count * self.pieces();
        self.cones.push(SupportedConeT::NonnegativeConeT(rows));
    }

    fn coefficients(&mut self, bound: &Bound, degree: usize) {
        for piece in 0..self.pieces() {
            for row in self.bernstein(piece, bound.order, degree) {
                self.both(&row, bound.most);
            }
        }
        let rows = 2 * (degree - bound.order + 1) * self.pieces();
        self.cones.push(SupportedConeT::NonnegativeConeT(rows));
    }

    /// Rows of the Bernstein coefficients of derivative `order` on a piece.
    fn bernstein(&self, piece: usize, order: usize, degree: usize) -> Vec<Entries> {
        let Basis::Spline { space, .. } = &self.basis else {
            return Vec::new();
        };
        let width = space.spans()[piece].width;
        let mut differences: Vec<Vec<f64>> = (0..=degree)
            .map(|k| (0..=degree).map(|i| f64::from(i == k)).collect())
            .collect();
        for d in 0..order {
            let factor = (degree - d) as f64 / width;
            differences = differences
                .windows(2)
                .map(|w| {
                    (w[1].iter().zip(&w[0]))
                        .map(|(b, a)| factor * (b - a))
                        .collect()
                })
                .collect();
        }
        differences
            .iter()
            .map(|weights| {
                let mut local = vec![0.0; degree + 1];
                space.pull_back(piece, weights, &mut local);
                (local.iter().enumerate())
                    .map(|(k, &v)| (space.index(piece, k), v))
                    .collect()
            })
            .collect()
    }

    /// Adds the cones of a bound: most ∓ s⁽ᵏ⁾ = b₀(1−u)² + 2b₁u(1−u) + b₂u² ≥ 0 holds exactly if b₁ = m + λ, λ ≥ 0, m² ≤ b₀b₂ (theory §9).
    fn cones(&mut self, bound: &Bound) {
        for piece in 0..self.pieces() {
            let b = self.bernstein(piece, bound.order, bound.order + 2);
            for sign in [1.0, -1.0] {
                let lambda = self.columns;
                self.columns += 1;
                // λ ≥ 0.
                self.rows.push((vec![(lambda, -1.0)], 0.0));
                self.cones.push(SupportedConeT::NonnegativeConeT(1));
                let part = |k: usize, factor: f64| -> Vec<(usize, f64)> {
                    b[k].iter()
                        .map(|&(i, v)| (i, factor * sign * v * self.length / bound.most))
                        .collect()
                };
                // (b₀ + b₂, b₀ − b₂, 2(b₁ − λ)) with bₖ = 1 ∓ row.
                let (first, last) = (part(0, 1.0), part(2, 1.0));
                let minus_last = part(2, -1.0);
                let mut middle = part(1, 2.0);
                middle.push((lambda, 2.0));
                self.rows.push(([first.clone(), last].concat(), 2.0));
                self.rows.push(([first, minus_last].concat(), 0.0));
                self.rows.push((middle, 2.0));
                self.cones.push(SupportedConeT::SecondOrderConeT(3));
            }
        }
    }

    /// Unit of the objective in the solver: the largest diagonal element of H.
    fn unit(&self) -> f64 {
        let largest = (self.hessian.iter())
            .filter(|e| e.0 == e.1)
            .fold(0.0_f64, |m, e| m.max(e.2));
        largest * self.length * self.length
    }

    /// Solves the program to a relative tolerance.
    ///
    /// # Errors
    ///
    /// The limits are infeasible, or the solver fails.
    pub fn solve(&self, tolerance: f64) -> Result<Law> {
        let factor = self.length * self.length / self.unit();
        let (mut i, mut j, mut v) = (Vec::new(), Vec::new(), Vec::new());
        for &(row, column, value) in &self.hessian {
            i.push(column);
            j.push(row);
            v.push(value * factor);
        }
        let p = CscMatrix::new_from_triplets(self.columns, self.columns, i, j, v);
        let (mut i, mut j, mut v) = (Vec::new(), Vec::new(), Vec::new());
        for (r, (entries, _)) in self.rows.iter().enumerate() {
            for &(column, value) in entries {
                i.push(r);
                j.push(column);
                v.push(value);
            }
        }
        let a = CscMatrix::new_from_triplets(self.rows.len(), self.columns, i, j, v);
        let b: Vec<f64> = self.rows.iter().map(|r| r.1).collect();
        let scale = self.length / self.unit();
        let mut q: Vec<f64> = self.gradient.iter().map(|g| g * scale).collect();
        q.resize(self.columns, 0.0);
        let fault = |e: String| crate::fault(format!("the solver refused: {e}"));
        let settings = DefaultSettingsBuilder::default()
            .verbose(false)
            .max_iter(200)
            .max_threads(1)
            .tol_gap_abs(tolerance)
            .tol_gap_rel(tolerance)
            .tol_feas(tolerance)
            .build()
            .map_err(|e| fault(e.to_string()))?;
        let mut solver = DefaultSolver::new(&p, &q, &a, &b, &self.cones, settings)
            .map_err(|e| fault(e.to_string()))?;
        solver.solve();
        let answer = &solver.solution;
        match answer.status {
            SolverStatus::Solved
            | SolverStatus::AlmostSolved
            | SolverStatus::InsufficientProgress => {}
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
                return Err(refused(&Failure::Infeasible));
            }
            _ => return Err(refused(&Stop::NumericalError.into())),
        }
        let x: Vec<f64> = answer.x[..self.n].iter().map(|y| y * self.length).collect();
        Ok(Law::of(&self.basis, &x))
    }
}

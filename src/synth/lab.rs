//! The solver's rungs one by one, opened for measuring them against each other.
//!
//! `synthesise` picks among them by itself; this module is for charts, benchmarks and tests that must see
//! a single rung, or a cheaper or dearer way to hold a limit between samples.

use std::f64::consts::TAU;

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverStatus, SupportedConeT,
};

use super::basis::{Basis, Entries};
use super::demand::Demand;
use super::objective::Quadratic;
use super::problem::{Failure, Limit, Program};
use super::{equality, harmonic};
use crate::drive::Drive;
use crate::error::{Error, Result};
use crate::gait::ForceCurve;
use crate::law::Law;
use crate::poly::SplineSpace;

/// A two-sided limit |s⁽ᵏ⁾| ≤ most on the whole turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// k, 1 … 4.
    pub order: usize,
    /// Its size, m/radᵏ.
    pub most: f64,
}

/// A periodic spline that follows a force.
#[derive(Debug, Clone)]
pub struct Task<'a> {
    /// One turn of wanted force.
    pub target: &'a ForceCurve,
    /// How lift becomes force.
    pub drive: Drive,
    /// Degree of the spline, at least 2.
    pub degree: usize,
    /// Number of equal spans.
    pub spans: usize,
    /// Limits.
    pub bounds: &'a [Bound],
}

/// How a limit is held between the points at which it is written down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Between {
    /// Not at all: this many samples on every span.
    Samples(usize),
    /// Bernstein coefficients of every span stay inside: safe, a little too strict.
    Coefficients,
    /// Exact cone for a derivative that is quadratic on every span.
    Cone,
}

/// Settings of the interior-point method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Gap and feasibility tolerance.
    pub tolerance: f64,
    /// Equilibration of rows and columns.
    pub equilibrate: bool,
    /// Presolve.
    pub presolve: bool,
    /// Iterative refinement of every factorisation.
    pub refine: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            tolerance: 1e-9,
            equilibrate: true,
            presolve: true,
            refine: true,
        }
    }
}

/// A law with how many iterations it took.
#[derive(Debug, Clone)]
pub struct Answer {
    /// The law.
    pub law: Law,
    /// Interior-point iterations; 0 for one factorisation.
    pub iterations: usize,
}

impl Task<'_> {
    fn basis(&self) -> Basis {
        Basis::Spline {
            space: SplineSpace::periodic_uniform(self.degree, self.spans, TAU),
            closed: true,
        }
    }

    /// A typical lift: what the force's swing takes.
    fn length(&self) -> f64 {
        let mean = self.target.mean_n();
        let (low, high) = self.target.range_n();
        let swing = (high - mean).max(mean - low);
        let w = self.drive.weights();
        let gain = w[0].abs().max(w[1].abs()).max(w[2].abs());
        if swing > 0.0 && gain > 0.0 {
            swing / gain
        } else {
            1.0
        }
    }

    fn distance(&self, basis: &Basis) -> Quadratic {
        let mut force = Quadratic::zero(basis);
        let nodes = (self.degree + 2).max(self.target.force_n.len().div_ceil(self.spans));
        let demand = demand(self.target, self.drive, self.target.cubics());
        force.add_distance(
            basis,
            &self.drive.weights(),
            nodes,
            |start, width, places, out| {
                demand.wanted_on(start, width, places, out);
                out.iter_mut().for_each(|f| *f -= self.drive.rest_force);
            },
            None,
        );
        force
    }

    fn program(&self) -> Program {
        let basis = self.basis();
        let force = self.distance(&basis);
        let mut program = Program::new(basis, force, Vec::new(), self.length());
        for bound in self.bounds {
            for sign in [1.0, -1.0] {
                let mut weights = [0.0; 5];
                weights[bound.order] = sign;
                let limit = Limit::new("derivative", weights, bound.most, bound.most);
                program.limits.push(limit);
            }
        }
        program
    }

    /// The best law without the limits: one factorisation.
    pub fn free(&self) -> Result<Answer> {
        let program = self.program();
        let x = equality::solve(&program).map_err(|f| refused(&f))?.x;
        Ok(Answer {
            law: program.basis.law(&x),
            iterations: 0,
        })
    }

    /// The best law with the limits, by exchange of rows at exact extrema: what `synthesise` does.
    pub fn exchange(&self) -> Result<Answer> {
        let program = self.program();
        let solution = program.solve().map_err(|f| refused(&f))?;
        Ok(Answer {
            law: program.basis.law(&solution.x),
            iterations: solution.iterations,
        })
    }

    /// The same with an interior-point method on the rows of every round.
    pub fn interior_point(&self) -> Result<Answer> {
        let program = self.program();
        let solution = program.solve_by_interior_point().map_err(|f| refused(&f))?;
        Ok(Answer {
            law: program.basis.law(&solution.x),
            iterations: solution.iterations,
        })
    }

    /// The same with all rows written down beforehand.
    ///
    /// Fails where a cone is asked for a derivative that is not quadratic on a span.
    pub fn conic(&self, between: Between) -> Result<Conic> {
        let basis = self.basis();
        let force = self.distance(&basis);
        let n = basis.columns();
        let mut conic = Conic {
            length: self.length(),
            basis,
            n,
            columns: n,
            hessian: force.hessian.lower_entries(),
            gradient: force.gradient,
            rows: Vec::new(),
            cones: Vec::new(),
        };
        if self.drive.spring_rate == 0.0 {
            // Nothing in force or limits knows the absolute lift.
            conic.rows.push((vec![(n - 1, 1.0)], 0.0));
            conic.cones.push(SupportedConeT::ZeroConeT(1));
        }
        for bound in self.bounds {
            match between {
                Between::Samples(count) => conic.sampled(bound, count),
                Between::Coefficients => conic.coefficients(bound, self.degree),
                Between::Cone if self.degree == bound.order + 2 => conic.cones(bound),
                Between::Cone => {
                    return Err(Error::new(format!(
                        "derivative {} of degree {} is not quadratic on a span",
                        bound.order, self.degree
                    )));
                }
            }
        }
        Ok(conic)
    }
}

/// Harmonics inverted one by one; N of force left over is not looked at.
pub fn spectral(target: &ForceCurve, drive: Drive, count: usize) -> Result<Law> {
    let demand = demand(target, drive, Vec::new());
    Ok(harmonic::invert(&demand, Some(count), 0.0)?.law())
}

/// As many harmonics, inverted one by one, as leave no more than `wanted` newtons RMS: what a scene gets
/// that names no family and breaks no limit.
pub fn first_rung(target: &ForceCurve, drive: Drive, wanted: f64) -> Result<Law> {
    let demand = demand(target, drive, Vec::new());
    Ok(harmonic::invert(&demand, None, wanted)?.law())
}

fn demand(target: &ForceCurve, drive: Drive, cubics: Vec<[f64; 4]>) -> Demand {
    Demand {
        target: Some(target.clone()),
        drive,
        phase: 0.0,
        cubics,
        length: 1.0,
        remarks: Vec::new(),
    }
}

fn refused(failure: &Failure) -> Error {
    Error::new(match failure {
        Failure::Equalities(names) => format!("demands contradict each other: {names:?}"),
        Failure::Infeasible => "the limits leave nothing".to_string(),
        Failure::Solver(word) => format!("the solver gave up: {word}"),
    })
}

/// A conic program with all its rows written down: minimise ½xᵀHx + gᵀx, b − Ax in cones.
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

impl Conic {
    fn pieces(&self) -> usize {
        self.basis.breaks().len() - 1
    }

    /// Both signs of one sample: ±row ≤ most, divided by `most`.
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

    /// most ∓ s⁽ᵏ⁾ = b₀(1−u)² + 2b₁u(1−u) + b₂u² ≥ 0 exactly when b₁ = m + λ, λ ≥ 0, m² ≤ b₀b₂ (FACTS §9).
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

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows.len()
    }

    /// Objective in the solver's unit: the largest of H's diagonal counts 1.
    fn unit(&self) -> f64 {
        let largest = (self.hessian.iter())
            .filter(|e| e.0 == e.1)
            .fold(0.0_f64, |m, e| m.max(e.2));
        largest * self.length * self.length
    }

    fn linear(&self, gradient: &[f64]) -> Vec<f64> {
        let factor = self.length / self.unit();
        let mut q: Vec<f64> = gradient.iter().map(|g| g * factor).collect();
        q.resize(self.columns, 0.0);
        q
    }

    /// Hands the program to the solver.
    pub fn prepare(&self, settings: Settings) -> Result<Prepared> {
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
        let q = self.linear(&self.gradient);
        let fault = |e: String| Error::new(format!("the solver refused: {e}"));
        let settings = chosen(settings).map_err(fault)?;
        let solver = DefaultSolver::new(&p, &q, &a, &b, &self.cones, settings)
            .map_err(|e| fault(e.to_string()))?;
        Ok(Prepared {
            solver,
            basis: self.basis.clone(),
            n: self.n,
            length: self.length,
        })
    }

    /// Prepares and solves.
    pub fn solve(&self, settings: Settings) -> Result<Answer> {
        self.prepare(settings)?.solve()
    }

    /// The linear part of the objective for another target with the same mean and drive, to be handed to
    /// [`Prepared::update`].
    pub fn linear_part(&self, task: &Task) -> Vec<f64> {
        self.linear(&task.distance(&self.basis).gradient)
    }
}

fn chosen(s: Settings) -> std::result::Result<DefaultSettings<f64>, String> {
    DefaultSettingsBuilder::default()
        .verbose(false)
        .max_iter(200)
        .max_threads(1)
        .tol_gap_abs(s.tolerance)
        .tol_gap_rel(s.tolerance)
        .tol_feas(s.tolerance)
        .equilibrate_enable(s.equilibrate)
        .presolve_enable(s.presolve)
        .iterative_refinement_enable(s.refine)
        .build()
        .map_err(|e| e.to_string())
}

/// A program in the solver's hands: structure analysed once, data may change.
pub struct Prepared {
    solver: DefaultSolver<f64>,
    basis: Basis,
    n: usize,
    length: f64,
}

impl Prepared {
    /// Solves as it stands.
    ///
    /// Fails when the limits leave nothing or the solver gives up.
    pub fn solve(&mut self) -> Result<Answer> {
        self.solver.solve();
        let answer = &self.solver.solution;
        match answer.status {
            SolverStatus::Solved
            | SolverStatus::AlmostSolved
            | SolverStatus::InsufficientProgress => {}
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
                return Err(refused(&Failure::Infeasible));
            }
            other => return Err(refused(&Failure::Solver(format!("{other:?}")))),
        }
        let x: Vec<f64> = answer.x[..self.n].iter().map(|y| y * self.length).collect();
        Ok(Answer {
            law: self.basis.law(&x),
            iterations: answer.iterations as usize,
        })
    }

    /// Exchanges the linear part of the objective (of [`Conic::linear_part`]); needs presolve off.
    pub fn update(&mut self, linear: &[f64]) -> Result<()> {
        self.solver
            .update_q(&linear.to_vec())
            .map_err(|e| Error::new(format!("the solver refused: {e}")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gait::{Feet, model};

    fn task<'a>(target: &'a ForceCurve, bounds: &'a [Bound]) -> Task<'a> {
        let drive = Drive::moving_axis(target.mean_n() / 9.81, 9.81, TAU / target.period_s);
        Task {
            target,
            drive,
            degree: 5,
            spans: 24,
            bounds,
        }
    }

    fn error(task: &Task, law: &Law) -> f64 {
        let n = 2000;
        let sum: f64 = (0..n)
            .map(|i| TAU * i as f64 / f64::from(n))
            .map(|x| (task.drive.force(law.svaj(x)) - task.target.at(x)).powi(2))
            .sum();
        (sum / f64::from(n)).sqrt()
    }

    /// FACTS §9: cone exact, Bernstein rows a little too strict, samples too lax; exchange equals the cone.
    #[test]
    fn cone_and_exchange_agree_and_rows_stand_on_the_safe_side() {
        let target = model("young", Some(1.85), 700.0, Feet::Both).unwrap();
        let free = task(&target, &[]).free().unwrap().law;
        let most = 0.6 * free.extremes(3).1.value;
        let bounds = [Bound { order: 3, most }];
        let t = task(&target, &bounds);
        let jerk = |law: &Law| {
            let (low, high) = law.extremes(3);
            high.value.max(-low.value) / most
        };
        let conic = |b| t.conic(b).unwrap().solve(Settings::default()).unwrap().law;
        let exchange = t.exchange().unwrap().law;
        let cone = conic(Between::Cone);
        let rows = conic(Between::Coefficients);
        let lax = conic(Between::Samples(1));
        // The exchange may keep up to a millionth of the limit free for what the solver does not resolve.
        let used = jerk(&exchange);
        assert!(used > 1.0 - 2e-6 && used <= 1.0 + 1e-9, "{used}");
        assert!((jerk(&cone) - 1.0).abs() < 1e-6);
        assert!(jerk(&rows) < 1.0 + 1e-6);
        assert!(jerk(&lax) > 1.01, "{}", jerk(&lax));
        let [e_exchange, e_cone, e_rows] = [&exchange, &cone, &rows].map(|l| error(&t, l));
        assert!(
            (e_exchange - e_cone).abs() < 1e-5 * e_cone,
            "{e_exchange} {e_cone}"
        );
        assert!(e_rows >= e_cone * (1.0 - 1e-6));
    }
}

//! Methods of the solver one by one, for comparisons.
//!
//! `synthesise` selects among them automatically. This module is for charts, benchmarks and tests that use a single method, or another treatment of a
//! limit between samples.

use std::f64::consts::TAU;

mod conic;

pub use conic::Conic;

use gaitcam::drive::Drive;
use gaitcam::error::{Error, Result};
use gaitcam::force::ForceCurve;
use gaitcam::law::Law;
use gaitcam::poly::SplineSpace;
use gaitcam::problem::Target;
use gaitcam::synth::invert;
use gaitcam::wording::{self, Language};
use splineqp::{self as qp, Basis, Failure, Limit, Quadratic};

/// Program whose limits have the names of the charts.
type Program = qp::Program<()>;

/// Two-sided limit |s⁽ᵏ⁾| ≤ most on the whole turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Order k of the derivative, 1 … 4.
    pub order: usize,
    /// Maximum of the derivative, m/radᵏ.
    pub most: f64,
}

/// Task for a periodic spline that follows a force.
#[derive(Debug, Clone)]
pub struct Task<'a> {
    /// One turn of the target force.
    pub target: &'a ForceCurve,
    /// Drive, which determines the force for a lift.
    pub drive: Drive,
    /// Degree of the spline, at least 2.
    pub degree: usize,
    /// Number of equal spans of the spline.
    pub spans: usize,
    /// Two-sided limits on the derivatives.
    pub bounds: &'a [Bound],
}

/// Treatment of a limit between the points of its rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Between {
    /// Rows at this number of samples on every span, and none between them.
    Samples(usize),
    /// Rows for the Bernstein coefficients of every span, which is sufficient but slightly too strict.
    Coefficients,
    /// Exact cone for a derivative that is quadratic on every span.
    Cone,
}

impl<'a> Task<'a> {
    /// Task for the quintic spline of `spans` spans without bounds.
    pub fn quintic(target: &'a ForceCurve, drive: Drive, spans: usize) -> Task<'a> {
        Task {
            target,
            drive,
            degree: 5,
            spans,
            bounds: &[],
        }
    }
}

impl Task<'_> {
    fn basis(&self) -> Basis {
        Basis::Spline {
            space: SplineSpace::periodic_uniform(self.degree, self.spans, TAU),
            closed: true,
        }
    }

    /// Typical lift, from the range of the force.
    fn length(&self, target: &Target) -> f64 {
        let swing = target.farthest_from(target.mean_n());
        let w = self.drive.weights();
        let gain = w[0].abs().max(w[1].abs()).max(w[2].abs());
        if swing > 0.0 && gain > 0.0 {
            swing / gain
        } else {
            1.0
        }
    }

    fn target(&self) -> Target {
        Target::new(self.target.clone())
    }

    fn distance(&self, target: &Target, basis: &Basis) -> Quadratic {
        let mut force = Quadratic::zero(basis);
        let nearest = target.cells().nearest(&basis.breaks(), self.degree);
        let mut pieces = nearest.chunks_exact(self.degree + 1);
        force.add_distance(
            basis,
            &self.drive.weights(),
            self.degree + 1,
            |_, _, _, out| {
                for (out, f) in out.iter_mut().zip(pieces.next().unwrap_or_default()) {
                    *out = f - self.drive.rest_force;
                }
            },
            None,
        );
        force.constant = 0.5 * target.cells().mean_square_from(self.drive.rest_force);
        force
    }

    /// Convex program of the task.
    pub fn program(&self) -> Program {
        let basis = self.basis();
        let target = self.target();
        let force = self.distance(&target, &basis);
        let mut program = Program::new(basis, force, Vec::new(), self.length(&target));
        for bound in self.bounds {
            for sign in [1.0, -1.0] {
                let mut weights = [0.0; 5];
                weights[bound.order] = sign;
                let limit = Limit::on("peak", weights).at_most(bound.most);
                program.limits.push(limit);
            }
        }
        program
    }

    /// Optimal law without limits, by one factorisation.
    pub fn free(&self) -> Result<Law> {
        let program = self.program();
        let x = qp::solve_equalities(&program).map_err(|f| refused(&f))?.x;
        Ok(Law::of(&program.basis, &x))
    }

    /// Optimal law with the limits, by exchange of rows at exact extrema, which `synthesise` uses.
    pub fn exchange(&self) -> Result<Law> {
        let program = self.program();
        let solution = program.solve().map_err(|f| refused(&f))?;
        Ok(Law::of(&program.basis, &solution.x))
    }

    /// Optimal law with the limits, by exchange with an interior-point method for the rows of every round.
    pub fn interior_point(&self) -> Result<Law> {
        let program = self.program();
        let solution = qp::solve_by_interior_point(&program).map_err(|f| refused(&f))?;
        Ok(Law::of(&program.basis, &solution.x))
    }
}

/// Law of the first `count` harmonics, inverted one by one, for any remaining force error.
pub fn spectral(target: &ForceCurve, drive: Drive, count: usize) -> Result<Law> {
    Ok(invert(&Target::new(target.clone()), &drive, Some(count), 0.0)?.law())
}

/// Law of as many harmonics, inverted one by one, as are needed for a force error of at most `rms` newtons. This is the default family if the law
/// satisfies the limits.
pub fn first_rung(target: &ForceCurve, drive: Drive, rms: f64) -> Result<Law> {
    Ok(invert(&Target::new(target.clone()), &drive, None, rms)?.law())
}

fn refused(failure: &Failure<()>) -> Error {
    crate::fault(match failure {
        Failure::Inconsistent { equalities } => {
            format!("contradicting equalities: {equalities:?}")
        }
        Failure::Infeasible => "infeasible limits".to_string(),
        Failure::Numerical { stop } => wording::sentence(Language::En, "name", stop),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use gaitcam::force::{Feet, model};

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

    /// Theory §9: the cone is exact, Bernstein rows are slightly too strict, and samples are insufficient. The exchange equals the cone.
    #[test]
    fn cone_and_exchange_agree_and_rows_stand_on_the_safe_side() {
        let target = model("young", Some(1.85), 700.0, Feet::Both).unwrap();
        let free = task(&target, &[]).free().unwrap();
        let most = 0.6 * free.extremes(3).1.value;
        let bounds = [Bound { order: 3, most }];
        let t = task(&target, &bounds);
        let jerk = |law: &Law| {
            let (low, high) = law.extremes(3);
            high.value.max(-low.value) / most
        };
        let conic = |b| t.conic(b).unwrap().solve(1e-9).unwrap();
        let exchange = t.exchange().unwrap();
        let cone = conic(Between::Cone);
        let rows = conic(Between::Coefficients);
        let lax = conic(Between::Samples(1));
        // The exchange may leave up to a millionth of the limit unused, because of the tolerance of the solver.
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

//! Derivative of the Lagrangian of a solution with respect to the force. The program for a moving floor uses this derivative.

use super::Optimum;
use crate::criterion::{Criterion, DependsOn};
use crate::problem::Problem;
use crate::scene::Minimise;
use crate::synth::qp::{Program, Row, Solution};

/// Derivative of the Lagrangian with respect to the force. It consists of factors of the force error, and of multipliers at angles.
#[derive(Debug, Clone, PartialEq)]
pub struct ForcePrice {
    /// Factor of the weighted force error that comes from the objective: 1 if the mean square force error is minimised, otherwise 0.
    pub of_objective: f64,
    /// Factor of the force error that comes from the limit on its root mean square.
    pub of_accuracy: f64,
    /// Angle, rad, and signed multiplier of every active limit on the force.
    pub of_limits: Vec<(f64, f64)>,
    /// Whether the derivative is complete and the multipliers are valid for all laws. This requires an objective and active limits that are
    /// linear or quadratic in the force.
    pub is_whole: bool,
}

impl ForcePrice {
    /// Derivative for a solution without active limits.
    pub fn unlimited(problem: &Problem) -> ForcePrice {
        let is_minimised = problem.objective() == Minimise::ForceError;
        ForcePrice {
            of_objective: f64::from(u8::from(is_minimised)),
            of_accuracy: 0.0,
            of_limits: Vec::new(),
            is_whole: !problem.is_weighed(),
        }
    }

    /// Derivative of the Lagrangian with respect to the force at an optimum, with the multipliers of `solution`.
    pub fn of(problem: &Problem, optimum: &Optimum, solution: &Solution) -> ForcePrice {
        let mut out = ForcePrice::unlimited(problem);
        out.is_whole &= optimum.at.is_none() && optimum.sequence.is_none();
        let program = &optimum.formulation.program;
        let inertia = problem.drive.weights()[2];
        for row in &solution.active {
            if row.name == Criterion::Accuracy {
                out.of_accuracy += row.multiplier / most(program, row);
            } else if is_of_force(problem, row) {
                let sign = row.weights[2] / inertia;
                out.of_limits.push((row.peak.at, sign * row.multiplier));
            } else if let Criterion::Limit(kind) = row.name {
                out.is_whole &= kind.facts().depends_on != DependsOn::Load;
            }
        }
        out
    }
}

/// The solution with multipliers per unit of the force on the moving floor. The force in the program is 1/G∞ times the force on the moving
/// floor.
pub fn on_floor(problem: &Problem, solution: &Solution) -> Solution {
    let mut out = solution.clone();
    let at_once = problem.through_floor().map_or(1.0, |floor| floor.at_once);
    for row in &mut out.active {
        if row.name == Criterion::Accuracy || is_of_force(problem, row) {
            row.multiplier /= at_once;
        }
    }
    out
}

/// Whether a row limits the force or its difference from the target.
fn is_of_force(problem: &Problem, row: &Row) -> bool {
    match row.name {
        Criterion::Limit(kind) => kind.facts().depends_on == DependsOn::Force,
        Criterion::Band => true,
        Criterion::Peak => problem.objective() == Minimise::PeakForceError,
        _ => false,
    }
}

/// Bound, N, of the root-mean-square limit to which the tangent `row` belongs; infinite if there is no such limit.
fn most(program: &Program, row: &Row) -> f64 {
    let own = program.rms.iter().find(|limit| limit.is_tangent(row));
    own.map_or(f64::INFINITY, |limit| limit.most)
}

//! Lower bounds of the force error that refuse a design before it is solved.
//!
//! The multipliers of a convex program prove that no law which keeps the limits they stand on comes nearer to the force
//! (theory §8). The proof holds as it is for every program with the same objective, the same demands and those limits,
//! whatever its other limits: relaxing a limit without a multiplier cannot help.

use super::touching::Optimum;
use crate::problem::Problem;
use crate::scene::Minimise;
use crate::synth::qp::{self, Program, Solution};
use crate::synth::search::Search;

/// A lower bound of the error beyond what is allowed by this part of it is no rounding.
const SURELY: f64 = 1e-6;
/// Stationarity that multipliers must have for a proof.
const STATIONARY: f64 = 1e-6;

/// A program whose optimum misses the accuracy, with that optimum: what its multipliers prove holds for others too.
#[derive(Debug)]
pub struct MissedAccuracy {
    program: Program,
    solution: Solution,
}

/// Whether no law that keeps the convex limits reaches the accuracy, and nothing else is of use. Remembered for the
/// problems that follow.
pub fn is_missed(problem: &Problem, search: &Search, optimum: &Optimum) -> bool {
    let Some(allowed) = judged(problem).filter(|_| search.only_passing) else {
        return false;
    };
    let missed = is_beyond(optimum.least(), allowed);
    // A touching angle is proved over all angles by other means.
    if missed && optimum.at.is_none() {
        let (program, solution) = (optimum.program.clone(), optimum.solution.clone());
        let proof = MissedAccuracy { program, solution };
        search.cache.missed.keep(proof, ());
    }
    missed
}

/// Whether an earlier proof holds for this program too.
pub fn refuses(problem: &Problem, search: &Search, program: &Program) -> bool {
    let Some(allowed) = judged(problem).filter(|_| search.only_passing) else {
        return false;
    };
    search.cache.missed.any(|proof| {
        is_alike(&proof.program, program)
            && least(proof, program).is_some_and(|least| is_beyond(least, allowed))
    })
}

/// The error allowed, where it is what the program minimises. More spans may reach it where their number is open.
fn judged(problem: &Problem) -> Option<f64> {
    if problem.law.spans.is_none()
        || problem.objective() != Minimise::ForceError
        || problem.is_weighed()
    {
        return None;
    }
    problem.allowed_error()
}

fn is_beyond(least: f64, allowed: f64) -> bool {
    (2.0 * least).max(0.0).sqrt() > (1.0 + SURELY) * allowed
}

/// What the multipliers on limits that both programs have prove of the objective.
fn least(proof: &MissedAccuracy, program: &Program) -> Option<f64> {
    let MissedAccuracy {
        program: solved,
        solution,
    } = proof;
    let mut shared = solution.clone();
    shared.active.retain(|row| {
        let limit = row.limit.map(|i| &solved.limits[i]);
        limit.is_some_and(|limit| program.limits.contains(limit))
    });
    let bound = qp::certificate(solved, &shared);
    (bound.stationarity <= STATIONARY).then(|| solved.merit(solution) - bound.duality_gap)
}

/// Whether two programs differ in their limits alone.
fn is_alike(a: &Program, b: &Program) -> bool {
    a.basis.breaks() == b.basis.breaks()
        && a.hessian.lower_entries() == b.hessian.lower_entries()
        && a.gradient == b.gradient
        && a.constant == b.constant
        && a.equalities == b.equalities
        && a.shapes == b.shapes
        && a.touching == b.touching
        && a.fixed.is_empty()
        && b.fixed.is_empty()
        && a.cost == b.cost
        && a.cone == b.cone
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cam::LimitKind;
    use crate::scene::built_in;
    use crate::synth::families::{spline, spline_program};

    /// A footbridge whose stroke leaves no room for the force, as the search for relaxations asks for it.
    fn cramped() -> (Problem, Search) {
        let scene = built_in("footbridge").unwrap().scene().unwrap();
        let with = [
            ("law.family", "spline"),
            ("law.spans", "24"),
            ("limits.stroke", "20 mm"),
            ("limits.jerk", "9000 m/s^3"),
        ];
        let scene = (with.iter()).fold(scene, |s, (key, value)| s.with(key, value).unwrap());
        let force = scene.model_force().unwrap();
        let problem = Problem::resolve(&scene, force.as_ref()).unwrap();
        let search = Search {
            only_passing: true,
            ..Search::default()
        };
        (problem, search)
    }

    fn known(problem: &Problem, search: &Search) -> bool {
        let (program, _) = spline_program::limited(problem, search, 24).unwrap();
        refuses(problem, search, &program)
    }

    #[test]
    fn a_missed_accuracy_is_known_where_a_limit_without_a_multiplier_is_relaxed_and_only_there() {
        let (problem, search) = cramped();
        assert!(
            !known(&problem, &search),
            "nothing is known before the first program"
        );
        assert!(spline::law(&problem, &search).is_err());
        assert!(known(&problem, &search));
        assert!(known(&problem.with(LimitKind::Jerk.into(), 1e6), &search));
        // The same without what is known, by its own program.
        let fresh = cramped().1;
        assert!(spline::law(&problem.with(LimitKind::Jerk.into(), 1e6), &fresh).is_err());
        let wide = problem.with(LimitKind::Stroke.into(), 1.0);
        assert!(!known(&wide, &search));
        assert!(spline::law(&wide, &search).is_ok());
    }
}

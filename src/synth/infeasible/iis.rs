//! Irreducible infeasible set of a program: conflicting limits that become feasible if any single limit is removed.

use super::reasons::conflicting;
use crate::cam::{Criterion, LimitKind};
use crate::problem::{Problem, Size};
use crate::synth::limits::NonconvexLimits;
use crate::synth::optimum::easing;
use crate::synth::optimum::{Refusal, at_own_size, scp};
use crate::synth::qp::{
    Demand, Failure, Limit, Meaning, PEAK, Program, Quadratic, RmsLimit, Solution, Values,
};
use crate::synth::report::limited::{Conflicting, Infeasible, Relaxation};
use crate::synth::report::reason::Reason;

/// Maximum number of equalities for which a minimal set is searched, because the search solves a program for each equality. If there are
/// more equalities, all of them are reported.
const MOST_DEMANDS: usize = 64;

/// Relative violation above which a solution does not satisfy a limit.
const BROKEN: f64 = 1e-6;

/// Explains why a program has no solution, by conflicting limits or conditions, and by a first relaxation of each limit.
pub fn explain(problem: &Problem, refusal: &Refusal) -> Infeasible {
    let because = |reason: Reason, conflict: Vec<Conflicting>| Infeasible {
        conflict,
        relaxations: Vec::new(),
        reasons: vec![reason],
    };
    match &refusal.failure {
        Failure::Inconsistent { equalities } => {
            let demands = equalities.clone();
            because(Reason::DemandsContradict { demands }, members(equalities))
        }
        Failure::Numerical { stop } => because(Reason::SolverStopped { stop: *stop }, Vec::new()),
        Failure::Infeasible => {
            let mut limits = conflicting_limits(problem, refusal);
            if let Some(nonconvex) = &refusal.nonconvex {
                // A law that satisfies the conditions and the convex limits was computed first.
                if limits.is_empty() {
                    limits = nonconvex.names();
                }
                let conflict = limits.iter().copied().map(Conflicting::Limit).collect();
                return because(Reason::NoLawFound { limits }, conflict);
            }
            if limits.is_empty() {
                let demands = conflicting_demands(problem, &refusal.program);
                let conflict = members(&demands);
                return because(Reason::DemandsInfeasible { demands }, conflict);
            }
            if problem.presses_too_little() && limits == [Criterion::from(LimitKind::ForceMin)] {
                let conflict = vec![Conflicting::Limit(limits[0])];
                return because(Reason::NothingPresses, conflict);
            }
            let relaxations = limits
                .iter()
                .filter_map(|&name| {
                    let own = best_accuracy(&refusal.program, name);
                    own.or_else(|| elastic(&refusal.program, name))
                })
                .collect();
            in_conflict(&limits, relaxations)
        }
    }
}

fn members(demands: &[Demand]) -> Vec<Conflicting> {
    demands.iter().copied().map(Conflicting::Demand).collect()
}

/// Result for conflicting limits. `relaxations` contains the values at which the search for sufficient changes begins.
fn in_conflict(kept: &[Criterion], relaxations: Vec<Relaxation>) -> Infeasible {
    Infeasible {
        conflict: kept.iter().copied().map(Conflicting::Limit).collect(),
        relaxations,
        reasons: vec![conflicting(kept)],
    }
}

/// Deletion filter for an irreducible infeasible set. The returned set is infeasible, but becomes feasible if any single member is removed.
/// If `can_hold` returns `None` for the set without a member, because the solver stopped early, this member remains in the set.
fn irreducible<T: Clone + PartialEq>(all: &[T], can_hold: impl Fn(&[T]) -> Option<bool>) -> Vec<T> {
    let mut kept = all.to_vec();
    for item in all {
        let without: Vec<T> = kept.iter().filter(|k| *k != item).cloned().collect();
        if can_hold(&without) == Some(false) {
            kept = without;
        }
    }
    kept
}

/// Irreducible set of conflicting limits of the scene, under all equalities. The set is empty if the equalities alone are infeasible.
fn conflicting_limits(problem: &Problem, refusal: &Refusal) -> Vec<Criterion> {
    let rows = refusal.program.limits.iter().filter(|l| is_asked(l));
    let nonconvex = refusal
        .nonconvex
        .as_ref()
        .map_or_else(Vec::new, |b| b.names());
    let mut names: Vec<Criterion> = Vec::new();
    let mean = refusal.program.rms.iter().map(|l| l.name);
    for name in rows.map(|l| l.name).chain(mean).chain(nonconvex) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let holds = |kept: &[Criterion]| {
        let stays = |name: Criterion| !names.contains(&name) || kept.contains(&name);
        let mut program = refusal.program.clone();
        program.limits.retain(|l| stays(l.name));
        let others = program.rms.iter_mut().filter(|l| !stays(l.name));
        others.for_each(unlimit);
        can_hold(
            problem,
            &program,
            refusal.nonconvex.as_ref().map(|b| b.only(stays)),
        )
    };
    // If no law is found without these limits, the limits are not the cause.
    if holds(&[]) != Some(true) {
        return Vec::new();
    }
    irreducible(&names, holds)
}

/// Points and dwells that together are infeasible for a law that is nowhere below the base circle.
fn conflicting_demands(problem: &Problem, program: &Program) -> Vec<Demand> {
    let mut names: Vec<Demand> = Vec::new();
    for demand in &program.equalities {
        if !names.contains(&demand.name) {
            names.push(demand.name);
        }
    }
    if names.len() > MOST_DEMANDS {
        return names;
    }
    let mut program = program.clone();
    program.limits.retain(|l| !is_asked(l));
    program.rms.iter_mut().for_each(unlimit);
    irreducible(&names, |kept| {
        let mut trial = program.clone();
        trial.equalities.retain(|e| kept.contains(&e.name));
        // Without a condition, a law that stays on the base circle is feasible.
        Some(kept.is_empty() || can_hold(problem, &trial, None) == Some(true))
    })
}

/// Makes a limit on a root mean square inactive. A program without other limits is then easy to solve.
fn unlimit(limit: &mut RmsLimit) {
    limit.most = f64::INFINITY;
}

/// Whether a limit has its value in the scene. The result is `false` for the base circle, a monotone flank and a minimised peak.
fn is_asked(limit: &Limit) -> bool {
    limit.meaning != Meaning::Structure && !limit.is_peak()
}

/// Whether a program has a feasible law; `None` if the solver stopped without a result.
fn can_hold(
    problem: &Problem,
    program: &Program,
    nonconvex: Option<NonconvexLimits>,
) -> Option<bool> {
    let solution = match program.rms.first() {
        Some(limit) => of_least(program, limit),
        None => program.solve(),
    };
    match solution {
        // If the exchange of rows ended with a violated limit, the solution is not a feasible law.
        Ok(own) if own.violation > BROKEN => Some(false),
        Ok(own) => Some(nonconvex.is_none_or(|limits| {
            let start = at_own_size(problem, program, &own).unwrap_or(own);
            scp::feasible(program, &start, limits).is_some()
        })),
        Err(Failure::Infeasible | Failure::Inconsistent { .. }) => Some(false),
        Err(Failure::Numerical { .. }) => None,
    }
}

/// Law with the minimum root mean square of the limited quantity. The result is an error if this minimum exceeds its limit, because then no
/// law satisfies the limit.
fn of_least(program: &Program, limit: &RmsLimit) -> Result<Solution, Failure> {
    let mut least = program
        .of_least_rms(limit.name)
        .ok_or(Failure::Infeasible)?;
    least.rms.retain(|l| l.most.is_finite());
    let own = least.solve()?;
    let holds = limit.excess(&own.x) <= BROKEN;
    holds.then_some(own).ok_or(Failure::Infeasible)
}

/// Conflict of bore and prime radius for an automatic size. The minimum base circle around the bore exceeds the limit on the prime radius.
/// `None` if there is no such conflict.
pub fn bore_against_size(problem: &Problem) -> Option<Infeasible> {
    let (bore, limit) = (problem.cam.bore?, problem.limits[LimitKind::PrimeRadius]?);
    let least = problem.outside_bore() + problem.cam.roller_radius;
    if matches!(problem.size(), Size::Given { .. }) || least <= limit {
        return None;
    }
    let smaller = bore - 2.0 * (least - limit);
    let conflict = [Criterion::Bore, LimitKind::PrimeRadius.into()];
    let relaxations = vec![
        Relaxation::of(conflict[0], bore, (smaller > 0.0).then_some(smaller)),
        Relaxation::of(conflict[1], limit, Some(least)),
    ];
    Some(in_conflict(&conflict, relaxations))
}

/// Relaxation of a limit on a root mean square (accuracy or mean power) to its minimum under the other limits. `None` if `name` is not such
/// a limit.
fn best_accuracy(program: &Program, name: Criterion) -> Option<Relaxation> {
    let limit = program.rms.iter().find(|l| l.name == name)?;
    let best = program.of_least_rms(name)?.solve().ok();
    let best = best.filter(|s| s.violation <= BROKEN);
    let to = best.and_then(|s| limit.meaning.value(limit.half.root(&s.x)));
    Some(Relaxation::of(name, limit.meaning.value(limit.most)?, to))
}

/// Minimum relaxation of one limit with which the program is feasible. It is computed by minimising the bound of this limit under the other
/// limits. `None` for a limit that is not a value of the scene. The complete design may require a larger change. The search in the module
/// `relaxation` starts from this value.
fn elastic(program: &Program, name: Criterion) -> Option<Relaxation> {
    let mut elastic = program.clone();
    let nothing = Quadratic::zero(&elastic.basis);
    elastic.hessian = nothing.hessian;
    elastic.gradient = nothing.gradient;
    elastic.limits.retain(|l| !l.is_peak());
    elastic.cost = Values::NONE;
    elastic.cost[PEAK] = 1.0;
    let is_number = |l: &Limit| l.name == name && l.meaning.value(l.bound).is_some();
    let first = *elastic.limits.iter().find(|l| is_number(l))?;
    let from = first.meaning.value(first.bound)?;
    for limit in elastic.limits.iter_mut().filter(|l| is_number(l)) {
        *limit = limit.minimised();
    }
    let to = elastic
        .solve()
        .ok()
        .filter(|s| s.violation <= BROKEN)
        .and_then(|s| first.meaning.value(s.extra[PEAK]));
    Some(Relaxation::of(easing::key(&first), from, to))
}

//! Best law under all limits. The touching angle, at which the law touches the base circle, is optimised first. Non-convex limits are then
//! added by a sequence of convex programs.

pub mod easing;
pub mod force_price;
mod refusal;
pub mod scp;
mod solved;
#[cfg(test)]
mod tests;
mod touching;

pub use force_price::ForcePrice;
pub use refusal::{Refusal, Sought};
pub use solved::{Formulation, Optimum};
pub use touching::at_best_angle;

use super::limits::{self, ENLARGED, NonconvexLimits};
use super::qp::{
    Demand, Equality, Failure, Limit, OFFSET, PEAK, Program, Quadratic, RADIUS, RISE, Solution,
    Stop,
};
use super::report::force::ForceReport;
use super::search::Search;
use super::sizing;
use crate::criterion::Criterion;
use crate::law::Law;
use crate::problem::{Problem, Size};
use crate::scene::Minimise;
use solved::Refined;

/// Maximum number of tangents of the limit on residual vibration for each dwell. Usually five tangents are sufficient.
const MOST_TANGENTS: usize = 40;

/// Optimum under the convex limits, the limit on vibration in dwells, and the load limits.
///
/// # Errors
///
/// No law satisfies the limits. If only passing designs are useful, a law that does not reach the accuracy is an error too.
pub fn solve(
    problem: &Problem,
    search: &Search,
    formulation: Formulation,
) -> Result<Optimum, Box<Refusal>> {
    let mut optimum = at_best_angle(formulation)?;
    if search.only_passing && optimum.misses_accuracy(problem) {
        return Err(Refusal::of(
            optimum.formulation.program,
            Failure::Infeasible,
        ));
    }
    without_vibration(problem, &mut optimum);
    match with_loads(problem, search, &mut optimum) {
        None => Ok(optimum),
        Some(limits) => {
            let failure = if search.halt.is_asked() {
                Stop::OutOfTime.into()
            } else {
                Failure::Infeasible
            };
            let refusal = Refusal {
                nonconvex: Some(limits),
                ..*Refusal::of(optimum.formulation.program, failure)
            };
            Err(Box::new(refusal))
        }
    }
}

/// Adds tangents of the limit on residual vibration until the law satisfies this limit.
fn without_vibration(problem: &Problem, optimum: &mut Optimum) {
    let basis = &optimum.formulation.program.basis;
    let Some(vibrations) = limits::Vibrations::of(problem, basis) else {
        return;
    };
    for _ in 0..MOST_TANGENTS {
        let tangents = vibrations.tangents(&optimum.solution.x);
        if tangents.is_empty() {
            return;
        }
        let mut formulation = optimum.formulation.clone();
        formulation.program.fixed.extend(tangents);
        // Without a solution, the check reports the residual vibration.
        let Ok(quieter) = at_best_angle(formulation) else {
            return;
        };
        *optimum = quieter;
    }
}

/// Continues with the sequence of convex programs if the law violates a load limit. Returns the limits if no feasible start was found, otherwise
/// `None`.
fn with_loads(
    problem: &Problem,
    search: &Search,
    optimum: &mut Optimum,
) -> Option<NonconvexLimits> {
    let limits = NonconvexLimits::of(problem)?;
    limits.loads.as_ref()?;
    let (program, solution) = at_level(problem, optimum, &limits, &optimum.solution);
    let here = scp::AtSize::new(limits.clone(), &program).of(&solution);
    if limits::loaded(&Law::of(&program.basis, &solution.x), &here) >= 0.0 {
        return None;
    }
    (!in_sequence(problem, search, optimum, limits.clone())).then_some(limits)
}

/// Continues with the sequence of convex programs for non-convex limits. It starts from the optimum without these limits, then from the
/// smallest cam without these limits. Returns `false` if no feasible start was found.
fn in_sequence(
    problem: &Problem,
    search: &Search,
    optimum: &mut Optimum,
    limits: NonconvexLimits,
) -> bool {
    let (mut program, solution) = at_level(problem, optimum, &limits, &optimum.solution);
    if scp::keeps(&program, &solution, &limits) {
        return true;
    }
    limits::leave_room(&mut program);
    if let Some(found) = sequence_from(problem, search, optimum, &limits, &program, &solution) {
        // If the sequence returns the convex optimum at the same cost, this optimum and its certificate are kept.
        let (refined, steps, _) = &found;
        let as_it_was = steps.is_empty() && refined.x == solution.x;
        if !as_it_was || program.merit(refined) > program.merit(&solution) {
            optimum.ended_by(program, found);
        }
        return true;
    }
    if limits.profile.is_none() || problem.size() != Size::Sought {
        return false;
    }
    let formulation = &optimum.formulation;
    let smallest = Formulation {
        program: scp::of_least_size(&formulation.program, &optimum.solution.extra),
        stiffness: None,
        ..formulation.clone()
    };
    let Ok(mut smallest) = at_best_angle(smallest) else {
        return false;
    };
    let least = &mut smallest.solution;
    least.extra[PEAK] = formulation.program.own_peak(&least.x, &least.extra);
    let (mut program, solution) = at_level(problem, optimum, &limits, &smallest.solution);
    limits::leave_room(&mut program);
    let found = sequence_from(problem, search, optimum, &limits, &program, &solution);
    let is_found = found.is_some();
    if let Some(found) = found {
        optimum.ended_by(program, found);
    }
    is_found
}

/// Sequence of convex programs that starts from a program with a fixed level of the lift, and its solution; `None` without a feasible start.
fn sequence_from(
    problem: &Problem,
    search: &Search,
    optimum: &Optimum,
    limits: &NonconvexLimits,
    program: &Program,
    solution: &Solution,
) -> Option<Refined> {
    let mut starts = starts(problem, program, solution);
    if problem.objective() == Minimise::PeakForceError {
        let force = &optimum.formulation.force;
        // If no start is feasible, the last start is shrunk or tightened. This start already has its final size, so it precedes the other
        // starts.
        starts.splice(0..0, nearest_to_force(problem, program, force, limits));
    }
    // A law that satisfies every limit passes, except that its force error may still exceed the accuracy.
    let passes = |s: &Solution| {
        let error = || ForceReport::of(problem, &Law::of(&program.basis, &s.x)).rms_error_n;
        search.only_passing && problem.allowed_error().is_none_or(|most| error() <= most)
    };
    scp::refine(program, &starts, limits.clone(), passes)
}

/// Possible starts of a sequence: the solution of the program, and the same law on a cam of the size that the law requires.
fn starts(problem: &Problem, program: &Program, solution: &Solution) -> Vec<Solution> {
    let mut out = Vec::new();
    // At the minimum radius of an arm, the linearisation is singular.
    if problem.reach_of_arm().is_none() || problem.size() != Size::Sought {
        out.push(solution.clone());
    }
    out.extend(at_own_size(problem, program, solution));
    out
}

/// Feasible law with the minimum mean square force error under the same limits, as a start if the maximum error is minimised. The programs
/// with this objective are easier to solve.
fn nearest_to_force(
    problem: &Problem,
    program: &Program,
    force: &Quadratic,
    limits: &NonconvexLimits,
) -> Option<Solution> {
    let mut near = program.clone().minimising(force.clone());
    near.rms.retain(|l| l.name != Criterion::Accuracy);
    let solution = near.solve().ok()?;
    let starts = starts(problem, &near, &solution);
    let (mut found, ..) = scp::refine(&near, &starts, limits.clone(), |_| false)?;
    found.active.clear();
    found.extra[PEAK] = program.own_peak(&found.x, &found.extra);
    Some(found)
}

/// Program and solution with a fixed level of the lift. If limits of the profile depend on this level and the problem does not fix it, the
/// law is shifted to a minimum lift of zero.
fn at_level(
    problem: &Problem,
    optimum: &Optimum,
    limits: &NonconvexLimits,
    solution: &Solution,
) -> (Program, Solution) {
    let (mut program, mut solution) = (optimum.formulation.program.clone(), solution.clone());
    if problem.level_is_known() || limits.profile.is_none() {
        return (program, solution);
    }
    // If a limit does not determine the angle of the minimum, the law may be lower at other angles. Raising the law only increases all
    // lifts.
    let lowest = Law::of(&program.basis, &solution.x).extremes(0).0;
    solution.x = program.basis.raised(solution.x, -lowest.value);
    program.count_from(lowest.at);
    program.equalities.push(Equality {
        name: Demand::OnBaseCircle,
        entries: program.basis.row(lowest.at, &[1.0, 0.0, 0.0, 0.0]),
        value: 0.0,
    });
    let is_on_lift = |l: &Limit| l.name == Criterion::BaseCircle && !l.is_on_variables_alone();
    program.limits.retain(|l| !is_on_lift(l));
    program.limits.extend(optimum.formulation.above_base_circle);
    (program, solution)
}

/// Adds the non-convex limits of the profile by a sequence of convex programs.
pub fn with_profile(problem: &Problem, search: &Search, optimum: &mut Optimum) {
    if optimum.sequence.is_some() {
        return;
    }
    if let Some(limits) = NonconvexLimits::of(problem).filter(|l| l.profile.is_some()) {
        optimum.left_out = !in_sequence(problem, search, optimum, limits);
    }
}

/// The law of a solution with the size of the cam that the law requires, if the size is a variable. The size in the solution satisfies only
/// the convex limits, and it is arbitrary if it has no cost. For a follower on an arm, the size is limited by the reach of the arm.
pub fn at_own_size(problem: &Problem, program: &Program, solution: &Solution) -> Option<Solution> {
    if problem.size() != Size::Sought {
        return None;
    }
    let mut out = solution.clone();
    let law = Law::of(&program.basis, &solution.x);
    let own = sizing::cam(problem, law.clone(), &law).ok();
    let prime = own.as_ref().map(|cam| cam.follower.prime_radius());
    if let Some([least, most]) = problem.reach_of_arm() {
        let most = (most * (1.0 - 4.0 * ENLARGED)).max(least);
        let prime = prime.map_or(most, |own| own * (1.0 + ENLARGED));
        out.extra[RADIUS] = prime.clamp(least, most);
    } else {
        let (prime, offset) = (prime?, own?.follower.offset());
        let rise = (prime * prime - offset * offset).max(0.0).sqrt();
        let sizes = [(RADIUS, prime), (RISE, rise), (OFFSET, offset)];
        let present = program.present();
        for (k, value) in sizes.into_iter().filter(|(k, _)| present[*k]) {
            out.extra[k] = value * if k == OFFSET { 1.0 } else { 1.0 + ENLARGED };
        }
    }
    Some(out)
}

//! Limits that are not convex in the law, by a sequence of convex programs that stays feasible: a roller's
//! curvature, and curvature and pressure angle of followers on an arm.
//!
//! With X = D + s, Y = v − e, w = X² + Y² and ρ = ρ_cam,min + R_f the pitch curve is nowhere sharper than ρ
//! where h = w^{3/2}/ρ − (w + vY − aX) ≥ 0 (theory §6). That is not convex. It is linearised about the last
//! law at the places where it is near zero, the convex program is solved again, and the step is shortened
//! until the true h holds all around: every limit that is convex holds along the whole step.
//! A whole step that breaks h is linearised once more about its own end (Newton's method on the contacts), and cut
//! short only where that does not mend it.
//! The first steps use the restriction a ≥ X − X²/ρ with X² ≥ 2X₀X − X₀², which is sufficient for X ≥ 4ρ/3
//! and needs no trust in the linearisation. Followers on an arm go the same way with the h of their own
//! geometry. A concave profile needs no row: its radius is the pitch curve's plus the roller's, so the
//! roller always fits.

mod at_size;
mod linearised;
mod start;
#[cfg(test)]
mod tests;
mod trial;

pub use at_size::AtSize;

use linearised::{NEARLY, Room, contacts, least_of, linearised};
use trial::{ROOM, blend, solved};

use crate::cam::LimitKind;
use crate::synth::limits::{ENLARGED, NonconvexLimits};
use crate::synth::qp::{
    PEAK, Program, Quadratic, RADIUS, RISE, Row, SIZES, Solution, TOLERANCE, Values, sizes,
    smoothing, structural,
};
use crate::synth::report::method::Ended;
use crate::synth::report::solver::Step;

/// Steps before the sequence is called finished as it is.
const MOST_STEPS: usize = 40;
/// A step must promise to improve the merit by this part, and do so, or the sequence ends.
const IMPROVEMENT: f64 = 1e-7;
/// Tolerance of the limits between steps; the last law is solved to rounding.
const STEP_TOLERANCE: f64 = 0.25 * ENLARGED;
/// Linearisations tried for the last law.
const HELD_ROUNDS: usize = 6;
/// Linearisations of a step about its own end before it is shortened instead.
const CORRECTIONS: usize = 5;
/// A corrected step that gains less than this part of the predicted gain is compared with shorter steps.
const WORTH_MENDING: f64 = 0.5;
/// Steps are shortened to no less than this.
const SHORTEST: f64 = 1e-4;

/// Sequence of convex programs from the best feasible point that the `starts` lead to, until no step improves the
/// objective or the law is good `enough`. Starts keep the convex limits, except those on the size. Where the size is among the variables of the
/// program, the size in `limits` is ignored.
///
/// Returns the last solution with its size, the steps taken and why no more were, or `None` where no
/// feasible start was found.
pub fn refine(
    program: &Program,
    starts: &[Solution],
    limits: NonconvexLimits,
    enough: impl Fn(&Solution) -> bool,
) -> Option<(Solution, Vec<Step>, Ended)> {
    // Between steps limits need not hold better than the next step will change them.
    let mut program = program.clone();
    program.settings.tolerance = STEP_TOLERANCE;
    let program = &program;
    let at_size = AtSize::new(limits, program);
    let start = starts
        .iter()
        .filter_map(|start| start::feasible(program, start, &at_size))
        .min_by(|a, b| program.merit(a).total_cmp(&program.merit(b)))
        .or_else(|| {
            let last = starts.last()?;
            if sizes::keep(program, &last.extra) {
                start::tightened(program, last, &at_size)
            } else {
                shrunk(program, last, &at_size)
            }
        })?;
    let (mut current, steps, ended) = descended(program, start, &at_size, enough);
    // A start without steps needs no last program if it keeps the convex limits to rounding.
    let as_it_came = steps.is_empty() && current.violation <= TOLERANCE;
    let exact =
        || held(program, &current, &at_size).or_else(|| resolved(program, &current, &at_size));
    if let Some(exact) = (!as_it_came).then(exact).flatten() {
        let active = current.active;
        current = Solution {
            active,
            iterations: current.iterations + exact.iterations,
            ..exact
        };
    }
    Some((current, steps, ended))
}

/// Steps from a feasible start until none improves the objective or the law is good `enough`.
fn descended(
    program: &Program,
    start: Solution,
    at_size: &AtSize,
    enough: impl Fn(&Solution) -> bool,
) -> (Solution, Vec<Step>, Ended) {
    let (mut current, mut steps, mut reach) = (start, Vec::new(), f64::INFINITY);
    for _ in 0..MOST_STEPS {
        if enough(&current) {
            break;
        }
        match step(program, &current, at_size, &mut reach) {
            Outcome::Taken(next, one) => {
                let gain = program.merit(&current) - one.merit;
                let small = gain <= IMPROVEMENT * program.merit(&current).abs();
                current = next;
                steps.push(one);
                if small {
                    return (current, steps, Ended::SmallGain);
                }
            }
            Outcome::Failed(_) if reach_shrinks(program, reach) => (),
            Outcome::Failed(why) | Outcome::Finished(why) => return (current, steps, why),
        }
    }
    (current, steps, Ended::MostSteps)
}

/// Outcome of a step.
enum Outcome {
    /// It was taken: the solution after it.
    Taken(Solution, Step),
    /// It failed; a shorter one may succeed.
    Failed(Ended),
    /// No further step is worth it, or there is no time for one.
    Finished(Ended),
}

/// One step: the optimum under the limits linearised about the last law, corrected or shortened until they hold.
///
/// `reach` is the trust region: the largest relative reduction of the size in one step, because an objective of the
/// size alone goes as far as the linear rows allow.
fn step(program: &Program, current: &Solution, at_size: &AtSize, reach: &mut f64) -> Outcome {
    if program.halt.is_asked() {
        return Outcome::Finished(Ended::OutOfTime);
    }
    let near = within_reach(program, current, *reach);
    let mut next = near.clone();
    next.fixed = linearised(program, current, at_size, &Room::above(0.0));
    next.seeds = contacts(program, current);
    let Some(target) = solved(&next) else {
        *reach = 0.5 * reach.min(1.0);
        return Outcome::Failed(Ended::NoSolution);
    };
    let merit = program.merit(current);
    let gained = |trial: &Solution| merit - program.merit(trial);
    if gained(&target) <= IMPROVEMENT * merit.abs() {
        return Outcome::Finished(Ended::SmallGain);
    }
    let whole = corrected(&near, &target, at_size).filter(|(trial, _)| gained(trial) > 0.0);
    // If the correction costs most of the predicted gain, a shorter step may gain more.
    let enough = WORTH_MENDING * gained(&target);
    let good = (whole.as_ref()).is_some_and(|(trial, _)| gained(trial) >= enough);
    let (accepted, taken) = if good {
        *reach *= 2.0;
        (whole, 1.0)
    } else {
        let radius = |s: &Solution| at_size.of(s).size().prime_radius();
        let shrinks = 1.0 - radius(&target) / radius(current);
        // NaN without a size: then the reach stays as it is.
        *reach = 0.5 * shrinks.min(*reach).max(0.0);
        let least = whole.as_ref().map_or(0.0, |(trial, _)| gained(trial));
        match shortened(program, current, &target, at_size, least) {
            Some((trial, room, part)) => (Some((trial, room)), part),
            None => (whole, 1.0),
        }
    };
    let Some((mut trial, clearance)) = accepted else {
        return Outcome::Failed(Ended::NoImprovement);
    };
    trial.iterations += current.iterations;
    trial.rounds += current.rounds;
    let own = |row: &Row| row.limit.is_none_or(|limit| limit < program.limits.len());
    trial.active.retain(own);
    let one = Step {
        prime_radius: at_size.of(&trial).size().prime_radius(),
        merit: program.merit(&trial),
        clearance,
        taken,
    };
    Outcome::Taken(trial, one)
}

/// A step's end with its clearance, linearised about itself until what is not convex holds there: Newton's method on
/// the contacts, where the rows of the step's start would have it cut short. `None` where it does not come to that.
fn corrected(program: &Program, target: &Solution, at_size: &AtSize) -> Option<(Solution, f64)> {
    let mut end = target.clone();
    let (mut kept, mut before) = (Room::above(0.0), f64::NEG_INFINITY);
    for round in 0..=CORRECTIONS {
        let each = at_size.clear(program, &end);
        let clear = least_of(&each);
        if clear >= ROOM {
            return Some((end, clear));
        }
        if round == CORRECTIONS || clear < 2.0 * before.min(-NEARLY) {
            return None;
        }
        if clear < 0.25 * before {
            kept.widen(&each);
        }
        before = clear;
        let mut next = program.clone();
        next.fixed = linearised(program, &end, at_size, &kept);
        next.seeds = contacts(program, &end);
        let solved = solved(&next)?;
        end = Solution {
            iterations: end.iterations + solved.iterations,
            rounds: end.rounds + solved.rounds,
            ..solved
        };
    }
    None
}

/// The longest part of a step, by halves, that keeps every limit and gains more than `least`; its clearance and the part.
fn shortened(
    program: &Program,
    current: &Solution,
    target: &Solution,
    at_size: &AtSize,
    least: f64,
) -> Option<(Solution, f64, f64)> {
    let mut part = 1.0;
    while part >= SHORTEST {
        let mut trial = blend(current, target, part, program);
        (trial.iterations, trial.rounds) = (target.iterations, target.rounds);
        let room = least_of(&at_size.clear(program, &trial));
        if room >= ROOM && program.merit(current) - program.merit(&trial) > least {
            return Some((trial, room, part));
        }
        part *= 0.5;
    }
    None
}

/// Whether a shorter reach makes another step: a size is priced, and there is something left of the reach.
fn reach_shrinks(program: &Program, reach: f64) -> bool {
    reach > SHORTEST && SIZES.iter().any(|&k| program.cost[k] != 0.0)
}

/// A start by shrinking a cam that is larger than allowed: on the way to the smallest one, until it is small enough.
fn shrunk(program: &Program, large: &Solution, at_size: &AtSize) -> Option<Solution> {
    let smallest = of_least_size(program, &large.extra);
    let convex = solved(&smallest);
    let start = (convex.iter().chain([large]))
        .find_map(|from| start::feasible(&smallest, from, at_size))
        .or_else(|| start::tightened(&smallest, large, at_size))?;
    let small = |s: &Solution| sizes::keep(program, &s.extra);
    let (mut found, ..) = descended(&smallest, start, at_size, small);
    found.active.clear();
    found.extra[PEAK] = program.own_peak(&found.x, &found.extra);
    small(&found).then_some(found)
}

/// The program of the smallest cam that keeps the limits, those on its size left out where these sizes exceed them.
pub fn of_least_size(program: &Program, large: &Values) -> Program {
    let mut smooth = Quadratic::zero(&program.basis);
    smooth.add_energy(&program.basis, 3, smoothing(program.length, program.length));
    let smallest = program.clone().minimising(smooth);
    sizes::priced(&smallest, large, 1.0)
}

/// The program with the sizes that it prices held above the present ones less this part.
fn within_reach(program: &Program, current: &Solution, part: f64) -> Program {
    let mut out = program.clone();
    if part.is_finite() {
        for k in SIZES.into_iter().filter(|&k| program.cost[k] > 0.0) {
            let least = (1.0 - part) * current.extra[k];
            let mut limit = structural(LimitKind::PrimeRadius, [0.0; 5], -least, program.length);
            limit.extra[k] = -1.0;
            limit.domain = (0.0, 0.0);
            out.limits.push(limit);
        }
    }
    out
}

/// A solution that keeps the nonconvex limits too, from a solution of the program; `None` on failure.
pub fn feasible(program: &Program, start: &Solution, limits: NonconvexLimits) -> Option<Solution> {
    let mut program = program.clone();
    program.settings.tolerance = STEP_TOLERANCE;
    let program = &program;
    let at_size = AtSize::new(limits, program);
    start::feasible(program, start, &at_size).or_else(|| start::tightened(program, start, &at_size))
}

/// The optimum about the last law whose limits hold to rounding, where none of its size does.
fn resolved(program: &Program, current: &Solution, at_size: &AtSize) -> Option<Solution> {
    let mut exact = program.clone();
    exact.settings.tolerance = TOLERANCE;
    let mut next = exact.clone();
    next.fixed = linearised(program, current, at_size, &Room::above(0.0));
    next.seeds = contacts(program, current);
    let (found, _) = corrected(&exact, &solved(&next)?, at_size)?;
    (found.violation < current.violation).then_some(found)
}

/// The law nearest to the last one whose limits hold to rounding, at a slightly larger size.
fn held(program: &Program, current: &Solution, at_size: &AtSize) -> Option<Solution> {
    // A given size stays as it is.
    let free = at_size.free();
    let at_size = at_size.held();
    let size = at_size.of(current).size();
    let room = if free[RISE] || (free[RADIUS] && size.radius > 0.0) {
        ENLARGED
    } else {
        0.0
    };
    let mut near = program.clone();
    let mut about = current.clone();
    if near.hessian.largest_diagonal() == 0.0 {
        // A peak has no distance of its own, and rises by what the law moves.
        let mut distance = Quadratic::zero(&program.basis);
        for order in [0, 2] {
            distance.add_energy(&program.basis, order, program.length.powi(-2));
        }
        near = near.minimising(distance);
        let of_peak = |row: &Row| row.extra[PEAK] != 0.0;
        about.active.retain(|row| !of_peak(row));
    }
    // Nearest to the law at hand, so that the linearised curvature stays true.
    let pulled = near.hessian.times(&current.x[..near.basis.columns()]);
    near.gradient = pulled.iter().map(|g| -g).collect();
    let sized = about.clone();
    about.extra[RISE] *= 1.0 + room;
    about.extra[RADIUS] *= 1.0 + room;
    let mut kept = Room::above(0.0);
    for _ in 0..HELD_ROUNDS {
        let mut last = near.clone();
        last.fixed = linearised(program, &about, &at_size, &kept);
        let mut exact = solved(&sizes::held(&last, &sized, room))?;
        exact.extra = about.extra;
        let clear = at_size.clear(program, &exact);
        if least_of(&clear) >= 0.0 {
            exact.extra = current.extra;
            exact.extra[PEAK] = program.own_peak(&exact.x, &exact.extra);
            exact.violation = program.violation(&exact.x, &exact.extra);
            return (exact.violation < current.violation).then_some(exact);
        }
        kept.widen(&clear);
        about = exact;
    }
    None
}

//! Steps from one feasible law to a better feasible law.

use super::at_size::AtSize;
use super::linearised::{NEARLY, Room, contacts, least_of, linearised};
use super::trial::{ROOM, blend, solved};
use crate::cam::LimitKind;
use crate::synth::qp::{Program, Row, SIZES, Solution, structural};
use crate::synth::report::method::Ended;
use crate::synth::report::solver::Step;

/// Maximum number of steps of a sequence.
const MOST_STEPS: usize = 40;
/// Relative improvement of the objective, predicted or actual, below which the sequence ends.
const IMPROVEMENT: f64 = 1e-7;
/// Maximum number of second-order corrections before a step is shortened.
const CORRECTIONS: usize = 5;
/// Fraction of the predicted gain. If the gain of a corrected step is below this fraction, shorter steps are tried too, for comparison.
const WORTH_MENDING: f64 = 0.5;
/// Minimum fraction of a step, and minimum trust region.
pub const SHORTEST: f64 = 1e-4;

/// Steps from a feasible start until the objective no longer improves, or until `enough` returns `true` for the law. Returns the last
/// solution, the steps, and the reason for the end.
pub fn descended(
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

/// Outcome of a step of a sequence of convex programs.
pub enum Outcome {
    /// The step was accepted. Contains the new solution and the record of the step.
    Taken(Solution, Step),
    /// The step failed. A shorter step may succeed.
    Failed(Ended),
    /// No further step is worthwhile, or the time limit is reached.
    Finished(Ended),
}

/// One step: the optimum with the limits linearised about the last law. The step is corrected or shortened until the limits hold.
///
/// `reach` is the trust region: the maximum relative reduction of the size in one step. The trust region is necessary if the objective is the
/// size alone, because the optimum then lies where the linearised limits are active.
pub fn step(program: &Program, current: &Solution, at_size: &AtSize, reach: &mut f64) -> Outcome {
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
        // Without a size, `shrinks` is NaN, and the infinite reach remains infinite.
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

/// Second-order correction of a step: the limits are linearised again at its end until the non-convex limits hold. Returns the corrected end and
/// its clearance h/w; `None` if this fails.
pub fn corrected(
    program: &Program,
    target: &Solution,
    at_size: &AtSize,
) -> Option<(Solution, f64)> {
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

/// Largest fraction of a step, found by halving, for which every limit holds and the gain exceeds `least`. Returns the solution, its clearance
/// h/w and the fraction.
pub fn shortened(
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

/// Whether a smaller trust region can give another step. This requires that a size has a cost, and that the region is not too small.
pub fn reach_shrinks(program: &Program, reach: f64) -> bool {
    reach > SHORTEST && SIZES.iter().any(|&k| program.cost[k] != 0.0)
}

/// Program with lower bounds on the sizes that have a cost. A size can decrease by at most the fraction `part`.
pub fn within_reach(program: &Program, current: &Solution, part: f64) -> Program {
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

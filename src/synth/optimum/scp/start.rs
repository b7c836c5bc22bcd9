//! Feasible start of a sequence of convex programs.

use super::at_size::AtSize;
use super::linearised::{Room, contacts, least_of, linearised, restricted};
use super::steps::descended;
use super::trial::{ROOM, blend, solved};
use crate::cam::LimitKind;
use crate::synth::limits::Profile;
use crate::synth::qp::{PEAK, Program, Quadratic, SIZES, Solution, Values, sizes, smoothing};

/// Maximum number of steps of the continuation, which tightens relaxed limits gradually.
const TIGHTENINGS: usize = 40;
const LINEARISATIONS: usize = 8;
const SMALLEST_SHARE: f64 = 2e-3;
/// Maximum number of programs with the restriction or with linearised limits.
const RESTRICTIONS: usize = 20;
const PATIENCE: usize = 4;
/// Weight of the distance between laws in the objective, as a multiple of the cost of a minimised peak.
const HEAVY: f64 = 1e3;
/// Fractions of a step that are tried if the complete step is too long.
const PARTS: [f64; 4] = [1.0, 0.7, 0.4, 0.15];

/// Best feasible point that is reached from the `starts`. The starts satisfy the convex limits, except limits on the size. `None` if no feasible
/// point is found.
pub fn best(program: &Program, starts: &[Solution], at_size: &AtSize) -> Option<Solution> {
    let each = starts.iter();
    let each = each.filter_map(|start| feasible(program, start, at_size));
    let best = each.min_by(|a, b| program.merit(a).total_cmp(&program.merit(b)));
    best.or_else(|| {
        let last = starts.last()?;
        if sizes::keep(program, &last.extra) {
            tightened(program, last, at_size)
        } else {
            shrunk(program, last, at_size)
        }
    })
}

/// The start itself if it is feasible. Otherwise, two steps are repeated until the limits are satisfied. First, the sufficient restriction
/// is set up about the last law. Then, the optimum with this restriction is computed. For followers on an arm there is no such restriction,
/// and the linearised limits are used instead. `None` if there is no progress.
pub fn feasible(program: &Program, start: &Solution, at_size: &AtSize) -> Option<Solution> {
    let mut current = start.clone();
    let (mut room, mut nearest, mut since) = (Room::above(0.0), f64::NEG_INFINITY, 0);
    for _ in 0..RESTRICTIONS {
        let clear = at_size.clear(program, &current);
        if least_of(&clear) >= ROOM
            && program.violation(&current.x, &current.extra) <= program.settings.tolerance
            && sizes::keep(program, &current.extra)
        {
            return Some(current);
        }
        since = if least_of(&clear) > nearest {
            0
        } else {
            since + 1
        };
        if since > PATIENCE {
            return None;
        }
        nearest = nearest.max(least_of(&clear));
        room.widen(&clear);
        let mut next = program.clone();
        next.fixed = match at_size.of(&current).profile {
            Some(Profile::Roller(size)) => {
                // The sufficient restriction replaces only the curvature limit. Load limits remain linearised.
                let mut rows = linearised(program, &current, at_size, &room);
                rows.retain(|r| r.name != LimitKind::Curvature);
                rows.extend(restricted(program, &current, size));
                rows
            }
            _ => linearised(program, &current, at_size, &room),
        };
        next.seeds = contacts(program, &current);
        let solved = solved(&next)?;
        current = Solution {
            iterations: current.iterations + solved.iterations,
            ..solved
        };
    }
    None
}

/// Feasible start by continuation. The non-convex limits and the limits on the size are first relaxed by the violation of the given law. They
/// are then tightened in steps to their values. Each step computes the law nearest to the previous law. Minimising the objective instead could
/// leave the region in which the linearisation is valid.
pub fn tightened(program: &Program, start: &Solution, at_size: &AtSize) -> Option<Solution> {
    let first = least_of(&at_size.clear(program, start)).min(ROOM);
    let asked = sizes::within(program, &start.extra);
    let mut current = Solution {
        active: Vec::new(),
        ..start.clone()
    };
    let (mut reached, mut step, mut again) = (0.0_f64, 1.0_f64, false);
    for _ in 0..TIGHTENINGS {
        if program.halt.is_asked() {
            return None;
        }
        let share = (reached + step).min(1.0);
        let level = first + share * (ROOM - first);
        for k in SIZES {
            current.extra[k] = start.extra[k] + share * (asked[k] - start.extra[k]);
        }
        match kept_at(program, &current, level, at_size) {
            Some(found) if share >= 1.0 => {
                return Some(Solution {
                    violation: program.violation(&found.x, &found.extra),
                    active: Vec::new(),
                    ..found
                });
            }
            Some(found) => {
                (current, reached) = (found, share);
                // A fraction that failed is tried again after two successful ones.
                step *= if again { 2.0 } else { 0.5 };
                again = true;
            }
            None => {
                (step, again) = (0.5 * (share - reached), false);
                if step < SMALLEST_SHARE {
                    return None;
                }
            }
        }
    }
    None
}

/// Law that satisfies h ≥ level · w and is nearest to the law `before`, with the same size. It is computed by repeated linearisation.
fn kept_at(program: &Program, before: &Solution, level: f64, at_size: &AtSize) -> Option<Solution> {
    let mut near = nearest_to(program, before);
    let at_size = at_size.held();
    let mut trial = before.clone();
    let (mut room, mut nearest) = (Room::above(level - ROOM), f64::NEG_INFINITY);
    for _ in 0..LINEARISATIONS {
        near.fixed = linearised(program, &trial, &at_size, &room);
        near.seeds = contacts(&near, &trial);
        let mut target = solved(&near)?;
        for k in SIZES {
            target.extra[k] = before.extra[k];
        }
        // If the whole step overshoots, the fraction with the largest clearance is used.
        let part = |part: f64| {
            let some = blend(&trial, &target, part, &near);
            (at_size.clear(program, &some), some)
        };
        let parts = PARTS.iter().map(|&p| part(p));
        let (each, some) = parts.max_by(|a, b| least_of(&a.0).total_cmp(&least_of(&b.0)))?;
        let clear = least_of(&each);
        trial = some;
        if clear >= level {
            return Some(trial);
        }
        if clear <= nearest {
            return None;
        }
        nearest = clear;
        room.widen(&each);
    }
    None
}

/// Program for the law nearest to the law `before` in the mean square of the acceleration, with the same size.
fn nearest_to(program: &Program, before: &Solution) -> Program {
    let mut near = program.clone();
    near.limits.retain(|l| !l.is_on_variables_alone());
    let mut near = sizes::held(&near, before, 0.0);
    near.settings.tolerance = program.settings.tolerance;
    // The peak is a variable without a cost in this program.
    let peak = (program.cost[PEAK] * before.extra[PEAK]).abs();
    let weight = if peak > 0.0 { HEAVY * peak } else { 1.0 };
    let mut distance = Quadratic::zero(&program.basis);
    distance.add_energy(&program.basis, 2, weight / program.length.powi(2));
    let pulled = distance.hessian.times(&before.x[..program.basis.columns()]);
    distance.gradient = pulled.iter().map(|g| -g).collect();
    (near.hessian, near.gradient) = (distance.hessian, distance.gradient);
    near.constant = 0.0;
    near
}

/// Feasible start from a cam that is too large. Its size is reduced until the limits on the size are satisfied.
pub fn shrunk(program: &Program, large: &Solution, at_size: &AtSize) -> Option<Solution> {
    let smallest = of_least_size(program, &large.extra);
    let convex = solved(&smallest);
    let start = (convex.iter().chain([large]))
        .find_map(|from| feasible(&smallest, from, at_size))
        .or_else(|| tightened(&smallest, large, at_size))?;
    let small = |s: &Solution| sizes::keep(program, &s.extra);
    let (mut found, ..) = descended(&smallest, start, at_size, small);
    found.active.clear();
    found.extra[PEAK] = program.own_peak(&found.x, &found.extra);
    small(&found).then_some(found)
}

/// Program for the smallest feasible cam. Limits on the size are relaxed to the sizes `large`.
pub fn of_least_size(program: &Program, large: &Values) -> Program {
    let mut smooth = Quadratic::zero(&program.basis);
    smooth.add_energy(&program.basis, 3, smoothing(program.length, program.length));
    let smallest = program.clone().minimising(smooth);
    sizes::priced(&smallest, large, 1.0)
}

//! Where a sequence of convex programs begins: a law that keeps what is not convex.

use super::{NEARLY, ROOM, SHORTEST, blend, contacts, each_place, linearised, row, solved};
use crate::cam::LimitKind;
use crate::synth::limits::{NonconvexLimits, Profile, ProfileSize, clearance};
use crate::synth::qp::{EXTRAS, Program, RISE, Row, Solution};

/// Steps of a smallest radius that grows, and linearisations for each.
const CLIMBS: usize = 40;
const CLIMB_ROUNDS: usize = 8;
/// Parts of a step that are looked at.
const PARTS: [f64; 4] = [1.0, 0.7, 0.4, 0.15];
/// Halvings that find the radius a law keeps.
const HALVINGS: usize = 24;

/// The start itself where it holds; otherwise the optimum under the sufficient restriction, tightened
/// about its own X a few times. Followers on an arm have no such restriction: there the linearised limits
/// are solved until they hold.
pub fn feasible(
    program: &Program,
    start: &Solution,
    sized: &impl Fn(&[f64; EXTRAS]) -> NonconvexLimits,
) -> Option<Solution> {
    let mut current = start.clone();
    let mut room = 2.0 * ROOM;
    for _ in 0..20 {
        let here = sized(&current.extra);
        let clear = clearance(&program.basis.law(&current.x), &here);
        if clear >= ROOM {
            return Some(current);
        }
        // Low points that wander between two programs need a little more room than they take.
        if clear > -NEARLY {
            room = room.max(-2.0 * clear);
        }
        let mut next = program.clone();
        next.fixed = match here.profile {
            Some(Profile::Roller(size)) => {
                // What is sufficient for the curvature says nothing of the loads.
                let mut rows = linearised(program, &current, &here, &program.present(), room);
                rows.retain(|r| r.name != LimitKind::Curvature);
                rows.extend(restricted(program, &current, size));
                rows
            }
            _ => linearised(program, &current, &here, &program.present(), room),
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

/// A start by growing the smallest radius from what the law without it keeps to what is asked, each time
/// from the law before.
pub fn climbed(
    program: &Program,
    start: &Solution,
    sized: &impl Fn(&[f64; EXTRAS]) -> NonconvexLimits,
) -> Option<Solution> {
    let present = program.present();
    let asked = sized(&start.extra).profile?.rho();
    let holds = |s: &Solution, rho: f64| {
        let limits = sized(&s.extra).with_rho(rho);
        clearance(&program.basis.law(&s.x), &limits) >= ROOM
    };
    let (mut reached, mut missed) = (0.0, asked);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (reached + missed);
        if holds(start, middle) {
            reached = middle;
        } else {
            missed = middle;
        }
    }
    if reached == 0.0 {
        return None;
    }
    let mut current = start.clone();
    let mut step = asked - reached;
    for _ in 0..CLIMBS {
        let goal = (reached + step).min(asked);
        let mut trial = current.clone();
        let mut there = false;
        let mut kept = 2.0 * ROOM;
        for _ in 0..CLIMB_ROUNDS {
            let limits = sized(&trial.extra).with_rho(goal);
            let mut next = program.clone();
            next.fixed = linearised(program, &trial, &limits, &present, kept);
            next.seeds = contacts(program, &trial);
            let Some(solved) = solved(&next) else {
                break;
            };
            // Where the whole step overshoots, the part of it that comes nearest.
            let clear = |part: f64| {
                let some = blend(&trial, &solved, part, program);
                let limits = sized(&some.extra).with_rho(goal);
                (clearance(&program.basis.law(&some.x), &limits), some)
            };
            let nearest = PARTS
                .iter()
                .map(|&part| clear(part))
                .max_by(|a, b| a.0.total_cmp(&b.0));
            let Some((room, some)) = nearest else { break };
            trial = some;
            there = room >= ROOM;
            // Low points wander between two programs.
            if room > -NEARLY {
                kept = kept.max(-2.0 * room);
            }
            if there {
                break;
            }
        }
        if there && goal >= asked {
            return Some(trial);
        }
        if there {
            (current, reached) = (trial, goal);
            step *= 1.5;
        } else {
            step *= 0.5;
            if step < SHORTEST * asked {
                return None;
            }
        }
    }
    None
}

/// Rows of a + (2X₀/ρ − 1)X − X₀²/ρ ≥ 0 all around, X₀ no smaller than the 4ρ/3 that makes it sufficient.
fn restricted(program: &Program, current: &Solution, size: ProfileSize) -> Vec<Row> {
    let present = program.present();
    let law = program.basis.law(&current.x);
    let sufficient = 4.0 / 3.0 * size.rho;
    let mut out = Vec::new();
    each_place(program, |place| {
        let at = law.svaj_on(place.piece, place.u);
        let x0 = (size.rise + at.s).max(sufficient);
        let by_x = 2.0 * x0 / size.rho - 1.0;
        let mut bound = -x0 * x0 / size.rho;
        let mut extra = [0.0; EXTRAS];
        if present[RISE] {
            extra[RISE] = -by_x;
        } else {
            bound += by_x * size.rise;
        }
        out.push(row(program, place, &[-by_x, 0.0, -1.0], extra, bound, x0));
        if present[RISE] {
            let mut high_enough = [0.0; EXTRAS];
            high_enough[RISE] = -1.0;
            out.push(row(program, place, &[-1.0], high_enough, -sufficient, x0));
        }
    });
    out
}

//! Whole steps of a sequence of convex programs, mended where they break what is not convex.

use super::{NEARLY, ROOM, Room, contacts, least, linearised, solved};
use crate::synth::limits::{NonconvexLimits, clearances};
use crate::synth::qp::{EXTRAS, Program, Solution};

/// Linearisations of a step about its own end before it is shortened instead.
const CORRECTIONS: usize = 5;

/// A step's end with its clearance, linearised about itself until what is not convex holds there: Newton's method on
/// the contacts, where the rows of the step's start would have it cut short. `None` where it does not come to that.
pub fn corrected(
    program: &Program,
    target: &Solution,
    sized: &impl Fn(&[f64; EXTRAS]) -> NonconvexLimits,
) -> Option<(Solution, f64)> {
    let present = program.present();
    let mut end = target.clone();
    let (mut kept, mut before) = (Room::above(0.0), f64::NEG_INFINITY);
    for round in 0..=CORRECTIONS {
        let here = sized(&end.extra);
        let each = clearances(&program.basis.law(&end.x), &here);
        let clear = least(&each);
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
        next.fixed = linearised(program, &end, &here, &present, &kept);
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

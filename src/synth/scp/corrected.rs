//! Second-order correction: full steps of the sequence, relinearised where they violate a nonconvex limit.

use super::at_size::AtSize;
use super::linearised::{NEARLY, Room, contacts, least_of, linearised};
use super::trial::{ROOM, solved};
use crate::synth::qp::{Program, Solution};

/// Linearisations of a step about its own end before it is shortened instead.
const CORRECTIONS: usize = 5;

/// A step's end with its clearance, linearised about itself until what is not convex holds there: Newton's method on
/// the contacts, where the rows of the step's start would have it cut short. `None` where it does not come to that.
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

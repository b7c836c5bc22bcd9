//! Final law of a sequence of convex programs, which satisfies the limits up to rounding errors.

use super::at_size::AtSize;
use super::linearised::{Room, contacts, least_of, linearised};
use super::steps::corrected;
use super::trial::solved;
use crate::synth::limits::ENLARGED;
use crate::synth::qp::{PEAK, Program, Quadratic, RADIUS, RISE, Row, Solution, TOLERANCE, sizes};

/// Maximum number of linearisations in the computation of the nearest law.
const HELD_ROUNDS: usize = 6;

/// Optimum of the program that is linearised about the last law. It satisfies the limits up to rounding errors. `None` if its violation is
/// not smaller than the violation of the last law.
pub fn resolved(program: &Program, current: &Solution, at_size: &AtSize) -> Option<Solution> {
    let mut exact = program.clone();
    exact.settings.tolerance = TOLERANCE;
    let mut next = exact.clone();
    next.fixed = linearised(program, current, at_size, &Room::above(0.0));
    next.seeds = contacts(program, current);
    let (found, _) = corrected(&exact, &solved(&next)?, at_size)?;
    (found.violation < current.violation).then_some(found)
}

/// Law that satisfies the limits up to rounding errors and is nearest to the last law. If the size is a variable, the cam is slightly
/// enlarged for this law. `None` if no such law was found.
pub fn held(program: &Program, current: &Solution, at_size: &AtSize) -> Option<Solution> {
    // A given size remains unchanged.
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
        // With a peak as objective, the program has no quadratic term, so a quadratic distance between laws is added. The rows of the peak
        // are removed, because the nearest law may have a larger peak.
        let mut distance = Quadratic::zero(&program.basis);
        for order in [0, 2] {
            distance.add_energy(&program.basis, order, program.length.powi(-2));
        }
        near = near.minimising(distance);
        let of_peak = |row: &Row| row.extra[PEAK] != 0.0;
        about.active.retain(|row| !of_peak(row));
    }
    // The distance from the present law is minimised, so that the linearised curvature remains accurate.
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

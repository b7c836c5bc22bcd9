//! Trial solutions of a sequence of convex programs.

use crate::synth::qp::{Program, Solution, apply};

/// Relative violation of a limit above which a result does not count as a solution.
const BROKEN: f64 = 1e-4;
/// Relative clearance h/w of the non-convex limits with which the check of the finished cam passes. h is the value of a limit and w its
/// scale (see `Slack`).
pub const ROOM: f64 = 1e-9;

/// Solution of a program; `None` without a solution or if a limit is violated.
pub fn solved(program: &Program) -> Option<Solution> {
    program.solve().ok().filter(|s| s.violation <= BROKEN)
}

/// Point between two solutions, at the fraction `part` of the way. Convex limits that hold at both solutions also hold there.
pub fn blend(from: &Solution, to: &Solution, part: f64, program: &Program) -> Solution {
    let mix = |a: f64, b: f64| a + part * (b - a);
    let x: Vec<f64> = from.x.iter().zip(&to.x).map(|(a, b)| mix(*a, *b)).collect();
    let mut extra = from.extra;
    for (k, value) in to.extra.iter() {
        extra[k] = mix(extra[k], value);
    }
    for cone in &program.cones {
        extra[cone.head] = cone.norm(&extra);
    }
    debug_assert!(
        program
            .equalities
            .iter()
            .all(|e| (apply(&e.entries, &x) - e.value).abs() < 1e-6 * program.length)
    );
    let violation = program.violation(&x, &extra);
    Solution {
        x,
        extra,
        violation,
        active: to.active.clone(),
        used_rows: true,
        ..*from
    }
}

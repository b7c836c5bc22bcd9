//! Trial solutions of a sequence of convex programs.

use crate::synth::qp::{Program, Solution, apply};

/// What the exchange of rows leaves further outside a limit than this is no solution.
const BROKEN: f64 = 1e-4;
/// Room kept in h, relative to w, so that the finished cam passes its own check.
pub const ROOM: f64 = 1e-9;

/// The solution of a program, where there is one.
pub fn solved(program: &Program) -> Option<Solution> {
    program.solve().ok().filter(|s| s.violation <= BROKEN)
}

/// A point on the way from one solution to another; convex limits that hold at both ends hold there.
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

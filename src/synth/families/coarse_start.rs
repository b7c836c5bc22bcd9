//! Where a sequence of convex programs over many spans begins: with the law of a few.

use super::spline;
use crate::problem::Problem;
use crate::synth::qp::{Program, Quadratic, Solution, apply, solve_equalities};

/// Fewer spans than this are solved as they are.
const MANY: usize = 120;
/// Coarser laws than this are no good start.
const FEWEST: usize = 24;
/// A demand missed by no more than this part of the typical lift is kept.
const KEPT: f64 = 1e-9;

/// The law of a part of the spans, whose knots are among the many, as one over all of them. Its sequence has been
/// carried out where a program costs little; what the other knots add is left to do.
pub fn found(problem: &Problem, program: &Program, spans: usize) -> Option<Solution> {
    if spans < MANY || !problem.law.dwells.is_empty() {
        return None;
    }
    let coarse = (2..=spans / FEWEST).find(|d| spans.is_multiple_of(*d) && spans / d < MANY)?;
    let touched = spline::on_spans(problem, spans / coarse)?;
    let law = touched.law();
    let mut distance = Quadratic::zero(&program.basis);
    distance.add_distance(
        &program.basis,
        &[1.0],
        problem.degree() + 1,
        |start, width, places, out| {
            for (value, &(u, _)) in out.iter_mut().zip(places) {
                *value = law.svaj(start + u * width).s;
            }
        },
        None,
    );
    let fit = Program::new(program.basis.clone(), distance, Vec::new(), program.length);
    let x = solve_equalities(&fit).ok()?.x;
    let missed = |(value, wanted): (f64, f64)| (value - wanted).abs() > KEPT * program.length;
    let values = program.equalities.iter();
    if values.map(|e| (apply(&e.entries, &x), e.value)).any(missed) {
        return None;
    }
    Some(Solution {
        violation: program.violation(&x, &touched.solution.extra),
        x,
        active: Vec::new(),
        ..touched.solution
    })
}

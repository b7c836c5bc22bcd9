//! The interior-point method with cost in proportion to the spans.
//!
//! Slacks and multipliers of all rows are driven to the central path together (Mehrotra's predictor and corrector);
//! what is factorised in every iteration is H + Σ (zᵢ/sᵢ) aᵢaᵢᵀ. Of many spans it is a chain of windows (`chain`); of few
//! spans, where only the programs between the steps of a sequence are solved here, the band of the lift's coefficients.
//! The objective counts from the optimum without limits, so that the gap is a part of what the limits cost.
//!
//! What has no such band, and what the method does not settle, is left to the caller.

mod chain;
mod cone;
mod demands;
mod dense;
mod held;
mod scaled;
mod steps;
mod system;

pub use held::{fall, on_contacts};

use super::basis::Basis;
use super::clarabel::Point;
use super::program::{Failure, Program, Row};
use super::settings::TOLERANCE;
use scaled::{Base, Scaled};
use std::collections::HashMap;
use std::sync::Arc;
use system::Midway;

/// More demands than this are no small dense system.
const MOST_DEMANDS: usize = 160;

/// Why there is no point.
pub enum Left {
    /// Proved: nothing keeps all rows.
    Failed(Failure),
    /// Not a program for this method, or one that it does not settle.
    Open,
}

/// What a solution leaves to the next one with other rows.
#[derive(Default)]
pub struct Trail {
    base: Option<Arc<Base>>,
    midway: Option<Midway>,
    /// Push of each row at that point.
    pushes: HashMap<Named, f64>,
}

/// A row by limit, place and bound.
type Named = (Option<usize>, u64, u64);

fn named(row: &Row) -> Named {
    (row.limit, row.peak.at.to_bits(), row.bound.to_bits())
}

/// Solves with the rows given; multipliers are written back into them. `margin` (relative to each limit's scale) is
/// kept free inside every limit.
pub fn solve(
    program: &Program,
    rows: &mut [Row],
    margin: f64,
    trail: &mut Trail,
) -> Result<Point, Left> {
    let far = rows.iter().any(|r| !r.touching.is_empty());
    if far || rows.is_empty() || program.equalities.len() > MOST_DEMANDS {
        return Err(Left::Open);
    }
    match &program.lifted {
        Some(lifted) if rows.iter().all(|r| lifted.carries(&r.weights)) => answered(
            program,
            rows,
            Scaled::of_many_spans(program, lifted, rows, margin, &mut trail.base),
            trail,
        ),
        None if is_between_steps(program) => {
            let scaled = Scaled::of_few_spans(program, rows, margin);
            answered(program, rows, scaled, trail)
        }
        _ => Err(Left::Open),
    }
}

/// Whether a spline's program is one of a sequence, but not its last.
fn is_between_steps(program: &Program) -> bool {
    let spline = matches!(program.basis, Basis::Spline { .. });
    spline && !program.fixed.is_empty() && program.settings.tolerance > TOLERANCE
}

fn answered(
    program: &Program,
    rows: &mut [Row],
    scaled: Option<Scaled>,
    trail: &mut Trail,
) -> Result<Point, Left> {
    let scaled = scaled.ok_or(Left::Open)?;
    let settings = &program.settings.interior_point;
    let names: Vec<Named> = scaled.rows().map(|index| named(&rows[index])).collect();
    let from = trail.midway.take().map(|midway| Midway {
        z: names.iter().map(|n| trail.pushes.get(n).copied()).collect(),
        ..midway
    });
    let asked = program.settings.tolerance;
    let mut found = steps::solve(&scaled.system, settings, asked, &program.halt, from)?;
    let mut inside = None;
    if let Some(midway) = found.midway.take() {
        inside = Some(scaled.law(program, &midway.u));
        let pushes = names.into_iter().zip(&midway.z);
        trail.pushes = pushes.filter_map(|(n, z)| Some((n, (*z)?))).collect();
        trail.midway = Some(midway);
    }
    Ok(Point {
        inside,
        ..scaled.point(program, rows, found)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::criterion::Criterion;
    use crate::poly::{Peak, SplineSpace};
    use crate::synth::qp::clarabel;
    use crate::synth::qp::objective::{Quadratic, pointwise};
    use crate::synth::qp::program::{Limit, OFFSET, RADIUS, RISE};
    use std::f64::consts::TAU;

    fn place(piece: usize) -> Peak {
        Peak {
            piece,
            u: 0.5,
            at: 0.0,
            value: 0.0,
        }
    }

    /// The smallest ‖(D, e)‖ with D ≥ 2v − s at the middle of every piece and e ≥ 0.3, weighed against a distance.
    fn of_a_sequence() -> (Program, Vec<Row>) {
        let basis = Basis::Spline {
            space: SplineSpace::periodic_uniform(5, 36, TAU),
            closed: true,
        };
        let mut distance = Quadratic::zero(&basis);
        distance.add_distance(&basis, &[2.0, -0.3, 1.0], 7, pointwise(f64::cos), None);
        let mut program = Program::new(basis, distance, Vec::new(), 1.0);
        let mut limit = Limit::new(Criterion::Peak, [-1.0, 2.0, 0.0, 0.0, 0.0], 0.0, 1.0);
        limit.extra[RISE] = -1.0;
        program.limits.push(limit);
        program.cost[RADIUS] = 0.5;
        program.cone = true;
        program.settings.tolerance = 1e-6;
        let mut offset = program.row(0, place(0));
        offset.limit = None;
        offset.weights = [0.0; 5];
        offset.entries.clear();
        offset.extra = [0.0; 6];
        offset.extra[OFFSET] = -1.0;
        offset.bound = -0.3;
        program.fixed.push(offset.clone());
        let mut rows: Vec<Row> = (0..36).map(|piece| program.row(0, place(piece))).collect();
        rows.push(offset);
        (program, rows)
    }

    #[test]
    fn a_program_between_two_steps_has_the_optimum_that_another_method_finds() {
        let (program, mut rows) = of_a_sequence();
        let own = solve(&program, &mut rows, 0.0, &mut Trail::default())
            .ok()
            .unwrap();
        let pushes: Vec<f64> = rows.iter().map(|r| r.multiplier).collect();
        let other = clarabel::solve(&program, &mut rows, 0.0).unwrap();
        let value = |p: &Point| program.objective(&p.x) + 0.5 * p.extra[RADIUS];
        assert!((value(&own) - value(&other)).abs() < 1e-8);
        // Coefficients and multipliers differ by no more than the root of what the values may.
        for (a, b) in own.x.iter().zip(&other.x) {
            assert!((a - b).abs() < 1e-4, "{a} {b}");
        }
        for (push, row) in pushes.iter().zip(&rows) {
            assert!((push - row.multiplier).abs() < 1e-4);
        }
        let [radius, rise, offset] = [RADIUS, RISE, OFFSET].map(|k| own.extra[k]);
        assert!((radius - rise.hypot(offset)).abs() < 1e-7 && (offset - 0.3).abs() < 1e-7);
    }

    #[test]
    fn the_last_program_of_a_sequence_is_left_to_the_other_method() {
        let (mut program, mut rows) = of_a_sequence();
        program.settings.tolerance = TOLERANCE;
        assert!(matches!(
            solve(&program, &mut rows, 0.0, &mut Trail::default()),
            Err(Left::Open)
        ));
    }
}

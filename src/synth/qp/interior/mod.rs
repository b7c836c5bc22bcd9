//! The interior-point method on the program's own band.
//!
//! Slacks and multipliers of all rows are driven to the central path together (Mehrotra's predictor and corrector);
//! what is factorised in every iteration is H + Σ (zᵢ/sᵢ) aᵢaᵢᵀ, which is as banded as H: cost in proportion to the spans.
//! The objective counts from the optimum without limits, so that the gap is a part of what the limits cost. In the
//! coefficients of a lift of many spans the matrix has a condition of N⁴ and more (theory §9): they are solved in numbers
//! of twice the digits. Few spans are left to the caller.
//!
//! What has no such band, and what the method does not settle, is left to the caller.

mod cone;
mod demands;
mod scaled;
mod steps;

use super::clarabel::Point;
use super::double::{Double, Number};
use super::program::{Failure, Program, Row};
use scaled::Scaled;

/// More demands than this are no small dense system.
const MOST_DEMANDS: usize = 160;

/// Why there is no point.
pub enum Left {
    /// Proved: nothing keeps all rows.
    Failed(Failure),
    /// Not a program for this method, or one that it does not settle.
    Open,
}

/// Solves with the rows given; multipliers are written back into them. `margin` (relative to each limit's scale) is
/// kept free inside every limit.
pub fn solve(program: &Program, rows: &mut [Row], margin: f64) -> Result<Point, Left> {
    let far = rows.iter().any(|r| !r.touching.is_empty());
    if far || rows.is_empty() || program.equalities.len() > MOST_DEMANDS {
        return Err(Left::Open);
    }
    match &program.lifted {
        Some(lifted) if rows.iter().all(|r| lifted.carries(&r.weights)) => answered(
            program,
            rows,
            Scaled::<Double>::of_many_spans(program, lifted, rows, margin),
        ),
        _ => Err(Left::Open),
    }
}

fn answered<T: Number>(
    program: &Program,
    rows: &mut [Row],
    scaled: Option<Scaled<T>>,
) -> Result<Point, Left> {
    let scaled = scaled.ok_or(Left::Open)?;
    let settings = &program.settings.interior_point;
    let found = steps::solve(&scaled.system, settings, &program.halt)?;
    Ok(scaled.point(program, rows, found))
}

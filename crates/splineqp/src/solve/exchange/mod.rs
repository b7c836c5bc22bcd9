//! Exchange of rows: solves the program with finitely many rows, and adds rows at the exact points of maximum violation. The exchange ends
//! when no limit is exceeded at any angle.

pub mod clarabel;

use crate::Names;
use crate::basis::row_unit;
use crate::equality;
use crate::poly::Peak;
use crate::program::{Failure, PEAK, Program, Row, Solution, Stop, Values};
use crate::solve::refine;
use crate::solve::row_solver::{Point, RowSolver};
use clarabel::InteriorPoint;

/// Optimum by the interior-point method with exchange of rows, starting from the seeds of the program. Nearly equal seeds may prevent
/// convergence. The method then starts again without seeds.
///
/// # Errors
///
/// - The limits are infeasible.
/// - The solver stops without a result.
pub fn solve<N: Names>(program: &Program<N>) -> Result<Solution<N>, Failure<N>> {
    if program.seeds.is_empty() {
        return without_seeds(program);
    }
    let contacts = program.seeds.iter().filter(|r| r.limit.is_some());
    // A limit on further variables alone is one row. It is added here because the exchange adds rows only at points of the law.
    let mut own = Vec::new();
    program.seed_rows(&mut own);
    own.retain(|r| r.entries.iter().all(|e| e.1 == 0.0));
    let rows = program.fixed.iter().chain(contacts).cloned().chain(own);
    match from_rows(program, rows.collect(), &mut InteriorPoint::default()) {
        Err(Failure::Numerical { stop }) if stop != Stop::OutOfTime => without_seeds(program),
        found => found,
    }
}

/// Starts without seeds. The first rows are at the points of maximum violation of the unlimited optimum. With further variables, the first
/// rows are at the ends and middles of pieces.
fn without_seeds<N: Names>(program: &Program<N>) -> Result<Solution<N>, Failure<N>> {
    let rows = if program.free_variables().is_empty() {
        let x = program.with_least_at_zero(equality::solve(program)?.x);
        if let Some(solution) = program.without_rows(&x) {
            return Ok(solution);
        }
        first_rows(program, &x)
    } else {
        let mut rows = program.fixed.clone();
        program.seed_rows(&mut rows);
        rows
    };
    from_rows(program, rows, &mut InteriorPoint::default())
}

/// Permanent rows, and rows at and near the points of maximum violation of the unlimited optimum.
pub fn first_rows<N: Names>(program: &Program<N>, x: &[f64]) -> Vec<Row<N>> {
    let mut rows = program.fixed.clone();
    add_rows(program, &mut rows, program.broken(x, &Values::NONE));
    program.add_neighbours(&mut rows, x);
    rows
}

/// Iterates from the given rows, with `solver` for each program with finitely many rows.
pub fn from_rows<N: Names>(
    program: &Program<N>,
    mut rows: Vec<Row<N>>,
    solver: &mut impl RowSolver<N>,
) -> Result<Solution<N>, Failure<N>> {
    let settings = &program.settings.exchange;
    // A second refinement would fail at the same active points.
    let mut is_refinable = program.rms.is_empty() && refine::is_wanted(program);
    let mut best: Option<Solution<N>> = None;
    // Margin inside every limit for the residual of the solver. It is increased only if necessary. With a cone there is no refinement, so
    // the margin is used from the start.
    let mut margin = if !program.cones.is_empty() || !program.rms.is_empty() {
        settings.cone_margin
    } else {
        0.0
    };
    let mut keeps_room = true;
    for round in 1..=settings.rounds {
        if program.halt.is_asked() {
            return best.ok_or(Stop::OutOfTime.into());
        }
        let point = match (solver.solve(program, &mut rows, margin), &best) {
            (Ok(point), _) => point,
            // With the margin there is no solution. The rows without a margin may have one.
            (Err(_), Some(_)) if margin > 0.0 => {
                (margin, keeps_room) = (0.0, false);
                continue;
            }
            (Err(_), Some(best)) if !keeps_room && best.violation < settings.largest_margin => {
                break;
            }
            (Err(failure), _) => return Err(failure),
        };
        let Point {
            x,
            mut extra,
            tangents,
            iterations,
        } = point;
        // If a law exceeds its minimised peak by less than a gap that needs no refinement, the actual peak replaces the minimised one.
        let peak = program.own_peak(&x, &extra);
        if peak - extra[PEAK] <= program.settings.refinement.gap * peak {
            extra[PEAK] = peak;
        }
        let broken = program.broken(&x, &extra);
        let violation = program.violation(&x, &extra);
        let all = rows.iter().chain(&tangents);
        let active = all.filter(|r| is_active(program, r, &x, &extra));
        let solution = Solution {
            active: active.cloned().collect(),
            x,
            extra,
            used_rows: true,
            iterations,
            rounds: round,
            violation,
        };
        let rows_hold = program.excess_of_rows(&solution.x, &extra) <= program.settings.tolerance;
        if broken.is_empty() && rows_hold {
            return Ok(solution);
        }
        if is_refinable && violation < program.settings.refinement.from {
            is_refinable = false;
            if let Some(refined) = refine::on_contacts(program, &solution) {
                return Ok(refined);
            }
        }
        let least = best.as_ref().map_or(f64::INFINITY, |b| b.violation);
        let is_small = violation < settings.largest_margin;
        if keeps_room && is_small && violation > settings.stalled * least {
            let wider = settings.margin_growth * violation.max(margin);
            margin = wider.min(settings.largest_margin);
        }
        if violation < least {
            best = Some(solution);
        }
        add_rows(program, &mut rows, broken);
    }
    best.ok_or(Stop::NoProgress.into())
}

/// Adds rows at the violated points. Earlier rows are kept, because two rows on either side of an active point converge to this point as in
/// the secant method. Only a coinciding row is replaced.
fn add_rows<N: Names>(program: &Program<N>, rows: &mut Vec<Row<N>>, broken: Vec<(usize, Peak)>) {
    let coincident = program.settings.exchange.coincident;
    for (limit, peak) in broken {
        let row = program.row(limit, peak);
        rows.retain(|r| !r.coincides(&row, coincident));
        rows.push(row);
    }
}

/// Whether a row is active. The multiplier of an active row is larger than its slack, in the scaled units of the solver.
fn is_active<N: Names>(program: &Program<N>, row: &Row<N>, x: &[f64], extra: &Values) -> bool {
    let unit = row_unit(&row.entries, program.length);
    let multiplier = row.multiplier * unit / program.multiplier_unit(extra[PEAK]);
    multiplier > (row.slack(x, extra) / unit).max(0.0)
}

//! Optimum for the coefficients alone, by the dual active-set method. It starts at the optimum without limits. The rows are evaluated at
//! the exact points of maximum violation.
//!
//! Each iteration starts from the last solution and adds rows at the points of maximum violation. The objective only increases, so no
//! active set is repeated. When all active points are nearly exact, Newton's method improves all of them together (`refine`).

pub mod dual;
pub mod proximal;

use crate::Names;
use crate::band::ArrowFactor;
use crate::equality::Unlimited;
use crate::poly::Peak;
use crate::program::{Failure, Program, Row, Solution, Stop, Values};
use crate::settings::ActiveSetSettings;
use crate::solve::refine;
use crate::solve::row_solver::{Point, RowSolver};
use dual::{Dual, DualFailure, Plane};

/// Solves a program for the coefficients alone, starting from its optimum without limits.
///
/// If the maximum number of steps is reached or there is no progress, the error contains the rows so far. The interior-point method then
/// continues with these rows and determines feasibility.
pub fn solve<N: Names>(
    program: &Program<N>,
    unlimited: &Unlimited,
) -> Result<Solution<N>, Vec<Row<N>>> {
    let settings = &program.settings.active_set;
    let level = unlimited.pin.map_or(0.0, |(at, _)| unlimited.x[at]);
    let mut set = ActiveSet::new(program, unlimited, &unlimited.factor, level);
    let mut rows: Vec<Row<N>> = Vec::new();
    rows.extend(program.fixed.iter().chain(&program.seeds).cloned());
    let none = Values::NONE;
    if program.seeds.is_empty() {
        program.add_neighbours(&mut rows, &set.dual.x);
        let broken = program.broken(&set.dual.x, &none);
        add_rows(program, &mut rows, broken, &mut set);
    }
    if rows.len() > settings.rows {
        return Err(rows);
    }
    let mut best: Option<Solution<N>> = None;
    let (mut since_best, mut refinements) = (0, 0);
    for round in 1..=settings.rounds {
        if program.halt.is_asked() {
            break;
        }
        let Ok(Point { x, iterations, .. }) = set.solve(program, &mut rows, 0.0) else {
            return best
                .filter(|b| b.violation < settings.resolved_at_last)
                .ok_or(rows);
        };
        let refinement = &program.settings.refinement;
        let peaks = program.peaks_near(&x, &none, refinement.below);
        let broken = program.broken_among(&peaks, &x, &none);
        let candidate = Solution {
            violation: program.worst(&peaks, &x, &none),
            x,
            extra: none,
            active: set.active(&rows),
            used_rows: true,
            iterations,
            rounds: round,
        };
        if candidate.violation <= program.settings.tolerance {
            return Ok(candidate);
        }
        if candidate.violation < refinement.from && refinements < settings.refinements {
            refinements += 1;
            let refined = refine::on_band(program, unlimited, &candidate, peaks, set.pinned_at);
            if let Some(refined) = refined {
                return Ok(refined);
            }
        }
        let progress = settings.progress;
        if (best.as_ref()).is_none_or(|b| candidate.violation < progress * b.violation) {
            best = Some(candidate);
            since_best = 0;
        } else {
            since_best += 1;
            // The remaining violation is a rounding error, and more rows do not reduce it.
            let fine = |b: &Solution<N>| b.violation < settings.resolved_at_last;
            if since_best >= settings.patience && best.as_ref().is_some_and(fine) {
                return best.ok_or(rows);
            }
        }
        add_rows(program, &mut rows, broken, &mut set);
    }
    Err(rows)
}

fn add_rows<N: Names>(
    program: &Program<N>,
    rows: &mut Vec<Row<N>>,
    broken: Vec<(usize, Peak)>,
    set: &mut ActiveSet,
) {
    let coincident = program.settings.active_set.coincident;
    for (limit, peak) in broken {
        let row = program.row(limit, peak);
        match rows.iter().position(|r| r.coincides(&row, coincident)) {
            Some(at) => {
                RowSolver::<N>::replaced(set, at);
                rows[at] = row;
            }
            None => rows.push(row),
        }
    }
}

/// Active set of a program. If the level of the law is free, it is fixed by an additional quadratic term.
pub struct ActiveSet<'a> {
    settings: ActiveSetSettings,
    pub dual: Dual<'a>,
    pin: Option<(usize, f64)>,
    pinned_at: f64,
}

impl<'a> ActiveSet<'a> {
    /// Creates the active set with the equalities alone, for a factor of H. A free level is fixed at `level`.
    pub fn new<N: Names>(
        program: &Program<N>,
        unlimited: &Unlimited,
        factor: &'a ArrowFactor,
        level: f64,
    ) -> Self {
        let settings = program.settings.active_set;
        let most_steps = settings.steps_per_unknown * unlimited.x.len();
        let (pull, x) = (unlimited.pull.clone(), unlimited.x.clone());
        let mut set = ActiveSet {
            settings,
            dual: Dual::new(factor, pull, x, settings.dependent, most_steps),
            pin: unlimited.pin,
            pinned_at: 0.0,
        };
        set.move_pin(level);
        for e in &program.equalities {
            set.dual.hold(None, &e.entries, e.value, 0.0);
        }
        set
    }

    /// Iterates until no row is violated and, if the level is free, the level no longer changes.
    fn settle<N: Names>(
        &mut self,
        program: &Program<N>,
        rows: &[Row<N>],
        margin: f64,
    ) -> Result<(), DualFailure> {
        let planes: Vec<Plane> = (rows.iter())
            .map(|row| {
                let size = row.limit.map_or(row.scale, |i| program.limits[i].scale);
                let (entries, bound) = (&row.entries, row.bound - margin * row.scale);
                let unit = size.max(bound.abs());
                Plane {
                    entries,
                    bound,
                    unit,
                }
            })
            .collect();
        let ActiveSetSettings {
            resolved, active, ..
        } = self.settings;
        for _ in 0..self.settings.pin_moves {
            (self.dual).settle(&planes, resolved, active, &program.halt)?;
            let Some((at, _)) = self.pin else {
                return Ok(());
            };
            let level = self.dual.x[at];
            if (level - self.pinned_at).abs() <= self.settings.pin_settled * program.length {
                return Ok(());
            }
            self.move_pin(level);
            self.dual.retreat();
        }
        Ok(())
    }

    fn move_pin(&mut self, to: f64) {
        if let Some((at, weight)) = self.pin {
            let mut change = vec![0.0; self.dual.x.len()];
            change[at] = weight * (to - self.pinned_at);
            self.dual.add_pull(change);
            self.pinned_at = to;
        }
    }

    /// Rows with positive multipliers.
    pub fn active<N: Names>(&self, rows: &[Row<N>]) -> Vec<Row<N>> {
        let positive = self.dual.multipliers().filter(|m| m.1 > 0.0);
        let rows = positive.map(|(i, multiplier)| Row {
            multiplier,
            ..rows[i].clone()
        });
        rows.collect()
    }
}

impl<N: Names> RowSolver<N> for ActiveSet<'_> {
    /// Continues with the active rows of the last solution. The working set is unchanged on failure.
    fn solve(
        &mut self,
        program: &Program<N>,
        rows: &mut [Row<N>],
        margin: f64,
    ) -> Result<Point<N>, Failure<N>> {
        (self.settle(program, rows, margin)).map_err(|_| Stop::NoProgress)?;
        rows.iter_mut().for_each(|row| row.multiplier = 0.0);
        for (row, multiplier) in self.dual.multipliers() {
            rows[row].multiplier = multiplier;
        }
        Ok(Point {
            x: self.dual.x.clone(),
            extra: Values::NONE,
            tangents: Vec::new(),
            iterations: self.dual.steps,
        })
    }

    fn replaced(&mut self, row: usize) {
        self.dual.forget(row);
    }
}

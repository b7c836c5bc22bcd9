//! Exchange of rows: solve with the rows at hand, find the exact worst points of the law, bring them in,
//! solve again, until no limit is broken on the whole turn.

use super::basis::apply;
use super::certificate::certificate;
use super::program::{EXTRAS, FACE_END, Failure, LOWEST, Meaning, Program, Row, Solution, Stop};
use super::settings::TOLERANCE;
use super::{active_set, clarabel, equality};
use crate::poly::Peak;

/// A relative gap that needs no better digits …
const GAP: f64 = 1e-7;
/// … and a stationarity, which often ends at 10⁻⁷ where the gap is closed. A law is certified with both below 10⁻⁶.
const STATIONARITY: f64 = 3e-7;

impl Program {
    /// The optimum without limits, then with as many rows as they need.
    ///
    /// A program over the coefficients alone goes to the active-set method; sizes, peaks and cones, and what
    /// the active set cannot settle, go to the interior-point method.
    pub fn solve(&self) -> Result<Solution, Failure> {
        Ok(self.proved(self.solve_as_it_comes()?))
    }

    /// A solution whose proof is open, brought to its last digits by Newton's method on the contacts. Between the
    /// steps of a sequence nobody asks for them.
    fn proved(&self, solution: Solution) -> Solution {
        if !solution.used_rows || self.settings.tolerance > TOLERANCE {
            return solution;
        }
        let before = self.doubt(&solution);
        if before <= 1.0 {
            return solution;
        }
        match super::contacts::proved(self, &solution) {
            Some(settled) if self.doubt(&settled) < before => settled,
            _ => solution,
        }
    }

    /// What the proof leaves open, and what is outside the limits; more than 1 asks for better digits.
    fn doubt(&self, solution: &Solution) -> f64 {
        let proof = certificate(self, solution);
        let excess = (solution.violation - self.settings.tolerance).max(0.0);
        (proof.relative_gap / GAP).max(proof.stationarity / STATIONARITY) + excess / GAP
    }

    fn solve_as_it_comes(&self) -> Result<Solution, Failure> {
        // A range of values whose place is free is two more unknowns: only where it is too wide.
        if let Some(free) = self.without_windows() {
            let mut solution = free.solve()?;
            let windows = self.windows(&solution.x);
            for k in [LOWEST, FACE_END] {
                solution.extra[k] = windows[k];
            }
            if self.broken(&solution.x, &solution.extra).is_empty() {
                return Ok(solution);
            }
        }
        if self.present().iter().any(|p| *p) {
            return self.solve_by_interior_point();
        }
        let mut unlimited = equality::solve(self)?;
        if unlimited.pin.is_some() {
            unlimited.x = self.with_lowest_at_zero(unlimited.x);
        }
        if let Some(solution) = self.without_rows(&unlimited.x) {
            return Ok(solution);
        }
        match active_set::solve(self, &unlimited) {
            // Two crests that share a row can end a hair above a limit: once more with that hair kept free.
            Ok(solution) if solution.violation > self.settings.tolerance => {
                let tighter = self.with_room(2.0 * solution.violation);
                let again = active_set::solve(&tighter, &unlimited).ok();
                Ok(again
                    .map(|s| Solution {
                        violation: self.violation(&s.x, &s.extra),
                        ..s
                    })
                    .filter(|s| s.violation < solution.violation)
                    .unwrap_or(solution))
            }
            Ok(solution) => Ok(solution),
            Err(rows) => self.exchange(rows),
        }
    }

    /// The same program with this part of every limit's size kept free, where room can be kept.
    fn with_room(&self, part: f64) -> Program {
        let mut out = self.clone();
        for limit in &mut out.limits {
            if limit.meaning != Meaning::Structure && !limit.is_peak() {
                limit.bound -= part * limit.size(limit.bound);
            }
        }
        out
    }

    /// The same with an interior-point method on the rows of every round.
    pub fn solve_by_interior_point(&self) -> Result<Solution, Failure> {
        let mut rows: Vec<Row> = self.fixed.clone();
        if !self.seeds.is_empty() {
            rows.extend(self.seeds.iter().cloned());
            // A limit on a size alone is one row, which no place of the law calls in.
            let mut own = Vec::new();
            self.seed_rows(&mut own);
            rows.extend(
                own.into_iter()
                    .filter(|r| r.entries.iter().all(|e| e.1 == 0.0)),
            );
        } else if self.present().iter().any(|p| *p) {
            self.seed_rows(&mut rows);
        } else {
            let x = self.on_base_circle(equality::solve(self)?.x);
            if let Some(solution) = self.without_rows(&x) {
                return Ok(solution);
            }
            self.add_rows(&mut rows, self.broken(&x, &[0.0; EXTRAS]));
            self.add_neighbours(&mut rows, &x);
        }
        self.exchange(rows)
    }

    /// The optimum without limits as the answer, where it breaks none.
    fn without_rows(&self, x: &[f64]) -> Option<Solution> {
        let extra = [0.0; EXTRAS];
        let violation = self.violation(x, &extra);
        let kept = self.fixed.iter().all(|r| apply(&r.entries, x) <= r.bound)
            && violation <= self.settings.tolerance;
        kept.then(|| Solution {
            x: x.to_vec(),
            extra,
            active: Vec::new(),
            used_rows: false,
            iterations: 0,
            rounds: 0,
            violation,
        })
    }

    fn exchange(&self, rows: Vec<Row>) -> Result<Solution, Failure> {
        let solution = self.exchanged(rows)?;
        Ok(self.brought_inside(solution))
    }

    fn exchanged(&self, mut rows: Vec<Row>) -> Result<Solution, Failure> {
        let settings = &self.settings.exchange;
        let mut iterations = 0;
        let mut best: Option<Solution> = None;
        // Room left inside every limit for what the solver does not resolve; grows only when needed.
        // Cones are not polished, so there it is kept from the start.
        let mut margin = if self.cone { settings.cone_margin } else { 0.0 };
        for round in 1..=settings.rounds {
            if self.halt.is_asked() {
                return best.ok_or(Stop::OutOfTime.into());
            }
            let point = match (clarabel::solve(self, &mut rows, margin), &best) {
                (Ok(point), _) => point,
                // The room kept free is ours, not the user's: without it there is a solution.
                (Err(_), Some(_)) if margin > 0.0 => break,
                (Err(failure), _) => return Err(failure),
            };
            iterations += point.iterations;
            // Far from the end the next rows matter, not the last digits.
            let rough = self.violation(&point.x, &point.extra) > settings.polish_below;
            let (x, extra) = if rough {
                (point.x, point.extra)
            } else {
                super::polish::polish(self, &mut rows, &point)
            };
            let broken = self.broken(&x, &extra);
            let violation = self.violation(&x, &extra);
            let active = rows
                .iter()
                .filter(|r| r.multiplier > 0.0)
                .cloned()
                .collect();
            let solution = Solution {
                active,
                x: x.clone(),
                extra,
                used_rows: true,
                iterations,
                rounds: round,
                violation,
            };
            if violation < self.settings.contacts.from
                && let Some(settled) = super::contacts::settled(self, &solution)
            {
                return Ok(settled);
            }
            if broken.is_empty() {
                return Ok(solution);
            }
            let stalled = best.as_ref().is_some_and(|b| violation > 0.5 * b.violation);
            if best.as_ref().is_none_or(|b| violation < b.violation) {
                best = Some(solution);
            }
            if stalled && violation < settings.largest_margin {
                margin = (2.0 * violation)
                    .max(2.0 * margin)
                    .min(settings.largest_margin);
            }
            self.add_rows(&mut rows, broken);
        }
        best.ok_or(Stop::NoProgress.into())
    }

    /// Adds rows at the broken points. Earlier rows stay (two that straddle a contact close in on it like a
    /// secant); only one that all but coincides is replaced.
    fn add_rows(&self, rows: &mut Vec<Row>, broken: Vec<(usize, Peak)>) {
        let coincident = self.settings.exchange.coincident;
        for (limit, peak) in broken {
            let same = |r: &Row| {
                r.limit == Some(limit)
                    && r.peak.piece == peak.piece
                    && (r.peak.u - peak.u).abs() < coincident
            };
            rows.retain(|r| !same(r));
            rows.push(self.row(limit, peak));
        }
    }
}

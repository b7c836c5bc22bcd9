//! Exchange of rows: solve with the rows at hand, find the exact worst points of the law, bring them in,
//! solve again, until no limit is broken on the whole turn.

use super::basis::{Basis, apply};
use super::certificate::certificate;
use super::clarabel::Point;
use super::interior::{self, Left, Trail};
use super::lifted::Lifted;
use super::program::{
    EXTRAS, FACE_END, Failure, LOWEST, Limit, Meaning, Program, Row, Solution, Stop,
};
use super::settings::TOLERANCE;
use super::{active_set, equality, local_reduction};
use crate::poly::Peak;
use std::f64::consts::TAU;

/// Where rows are put beside a broken place, as parts of the way to the row before.
const BESIDE: [f64; 12] = [
    -0.7, -0.6, -0.5, -0.4, -0.3, -0.2, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7,
];

/// Spans from which on the coefficients of the lift alone are not tried.
const DOZENS: usize = 64;
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
        match self.by_the_lift_alone() {
            Some(solution) => Ok(solution),
            None => Ok(self.proved(self.solve_as_it_comes()?)),
        }
    }

    /// Of some dozens of spans the solution in the coefficients of the lift, which costs half, where its proof holds or
    /// nobody asks for one.
    fn by_the_lift_alone(&self) -> Option<Solution> {
        if self.lifted.is_none() || self.basis.columns() >= DOZENS {
            return None;
        }
        let plain = Program {
            lifted: None,
            ..self.clone()
        };
        let solution = plain.proved(plain.solve_as_it_comes().ok()?);
        let tolerance = self.settings.tolerance;
        let step = tolerance > TOLERANCE && solution.violation <= tolerance;
        (step || self.doubt(&solution) <= 1.0).then_some(solution)
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
        if self.lifted.is_some() {
            return self.solve_many_spans(&unlimited);
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

    /// Many spans: the active set while rows are few and its digits last, the interior-point method otherwise; of two
    /// laws that keep the limits the one with the better proof.
    fn solve_many_spans(&self, unlimited: &equality::Unlimited) -> Result<Solution, Failure> {
        let settings = &self.settings.active_set;
        let mut few = self.clone();
        few.settings.active_set.rows = settings.few_rows;
        few.settings.active_set.active = settings.few_active;
        let doubt = |s: &Solution| {
            let proof = certificate(self, s);
            proof.relative_gap.max(proof.stationarity)
        };
        let kept = |s: &Solution| s.violation <= self.settings.tolerance;
        let first = self
            .band_has_digits()
            .then(|| active_set::solve(&few, unlimited));
        let first = first.and_then(Result::ok).filter(kept);
        let first = first.map(|s| (doubt(&s), s));
        let first = first.map(|(gap, solution)| {
            if gap <= settings.proved {
                return (gap, solution);
            }
            // The contacts are right; the band has not the digits for the law on them.
            let exact = self.on_contacts(&solution);
            let exact = exact.map(|s| (doubt(&s), s)).filter(|e| e.0 < gap);
            exact.unwrap_or((gap, solution))
        });
        match first {
            Some((gap, solution)) if gap <= settings.proved => Ok(solution),
            None => self.solve_by_interior_point(),
            Some((gap, solution)) => match self.solve_by_interior_point() {
                Ok(second) if kept(&second) && doubt(&second) < gap => Ok(second),
                _ => Ok(solution),
            },
        }
    }

    /// A law of many spans brought onto its contacts.
    fn on_contacts(&self, solution: &Solution) -> Option<Solution> {
        let below = self.settings.local_reduction.below;
        let peaks = self.peaks_near(&solution.x, &solution.extra, below);
        local_reduction::refine(self, None, solution, peaks, 0.0)
    }

    /// Whether the condition of the lift's coefficients, (N/2π)²ᵏ for an objective on the kth derivative, leaves the active
    /// set enough to find the contacts.
    fn band_has_digits(&self) -> bool {
        let order = self.lifted.as_ref().map_or(0, Lifted::used);
        let condition = (self.basis.columns() as f64 / TAU).powi(2 * order as i32);
        condition * f64::EPSILON < self.settings.active_set.digits
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
            if self.lifted.is_some() {
                self.add_everywhere(&mut rows, &x);
            } else {
                self.add_rows(&mut rows, self.broken(&x, &[0.0; EXTRAS]));
                self.add_neighbours(&mut rows, &x);
            }
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
        let mut trail = Trail::default();
        // Room left inside every limit for what the solver does not resolve; grows only when needed.
        // Cones are not polished, so there it is kept from the start.
        let mut margin = if self.cone { settings.cone_margin } else { 0.0 };
        let most = if self.lifted.is_some() {
            settings.largest_lifted_margin
        } else {
            settings.largest_margin
        };
        for round in 1..=settings.rounds {
            if self.halt.is_asked() {
                return best.ok_or(Stop::OutOfTime.into());
            }
            let point = match (self.point(&mut rows, margin, &mut trail), &best) {
                (Ok(point), _) => point,
                // The room kept free is ours, not the user's: without it there is a solution.
                (Err(_), Some(_)) if margin > 0.0 => break,
                (Err(failure), _) => return Err(failure),
            };
            iterations += point.iterations;
            // Far from the end the next rows matter, not the last digits; many spans have them already, and would lose
            // them in the lift's coefficients.
            let rough = self.violation(&point.x, &point.extra) > settings.polish_below
                || self.lifted.is_some();
            let (x, extra) = if rough {
                (point.x, point.extra)
            } else {
                super::polish::polish(self, &mut rows, &point)
            };
            let broken = self.broken(&x, &extra);
            if self.lifted.is_some() && round == 1 {
                rows.retain(|r| self.is_near(r, &x, &extra));
            }
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
            if let (Some(inside), true) = (&point.inside, self.lifted.is_some())
                && let Some(drawn) = self.drawn_inside(&solution, inside, &broken)
                && self.doubt(&drawn) <= 1.0
            {
                return Ok(drawn);
            }
            let stalled = best.as_ref().is_some_and(|b| violation > 0.5 * b.violation);
            if best.as_ref().is_none_or(|b| violation < b.violation) {
                best = Some(solution);
            }
            if stalled && violation < most {
                margin = (2.0 * violation).max(2.0 * margin).min(most);
            }
            if self.lifted.is_some() {
                self.add_rows_beside(&mut rows, &broken, &x, &extra);
            }
            self.add_rows(&mut rows, broken);
        }
        best.ok_or(Stop::NoProgress.into())
    }

    /// Rows on both sides of each broken place: the contact lies between it and the row before, which stands where the
    /// limit's left side has fallen by the excess. Halfway there the next excess is a small part of this one.
    fn add_rows_beside(
        &self,
        rows: &mut Vec<Row>,
        broken: &[(usize, Peak)],
        x: &[f64],
        extra: &[f64; EXTRAS],
    ) {
        for &(index, peak) in broken {
            let limit = &self.limits[index];
            let falls = self.sharpness(limit, &peak, x);
            let excess = peak.value - self.room(limit, x, extra);
            if falls <= 0.0 || excess <= 0.0 {
                continue;
            }
            let reach = (2.0 * excess / falls).sqrt().min(self.width(peak.piece));
            for part in BESIDE {
                let at = peak.at + part * reach;
                if at > limit.domain.0 && at < limit.domain.1 {
                    rows.push(self.row(index, self.place(at)));
                }
            }
        }
    }

    /// −c″ of a limit's left side at a place; 0 where it is not known.
    fn sharpness(&self, limit: &Limit, peak: &Peak, x: &[f64]) -> f64 {
        let w = limit.weights;
        let known = matches!(self.basis, Basis::Spline { .. }) && w[4] == 0.0;
        if !known || limit.shape.is_some() {
            return 0.0;
        }
        let twice = [0.0, 0.0, w[0], w[1], w[2], w[3]];
        -apply(&self.basis.row_on(peak.piece, peak.u, &twice), x)
    }

    fn place(&self, at: f64) -> Peak {
        let (piece, u) = match &self.basis {
            Basis::Spline { space, .. } => space.locate(at),
            Basis::Harmonic { .. } => (0, 0.0),
        };
        Peak {
            piece,
            u,
            at,
            value: 0.0,
        }
    }

    /// The optimum under the rows at hand: by the interior-point method at home here, or where that leaves it open by
    /// Clarabel.
    fn point(&self, rows: &mut [Row], margin: f64, trail: &mut Trail) -> Result<Point, Failure> {
        match interior::solve(self, rows, margin, trail) {
            Ok(point) => Ok(point),
            Err(Left::Failed(failure)) => Err(failure),
            // Beside rows of a sequence a law of many spans is no question of whether there is one at all.
            Err(Left::Open) if self.lifted.is_some() && !self.fixed.is_empty() => {
                Err(Stop::NoProgress.into())
            }
            Err(Left::Open) => {
                let least = if self.lifted.is_some() {
                    self.settings.exchange.lifted_margin
                } else {
                    0.0
                };
                super::clarabel::solve(self, rows, margin.max(least))
            }
        }
    }

    /// Whether a row is worth keeping beside a law that all but keeps its limits. Rows on sizes alone are.
    fn is_near(&self, row: &Row, x: &[f64], extra: &[f64; EXTRAS]) -> bool {
        let Some(limit) = row.limit.map(|i| &self.limits[i]) else {
            return true;
        };
        let beside: f64 = (0..EXTRAS).map(|k| row.extra[k] * extra[k]).sum();
        let slack = row.bound - beside - apply(&row.entries, x);
        slack < self.settings.exchange.near * limit.size(limit.bound) || row.weights == [0.0; 5]
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

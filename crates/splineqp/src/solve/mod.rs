//! Choice of the method for a program.
//!
//! | method | used for | file |
//! |---|---|---|
//! | equality-constrained least squares | limits that the unconstrained optimum satisfies | `equality` |
//! | proximal steps of the dual active-set method | minimising a peak | `active_set/proximal` |
//! | dual active-set method | only coefficients, at most 1000 rows | `active_set` |
//! | interior-point method with exchange of rows | further variables or cones; failure of the active-set method | `exchange` |
//! | search for the weight of the mean square | root-mean-square limit; `exchange` with a peak and other further variables | `rms` |
//! | Newton's method for the active points | every solution whose certificate is not sufficient | `refine` |
//!
//! In each iteration, `active_set` and `exchange` solve a program with finitely many rows by a solver with the trait `RowSolver`.

mod active_set;
pub mod exchange;
mod refine;
mod rms;
mod row_solver;

use crate::Names;
use crate::basis::apply;
use crate::equality::{self, Unlimited};
use crate::program::{Failure, PEAK, Program, Solution, Stop, Values, Variable};
use crate::settings::TOLERANCE;
use active_set::proximal;
use exchange::clarabel::InteriorPoint;

impl<N: Names> Program<N> {
    /// Optimum with all limits at every angle.
    ///
    /// # Errors
    ///
    /// - The equalities contradict each other.
    /// - The limits are infeasible.
    /// - The solver stops without a result.
    pub fn solve(&self) -> Result<Solution<N>, Failure<N>> {
        let mut solution = match self.rms.first() {
            Some(_) if self.settings.tolerance > TOLERANCE => exchange::solve(self)?,
            Some(limit) => match self.with_its_cone() {
                Some(solution) => solution,
                None => rms::solve(self, limit)?,
            },
            None => self.solved()?,
        };
        let peak = self.own_peak(&solution.x, &solution.extra);
        if peak > solution.extra[PEAK] {
            solution.extra[PEAK] = peak;
            solution.violation = self.violation(&solution.x, &solution.extra);
        }
        Ok(solution)
    }

    /// Solves a program with a limit on a root mean square, a peak and other further variables as one cone program. `None` if the program
    /// has no such variables, or if the solution exceeds a limit.
    fn with_its_cone(&self) -> Option<Solution<N>> {
        let present = self.present();
        let is_least = |k: Variable| self.least_values().any(|least| least.0 == k);
        let mut sizes = present
            .iter()
            .filter(|(k, own)| *own && *k != PEAK && !is_least(*k));
        if !present[PEAK] || sizes.next().is_none() {
            return None;
        }
        let mut solution = exchange::solve(self).ok()?;
        // The margin of the rows is not part of the peak of the law.
        solution.extra[PEAK] = 0.0;
        solution.extra[PEAK] = self.own_peak(&solution.x, &solution.extra);
        solution.violation = self.violation(&solution.x, &solution.extra);
        (solution.violation <= self.settings.tolerance).then_some(solution)
    }

    fn solved(&self) -> Result<Solution<N>, Failure<N>> {
        // A range with free position adds an unknown. The program is first solved without the range. This solution is kept if it fits into
        // the range.
        if let Some(free) = self.without_windows() {
            let mut solution = refine::refined(&free, free.by_the_first_method()?);
            let windows = self.windows(&solution.x);
            for (k, _) in self.least_values() {
                solution.extra[k] = windows[k];
            }
            if self.broken(&solution.x, &solution.extra).is_empty() {
                return Ok(refine::refined(self, solution));
            }
        }
        Ok(refine::refined(self, self.by_the_first_method()?))
    }

    /// Solution by the first applicable method of the table above.
    fn by_the_first_method(&self) -> Result<Solution<N>, Failure<N>> {
        if proximal::suits(self) && self.hessian.largest_diagonal() == 0.0 {
            match proximal::solve(self)? {
                Some(solution) => return Ok(self.or_by_exchange(solution)),
                None if self.halt.is_asked() => return Err(Stop::OutOfTime.into()),
                None => (),
            }
        }
        if !self.free_variables().is_empty() {
            return exchange::solve(self);
        }
        let mut unlimited = equality::solve(self)?;
        unlimited.x = self.with_least_at_zero(unlimited.x);
        if let Some(solution) = self.without_rows(&unlimited.x) {
            return Ok(solution);
        }
        match active_set::solve(self, &unlimited) {
            Ok(solution) => {
                let solution = self.or_by_exchange(solution);
                Ok(self.inside(&unlimited, &solution).unwrap_or(solution))
            }
            Err(rows) => exchange::from_rows(self, rows, &mut InteriorPoint::default()),
        }
    }

    /// Solution of the active-set method, refined if it exceeds its limits. If the refined solution still exceeds its limits, the exchange
    /// method is tried as well. Its solution is used if it satisfies the limits or has a better certificate.
    fn or_by_exchange(&self, solution: Solution<N>) -> Solution<N> {
        if refine::keeps_limits(self, &solution) {
            return solution;
        }
        let solution = refine::refined(self, solution);
        if refine::keeps_limits(self, &solution) {
            return solution;
        }
        let other = exchange::solve(self).map(|other| refine::refined(self, other));
        match other {
            Ok(other)
                if refine::keeps_limits(self, &other)
                    || refine::openness(self, &other) < refine::openness(self, &solution) =>
            {
                other
            }
            _ => solution,
        }
    }

    /// Solves again with limits that are tightened by twice the violation, if this violation results from rounding errors. The duality gap
    /// includes the effect of this change. `None` if the solution already satisfies its limits, or if the new solution violates them.
    fn inside(&self, unlimited: &Unlimited, solution: &Solution<N>) -> Option<Solution<N>> {
        if solution.violation <= self.settings.tolerance || !refine::keeps_limits(self, solution) {
            return None;
        }
        let part = 2.0 * solution.violation;
        let mut narrow = self.clone();
        narrow.seeds.clear();
        for limit in &mut narrow.limits {
            limit.bound -= part * limit.size(limit.bound);
        }
        let mut inside = active_set::solve(&narrow, unlimited).ok()?;
        for row in &mut inside.active {
            let limit = row.limit.map(|i| &self.limits[i]);
            row.bound += limit.map_or(0.0, |limit| part * limit.size(limit.bound));
        }
        inside.violation = self.violation(&inside.x, &inside.extra);
        (inside.violation <= self.settings.tolerance).then_some(inside)
    }

    /// The optimum without limits as the solution, if it satisfies all limits.
    pub(crate) fn without_rows(&self, x: &[f64]) -> Option<Solution<N>> {
        let extra = Values::NONE;
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
}

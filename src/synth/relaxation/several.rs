//! Suggested changes of several limits, for designs for which no single change is sufficient.

use std::mem::discriminant;

use super::relaxable::Relaxable;
use super::{FAR, MACHINE_ROOMS, Relaxing, SMALL, Values, beside, changed, passes, passing};
use crate::halt::Halt;
use crate::synth::infeasible::reasons::changes;
use crate::synth::report::limited::Relaxation;
use crate::synth::report::reason::Reason;
use crate::synth::synthesis;

impl Relaxing<'_> {
    /// Reasons and values for common changes of several limits, if no single change is sufficient.
    pub fn several(&self, numbers: &Values, known: &[Reason]) -> (Vec<Reason>, Vec<Relaxation>) {
        if let Some(all) = self.together(numbers) {
            let changes = changes(&all, self.problem.cam.measures());
            return (vec![Reason::AllTogether { changes }], all);
        }
        let away = |&(number, from): &(Relaxable, f64)| (number, number.away(from, self.force));
        let free: Vec<(Relaxable, f64)> = numbers.iter().map(away).collect();
        match synthesis::design(&changed(self.problem, &free), self.search) {
            Ok(design) if !passes(&design) => {
                let mut reasons = vec![Reason::NotTheLimits];
                let is_known = |r: &Reason| known.iter().any(|k| tells_the_same(k, r));
                reasons.extend(design.reasons.into_iter().filter(|r| !is_known(r)));
                (reasons, Vec::new())
            }
            Ok(_) => self.with_those_out_of_reach(numbers, &free),
            Err(_) => (vec![Reason::NoRelaxation], Vec::new()),
        }
    }

    /// Values of several limits after the minimum common relative change that is sufficient; empty if no change is sufficient.
    pub fn several_limits(&self, limits: &Values) -> Vec<Relaxation> {
        if limits.len() < 2 || self.search.halt.is_asked() {
            return Vec::new();
        }
        self.together(limits).unwrap_or_default()
    }

    /// Suggested changes for limits that are infeasible even without the other limits. First, each of these limits is relaxed to a value at
    /// which it is feasible alone. If this is not sufficient, these limits, or all limits, are relaxed further by a common relative change.
    fn with_those_out_of_reach(
        &self,
        numbers: &Values,
        free: &Values,
    ) -> (Vec<Reason>, Vec<Relaxation>) {
        let alone = self.out_of_reach(numbers, free);
        if alone.is_empty() {
            return (vec![Reason::NoRelaxation], Vec::new());
        }
        // Limits that are feasible one by one may be infeasible together or with the other limits.
        let reached = changed(self.problem, &alone);
        let asked = changed(self.asked, &alone);
        let relaxing = Relaxing {
            problem: &reached,
            asked: &asked,
            ..*self
        };
        let moved = |&(number, from): &(Relaxable, f64)| {
            let value = alone.iter().find(|a| a.0 == number);
            (number, value.map_or(from, |a| a.1))
        };
        let all: Vec<(Relaxable, f64)> = numbers.iter().map(moved).collect();
        let both = relaxing.together(&alone);
        let eased = both.or_else(|| relaxing.together(&all));
        let helps = eased.is_some();
        let own =
            |&(number, to): &(Relaxable, f64)| Relaxation::of(number.criterion(), to, Some(to));
        let mut values = match eased {
            Some(values) => values,
            None => alone.iter().map(own).collect(),
        };
        for value in &mut values {
            let written = numbers.iter().find(|n| n.0.criterion() == value.limit);
            value.from = written.map_or(value.from, |n| n.1);
        }
        let changes = changes(&values, self.problem.cam.measures());
        if helps {
            (vec![Reason::FarTogether { changes }], values)
        } else {
            (vec![Reason::OutOfReach { changes }], Vec::new())
        }
    }

    /// Limits that are infeasible even without the other limits, with the values at which they become feasible. `free` contains a value for
    /// every limit at which the limit has no effect.
    fn out_of_reach(&self, numbers: &Values, free: &Values) -> Vec<(Relaxable, f64)> {
        let least = |&(number, from): &(Relaxable, f64), halt: &Halt| {
            let own = |&(other, far): &(Relaxable, f64)| {
                let value = if other == number { from } else { far };
                (other, value)
            };
            let values: Vec<(Relaxable, f64)> = free.iter().map(own).collect();
            let [alone, asked] = [self.problem, self.asked].map(|p| changed(p, &values));
            let search = self.search.ended_by(halt);
            if halt.is_asked() || passing(&alone, &search).is_some() {
                return None;
            }
            let relaxing = Relaxing {
                problem: &alone,
                asked: &asked,
                search: &search,
                ..*self
            };
            let least = relaxing.smallest(number, from, None)?;
            Some((number, relaxing.on_machine(number, least)?))
        };
        let tried = beside(numbers, &self.search.halt, least);
        tried.into_iter().flatten().collect()
    }

    /// Values of all limits after the minimum common relative change that is sufficient; `None` if no change is sufficient.
    fn together(&self, numbers: &Values) -> Option<Vec<Relaxation>> {
        let eased = |share: f64| -> Vec<(Relaxable, f64)> {
            let by =
                |&(k, from): &(Relaxable, f64)| (k, k.rounded(k.eased(from, share, self.force)));
            numbers.iter().map(by).collect()
        };
        let holds =
            |share: f64| passing(&changed(self.problem, &eased(share)), self.search).is_some();
        if !holds(FAR) {
            return None;
        }
        let share = if holds(SMALL) {
            SMALL
        } else {
            let found = self.bisected(
                FAR,
                SMALL,
                |works| 1e-2 * works,
                |share| holds(rounded(share)),
            );
            rounded(found)
        };
        let share = self.share_on_machine(share, eased)?;
        let all = (eased(share).into_iter().zip(numbers))
            .map(|((number, to), &(_, from))| Relaxation::of(number.criterion(), from, Some(to)));
        Some(all.collect())
    }

    /// The relative change, or a slightly larger change, with which the optimum passes in a machine with its own motion.
    fn share_on_machine(
        &self,
        share: f64,
        eased: impl Fn(f64) -> Vec<(Relaxable, f64)>,
    ) -> Option<f64> {
        let mut shares = MACHINE_ROOMS.map(|room| rounded(share + room)).into_iter();
        shares.find(|share| self.passes_as_asked(&eased(*share)))
    }
}

/// Whether two reasons differ only in their values.
fn tells_the_same(one: &Reason, other: &Reason) -> bool {
    match (one, other) {
        (Reason::LimitBroken { limit: one, .. }, Reason::LimitBroken { limit: other, .. }) => {
            one == other
        }
        (Reason::LimitInfeasible { .. } | Reason::LimitsInfeasible { .. }, _) => one == other,
        _ => discriminant(one) == discriminant(other),
    }
}

/// A relative change, rounded up to a multiple of 0.001.
fn rounded(share: f64) -> f64 {
    (1e3 * share - 1e-9).ceil() / 1e3
}

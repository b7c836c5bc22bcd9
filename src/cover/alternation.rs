//! Alternation between designing the cams and assigning the walkers.

use std::collections::HashMap;

use super::people::People;
use super::served::{Assigned, Under, one_walker};
use crate::error::Result;
use crate::scene::Robust;
use crate::synth::population::errors::{in_tail, measure};

/// Maximum number of alternations between design and assignment, for one start.
const TURNS: usize = 30;
/// Maximum number of consecutive alternations without improvement, while the shares of the worst walkers still change.
const IDLE: usize = 4;
/// Change of a cam's share of the worst walkers below which the share counts as constant.
const SETTLED: f64 = 1e-4;
/// Number of starts from distant walkers, in addition to the start from the result with one cam fewer.
const STARTS: usize = 3;

/// Assignment of the walkers to the cams at one alternation, with the resulting errors.
pub struct Trial {
    /// Index of the assigned cam of each walker.
    pub owner: Vec<usize>,
    /// Objective of the design of each cam.
    pub objectives: Vec<Robust>,
    /// Mean square error of each cycle under the assigned cam.
    pub squares: Vec<f64>,
    /// Number of infeasible cams, then the objective. Trials are compared in this order.
    pub value: (usize, f64),
}

/// Whether a cam satisfies its limits, and the mean square errors of all cycles with this cam.
pub type Column = (bool, Vec<f64>);
/// Cache of the results of cams. The key consists of the walkers of a cam and the objective of its design.
pub type Columns = HashMap<(Vec<usize>, String), Column>;

impl People<'_> {
    /// Best trial with `count` cams over all starts. `owner` is the assignment for one cam fewer, and `before` contains the errors with
    /// these cams.
    pub fn best_of(
        &self,
        count: usize,
        owner: &[usize],
        before: &[Assigned],
        columns: &mut Columns,
    ) -> Result<Trial> {
        let error = |w: &usize| {
            let each = self.cycles[*w]
                .iter()
                .map(|i| before[*i].error.measured(self.scene.law.error));
            each.fold(0.0, f64::max)
        };
        let split = filled(owner.to_vec(), count, &|w, _| error(&w));
        let badly = split.iter().position(|cam| *cam == count - 1);
        let badly = badly.unwrap_or_default();
        let mut best = self.alternated(split, count, columns)?;
        let starts = if self.points.is_empty() { 0 } else { STARTS };
        for start in 0..starts {
            let first = (badly + start * owner.len() / STARTS) % owner.len();
            let trial = self.alternated(self.far_apart(first, count), count, columns)?;
            if trial.value < best.value {
                best = trial;
            }
        }
        Ok(best)
    }

    /// Assigns every walker to the nearest of `count` walkers that are far apart from each other. `first` is the first of these walkers.
    fn far_apart(&self, first: usize, count: usize) -> Vec<usize> {
        let own = |w: usize| &self.points[self.cycles[w][0]];
        let distance = |a: usize, b: usize| {
            let off = own(a)
                .at
                .iter()
                .zip(&own(b).at)
                .map(|(x, y)| (x - y).powi(2));
            own(b).scale.powi(2) * off.sum::<f64>()
        };
        let mut owner = vec![0; self.cycles.len()];
        let mut nearest: Vec<f64> = (0..owner.len()).map(|w| distance(first, w)).collect();
        for cam in 1..count {
            let next = (0..owner.len()).max_by(|a, b| nearest[*a].total_cmp(&nearest[*b]));
            let next = next.unwrap_or(first);
            for w in 0..owner.len() {
                let own = distance(next, w);
                if own < nearest[w] || w == next {
                    (nearest[w], owner[w]) = (own, cam);
                }
            }
        }
        // If several walkers have equal forces, some cams may have no walker. `filled` assigns walkers to these cams.
        filled(owner, count, &|_, _| 0.0)
    }

    /// Alternates between designing the cams and assigning the walkers, from an initial assignment. Returns the best trial.
    pub fn alternated(
        &self,
        mut owner: Vec<usize>,
        count: usize,
        columns: &mut Columns,
    ) -> Result<Trial> {
        let mut best: Option<Trial> = None;
        let mut objectives = vec![self.scene.law.robust; count];
        let mut idle = 0;
        for _ in 0..TURNS {
            let mut of_cams: Vec<Column> = Vec::new();
            for (cam, objective) in objectives.iter().enumerate() {
                let group: Vec<usize> = (0..owner.len()).filter(|w| owner[*w] == cam).collect();
                let name = (group, objective.to_string());
                if !columns.contains_key(&name) {
                    let design = self.cam(&name.0, *objective)?;
                    let errors = Under::of(&self.problem, &design)?.squares;
                    columns.insert(name.clone(), (design.infeasible.is_none(), errors));
                }
                of_cams.push(columns[&name].clone());
            }
            let mut squares = vec![0.0; self.shares.len()];
            for (walker, cam) in owner.iter().enumerate() {
                self.cycles[walker]
                    .iter()
                    .for_each(|i| squares[*i] = of_cams[*cam].1[*i]);
            }
            let impossible = of_cams.iter().filter(|c| !c.0).count();
            let value = (
                impossible,
                measure(self.scene.law.robust, &squares, &self.shares),
            );
            let settled = self.objectives(&owner, &objectives, &squares);
            idle += 1;
            if best.as_ref().is_none_or(|b| value < b.value) {
                idle = 0;
                best = Some(Trial {
                    owner: owner.clone(),
                    objectives: objectives.clone(),
                    squares,
                    value,
                });
            }
            let next = self.nearest(&of_cams);
            let is_last = next == owner && (settled == objectives || idle >= IDLE);
            if is_last || self.search.halt.is_asked() {
                break;
            }
            (owner, objectives) = (next, settled);
        }
        best.ok_or_else(one_walker)
    }

    /// Design objective of each cam, from the current errors. If only the worst walkers count, each cam is designed for the worst share of
    /// its walkers. In each alternation, this share moves half-way to the fraction of these walkers that are among the worst of all
    /// walkers.
    fn objectives(&self, owner: &[usize], now: &[Robust], squares: &[f64]) -> Vec<Robust> {
        let Robust::Tail(part) = self.scene.law.robust else {
            return now.to_vec();
        };
        let worst = in_tail(part, squares, &self.shares);
        let of = |(cam, now): (usize, &Robust)| {
            let own = (0..owner.len()).filter(|w| owner[*w] == cam);
            let own: Vec<usize> = own.flat_map(|w| self.cycles[w].clone()).collect();
            let sum = |all: &[f64]| own.iter().map(|i| all[*i]).sum::<f64>();
            let target = (1.0 - part) * sum(&worst) / sum(&self.shares);
            let before = match now {
                Robust::Mean => 1.0,
                Robust::Worst => 0.0,
                Robust::Tail(part) => 1.0 - part,
            };
            let next = 0.5 * (before + target);
            match next {
                _ if (next - before).abs() < SETTLED => *now,
                next if next < SETTLED => Robust::Worst,
                next if next > 1.0 - SETTLED => Robust::Mean,
                next => Robust::Tail(1.0 - next),
            }
        };
        now.iter().enumerate().map(of).collect()
    }

    /// Index of the cam with the minimum error for each walker.
    fn nearest(&self, of_cams: &[Column]) -> Vec<usize> {
        let error = |walker: usize, cam: usize| {
            let each = self.cycles[walker]
                .iter()
                .map(|i| (of_cams[cam].1[*i], self.shares[*i]));
            match self.scene.law.robust {
                Robust::Worst => each.fold(0.0, |m: f64, e| m.max(e.0)),
                Robust::Mean | Robust::Tail(_) => each.map(|e| e.0 * e.1).sum(),
            }
        };
        let count = of_cams.len();
        let best = |w: usize| (0..count).min_by(|a, b| error(w, *a).total_cmp(&error(w, *b)));
        let owner: Vec<usize> = (0..self.cycles.len())
            .map(|w| best(w).unwrap_or_default())
            .collect();
        filled(owner, count, &error)
    }
}

/// Assigns walkers to the unused cams. Each unused cam receives the walker with the largest error among the cams with several walkers.
fn filled(mut owner: Vec<usize>, count: usize, error: &dyn Fn(usize, usize) -> f64) -> Vec<usize> {
    let size = |owner: &[usize], cam: usize| owner.iter().filter(|o| **o == cam).count();
    for cam in 0..count {
        if size(&owner, cam) == 0 {
            let own = |w: &usize| error(*w, owner[*w]);
            let free = (0..owner.len()).filter(|w| size(&owner, owner[*w]) > 1);
            let badly = free.max_by(|a, b| own(a).total_cmp(&own(b)));
            owner[badly.unwrap_or_default()] = cam;
        }
    }
    owner
}

//! The law nearest to the unlimited one: a dual active-set method on the banded factor.
//!
//! With H = LLᵀ and y = Lᵀx the program asks for the point nearest to y₀ = −L⁻¹g among all that keep the
//! rows zᵀy ≤ b, z = L⁻¹a (Goldfarb and Idnani 1983). The active rows are kept as an orthonormal basis Q and
//! a triangle R, Z = QR, so a row comes or goes in O(n·active) operations, and each round of exchange goes
//! on from the last. Between rounds the exact worst points of the law join as rows; the objective only
//! grows, so no set returns.

use super::band::ArrowFactor;
use super::basis::{Entries, apply};
use super::equality::Unlimited;
use super::frame::{Apart, Frame, square};
use super::local_reduction;
use super::program::{EXTRAS, Program, Row, Solution};
use super::settings::ActiveSetSettings;
use crate::poly::Peak;

/// Solves a program without variables beside the law, starting from its optimum without limits.
///
/// Returns the rows gathered so far when no step is left or progress ends: the interior-point method then
/// has the last word on whether there is a solution.
pub fn solve(program: &Program, unlimited: &Unlimited) -> Result<Solution, Vec<Row>> {
    let settings = &program.settings.active_set;
    let mut set = ActiveSet::new(program, unlimited);
    let mut rows: Vec<Row> = Vec::new();
    rows.extend(program.fixed.iter().chain(&program.seeds).cloned());
    let none = [0.0; EXTRAS];
    if program.seeds.is_empty() {
        program.add_neighbours(&mut rows, &set.x);
        add_rows(program, &mut rows, program.broken(&set.x, &none), &mut set);
    }
    if rows.len() > settings.rows {
        return Err(rows);
    }
    let mut best: Option<Solution> = None;
    let mut since_best = 0;
    let mut attempts = 0;
    for round in 1..=settings.rounds {
        if program.halt.is_asked() {
            break;
        }
        if set.settle(program, &mut rows).is_err() {
            return best
                .filter(|b| b.violation < settings.resolved_at_last)
                .ok_or(rows);
        }
        let below = program.settings.local_reduction.below;
        let peaks = program.peaks_near(&set.x, &none, below);
        let violation = program.worst(&peaks, &set.x, &none);
        let candidate = set.solution(set.pushing(|i| &rows[i]), violation, round);
        if candidate.violation <= program.settings.tolerance {
            return Ok(candidate);
        }
        let broken = program.broken_among(&peaks, &set.x, &none);
        if candidate.violation < settings.local_reduction_from
            && attempts < settings.local_reductions
        {
            attempts += 1;
            let level = set.pinned_at;
            let refined = local_reduction::refine(program, unlimited, &candidate, peaks, level);
            if let Some(refined) = refined {
                return Ok(refined);
            }
        }
        if best
            .as_ref()
            .is_none_or(|b| candidate.violation < 0.9 * b.violation)
        {
            best = Some(candidate);
            since_best = 0;
        } else {
            since_best += 1;
            // Rounding, not rows, is what is left.
            let fine = |b: &Solution| b.violation < settings.resolved_at_last;
            if since_best >= 4 && best.as_ref().is_some_and(fine) {
                return best.ok_or(rows);
            }
        }
        add_rows(program, &mut rows, broken, &mut set);
    }
    Err(rows)
}

fn add_rows(
    program: &Program,
    rows: &mut Vec<Row>,
    broken: Vec<(usize, Peak)>,
    set: &mut ActiveSet,
) {
    let coincident = program.settings.active_set.coincident;
    for (limit, peak) in broken {
        let same = |r: &Row| {
            r.limit == Some(limit)
                && r.peak.piece == peak.piece
                && (r.peak.u - peak.u).abs() < coincident
        };
        let row = program.row(limit, peak);
        match rows.iter().position(same) {
            Some(at) => {
                set.forget(at);
                rows[at] = row;
            }
            None => rows.push(row),
        }
    }
}

/// An active row or demand.
struct Member {
    /// Index of the row; `None` for a demand, which never leaves.
    row: Option<usize>,
    /// Its bound.
    bound: f64,
    /// Its multiplier.
    push: f64,
}

pub struct ActiveSet<'a> {
    settings: ActiveSetSettings,
    factor: &'a ArrowFactor,
    /// y₀.
    free: Vec<f64>,
    /// Coefficients.
    pub x: Vec<f64>,
    members: Vec<Member>,
    frame: Frame,
    steps: usize,
    pin: Option<(usize, f64)>,
    pinned_at: f64,
}

/// No step is left, or too many were taken.
struct Stuck;

impl<'a> ActiveSet<'a> {
    fn new(program: &Program, unlimited: &'a Unlimited) -> Self {
        let level = unlimited.pin.map_or(0.0, |(at, _)| unlimited.x[at]);
        Self::about(program, unlimited, &unlimited.factor, level)
    }

    /// With the demands alone, on another factor, the level pinned at `level` where it is open.
    pub fn about(
        program: &Program,
        unlimited: &Unlimited,
        factor: &'a ArrowFactor,
        level: f64,
    ) -> Self {
        let mut set = ActiveSet {
            settings: program.settings.active_set,
            factor,
            free: unlimited.pull.clone(),
            x: unlimited.x.clone(),
            members: Vec::new(),
            frame: Frame::default(),
            steps: 0,
            pin: unlimited.pin,
            pinned_at: 0.0,
        };
        set.factor.forward(&mut set.free);
        set.move_pin(level);
        for demand in &program.equalities {
            let z = set.whitened(&demand.entries);
            let apart = set.frame.split(&z);
            if apart.left > set.settings.dependent * square(&z) {
                set.push(apart, None, demand.value, 0.0);
            }
        }
        set
    }

    fn whitened(&self, entries: &Entries) -> Vec<f64> {
        let mut z = vec![0.0; self.x.len()];
        for &(i, a) in entries {
            z[i] += a;
        }
        self.factor.forward(&mut z);
        z
    }

    fn push(&mut self, apart: Apart, row: Option<usize>, bound: f64, push: f64) {
        self.frame.push(apart);
        self.members.push(Member { row, bound, push });
    }

    /// Takes member `j` out.
    fn remove(&mut self, j: usize) {
        self.members.remove(j);
        self.frame.remove(j);
    }

    /// The point nearest to y₀ on all members' planes, and their multipliers.
    pub fn refresh(&mut self) {
        let bounds: Vec<f64> = self.members.iter().map(|m| m.bound).collect();
        let (mut y, away) = self.frame.nearest(&self.free, &bounds);
        self.factor.backward(&mut y);
        self.x = y;
        let pushes = self.frame.back_substituted(&away);
        for (member, push) in self.members.iter_mut().zip(pushes) {
            member.push = push;
        }
    }

    /// The same after members that pull instead of push have left, so that what is left is an optimum.
    fn retreat(&mut self) {
        loop {
            self.refresh();
            let worst = (0..self.members.len())
                .filter(|&j| self.members[j].row.is_some() && self.members[j].push < 0.0)
                .min_by(|&a, &b| self.members[a].push.total_cmp(&self.members[b].push));
            match worst {
                Some(j) => self.remove(j),
                None => return,
            }
        }
    }

    /// A row is about to change: it leaves the set.
    fn forget(&mut self, row: usize) {
        if let Some(j) = self.members.iter().position(|m| m.row == Some(row)) {
            self.remove(j);
            self.retreat();
        }
    }

    /// Until no row is broken and the level, where it is open, has settled.
    fn settle(&mut self, program: &Program, rows: &mut [Row]) -> Result<(), Stuck> {
        for _ in 0..self.settings.pin_moves {
            self.keep_rows(program, rows)?;
            let Some((at, _)) = self.pin else {
                return Ok(());
            };
            if (self.x[at] - self.pinned_at).abs() <= self.settings.pin_settled * program.length {
                return Ok(());
            }
            self.move_pin(self.x[at]);
            self.retreat();
        }
        Ok(())
    }

    fn move_pin(&mut self, to: f64) {
        if let Some((at, weight)) = self.pin {
            let mut change = vec![0.0; self.x.len()];
            change[at] = weight * (to - self.pinned_at);
            self.factor.forward(&mut change);
            for (f, c) in self.free.iter_mut().zip(change) {
                *f += c;
            }
            self.pinned_at = to;
        }
    }

    fn keep_rows(&mut self, program: &Program, rows: &[Row]) -> Result<(), Stuck> {
        let units: Vec<f64> = rows
            .iter()
            .map(|row| {
                let size = row.limit.map_or(row.scale, |i| program.limits[i].scale);
                size.max(row.bound.abs())
            })
            .collect();
        loop {
            let mut worst = (0.0, None);
            for (i, (row, unit)) in rows.iter().zip(&units).enumerate() {
                let (value, rounding) = with_rounding(&row.entries, &self.x);
                let gap = (value - row.bound - rounding) / unit - self.settings.resolved;
                if gap > worst.0 && !self.members.iter().any(|m| m.row == Some(i)) {
                    worst = (gap, Some(i));
                }
            }
            let Some(i) = worst.1 else {
                self.refresh();
                return Ok(());
            };
            if program.halt.is_asked() {
                return Err(Stuck);
            }
            self.bring_in(i, &rows[i])?;
            if self.members.len() > self.settings.active {
                return Err(Stuck);
            }
        }
    }

    /// Makes a broken row hold; rows that no longer push leave on the way.
    fn bring_in(&mut self, index: usize, row: &Row) -> Result<(), Stuck> {
        let z = self.whitened(&row.entries);
        let length = square(&z);
        let mut push = 0.0;
        loop {
            self.steps += 1;
            if self.steps > self.settings.steps_per_unknown * self.x.len() {
                return Err(Stuck);
            }
            let apart = self.frame.split(&z);
            let shift = self.frame.back_substituted(&apart.along);
            let mut blocking: Option<(usize, f64)> = None;
            for (j, (member, shift)) in self.members.iter().zip(&shift).enumerate() {
                if member.row.is_some() && *shift > 0.0 {
                    let most = member.push.max(0.0) / shift;
                    if blocking.is_none_or(|b| most < b.1) {
                        blocking = Some((j, most));
                    }
                }
            }
            let gap = apply(&row.entries, &self.x) - row.bound;
            let full = (apart.left > self.settings.dependent * length).then_some(gap / apart.left);
            let (step, leaves) = match (full, blocking) {
                (Some(full), Some((j, most))) if most < full => (most, Some(j)),
                (Some(full), _) => (full, None),
                (None, Some((j, most))) => (most, Some(j)),
                (None, None) => return Err(Stuck),
            };
            for (member, shift) in self.members.iter_mut().zip(&shift) {
                member.push -= step * shift;
            }
            push += step;
            if full.is_some() {
                let mut direction = apart.rest.clone();
                self.factor.backward(&mut direction);
                for (x, p) in self.x.iter_mut().zip(&direction) {
                    *x -= step * p;
                }
            }
            match leaves {
                Some(j) => self.remove(j),
                None => {
                    self.push(apart, Some(index), row.bound, push);
                    return Ok(());
                }
            }
        }
    }

    /// Adds a row as active; false when it depends on those that are.
    pub fn hold(&mut self, index: usize, row: &Row) -> bool {
        let z = self.whitened(&row.entries);
        let apart = self.frame.split(&z);
        let independent = apart.left > self.settings.dependent * square(&z);
        if independent {
            self.push(apart, Some(index), row.bound, row.multiplier);
        }
        independent
    }

    /// Smallest multiplier of an active row, relative to the largest.
    pub fn weakest(&self) -> f64 {
        let pushes = || {
            let rows = self.members.iter().filter(|m| m.row.is_some());
            rows.map(|m| m.push)
        };
        let largest = pushes().fold(0.0_f64, |m, p| m.max(p.abs()));
        pushes().fold(f64::INFINITY, f64::min) / largest.max(f64::MIN_POSITIVE)
    }

    /// The active rows that push, with their multipliers.
    pub fn pushing<'r>(&self, row: impl Fn(usize) -> &'r Row) -> Vec<Row> {
        let pushing = self.members.iter().filter(|m| m.push > 0.0);
        let with_push = pushing.filter_map(|m| {
            Some(Row {
                multiplier: m.push,
                ..row(m.row?).clone()
            })
        });
        with_push.collect()
    }

    /// The state as an answer.
    pub fn solution(&self, active: Vec<Row>, violation: f64, rounds: usize) -> Solution {
        Solution {
            violation,
            x: self.x.clone(),
            extra: [0.0; EXTRAS],
            active,
            used_rows: true,
            iterations: self.steps,
            rounds,
        }
    }
}

/// Value of a row and what rounding may have made of it.
fn with_rounding(entries: &Entries, x: &[f64]) -> (f64, f64) {
    let (value, size) = entries.iter().fold((0.0, 0.0), |(v, z), &(i, a)| {
        let term: f64 = a * x[i];
        (v + term, z + term.abs())
    });
    (value, 4.0 * f64::EPSILON * size)
}

//! The last digits of a program with variables beside the law: Newton's method on its contacts.
//!
//! Rounds of an interior-point method close in on a contact with two rows on either side of it; their
//! multipliers, and so the proof, stay uncertain long after the law has settled. Here each contact is one row
//! at the exact local maximum, and a step solves
//!
//! ```text
//! (H + Σ λ/(−c″) a′a′ᵀ + ε) d + Eᵀν + Aᵀλ = −(Hx + g)      E d = e − E x      A d − δ (λ − λ₀) = b − A x
//! ```
//!
//! for law and variables at once (theory as in `local_reduction`). ε and δ hold steps, not results: a proximal
//! method of multipliers for what objective and contacts leave open.

use super::basis::{Basis, apply};
use super::certificate::certificate;
use super::clarabel::row_unit;
use super::program::{EXTRAS, Limit, PEAK, Program, Row, Solution};
use crate::poly::{Peak, PiecewisePoly};
use nalgebra::{DMatrix, DVector};

/// A gap and a stationarity below this end the search.
const PROVED: f64 = 1e-8;

struct Contacts<'a> {
    program: &'a Program,
    /// Second derivatives of the bounds' shapes.
    bends: Vec<PiecewisePoly>,
    free: Vec<usize>,
    degree: usize,
}

/// The optimum near a solution whose limits are all but kept; `None` where the search does not reach it.
pub fn settled(program: &Program, start: &Solution) -> Option<Solution> {
    let Basis::Spline { space, .. } = &program.basis else {
        return None;
    };
    let present = program.present();
    let settings = &program.settings.contacts;
    let unknowns = program.basis.columns() + program.equalities.len();
    let too_large = 2 * unknowns > program.settings.exchange.polish_size;
    if program.cone || program.lifted.is_some() || too_large {
        return None;
    }
    let contacts = Contacts {
        program,
        bends: (program.shapes.iter())
            .map(|s| s.derivative().derivative())
            .collect(),
        free: (0..EXTRAS).filter(|&k| present[k]).collect(),
        degree: space.degree(),
    };
    let push = |r: &Row| r.multiplier * row_unit(&r.entries, program.length);
    let largest = start.active.iter().map(push).fold(0.0, f64::max);
    let mut current = start.clone();
    (current.active).retain(|r| push(r) > settings.weakest * largest);
    current.active = contacts.gathered(&current);
    // No vertex has more contacts than unknowns; far more are an interior point's.
    if current.active.len() > 2 * unknowns {
        return None;
    }
    let mut solves = settings.solves;
    for _ in 0..settings.steps {
        let mut next = contacts.step(&current, &mut solves)?;
        next.violation = program.violation(&next.x, &next.extra);
        let most = settings.divergence * start.violation.max(settings.from);
        if next.violation.is_nan() || next.violation > most {
            return None;
        }
        next.active = contacts.gathered(&next);
        if next.violation <= program.settings.tolerance {
            let proof = certificate(program, &next);
            if proof.relative_gap.max(proof.stationarity) <= PROVED {
                return Some(next);
            }
        }
        contacts.add_broken(&mut next);
        current = next;
    }
    None
}

impl Contacts<'_> {
    /// Whether a limit is constant on every piece: it touches along pieces, not at places.
    fn is_flat(&self, limit: &Limit) -> bool {
        let order = limit.weights.iter().rposition(|w| *w != 0.0).unwrap_or(0);
        order >= self.degree && limit.shape.is_none()
    }

    /// Active rows brought to the local maxima beside them; rows that share one are one contact.
    fn gathered(&self, solution: &Solution) -> Vec<Row> {
        let program = self.program;
        let below = program.settings.local_reduction.below;
        let mut peaks: Vec<(usize, Peak)> = Vec::new();
        let near = |l: &Limit| {
            let room = program.room(l, &solution.x, &solution.extra);
            room - below * l.size(room)
        };
        program.each_peak_above(&solution.x, near, |index, peak| peaks.push((index, peak)));
        let mut out: Vec<Row> = Vec::new();
        for row in &solution.active {
            let width = program.width(row.peak.piece);
            let away = |p: &Peak| (p.at - row.peak.at).abs();
            let limit = row.limit.filter(|&l| !self.is_flat(&program.limits[l]));
            let nearest = limit.and_then(|limit| {
                let mine = peaks.iter().filter(|p| p.0 == limit && away(&p.1) < width);
                mine.min_by(|a, b| away(&a.1).total_cmp(&away(&b.1)))
            });
            let moved = nearest.map_or_else(
                || row.clone(),
                |&(limit, peak)| Row {
                    multiplier: row.multiplier,
                    ..program.row(limit, peak)
                },
            );
            match out.iter_mut().find(|r| self.is_same(r, &moved)) {
                Some(twin) => twin.multiplier += moved.multiplier,
                None => out.push(moved),
            }
        }
        out
    }

    fn is_same(&self, a: &Row, b: &Row) -> bool {
        let apart = (a.peak.at - b.peak.at).abs();
        match a.limit {
            None => false,
            Some(limit) if self.is_flat(&self.program.limits[limit]) => {
                a.limit == b.limit && a.peak.piece == b.peak.piece
            }
            Some(_) => a.limit == b.limit && apart < 1e-7 * self.program.width(a.peak.piece),
        }
    }

    /// Places that a step broke.
    fn add_broken(&self, solution: &mut Solution) {
        for (limit, peak) in self.program.broken(&solution.x, &solution.extra) {
            let row = self.program.row(limit, peak);
            if !solution.active.iter().any(|r| self.is_same(r, &row)) {
                solution.active.push(row);
            }
        }
    }

    /// −c″ at a contact inside its piece.
    fn sharpness(&self, x: &[f64], row: &Row) -> Option<f64> {
        let limit = row.limit.map(|i| &self.program.limits[i])?;
        let w = limit.weights;
        let inside = row.peak.u > 0.0 && row.peak.u < 1.0 && w[4] == 0.0;
        let twice = [0.0, 0.0, w[0], w[1], w[2], w[3]];
        let own = || {
            let entries = self
                .program
                .basis
                .row_on(row.peak.piece, row.peak.u, &twice);
            let bend = limit.shape.map_or(0.0, |i| self.bends[i].eval(row.peak.at));
            bend - apply(&entries, x)
        };
        let width = self.program.width(row.peak.piece);
        let flat = self.program.settings.local_reduction.flat * limit.size(limit.bound);
        inside
            .then(own)
            .filter(|falls| falls * width * width > flat)
    }

    /// One step; rows whose multiplier turns negative leave, the most negative first.
    fn step(&self, from: &Solution, solves: &mut usize) -> Option<Solution> {
        let mut rows = from.active.clone();
        loop {
            *solves = solves.checked_sub(1)?;
            let next = self.equality_step(from, &rows)?;
            let push = |r: &Row| r.multiplier * row_unit(&r.entries, self.program.length);
            let largest = next
                .active
                .iter()
                .map(|r| push(r).abs())
                .fold(0.0, f64::max);
            let (weakest, least) =
                (next.active.iter().map(push).enumerate()).min_by(|a, b| a.1.total_cmp(&b.1))?;
            if least >= -self.program.settings.local_reduction.negative_multiplier * largest {
                let mut next = next;
                next.active.retain(|r| r.multiplier > 0.0);
                return Some(next);
            }
            rows.remove(weakest);
        }
    }

    /// The step with all rows held as equalities.
    fn equality_step(&self, from: &Solution, rows: &[Row]) -> Option<Solution> {
        let program = self.program;
        let (n, length) = (program.basis.columns(), program.length);
        let objective = program.multiplier_unit(from.extra[PEAK]);
        let unit = |k: usize| match from.extra[PEAK].abs() {
            peak if k == PEAK && peak > 0.0 => peak,
            _ => length,
        };
        let columns = n + self.free.len();
        let ties = program.equalities.len() + rows.len();
        let mut kkt = DMatrix::<f64>::zeros(columns + ties, columns + ties);
        let mut rhs = DVector::<f64>::zeros(columns + ties);
        let mut stiff = program.hessian.clone();
        for row in rows.iter().filter(|r| r.multiplier > 0.0) {
            let Some(falls) = self.sharpness(&from.x, row) else {
                continue;
            };
            let w = row.weights;
            let once = [0.0, w[0], w[1], w[2], w[3]];
            let slope = program.basis.row_on(row.peak.piece, row.peak.u, &once);
            for (p, &(i, a)) in slope.iter().enumerate() {
                for &(j, b) in &slope[..=p] {
                    stiff.add(i, j, row.multiplier / falls * a * b);
                }
            }
        }
        for (i, j, value) in stiff.lower_entries() {
            kkt[(i, j)] = value * length * length / objective;
            kkt[(j, i)] = kkt[(i, j)];
        }
        let held = program.settings.contacts.held;
        (0..columns).for_each(|i| kkt[(i, i)] += held);
        let hx = program.hessian.times(&from.x[..n]);
        for i in 0..n {
            rhs[i] = -(hx[i] + program.gradient[i]) * length / objective;
        }
        for (c, &k) in self.free.iter().enumerate() {
            rhs[n + c] = -program.cost[k] * unit(k) / objective;
        }
        let demands = program
            .equalities
            .iter()
            .map(|e| (&e.entries, [0.0; EXTRAS], e.value));
        let contacts = rows.iter().map(|r| (&r.entries, r.extra, r.bound));
        let mut units = Vec::with_capacity(ties);
        for (r, (entries, extra, bound)) in demands.chain(contacts).enumerate() {
            let scale = row_unit(entries, length);
            let mut put = |column: usize, value: f64| {
                kkt[(columns + r, column)] += value / scale;
                kkt[(column, columns + r)] += value / scale;
            };
            entries.iter().for_each(|&(i, v)| put(i, v * length));
            for (c, &k) in self.free.iter().enumerate() {
                put(n + c, extra[k] * unit(k));
            }
            let taken: f64 = (0..EXTRAS).map(|k| extra[k] * from.extra[k]).sum();
            rhs[columns + r] = (bound - taken - apply(entries, &from.x)) / scale;
            if let Some(row) = r.checked_sub(program.equalities.len()).map(|r| &rows[r]) {
                let light = program.settings.contacts.light;
                kkt[(columns + r, columns + r)] = -light;
                rhs[columns + r] -= light * row.multiplier * scale / objective;
            }
            units.push(scale);
        }
        let lu = kkt.clone().lu();
        let mut y = lu.solve(&rhs)?;
        y += lu.solve(&(&rhs - &kkt * &y))?;
        if !y.iter().all(|v| v.is_finite()) {
            return None;
        }
        let mut next = from.clone();
        (0..n).for_each(|i| next.x[i] += y[i] * length);
        for (c, &k) in self.free.iter().enumerate() {
            next.extra[k] += y[n + c] * unit(k);
        }
        next.active = rows.to_vec();
        let first = program.equalities.len();
        for (r, row) in next.active.iter_mut().enumerate() {
            row.multiplier = y[columns + first + r] * objective / units[first + r];
        }
        next.iterations += 1;
        Some(next)
    }
}

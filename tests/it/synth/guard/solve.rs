//! Optimum of the reference: Clarabel with rows at sampled angles. Rows are added where the law exceeds a limit between them, until there is no
//! excess. Every dual value is a lower bound, since rows are missing.

use super::judge::{Judged, crests, judge};
use super::reference::{Reference, Space};
use super::rows::Limit;
use super::splines::ORDERS;
use nalgebra::DVector;

/// Relative excess up to which a limit is satisfied.
pub const HELD: f64 = 1e-9;
/// Relative distance below which a law may touch a limit.
const NEAR: f64 = 0.02;
/// Relative change by which limits are relaxed or tightened before a scene counts as wrongly rejected or designed.
pub const EDGE: f64 = 1e-6;
/// Maximum number of rounds that add rows.
const ROUNDS: usize = 60;
pub enum Outcome {
    Optimum(Optimum),
    /// Lower bound of the objective, which was sufficient to end the search.
    Above(f64),
    Infeasible,
    /// The solver failed, with the reason.
    Undecided(String),
}

#[derive(Debug, Clone)]
pub struct Optimum {
    pub value: f64,
    /// Lower bound of the objective for laws that satisfy the sampled rows, and thus for all laws that satisfy the limits.
    pub bound: f64,
    /// Largest relative excess over a limit.
    pub excess: f64,
}

/// Limit at one angle, as a row over u and the further variables.
pub struct Row {
    pub own: DVector<f64>,
    pub beside: Vec<(usize, f64)>,
    pub bound: f64,
}

impl Row {
    /// Contribution of the further variables to the row.
    pub fn taken(&self, beside: &[f64]) -> f64 {
        self.beside.iter().map(|(k, e)| e * beside[*k]).sum()
    }
}

/// Set of rows that is exchanged during the search.
pub struct Exchange<'a> {
    pub reference: &'a Reference<'a>,
    pub space: &'a Space,
    /// Relative relaxation of every bound, in units of its scale.
    room: f64,
    /// Whether the relaxation is the last variable and the objective.
    pub seeks_room: bool,
    pub rows: Vec<Row>,
    /// Whether a row is violated that no law can influence.
    hopeless: bool,
    pub aim: Aim<'a>,
}

/// Start and end condition of a search.
#[derive(Clone, Copy)]
pub struct Aim<'a> {
    /// Law whose contacts are the first rows. Any rows lead to a lower bound, and these are active if the law is the optimum. `None`: a grid.
    pub near: Option<&'a [f64]>,
    /// Lower bound that ends the search.
    pub enough: f64,
}

/// Search for the optimum from a grid.
pub const WHOLE: Aim = Aim {
    near: None,
    enough: f64::INFINITY,
};

/// Optimum with every bound relaxed by `room` times its scale (tightened if negative).
pub fn solve(reference: &Reference, space: &Space, room: f64, aim: Aim) -> Outcome {
    let mut exchange = Exchange::new(reference, space, room, aim);
    if room <= 0.0 {
        exchange.touched();
    }
    exchange.at_demands();
    if let Some(law) = aim.near {
        exchange.contacts(law);
    }
    // What is linear has an optimum only between rows.
    let open = !space.is_square || reference.extras.iter().any(|e| e.cost != 0.0);
    if aim.near.is_none() || open {
        exchange.coarse();
    }
    exchange.run()
}

/// Minimum relative relaxation of all limits for which a law exists; negative if a law exists with tightened limits. Returns a lower bound and the
/// relaxation of a law. Both are at least 0 if the demands alone violate a limit.
pub fn least_room(reference: &Reference, space: &Space) -> Result<[f64; 2], String> {
    let mut exchange = Exchange::new(reference, space, 0.0, WHOLE);
    exchange.seeks_room = true;
    exchange.touched();
    exchange.at_demands();
    exchange.coarse();
    let start = judge(reference, space.origin.as_slice());
    if exchange.hopeless || space.free.ncols() == 0 {
        return Ok([start.room; 2]);
    }
    let (mut unit, mut least, mut most) = (1.0, f64::NEG_INFINITY, start.room);
    if space.is_square {
        unit = exchange.first_unit(&start);
    }
    for _ in 0..ROUNDS {
        let beside: Vec<f64> = start.extras.iter().copied().chain([start.room]).collect();
        let (u, beside, bound) = match exchange.solved(unit, &beside) {
            Ok(answer) => answer,
            Err(words) => return Err(words.unwrap_or_else(|| "no law at all".to_string())),
        };
        least = f64::max(least, bound);
        let x = &space.origin + &space.free * &u;
        most = f64::min(most, judge(reference, x.as_slice()).room);
        if least > HELD || most < -EDGE || most - least < EDGE {
            return Ok([least, most]);
        }
        exchange.room = beside[beside.len() - 1];
        let added = exchange.add_crests(x.as_slice(), &beside);
        exchange.room = 0.0;
        if !added {
            break;
        }
    }
    Err(format!("no end between a room of {least:e} and {most:e}"))
}

impl<'a> Exchange<'a> {
    fn new(reference: &'a Reference<'a>, space: &'a Space, room: f64, aim: Aim<'a>) -> Self {
        Exchange {
            reference,
            space,
            room,
            seeks_room: false,
            rows: Vec::new(),
            hopeless: false,
            aim,
        }
    }

    /// Objective coefficients of the further variables.
    pub fn costs(&self) -> Vec<f64> {
        let own = self.reference.extras.iter().map(|e| e.cost);
        if self.seeks_room {
            own.map(|_| 0.0).chain([1.0]).collect()
        } else {
            own.collect()
        }
    }

    pub fn is_square(&self) -> bool {
        self.space.is_square && !self.seeks_room
    }
}

impl Exchange<'_> {
    fn push(&mut self, limit: &Limit, span: usize, theta: f64) {
        let alone = limit.weights == [0.0; ORDERS];
        let known = |r: &Row| r.beside.first() == limit.extra.as_ref() && r.own.amax() == 0.0;
        if alone && self.rows.iter().any(known) {
            return;
        }
        let row = DVector::from_vec(self.reference.splines.row(span, theta, limit.weights));
        self.push_row(
            &row,
            self.reference.bound(limit, theta),
            limit.extra,
            limit.scale,
        );
    }

    fn push_row(
        &mut self,
        row: &DVector<f64>,
        bound: f64,
        extra: Option<(usize, f64)>,
        scale: f64,
    ) {
        let bound = bound + self.room * scale - row.dot(&self.space.origin);
        let own = self.space.free.tr_mul(row);
        // In a dwell and at the touching angle no law moves it.
        let moved = own.norm() > 1e-11 * row.norm() * self.space.free.norm();
        if moved || extra.is_some() {
            let mut beside: Vec<(usize, f64)> = extra.into_iter().collect();
            if self.seeks_room {
                beside.push((self.reference.extras.len(), -scale));
            }
            self.rows.push(Row { own, beside, bound });
        } else if bound < -HELD * scale {
            self.hopeless = true;
        }
    }

    /// Adds tangents of the vibrations whose amplitude exceeds this fraction of the limit.
    fn tangents(&mut self, x: &[f64], part: f64) {
        let (reference, most) = (self.reference, self.reference.asked.train.map(|t| t.most));
        for (swing, most) in reference.swings.iter().zip(most.into_iter().cycle()) {
            let (length, row) = reference.amplitude(swing, x);
            if length > part * most {
                self.push_row(&row, most, None, most);
            }
        }
    }

    /// Adds the rows that s ≥ 0 implies where the law touches the base circle. Rows on s alone reach it only in infinitely many steps. s ≥ −ε does
    /// not imply it: beside a dwell, s = −jt³/6 + pt⁴/24 falls by no more than ε for every j below (p³ε)^¼.
    fn touched(&mut self) {
        for (span, theta, weights) in self.reference.touched() {
            let limit = Limit {
                name: "touched",
                weights,
                bound: 0.0,
                shape: 0.0,
                extra: None,
                scale: self.reference.asked.length(),
            };
            self.push(&limit, span, theta);
        }
    }

    /// Adds rows at the demands. No law changes the quantities fixed there, and only irregular laws violate limits next to them.
    fn at_demands(&mut self) {
        let reference = self.reference;
        for limit in &reference.limits {
            for point in &reference.asked.points {
                let span = reference.splines.span_of(point.angle);
                self.push(limit, span, point.angle);
            }
        }
    }

    fn coarse(&mut self) {
        let splines = &self.reference.splines;
        let sides = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
        let most = self.reference.asked.train.map_or(0.0, |t| t.most);
        for [q, p] in &self.reference.swings {
            for [of_q, of_p] in sides {
                self.push_row(&(q * of_q + p * of_p), most, None, most);
            }
        }
        for limit in &self.reference.limits {
            for span in 0..splines.spans() {
                let (a, b) = (splines.breaks()[span], splines.breaks()[span + 1]);
                for u in [0.0, 0.3, 0.7, 1.0] {
                    self.push(limit, span, a + u * (b - a));
                }
            }
        }
    }

    /// Adds rows where a law nearly reaches its limits.
    fn contacts(&mut self, law: &[f64]) {
        let reference = self.reference;
        let extras = judge(reference, law).extras;
        self.tangents(law, 1.0 - NEAR);
        for limit in &reference.limits {
            let taken = limit.extra.map_or(0.0, |(k, e)| e * extras[k]);
            for (span, theta, _) in crests(reference, limit, law, -taken - NEAR * limit.scale) {
                self.push(limit, span, theta);
            }
        }
    }

    fn run(&mut self) -> Outcome {
        let start = judge(self.reference, self.space.origin.as_slice());
        if let Some(outcome) = self.without_rows(&start) {
            return outcome;
        }
        let mut unit = self.first_unit(&start);
        let mut last = f64::INFINITY;
        for _ in 0..ROUNDS {
            let (u, extras, bound) = match self.solved(unit, &start.extras) {
                Ok(answer) => answer,
                Err(Some(words)) => return Outcome::Undecided(words),
                Err(None) => return Outcome::Infeasible,
            };
            if bound >= self.aim.enough {
                return Outcome::Above(bound);
            }
            let x = &self.space.origin + &self.space.free * &u;
            let judged = judge(self.reference, x.as_slice());
            let optimum = Optimum {
                value: judged.value,
                bound,
                excess: judged.excess,
            };
            let before = unit;
            if self.space.is_square {
                unit = u.norm().max(1e-3 * unit);
            }
            let added = self.add_crests(x.as_slice(), &extras);
            let settled = (optimum.value - bound).abs() <= 1e-7 * optimum.value.abs();
            last = optimum.excess - self.room.max(0.0);
            if last <= HELD && settled || !added && unit > 0.5 * before && last < 100.0 * HELD {
                return Outcome::Optimum(optimum);
            }
        }
        Outcome::Undecided(format!("no end at an excess of {last:e}"))
    }

    /// Law without limits, if it satisfies them or there is no other law.
    fn without_rows(&self, start: &Judged) -> Option<Outcome> {
        let kept = |more: f64| start.excess <= more + self.room.max(0.0);
        let alone = Outcome::Optimum(Optimum {
            value: start.value,
            bound: start.value,
            excess: start.excess,
        });
        let free = self.reference.extras.iter().all(|e| e.cost == 0.0);
        if self.space.is_square && free && kept(0.0) {
            return Some(alone);
        }
        if self.space.free.ncols() == 0 {
            return Some(if kept(HELD) {
                alone
            } else {
                Outcome::Infeasible
            });
        }
        self.hopeless.then_some(Outcome::Infeasible)
    }

    /// Adds rows where a law exceeds its limits. Returns whether there were any.
    fn add_crests(&mut self, x: &[f64], extras: &[f64]) -> bool {
        let (reference, before) = (self.reference, self.rows.len());
        self.tangents(x, 1.0 + self.room + 0.1 * HELD);
        for limit in &reference.limits {
            let taken = limit.extra.map_or(0.0, |(k, e)| e * extras[k]);
            let above = self.room * limit.scale - taken + 0.1 * HELD * limit.scale;
            for (span, theta, _) in crests(reference, limit, x, above) {
                self.push(limit, span, theta);
            }
        }
        self.rows.len() > before
    }
}

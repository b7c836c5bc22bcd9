//! The reference's optimum: rows at sampled angles, Clarabel, more rows where the law exceeds a limit between
//! them, until none is exceeded. Every round's dual value is a lower bound, since it leaves rows out.

use super::judge::{Judged, crests, judge};
use super::reference::{Reference, Space};
use super::rows::Limit;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverStatus, SupportedConeT,
};
use nalgebra::DVector;

/// An excess below this part of its limit is none.
pub const HELD: f64 = 1e-9;
/// Rounds of rows.
const ROUNDS: usize = 60;
/// Units and tolerances: where rounding stops the solver under the first, others may do.
const TRIES: [(f64, f64); 5] = [
    (1.0, 1e-12),
    (1.0, 1e-10),
    (0.1, 1e-11),
    (10.0, 1e-11),
    (1.0, 1e-9),
];
/// Residuals and gap, in the solver's own units, with which an answer counts.
const GOOD: f64 = 1e-7;
/// The same of the dual residual, by which the bound is lowered.
const GOOD_DUAL: f64 = 1e-5;

pub enum Outcome {
    Optimum(Optimum),
    Infeasible,
    /// The solver did not end.
    Undecided(String),
}

#[derive(Debug, Clone)]
pub struct Optimum {
    pub value: f64,
    /// No law that keeps the sampled rows, and so none that keeps the limits, is below.
    pub bound: f64,
    /// Largest excess, as a part of its limit.
    pub excess: f64,
}

/// u, the variables beside the law, and the dual value. `Err(None)`: the rows leave nothing.
type Answer = Result<(DVector<f64>, Vec<f64>, f64), Option<String>>;

/// A limit at one place, over u and the variables beside the law.
struct Row {
    own: DVector<f64>,
    extra: Option<(usize, f64)>,
    bound: f64,
}

struct Exchange<'a> {
    reference: &'a Reference<'a>,
    space: &'a Space,
    /// Every bound is moved out by this part of its scale.
    room: f64,
    rows: Vec<Row>,
    /// A row that no law moves is broken.
    hopeless: bool,
    /// Bounds above this are of no interest.
    enough: f64,
}

/// The optimum with every limit moved out by a part `room` of its scale (inwards where negative).
pub fn solve(reference: &Reference, space: &Space, room: f64) -> Outcome {
    solve_below(reference, space, room, f64::INFINITY)
}

/// The same, given up once the optimum is known to be above `enough`.
pub fn solve_below(reference: &Reference, space: &Space, room: f64, enough: f64) -> Outcome {
    let mut exchange = Exchange {
        reference,
        space,
        room,
        rows: Vec::new(),
        hopeless: false,
        enough,
    };
    exchange.touched();
    exchange.coarse();
    exchange.run()
}

impl Exchange<'_> {
    fn push(&mut self, limit: &Limit, span: usize, theta: f64) {
        let row = DVector::from_vec(self.reference.splines.row(span, theta, limit.weights));
        let bound = self.reference.bound(limit, theta) + self.room * limit.scale
            - row.dot(&self.space.origin);
        let own = self.space.free.tr_mul(&row);
        // In a dwell and at the touching angle no law moves it.
        let moved = own.norm() > 1e-11 * row.norm() * self.space.free.norm();
        if moved || limit.extra.is_some() {
            let extra = limit.extra;
            self.rows.push(Row { own, extra, bound });
        } else if bound < -HELD * limit.scale {
            self.hopeless = true;
        }
    }

    /// What s ≥ 0 implies where the law touches the base circle: rows on s alone find it only in infinitely
    /// many steps.
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

    fn coarse(&mut self) {
        let splines = &self.reference.splines;
        for limit in &self.reference.limits {
            for span in 0..splines.spans() {
                let (a, b) = (splines.breaks()[span], splines.breaks()[span + 1]);
                for u in [0.0, 0.3, 0.7, 1.0] {
                    self.push(limit, span, a + u * (b - a));
                }
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
            if bound > self.enough {
                return Outcome::Infeasible;
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

    /// The law without limits, where it keeps them or where there is no other.
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

    /// Rows where a law exceeds its limits; whether there were any.
    fn add_crests(&mut self, x: &[f64], extras: &[f64]) -> bool {
        let (reference, before) = (self.reference, self.rows.len());
        for limit in &reference.limits {
            let taken = limit.extra.map_or(0.0, |(k, e)| e * extras[k]);
            let above = self.room * limit.scale - taken + 0.1 * HELD * limit.scale;
            for (span, theta, _) in crests(reference, limit, x, above) {
                self.push(limit, span, theta);
            }
        }
        self.rows.len() > before
    }

    fn solved(&self, unit: f64, from: &[f64]) -> Answer {
        let mut answer = Err(Some(String::new()));
        for (times, tolerance) in TRIES {
            if matches!(answer, Err(Some(_))) {
                answer = self.clarabel(times * unit, tolerance, from);
            }
        }
        answer
    }

    /// How far u has to go: the farthest row that the law without limits breaks.
    fn first_unit(&self, start: &Judged) -> f64 {
        if !self.space.is_square {
            return 1.0;
        }
        let longest = self.rows.iter().map(|r| r.own.norm()).fold(0.0, f64::max);
        let long = self.rows.iter().filter(|r| r.own.norm() > 1e-3 * longest);
        let far = long.map(|r| {
            let taken = r.extra.map_or(0.0, |(k, e)| e * start.extras[k]);
            (taken - r.bound) / r.own.norm()
        });
        let far = far.filter(|f| f.is_finite());
        let far = far.fold(0.0, f64::max);
        if far > 0.0 {
            far
        } else {
            start.value.abs().sqrt()
        }
    }

    /// Lengths of the rows for laws of size `unit`, and the units of the variables beside the law: what moves
    /// their rows as far as the law does.
    fn scales(&self, unit: f64) -> (Vec<f64>, Vec<f64>) {
        let longest = self.rows.iter().map(|r| r.own.norm()).fold(0.0, f64::max);
        let length = |r: &Row| match r.extra {
            // A row of a variable alone is as long as that makes it.
            Some(_) => r.own.norm().max(1e-3 * longest) * unit,
            None => r.own.norm() * unit,
        };
        let lengths: Vec<f64> = self.rows.iter().map(length).collect();
        let of = |k: usize| {
            let mine = self.rows.iter().zip(&lengths);
            let mine = mine.filter(|(r, _)| r.extra.is_some_and(|e| e.0 == k));
            mine.map(|(_, l)| *l).fold(0.0, f64::max).max(1e-300)
        };
        let units = (0..self.reference.extras.len()).map(of).collect();
        (lengths, units)
    }

    /// The rows as Clarabel takes them, over u and the variables beside the law counted `from` where they are.
    fn matrix(
        &self,
        unit: f64,
        lengths: &[f64],
        units: &[f64],
        from: &[f64],
    ) -> (CscMatrix<f64>, Vec<f64>) {
        let n = self.space.free.ncols();
        let (mut i, mut j, mut v, mut b) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (at, (row, length)) in self.rows.iter().zip(lengths).enumerate() {
            let mut put = |column: usize, value: f64| {
                i.push(at);
                j.push(column);
                v.push(value / length);
            };
            (row.own.iter().enumerate()).for_each(|(column, a)| put(column, a * unit));
            let mut bound = row.bound;
            if let Some((k, e)) = row.extra {
                put(n + k, e * units[k]);
                bound -= e * from[k];
            }
            b.push(bound / length);
        }
        let columns = n + units.len();
        (CscMatrix::new_from_triplets(b.len(), columns, i, j, v), b)
    }

    fn clarabel(&self, unit: f64, tolerance: f64, from: &[f64]) -> Answer {
        let (n, extras) = (self.space.free.ncols(), &self.reference.extras);
        let (lengths, units) = self.scales(unit);
        let (a, b) = self.matrix(unit, &lengths, &units, from);
        let costs = extras.iter().zip(&units).map(|(e, unit)| e.cost * unit);
        let square = if self.space.is_square {
            unit * unit
        } else {
            0.0
        };
        let weight = costs.clone().fold(square, f64::max);
        let all = n + extras.len();
        let diagonal = vec![square / weight; n];
        let p =
            CscMatrix::new_from_triplets(all, all, (0..n).collect(), (0..n).collect(), diagonal);
        let q: Vec<f64> = std::iter::repeat_n(0.0, n)
            .chain(costs.map(|c| c / weight))
            .collect();
        let settings = DefaultSettingsBuilder::default()
            .verbose(false)
            .max_threads(1)
            .tol_gap_abs(tolerance)
            .tol_gap_rel(tolerance)
            .tol_feas(tolerance)
            .build()
            .map_err(|e| Some(e.to_string()))?;
        let cones = [SupportedConeT::NonnegativeConeT(b.len())];
        let mut solver = DefaultSolver::new(&p, &q, &a, &b, &cones, settings)
            .map_err(|e| Some(e.to_string()))?;
        solver.solve();
        let answer = &solver.solution;
        let gap = (answer.obj_val - answer.obj_val_dual).abs();
        match answer.status {
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
                return Err(None);
            }
            SolverStatus::Solved => {}
            _ if answer.r_prim < GOOD
                && answer.r_dual < GOOD_DUAL
                && gap < GOOD * answer.obj_val.abs().max(1.0) => {}
            status => return Err(Some(format!("{status:?}, gap {gap:e}"))),
        }
        let u = DVector::from_fn(n, |k, _| unit * answer.x[k]);
        let beside = (0..extras.len()).map(|k| from[k] + units[k] * answer.x[n + k]);
        let constant: f64 = extras.iter().zip(from).map(|(e, y)| e.cost * y).sum();
        let length = answer.x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let dual = answer.obj_val_dual - answer.r_dual * length;
        Ok((
            u,
            beside.collect(),
            self.space.least + constant + weight * dual,
        ))
    }
}

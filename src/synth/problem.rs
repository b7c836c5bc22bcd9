//! The convex program over the coefficients of a law, and its solution by exchange of rows.
//!
//! Minimise ½xᵀHx + gᵀx (+ t) subject to equalities and to limits that must hold *everywhere* on their
//! domain: Σ wₖ s⁽ᵏ⁾(θ) ≤ bound. A limit is infinitely many rows; the exchange starts from the optimum
//! without it, finds its exact worst points by roots, adds rows there and solves again until nothing is
//! broken. What is active at the end is then solved once more as equalities, which gives back the digits
//! an interior-point method leaves out.

use super::band::ArrowMatrix;
use super::basis::{Basis, Entries, apply};
use super::cones;
use crate::poly::Peak;

/// A linear limit on the law over a range of cam angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// Name as users know it; both signs of a two-sided limit share it.
    pub name: &'static str,
    /// Weights of s, v, a, j and the fourth derivative, by cam angle.
    pub weights: [f64; 5],
    /// Σ weights·svaj ≤ bound.
    pub bound: f64,
    /// First and last cam angle at which it is asked for, rad.
    pub domain: (f64, f64),
    /// Size against which a violation counts: |bound| unless that is 0.
    pub scale: f64,
    /// The bound is a variable to be minimised (a peak objective or an elastic limit).
    pub is_peak: bool,
    /// What a change of the bound means to the user.
    pub meaning: Meaning,
}

/// How a bound is read by users.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Meaning {
    /// Not a number of the scene: the base circle, a monotone flank, the objective.
    Structure,
    /// The scene's value is factor·bound + offset.
    Value {
        /// Factor.
        factor: f64,
        /// Offset.
        offset: f64,
    },
    /// A pressure-angle limit on a given prime circle: bound = tan·D ± e, read as the prime radius.
    PrimeRadius {
        /// Tangent of the angle allowed.
        tan: f64,
        /// Offset of the follower with its sign in the bound, m.
        offset: f64,
    },
}

impl Meaning {
    /// The user's value for a bound; `None` where there is none.
    pub fn value(self, bound: f64) -> Option<f64> {
        match self {
            Meaning::Structure => None,
            Meaning::Value { factor, offset } => Some(factor * bound + offset),
            Meaning::PrimeRadius { tan, offset } => Some(((bound - offset) / tan).hypot(offset)),
        }
    }

    /// |d value / d bound|, for multipliers.
    pub fn slope(self) -> f64 {
        match self {
            Meaning::Structure => 1.0,
            Meaning::Value { factor, .. } => factor.abs(),
            Meaning::PrimeRadius { tan, .. } => 1.0 / tan,
        }
    }
}

/// An exact demand on the law: Σ entries·x = value.
#[derive(Debug, Clone, PartialEq)]
pub struct Equality {
    /// What it says, for messages: "point 2 (56.88°): lift".
    pub name: String,
    /// The row.
    pub entries: Entries,
    /// Its value.
    pub value: f64,
}

/// The whole program.
#[derive(Debug, Clone)]
pub struct Program {
    /// The functions.
    pub basis: Basis,
    /// H of the quadratic objective (may be singular or zero).
    pub hessian: ArrowMatrix,
    /// g of the quadratic objective.
    pub gradient: Vec<f64>,
    /// Exact demands.
    pub equalities: Vec<Equality>,
    /// Limits over ranges.
    pub limits: Vec<Limit>,
    /// Typical size of the coefficients, m: the unit in which the solver works.
    pub length: f64,
}

/// A row of a limit at one angle.
#[derive(Debug, Clone)]
pub struct Row {
    /// Index of the limit.
    pub limit: usize,
    /// Where on the law.
    pub peak: Peak,
    /// The row.
    pub entries: Entries,
    /// Multiplier of the last solve, in units of the objective per unit of the bound.
    pub multiplier: f64,
}

/// A solution with its evidence.
#[derive(Debug, Clone)]
pub struct Solution {
    /// Coefficients.
    pub x: Vec<f64>,
    /// Value of the peak variable, where there is one.
    pub peak: Option<f64>,
    /// Active rows with their multipliers.
    pub active: Vec<Row>,
    /// Whether inequalities had to be brought in at all.
    pub used_rows: bool,
    /// Interior-point iterations over all rounds.
    pub iterations: usize,
    /// Rounds of exchange.
    pub rounds: usize,
    /// Largest violation of any limit on the continuum, relative to its scale.
    pub violation: f64,
}

/// Why there is no solution.
#[derive(Debug, Clone, PartialEq)]
pub enum Failure {
    /// The demands contradict each other; the names of those that are left over.
    Equalities(Vec<String>),
    /// The limits leave nothing.
    Infeasible,
    /// The solver gave up; its word.
    Solver(String),
}

/// A limit counts as kept when it is exceeded by no more than this part of its scale.
pub const TOLERANCE: f64 = 1e-9;
/// Rounds of exchange before giving up; a handful is usual.
const MAX_ROUNDS: usize = 60;
/// A new row this near (in units of its piece) to an old one of the same limit replaces it.
const COINCIDENT: f64 = 1e-4;

impl Program {
    /// The optimum without limits, then with as many rows as they need.
    pub fn solve(&self) -> Result<Solution, Failure> {
        let peak = self.limits.iter().any(|l| l.is_peak);
        let mut rows: Vec<Row> = Vec::new();
        if peak {
            self.seed_rows(&mut rows);
        } else {
            let x = super::equality::solve(self)?;
            let broken = self.broken(&x, None);
            if broken.is_empty() {
                let violation = self.violation(&x, None);
                return Ok(Solution {
                    x,
                    peak: None,
                    active: Vec::new(),
                    used_rows: false,
                    iterations: 0,
                    rounds: 0,
                    violation,
                });
            }
            self.add_rows(&mut rows, broken);
        }
        self.exchange(rows, peak)
    }

    fn exchange(&self, mut rows: Vec<Row>, has_peak: bool) -> Result<Solution, Failure> {
        let mut iterations = 0;
        let mut best: Option<Solution> = None;
        // Room left inside every limit for what the solver does not resolve; grows only when needed.
        let mut margin = 0.0;
        for round in 1..=MAX_ROUNDS {
            let point = cones::solve(self, &mut rows, has_peak, margin)?;
            iterations += point.iterations;
            let (x, t) = super::polish::polish(self, &mut rows, &point, has_peak);
            let broken = self.broken(&x, t);
            let violation = self.violation(&x, t);
            let solution = Solution {
                active: rows
                    .iter()
                    .filter(|r| r.multiplier > 0.0)
                    .cloned()
                    .collect(),
                x,
                peak: t,
                used_rows: true,
                iterations,
                rounds: round,
                violation,
            };
            if broken.is_empty() {
                return Ok(solution);
            }
            let stalled = best.as_ref().is_some_and(|b| violation > 0.5 * b.violation);
            if best.as_ref().is_none_or(|b| violation < b.violation) {
                best = Some(solution);
            }
            if stalled && violation < 1e-6 {
                margin = (2.0 * violation).max(2.0 * margin);
            }
            self.add_rows(&mut rows, broken);
        }
        best.ok_or_else(|| Failure::Solver("no progress".to_string()))
    }

    /// Both ends and the middle of every piece, for limits whose bound is itself a variable.
    fn seed_rows(&self, rows: &mut Vec<Row>) {
        let breaks = self.basis.breaks();
        for (index, limit) in self.limits.iter().enumerate().filter(|(_, l)| l.is_peak) {
            for piece in 0..breaks.len() - 1 {
                for u in [0.0, 0.5, 1.0] {
                    let at = breaks[piece] + u * (breaks[piece + 1] - breaks[piece]);
                    if at >= limit.domain.0 && at <= limit.domain.1 {
                        let peak = Peak {
                            piece,
                            u,
                            at,
                            value: 0.0,
                        };
                        rows.push(self.row(index, peak));
                    }
                }
            }
        }
    }

    fn row(&self, limit: usize, peak: Peak) -> Row {
        let weights = &self.limits[limit].weights;
        let entries = match self.basis {
            Basis::Spline { .. } => self.basis.row_on(peak.piece, peak.u, weights),
            Basis::Harmonic { .. } => self.basis.row(peak.at, weights),
        };
        Row {
            limit,
            peak,
            entries,
            multiplier: 0.0,
        }
    }

    /// Adds rows at the broken points. Earlier rows stay (two that straddle a contact close in on it like a
    /// secant); only one that all but coincides is replaced.
    fn add_rows(&self, rows: &mut Vec<Row>, broken: Vec<(usize, Peak)>) {
        for (limit, peak) in broken {
            let same = |r: &Row| {
                r.limit == limit
                    && r.peak.piece == peak.piece
                    && (r.peak.u - peak.u).abs() < COINCIDENT
            };
            rows.retain(|r| !same(r));
            rows.push(self.row(limit, peak));
        }
    }

    /// Exact worst points at which a limit is exceeded by more than the tolerance.
    pub fn broken(&self, x: &[f64], t: Option<f64>) -> Vec<(usize, Peak)> {
        let curves = Curves::new(self, x);
        let mut out = Vec::new();
        for (index, limit) in self.limits.iter().enumerate() {
            let bound = if limit.is_peak {
                t.unwrap_or(0.0)
            } else {
                limit.bound
            };
            let allowed = bound + TOLERANCE * limit.scale.max(bound.abs());
            let curve = curves.of(limit);
            for peak in curve.peaks_above(allowed, limit.domain.0, limit.domain.1) {
                out.push((index, peak));
            }
        }
        out
    }

    /// Largest excess over any limit, relative to its scale; 0 when all hold.
    pub fn violation(&self, x: &[f64], t: Option<f64>) -> f64 {
        let curves = Curves::new(self, x);
        let mut worst = 0.0_f64;
        for limit in &self.limits {
            let bound = if limit.is_peak {
                t.unwrap_or(0.0)
            } else {
                limit.bound
            };
            let scale = limit.scale.max(bound.abs());
            for peak in curves
                .of(limit)
                .peaks_above(bound, limit.domain.0, limit.domain.1)
            {
                worst = worst.max((peak.value - bound) / scale);
            }
        }
        worst
    }

    /// Size by which solvers divide the objective: its value for coefficients of typical size.
    pub fn objective_unit(&self) -> f64 {
        let h = self.hessian.largest_diagonal() * self.length * self.length;
        let g = self.gradient.iter().fold(0.0_f64, |m, g| m.max(g.abs())) * self.length;
        let unit = h.max(g);
        if unit > 0.0 { unit } else { 1.0 }
    }

    /// Value of the quadratic objective.
    pub fn objective(&self, x: &[f64]) -> f64 {
        let hx = self.hessian.times(&x[..self.basis.columns()]);
        hx.iter().zip(x).map(|(h, x)| 0.5 * h * x).sum::<f64>()
            + self.gradient.iter().zip(x).map(|(g, x)| g * x).sum::<f64>()
    }

    /// Largest violation of an equality, in the equality's own units.
    pub fn equality_error(&self, x: &[f64]) -> f64 {
        self.equalities
            .iter()
            .fold(0.0, |m, e| (apply(&e.entries, x) - e.value).abs().max(m))
    }
}

/// The law of a trial solution, asked for each limit's curve.
struct Curves {
    law: crate::law::Law,
}

impl Curves {
    fn new(program: &Program, x: &[f64]) -> Self {
        Curves {
            law: program.basis.law(x),
        }
    }

    fn of(&self, limit: &Limit) -> crate::poly::PiecewisePoly {
        let w = limit.weights;
        let mut curve = self.law.combination([w[0], w[1], w[2], w[3]], 0.0);
        if w[4] != 0.0 {
            let snap = self.law.combination([0.0, 0.0, 0.0, 1.0], 0.0).derivative();
            curve = crate::poly::PiecewisePoly::combine(&[(1.0, &curve), (w[4], &snap)], 0.0);
        }
        curve
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::SplineSpace;
    use crate::synth::objective::Quadratic;
    use std::f64::consts::PI;

    /// Rest to rest on [0, 1] with h = 1, the first n − 1 derivatives zero at both ends.
    fn rest_to_rest(n: usize, degree: usize, breaks: &[f64]) -> Program {
        let inner = breaks.len() - 2;
        let space = SplineSpace::clamped(degree, breaks, &vec![1; inner]);
        let basis = Basis::Spline {
            space,
            closed: false,
        };
        let mut equalities = Vec::new();
        for order in 0..n {
            let mut w = [0.0; 5];
            w[order] = 1.0;
            let last = breaks.len() - 2;
            let demand = |piece, u, value| Equality {
                name: format!("order {order}"),
                entries: basis.row_on(piece, u, &w),
                value,
            };
            equalities.push(demand(0, 0.0, 0.0));
            equalities.push(demand(last, 1.0, if order == 0 { 1.0 } else { 0.0 }));
        }
        let zero = Quadratic::zero(&basis);
        Program {
            basis,
            hessian: zero.hessian,
            gradient: zero.gradient,
            equalities,
            limits: vec![],
            length: 1.0,
        }
    }

    fn uniform(n: usize) -> Vec<f64> {
        (0..=n).map(|i| i as f64 / n as f64).collect()
    }

    fn with_energy(mut p: Program, order: usize) -> Program {
        let mut q = Quadratic::zero(&p.basis);
        q.add_energy(&p.basis, order, 2.0);
        p.hessian = q.hessian;
        p
    }

    fn peak_limits(order: usize) -> Vec<Limit> {
        [1.0, -1.0]
            .map(|sign| {
                let mut weights = [0.0; 5];
                weights[order] = sign;
                Limit {
                    name: "peak",
                    weights,
                    bound: 0.0,
                    domain: (0.0, 1.0),
                    scale: 1.0,
                    is_peak: true,
                    meaning: Meaning::Structure,
                }
            })
            .to_vec()
    }

    fn two_sided(order: usize, bound: f64) -> Vec<Limit> {
        let mut out = peak_limits(order);
        for l in &mut out {
            l.is_peak = false;
            l.bound = bound;
            l.scale = bound;
        }
        out
    }

    #[test]
    fn least_energy_rest_to_rest_is_3_4_5_and_4_5_6_7() {
        // FACTS §8: 12, 720, 100800 for n = 2, 3, 4.
        for (n, degree, expected) in [(2, 3, 12.0), (3, 5, 720.0), (4, 7, 100_800.0)] {
            let program = with_energy(rest_to_rest(n, degree, &[0.0, 0.3, 1.0]), n);
            let solution = program.solve().unwrap();
            let value = program.objective(&solution.x);
            assert!((value / expected - 1.0).abs() < 1e-9, "{n}: {value}");
        }
    }

    #[test]
    fn free_end_acceleration_gives_jerk_energy_120() {
        let mut program = with_energy(rest_to_rest(2, 5, &[0.0, 0.5, 1.0]), 3);
        program.equalities.truncate(4);
        let solution = program.solve().unwrap();
        assert!((program.objective(&solution.x) / 120.0 - 1.0).abs() < 1e-9);
    }

    #[test]
    fn least_peaks_are_4_32_and_384() {
        // FACTS §8: switches at (1 − cos kπ/n)/2 put the optimum inside the spline space.
        for (n, expected) in [(2_usize, 4.0), (3, 32.0), (4, 384.0)] {
            let breaks: Vec<f64> = (0..=n)
                .map(|k| 0.5 * (1.0 - (k as f64 * PI / n as f64).cos()))
                .collect();
            let mut program = rest_to_rest(n, n, &breaks);
            program.limits = peak_limits(n);
            let solution = program.solve().unwrap();
            let peak = solution.peak.unwrap();
            assert!((peak / expected - 1.0).abs() < 1e-6, "{n}: {peak}");
        }
    }

    #[test]
    fn least_peak_acceleration_under_a_jerk_limit_follows_the_closed_form() {
        // FACTS §8: A*(J) = (J/4)(1 − √(1 − 32/J)); breaks on the ramp ends make it exact.
        for (jerk, n, expected) in [(32.0, 8, 8.0), (36.0, 12, 6.0), (50.0, 20, 5.0)] {
            let mut program = rest_to_rest(3, 3, &uniform(n));
            program.limits = [peak_limits(2), two_sided(3, jerk)].concat();
            let solution = program.solve().unwrap();
            let closed = jerk / 4.0 * (1.0 - (1.0 - 32.0 / jerk as f64).max(0.0).sqrt());
            assert!((closed - expected).abs() < 1e-12);
            let peak = solution.peak.unwrap();
            assert!((peak / expected - 1.0).abs() < 1e-6, "J = {jerk}: {peak}");
            assert!(solution.violation < 1e-6);
        }
    }

    #[test]
    fn a_jerk_limit_below_32_is_infeasible() {
        let mut program = with_energy(rest_to_rest(3, 5, &uniform(24)), 3);
        program.limits = two_sided(3, 31.9);
        assert_eq!(program.solve().unwrap_err(), Failure::Infeasible);
    }

    #[test]
    fn a_jerk_limit_on_quintics_holds_between_samples() {
        // FACTS §9: one sample per span lets a limit of 50 reach 197.9; exchange must not.
        let mut program = with_energy(rest_to_rest(3, 5, &uniform(16)), 2);
        program.limits = two_sided(3, 50.0);
        let solution = program.solve().unwrap();
        let law = program.basis.law(&solution.x);
        let worst = (0..100_000)
            .map(|i| law.svaj(f64::from(i) / 100_000.0).j.abs())
            .fold(0.0, f64::max);
        assert!(worst < 50.0 * (1.0 + 2e-9), "{worst}");
        assert!(worst > 49.9, "the limit should bind: {worst}");
        assert!(solution.active.iter().all(|r| r.multiplier > 0.0) && !solution.active.is_empty());
    }

    #[test]
    fn contradicting_demands_are_named() {
        let mut program = with_energy(rest_to_rest(3, 5, &uniform(4)), 3);
        let mut again = program.equalities[1].clone();
        again.name = "the second end".to_string();
        again.value = 2.0;
        program.equalities.push(again.clone());
        assert_eq!(
            program.solve().unwrap_err(),
            Failure::Equalities(vec!["the second end".to_string()])
        );
        again.value = 1.0;
        program.equalities.pop();
        program.equalities.push(again);
        assert!(
            program.solve().is_ok(),
            "a repeated demand is no contradiction"
        );
    }
}

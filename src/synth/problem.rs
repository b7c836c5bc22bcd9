//! The convex program over the coefficients of a law, and its solution by exchange of rows.
//!
//! Minimise ½xᵀHx + gᵀx + cᵀy subject to equalities and to limits that must hold *everywhere* on their
//! domain: Σ wₖ s⁽ᵏ⁾(θ) ≤ bound. A limit is infinitely many rows; the exchange starts from the optimum
//! without it, finds its exact worst points by roots, adds rows there and solves again until nothing is
//! broken. What is active at the end is then solved once more as equalities, which gives back the digits
//! an interior-point method leaves out.

use super::band::ArrowMatrix;
use super::basis::{Basis, Entries, apply};
use super::cones;
use crate::poly::{Peak, PiecewisePoly};

/// Variables beside the coefficients of the law, by their index in `extra` arrays.
pub const EXTRAS: usize = 4;
/// A bound that is itself minimised: a peak objective, an elastic limit.
pub const PEAK: usize = 0;
/// Base radius of a flat-faced cam, prime radius Rp of a roller cam, m.
pub const RADIUS: usize = 1;
/// Height D of the roller centre above the cam centre at s = 0, m.
pub const RISE: usize = 2;
/// Offset e of the follower, m.
pub const OFFSET: usize = 3;

/// A linear limit on the law over a range of cam angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// Name as users know it; both signs of a two-sided limit share it.
    pub name: &'static str,
    /// Weights of s, v, a, j and the fourth derivative, by cam angle.
    pub weights: [f64; 5],
    /// Σ weights·svaj + Σ extra·y ≤ bound + shape(θ).
    pub bound: f64,
    /// Weights of the variables beside the law.
    pub extra: [f64; EXTRAS],
    /// Index into the program's shapes of the part of the bound that varies with θ.
    pub shape: Option<usize>,
    /// First and last cam angle at which it is asked for, rad.
    pub domain: (f64, f64),
    /// Size against which a violation counts: |bound| unless that is 0.
    pub scale: f64,
    /// What a change of the bound means to the user.
    pub meaning: Meaning,
}

impl Limit {
    /// Σ weights·svaj ≤ bound over one turn.
    pub fn new(name: &'static str, weights: [f64; 5], bound: f64, scale: f64) -> Self {
        Limit {
            name,
            weights,
            bound,
            extra: [0.0; EXTRAS],
            shape: None,
            domain: (0.0, std::f64::consts::TAU),
            scale,
            meaning: Meaning::Structure,
        }
    }

    /// The same limit with its bound (beyond the shape) replaced by the peak variable.
    #[must_use]
    pub fn minimised(mut self) -> Self {
        self.bound = 0.0;
        self.extra[PEAK] = -1.0;
        self
    }

    /// Whether its bound is minimised.
    pub fn is_peak(&self) -> bool {
        self.extra[PEAK] != 0.0
    }

    /// The bound less what the variables beside the law take of it.
    fn room(&self, extra: &[f64; EXTRAS]) -> f64 {
        self.bound - (0..EXTRAS).map(|k| self.extra[k] * extra[k]).sum::<f64>()
    }
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
    /// A limit on a size that is itself a variable: nothing to relax.
    Sized,
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
            Meaning::Structure | Meaning::Sized => None,
            Meaning::Value { factor, offset } => Some(factor * bound + offset),
            Meaning::PrimeRadius { tan, offset } => Some(((bound - offset) / tan).hypot(offset)),
        }
    }

    /// |d value / d bound|, for multipliers.
    pub fn slope(self) -> f64 {
        match self {
            Meaning::Structure | Meaning::Sized => 1.0,
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
    /// Parts of bounds that vary with θ.
    pub shapes: Vec<PiecewisePoly>,
    /// Rows that stand for themselves (linearised curvature).
    pub fixed: Vec<Row>,
    /// Rows to begin the exchange with: the contacts of a neighbouring program.
    pub seeds: Vec<Row>,
    /// Cost of each variable beside the law.
    pub cost: [f64; EXTRAS],
    /// Rp ≥ ‖(D, e)‖.
    pub cone: bool,
    /// A limit counts as kept when it is exceeded by no more than this part of its scale.
    pub tolerance: f64,
    /// Typical size of the coefficients, m: the unit in which the solver works.
    pub length: f64,
}

/// A row of a limit at one angle: Σ entries·x + Σ extra·y ≤ bound.
#[derive(Debug, Clone)]
pub struct Row {
    /// Index of the limit; `None` for a fixed row.
    pub limit: Option<usize>,
    /// Where on the law.
    pub peak: Peak,
    /// The row.
    pub entries: Entries,
    /// Weights of the variables beside the law.
    pub extra: [f64; EXTRAS],
    /// Its bound.
    pub bound: f64,
    /// Size of which a part may be kept free; 0 where none can be.
    pub scale: f64,
    /// Multiplier of the last solve, in units of the objective per unit of the bound.
    pub multiplier: f64,
}

/// A solution with its evidence.
#[derive(Debug, Clone)]
pub struct Solution {
    /// Coefficients.
    pub x: Vec<f64>,
    /// Values of the variables beside the law.
    pub extra: [f64; EXTRAS],
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

/// Tolerance of a finished law.
pub const TOLERANCE: f64 = 1e-9;
/// A point that breaks limits by more than this part of their scale is not polished.
const WORTH_POLISHING: f64 = 1e-5;
/// Rounds of exchange before giving up; a handful is usual.
const MAX_ROUNDS: usize = 60;
/// Room inside a limit never exceeds this part of its scale.
const LARGEST_MARGIN: f64 = 1e-6;
/// What the solver leaves unresolved on a second-order cone program.
const CONE_MARGIN: f64 = 1e-7;
/// A new row this near (in units of its piece) to an old one of the same limit replaces it.
const COINCIDENT: f64 = 1e-4;

impl Program {
    /// A program without limits.
    pub fn new(
        basis: Basis,
        hessian: ArrowMatrix,
        gradient: Vec<f64>,
        equalities: Vec<Equality>,
        length: f64,
    ) -> Self {
        Program {
            basis,
            hessian,
            gradient,
            equalities,
            limits: Vec::new(),
            shapes: Vec::new(),
            fixed: Vec::new(),
            seeds: Vec::new(),
            cost: [0.0; EXTRAS],
            cone: false,
            tolerance: TOLERANCE,
            length,
        }
    }

    /// Which of the variables beside the law take part.
    pub fn present(&self) -> [bool; EXTRAS] {
        let mut out = [false; EXTRAS];
        for (k, present) in out.iter_mut().enumerate() {
            *present = self.cost[k] != 0.0
                || self.limits.iter().any(|l| l.extra[k] != 0.0)
                || self.fixed.iter().any(|r| r.extra[k] != 0.0)
                || (self.cone && k != PEAK);
        }
        out
    }

    /// The optimum without limits, then with as many rows as they need.
    pub fn solve(&self) -> Result<Solution, Failure> {
        let mut rows: Vec<Row> = self.fixed.clone();
        if !self.seeds.is_empty() {
            rows.extend(self.seeds.iter().cloned());
        } else if self.present().iter().any(|p| *p) {
            self.seed_rows(&mut rows);
        } else {
            let x = self.on_base_circle(super::equality::solve(self)?);
            let extra = [0.0; EXTRAS];
            let broken = self.broken(&x, &extra);
            if broken.is_empty() && rows.iter().all(|r| apply(&r.entries, &x) <= r.bound) {
                let violation = self.violation(&x, &extra);
                let active = Vec::new();
                return Ok(Solution {
                    x,
                    extra,
                    active,
                    used_rows: false,
                    iterations: 0,
                    rounds: 0,
                    violation,
                });
            }
            self.add_rows(&mut rows, broken);
            self.add_neighbours(&mut rows, &x);
        }
        self.exchange(rows)
    }

    fn exchange(&self, mut rows: Vec<Row>) -> Result<Solution, Failure> {
        let mut iterations = 0;
        let mut best: Option<Solution> = None;
        // Room left inside every limit for what the solver does not resolve; grows only when needed.
        // Cones are not polished, so there it is kept from the start.
        let mut margin = if self.cone { CONE_MARGIN } else { 0.0 };
        for round in 1..=MAX_ROUNDS {
            let point = match (cones::solve(self, &mut rows, margin), &best) {
                (Ok(point), _) => point,
                // The room kept free is ours, not the user's: without it there is a solution.
                (Err(_), Some(_)) if margin > 0.0 => break,
                (Err(failure), _) => return Err(failure),
            };
            iterations += point.iterations;
            // Far from the end the next rows matter, not the last digits.
            let rough = self.violation(&point.x, &point.extra) > WORTH_POLISHING;
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
                x,
                extra,
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
                margin = (2.0 * violation).max(2.0 * margin).min(LARGEST_MARGIN);
            }
            self.add_rows(&mut rows, broken);
        }
        best.ok_or_else(|| Failure::Solver("no progress".to_string()))
    }

    /// The same program with its sizes held at the solution's, enlarged by `room`: without a cone it is
    /// solved to rounding, which a cone program is not.
    pub fn with_sizes_held(&self, solution: &Solution, room: f64) -> Program {
        let mut held = self.clone();
        let mut sizes = solution.extra;
        sizes[RISE] *= 1.0 + room;
        sizes[RADIUS] *= 1.0 + room;
        let taken = |extra: &[f64; EXTRAS]| (1..EXTRAS).map(|k| extra[k] * sizes[k]).sum::<f64>();
        for limit in &mut held.limits {
            limit.bound -= taken(&limit.extra);
            limit.extra = [limit.extra[PEAK], 0.0, 0.0, 0.0];
        }
        for row in &mut held.fixed {
            row.bound -= taken(&row.extra);
            row.extra = [row.extra[PEAK], 0.0, 0.0, 0.0];
        }
        held.cost = [self.cost[PEAK], 0.0, 0.0, 0.0];
        held.cone = false;
        held.tolerance = TOLERANCE;
        held.seeds = solution
            .active
            .iter()
            .filter(|r| r.limit.is_some())
            .cloned()
            .collect();
        for row in &mut held.seeds {
            row.bound -= taken(&row.extra);
            row.extra = [row.extra[PEAK], 0.0, 0.0, 0.0];
        }
        held
    }

    /// Both ends and the middle of every piece, for limits whose bound is itself a variable.
    fn seed_rows(&self, rows: &mut Vec<Row>) {
        let breaks = self.basis.breaks();
        let variable = |l: &Limit| l.extra.iter().any(|e| *e != 0.0);
        for (index, limit) in self.limits.iter().enumerate().filter(|(_, l)| variable(l)) {
            for piece in 0..breaks.len() - 1 {
                for u in [0.0, 0.5, 1.0] {
                    let at = breaks[piece] + u * (breaks[piece + 1] - breaks[piece]);
                    if at >= limit.domain.0 && at <= limit.domain.1 {
                        rows.push(self.row(
                            index,
                            Peak {
                                piece,
                                u,
                                at,
                                value: 0.0,
                            },
                        ));
                    }
                }
            }
        }
    }

    /// Ends and middles of pieces where the law without limits breaks one: many of them touch in the end,
    /// and rows are cheaper than rounds.
    fn add_neighbours(&self, rows: &mut Vec<Row>, x: &[f64]) {
        let law = self.basis.law(x);
        let extra = [0.0; EXTRAS];
        for (index, limit) in self.limits.iter().enumerate() {
            let bound = limit.room(&extra);
            let curve = self.curve(&law, limit);
            let worst = curve.peaks_above(bound, limit.domain.0, limit.domain.1);
            if worst.is_empty() || limit.shape.is_some() {
                continue;
            }
            let breaks = curve.breaks();
            for piece in 0..curve.pieces() {
                for u in [0.0, 0.5, 1.0] {
                    let at = breaks[piece] + u * (breaks[piece + 1] - breaks[piece]);
                    let value = crate::poly::bernstein::eval(curve.piece(piece), u);
                    if value > bound && at >= limit.domain.0 && at <= limit.domain.1 {
                        rows.push(self.row(
                            index,
                            Peak {
                                piece,
                                u,
                                at,
                                value,
                            },
                        ));
                    }
                }
            }
        }
    }

    fn row(&self, index: usize, peak: Peak) -> Row {
        let limit = &self.limits[index];
        // With a shape the pieces are cut finer than the basis: only the angle counts then.
        let by_piece = matches!(self.basis, Basis::Spline { .. }) && limit.shape.is_none();
        let entries = if by_piece {
            self.basis.row_on(peak.piece, peak.u, &limit.weights)
        } else {
            self.basis.row(peak.at, &limit.weights)
        };
        let shape = limit.shape.map_or(0.0, |i| self.shapes[i].eval(peak.at));
        Row {
            limit: Some(index),
            peak,
            entries,
            extra: limit.extra,
            bound: limit.bound + shape,
            // A law at rest lies on the base circle and on the edge of steadiness: no room can be kept there.
            scale: if limit.meaning == Meaning::Structure {
                0.0
            } else {
                limit.scale
            },
            multiplier: 0.0,
        }
    }

    /// Adds rows at the broken points. Earlier rows stay (two that straddle a contact close in on it like a
    /// secant); only one that all but coincides is replaced.
    fn add_rows(&self, rows: &mut Vec<Row>, broken: Vec<(usize, Peak)>) {
        for (limit, peak) in broken {
            let same = |r: &Row| {
                r.limit == Some(limit)
                    && r.peak.piece == peak.piece
                    && (r.peak.u - peak.u).abs() < COINCIDENT
            };
            rows.retain(|r| !same(r));
            rows.push(self.row(limit, peak));
        }
    }

    /// Exact worst points at which a limit is exceeded by more than the tolerance.
    pub fn broken(&self, x: &[f64], extra: &[f64; EXTRAS]) -> Vec<(usize, Peak)> {
        let law = self.basis.law(x);
        let mut out = Vec::new();
        for (index, limit) in self.limits.iter().enumerate() {
            let bound = limit.room(extra);
            let allowed = bound + self.tolerance * limit.scale.max(bound.abs());
            let peaks =
                self.curve(&law, limit)
                    .peaks_above(allowed, limit.domain.0, limit.domain.1);
            out.extend(peaks.into_iter().map(|peak| (index, peak)));
        }
        out
    }

    /// Largest excess over any limit, relative to its scale; 0 when all hold.
    pub fn violation(&self, x: &[f64], extra: &[f64; EXTRAS]) -> f64 {
        let law = self.basis.law(x);
        let mut worst = 0.0_f64;
        for limit in &self.limits {
            let bound = limit.room(extra);
            let scale = limit.scale.max(bound.abs());
            for peak in self
                .curve(&law, limit)
                .peaks_above(bound, limit.domain.0, limit.domain.1)
            {
                worst = worst.max((peak.value - bound) / scale);
            }
        }
        worst
    }

    /// Left side of a limit less its shape, over the whole law.
    fn curve(&self, law: &crate::law::Law, limit: &Limit) -> PiecewisePoly {
        let w = limit.weights;
        let mut curve = law.combination([w[0], w[1], w[2], w[3]], 0.0);
        if w[4] != 0.0 {
            let snap = law.combination([0.0, 0.0, 0.0, 1.0], 0.0).derivative();
            curve = PiecewisePoly::combine(&[(1.0, &curve), (w[4], &snap)], 0.0);
        }
        if let Some(shape) = limit.shape.map(|i| &self.shapes[i]) {
            let own = curve.cut_at(shape.breaks());
            curve =
                PiecewisePoly::combine(&[(1.0, &own), (-1.0, &shape.cut_at(own.breaks()))], 0.0);
        }
        curve
    }

    /// Whether H does not see the constant function: the moving axis knows no absolute lift.
    pub fn constant_is_free(&self) -> bool {
        let one = match self.basis {
            Basis::Spline { .. } => vec![1.0; self.basis.columns()],
            Basis::Harmonic { count } => {
                let mut x = vec![0.0; 2 * count + 1];
                x[0] = 1.0;
                x
            }
        };
        let energy: f64 = self
            .hessian
            .times(&one)
            .iter()
            .zip(&one)
            .map(|(h, x)| h * x)
            .sum();
        energy <= 1e-10 * self.hessian.largest_diagonal()
    }

    /// Where neither the objective nor a demand fixes the level, the law with its lowest point at zero: a
    /// stroke counts from there.
    fn on_base_circle(&self, mut x: Vec<f64>) -> Vec<f64> {
        let fixes_level = |e: &Equality| {
            let (sum, size) = e
                .entries
                .iter()
                .fold((0.0, 0.0), |(s, z), e| (s + e.1, z + e.1.abs()));
            f64::abs(sum) > 1e-6 * size
        };
        if !self.constant_is_free() || self.equalities.iter().any(fixes_level) {
            return x;
        }
        let lowest = self.basis.law(&x).extremes(0).0.value;
        match self.basis {
            Basis::Spline { .. } => x.iter_mut().for_each(|c| *c -= lowest),
            Basis::Harmonic { .. } => x[0] -= lowest,
        }
        x
    }

    /// Size by which solvers divide the objective: its value for coefficients of typical size.
    pub fn objective_unit(&self) -> f64 {
        let h = self.hessian.largest_diagonal() * self.length * self.length;
        let g = self.gradient.iter().fold(0.0_f64, |m, g| m.max(g.abs())) * self.length;
        let linear = (1..EXTRAS).fold(0.0_f64, |m, k| m.max(self.cost[k].abs())) * self.length;
        let unit = h.max(g).max(linear);
        if unit > 0.0 { unit } else { 1.0 }
    }

    /// Value of the quadratic part of the objective.
    pub fn objective(&self, x: &[f64]) -> f64 {
        let hx = self.hessian.times(&x[..self.basis.columns()]);
        hx.iter().zip(x).map(|(h, x)| 0.5 * h * x).sum::<f64>()
            + self.gradient.iter().zip(x).map(|(g, x)| g * x).sum::<f64>()
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
        Program::new(basis, zero.hessian, zero.gradient, equalities, 1.0)
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

    fn two_sided(order: usize, bound: f64) -> Vec<Limit> {
        [1.0, -1.0]
            .map(|sign| {
                let mut weights = [0.0; 5];
                weights[order] = sign;
                Limit {
                    domain: (0.0, 1.0),
                    ..Limit::new("peak", weights, bound, 1.0)
                }
            })
            .to_vec()
    }

    fn minimise_peak(program: &mut Program, order: usize) {
        program
            .limits
            .extend(two_sided(order, 0.0).into_iter().map(Limit::minimised));
        program.cost[PEAK] = 1.0;
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
            minimise_peak(&mut program, n);
            let solution = program.solve().unwrap();
            let peak = solution.extra[PEAK];
            assert!((peak / expected - 1.0).abs() < 1e-6, "{n}: {peak}");
        }
    }

    #[test]
    fn least_peak_acceleration_under_a_jerk_limit_follows_the_closed_form() {
        // FACTS §8: A*(J) = (J/4)(1 − √(1 − 32/J)); breaks on the ramp ends make it exact.
        for (jerk, n, expected) in [(32.0, 8, 8.0), (36.0, 12, 6.0), (50.0, 20, 5.0)] {
            let mut program = rest_to_rest(3, 3, &uniform(n));
            program.limits = two_sided(3, jerk);
            minimise_peak(&mut program, 2);
            let solution = program.solve().unwrap();
            let closed = jerk / 4.0 * (1.0 - (1.0 - 32.0 / jerk).max(0.0).sqrt());
            assert!((closed - expected).abs() < 1e-12);
            let peak = solution.extra[PEAK];
            assert!((peak / expected - 1.0).abs() < 1e-6, "J = {jerk}: {peak}");
            assert!(solution.violation < 1e-6);
        }
    }

    /// Dwell, rise to 1 at ½, return: the first n − 1 derivatives zero at both ends.
    fn rise_and_return(n: usize, degree: usize, breaks: &[f64]) -> Program {
        let mut program = rest_to_rest(n, degree, breaks);
        for e in &mut program.equalities {
            e.value = 0.0;
        }
        let entries = program.basis.row(0.5, &[1.0]);
        program.equalities.push(Equality {
            name: "top".to_string(),
            entries,
            value: 1.0,
        });
        program
    }

    #[test]
    fn dwell_rise_return_optima_are_found() {
        // FACTS §8: min ∫a² = 192, min ∫j² = 20480, min peak |a| = 16, min peak |j| = 48(2 + √2).
        for (n, degree, expected) in [(2, 3, 192.0), (3, 5, 20_480.0)] {
            let program = with_energy(rise_and_return(n, degree, &uniform(4)), n);
            let value = program.objective(&program.solve().unwrap().x);
            assert!((value / expected - 1.0).abs() < 1e-9, "{n}: {value}");
        }
        let mut program = rise_and_return(2, 2, &uniform(8));
        minimise_peak(&mut program, 2);
        let peak = program.solve().unwrap().extra[PEAK];
        assert!((peak / 16.0 - 1.0).abs() < 1e-6, "{peak}");
        // The switches of the jerk are irrational; fine uniform breaks come near enough.
        let mut program = rise_and_return(3, 3, &uniform(400));
        minimise_peak(&mut program, 3);
        let peak = program.solve().unwrap().extra[PEAK];
        let exact = 48.0 * (2.0 + 2.0_f64.sqrt());
        assert!(
            (peak / exact - 1.0).abs() < 1e-4 && peak > exact * (1.0 - 1e-6),
            "{peak} {exact}"
        );
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

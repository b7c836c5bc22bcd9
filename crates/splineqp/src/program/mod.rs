//! Convex program for the coefficients of a law, and its solution by exchange of rows.
//!
//! Minimises ½xᵀHx + gᵀx + cᵀy subject to equalities and to limits that must hold at *every* point of their domain: Σ wₖ s⁽ᵏ⁾(θ) ≤ bound. A
//! limit is equivalent to infinitely many rows, one for each θ. `separation` computes the exact points at which a law exceeds a limit most.
//! `solve` selects the method: `active_set` if only the coefficients are unknown, `exchange` if there are further variables.

use crate::Names;
mod failure;
mod limit;
mod pieces;
mod rms;
mod separation;
mod variable;

pub use failure::{Failure, Stop};
pub use limit::{Derivative, LeftSide, Limit, Limited};
pub use rms::{Ball, RmsLimit};
pub(crate) use variable::make_constant;
pub use variable::{ByVariable, Cone, PEAK, Values, Variable};

use super::band::ArrowMatrix;
use super::basis::{Basis, Entries, apply};
use super::objective::{Quadratic, quadratic};
use super::settings::Settings;
use crate::poly::{Peak, PiecewisePoly};
use gaitcam_base::halt::Halt;
use variable::Declared;

/// Equality constraint on the law: Σ entries·x = value.
#[derive(Debug, Clone, PartialEq)]
pub struct Equality<N: Names> {
    /// Name of the equality for the caller.
    pub name: N::Equality,
    /// Weights of the coefficients of the law in the left side.
    pub entries: Entries,
    /// Prescribed value of the left side.
    pub value: f64,
}

/// Convex program for the coefficients of a law and a few further variables.
#[derive(Debug, Clone)]
pub struct Program<N: Names> {
    /// Basis functions Bᵢ of the law.
    pub basis: Basis,
    /// Matrix H of the quadratic objective (may be singular or zero).
    pub hessian: ArrowMatrix,
    /// Vector g of the quadratic objective.
    pub gradient: Vec<f64>,
    /// Constant part of the objective.
    pub constant: f64,
    /// Equality constraints on the law.
    pub equalities: Vec<Equality<N>>,
    /// Limits over ranges of angles.
    pub limits: Vec<Limit<N>>,
    /// Limits on root mean squares of the law.
    pub rms: Vec<RmsLimit<N>>,
    /// Functions of θ that are added to the constant bounds of limits.
    pub shapes: Vec<PiecewisePoly>,
    /// Row for the value of the law at the reference angle. Limits with `from_reference` measure the law from this value; `None` if they
    /// measure it from zero.
    pub reference: Option<Entries>,
    /// Rows that do not belong to a limit, such as the rows of a linearised curvature. These rows are kept in every iteration.
    pub fixed: Vec<Row<N>>,
    /// Initial rows of the exchange, such as the active rows of a similar program.
    pub seeds: Vec<Row<N>>,
    /// Cost of each further variable in the objective: the vector c.
    pub cost: Values,
    /// Second-order cones of the further variables.
    pub cones: Vec<Cone<N>>,
    variables: Vec<Declared>,
    /// Typical size of the coefficients, used as unit of the solver.
    pub length: f64,
    /// Settings of the solvers for this program.
    pub settings: Settings,
    /// Condition under which the caller stops the solvers.
    pub halt: Halt,
}

/// Row of a limit at one angle: Σ entries·x + Σ extra·y ≤ bound.
#[derive(Debug, Clone)]
pub struct Row<N: Names> {
    /// Index of the limit; `None` for a row that does not belong to a limit.
    pub limit: Option<usize>,
    /// Name of the limit for users.
    pub name: N::Limit,
    /// Position at which the row is evaluated: piece, position on the piece, and angle.
    pub peak: Peak,
    /// Weights of s, v, a, j and the fourth derivative at that position.
    pub weights: [f64; 5],
    /// Weights of the coefficients of the law in the left side.
    pub entries: Entries,
    /// Part of the weights `entries` that comes from the value of the law at the reference angle.
    pub reference: Entries,
    /// Weights of the further variables y in the left side.
    pub extra: Values,
    /// Bound of the left side of the row.
    pub bound: f64,
    /// Scale of the margin; 0 if no margin is permitted.
    pub scale: f64,
    /// Multiplier of the last solution, in units of the objective per unit of the bound.
    pub multiplier: f64,
}

impl<N: Names> Row<N> {
    /// A row that does not belong to a limit: Σ entries·x ≤ bound. Its excess is checked if the row has a scale.
    pub fn of_no_limit(name: N::Limit, peak: Peak, entries: Entries, bound: f64) -> Self {
        Row {
            limit: None,
            name,
            peak,
            weights: [0.0; 5],
            entries,
            reference: Vec::new(),
            extra: Values::NONE,
            bound,
            scale: 0.0,
            multiplier: 0.0,
        }
    }

    /// Bound of the row minus its left side for the given coefficients and further variables.
    pub(crate) fn slack(&self, x: &[f64], extra: &Values) -> f64 {
        self.bound - self.extra.dot(extra) - apply(&self.entries, x)
    }

    /// Whether both rows belong to the same limit and the same piece, at a distance less than the fraction `part` of the piece.
    pub(crate) fn coincides(&self, other: &Row<N>, part: f64) -> bool {
        self.limit == other.limit
            && self.peak.piece == other.peak.piece
            && (self.peak.u - other.peak.u).abs() < part
    }
}

/// Solution of a program, with the data for its certificate.
#[derive(Debug, Clone)]
pub struct Solution<N: Names> {
    /// Coefficients of the law, without the further variables.
    pub x: Vec<f64>,
    /// Values of the further variables.
    pub extra: Values,
    /// Active rows with their multipliers.
    pub active: Vec<Row<N>>,
    /// Whether inequalities were necessary, that is, whether the optimum with the equalities alone violates a limit.
    pub used_rows: bool,
    /// Total number of interior-point iterations.
    pub iterations: usize,
    /// Number of iterations in which rows were added.
    pub rounds: usize,
    /// Maximum violation of a limit over all angles, relative to its scale.
    pub violation: f64,
}

impl<N: Names> Program<N> {
    /// Creates a program without limits.
    pub fn new(
        basis: Basis,
        objective: Quadratic,
        equalities: Vec<Equality<N>>,
        length: f64,
    ) -> Self {
        Program {
            basis,
            hessian: objective.hessian,
            gradient: objective.gradient,
            constant: objective.constant,
            equalities,
            limits: Vec::new(),
            rms: Vec::new(),
            shapes: Vec::new(),
            reference: None,
            fixed: Vec::new(),
            seeds: Vec::new(),
            cost: Values::NONE,
            cones: Vec::new(),
            variables: Vec::new(),
            length,
            settings: Settings::default(),
            halt: Halt::never(),
        }
    }

    /// Bound of the left side of a limit for a law. It is the bound of the limit minus the terms of the further variables. If the limit
    /// measures the law from its value at the reference angle, this value is added.
    pub fn room(&self, limit: &Limit<N>, x: &[f64], extra: &Values) -> f64 {
        let lowest = self.reference_of(limit).map_or(0.0, |at| apply(at, x));
        limit.room(extra) + limit.weights[0] * lowest
    }

    /// A derivative of the law of a solution, or a combination of derivatives.
    pub fn curve(&self, solution: &Solution<N>, side: impl Into<LeftSide>) -> PiecewisePoly {
        self.basis.combination(&solution.x, &side.into().weights())
    }

    /// Sets the reference angle, rad. Limits with `from_reference` measure the law from its value at this angle.
    pub fn count_from(&mut self, angle: f64) {
        self.reference = Some(self.basis.row(angle, &[1.0, 0.0, 0.0, 0.0]));
    }

    /// Row for the value of the law at the reference angle, if the limit is relative to this value. `None` if the limit is relative to
    /// zero.
    pub fn reference_of(&self, limit: &Limit<N>) -> Option<&Entries> {
        self.reference.as_ref().filter(|_| limit.from_reference)
    }

    /// The program without the limits on ranges of values whose position is free. `None` if there are no such limits, or if the width of
    /// a range is minimised. Also `None` if one of these limits was active in a similar program.
    pub fn without_windows(&self) -> Option<Program<N>> {
        let mut windows = self.limits.iter().filter(|l| l.is_window).peekable();
        if windows.peek().is_none() || windows.any(Limit::is_peak) {
            return None;
        }
        let of_window = |r: &Row<N>| r.limit.is_some_and(|i| self.limits[i].is_window);
        if (self.seeds.iter()).any(|r| r.multiplier > 0.0 && of_window(r)) {
            return None;
        }
        let mut free = self.clone();
        free.seeds.retain(|r| !of_window(r));
        for limit in free.limits.iter_mut().filter(|l| l.is_window) {
            *limit = limit.idle();
        }
        Some(free)
    }

    /// Values of the variables that are the lower ends of ranges with free position, for the law with the coefficients `x`.
    pub fn windows(&self, x: &[f64]) -> Values {
        let mut extra = Values::NONE;
        if self.limits.iter().any(|l| l.is_window) {
            for (k, order) in self.least_values() {
                extra[k] = self.basis.least(x, order);
            }
        }
        extra
    }

    /// Whether H is zero for constant functions. On a moving axis, for example, the force does not depend on the level of the lift.
    pub fn constant_is_free(&self) -> bool {
        let energy = match self.basis {
            Basis::Spline { .. } => self.hessian.sum(),
            Basis::Harmonic { .. } => self.hessian.get(0, 0),
        };
        let free = self.settings.equality.level_is_free;
        energy <= free * self.hessian.largest_diagonal()
    }

    /// Whether neither the objective nor an equality determines the level of the law.
    pub fn level_is_open(&self) -> bool {
        let fixes_level = |e: &Equality<N>| {
            let (sum, size) = e
                .entries
                .iter()
                .fold((0.0, 0.0), |(s, z), e| (s + e.1, z + e.1.abs()));
            f64::abs(sum) > self.settings.equality.fixes_level * size
        };
        !self.equalities.iter().any(fixes_level) && self.constant_is_free()
    }

    /// Coefficients of the law. If nothing determines the level, the law is shifted so that its minimum is zero.
    pub(crate) fn with_least_at_zero(&self, x: Vec<f64>) -> Vec<f64> {
        if !self.level_is_open() {
            return x;
        }
        let lowest = self.basis.least(&x, 0);
        self.basis.raised(x, -lowest)
    }

    /// Width of a piece of the basis, rad.
    pub fn width(&self, piece: usize) -> f64 {
        match &self.basis {
            Basis::Spline { space, .. } => space.spans()[piece].width,
            Basis::Harmonic { .. } => {
                let breaks = self.basis.breaks();
                breaks[piece + 1] - breaks[piece]
            }
        }
    }

    /// Scale of the objective in the solvers: its value for coefficients of typical size.
    pub fn objective_unit(&self) -> f64 {
        let h = self.hessian.largest_diagonal() * self.length * self.length;
        let g = self.gradient.iter().fold(0.0_f64, |m, g| m.max(g.abs())) * self.length;
        let costs = self.cost.iter().filter(|(k, _)| *k != PEAK);
        let linear = costs.fold(0.0_f64, |m, (k, cost)| m.max(cost.abs() * self.typical(k)));
        let unit = h.max(g).max(linear);
        if unit > 0.0 { unit } else { 1.0 }
    }

    /// Unit of the multipliers in the solver. It is the unit of the objective, or the unit of the peak if only the peak is minimised.
    pub fn multiplier_unit(&self, peak: f64) -> f64 {
        if self.cost[PEAK] == 0.0 {
            return self.objective_unit();
        }
        self.cost[PEAK].abs() * peak.abs().max(f64::MIN_POSITIVE)
    }

    /// Total objective of a solution, including the costs of the further variables.
    pub fn merit(&self, solution: &Solution<N>) -> f64 {
        self.objective(&solution.x) + self.constant + self.cost.dot(&solution.extra)
    }

    /// Value of the quadratic part of the objective, without its constant.
    pub fn objective(&self, x: &[f64]) -> f64 {
        quadratic(&self.hessian, &self.gradient, &x[..self.basis.columns()])
    }
}

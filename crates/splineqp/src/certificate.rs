//! Certificate of a law: an upper bound of its distance from the optimum.
//!
//! The active rows aᵢᵀx ≤ bᵢ have the multipliers λ ≥ 0, and the equalities Ex = d have the multipliers ν. With these multipliers, the
//! Lagrange dual of the program is a lower bound of its objective. Let r = Hx + g + Eᵀν + Aᵀλ be the residual of the law x, where A has the
//! rows aᵢᵀ. The difference between the objective and the lower bound is then at most
//!
//! ```text
//! gap = Σ λᵢ (bᵢ − aᵢᵀx) − νᵀ(Ex − d) + xᵀr (+ z·y for the multiplier z of a cone with the further variables y)
//! ```
//!
//! (Boyd and Vandenberghe, Convex Optimization, §5.5). If H has a Cholesky factor, the quadratic Lagrangian decreases from its value at x
//! by at most ½ rᵀH⁻¹r. This term replaces xᵀr if xᵀr is not small, because in xᵀr the rounding error of r is multiplied by the whole lift.
//! The rows are limits at exact angles, so the bound is valid for the whole turn.

use super::basis::{Basis, apply, dense};
use super::equality;
use super::frame::{Frame, dot, square};
use super::program::{PEAK, Program, Solution, Values};
use super::settings::TOLERANCE;
use crate::Names;
use serde::Serialize;

/// Proved upper bounds of the distance of a law from the optimum.
///
/// ```
/// use splineqp::{Basis, Derivative, Limit, Program, Quadratic, certificate};
/// use splineqp::poly::SplineSpace;
/// use std::f64::consts::TAU;
///
/// // The periodic quintic nearest to sin θ whose value nowhere exceeds ½.
/// let basis = Basis::Spline { space: SplineSpace::periodic_uniform(5, 16, TAU), closed: true };
/// let mut distance = Quadratic::zero(&basis);
/// let sine = |start: f64, width: f64, rule: &[(f64, f64)], out: &mut [f64]| {
///     for (value, (u, _)) in out.iter_mut().zip(rule) {
///         *value = (start + u * width).sin();
///     }
/// };
/// distance.add_distance(&basis, &[1.0], 8, sine, None);
/// let mut program: Program<()> = Program::new(basis, distance, Vec::new(), 1.0);
/// program.limits.push(Limit::on("highest", Derivative::Value).at_most(0.5));
/// let solution = program.solve().unwrap();
/// let proof = certificate(&program, &solution);
/// assert!(proof.relative_gap < 1e-6 && proof.violation < 1e-8);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Certificate {
    /// Objective minus the lower bound from the multipliers, in units of the objective (N² for half the mean square of a force error).
    pub duality_gap: f64,
    /// Duality gap relative to the size of the objective.
    pub relative_gap: f64,
    /// Objective minus a lower bound over all laws, relative to the size of the objective. It exceeds the relative gap if the law results
    /// from a sequence of convex programs, which prove only a local optimum. `None` if no such bound is known.
    pub global_gap: Option<f64>,
    /// Size of the objective. It is the largest of three numbers: the magnitude of the objective, the sum of the magnitudes of the costs,
    /// and a millionth of the largest term. The last number estimates the rounding error.
    pub size: f64,
    /// Maximum entry of the gradient of the Lagrangian, relative to the largest term of this gradient.
    pub stationarity: f64,
    /// Maximum violation of a limit over all angles, relative to the scale of the limit.
    pub violation: f64,
}

/// Maximum relative gap and maximum stationarity for which an optimum counts as proved.
pub const PROVED: f64 = 1e-6;

impl Certificate {
    /// Whether every limit is satisfied to [`TOLERANCE`].
    pub fn keeps_limits(&self) -> bool {
        self.violation <= TOLERANCE * 1.000_001
    }

    /// Whether the optimum is proved: gap and stationarity are at most [`PROVED`].
    pub fn proves_optimum(&self) -> bool {
        self.relative_gap <= PROVED && self.stationarity <= PROVED
    }

    /// Raises the duality gap to `gap` if `gap` is larger. The relative gap then also counts as the global gap.
    pub fn widen(&mut self, gap: f64) {
        self.duality_gap = self.duality_gap.max(gap);
        self.relative_gap = self.duality_gap / self.size;
        self.global_gap = Some(self.relative_gap);
    }

    /// Sets the global gap of a local optimum. `gap` is the objective minus a lower bound over all laws; `None` if no such bound is known.
    pub fn bounded_by(&mut self, gap: Option<f64>) {
        self.global_gap = gap.map(|gap| self.relative_gap.max(gap / self.size));
    }
}

/// Certificate of a solution. The peak is computed from the law, because the peak stored in the solution may be inexact.
pub fn certificate<N: Names>(program: &Program<N>, solution: &Solution<N>) -> Certificate {
    let x = &solution.x[..program.basis.columns()];
    let mut extra = solution.extra;
    extra[PEAK] = program.own_peak(x, &extra);
    let mut lagrangian = Lagrangian::of(program, solution, x, &extra);
    let size = objective_size(program, x, &extra);
    let slack = lagrangian.slack;
    let mut gap = slack + project_off_equalities(program, &mut lagrangian.residual, x);
    let residual = &lagrangian.residual;
    // The gradient is negligible if it is small relative to its largest term. It is also negligible if a change of every coefficient by the
    // typical lift leaves the objective practically unchanged.
    let along: f64 = residual.iter().map(|r| r.abs()).sum::<f64>() * program.length;
    let left = largest(residual) / lagrangian.largest_term.max(f64::MIN_POSITIVE);
    let left = left.min(along / size);
    let product = residual.iter().zip(x).map(|(r, x)| r * x);
    let plain = product.sum::<f64>().abs();
    let known = (plain > program.settings.certificate.small * size)
        .then(|| equality::largest_decrease(program, residual));
    let level = match program.basis {
        _ if !program.level_is_open() => 0.0,
        Basis::Spline { .. } => lagrangian.level * largest(x),
        Basis::Harmonic { .. } => residual[0] * x[0],
    };
    gap += known.flatten().map_or(plain, |own| own + level.abs());
    let (gap, left) = with_further_variables(program, &lagrangian, &extra, size, (gap, left));
    Certificate {
        duality_gap: gap,
        relative_gap: gap / size,
        global_gap: Some(gap / size),
        size,
        stationarity: left,
        violation: solution.violation,
    }
}

/// Gradient of the Lagrangian for the multipliers of the active rows, without the multipliers of the equalities.
struct Lagrangian {
    /// Gradient with respect to the coefficients.
    residual: Vec<f64>,
    /// Largest absolute term of the gradient with respect to the coefficients.
    largest_term: f64,
    /// Component of the gradient along the constant function, without the term Hx. It is used if the level is free. The contribution of Hx
    /// is then only a rounding error.
    level: f64,
    /// Gradient with respect to the further variables.
    of_extra: Values,
    /// Sum of the magnitudes of the terms in each component of `of_extra`.
    terms_of_extra: Values,
    /// Complementarity sum Σ λᵢ (bᵢ − aᵢᵀx).
    slack: f64,
}

impl Lagrangian {
    fn of<N: Names>(
        program: &Program<N>,
        solution: &Solution<N>,
        x: &[f64],
        extra: &Values,
    ) -> Self {
        let hx = program.hessian.times(x);
        let terms = hx.iter().chain(&program.gradient);
        let mut out = Lagrangian {
            largest_term: terms.fold(0.0, |m, term| m.max(term.abs())),
            level: program.gradient.iter().sum(),
            of_extra: program.cost,
            terms_of_extra: Values::NONE,
            slack: 0.0,
            residual: hx
                .iter()
                .zip(&program.gradient)
                .map(|(h, g)| h + g)
                .collect(),
        };
        for (k, cost) in program.cost.iter() {
            out.terms_of_extra[k] = cost.abs();
        }
        for row in &solution.active {
            out.slack += row.multiplier * row.slack(x, extra).abs();
            for &(i, a) in &row.entries {
                out.residual[i] += row.multiplier * a;
                out.level += row.multiplier * a;
                out.largest_term = out.largest_term.max((row.multiplier * a).abs());
            }
            for (k, e) in row.extra.iter() {
                out.of_extra[k] += row.multiplier * e;
                out.terms_of_extra[k] += (row.multiplier * e).abs();
            }
        }
        out
    }
}

/// Duality gap and stationarity including the further variables. A component of the gradient counts as zero if it is small relative to its
/// largest term. It also counts as zero if a change of the variable by its own size leaves the objective practically unchanged.
fn with_further_variables<N: Names>(
    program: &Program<N>,
    lagrangian: &Lagrangian,
    extra: &Values,
    size: f64,
    (mut gap, mut left): (f64, f64),
) -> (f64, f64) {
    let (of_extra, terms) = (&lagrangian.of_extra, &lagrangian.terms_of_extra);
    let open = |component: f64, own: f64, at: f64| {
        let moved = if at > 0.0 {
            component * at / size
        } else {
            f64::INFINITY
        };
        (component / own.max(f64::MIN_POSITIVE)).min(moved)
    };
    for cone in &program.cones {
        // The multiplier of the cone is the cost minus the contribution of the rows. It must lie in the cone and be orthogonal to the variables.
        let largest_of = |values: &Values| {
            let sizes = cone.members().map(|k| values[k].abs());
            sizes.fold(0.0, f64::max)
        };
        let outside = (cone.norm(of_extra) - of_extra[cone.head]).max(0.0);
        left = left.max(open(outside, largest_of(terms), largest_of(extra)));
        let product = cone.members().map(|k| extra[k] * of_extra[k]);
        gap += product.sum::<f64>().abs();
    }
    for k in program.free_variables() {
        if !program.is_in_cone(k) {
            let typical = if k == PEAK { 0.0 } else { program.typical(k) };
            let at = extra[k].abs().max(typical);
            left = left.max(open(of_extra[k].abs(), terms[k], at));
            gap += (of_extra[k] * extra[k]).abs();
        }
    }
    (gap, left)
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| m.max(v.abs()))
}

/// Size of the objective: its magnitude, the sum of the magnitudes of the costs, or the fraction `least_objective` of its largest term. The
/// largest of these numbers is used.
fn objective_size<N: Names>(program: &Program<N>, x: &[f64], extra: &Values) -> f64 {
    let linear: f64 = program
        .gradient
        .iter()
        .zip(x)
        .map(|(g, x)| (g * x).abs())
        .sum();
    let costs = || program.cost.iter();
    let beside: f64 = costs().map(|(k, cost)| (cost * extra[k]).abs()).sum();
    // The typical value of a variable counts as a term even if the variable is 0. The scale of the limits with the peak counts in the same
    // way.
    let sizes = costs().filter(|(k, _)| *k != PEAK);
    let sizes = sizes.map(|(k, cost)| cost.abs() * program.typical(k));
    let peaks = program.limits.iter().filter(|l| l.is_peak());
    let peaks = peaks.map(|l| program.cost[PEAK].abs() * l.scale);
    let terms = sizes.chain(peaks).fold(linear, f64::max);
    let whole = program.objective(x) + program.constant;
    let value = whole
        .abs()
        .max(program.settings.certificate.least_objective * terms)
        .max(beside);
    if value > 0.0 { value } else { 1.0 }
}

/// Projects a residual onto the orthogonal complement of the rows of the equalities. The removed part is −Eᵀν. Returns |νᵀ(Ex − d)|.
fn project_off_equalities<N: Names>(
    program: &Program<N>,
    residual: &mut Vec<f64>,
    x: &[f64],
) -> f64 {
    let (mut frame, mut missed) = (Frame::default(), Vec::new());
    for equality in &program.equalities {
        let normal = dense(&equality.entries, residual.len());
        let apart = frame.split(&normal);
        if apart.left > program.settings.certificate.dependent * square(&normal) {
            frame.push(apart);
            missed.push(apply(&equality.entries, x) - equality.value);
        }
    }
    let apart = frame.split(residual);
    *residual = apart.rest;
    dot(&frame.back_substituted(&apart.along), &missed).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXACT: Certificate = Certificate {
        duality_gap: 2e-8,
        relative_gap: 1e-8,
        global_gap: Some(1e-8),
        size: 2.0,
        stationarity: 0.0,
        violation: 0.0,
    };

    #[test]
    fn a_proof_ends_where_it_says() {
        let keeps = |violation| Certificate { violation, ..EXACT }.keeps_limits();
        assert_eq!(
            [TOLERANCE, 1.00001 * TOLERANCE, f64::NAN].map(keeps),
            [true, false, false]
        );
        let proves = |relative_gap, stationarity| {
            let other = Certificate {
                relative_gap,
                stationarity,
                ..EXACT
            };
            other.proves_optimum()
        };
        assert!(proves(1e-6, 1e-6));
        assert!(!proves(1.01e-6, 0.0) && !proves(0.0, 1.01e-6));
    }

    #[test]
    fn a_gap_to_a_lower_bound_counts_in_parts_of_the_objective() {
        let mut wide = EXACT;
        wide.widen(1e-3);
        assert_eq!(
            (wide.duality_gap, wide.relative_gap, wide.global_gap),
            (1e-3, 5e-4, Some(5e-4))
        );
        wide.widen(1e-4);
        assert_eq!(wide.duality_gap, 1e-3);
        let mut local = EXACT;
        local.bounded_by(Some(1e-3));
        assert_eq!((local.relative_gap, local.global_gap), (1e-8, Some(5e-4)));
        local.bounded_by(Some(0.0));
        assert_eq!(local.global_gap, Some(1e-8));
        local.bounded_by(None);
        assert_eq!((local.relative_gap, local.global_gap), (1e-8, None));
    }
}

//! A limit on a root mean square of the law, such as its force error.

use super::{ByVariable, Limit, Program, Row, Values, Variable};
use crate::Names;
use crate::band::ArrowFactor;
use crate::objective::{MeanSquare, Quadratic};
use crate::poly::Peak;

/// Bound of the rounding error of the mean square, relative to the constant term of q.
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Relative increase of the diagonal of H. With it, H can be factorised even if it is zero for constant functions.
const RIDGE: f64 = 1e-13;

/// Limit on a root mean square as a cone: ‖Lᵀx + h‖ ≤ radius.
pub struct Ball {
    /// Cholesky factor L of the Hessian H of the quadratic q (see [`RmsLimit`]).
    pub factor: ArrowFactor,
    /// Vector h by which the cone is shifted.
    pub shift: Vec<f64>,
    /// Radius √(most² − 2 min q) of the cone.
    pub radius: f64,
}

/// Limit √(2 q(x)) ≤ most. The convex quadratic function q is half a mean square.
#[derive(Debug, Clone)]
pub struct RmsLimit<N: Names> {
    /// Name of the limit for users.
    pub name: N::Limit,
    /// The function q of the coefficients, half a mean square of the law.
    pub half: MeanSquare,
    /// Maximum root mean square, above 0.
    pub most: f64,
    /// Meaning of `most` for the caller, such as the quantity from which `most` is computed.
    pub meaning: N::Meaning,
}

impl<N: Names> RmsLimit<N> {
    /// Relative excess over the limit after subtraction of the rounding errors of q; negative if the limit is satisfied.
    pub fn excess(&self, x: &[f64]) -> f64 {
        let square = 2.0 * self.half.value(x) - ROUNDING * self.half.whole.constant.abs();
        square.max(0.0).sqrt() / self.most - 1.0
    }

    /// The limit as a cone. `None` if the minimum root mean square is not below the limit, or if H cannot be factorised.
    pub(crate) fn ball(&self) -> Option<Ball> {
        let whole = &self.half.whole;
        let mut hessian = whole.hessian.clone();
        let ridge = RIDGE * hessian.largest_diagonal();
        (0..hessian.dimension()).for_each(|i| hessian.add(i, i, ridge));
        let factor = hessian.factor()?;
        let mut shift = whole.gradient.clone();
        factor.forward(&mut shift);
        let mut nearest: Vec<f64> = shift.iter().map(|h| -h).collect();
        factor.backward(&mut nearest);
        let room = self.most.powi(2) - 2.0 * self.half.value(&nearest);
        (room > 0.0).then(|| Ball {
            factor,
            shift,
            radius: room.sqrt(),
        })
    }

    /// Whether a row is a tangent of this limit, recognised by its name.
    pub fn is_tangent(&self, row: &Row<N>) -> bool {
        row.limit.is_none() && row.name == self.name
    }

    /// Tangent of the limit at x. Since q is convex, every law z that satisfies the limit satisfies ∇q(x)·(z − x) ≤ ½ most² − q(x). The
    /// tangent is this inequality, divided by `most`.
    pub(crate) fn tangent(&self, x: &[f64], multiplier: f64) -> Row<N> {
        let mut gradient = self.half.gradient(x);
        gradient.iter_mut().for_each(|g| *g /= self.most);
        let along: f64 = gradient.iter().zip(x).map(|(g, x)| g * x).sum();
        let entries = gradient.into_iter().enumerate().collect();
        let bound = 0.5 * self.most - self.half.value(x) / self.most + along;
        Row {
            multiplier,
            ..Row::of_no_limit(self.name, Peak::default(), entries, bound)
        }
    }
}

impl<N: Names> Program<N> {
    /// Active rows of a similar program as initial rows of this program. Rows of limits are computed again with the bounds of this program.
    /// Tangents of root-mean-square limits are unchanged.
    pub fn seeds_of(&self, active: &[Row<N>]) -> Vec<Row<N>> {
        let is_limited = |i: usize| self.limits.get(i).is_some_and(|l| !l.is_idle());
        let own = |row: &Row<N>| match row.limit {
            Some(limit) => is_limited(limit).then(|| Row {
                multiplier: row.multiplier,
                ..self.row(limit, row.peak)
            }),
            None => (self.rms.iter().any(|l| l.is_tangent(row))).then(|| row.clone()),
        };
        active.iter().filter_map(own).collect()
    }

    /// The program with `weight` times q in its objective, instead of the limit √(2 q) ≤ most.
    pub(crate) fn weighing(&self, limit: &RmsLimit<N>, weight: f64) -> Program<N> {
        let mut out = self.clone();
        out.rms.retain(|l| l.name != limit.name);
        let whole = &limit.half.whole;
        out.hessian.add_scaled(&whole.hessian, weight);
        for (own, g) in out.gradient.iter_mut().zip(&whole.gradient) {
            *own += weight * g;
        }
        out.constant += weight * whole.constant;
        out
    }

    /// Program that minimises the root mean square with this name subject to the other limits; `None` if there is no limit with this name.
    pub fn of_least_rms(&self, name: N::Limit) -> Option<Program<N>> {
        let mut out = self.clone();
        let limit = out.rms.iter().position(|l| l.name == name)?;
        let limit = out.rms.remove(limit);
        Some(out.minimising(limit.half.whole))
    }

    /// The program with `objective` as its objective, and without costs of further variables. Its limits keep their indices, so that rows
    /// of both programs can be exchanged.
    #[must_use]
    pub fn minimising(mut self, objective: Quadratic) -> Program<N> {
        (self.hessian, self.gradient) = (objective.hessian, objective.gradient);
        (self.constant, self.cost) = (objective.constant, Values::NONE);
        self.without_idle_limits();
        self.seeds.clear();
        self
    }

    /// Removes limits that have no effect, because their bound contains a variable without a cost or another restriction. An example is a
    /// peak that is no longer minimised.
    fn without_idle_limits(&mut self) {
        let kept = |k: Variable| {
            self.is_in_cone(k)
                || self.limits.iter().any(|l| l.extra[k] > 0.0)
                || self.fixed.iter().any(|r| r.extra[k] != 0.0)
        };
        let mut grows = ByVariable::<bool>::default();
        Variable::all().for_each(|k| grows[k] = self.cost[k] == 0.0 && !kept(k));
        let is_idle = |l: &Limit<N>| l.extra.iter().any(|(k, weight)| grows[k] && weight < 0.0);
        for limit in self.limits.iter_mut().filter(|l| is_idle(l)) {
            *limit = limit.idle();
        }
    }
}

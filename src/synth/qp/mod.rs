//! Convex programs of `splineqp`, with limits and equalities named as in a scene.

mod demand;
mod meaning;
pub mod sizes;

use crate::criterion::Criterion;

pub use demand::{Demand, Given};
pub use meaning::{Meaning, structural};
pub use sizes::{FACE_END, LOWEST, OFFSET, RADIUS, RISE, SIZES};
pub use splineqp::{
    Basis, ByVariable, Certificate, Entries, LeftSide, MeanSquare, PEAK, PROVED, Quadratic, Stop,
    TOLERANCE, Values, Variable, apply, certificate, only, solve_equalities,
};

/// Type parameters of a program, with limits and equalities named as in a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OfScene;

impl splineqp::Names for OfScene {
    type Limit = Criterion;
    type Equality = Demand;
    type Meaning = Meaning;
}

pub type Program = splineqp::Program<OfScene>;
pub type Limit = splineqp::Limit<OfScene>;
pub type RmsLimit = splineqp::RmsLimit<OfScene>;
pub type Row = splineqp::Row<OfScene>;
pub type Equality = splineqp::Equality<OfScene>;
pub type Solution = splineqp::Solution<OfScene>;
pub type Failure = splineqp::Failure<OfScene>;

/// Jerk, in units of the typical lift per rad³. If the size is minimised, the mean square of this jerk has the same cost as a radius of one
/// typical lift. The value is so large that the smoothing does not affect the size, and small enough that the law is still smooth.
const SIZE_JERK: f64 = 1e3;

/// Weight μ of the term ½ μ mean(j²), with the jerk j, which keeps the law of the smallest cam smooth. `length` is the typical lift, m.
/// `cost` is the cost of a radius of one typical lift.
pub fn smoothing(cost: f64, length: f64) -> f64 {
    let unit = SIZE_JERK * length;
    cost / (unit * unit)
}

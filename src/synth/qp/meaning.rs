//! Relation between the bound of a limit in a program and the value of this limit in the scene.

use super::{LeftSide, Limit};
use crate::criterion::Criterion;

/// Relation between the bound of a limit and its value in the scene.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Meaning {
    /// The bound does not come from a value of the scene. Examples are the base circle, a monotone flank and a minimised peak.
    #[default]
    Structure,
    /// The value of the scene is factor·bound + offset.
    Value {
        /// Factor of the bound.
        factor: f64,
        /// Offset of the value.
        offset: f64,
    },
    /// The value of the scene is factor·bound². The bound limits a root mean square, and the value is proportional to the mean square.
    Square {
        /// Factor of the squared bound.
        factor: f64,
    },
    /// The limit contains the size as a variable, and its bound is not a value of the scene.
    Sized,
    /// A pressure-angle limit that contains the size as a variable. The angle determines the weights of the limit, not its bound.
    PressureAngle,
    /// A limit on the distance of a roller centre or a face from the cam centre, measured along the motion. The value of the scene is the
    /// diameter of the finished cam, 2 (√(bound² + offset²) − radius).
    Diameter {
        /// Offset of the follower, m.
        offset: f64,
        /// Radius of the roller, m; 0 for a face.
        radius: f64,
    },
    /// A pressure-angle limit for a given prime circle, with bound = tan·D ± e, where D is the height of the roller centre and e the offset.
    /// The value of the scene is the prime radius.
    PrimeRadius {
        /// Tangent of the permitted angle.
        tan: f64,
        /// Offset of the follower, m, with the sign that it has in the bound.
        offset: f64,
    },
}

impl Meaning {
    /// Relation in which the value of the scene is factor·bound.
    pub fn times(factor: f64) -> Meaning {
        Meaning::Value {
            factor,
            offset: 0.0,
        }
    }

    /// Value of the scene that corresponds to a bound; `None` if the bound is not related to such a value.
    pub fn value(self, bound: f64) -> Option<f64> {
        match self {
            Meaning::Structure | Meaning::Sized | Meaning::PressureAngle => None,
            Meaning::Diameter { offset, radius } => {
                Some(2.0 * (libm::hypot(bound, offset) - radius))
            }
            Meaning::Value { factor, offset } => Some(factor * bound + offset),
            Meaning::Square { factor } => Some(factor * bound * bound),
            Meaning::PrimeRadius { tan, offset } => {
                Some(libm::hypot((bound - offset) / tan, offset))
            }
        }
    }

    /// Derivative |d value / d bound|. A multiplier per unit of the bound, divided by this derivative, is a multiplier per unit of the
    /// value.
    pub fn slope(self, bound: f64) -> f64 {
        match self {
            Meaning::Structure | Meaning::Sized | Meaning::PressureAngle => 1.0,
            Meaning::Diameter { offset, .. } => 2.0 * (bound / libm::hypot(bound, offset)).abs(),
            Meaning::Value { factor, .. } => factor.abs(),
            Meaning::Square { factor } => 2.0 * (factor * bound).abs(),
            Meaning::PrimeRadius { tan, offset } => {
                let rise = (bound - offset) / tan;
                (rise / libm::hypot(rise, offset)).abs() / tan
            }
        }
    }

    /// Attaches this relation to a limit. A bound that is not a value of the scene is enforced without a margin, because a dwell may lie on the
    /// base circle.
    pub fn of(self, limit: Limit) -> Limit {
        Limit {
            meaning: self,
            has_room: self != Meaning::Structure,
            ..limit
        }
    }
}

/// A limit whose bound is not related to a value of the scene. [`Meaning::of`] adds a relation.
pub fn structural(
    name: impl Into<Criterion>,
    side: impl Into<LeftSide>,
    bound: f64,
    scale: f64,
) -> Limit {
    Limit::on(name, side).at_most(bound).scaled(scale).exact()
}

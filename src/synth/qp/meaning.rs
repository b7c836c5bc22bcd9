//! Relation of the bounds of a cam's program to the scene.

use super::{LeftSide, Limit};
use crate::criterion::Criterion;

/// Relation of a bound to the value of the scene.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Meaning {
    /// The bound is not a value of the scene: the base circle, a monotone flank, the objective.
    #[default]
    Structure,
    /// The value of the scene is factor·bound + offset.
    Value {
        /// Factor of the bound.
        factor: f64,
        /// Offset of the value.
        offset: f64,
    },
    /// The value of the scene is factor·bound²: a mean square whose root is limited.
    Square {
        /// Factor of the squared bound.
        factor: f64,
    },
    /// A limit with the size among the variables. Its bound is not a value of the scene.
    Sized,
    /// A pressure-angle limit with the size among the variables: its angle is in the weights, not in the bound.
    PressureAngle,
    /// A limit on the distance of a roller centre or face from the cam centre along the motion. The value is the diameter of the finished cam:
    /// 2 (√(bound² + offset²) − radius).
    Diameter {
        /// Offset of the follower, m.
        offset: f64,
        /// Radius of the roller, m; 0 for a face.
        radius: f64,
    },
    /// A pressure-angle limit for a given prime circle: bound = tan·D ± e. Its value is the prime radius.
    PrimeRadius {
        /// Tangent of the permitted angle.
        tan: f64,
        /// Offset of the follower with its sign in the bound, m.
        offset: f64,
    },
}

impl Meaning {
    /// The value of the scene is the bound times a factor.
    pub fn times(factor: f64) -> Meaning {
        Meaning::Value {
            factor,
            offset: 0.0,
        }
    }

    /// Value of the scene for a bound; `None` if the bound is not such a value.
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

    /// Derivative |d value / d bound|, to convert multipliers.
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

    /// Attaches this relation to a limit. A bound that is not a value of the scene has no margin, because a dwell lies on the base circle.
    pub fn of(self, limit: Limit) -> Limit {
        Limit {
            meaning: self,
            has_room: self != Meaning::Structure,
            ..limit
        }
    }
}

/// A limit whose bound is not a value of the scene, until a [`Meaning`] is attached.
pub fn structural(
    name: impl Into<Criterion>,
    side: impl Into<LeftSide>,
    bound: f64,
    scale: f64,
) -> Limit {
    Limit::on(name, side).at_most(bound).scaled(scale).exact()
}

//! Conditions on the law. They serve as names of the equalities of a program.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// Condition on the law: an entry of the scene, or contact with the base circle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Demand {
    /// A value that is prescribed at a point of the law.
    AtPoint {
        /// Position of the entry in the scene, counted from 1.
        point: usize,
        /// Cam angle of the point.
        at: Quantity,
        /// Quantity that is prescribed at the point.
        given: Given,
    },
    /// A constant lift that is prescribed in a dwell.
    InDwell {
        /// Position of the entry in the scene, counted from 1.
        dwell: usize,
    },
    /// Contact with the base circle at one angle, where the lift is zero.
    OnBaseCircle,
}

/// Kind of quantity that a point of the law prescribes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, VariantNames, strum::IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)]
pub enum Given {
    Lift,
    Velocity,
    Acceleration,
    Jerk,
    Force,
}

impl Demand {
    /// Name of the condition in `summary.json`, which contains the position of its entry in the scene.
    pub fn name(self) -> String {
        match self {
            Demand::AtPoint { point, at, given } => {
                let (at, given) = (at.value.to_degrees(), <&str>::from(given));
                format!("law.point[{point}] at {at:.2}°: {given}")
            }
            Demand::InDwell { dwell } => format!("law.dwell[{dwell}]"),
            Demand::OnBaseCircle => "base circle".to_string(),
        }
    }
}

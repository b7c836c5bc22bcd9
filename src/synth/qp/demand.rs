//! What an equality of a program demands of the law.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// One demand on the law, as its scene writes it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Demand {
    /// A value at a point of the law.
    AtPoint {
        /// Position of the entry in the scene, counted from 1.
        point: usize,
        /// Cam angle of the prescribed point.
        at: Quantity,
        /// What is given there.
        given: Given,
    },
    /// A dwell.
    InDwell {
        /// Position of the entry in the scene, counted from 1.
        dwell: usize,
    },
    /// The law stands on its base circle somewhere.
    OnBaseCircle,
}

/// What a point of a law gives.
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
    /// Its name in `summary.json`: where it stands in the scene.
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

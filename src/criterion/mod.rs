//! Criteria of a cam, for checks, active limits and suggested changes.

mod facts;
mod limit_kind;

pub(crate) use facts::{DependsOn, LimitFacts, Lines, Severity};
pub use facts::{Diagram, Direction};
pub use limit_kind::LimitKind;

use std::fmt;

use serde::{Serialize, Serializer};

/// Subject of a check, an active limit or a suggested change.
///
/// ```
/// use gaitcam::criterion::{Criterion, LimitKind};
///
/// assert_eq!(Criterion::from(LimitKind::PressureAngleRise).name(), "pressure_angle_rise");
/// assert_eq!(Criterion::Limit(LimitKind::Curvature).of_second_cam().name(), "second_curvature");
/// assert!(Criterion::Concave != LimitKind::Curvature);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, strum::EnumCount)]
#[non_exhaustive]
pub enum Criterion {
    /// A limit of the scene.
    Limit(LimitKind),
    /// Root mean square of the force error.
    RmsError,
    /// Permitted RMS force error as a fraction of the mean force, as given by the key `accuracy.rms`.
    Accuracy,
    /// The force is inside the band around the target force.
    Band,
    /// The lift is nowhere below the base circle.
    BaseCircle,
    /// Diameter of the bore, m. It limits the size of the base circle from below.
    Bore,
    /// The base circle stays outside the bore and its keyway.
    BaseOutsideBore,
    /// Base radius given in the scene, m.
    BaseRadius,
    /// Prime radius given in the scene, m.
    GivenPrimeRadius,
    /// Shaft inertia given in the scene, kg·m².
    Inertia,
    /// The roller fits the concave parts of the profile.
    Concave,
    /// The follower does not interfere with the cam away from the contact.
    Interference,
    /// Convex radius of the upper wall of a groove.
    UpperWall,
    /// Convex radius of the lower wall of a groove.
    LowerWall,
    /// Requirement that the lift between two points of the law only rises or only falls.
    Monotone,
    /// Maximum of the quantity that a minimax objective minimises.
    Peak,
    /// Diameter of the second cam of a pair.
    SecondDiameter,
    /// Minimum convex radius of the second cam of a pair.
    SecondCurvature,
    /// The roller fits the concave parts of the second cam.
    SecondConcave,
    /// The follower does not interfere with the second cam away from the contact.
    SecondInterference,
    /// Pressure angle of the second cam where its follower rises.
    SecondPressureAngleRise,
    /// Pressure angle of the second cam where its follower falls.
    SecondPressureAngleFall,
}

impl Criterion {
    /// Name of the criterion in `summary.json`. For a value given in the scene, it is the key of this value.
    pub fn name(self) -> &'static str {
        match self {
            Criterion::Limit(kind) => kind.name(),
            Criterion::RmsError => "rms_error",
            Criterion::Accuracy => "accuracy.rms",
            Criterion::Band => "band",
            Criterion::BaseCircle => "base_circle",
            Criterion::Bore => "bore",
            Criterion::BaseOutsideBore => "base_outside_bore",
            Criterion::BaseRadius => "cam.base_radius",
            Criterion::GivenPrimeRadius => "cam.prime_radius",
            Criterion::Inertia => "machine.inertia",
            Criterion::Concave => "concave",
            Criterion::Interference => "interference",
            Criterion::UpperWall => "upper_wall",
            Criterion::LowerWall => "lower_wall",
            Criterion::Monotone => "monotone",
            Criterion::Peak => "peak",
            Criterion::SecondDiameter => "second_diameter",
            Criterion::SecondCurvature => "second_curvature",
            Criterion::SecondConcave => "second_concave",
            Criterion::SecondInterference => "second_interference",
            Criterion::SecondPressureAngleRise => "second_pressure_angle_rise",
            Criterion::SecondPressureAngleFall => "second_pressure_angle_fall",
        }
    }

    /// The corresponding criterion for the second cam of a pair. Criteria that a second cam does not have are returned unchanged.
    #[must_use]
    pub fn of_second_cam(self) -> Criterion {
        match self {
            Criterion::Limit(LimitKind::Diameter) => Criterion::SecondDiameter,
            Criterion::Limit(LimitKind::Curvature) => Criterion::SecondCurvature,
            Criterion::Limit(LimitKind::PressureAngleRise) => Criterion::SecondPressureAngleRise,
            Criterion::Limit(LimitKind::PressureAngleFall) => Criterion::SecondPressureAngleFall,
            Criterion::Concave => Criterion::SecondConcave,
            Criterion::Interference => Criterion::SecondInterference,
            other => other,
        }
    }

    /// Side of the bound on which values are permitted.
    pub fn direction(self) -> Direction {
        match self {
            Criterion::Limit(kind) => kind.facts().direction,
            Criterion::RmsError
            | Criterion::Accuracy
            | Criterion::Band
            | Criterion::Bore
            | Criterion::BaseRadius
            | Criterion::GivenPrimeRadius
            | Criterion::Interference
            | Criterion::SecondInterference
            | Criterion::SecondDiameter
            | Criterion::SecondPressureAngleRise
            | Criterion::SecondPressureAngleFall
            | Criterion::Peak => Direction::AtMost,
            Criterion::BaseCircle
            | Criterion::BaseOutsideBore
            | Criterion::Inertia
            | Criterion::Concave
            | Criterion::SecondConcave
            | Criterion::SecondCurvature
            | Criterion::UpperWall
            | Criterion::LowerWall
            | Criterion::Monotone => Direction::AtLeast,
        }
    }

    /// Severity of a failed check, which determines the order of the reasons for a verdict.
    pub fn severity(self) -> Severity {
        match self {
            Criterion::Limit(kind) => kind.facts().severity,
            Criterion::SecondCurvature
            | Criterion::Concave
            | Criterion::SecondConcave
            | Criterion::UpperWall
            | Criterion::LowerWall => Severity::Profile,
            Criterion::Interference | Criterion::SecondInterference | Criterion::BaseCircle => {
                Severity::Interference
            }
            Criterion::SecondPressureAngleRise | Criterion::SecondPressureAngleFall => {
                Severity::PressureAngle
            }
            Criterion::RmsError | Criterion::Band => Severity::ForceError,
            Criterion::Accuracy
            | Criterion::Bore
            | Criterion::BaseOutsideBore
            | Criterion::BaseRadius
            | Criterion::GivenPrimeRadius
            | Criterion::Inertia
            | Criterion::SecondDiameter
            | Criterion::Monotone
            | Criterion::Peak => Severity::Limit,
        }
    }

    /// Whether the criterion limits the pressure angle of the cam or of its conjugate cam.
    pub fn is_pressure_angle(self) -> bool {
        self.severity() == Severity::PressureAngle
    }

    /// The limit of the scene to which this criterion refers; `None` for other criteria.
    pub fn limit(self) -> Option<LimitKind> {
        match self {
            Criterion::Limit(kind) => Some(kind),
            _ => None,
        }
    }
}

impl From<LimitKind> for Criterion {
    fn from(kind: LimitKind) -> Criterion {
        Criterion::Limit(kind)
    }
}

impl PartialEq<LimitKind> for Criterion {
    fn eq(&self, kind: &LimitKind) -> bool {
        self.limit() == Some(*kind)
    }
}

impl fmt::Display for Criterion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl Serialize for Criterion {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

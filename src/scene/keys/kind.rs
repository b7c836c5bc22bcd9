//! Type of a key: kind of value, range, dimension, and direction in which the key may be relaxed.

use serde::Serialize;

use crate::cam::Measures;
use crate::units::Dimension;

/// Dimension of a number. It depends on the kind of follower and cam.
///
/// ```
/// use gaitcam::cam::Measures;
/// use gaitcam::scene::keys;
/// use gaitcam::units::Dimension;
///
/// // The stroke of an arm is an angle.
/// let stroke = keys::find("limits.stroke").unwrap().measure().unwrap();
/// assert_eq!(stroke.of(Measures::Oscillating), Dimension::Angle);
/// assert_eq!(stroke.of(Measures::Translating), Dimension::Length);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Measure {
    /// Dimension for translating followers.
    pub translating: Dimension,
    /// Dimension for oscillating followers.
    pub oscillating: Dimension,
    /// Dimension for cams that translate.
    pub straight: Dimension,
}

impl Measure {
    /// Creates a measure with the same dimension for every kind of follower and cam.
    pub const fn same(dimension: Dimension) -> Measure {
        Measure::by_arm(dimension, dimension)
    }

    /// Creates a measure with the dimension `arm` for followers on an arm, and the dimension `other` for all other followers.
    pub const fn by_arm(other: Dimension, arm: Dimension) -> Measure {
        Measure {
            translating: other,
            oscillating: arm,
            straight: other,
        }
    }

    /// Dimension for a kind of motion of follower and cam.
    pub fn of(self, measures: Measures) -> Dimension {
        match measures {
            Measures::Translating => self.translating,
            Measures::Oscillating => self.oscillating,
            Measures::Straight => self.straight,
        }
    }

    /// Distinct dimensions for all kinds of motion of follower and cam.
    pub fn each(self) -> Vec<Dimension> {
        let mut all = vec![self.translating];
        for next in [self.oscillating, self.straight] {
            if !all.contains(&next) {
                all.push(next);
            }
        }
        all
    }
}

/// Kind of value that a key accepts.
///
/// ```
/// use gaitcam::scene::keys::{self, Kind};
///
/// assert!(matches!(keys::find("law.degree").unwrap().kind, Kind::Count(..)));
/// assert!(matches!(keys::find("law.monotone").unwrap().kind, Kind::Flag));
/// ```
#[derive(Debug, Clone, Copy, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Kind {
    /// A number with its unit.
    Number(Measure),
    /// A number with its unit, or the given word instead.
    #[strum(serialize = "number-or-word")]
    NumberOr(Measure, &'static str),
    /// A number with its unit, or several numbers: a range such as `1.4 Hz:2.4 Hz:11`, or a distribution such as `normal 1.87 Hz 0.19 Hz`.
    #[strum(serialize = "number")]
    NumberOrSeveral(Measure),
    /// A whole number between the given minimum and maximum, both included.
    Count(usize, usize),
    /// One word of a closed set, which the function returns.
    Choice(fn() -> Vec<&'static str>),
    /// A Boolean value, `true` or `false`.
    Flag,
    /// A text of any content.
    Text,
    /// A text or a list of texts.
    Texts,
}

/// Permitted range of a numeric key, in SI units.
///
/// ```
/// use gaitcam::scene::keys::{self, Range};
///
/// let restitution = keys::find("machine.restitution").unwrap();
/// assert_eq!(restitution.range, Range::Between(0.0, 1.0));
/// assert!(restitution.range.contains(0.3) && !restitution.range.contains(1.3));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Range {
    /// Every finite number.
    Any,
    /// Numbers above zero.
    Positive,
    /// Zero and positive numbers.
    NotNegative,
    /// Numbers between the given minimum and maximum, both included.
    Between(f64, f64),
    /// Angles above 0 and below 90°, in rad.
    Acute,
}

impl Range {
    /// Whether a number, in SI units, is within the range.
    pub fn contains(self, x: f64) -> bool {
        x.is_finite()
            && match self {
                Range::Any => true,
                Range::Positive => x > 0.0,
                Range::NotNegative => x >= 0.0,
                Range::Between(low, high) => (low..=high).contains(&x),
                Range::Acute => x > 0.0 && x < std::f64::consts::FRAC_PI_2,
            }
    }
}

/// Direction in which the number of a key may be changed to relax its condition.
///
/// ```
/// use gaitcam::scene::keys::{self, Relax};
///
/// // A larger stroke relaxes the limit, and so does a smaller radius of curvature.
/// assert_eq!(keys::find("limits.stroke").unwrap().relax, Some(Relax::Up));
/// assert_eq!(keys::find("limits.curvature").unwrap().relax, Some(Relax::Down));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Relax {
    /// A larger number is less restrictive.
    Up,
    /// A smaller number is less restrictive.
    Down,
}

/// Reason for which a given key has no effect in a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, strum::IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
#[strum(serialize_all = "kebab-case")]
pub enum Idle {
    /// The family of the law does not use the key.
    Family,
    /// The follower of the scene does not use the key.
    Follower,
    /// The drive does not use the key.
    Drive,
    /// The scene has no target force.
    NoForce,
    /// The force comes from a recording.
    Recording,
    /// The force comes from a load model.
    Model,
    /// The follower is rigid: neither its stiffness nor its natural frequency is given.
    RigidFollower,
    /// The shaft has no motor.
    NoMotor,
    /// The law has no dwell.
    NoDwell,
    /// The floor is rigid.
    StiffFloor,
}

impl Idle {
    /// Name of the reason in machine-readable data.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

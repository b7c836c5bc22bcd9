//! Type of a key: kind of value, range, dimension, and direction of relaxation.

use serde::Serialize;

use crate::cam::Measures;
use crate::units::Dimension;

/// Dimension of a number, depending on the kind of follower.
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
    /// Dimension for translating cams.
    pub straight: Dimension,
}

impl Measure {
    /// Measure with one dimension for every follower.
    pub const fn same(dimension: Dimension) -> Measure {
        Measure::by_arm(dimension, dimension)
    }

    /// One dimension for followers on an arm, another one for all others.
    pub const fn by_arm(other: Dimension, arm: Dimension) -> Measure {
        Measure {
            translating: other,
            oscillating: arm,
            straight: other,
        }
    }

    /// Dimension for a kind of follower.
    pub fn of(self, measures: Measures) -> Dimension {
        match measures {
            Measures::Translating => self.translating,
            Measures::Oscillating => self.oscillating,
            Measures::Straight => self.straight,
        }
    }

    /// Distinct dimensions over all followers.
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

/// Kind of value of a key.
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
    /// A number with its unit, or the given word.
    #[strum(serialize = "number-or-word")]
    NumberOr(Measure, &'static str),
    /// A number with its unit, or several numbers: `1.4 Hz:2.4 Hz:11`, `normal 1.87 Hz 0.19 Hz`.
    #[strum(serialize = "number")]
    NumberOrSeveral(Measure),
    /// A whole number from the first to the last.
    Count(usize, usize),
    /// One of several words.
    Choice(fn() -> Vec<&'static str>),
    /// A truth value, `true` or `false`.
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
    /// Numbers greater than zero.
    Positive,
    /// Zero or positive numbers.
    NotNegative,
    /// Numbers from the first to the last.
    Between(f64, f64),
    /// Angles above 0 and below 90°.
    Acute,
}

impl Range {
    /// Whether a number is inside the range.
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

/// Direction in which a change of the number relaxes the limit.
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
    /// A larger value is less restrictive.
    Up,
    /// A smaller value is less restrictive.
    Down,
}

/// Reason why a given key has no effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, strum::IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
#[strum(serialize_all = "kebab-case")]
pub enum Idle {
    /// The law's family does not use the key.
    Family,
    /// The kind of follower does not use the key.
    Follower,
    /// The drive does not use the key.
    Drive,
    /// The scene has no target force.
    NoForce,
    /// The force comes from a recording.
    Recording,
    /// The force comes from a load model.
    Model,
    /// The follower is rigid: neither stiffness nor natural frequency is given.
    RigidFollower,
    /// The shaft has no motor.
    NoMotor,
    /// The law has no dwell.
    NoDwell,
    /// The floor is rigid.
    StiffFloor,
}

impl Idle {
    /// Name of the reason in data.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

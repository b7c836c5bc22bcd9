//! Limits of a cam, in a table with one row for each limit and its properties.

use serde::Serialize;

use super::{Criterion, DependsOn, Diagram, Direction, LimitFacts, Lines, Severity};

/// Kind of limit in a scene.
///
/// ```
/// use gaitcam::criterion::LimitKind;
///
/// assert_eq!(LimitKind::named("hertz_pressure"), Some(LimitKind::HertzPressure));
/// assert!(LimitKind::ALL.contains(&LimitKind::Power));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
#[derive(strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[strum(serialize_all = "snake_case")]
#[non_exhaustive]
pub enum LimitKind {
    /// Maximum stroke of the follower, m (rad for an arm).
    Stroke,
    /// Maximum |velocity| with respect to time, m/s (rad/s for an arm).
    Velocity,
    /// Maximum |acceleration| with respect to time, m/s² (rad/s² for an arm).
    Acceleration,
    /// Maximum |jerk| with respect to time, m/s³ (rad/s³ for an arm).
    Jerk,
    /// Minimum contact force over the turn, N (N·m for an arm).
    ForceMin,
    /// Maximum contact force over the turn, N (N·m for an arm).
    ForceMax,
    /// Minimum convex radius of curvature of the finished cam, m.
    Curvature,
    /// Maximum |pressure angle|, rad, with the same value for rise and fall.
    PressureAngle,
    /// Maximum |pressure angle| where the follower rises, rad.
    PressureAngleRise,
    /// Maximum |pressure angle| where the follower falls, rad.
    PressureAngleFall,
    /// Maximum prime radius, m. For a flat face it is the base radius.
    PrimeRadius,
    /// Maximum diameter of the finished cam, m.
    Diameter,
    /// Maximum length of a flat face, m.
    FaceWidth,
    /// Maximum |torque| of the shaft without friction, N·m.
    Torque,
    /// Maximum |power| of the shaft without friction, W, for driving or braking.
    Power,
    /// Maximum mean power of the shaft without friction, W. Damping dissipates this power.
    PowerMean,
    /// Maximum |rate of change| of the shaft torque with respect to the cam angle, N·m/rad.
    TorqueRate,
    /// Maximum Hertz pressure of the line contact, Pa.
    HertzPressure,
    /// Maximum amplitude of the residual vibration in a dwell, m (rad for an arm).
    Residual,
}

impl LimitKind {
    /// All limits, in the order of the key table.
    pub const ALL: &'static [LimitKind] = <LimitKind as strum::VariantArray>::VARIANTS;

    /// Name of the limit among the checks in `summary.json`. It is the last word of the key of the limit, such as `stroke` for
    /// `limits.stroke`.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// The limit with this name; `None` for an unknown name.
    pub fn named(name: &str) -> Option<LimitKind> {
        name.parse().ok()
    }

    /// Whether a check of a design measures this limit. A common pressure-angle limit is measured by the check of the rise and by the check
    /// of the fall.
    pub fn is_measured_by(self, check: Criterion) -> bool {
        let side =
            [LimitKind::PressureAngleRise, LimitKind::PressureAngleFall].map(Criterion::Limit);
        check == self || self == LimitKind::PressureAngle && side.contains(&check)
    }

    /// Properties of the limit: direction, dependence on speed and walker, diagram, severity.
    #[rustfmt::skip]
    pub const fn facts(self) -> LimitFacts {
        use DependsOn::{Cam, Force, Load, Motion, Vibration};
        use Direction::{AtLeast, AtMost};
        use Lines::{AboveLowest, AtBound, AtNegative, BothSides};
        use Severity::{Contact, Limit, PressureAngle, Profile};
        match self {
            //                                                direction depends on moves  diagram                                    severity
            LimitKind::Stroke            => LimitFacts::row(AtMost,  Cam,       true,  Some((Diagram::Lift, AboveLowest)),        Limit),
            LimitKind::Velocity          => LimitFacts::row(AtMost,  Motion(1), true,  Some((Diagram::Velocity, BothSides)),      Limit),
            LimitKind::Acceleration      => LimitFacts::row(AtMost,  Motion(2), true,  Some((Diagram::Acceleration, BothSides)),  Limit),
            LimitKind::Jerk              => LimitFacts::row(AtMost,  Motion(3), true,  Some((Diagram::Jerk, BothSides)),          Limit),
            LimitKind::ForceMin          => LimitFacts::row(AtLeast, Force,     false, Some((Diagram::Force, AtBound)),           Contact),
            LimitKind::ForceMax          => LimitFacts::row(AtMost,  Force,     false, Some((Diagram::Force, AtBound)),           Limit),
            LimitKind::Curvature         => LimitFacts::row(AtLeast, Cam,       true,  Some((Diagram::Radius, AtBound)),          Profile),
            LimitKind::PressureAngle     => LimitFacts::row(AtMost,  Cam,       true,  Some((Diagram::PressureAngle, BothSides)), PressureAngle),
            LimitKind::PressureAngleRise => LimitFacts::row(AtMost,  Cam,       true,  Some((Diagram::PressureAngle, AtBound)),   PressureAngle),
            LimitKind::PressureAngleFall => LimitFacts::row(AtMost,  Cam,       true,  Some((Diagram::PressureAngle, AtNegative)), PressureAngle),
            LimitKind::PrimeRadius       => LimitFacts::row(AtMost,  Cam,       true,  None,                                      Limit),
            LimitKind::Diameter          => LimitFacts::row(AtMost,  Cam,       true,  None,                                      Limit),
            LimitKind::FaceWidth         => LimitFacts::row(AtMost,  Cam,       false, Some((Diagram::Contact, AboveLowest)),     Limit),
            LimitKind::Torque            => LimitFacts::row(AtMost,  Load,      true,  Some((Diagram::Torque, BothSides)),        Limit),
            LimitKind::Power             => LimitFacts::row(AtMost,  Load,      true,  Some((Diagram::Power, BothSides)),         Limit),
            LimitKind::PowerMean         => LimitFacts::row(AtMost,  Load,      true,  None,                                      Limit),
            LimitKind::TorqueRate        => LimitFacts::row(AtMost,  Load,      true,  None,                                      Limit),
            LimitKind::HertzPressure     => LimitFacts::row(AtMost,  Load,      true,  None,                                      Limit),
            LimitKind::Residual          => LimitFacts::row(AtMost,  Vibration, false, None,                                      Limit),
        }
    }

    /// Limits on time derivatives of the lift, with the order of the derivative.
    pub fn by_time() -> impl Iterator<Item = (LimitKind, usize)> {
        let order = |kind: &LimitKind| match kind.facts().depends_on {
            DependsOn::Motion(order) => Some((*kind, order)),
            _ => None,
        };
        LimitKind::ALL.iter().filter_map(order)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limits_by_time_are_those_of_three_derivatives() {
        let orders: Vec<usize> = LimitKind::by_time().map(|limit| limit.1).collect();
        assert_eq!(orders, [1, 2, 3]);
    }
}

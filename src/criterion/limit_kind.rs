//! The limits that may be set for a cam.

use serde::Serialize;

use super::Criterion;

/// Every limit that a scene may set.
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
    /// Largest stroke.
    Stroke,
    /// Largest velocity by time.
    Velocity,
    /// Largest acceleration by time.
    Acceleration,
    /// Largest jerk by time.
    Jerk,
    /// Smallest force.
    ForceMin,
    /// Largest force.
    ForceMax,
    /// Smallest convex radius of curvature.
    Curvature,
    /// Largest |pressure angle|, where one value limits rise and fall.
    PressureAngle,
    /// Largest |pressure angle| where the follower rises.
    PressureAngleRise,
    /// Largest |pressure angle| where the follower falls.
    PressureAngleFall,
    /// Largest prime radius.
    PrimeRadius,
    /// Longest flat face.
    FaceWidth,
    /// Largest shaft torque.
    Torque,
    /// Largest shaft power.
    Power,
    /// Largest rate of the shaft torque.
    TorqueRate,
    /// Largest contact pressure.
    HertzPressure,
    /// Largest amplitude in a dwell.
    Residual,
}

impl LimitKind {
    /// All of them, in the order of the key table.
    pub const ALL: &'static [LimitKind] = <LimitKind as strum::VariantArray>::VARIANTS;

    /// Its name among the checks of a summary: the last word of its key.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// The limit of that name.
    pub fn named(name: &str) -> Option<LimitKind> {
        name.parse().ok()
    }

    /// Whether a check of a design measures it. One value for both pressure angles is measured on rise and fall.
    pub fn is_measured_by(self, check: Criterion) -> bool {
        let side =
            [LimitKind::PressureAngleRise, LimitKind::PressureAngleFall].map(Criterion::Limit);
        check == self || self == LimitKind::PressureAngle && side.contains(&check)
    }
}

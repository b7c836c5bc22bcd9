//! `[limits]`: what must not be exceeded.

use crate::cam::LimitKind;

/// What must not be exceeded; `None` = no limit. SI.
///
/// ```
/// use gaitcam::{LimitKind, Limits};
///
/// let limits = Limits::default().with(LimitKind::Stroke, 0.04).with(LimitKind::PressureAngle, 0.5);
/// assert_eq!(limits.stroke, Some(0.04));
/// assert_eq!((limits.pressure_angle_rise, limits.pressure_angle_fall), (Some(0.5), Some(0.5)));
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Limits {
    /// Largest stroke, m (or rad).
    pub stroke: Option<f64>,
    /// Largest |ds/dt|, m/s.
    pub velocity: Option<f64>,
    /// Largest |d²s/dt²|, m/s².
    pub acceleration: Option<f64>,
    /// Largest |d³s/dt³|, m/s³.
    pub jerk: Option<f64>,
    /// Largest pressure angle on the positive side, rad.
    pub pressure_angle_rise: Option<f64>,
    /// Largest pressure angle on the negative side, rad.
    pub pressure_angle_fall: Option<f64>,
    /// Smallest convex radius of the finished cam, m.
    pub curvature: Option<f64>,
    /// Largest prime radius (base radius of a flat-faced cam), m, where the size is not fixed.
    pub prime_radius: Option<f64>,
    /// Smallest force, N.
    pub force_min: Option<f64>,
    /// Largest force, N.
    pub force_max: Option<f64>,
    /// Longest flat face, m.
    pub face_width: Option<f64>,
    /// Largest shaft torque without friction, N·m.
    pub torque: Option<f64>,
    /// Largest shaft power without friction, W.
    pub power: Option<f64>,
    /// Largest rate of that torque by the cam angle, N·m/rad.
    pub torque_rate: Option<f64>,
    /// Largest line pressure between cam and follower, steel on steel over the plate's thickness, Pa.
    pub hertz_pressure: Option<f64>,
    /// Largest amplitude of the residual vibration of the follower in a dwell, m.
    pub residual: Option<f64>,
    /// What is not judged by the bound that is usual where the scene gives none.
    pub unjudged: Unjudged,
}

/// Bounds of the verdict that a scene switches off with `"none"`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Unjudged {
    /// `limits.pressure_angle = "none"`.
    pub pressure_angle: bool,
    /// `limits.force_min = "none"`.
    pub contact_force: bool,
    /// `accuracy.rms = "none"`.
    pub accuracy: bool,
}

impl Unjudged {
    /// The keys that say `"none"`.
    pub fn keys(self) -> Vec<&'static str> {
        let all = [
            ("limits.pressure_angle", self.pressure_angle),
            ("limits.force_min", self.contact_force),
            ("accuracy.rms", self.accuracy),
        ];
        all.into_iter().filter(|k| k.1).map(|k| k.0).collect()
    }
}

impl Limits {
    /// Where the value of a limit stands; of one value for both pressure angles, that of the rise.
    pub fn slot(&mut self, kind: LimitKind) -> &mut Option<f64> {
        match kind {
            LimitKind::Stroke => &mut self.stroke,
            LimitKind::Velocity => &mut self.velocity,
            LimitKind::Acceleration => &mut self.acceleration,
            LimitKind::Jerk => &mut self.jerk,
            LimitKind::ForceMin => &mut self.force_min,
            LimitKind::ForceMax => &mut self.force_max,
            LimitKind::Curvature => &mut self.curvature,
            LimitKind::PressureAngle | LimitKind::PressureAngleRise => {
                &mut self.pressure_angle_rise
            }
            LimitKind::PressureAngleFall => &mut self.pressure_angle_fall,
            LimitKind::PrimeRadius => &mut self.prime_radius,
            LimitKind::FaceWidth => &mut self.face_width,
            LimitKind::Torque => &mut self.torque,
            LimitKind::Power => &mut self.power,
            LimitKind::TorqueRate => &mut self.torque_rate,
            LimitKind::HertzPressure => &mut self.hertz_pressure,
            LimitKind::Residual => &mut self.residual,
        }
    }
}

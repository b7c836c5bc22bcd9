//! The numbers of a problem that may be relaxed: limits, accuracy, sizes that were given.

use crate::problem::Problem;

/// A limit is first lifted by this factor, to see whether it is what stands in the way.
pub const AWAY: f64 = 1e4;
/// Pressure angle that is no limit any more, rad.
pub const STEEPEST: f64 = 1.55;

/// A number of the problem that may be relaxed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relaxable {
    Stroke,
    Velocity,
    Acceleration,
    Jerk,
    ForceMin,
    ForceMax,
    Curvature,
    PressureAngle,
    Rise,
    Fall,
    Bore,
    PrimeRadiusLimit,
    FaceWidth,
    Torque,
    TorqueRate,
    Hertz,
    Residual,
    Accuracy,
    PrimeRadius,
    BaseRadius,
}

pub use Relaxable::{
    Acceleration, Accuracy, BaseRadius, Bore, Curvature, FaceWidth, Fall, ForceMax, ForceMin,
    Hertz, Jerk, PressureAngle, PrimeRadius, PrimeRadiusLimit, Residual, Rise, Stroke, Torque,
    TorqueRate, Velocity,
};

/// All of them, in the order in which they are told.
pub const RELAXABLE: [Relaxable; 20] = [
    Stroke,
    Velocity,
    Acceleration,
    Jerk,
    ForceMin,
    ForceMax,
    Curvature,
    PressureAngle,
    Rise,
    Fall,
    Bore,
    PrimeRadiusLimit,
    FaceWidth,
    Torque,
    TorqueRate,
    Hertz,
    Residual,
    Accuracy,
    PrimeRadius,
    BaseRadius,
];

impl Relaxable {
    /// Name in messages and in `summary.json`: the limit's, or the scene's key where that is none.
    pub fn name(self) -> &'static str {
        match self {
            Stroke => "stroke",
            Velocity => "velocity",
            Acceleration => "acceleration",
            Jerk => "jerk",
            ForceMin => "force_min",
            ForceMax => "force_max",
            Curvature => "curvature",
            PressureAngle => "pressure_angle",
            Rise => "pressure_angle_rise",
            Fall => "pressure_angle_fall",
            Bore => "bore",
            PrimeRadiusLimit => "prime_radius",
            FaceWidth => "face_width",
            Torque => "torque",
            TorqueRate => "torque_rate",
            Hertz => "hertz_pressure",
            Residual => "residual",
            Accuracy => "accuracy.rms",
            PrimeRadius => "cam.prime_radius",
            BaseRadius => "cam.base_radius",
        }
    }

    /// Whether a check measures it.
    pub fn is_measured_by(self, check: &str) -> bool {
        match self {
            PressureAngle => check == "pressure_angle_rise" || check == "pressure_angle_fall",
            Accuracy => check == "rms_error",
            Bore | PrimeRadius | BaseRadius => false,
            _ => check == self.name(),
        }
    }

    fn slot(self, problem: &mut Problem) -> &mut Option<f64> {
        let limits = &mut problem.limits;
        match self {
            Stroke => &mut limits.stroke,
            Velocity => &mut limits.velocity,
            Acceleration => &mut limits.acceleration,
            Jerk => &mut limits.jerk,
            ForceMin => &mut limits.force_min,
            ForceMax => &mut limits.force_max,
            Curvature => &mut limits.curvature,
            PressureAngle | Rise => &mut limits.pressure_angle_rise,
            Fall => &mut limits.pressure_angle_fall,
            Bore => &mut problem.cam.bore,
            PrimeRadiusLimit => &mut limits.prime_radius,
            FaceWidth => &mut limits.face_width,
            Torque => &mut limits.torque,
            TorqueRate => &mut limits.torque_rate,
            Hertz => &mut limits.hertz_pressure,
            Residual => &mut limits.residual,
            Accuracy => &mut problem.accuracy,
            PrimeRadius => &mut problem.cam.prime_radius,
            BaseRadius => &mut problem.cam.base_radius,
        }
    }

    /// Its value, where the scene has one that can be relaxed by itself.
    pub fn value(self, problem: &Problem) -> Option<f64> {
        let both = problem.limits.pressure_angle_rise.is_some()
            && problem.limits.pressure_angle_rise == problem.limits.pressure_angle_fall;
        let told = match self {
            PressureAngle => both,
            Rise | Fall => !both,
            _ => true,
        };
        let value = *self.slot(&mut problem.clone());
        value.filter(|_| told)
    }

    /// The scene with another value.
    pub fn with(self, problem: &Problem, value: f64) -> Problem {
        let mut out = problem.clone();
        *self.slot(&mut out) = Some(value);
        if self == PressureAngle {
            out.limits.pressure_angle_fall = Some(value);
        }
        out
    }

    /// Whether a larger value is the weaker limit.
    pub fn grows(self) -> bool {
        !matches!(self, ForceMin | Curvature | Bore)
    }

    /// +1 where a larger value is the weaker limit.
    pub fn sign(self) -> f64 {
        if self.grows() { 1.0 } else { -1.0 }
    }

    /// A value that limits nothing.
    pub fn away(self, from: f64, force: f64) -> f64 {
        match self {
            PressureAngle | Rise | Fall => STEEPEST,
            Curvature => 0.0,
            Bore => from / AWAY,
            ForceMin => from - AWAY * force.max(from.abs()),
            ForceMax => from + AWAY * force.max(from.abs()),
            PrimeRadius | BaseRadius => 30.0 * from,
            _ => AWAY * from,
        }
    }

    /// Steps in which a value is told: a little on the weak side of what was found.
    pub fn rounded(self, value: f64) -> f64 {
        let step = match self {
            PressureAngle | Rise | Fall => 1e-3_f64.to_radians(),
            _ => 10_f64.powf((value.abs().max(f64::MIN_POSITIVE)).log10().floor() - 5.0),
        };
        // A value that is round already stays.
        let steps = value / step;
        step * if self.grows() {
            (steps - 1e-9).ceil()
        } else {
            (steps + 1e-9).floor()
        }
    }
}

//! Scene keys that have a unit, and how their numbers reach a scene that is already read.

use crate::scene::{Scene, Source};
use crate::units::Dimension;

/// Numbers that a key takes; anything else is left to the scene's own reader to refuse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Allowed {
    /// Any.
    Any,
    /// Above zero.
    Positive,
    /// Zero or above.
    NotNegative,
    /// An angle in (0, 90°).
    Acute,
}

/// A key whose value is a quantity.
#[derive(Debug)]
pub struct Quantity {
    /// Dotted name of the key.
    pub name: &'static str,
    /// What it measures.
    pub dimension: Dimension,
    /// The SI unit as scenes write it.
    pub unit: &'static str,
    /// The same at the end of a column's name.
    pub suffix: &'static str,
    /// Numbers it takes.
    pub allowed: Allowed,
    /// Sets it in a scene that is already read; `None` where other keys decide what it means.
    pub set: Option<fn(&mut Scene, f64)>,
}

const fn quantity(
    name: &'static str,
    dimension: Dimension,
    unit: &'static str,
    suffix: &'static str,
    allowed: Allowed,
    set: Option<fn(&mut Scene, f64)>,
) -> Quantity {
    Quantity {
        name,
        dimension,
        unit,
        suffix,
        allowed,
        set,
    }
}

/// A key that the scene's own reader judges, row by row: what it means hangs on other keys.
const fn judged(
    name: &'static str,
    dimension: Dimension,
    unit: &'static str,
    suffix: &'static str,
) -> Quantity {
    quantity(name, dimension, unit, suffix, Allowed::Any, None)
}

use Allowed::{Acute, Any, NotNegative, Positive};
use Dimension as D;

/// Every key with a unit. Two entries of one name are tried in turn: an oscillating follower's stroke is
/// an angle.
pub const QUANTITIES: &[Quantity] = &[
    quantity(
        "gait.step_frequency",
        D::Frequency,
        "Hz",
        "_hz",
        Positive,
        Some(step_frequency),
    ),
    quantity(
        "gait.body_weight",
        D::Force,
        "N",
        "_n",
        Positive,
        Some(body_weight),
    ),
    judged("gait.rate", D::Frequency, "Hz", "_hz"),
    judged("gait.mass", D::Mass, "kg", "_kg"),
    judged("gait.phase", D::Angle, "rad", "_rad"),
    judged("gait.band", D::Force, "N", "_n"),
    quantity(
        "drive.mass",
        D::Mass,
        "kg",
        "_kg",
        Positive,
        Some(|s, x| s.drive.mass = Some(x)),
    ),
    quantity(
        "drive.speed",
        D::AngularSpeed,
        "rad/s",
        "_rad_per_s",
        Positive,
        Some(|s, x| s.drive.speed = Some(x)),
    ),
    quantity(
        "drive.gravity",
        D::Acceleration,
        "m/s^2",
        "_m_per_s2",
        Positive,
        Some(|s, x| s.drive.gravity = x),
    ),
    quantity(
        "drive.pressure_per_volume",
        D::PressurePerVolume,
        "Pa/m^3",
        "_pa_per_m3",
        Positive,
        Some(|s, x| s.drive.pressure_per_volume = x),
    ),
    quantity(
        "drive.piston_radius",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.drive.piston_radius = x),
    ),
    quantity(
        "drive.spring_rate",
        D::SpringRate,
        "N/m",
        "_n_per_m",
        NotNegative,
        Some(|s, x| s.drive.spring_rate = x),
    ),
    quantity(
        "drive.preload",
        D::Force,
        "N",
        "_n",
        Any,
        Some(|s, x| s.drive.preload = x),
    ),
    quantity(
        "drive.damping",
        D::Damping,
        "N s/m",
        "_n_s_per_m",
        NotNegative,
        Some(|s, x| s.drive.damping = x),
    ),
    quantity(
        "cam.base_radius",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.cam.base_radius = Some(x)),
    ),
    quantity(
        "cam.prime_radius",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.cam.prime_radius = Some(x)),
    ),
    quantity(
        "cam.offset",
        D::Length,
        "m",
        "_m",
        Any,
        Some(|s, x| s.cam.offset = Some(x)),
    ),
    quantity(
        "cam.roller_radius",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.cam.roller_radius = x),
    ),
    quantity(
        "cam.bore",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.cam.bore = Some(x)),
    ),
    quantity(
        "cam.thickness",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.cam.thickness = x),
    ),
    judged("drive.speed", D::Speed, "m/s", "_m_per_s"),
    judged("drive.inertia", D::Inertia, "kg m^2", "_kg_m2"),
    judged(
        "drive.spring_rate",
        D::AngularRate,
        "N m/rad",
        "_n_m_per_rad",
    ),
    judged("drive.preload", D::Torque, "N m", "_n_m"),
    judged("cam.pivot_distance", D::Length, "m", "_m"),
    judged("cam.arm", D::Length, "m", "_m"),
    judged("cam.face_offset", D::Length, "m", "_m"),
    judged("cam.breadth", D::Length, "m", "_m"),
    judged("cam.travel", D::Length, "m", "_m"),
    judged("cam.depth", D::Length, "m", "_m"),
    judged("cam.roller_eccentricity", D::Length, "m", "_m"),
    judged("cam.conjugate.distance", D::Length, "m", "_m"),
    judged("cam.conjugate.angle", D::Angle, "rad", "_rad"),
    judged("cam.conjugate.base_radius", D::Length, "m", "_m"),
    judged("cam.conjugate.roller_radius", D::Length, "m", "_m"),
    judged("limits.velocity", D::AngularSpeed, "rad/s", "_rad_per_s"),
    judged(
        "limits.acceleration",
        D::AngularAcceleration,
        "rad/s^2",
        "_rad_per_s2",
    ),
    judged("limits.jerk", D::AngularJerk, "rad/s^3", "_rad_per_s3"),
    judged("limits.torque", D::Torque, "N m", "_n_m"),
    judged(
        "limits.torque_rate",
        D::AngularRate,
        "N m/rad",
        "_n_m_per_rad",
    ),
    judged("limits.hertz_pressure", D::Pressure, "Pa", "_pa"),
    judged("limits.residual", D::Length, "m", "_m"),
    judged("limits.residual", D::Angle, "rad", "_rad"),
    judged("machine.natural_frequency", D::Frequency, "Hz", "_hz"),
    judged("machine.stiffness", D::SpringRate, "N/m", "_n_per_m"),
    judged(
        "machine.stiffness",
        D::AngularRate,
        "N m/rad",
        "_n_m_per_rad",
    ),
    judged("machine.damping_ratio", D::Ratio, "", ""),
    judged("machine.friction", D::Ratio, "", ""),
    judged("machine.restitution", D::Ratio, "", ""),
    judged("machine.second_cam", D::Angle, "rad", "_rad"),
    quantity(
        "limits.stroke",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.limits.stroke = Some(x)),
    ),
    quantity(
        "limits.stroke",
        D::Angle,
        "rad",
        "_rad",
        Positive,
        Some(|s, x| s.limits.stroke = Some(x)),
    ),
    quantity(
        "limits.velocity",
        D::Speed,
        "m/s",
        "_m_per_s",
        Positive,
        Some(|s, x| s.limits.velocity = Some(x)),
    ),
    quantity(
        "limits.acceleration",
        D::Acceleration,
        "m/s^2",
        "_m_per_s2",
        Positive,
        Some(|s, x| s.limits.acceleration = Some(x)),
    ),
    quantity(
        "limits.jerk",
        D::Jerk,
        "m/s^3",
        "_m_per_s3",
        Positive,
        Some(|s, x| s.limits.jerk = Some(x)),
    ),
    quantity(
        "limits.pressure_angle",
        D::Angle,
        "rad",
        "_rad",
        Acute,
        None,
    ),
    quantity(
        "limits.pressure_angle_rise",
        D::Angle,
        "rad",
        "_rad",
        Acute,
        Some(|s, x| s.limits.pressure_angle_rise = Some(x)),
    ),
    quantity(
        "limits.pressure_angle_fall",
        D::Angle,
        "rad",
        "_rad",
        Acute,
        Some(|s, x| s.limits.pressure_angle_fall = Some(x)),
    ),
    quantity(
        "limits.curvature",
        D::Length,
        "m",
        "_m",
        NotNegative,
        Some(|s, x| s.limits.curvature = Some(x)),
    ),
    quantity(
        "limits.force_min",
        D::Force,
        "N",
        "_n",
        Any,
        Some(|s, x| s.limits.force_min = Some(x)),
    ),
    quantity(
        "limits.force_max",
        D::Force,
        "N",
        "_n",
        Any,
        Some(|s, x| s.limits.force_max = Some(x)),
    ),
    quantity(
        "limits.face_width",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.limits.face_width = Some(x)),
    ),
    quantity(
        "limits.prime_radius",
        D::Length,
        "m",
        "_m",
        Positive,
        Some(|s, x| s.limits.prime_radius = Some(x)),
    ),
    quantity(
        "accuracy.rms",
        D::Percent,
        "ratio",
        "",
        Positive,
        Some(|s, x| s.rms = Some(x)),
    ),
];

fn step_frequency(scene: &mut Scene, hz: f64) {
    if let Some(Source::Model {
        step_frequency_hz, ..
    }) = scene.gait.as_mut().map(|g| &mut g.source)
    {
        *step_frequency_hz = Some(hz);
    }
}

fn body_weight(scene: &mut Scene, newtons: f64) {
    if let Some(Source::Model { body_weight_n, .. }) = scene.gait.as_mut().map(|g| &mut g.source) {
        *body_weight_n = newtons;
    }
}

/// Keys whose values are words, counts, truth values or paths.
pub const WORDS: &[&str] = &[
    "gait.file",
    "gait.model",
    "gait.feet",
    "gait.scale",
    "gait.time",
    "gait.force",
    "gait.unit",
    "drive.kind",
    "law.family",
    "law.degree",
    "law.spans",
    "law.harmonics",
    "law.minimise",
    "law.monotone",
    "law.polydyne",
    "cam.follower",
    "cam.turns",
    "cam.pivot_beside",
];

//! Rows of `[limits]`, `[machine]` and `[accuracy]`.

use super::kind::{Idle, Kind, Measure, Range, Relax};
use super::row::{Access, Key, given, key, number, optional, plain};
use super::value::Value;
use crate::scene::{LimitKind, Limits, Scene};
use crate::units::Dimension as D;

const LIFT: Measure = Measure::by_arm(D::Length, D::Angle);
const FORCE: Measure = Measure::by_arm(D::Force, D::Torque);

/// Without anything that gives, vibration has no say.
fn rigid(scene: &Scene) -> Option<Idle> {
    let machine = &scene.machine;
    let gives = machine.natural_frequency.is_some() || machine.stiffness.is_some();
    (!gives).then_some(Idle::RigidFollower)
}

/// Only a flat face has a width and an end.
fn no_flat_face(scene: &Scene) -> Option<Idle> {
    (!scene.cam.follower.is_flat()).then_some(Idle::Follower)
}

/// The pressure angle of both sides, where it is one.
fn both_sides(limits: &Limits) -> Option<f64> {
    limits
        .pressure_angle_rise
        .filter(|_| limits.pressure_angle_rise == limits.pressure_angle_fall)
}

/// Access to a bound that `"none"` switches off together with its default.
macro_rules! switched {
    ($($flag:ident).+, $get:expr, |$scene:ident, $value:ident| $set:expr) => {
        Access {
            get: |s, _| {
                let off = s.$($flag).+.then(|| Value::Text(NONE.to_string()));
                off.or_else(|| $get(s).map(Value::Number))
            },
            set: |$scene, _, v| {
                $scene.$($flag).+ = matches!(&v, Value::Text(word) if word == NONE);
                let $value = v.number();
                $set;
                Ok(())
            },
        }
    };
}

/// The word that switches a default bound off.
const NONE: &str = "none";

pub static LIMITS: &[Key] = &[
    number(
        "limits.stroke",
        LIFT,
        Range::Positive,
        optional!(limits.stroke),
    )
    .limit(LimitKind::Stroke, Relax::Up),
    number(
        "limits.velocity",
        Measure::by_arm(D::Speed, D::AngularSpeed),
        Range::Positive,
        optional!(limits.velocity),
    )
    .limit(LimitKind::Velocity, Relax::Up),
    number(
        "limits.acceleration",
        Measure::by_arm(D::Acceleration, D::AngularAcceleration),
        Range::Positive,
        optional!(limits.acceleration),
    )
    .limit(LimitKind::Acceleration, Relax::Up),
    number(
        "limits.jerk",
        Measure::by_arm(D::Jerk, D::AngularJerk),
        Range::Positive,
        optional!(limits.jerk),
    )
    .limit(LimitKind::Jerk, Relax::Up),
    key(
        "limits.force_min",
        Kind::NumberOr(FORCE, NONE),
        Range::Any,
        switched!(
            limits.unjudged.contact_force,
            |s: &Scene| s.limits.force_min,
            |s, v| s.limits.force_min = v
        ),
    )
    .limit(LimitKind::ForceMin, Relax::Down),
    number(
        "limits.force_max",
        FORCE,
        Range::Any,
        optional!(limits.force_max),
    )
    .limit(LimitKind::ForceMax, Relax::Up),
    plain(
        "limits.curvature",
        D::Length,
        Range::NotNegative,
        optional!(limits.curvature),
    )
    .limit(LimitKind::Curvature, Relax::Down),
    key(
        "limits.pressure_angle",
        Kind::NumberOr(Measure::same(D::Angle), NONE),
        Range::Acute,
        switched!(
            limits.unjudged.pressure_angle,
            |s: &Scene| both_sides(&s.limits),
            |s, angle| {
                s.limits.pressure_angle_rise = angle;
                s.limits.pressure_angle_fall = angle;
            }
        ),
    )
    .read_again()
    .limit(LimitKind::PressureAngle, Relax::Up),
    plain(
        "limits.pressure_angle_rise",
        D::Angle,
        Range::Acute,
        Access {
            get: |s, _| match both_sides(&s.limits) {
                None => s.limits.pressure_angle_rise.map(Value::Number),
                Some(_) => None,
            },
            set: |s, _, v| {
                s.limits.pressure_angle_rise = v.number();
                Ok(())
            },
        },
    )
    .limit(LimitKind::PressureAngleRise, Relax::Up),
    plain(
        "limits.pressure_angle_fall",
        D::Angle,
        Range::Acute,
        Access {
            get: |s, _| match both_sides(&s.limits) {
                None => s.limits.pressure_angle_fall.map(Value::Number),
                Some(_) => None,
            },
            set: |s, _, v| {
                s.limits.pressure_angle_fall = v.number();
                Ok(())
            },
        },
    )
    .limit(LimitKind::PressureAngleFall, Relax::Up),
    plain(
        "limits.prime_radius",
        D::Length,
        Range::Positive,
        optional!(limits.prime_radius),
    )
    .limit(LimitKind::PrimeRadius, Relax::Up),
    plain(
        "limits.face_width",
        D::Length,
        Range::Positive,
        optional!(limits.face_width),
    )
    .limit(LimitKind::FaceWidth, Relax::Up)
    .idle_when(no_flat_face),
    plain(
        "limits.torque",
        D::Torque,
        Range::Positive,
        optional!(limits.torque),
    )
    .limit(LimitKind::Torque, Relax::Up),
    plain(
        "limits.power",
        D::Power,
        Range::Positive,
        optional!(limits.power),
    )
    .limit(LimitKind::Power, Relax::Up),
    plain(
        "limits.torque_rate",
        D::AngularRate,
        Range::Positive,
        optional!(limits.torque_rate),
    )
    .limit(LimitKind::TorqueRate, Relax::Up),
    plain(
        "limits.hertz_pressure",
        D::Pressure,
        Range::Positive,
        optional!(limits.hertz_pressure),
    )
    .limit(LimitKind::HertzPressure, Relax::Up),
    number(
        "limits.residual",
        LIFT,
        Range::Positive,
        optional!(limits.residual),
    )
    .limit(LimitKind::Residual, Relax::Up),
];

pub static REST: &[Key] = &[
    plain(
        "machine.natural_frequency",
        D::Frequency,
        Range::Positive,
        optional!(machine.natural_frequency),
    )
    .default(""),
    number(
        "machine.stiffness",
        Measure::by_arm(D::SpringRate, D::AngularRate),
        Range::Positive,
        optional!(machine.stiffness),
    )
    .default(""),
    plain(
        "machine.damping_ratio",
        D::Ratio,
        Range::NotNegative,
        given!(machine.damping_ratio),
    )
    .default("0.05")
    .idle_when(rigid),
    plain(
        "machine.friction",
        D::Ratio,
        Range::NotNegative,
        given!(machine.friction),
    )
    .default("0"),
    plain(
        "machine.restitution",
        D::Ratio,
        Range::Between(0.0, 1.0),
        given!(machine.restitution),
    )
    .default("0"),
    plain(
        "machine.second_cam",
        D::Angle,
        Range::Any,
        optional!(machine.second_cam),
    )
    .default(""),
    key(
        "accuracy.rms",
        Kind::NumberOr(Measure::same(D::Percent), NONE),
        Range::Positive,
        switched!(limits.unjudged.accuracy, |s: &Scene| s.rms, |s, share| s
            .rms =
            share),
    )
    .default("auto")
    .relax(Relax::Up)
    .idle_when(|s| s.gait.is_none().then_some(Idle::NoForce)),
];

//! Rows of `[drive]`: how lift becomes force.

use super::kind::{Idle, Kind, Measure, Range};
use super::row::{Access, Key, given, number, optional, other, plain};
use super::value::Value;
use crate::drive::DriveKind;
use crate::scene::Scene;
use crate::units::Dimension as D;

const KINDS: [DriveKind; 3] = [
    DriveKind::MovingAxis,
    DriveKind::FixedAxis,
    DriveKind::Hydraulic,
];

fn is_fixed_axis(scene: &Scene) -> bool {
    scene.drive.kind == DriveKind::FixedAxis
}

fn is_hydraulic(scene: &Scene) -> bool {
    scene.drive.kind == DriveKind::Hydraulic
}

fn has_arm(scene: &Scene) -> bool {
    scene.cam.is_oscillating()
}

pub static ROWS: &[Key] = &[
    other(
        "drive.kind",
        Kind::Choice(|| KINDS.map(DriveKind::name).to_vec()),
        Access {
            get: |s, _| Some(Value::Text(s.drive.kind.name().to_string())),
            set: |s, _, v| {
                let word = v.text();
                if let Some(kind) = KINDS.into_iter().find(|k| k.name() == word) {
                    s.drive.kind = kind;
                }
                Ok(())
            },
        },
    ),
    plain(
        "drive.mass",
        D::Mass,
        Range::Positive,
        optional!(drive.mass),
    )
    .only(|s| !has_arm(s))
    .idle_when(|s| is_hydraulic(s).then_some(Idle::Drive)),
    plain(
        "drive.inertia",
        D::Inertia,
        Range::Positive,
        optional!(drive.mass),
    )
    .only(has_arm)
    .idle_when(|s| is_hydraulic(s).then_some(Idle::Drive)),
    number(
        "drive.speed",
        Measure {
            translating: D::AngularSpeed,
            oscillating: D::AngularSpeed,
            straight: D::Speed,
        },
        Range::Positive,
        optional!(drive.speed),
    ),
    plain(
        "drive.gravity",
        D::Acceleration,
        Range::Positive,
        given!(drive.gravity),
    )
    .default("9.81 m/s^2"),
    number(
        "drive.spring_rate",
        Measure::by_arm(D::SpringRate, D::AngularRate),
        Range::NotNegative,
        given!(drive.spring_rate),
    )
    .default("0")
    .only(is_fixed_axis),
    number(
        "drive.preload",
        Measure::by_arm(D::Force, D::Torque),
        Range::Any,
        given!(drive.preload),
    )
    .default("0")
    .only(is_fixed_axis),
    plain(
        "drive.damping",
        D::Damping,
        Range::NotNegative,
        given!(drive.damping),
    )
    .default("0")
    .only(|s| is_fixed_axis(s) && !has_arm(s)),
    plain(
        "drive.pressure_per_volume",
        D::PressurePerVolume,
        Range::Positive,
        given!(drive.pressure_per_volume),
    )
    .default("")
    .only(is_hydraulic)
    .required(),
    plain(
        "drive.piston_radius",
        D::Length,
        Range::Positive,
        given!(drive.piston_radius),
    )
    .default("")
    .only(is_hydraulic)
    .required(),
];

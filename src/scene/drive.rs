//! `[drive]`: how lift becomes force.

use super::table::Reader;
use super::{CamSpec, DriveSpec};
use crate::cam::FollowerKind;
use crate::drive::DriveKind;
use crate::error::{Error, Result};
use crate::units::{Dimension, G};

pub fn read(reader: Option<Reader>, cam: &CamSpec) -> Result<DriveSpec> {
    // Only a cam that turns under a sliding follower can carry its own shaft.
    let usual = if cam.is_oscillating() || cam.is_straight() || cam.follower == FollowerKind::Barrel
    {
        DriveKind::FixedAxis
    } else {
        DriveKind::MovingAxis
    };
    let mut spec = DriveSpec {
        kind: usual,
        mass: None,
        speed: None,
        gravity: G,
        pressure_per_volume: 0.0,
        piston_radius: 0.0,
        spring_rate: 0.0,
        preload: 0.0,
        damping: 0.0,
    };
    let Some(mut r) = reader else { return Ok(spec) };
    let kinds = [
        DriveKind::MovingAxis,
        DriveKind::FixedAxis,
        DriveKind::Hydraulic,
    ]
    .map(|k| (k.name(), k));
    spec.kind = r.choice("kind", &kinds)?.unwrap_or(usual);
    let arm = cam.is_oscillating();
    spec.mass = r.positive("mass", Dimension::Mass)?;
    if arm {
        if spec.mass.is_some() {
            return Err(Error::key(
                "drive.mass",
                "an arm's lift is an angle, on which no mass acts",
            )
            .help("give its moment of inertia about the pivot: inertia = \"0.02 kg m^2\""));
        }
        spec.mass = r.positive("inertia", Dimension::Inertia)?;
    }
    let per_time = if cam.is_straight() {
        Dimension::Speed
    } else {
        Dimension::AngularSpeed
    };
    spec.speed = r.positive("speed", per_time)?;
    spec.gravity = r.positive("gravity", Dimension::Acceleration)?.unwrap_or(G);
    match spec.kind {
        DriveKind::MovingAxis => {}
        DriveKind::FixedAxis => {
            spec.spring_rate = r
                .not_negative(
                    "spring_rate",
                    if arm {
                        Dimension::AngularRate
                    } else {
                        Dimension::SpringRate
                    },
                )?
                .unwrap_or(0.0);
            let preload = if arm {
                Dimension::Torque
            } else {
                Dimension::Force
            };
            spec.preload = r.quantity("preload", preload)?.unwrap_or(0.0);
            if !arm {
                spec.damping = r
                    .not_negative("damping", Dimension::Damping)?
                    .unwrap_or(0.0);
            }
        }
        DriveKind::Hydraulic => {
            let missing = |key: &str, example: &str| {
                Error::key(&format!("drive.{key}"), "a hydraulic drive needs it")
                    .help(format!("write for example {example}"))
            };
            spec.pressure_per_volume = r
                .positive("pressure_per_volume", Dimension::PressurePerVolume)?
                .ok_or_else(|| missing("pressure_per_volume", "\"30 psi/in^3\""))?;
            spec.piston_radius = r
                .positive("piston_radius", Dimension::Length)?
                .ok_or_else(|| missing("piston_radius", "\"0.75 in\""))?;
        }
    }
    r.finish()?;
    Ok(spec)
}

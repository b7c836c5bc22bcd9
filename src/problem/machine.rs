//! Speed and mass of the machine, and the force that belongs to them.

use std::f64::consts::TAU;

use crate::drive::{Drive, DriveKind};
use crate::error::{Placed, Result, SynthError};
use crate::force::ForceCurve;
use crate::scene::{DriveSpec, ForceScale};
use crate::units::Quantity;

/// The drive with every number, and the force scaled to its mass where that is asked for.
///
/// # Errors
/// No speed or no mass where no force gives one; a mean force that no mass can rest under.
pub fn resolve(
    spec: &DriveSpec,
    scale: ForceScale,
    force: Option<&ForceCurve>,
) -> Result<(Drive, Option<ForceCurve>)> {
    let drive = drive_of(spec, force.map(|curve| (curve.mean_n(), curve.period_s)))?;
    let on_mass = drive.kind == DriveKind::MovingAxis;
    let scaled = force.map(|curve| match scale {
        ForceScale::ToMass if on_mass => scaled_to(curve, drive.rest_force),
        ForceScale::Alternating if on_mass => {
            let shift = drive.rest_force - curve.mean_n();
            Ok(ForceCurve {
                force_n: curve.force_n.iter().map(|f| f + shift).collect(),
                ..curve.clone()
            })
        }
        ForceScale::None | ForceScale::ToMass | ForceScale::Alternating => Ok(curve.clone()),
    });
    Ok((drive, scaled.transpose()?))
}

/// The drive with every number, for a force of which mean, N, and period, s, are known.
pub(crate) fn drive_of(spec: &DriveSpec, force: Option<(f64, f64)>) -> Result<Drive> {
    let speed = match (spec.speed, force) {
        (Some(w), _) => w,
        (None, Some((_, period_s))) => TAU / period_s,
        (None, None) => {
            return Err(SynthError::ValueMissing.at_key("drive.speed"));
        }
    };
    Ok(match spec.kind {
        DriveKind::MovingAxis => {
            let mass = moving_mass(spec, force.map(|f| f.0))?;
            Drive::moving_axis(mass, spec.gravity, speed)
        }
        DriveKind::FixedAxis => Drive {
            kind: DriveKind::FixedAxis,
            rest_force: spec.preload,
            spring_rate: spec.spring_rate,
            damping: spec.damping,
            mass: spec.mass.unwrap_or(0.0),
            speed,
        },
        DriveKind::Hydraulic => {
            Drive::hydraulic(spec.pressure_per_volume, spec.piston_radius, speed)
        }
    })
}

/// The mass as given, otherwise the one whose weight is the mean force.
fn moving_mass(spec: &DriveSpec, mean: Option<f64>) -> Result<f64> {
    if let Some(mass) = spec.mass {
        return Ok(mass);
    }
    let Some(mean) = mean else {
        return Err(SynthError::ValueMissing.at_key("drive.mass"));
    };
    if mean <= 0.0 {
        return Err(SynthError::MeanForceNegative {
            mean: Quantity::force(mean),
        }
        .at_key("gait"));
    }
    Ok(mean / spec.gravity)
}

fn scaled_to(curve: &ForceCurve, weight: f64) -> Result<ForceCurve> {
    let mean = curve.mean_n();
    if mean <= 0.0 {
        return Err(SynthError::NotScalable {
            mean: Quantity::force(mean),
            weight: Quantity::force(weight),
        }
        .at_key("gait.scale"));
    }
    Ok(curve.scaled(weight / mean))
}

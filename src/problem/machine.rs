//! Speed and mass of the machine, and scaling of the force to the target.

use std::f64::consts::TAU;

use super::mean_force::MeanForce;
use crate::drive::{Drive, DriveKind};
use crate::error::{Placed, Result, SynthError};
use crate::force::ForceCurve;
use crate::scene::{CamSpec, DriveSpec, ForceScale, Scene};
use crate::units::Quantity;

/// Linear transformation of a force to the target. The force is multiplied by `factor`, then `shift` is added, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaling {
    pub factor: f64,
    pub shift: f64,
}

impl Scaling {
    /// Scaling that leaves the force unchanged.
    pub const NONE: Scaling = Scaling {
        factor: 1.0,
        shift: 0.0,
    };

    /// Whether the scaling leaves the force unchanged.
    pub fn is_none(self) -> bool {
        self.factor == 1.0 && self.shift == 0.0
    }

    /// Target for a value of the force, N.
    pub fn at(self, force: f64) -> f64 {
        self.factor * force + self.shift
    }

    /// Mean, spread and noise of the target. `force` contains these values for the unscaled force.
    pub fn of_mean(self, force: MeanForce) -> MeanForce {
        MeanForce {
            mean_n: self.at(force.mean_n),
            spread_n: self.factor * force.spread_n,
            noise_n: self.factor * force.noise_n,
            ..force
        }
    }

    /// Target force that results from scaling a force curve.
    pub fn of(self, force: &ForceCurve) -> ForceCurve {
        let mut target = force.scaled(self.factor);
        for f in &mut target.force_n {
            *f += self.shift;
        }
        target
    }

    /// Scaling that multiplies a force by `times` and then applies `self`.
    pub fn after(self, times: f64) -> Scaling {
        Scaling {
            factor: times * self.factor,
            ..self
        }
    }
}

/// Drive of a scene in which all numbers are set, and the scaling to the target. `force` contains the mean of the force to be scaled.
///
/// # Errors
///
/// A required force is not given. The mean force is not positive on a moving axis. The force of the drive does not depend on the lift.
pub fn of_force(scene: &Scene, force: Option<MeanForce>) -> Result<(Drive, Scaling)> {
    let drive = drive(&scene.drive, &scene.cam, force)?;
    let how = scene.gait.as_ref().map_or(ForceScale::None, |g| g.scale);
    let scaling = scaling(&drive, how, force.map_or(1.0, |f| f.mean_n))?;
    if force.is_some() && drive.weights() == [0.0; 4] {
        return Err(SynthError::NoLiftChangesForce.at_key("drive"));
    }
    Ok((drive, scaling))
}

/// Scaling to the target for a force with a given mean, N. For an arm, the target is the moment of the force. On a moving axis, the scene
/// can require that the force is scaled or shifted until its mean equals the weight of the mass.
///
/// # Errors
///
/// The scene requires scaling to the mass, but the mean force is not positive.
fn scaling(drive: &Drive, how: ForceScale, mean: f64) -> Result<Scaling> {
    let (mut factor, mut shift) = (drive.lever, 0.0);
    match how {
        ForceScale::ToMass | ForceScale::Alternating if drive.kind != DriveKind::MovingAxis => {}
        ForceScale::ToMass if mean <= 0.0 => {
            let (mean, weight) = (Quantity::force(mean), Quantity::force(drive.rest_force));
            return Err(SynthError::NotScalable { mean, weight }.at_key("gait.scale"));
        }
        ForceScale::ToMass => factor = drive.rest_force / mean,
        ForceScale::Alternating => shift = drive.rest_force - mean,
        ForceScale::None => {}
    }
    Ok(Scaling { factor, shift })
}

/// Drive of the machine with all values set. A missing speed follows from the period of the force. A missing mass on a moving axis follows
/// from the mean force.
///
/// # Errors
///
/// Without a force, the speed is missing, or the mass on a moving axis. With a force, this mass is missing and the mean force is not
/// positive.
fn drive(spec: &DriveSpec, cam: &CamSpec, force: Option<MeanForce>) -> Result<Drive> {
    let speed = match (spec.speed, force) {
        (Some(w), _) => w,
        (None, Some(force)) => TAU / force.period_s,
        (None, None) => {
            return Err(SynthError::ValueMissing.at_key("drive.speed"));
        }
    };
    let lever = spec.lever.or_else(|| cam.lever()).unwrap_or(1.0);
    Ok(match spec.kind {
        DriveKind::MovingAxis => {
            let mass = moving_mass(spec, force.map(|f| f.mean_n))?;
            Drive::moving_axis(mass, spec.gravity, speed)
        }
        DriveKind::FixedAxis => Drive {
            kind: DriveKind::FixedAxis,
            rest_force: spec.preload,
            spring_rate: spec.spring_rate,
            damping: spec.damping,
            mass: spec.mass.unwrap_or(0.0),
            speed,
            lever,
        },
        DriveKind::Hydraulic => {
            Drive::hydraulic(spec.pressure_per_volume, spec.piston_radius, speed).at_lever(lever)
        }
    })
}

/// Mass on a moving axis, kg: the given mass, or the mass whose weight is the mean force.
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

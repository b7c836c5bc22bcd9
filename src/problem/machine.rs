//! Speed and mass of the machine, and scaling of the force to the target.

use std::f64::consts::TAU;

use super::mean_force::MeanForce;
use crate::drive::{Drive, DriveKind};
use crate::error::{Placed, Result, SynthError};
use crate::force::ForceCurve;
use crate::scene::{CamSpec, DriveSpec, ForceScale, Scene};
use crate::units::Quantity;

/// Scaling of a force to the target: the force is multiplied by `factor`, then `shift` is added, N.
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

    /// Mean, spread and noise of the target from those of the force.
    pub fn of_mean(self, force: MeanForce) -> MeanForce {
        MeanForce {
            mean_n: self.at(force.mean_n),
            spread_n: self.factor * force.spread_n,
            noise_n: self.factor * force.noise_n,
            ..force
        }
    }

    /// Target force for a force curve.
    pub fn of(self, force: &ForceCurve) -> ForceCurve {
        let mut target = force.scaled(self.factor);
        for f in &mut target.force_n {
            *f += self.shift;
        }
        target
    }

    /// Scaling that applies the factor `times` first and then `self`. Its target for a force F is the target of `self` for `times` · F.
    pub fn after(self, times: f64) -> Scaling {
        Scaling {
            factor: times * self.factor,
            ..self
        }
    }
}

/// Drive of a scene with all numbers, and the scaling of a force with the given mean to the target.
///
/// # Errors
///
/// A required force is not given; the mean force is not positive on a moving axis; the drive does not relate lift and force.
pub fn of_force(scene: &Scene, force: Option<MeanForce>) -> Result<(Drive, Scaling)> {
    let drive = drive(&scene.drive, &scene.cam, force)?;
    let how = scene.gait.as_ref().map_or(ForceScale::None, |g| g.scale);
    let scaling = scaling(&drive, how, force.map_or(1.0, |f| f.mean_n))?;
    if force.is_some() && drive.weights() == [0.0; 4] {
        return Err(SynthError::NoLiftChangesForce.at_key("drive"));
    }
    Ok((drive, scaling))
}

/// Scaling of a force with a mean, N, to the target. For an arm, the target is the moment of the force. On a moving axis, the scene can require that
/// the target is scaled to the mass.
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
/// The speed, or the mass on a moving axis, is missing and there is no force. This mass is missing and the mean force is not positive.
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

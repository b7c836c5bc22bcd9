//! What a scene requires of a design, whatever the course of its force over the turn.

use super::machine::{self, Scaling};
use super::mean_force::MeanForce;
use crate::drive::Drive;
use crate::error::{Placed, Result, SynthError};
use crate::scene::{CamSpec, ForceScale, LawSpec, Limits, Scene};

/// Machine, law, cam and limits with every number resolved, for a force of known mean.
///
/// ```
/// use gaitcam::problem::{MeanForce, Requirements};
/// use gaitcam::scene;
///
/// // M g = 700 N, and 0.5 % of it as the force error, whatever the course of the force.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let force = MeanForce { mean_n: 700.0, period_s: 0.5, spread_n: 0.0 };
/// let required = Requirements::of(&scene, Some(force))?;
/// assert!((required.drive.mass - 700.0 / 9.81).abs() < 1e-9);
/// assert_eq!(required.asked_error(), 3.5);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Requirements {
    /// The machine that turns lift into force.
    pub drive: Drive,
    /// Family, size and demands of the law.
    pub law: LawSpec,
    /// Follower and lengths.
    pub cam: CamSpec,
    /// Limits in force.
    pub limits: Limits,
    /// RMS force error asked for, part of the mean force.
    pub accuracy: Option<f64>,
    /// The target force, scaled to the mass where the scene says so; `None` for a classical programme.
    pub(super) force: Option<MeanForce>,
    /// How it follows from the force given.
    pub(super) scaling: Scaling,
}

impl Requirements {
    /// Resolves speed and mass.
    ///
    /// # Errors
    /// The scene needs a force and none is given; the mean force is not positive on a moving axis; the drive
    /// relates no lift to force.
    pub fn of(scene: &Scene, force: Option<MeanForce>) -> Result<Requirements> {
        let drive = machine::drive(&scene.drive, &scene.cam, force)?;
        let how = scene.gait.as_ref().map_or(ForceScale::None, |g| g.scale);
        let scaling = machine::scaling(&drive, how, force.map_or(1.0, |f| f.mean_n))?;
        if force.is_some() && drive.weights() == [0.0; 4] {
            return Err(SynthError::NoLiftChangesForce.at_key("drive"));
        }
        let target = |force: MeanForce| MeanForce {
            mean_n: scaling.factor * force.mean_n + scaling.shift,
            spread_n: scaling.factor * force.spread_n,
            ..force
        };
        let mut law = scene.law.clone();
        for force in law.points.iter_mut().filter_map(|p| p.force.as_mut()) {
            *force *= drive.lever;
        }
        Ok(Requirements {
            drive,
            law,
            cam: scene.cam.clone(),
            limits: scene.limits.clone(),
            accuracy: scene.rms,
            force: force.map(target),
            scaling,
        })
    }
}

//! Simulation of a cam with one model. The lift is recovered from the points of the output profile.

mod choose;
mod largest;
mod models;
mod prepared;
mod rows;
mod shaft;

use crate::dynamics::outcome::{Model, Outcome};
use crate::dynamics::run::Run;
use crate::error::{DynamicsError, Placed, Result};
use prepared::prepare;

/// Simulates a cam with `model`, from the points of its output profile.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // An eccentric of 10 mm under a block of 1 kg: F = M(g + ω²a).
/// let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.03 })?;
/// let run = Run::new(cam, Drive::moving_axis(1.0, 9.81, 10.0), 720);
/// let out = simulate(&run, Model::Rigid)?;
/// assert!((out.force.min - (9.81 - 1.0)).abs() < 1e-6 && !out.contact_lost);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
///
/// # Errors
/// A profile from which the lift cannot be recovered (see [`recover`](crate::dynamics::recover())); machine data out of range; an undamped
/// resonance; `flexible` without a [`Train`](super::Train); a moving floor with a model other than the rigid one.
pub fn simulate(input: &Run, model: Model) -> Result<Outcome> {
    refuse_beside_floor(input, model)?;
    let mut prepared = prepare(input)?;
    shaft::turn(input, &mut prepared, model)?;
    match model {
        Model::Auto => choose::auto(input, &prepared),
        _ => models::under(input, &prepared, model),
    }
}

/// Rejects a moving floor with a model other than the rigid one.
fn refuse_beside_floor(input: &Run, model: Model) -> Result<()> {
    let machine = &input.machine;
    let is_rigid = matches!(model, Model::Auto | Model::Rigid);
    if machine.floor.is_some() && !(is_rigid && machine.train.is_none()) {
        return Err(DynamicsError::FloorNotRigid.at_key("machine.floor"));
    }
    Ok(())
}

#[cfg(test)]
mod tests;

#[cfg(test)]
mod followers_tests;

#[cfg(test)]
mod edge_tests;

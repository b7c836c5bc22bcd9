//! The shaft of a run under its motor, where that changes the force.

use super::choose::RIGID_ENOUGH;
use super::prepared::Prepared;
use crate::drive::Motor;
use crate::dynamics::outcome::Model;
use crate::dynamics::reason::RunNote;
use crate::dynamics::recover::Cycle;
use crate::dynamics::rigid::touch::{rubs, touch};
use crate::dynamics::run::Run;
use crate::dynamics::shaft::{Load, periodic};
use crate::error::{DynamicsError, Result};
use crate::law::Svaj;
use crate::units::Quantity;

/// Steps of the motion between the breaks of the law.
pub(super) const STEPS: usize = 240;

/// Gives the shaft its motion under the motor of the machine; under the automatic model only where the speed changes the
/// force by more than [`RIGID_ENOUGH`] of its mean.
pub(super) fn turn(input: &Run, p: &mut Prepared, model: Model) -> Result<()> {
    let Some(motor) = &input.machine.motor else {
        return Ok(());
    };
    refuse_unknown(input, p, motor)?;
    let arms = |at: Svaj| arms(input, at);
    let load = Load::new(&p.lift, &p.drive, STEPS, &arms);
    let (ripple, change) = load.forecast(motor.inertia, p.drive.speed);
    if model == Model::Auto && change <= RIGID_ENOUGH {
        p.notes.push(RunNote::SteadyShaft {
            ripple: Quantity::share(ripple),
            change: Quantity::share(change),
            allowed: Quantity::share(RIGID_ENOUGH),
        });
        return Ok(());
    }
    let lowest = p.lift.extremes(0).0.at;
    let motion = periodic(&load, motor, p.drive.speed, None)?.at_rows(p.nodes.len());
    motion.check_supply(&load, motor)?;
    p.shaft_report = Some(motion.report(&load, motor, lowest));
    p.notes.push(RunNote::ShaftVaries {
        ripple: Quantity::share(ripple),
        change: Quantity::share(change),
        found: Quantity::share(motion.ripple()),
    });
    p.shaft = Some(motion);
    Ok(())
}

/// Torque of the shaft per unit of force where the follower is pressed, and where it is pulled, m.
pub(super) fn arms(input: &Run, at: Svaj) -> [f64; 2] {
    let (follower, friction) = (&input.cam.follower, input.machine.friction);
    match friction > 0.0 && rubs(follower) {
        false => [at.v; 2],
        true => [1.0, -1.0].map(|f| f * touch(follower, 1.0, friction, at, f).torque),
    }
}

/// Refuses what has no steady turn under a motor.
fn refuse_unknown(input: &Run, p: &Prepared, motor: &Motor) -> Result<()> {
    if p.cycle != Cycle::TURN || p.laws.len() > 1 {
        return Err(DynamicsError::MotorTurns.into());
    }
    let numbers = [
        motor.inertia,
        motor.friction,
        motor.gear,
        motor.efficiency,
        input.drive.speed,
    ];
    let sound =
        numbers.iter().all(|x| x.is_finite()) && motor.inertia >= 0.0 && motor.friction >= 0.0;
    if !sound || motor.gear <= 0.0 || motor.efficiency <= 0.0 || input.drive.speed == 0.0 {
        return Err(DynamicsError::Motor.into());
    }
    Ok(())
}

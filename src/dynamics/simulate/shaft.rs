//! The shaft of a run under its motor, where that changes the force.

use super::choose::RIGID_ENOUGH;
use super::prepared::Prepared;
use crate::drive::Motor;
use crate::dynamics::outcome::Model;
use crate::dynamics::reason::RunNote;
use crate::dynamics::recover::Cycle;
use crate::dynamics::rigid::touch::{rubs, touch};
use crate::dynamics::run::Run;
use crate::dynamics::shaft::{Load, Node, periodic};
use crate::error::{DynamicsError, Result};
use crate::law::Svaj;
use crate::units::Quantity;

/// Gives the shaft its motion under the motor of the machine; under the automatic model only where the speed changes the
/// force by more than [`RIGID_ENOUGH`] of its mean.
pub(super) fn turn(input: &Run, p: &mut Prepared, model: Model) -> Result<()> {
    let Some(motor) = &input.machine.motor else {
        return Ok(());
    };
    refuse_unknown(input, p, motor)?;
    let (follower, friction) = (&input.cam.follower, input.machine.friction);
    let rubbing = friction > 0.0 && rubs(follower);
    let arms = |at: Svaj| match rubbing {
        false => [at.v; 2],
        true => [1.0, -1.0].map(|f| f * touch(follower, 1.0, friction, at, f).torque),
    };
    let load = Load::new(&p.lift, &p.drive, p.nodes.len(), &arms);
    let (ripple, change) = forecast(p, &load, motor);
    if model == Model::Auto && change <= RIGID_ENOUGH {
        p.notes.push(RunNote::SteadyShaft {
            ripple: Quantity::share(ripple),
            change: Quantity::share(change),
            allowed: Quantity::share(RIGID_ENOUGH),
        });
        return Ok(());
    }
    let nodes = p.nodes.iter().map(|at| Node::new(&p.drive, *at, arms(*at)));
    let nodes: Vec<Node> = nodes.collect();
    let lowest = p.lift.extremes(0).0.at;
    let motion = periodic(&load, &nodes, motor, p.drive.speed, None)?;
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

/// Ripple, part of the mean speed, and RMS change of the force, part of its mean, that a small swing of the speed makes:
/// J ω δω balances the load's work about its mean (theory §10).
fn forecast(p: &Prepared, load: &Load, motor: &Motor) -> (f64, f64) {
    let speed = p.drive.speed;
    let (mean_torque, swing) = load.at_constant_speed(speed);
    let scale = motor.inertia * speed * speed;
    let [_, c, m, _] = p.drive.weights();
    let forces: Vec<f64> = p.nodes.iter().map(|at| p.drive.force(*at)).collect();
    let (mut work, mut sum, mut square) = (0.0, 0.0, 0.0);
    let works: Vec<f64> = (p.nodes.iter().zip(&forces))
        .map(|(at, force)| {
            work += p.step * (mean_torque - at.v * force);
            work
        })
        .collect();
    let middle = works.iter().sum::<f64>() / works.len() as f64;
    for ((at, force), work) in p.nodes.iter().zip(&forces).zip(&works) {
        let (part, slope) = (
            (work - middle) / scale,
            (mean_torque - at.v * force) / scale,
        );
        square += ((2.0 * m * at.a + c * at.v) * part + m * at.v * slope).powi(2);
        sum += force;
    }
    let count = forces.len() as f64;
    (swing / scale, (square / count).sqrt() / (sum / count).abs())
}

//! Motion of shaft and floor in a run. With automatic model selection, the motor is included only if it changes the force. The floor moves
//! under the force.

use super::choose::RIGID_ENOUGH;
use super::prepared::Prepared;
use crate::dynamics::machine_motion::{Carrier, Parts};
use crate::dynamics::outcome::Model;
use crate::dynamics::reason::RunNote;
use crate::dynamics::run::Run;
use crate::dynamics::shaft::forecast;
use crate::error::{DynamicsError, Result};
use crate::units::Quantity;

/// Number of steps of the shaft motion between the breaks of the law.
const STEPS: usize = 160;
const FEW: usize = 32;

/// Drive, motor, floor and friction of the machine in this run.
///
/// # Errors
///
/// The errors of [`Carrier::new`], and a motor in combination with a second cam.
pub(super) fn carrier<'a>(input: &'a Run, p: &Prepared) -> Result<Carrier<'a>> {
    let machine = &input.machine;
    let motor = machine.motor.as_ref();
    if motor.is_some() && p.laws.len() > 1 {
        return Err(DynamicsError::MotorTurns.into());
    }
    let parts = Parts {
        drive: p.drive,
        motor,
        floor: machine.floor.as_ref(),
        friction: machine.friction,
    };
    let walker = || p.target.clone().unwrap_or_else(|| p.still_forces());
    Carrier::new(&input.cam, parts, walker, STEPS)
}

/// Computes the motion of shaft and floor. The automatic model includes the motor only if it changes the force by more than [`RIGID_ENOUGH`] of the
/// mean force.
pub(super) fn turn(input: &Run, p: &mut Prepared, model: Model) -> Result<()> {
    let mut carrier = carrier(input, p)?;
    let lift = p.lift.clone();
    let at = |angle: f64| lift.svaj(angle);
    let mut neglected = None;
    if let Some(motor) = carrier.motor {
        let few = Carrier {
            steps: FEW,
            ..carrier.clone()
        };
        let load = few.load(p.start, &[], &at, &|_| 0.0);
        let (ripple, change) = forecast(&load, motor, p.drive.speed);
        let [ripple, change, allowed] = [ripple, change, RIGID_ENOUGH].map(Quantity::share);
        if model == Model::Auto && change.value <= RIGID_ENOUGH {
            carrier.motor = None;
            p.notes.push(RunNote::SteadyShaft {
                ripple,
                change,
                allowed,
            });
        } else {
            neglected = Some((ripple, change));
        }
    }
    let is_plain = input.machine.learned.is_empty();
    if carrier.motor.is_none() && carrier.floor.is_none() && is_plain {
        return Ok(());
    }
    let motion = carrier.motion(p.start, &p.breaks, &at, None)?;
    if let Some((motor, (ripple, change))) = carrier.motor.zip(neglected) {
        motion.shaft.check_supply(motor)?;
        p.shaft_report = motion.shaft.report(motor, lift.extremes(0).0.at);
        p.notes.push(RunNote::ShaftVaries {
            ripple,
            change,
            found: Quantity::share(motion.shaft.ripple()),
        });
        p.shaft = Some(motion.shaft.clone().at_rows(p.nodes.len()));
    }
    p.machine = Some(motion);
    Ok(())
}

//! Simulation of a prepared cam with rigid bodies that stay in contact.

use super::in_time::in_time;
use super::note_pull;
use crate::dynamics::floor::FloorMotion;
use crate::dynamics::machine_motion::MachineMotion;
use crate::dynamics::outcome::{Force, Model, Outcome};
use crate::dynamics::reason::RunNote;
use crate::dynamics::rigid;
use crate::dynamics::rigid::touch::rubs;
use crate::dynamics::run::Run;
use crate::dynamics::shaft::force;
use crate::dynamics::simulate::prepared::Prepared;
use crate::dynamics::surface::Surface;
use crate::error::Result;
use crate::law::Svaj;

/// Mean torque, relative to the root mean square torque, below which the mean is a rounding error.
const NO_TORQUE: f64 = 1e-9;

pub fn rigid_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    let friction = input.machine.friction;
    let mut out = p.outcome(Model::Rigid);
    if let Some(machine) = &p.machine {
        return Ok(over_time(input, p, machine));
    }
    let forces = p.still_forces();
    let surface = Surface::new(p.lift.clone(), &p.drive);
    let (low, high) = surface.force.extremes();
    out.force = Force {
        min: low.value,
        max: high.value,
        rms_error: p.rms_error(&forces),
    };
    out.torque = p.sampled_torque(input, &forces);
    let curve = if p.rubs {
        None
    } else {
        let follower = &input.cam.follower;
        let reach = rigid::reach(follower);
        let friction = if rubs(follower) { friction } else { 0.0 };
        rigid::torque_curve(&p.lift, &p.drive, friction, reach)
    };
    if let Some(curve) = curve {
        let (low, high) = curve.extremes();
        (out.torque.min, out.torque.max) = (low.value, high.value);
        out.torque.mean = curve.integral() / p.cycle.length;
    }
    out.torque = p.signed(out.torque);
    note_pull(&mut out, input, p, pulled_share(&surface, p));
    out.contact_lost = out.lost_fraction > 0.0;
    if out.contact_lost {
        out.notes.push(RunNote::RigidPulls);
    }
    if p.laws.len() > 1 {
        out.notes.push(RunNote::RigidWithoutImpacts);
    }
    p.fill(input, &mut out, &forces, &vec![0.0; forces.len()]);
    Ok(out)
}

/// Fraction of the cycle with a negative force on the surface. A force of 0 is not negative.
fn pulled_share(surface: &Surface, p: &Prepared) -> f64 {
    let pulled = surface.pulls.iter().fold(0.0, |sum, (a, b)| sum + b - a);
    pulled / p.cycle.length
}

/// Simulates the rigid model with a varying shaft speed, a moving floor or a force correction. With a moving floor or a force correction,
/// the minimum and maximum force are taken from the rows.
fn over_time(input: &Run, p: &Prepared, machine: &MachineMotion) -> Outcome {
    let nodes = p.nodes.iter().enumerate();
    let motion = |i: usize| match &p.shaft {
        Some(shaft) => [shaft.speed[i], shaft.acceleration[i]],
        None => [p.drive.speed, 0.0],
    };
    let forces = nodes.map(|(i, at): (usize, &Svaj)| {
        let [speed, acceleration] = motion(i);
        let floor = machine.floor_at(p.step * i as f64);
        let learned = input.machine.learned.get(i).copied().unwrap_or(0.0);
        force(&p.drive, *at, speed, acceleration) + p.drive.mass * floor + learned
    });
    let forces: Vec<f64> = forces.collect();
    let is_smooth = input.machine.floor.is_none() && input.machine.learned.is_empty();
    let ([low, high], pulled) = match &p.shaft {
        Some(shaft) if is_smooth => {
            let surface = Surface::new(in_time(&p.lift, &p.breaks, shaft), &p.drive);
            let (low, high) = surface.force.extremes();
            ([low.value, high.value], pulled_share(&surface, p))
        }
        _ => {
            let pulled = forces.iter().filter(|f| **f < 0.0).count();
            let ends = [f64::INFINITY, f64::NEG_INFINITY];
            let range = forces.iter().fold(ends, |[l, h], f| [l.min(*f), h.max(*f)]);
            (range, pulled as f64 / forces.len() as f64)
        }
    };
    let mut out = p.outcome(Model::Rigid);
    out.force_time = p.force_time(&forces);
    out.force = Force {
        min: low,
        max: high,
        rms_error: match &p.shaft {
            Some(_) => out.force_time.map(|e| e.rms_error_n),
            None => p.rms_error(&forces),
        },
    };
    out.torque = p.signed(p.sampled_torque(input, &forces));
    if out.torque.mean.abs() < NO_TORQUE * out.torque.rms {
        out.torque.mean = 0.0;
    }
    note_pull(&mut out, input, p, pulled);
    out.contact_lost = out.lost_fraction > 0.0;
    if out.contact_lost {
        out.notes.push(RunNote::RigidPulls);
    }
    if !machine.floor.is_empty() {
        out.floor = Some(FloorMotion::of(&machine.floor));
        // The lift-off speed is valid only for a rigid floor.
        out.liftoff_speed = None;
    }
    p.fill(input, &mut out, &forces, &vec![0.0; forces.len()]);
    out
}

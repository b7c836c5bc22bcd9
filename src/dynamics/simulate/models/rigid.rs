//! The rigid model on a prepared cam.

use super::note_pull;
use super::on_shaft::in_time;
use crate::dynamics::floor::{Floor, FloorMotion, harmonics};
use crate::dynamics::outcome::{Force, Model, Outcome};
use crate::dynamics::reason::RunNote;
use crate::dynamics::rigid;
use crate::dynamics::run::Run;
use crate::dynamics::simulate::prepared::Prepared;
use crate::dynamics::surface::Surface;
use crate::error::Result;
use crate::poly::samples;

/// A mean torque below this part of the root mean square is rounding.
const NO_TORQUE: f64 = 1e-9;

pub fn rigid_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    let friction = input.machine.friction;
    let mut out = p.outcome(Model::Rigid);
    if let Some(shaft) = &p.shaft {
        let forces = shaft.forces(&p.drive, &p.nodes);
        let surface = Surface::new(in_time(&p.lift, shaft), &p.drive);
        return Ok(over_time(input, p, &forces, &surface));
    }
    if let Some(floor) = &input.machine.floor {
        return on_floor(input, p, floor);
    }
    let forces: Vec<f64> = p.nodes.iter().map(|at| p.drive.force(*at)).collect();
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
        let reach = rigid::reach(&input.cam.follower);
        let friction = if reach > 0.0 { friction } else { 0.0 };
        rigid::torque_curve(&p.lift, &p.drive, friction, reach)
    };
    if let Some(curve) = curve {
        let (low, high) = curve.extremes();
        (out.torque.min, out.torque.max) = (low.value, high.value);
        out.torque.mean = curve.integral() / p.cycle.length;
    }
    out.torque = p.signed(out.torque);
    let pulled = surface.pulls.iter().fold(0.0, |sum, (a, b)| sum + b - a) / p.cycle.length;
    note_pull(&mut out, input, p, pulled);
    out.contact_lost = out.lost_fraction > 0.0;
    if out.contact_lost {
        out.notes.push(RunNote::RigidPulls);
    }
    if p.laws.len() > 1 {
        out.notes.push(RunNote::RigidWithoutImpacts);
    }
    out.rows = p.rows(input, &forces, &vec![0.0; forces.len()]);
    out.hertz = p.hertz(input, &out.rows);
    Ok(out)
}

/// The rigid follower over a floor that moves: F = M (g + d″ + z″), the other walkers pressing as the target asks.
fn on_floor(input: &Run, p: &Prepared, floor: &Floor) -> Result<Outcome> {
    let (mass, speed) = (p.drive.mass, p.drive.speed);
    let still: Vec<f64> = p.nodes.iter().map(|at| p.drive.force(*at)).collect();
    let own = harmonics(&still);
    let wanted = harmonics(p.target.as_deref().unwrap_or(&still));
    let others = floor.of_walkers(1, &wanted);
    let pressed = floor.pressed(mass, speed, &own, &others)?;
    let all = pressed
        .iter()
        .zip(&others)
        .map(|(a, b)| (a.0 + b.0, a.1 + b.1));
    let acceleration = floor.acceleration(speed, &all.collect::<Vec<_>>())?;
    let moved = samples(&acceleration, 0, still.len()).into_iter();
    let forces: Vec<f64> = still.iter().zip(moved).map(|(f, a)| f + mass * a).collect();
    let pulled = forces.iter().filter(|f| **f < 0.0).count() as f64 / forces.len() as f64;
    let mut out = sampled(input, p, &forces, extremes(&forces), pulled);
    out.floor = Some(FloorMotion::of(&acceleration));
    // It is that of a stiff floor.
    out.liftoff_speed = None;
    Ok(out)
}

/// The rigid follower on a shaft whose speed varies; `surface` is the cam by the part of the period.
fn over_time(input: &Run, p: &Prepared, forces: &[f64], surface: &Surface) -> Outcome {
    let (low, high) = surface.force.extremes();
    let pulled = surface.pulls.iter().fold(0.0, |sum, (a, b)| sum + b - a) / p.cycle.length;
    sampled(input, p, forces, (low.value, high.value), pulled)
}

/// The rigid follower under forces that are no function of its lift alone, with their extremes and the part of the cycle in
/// which they pull.
fn sampled(
    input: &Run,
    p: &Prepared,
    forces: &[f64],
    (low, high): (f64, f64),
    pulled: f64,
) -> Outcome {
    let mut out = p.outcome(Model::Rigid);
    out.force_time = p.force_time(forces);
    out.force = Force {
        min: low,
        max: high,
        rms_error: match &p.shaft {
            Some(_) => out.force_time.map(|e| e.rms_error_n),
            None => p.rms_error(forces),
        },
    };
    out.torque = p.signed(p.sampled_torque(input, forces));
    if out.torque.mean.abs() < NO_TORQUE * out.torque.rms {
        out.torque.mean = 0.0;
    }
    note_pull(&mut out, input, p, pulled);
    out.contact_lost = out.lost_fraction > 0.0;
    if out.contact_lost {
        out.notes.push(RunNote::RigidPulls);
    }
    out.rows = p.rows(input, forces, &vec![0.0; forces.len()]);
    out.hertz = p.hertz(input, &out.rows);
    out
}

/// Smallest and largest of some numbers.
fn extremes(values: &[f64]) -> (f64, f64) {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    (least, most)
}

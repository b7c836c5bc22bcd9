//! The rigid model on a prepared cam.

use super::note_pull;
use crate::dynamics::outcome::{Force, Model, Outcome};
use crate::dynamics::reason::RunNote;
use crate::dynamics::rigid;
use crate::dynamics::run::Run;
use crate::dynamics::shaft::Motion;
use crate::dynamics::simulate::prepared::Prepared;
use crate::dynamics::surface::Surface;
use crate::error::Result;

/// A mean torque below this part of the root mean square is rounding.
const NO_TORQUE: f64 = 1e-9;

pub fn rigid_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    let friction = input.machine.friction;
    let mut out = p.outcome(Model::Rigid);
    if let Some(shaft) = &p.shaft {
        return Ok(on_shaft(input, p, shaft));
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

/// The rigid follower on a shaft whose speed varies; extremes are those of the rows.
fn on_shaft(input: &Run, p: &Prepared, shaft: &Motion) -> Outcome {
    let mut out = p.outcome(Model::Rigid);
    let forces = shaft.forces(&p.drive, &p.nodes);
    let (low, high) = extremes(&forces);
    out.force_time = p.force_time(&forces);
    out.force = Force {
        min: low,
        max: high,
        rms_error: out.force_time.map(|e| e.rms_error_n),
    };
    out.torque = p.signed(p.sampled_torque(input, &forces));
    if out.torque.mean.abs() < NO_TORQUE * out.torque.rms {
        out.torque.mean = 0.0;
    }
    let pulled = forces.iter().filter(|f| **f < 0.0).count() as f64 / forces.len() as f64;
    note_pull(&mut out, input, p, pulled);
    out.contact_lost = out.lost_fraction > 0.0;
    if out.contact_lost {
        out.notes.push(RunNote::RigidPulls);
    }
    out.rows = p.rows(input, &forces, &vec![0.0; forces.len()]);
    out.hertz = p.hertz(input, &out.rows);
    out
}

/// Smallest and largest of some numbers.
fn extremes(values: &[f64]) -> (f64, f64) {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    (least, most)
}

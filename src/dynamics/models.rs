//! The rigid and the flexible model on a prepared cam, each with its outcome.

use super::outcome::{Force, Model, Outcome};
use super::simulate::{Prepared, Run};
use super::surface::Surface;
use super::{flexible, rigid};
use crate::error::{Error, Result};

pub(super) fn rigid_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    let friction = input.machine.friction;
    let mut out = p.outcome(Model::Rigid, "asked for");
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
        let friction = if p.reach > 0.0 { friction } else { 0.0 };
        rigid::torque_curve(&p.lift, &p.drive, friction, p.reach)
    };
    if let Some(curve) = curve {
        let (low, high) = curve.extremes();
        (out.torque.min, out.torque.max) = (low.value, high.value);
        out.torque.mean = curve.integral() / p.cycle.length;
    }
    out.torque = p.signed(out.torque);
    let pulled = surface.pulls.iter().fold(0.0, |sum, (a, b)| sum + b - a) / p.cycle.length;
    if p.held {
        note_other_side(&mut out, input, pulled);
    } else {
        out.lost_fraction = pulled;
    }
    out.contact_lost = out.lost_fraction > 0.0;
    if out.contact_lost {
        out.notes.push(
            "the rigid model pulls where the force is negative: run --model contact".to_string(),
        );
    }
    if p.laws.len() > 1 {
        out.notes.push(
            "the rigid model leaves out the blows where one cam takes over from the other"
                .to_string(),
        );
    }
    out.rows = p.rows(input, &forces, &vec![0.0; forces.len()], &[]);
    out.hertz = p.hertz(input, &out.rows);
    Ok(out)
}

/// Where a groove or a pair holds the follower from both sides a pull is the other side's push.
fn note_other_side(out: &mut Outcome, input: &Run, pulled: f64) {
    if pulled <= 0.0 {
        return;
    }
    let side = if input.machine.conjugate.is_some() {
        "the second cam"
    } else {
        "the groove's other wall"
    };
    out.notes.push(format!(
        "{side} bears for {:.2} % of the cycle, up to {:.4} N; at each change the play between both sides is crossed",
        100.0 * pulled,
        -out.force.min
    ));
}

pub(super) fn flexible_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    let Some(train) = &input.machine.train else {
        return Err(Error::new("the flexible model needs to know what gives")
            .help("give the follower's natural frequency or its stiffness: --natural-frequency, or under [machine] in the scene"));
    };
    if !p.cycle.closed {
        return Err(
            Error::new("a slide that ends has no steady vibration").help("run --model rigid")
        );
    }
    let steady = flexible::steady(&p.lift, &p.drive, train)?;
    let mut out = p.outcome(Model::Flexible, "asked for");
    let n = p.nodes.len();
    // The rows' angles are among the breaks of the forcing.
    let mut k = 0;
    let (mut forces, mut heights, mut outputs) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..n {
        let at = p.start + p.step * i as f64;
        while k + 1 < steady.theta.len() && steady.theta[k] < at - 1e-9 {
            k += 1;
        }
        forces.push(steady.contact[k]);
        heights.push(steady.deflection[k]);
        outputs.push(steady.output[k]);
    }
    let (low, high) = steady.contact_extremes();
    out.force = Force {
        min: low.value,
        max: high.value,
        rms_error: p.rms_error(&outputs),
    };
    out.torque = p.signed(p.sampled_torque(input, &forces));
    let pulled = forces.iter().filter(|f| **f < 0.0).count() as f64 / n as f64;
    if p.held {
        note_other_side(&mut out, input, pulled);
    } else {
        out.contact_lost = low.value < 0.0;
        out.lost_fraction = pulled;
    }
    if out.contact_lost {
        out.notes.push(
            "the vibrating follower leaves the cam: the flexible model pulls there".to_string(),
        );
    }
    out.rows = p.rows(input, &forces, &heights, &[]);
    out.hertz = p.hertz(input, &out.rows);
    Ok(out)
}

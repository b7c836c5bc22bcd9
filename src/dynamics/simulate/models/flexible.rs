//! Simulation of a prepared cam with a compliant follower in steady vibration.

use super::note_pull;
use crate::dynamics::flexible;
use crate::dynamics::outcome::{Force, Model, Outcome};
use crate::dynamics::reason::RunNote;
use crate::dynamics::run::Run;
use crate::dynamics::simulate::prepared::Prepared;
use crate::error::{DynamicsError, Result};

pub fn flexible_run(input: &Run, p: &Prepared) -> Result<Outcome> {
    let Some(train) = &input.machine.train else {
        return Err(DynamicsError::NoTrain.into());
    };
    if !p.cycle.closed {
        return Err(DynamicsError::OpenVibration.into());
    }
    let steady = flexible::steady(&p.lift, &p.drive, train)?;
    let mut out = p.outcome(Model::Flexible);
    if out.shaft.is_some() {
        out.notes.push(RunNote::FlexibleAtMeanSpeed);
    }
    let n = p.nodes.len();
    // Most rows are at breaks of the input. The other rows nearly coincide with a break.
    let last = steady.theta.len() - 1;
    let (mut forces, mut heights, mut outputs) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..n {
        let at = p.start + p.step * i as f64;
        let k = steady.theta.partition_point(|t| *t < at - 1e-9).min(last);
        let back = steady.theta[k] - at;
        let value = |values: &[f64]| {
            if back <= 1e-9 || k == 0 {
                return values[k];
            }
            let part = back / (steady.theta[k] - steady.theta[k - 1]);
            values[k] + part * (values[k - 1] - values[k])
        };
        forces.push(value(&steady.contact));
        heights.push(value(&steady.deflection));
        outputs.push(value(&steady.output));
    }
    let (low, high) = steady.contact_extremes();
    out.force = Force {
        min: low.value,
        max: high.value,
        rms_error: p.rms_error(&outputs),
    };
    out.torque = p.signed(p.sampled_torque(input, &forces));
    let pulled = forces.iter().filter(|f| **f < 0.0).count() as f64 / n as f64;
    note_pull(&mut out, input, p, pulled);
    out.contact_lost = !p.held && low.value < 0.0;
    if out.contact_lost {
        out.notes.push(RunNote::FlexiblePulls);
    }
    p.fill(input, &mut out, &forces, &heights);
    Ok(out)
}

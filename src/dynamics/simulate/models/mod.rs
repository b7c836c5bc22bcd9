//! Simulation of a prepared cam with each model.

mod contact;
mod flexible;
mod in_time;
mod rigid;

pub(super) use contact::contact_run;
pub(super) use flexible::flexible_run;
pub(super) use rigid::rigid_run;

use super::prepared::Prepared;
use crate::dynamics::outcome::{Model, Outcome};
use crate::dynamics::reason::RunNote;
use crate::dynamics::run::Run;
use crate::error::Result;
use crate::units::Quantity;

/// Simulates a prepared cam with one model; the rigid model for `Auto`.
pub(super) fn under(input: &Run, p: &Prepared, model: Model) -> Result<Outcome> {
    match model {
        Model::Auto | Model::Rigid => rigid_run(input, p),
        Model::Flexible => flexible_run(input, p),
        Model::Contact => contact_run(input, p),
    }
}

/// Records the fraction `pulled` of the cycle in which the force is negative, as the fraction without contact. If the follower is in a
/// groove or on a conjugate pair, contact is not lost. A note then states the fraction.
fn note_pull(out: &mut Outcome, input: &Run, p: &Prepared, pulled: f64) {
    if !p.held {
        out.lost_fraction = pulled;
        return;
    }
    if pulled <= 0.0 {
        return;
    }
    let (part, force) = (Quantity::share(pulled), p.load(-out.force.min));
    out.notes.push(if input.machine.conjugate.is_some() {
        RunNote::SecondCamBears { part, force }
    } else {
        RunNote::OtherWallBears { part, force }
    });
}

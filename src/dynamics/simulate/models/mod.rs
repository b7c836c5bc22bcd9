//! One run of a prepared cam under each model.

mod contact;
mod flexible;
mod rigid;

pub(super) use contact::contact_run;
pub(super) use flexible::flexible_run;
pub(super) use rigid::rigid_run;

use super::prepared::Prepared;
use crate::dynamics::outcome::Outcome;
use crate::dynamics::reason::RunNote;
use crate::dynamics::run::Run;
use crate::units::Quantity;

/// Where a groove or a pair holds the follower from both sides a pull is the other side's push.
fn note_other_side(out: &mut Outcome, input: &Run, p: &Prepared, pulled: f64) {
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

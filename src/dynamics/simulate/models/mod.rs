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

/// In a groove or a conjugate pair a negative force is carried by the other side.
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

//! One run of a prepared cam under each model.

mod contact;
mod flexible;
mod rigid;

pub(super) use contact::contact_run;
pub(super) use flexible::flexible_run;
pub(super) use rigid::rigid_run;

use super::outcome::Outcome;
use super::run::Run;

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

//! Exit codes of the command.

use gaitcam::cam::Verdict;
use gaitcam::error::Error;

/// Built, and every check passes.
pub const BUILT: u8 = 0;
/// Internal error, or an answer that could not be written.
pub const INTERNAL_ERROR: u8 = 1;
/// Invalid input: the message names the fault.
pub const BAD_INPUT: u8 = 2;
/// No feasible cam, or a failed check.
pub const NO_SUCH_CAM: u8 = 3;
/// Interrupted by Ctrl-C, as in shells.
pub const INTERRUPTED: u8 = 130;

/// The exit code of an error.
pub fn of_error(error: &Error) -> u8 {
    if error.is_answer() {
        NO_SUCH_CAM
    } else {
        BAD_INPUT
    }
}

/// The exit code of a design.
pub fn of(verdict: Verdict) -> u8 {
    match verdict {
        Verdict::Acceptable | Verdict::NotForHighSpeed => BUILT,
        Verdict::Unacceptable => NO_SUCH_CAM,
    }
}

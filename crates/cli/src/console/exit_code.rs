//! Exit codes of the command.

use gaitcam::cam::Verdict;
use gaitcam::error::Error;

/// A cam was designed, and every check passes.
pub const BUILT: u8 = 0;
/// Internal error, or an output that could not be written.
pub const INTERNAL_ERROR: u8 = 1;
/// Invalid input. The message names the fault.
pub const BAD_INPUT: u8 = 2;
/// There is no feasible cam, or a check fails.
pub const NO_SUCH_CAM: u8 = 3;
/// Interrupted by Ctrl-C; the code that shells use.
pub const INTERRUPTED: u8 = 130;

/// Exit code of an error.
pub fn of_error(error: &Error) -> u8 {
    if error.is_answer() {
        NO_SUCH_CAM
    } else {
        BAD_INPUT
    }
}

/// Exit code of a design.
pub fn of(verdict: Verdict) -> u8 {
    match verdict {
        Verdict::Acceptable | Verdict::NotForHighSpeed => BUILT,
        Verdict::Unacceptable => NO_SUCH_CAM,
    }
}

//! Exit codes of the command `gaitcam`.

use gaitcam::cam::Verdict;
use gaitcam::error::Error;

/// A cam was designed, and every check passes. The verdict may still be "not for high speed".
pub const BUILT: u8 = 0;
/// Internal error, or an output that could not be written.
pub const INTERNAL_ERROR: u8 = 1;
/// Invalid input. The error message describes the fault.
pub const BAD_INPUT: u8 = 2;
/// There is no feasible cam, or a check fails.
pub const NO_SUCH_CAM: u8 = 3;
/// Interrupted by Ctrl-C. Shells report the same code.
pub const INTERRUPTED: u8 = 130;

/// Exit code for an error: 3 if the scene is valid but has no feasible cam, otherwise 2.
pub fn of_error(error: &Error) -> u8 {
    if error.is_answer() {
        NO_SUCH_CAM
    } else {
        BAD_INPUT
    }
}

/// Exit code for the verdict on a design: 3 if the design is unacceptable, otherwise 0.
pub fn of(verdict: Verdict) -> u8 {
    match verdict {
        Verdict::Acceptable | Verdict::NotForHighSpeed => BUILT,
        Verdict::Unacceptable => NO_SUCH_CAM,
    }
}

//! Laws for a machine that responds to the cam: a follower that gives, a shaft whose speed varies, a floor that moves. Each
//! designs for a rigid machine at constant speed, runs it, and designs again for what that says.

mod added;
mod in_motion;
mod polydyne;
mod runner;
pub mod sensitivity;

use super::design::Design;
use super::search::Search;
use crate::error::Result;
use crate::problem::Problem;

/// Whether the machine that a problem is designed for responds to the cam.
pub fn responds(problem: &Problem) -> bool {
    let machine = &problem.machine;
    if problem.on_shaft.is_some() {
        // The problem is that of a machine in a known motion.
        return false;
    }
    if problem.law.polydyne {
        // A fault of the follower is found by the design.
        return !matches!(problem.train(), Ok(None));
    }
    !machine.is_plain()
}

/// The design for such a machine.
///
/// # Errors
/// Faults of the input; the shaft stops; the rounds do not contract; an undamped mode in resonance.
pub fn designed(problem: &Problem, search: &Search) -> Result<Design> {
    if problem.law.polydyne
        && let Some(train) = problem.train()?
    {
        return polydyne::designed(problem, search, &train);
    }
    in_motion::designed(problem, search)
}

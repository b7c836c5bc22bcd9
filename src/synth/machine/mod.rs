//! Laws for a machine that responds to the cam: a compliant follower, a shaft with varying speed, a moving floor. The first design is for a
//! rigid machine at constant speed. Each following design uses the simulated machine motion of the previous one.

mod added;
mod assumed;
mod in_motion;
mod polydyne;
mod runner;
pub mod sensitivity;
mod through_floor;

use super::design::Design;
use super::search::Search;
use crate::error::Result;
use crate::problem::Problem;

/// Whether the machine of a problem responds to the cam, so that one design for a rigid machine is not sufficient.
pub fn responds(problem: &Problem) -> bool {
    let machine = &problem.machine;
    if problem.on_shaft.is_some() {
        // The problem already contains a given motion of the machine.
        return false;
    }
    if problem.law.polydyne {
        // If the data of the follower are invalid, the design reports the error.
        return !matches!(problem.train(), Ok(None));
    }
    !machine.is_plain()
}

/// Design for a machine that responds to the cam.
///
/// # Errors
///
/// Errors of the input. The shaft stops, the iteration does not converge, or an undamped mode is at resonance.
pub fn designed(problem: &Problem, search: &Search) -> Result<Design> {
    if problem.law.polydyne
        && let Some(train) = problem.train()?
    {
        return polydyne::designed(problem, search, &train);
    }
    in_motion::designed(problem, search)
}

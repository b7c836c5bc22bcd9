//! Design of a problem, for one force or many walkers. The motion of the machine may depend on the cam.

use super::attempt::{attempt, under_limits};
use super::design::Design;
use super::finish::{Reports, finished};
use super::machine;
use super::phase;
use super::population;
use super::search::Search;
use super::sizing::check_arm;
use crate::cam::Verdict;
use crate::error::Result;
use crate::problem::Problem;

/// Design of a problem. If the limits are infeasible, it is the best design without them.
///
/// # Errors
///
/// Errors of the input. No cam exists, for example because no law satisfies the conditions.
pub fn design(problem: &Problem, search: &Search) -> Result<Design> {
    check_arm(problem)?;
    let is_plain = !machine::responds(problem);
    let walkers = problem.walkers.as_deref();
    if let Some(walkers) = walkers.filter(|w| w.each.len() > 1 || is_plain) {
        return population::designed(problem, search, walkers);
    }
    let problem = &*phase::best(problem, search)?;
    if !is_plain {
        return machine::designed(problem, search);
    }
    let plain = attempt(problem, search)?;
    Ok(finished(problem, search, plain, Reports::default()))
}

/// A design that passes every check but need not be optimal. It is fast enough for interactive use. `None` if no such design is found.
///
/// ```
/// use gaitcam::synth::{Search, passing};
/// use gaitcam::{Problem, scene};
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let at = |stroke| -> gaitcam::error::Result<_> {
///     let scene = scene.with("limits.stroke", stroke)?;
///     passing(&Problem::resolve(&scene, scene.model_force()?.as_ref())?, &Search::default())
/// };
/// assert!(at("60 mm")?.is_some());
/// assert!(at("1 mm")?.is_none());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
///
/// # Errors
/// Errors of the input.
pub fn passing(problem: &Problem, search: &Search) -> Result<Option<Design>> {
    kept(problem, &search.for_passing_designs())
}

/// Design of a problem if its verdict is not unacceptable; otherwise `None`, without a diagnosis of infeasibility.
///
/// # Errors
///
/// Errors of the input.
pub fn kept(problem: &Problem, search: &Search) -> Result<Option<Design>> {
    let design = if machine::responds(problem) || population::is_judged(problem) {
        Some(design(problem, search)?)
    } else {
        let problem = phase::best(&population::of_mean(problem), search)?.into_owned();
        let plain = under_limits(&problem, search)?.ok();
        plain.map(|plain| finished(&problem, search, plain, Reports::default()))
    };
    Ok(design.filter(|design| design.verdict != Verdict::Unacceptable))
}

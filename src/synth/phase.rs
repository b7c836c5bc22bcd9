//! Free phase between force cycle and cam angle, for laws with conditions at cam angles (points, dwells, a programme). The force error as a
//! function of the phase has several minima. The best phase on a grid is therefore refined by Brent's method. The result is deterministic.

use std::borrow::Cow;
use std::f64::consts::TAU;

use argmin::core::{CostFunction, Executor, State};
use argmin::solver::brent::BrentOpt;

use super::families;
use super::report::force::ForceReport;
use super::search::Search;
use crate::error::{Placed, Result, SynthError};
use crate::problem::Problem;
use crate::scene::Minimise;

/// Number of equally spaced phases on the grid, of which the best is refined.
const VISITED: usize = 36;
/// Tolerance of the phase in Brent's method, rad.
const RESOLVED: f64 = 1e-6;
/// Maximum number of iterations of Brent's method.
const STEPS: u64 = 60;

/// The problem at the phase of minimum force error. A problem with a given phase is returned unchanged.
///
/// # Errors
///
/// No phase is feasible, and the input is invalid at some phases.
pub fn best<'p>(problem: &'p Problem, search: &Search) -> Result<Cow<'p, Problem>> {
    deepest(problem, |at| least_error(&at, search))
}

/// RMS force error, N, of the law with the smallest error within the limits of a problem; `None` if the limits are infeasible.
fn least_error(problem: &Problem, search: &Search) -> Result<Option<f64>> {
    let of_force = problem.limited_error().is_some() && !problem.is_weighed();
    let of_force = of_force.then(|| problem.minimising(Minimise::ForceError));
    let problem = of_force.as_ref().unwrap_or(problem);
    let found = families::law(problem, search)?.ok();
    Ok(found.map(|found| ForceReport::of(problem, &found.law).rms_error_n))
}

/// The problem at the phase for which `error` is minimum.
fn deepest(
    problem: &Problem,
    error: impl Fn(Problem) -> Result<Option<f64>>,
) -> Result<Cow<'_, Problem>> {
    if !problem.phase_is_free {
        return Ok(Cow::Borrowed(problem));
    }
    let phases = Phases(|phase| error(problem.at_phase(phase)));
    let mut best: Option<(f64, f64)> = None;
    let mut failure = None;
    for i in 0..VISITED {
        let phase = TAU * i as f64 / VISITED as f64;
        match phases.0(phase) {
            Ok(Some(error)) if best.is_none_or(|b| error < b.1) => best = Some((phase, error)),
            Ok(_) => {}
            Err(e) => failure = Some(e),
        }
    }
    let Some((near, error)) = best else {
        // If no phase has a law, the conflict is diagnosed at the first phase.
        return match failure {
            Some(e) => Err(e),
            None => Ok(Cow::Owned(problem.at_phase(0.0))),
        };
    };
    let width = TAU / VISITED as f64;
    let done = Executor::new(
        phases,
        BrentOpt::new(near - width, near + width).set_tolerance(RESOLVED, RESOLVED),
    )
    .configure(|state| state.max_iters(STEPS))
    .run()
    .map_err(|e| {
        SynthError::SearchFailed {
            fault: e.to_string(),
        }
        .at_key("gait.phase")
    })?;
    let found = match done.state().get_best_param() {
        Some(&phase) if done.state().get_best_cost() < error => phase.rem_euclid(TAU),
        _ => near,
    };
    Ok(Cow::Owned(problem.at_phase(found)))
}

/// Force error as a function of the phase, as the objective of Brent's method.
struct Phases<F>(F);

impl<F: Fn(f64) -> Result<Option<f64>>> CostFunction for Phases<F> {
    type Param = f64;
    type Output = f64;

    fn cost(&self, phase: &f64) -> std::result::Result<f64, argmin::core::Error> {
        Ok(self.0(*phase)?.unwrap_or(f64::MAX))
    }
}

//! A free phase: where in the cycle of the force the cam's turn begins.
//!
//! A law that is tied to cam angles (points, dwells, a programme) meets a force that may be shifted. The
//! error over the phase has several valleys, so all of them are visited first and the deepest one is
//! searched by Brent's method; the same scene always gives the same phase.

use std::f64::consts::TAU;

use argmin::core::{CostFunction, Executor, State};
use argmin::solver::brent::BrentOpt;

use super::families::{NoLaw, find_law, on_base_circle};
use super::limits::force_report;
use crate::error::{Placed, Result, SynthError};
use crate::problem::Problem;

/// Phases looked at before the search.
const VISITED: usize = 36;
/// The search ends when the phase is known to this, rad.
const RESOLVED: f64 = 1e-9;
/// Steps of the search.
const STEPS: u64 = 60;

/// The problem with its phase settled: as it is, or at the least force error over all phases.
///
/// # Errors
/// No phase has a law, and at some the input is at fault.
pub fn settled(problem: Problem) -> Result<Problem> {
    if !problem.phase_is_free {
        return Ok(problem);
    }
    let search = Search { problem: &problem };
    let mut best: Option<(f64, f64)> = None;
    let mut failure = None;
    for i in 0..VISITED {
        let phase = TAU * i as f64 / VISITED as f64;
        match search.error(phase) {
            Ok(Some(error)) if best.is_none_or(|b| error < b.1) => best = Some((phase, error)),
            Ok(_) => {}
            Err(e) => failure = Some(e),
        }
    }
    let Some((near, error)) = best else {
        // Without a law at any phase the conflict is explained at the first.
        return match failure {
            Some(e) => Err(e),
            None => problem.at_phase(0.0),
        };
    };
    let width = TAU / VISITED as f64;
    let done = Executor::new(
        search,
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
    problem.at_phase(found)
}

struct Search<'a> {
    problem: &'a Problem,
}

impl Search<'_> {
    /// RMS force error of the best law at a phase, N; `None` where limits leave no law.
    fn error(&self, phase: f64) -> Result<Option<f64>> {
        let problem = self.problem.clone().at_phase(phase)?;
        match find_law(&problem) {
            Ok(found) => {
                let law = on_base_circle(&problem, found.law);
                Ok(Some(force_report(&problem, &law).rms_error_n))
            }
            Err(NoLaw::Stuck(_)) => Ok(None),
            Err(NoLaw::Fault(fault)) => Err(fault),
        }
    }
}

impl CostFunction for Search<'_> {
    type Param = f64;
    type Output = f64;

    fn cost(&self, phase: &f64) -> std::result::Result<f64, argmin::core::Error> {
        Ok(self.error(*phase)?.unwrap_or(f64::MAX))
    }
}

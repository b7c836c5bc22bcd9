//! A free phase: where in the cycle of the force the cam's turn begins.
//!
//! A law that is tied to cam angles (points, dwells, a programme) meets a force that may be shifted. The
//! error over the phase has several valleys, so all of them are visited first and the deepest one is
//! searched by Brent's method; the same scene always gives the same phase.

use std::f64::consts::TAU;

use argmin::core::{CostFunction, Executor, State};
use argmin::solver::brent::BrentOpt;

use super::demand::Demand;
use super::{find_law, on_base_circle, verify};
use crate::error::{Error, Result};
use crate::force::ForceCurve;
use crate::scene::{Phase, Scene};

/// Phases looked at before the search.
const VISITED: usize = 36;
/// The search ends when the phase is known to this, rad.
const RESOLVED: f64 = 1e-9;
/// Steps of the search.
const STEPS: u64 = 60;

/// The scene with its phase settled: as it is, or at the least force error over all phases.
///
/// Returns the phase that was found, where it was free. Fails where no phase has a law.
pub fn settle(scene: &Scene, target: Option<&ForceCurve>) -> Result<(Scene, Option<f64>)> {
    let (Some(gait), Some(target)) = (&scene.gait, target) else {
        return Ok((scene.clone(), None));
    };
    if gait.phase != Phase::Free {
        return Ok((scene.clone(), None));
    }
    let search = Search { scene, target };
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
            None => Ok((search.at(0.0), Some(0.0))),
        };
    };
    let width = TAU / VISITED as f64;
    let done = Executor::new(
        Search { scene, target },
        BrentOpt::new(near - width, near + width).set_tolerance(RESOLVED, RESOLVED),
    )
    .configure(|state| state.max_iters(STEPS))
    .run()
    .map_err(|e| Error::key("gait.phase", e.to_string()))?;
    let found = match done.state().get_best_param() {
        Some(&phase) if done.state().get_best_cost() < error => phase.rem_euclid(TAU),
        _ => near,
    };
    Ok((search.at(found), Some(found)))
}

struct Search<'a> {
    scene: &'a Scene,
    target: &'a ForceCurve,
}

impl Search<'_> {
    fn at(&self, phase: f64) -> Scene {
        let mut scene = self.scene.clone();
        if let Some(gait) = &mut scene.gait {
            gait.phase = Phase::At(phase);
        }
        scene
    }

    /// RMS force error of the best law at a phase, N; `None` where limits leave no law.
    fn error(&self, phase: f64) -> Result<Option<f64>> {
        let scene = self.at(phase);
        let demand = Demand::settle(&scene, Some(self.target))?;
        let found = find_law(&scene, &demand)?;
        if found.infeasible.is_some() {
            return Ok(None);
        }
        let law = on_base_circle(&scene, &demand, found.law);
        Ok(Some(verify::law_force(&demand, &law).rms_error_n))
    }
}

impl CostFunction for Search<'_> {
    type Param = f64;
    type Output = f64;

    fn cost(&self, phase: &f64) -> std::result::Result<f64, argmin::core::Error> {
        Ok(self.error(*phase)?.unwrap_or(f64::MAX))
    }
}

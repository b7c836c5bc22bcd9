//! Function `synth`, which designs the cam of a scene.

use std::sync::Arc;

use gaitcam::error::Result;
use gaitcam::force::Walker;
use gaitcam::scene::Gait;
use gaitcam::synth::{Outcome, Search};
use gaitcam_app::Input;
use gaitcam_output::Timing;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::convert::Argument;
use crate::design::Design;
use crate::error::Raise;
use crate::force::Force;
use crate::interrupt::{self, Interrupt};
use crate::scene::Scene;

/// Designs the cam for a scene.
///
/// Parameters
/// ----------
/// scene : Scene, optional
///     Scene to design. The default is the built-in footbridge.
/// force : Force, optional
///     Target force that replaces the force of the scene.
/// forces : sequence of Force, optional
///     Cycles of several walkers. One cam is designed for all of them, with the objective ``law.robust`` and the adjustment
///     ``gait.adjust``. Forces with the same name are cycles of one walker. ``summary["population"]`` contains the errors.
/// time_limit : float
///     Time limit of the search, s. When it is reached, the best result so far is used.
///
/// Returns
/// -------
/// Design
///     A design is also returned if no cam satisfies the limits, or if there is no cam at all. In these cases, ``verdict`` is
///     ``unacceptable`` and ``summary["reasons"]`` contains the reasons.
///
/// Raises
/// ------
/// InputError
///     The scene, its recording or the force is invalid.
#[pyfunction]
#[pyo3(signature = (scene = None, *, force = None, forces = None, time_limit = 60.0))]
pub fn synth(
    py: Python<'_>,
    scene: Option<&Bound<'_, PyAny>>,
    force: Option<&Bound<'_, PyAny>>,
    forces: Option<Vec<PyRef<'_, Force>>>,
    time_limit: f64,
) -> PyResult<Design> {
    let (scene, force) = asked(py, scene, force, forces)?;
    answer(py, scene, force, time_limit)
}

/// Scene and force from the arguments of a call. The default scene is the built-in footbridge. If no force is given, the returned force is
/// `None`, and the scene defines the force.
///
/// If several forces are given, the forces of walkers that the scene excludes by name are omitted.
pub(crate) fn asked(
    py: Python<'_>,
    scene: Option<&Bound<'_, PyAny>>,
    force: Option<&Bound<'_, PyAny>>,
    forces: Option<Vec<PyRef<'_, Force>>>,
) -> PyResult<(Scene, Option<Force>)> {
    let scene = scene.map(|s| Scene::given(s, "scene")).transpose()?;
    let scene = Scene::or_default(py, scene.map(Bound::get))?;
    let force = match forces {
        Some(_) if force.is_some() => {
            return Err(PyTypeError::new_err("give force or forces, not both"));
        }
        Some(mut forces) => {
            let given = Gait::given();
            let gait = scene.input.scene.gait.as_ref().unwrap_or(&given);
            forces.retain(|force| !gait.leave_out.contains(&force.name));
            let walker = |force: &PyRef<'_, Force>| Walker::new(&force.name, force.curve.clone());
            check_open(gait, forces.iter().map(walker)).raise(py)?;
            Some(Force::of_walkers(py, &forces)?)
        }
        None => Force::of_argument(force)?,
    };
    Ok((scene, force))
}

/// Rejects walkers whose recordings have open questions that the scene does not accept.
fn check_open(gait: &Gait, walkers: impl Iterator<Item = Walker>) -> Result<()> {
    let open: Vec<Walker> = walkers
        .filter(|walker| !gait.open_questions(&walker.curve).is_empty())
        .collect();
    if open.is_empty() {
        return Ok(());
    }
    gait.walkers(open, &[]).map(drop)
}

/// Designs a scene. A given force replaces the force of the scene.
pub(crate) fn answer(
    py: Python<'_>,
    asked: Scene,
    force: Option<Force>,
    time_limit: f64,
) -> PyResult<Design> {
    let input = match &force {
        Some(force) => force.named_in(&asked.input).raise(py)?,
        None => asked.whole(py)?.clone(),
    };
    let interrupt = Interrupt::after(interrupt::limit(py, time_limit)?);
    let made = py.detach(|| made(&input, force.as_ref(), &interrupt));
    interrupt.result()?;
    let (made, solve_s) = made.raise(py)?;
    let time = Timing {
        solve_s,
        total_s: interrupt.elapsed_s(),
    };
    Ok(Design {
        outcome: made,
        input,
        asked,
        force,
        time,
        time_limit,
        recut: None,
        logs: Vec::new(),
    })
}

fn made(
    input: &Input,
    force: Option<&Force>,
    interrupt: &Arc<Interrupt>,
) -> Result<(Outcome, f64)> {
    let named = match force {
        Some(_) => None,
        None => input.target()?,
    };
    let target = force.map(|f| &f.curve).or(named.as_ref());
    let search = Search::until(interrupt.halt());
    let begun = interrupt.elapsed_s();
    let outcome = gaitcam::synth::answer(&input.scene, target, &search)?;
    let solve_s = interrupt.elapsed_s() - begun;
    Ok((outcome.relaxed_with(&search), solve_s))
}

//! Design of several cams for a population of walkers.

use gaitcam::cover::{Cover, covers, folds};
use gaitcam::error::{Placed, SynthError};
use gaitcam::force::{ForceCurve, Walker};
use gaitcam::scene::set_value;
use gaitcam::synth::Outcome;
use gaitcam_app::design::{MOST_CAMS, law_of_cam};
use gaitcam_output::{Timing, cover_tables};
use pyo3::prelude::*;

use crate::convert;
use crate::design::Design;
use crate::error::{Raise, argument};
use crate::force::Force;
use crate::interrupt;
use crate::scene::Scene;
use crate::synth::asked;
use crate::table::Table;

/// Designs sets of cams for a population of walkers, and computes the force errors for each number of cams.
///
/// Each walker is assigned to one cam. Cross-validation estimates the errors for new walkers.
///
/// Parameters
/// ----------
/// scene : Scene, optional
///     Scene with the machine, its limits, ``law.robust`` and ``gait.adjust``. The default is the built-in footbridge.
/// forces : sequence of Force, optional
///     Cycles of the walkers, which replace those in the scene. Forces with the same name are cycles of one walker.
/// cams : int
///     Maximum number of cams. All numbers from 1 to ``cams`` are computed, but not more than one cam per walker.
/// time_limit : float
///     Time limit of the search, s. When it is reached, the result contains only the completed numbers of cams.
///
/// Returns
/// -------
/// Cover
///     Object with three tables and the designs. ``cams`` contains the mean error, the maximum error and the lower bound for
///     each number of cams. ``assignment`` contains the cam of each cycle, numbered from 1, and its error. ``folds`` contains
///     the errors of walkers with cams that were designed without them. ``designs[k - 1][i - 1]`` is cam i of the set of k cams.
///
/// Raises
/// ------
/// InputError
///     There are fewer than two walkers, or a recording cannot be read.
#[pyfunction]
#[pyo3(signature = (scene = None, *, forces = None, cams = 6, time_limit = 60.0))]
pub fn cover<'py>(
    py: Python<'py>,
    scene: Option<&Bound<'py, PyAny>>,
    forces: Option<Vec<PyRef<'py, Force>>>,
    #[pyo3(from_py_with = convert::whole)] cams: usize,
    time_limit: f64,
) -> PyResult<Bound<'py, PyAny>> {
    if !(1..=MOST_CAMS).contains(&cams) {
        let what = format!("{cams} cams; give a number from 1 to {MOST_CAMS}");
        return Err(argument(py, "cams", what));
    }
    let (scene, force) = asked(py, scene, None, forces)?;
    let input = match &force {
        Some(force) => force.named_in(&scene.input).raise(py)?,
        None => scene.whole(py)?.clone(),
    };
    let found = interrupt::run(py, time_limit, |search| {
        let target = match &force {
            Some(force) => Some(force.curve.clone()),
            None => input.target()?,
        };
        let one = || SynthError::OneWalker.at_key("gait.file");
        let read = target.and_then(|t| t.population).ok_or_else(one)?;
        let whole = ForceCurve::of_walkers(read.walkers.clone())?;
        let found = covers(&input.scene, &whole, cams, search)?;
        Ok((found, folds(&input.scene, &whole, cams, search)?, read))
    });
    let (found, other, population) = found?.raise(py)?;
    let error = input.scene.law.error;
    let designs: PyResult<Vec<Vec<Design>>> = (found.iter())
        .map(|cover| of_cover(py, &scene, cover, &population.walkers, time_limit))
        .collect();
    let tables = [
        cover_tables::cover(&found, error),
        cover_tables::assignment(&found, error),
        cover_tables::folds(&other, error),
    ];
    let [cams, assignment, folds] = tables.map(|records| Table::new(records, Vec::new()));
    let class = py.import("gaitcam")?.getattr("Cover")?;
    class.call1((cams, assignment, folds, designs?))
}

/// Converts the cams of a set to designs. Each design contains the forces of the walkers that are assigned to its cam.
fn of_cover(
    py: Python<'_>,
    scene: &Scene,
    cover: &Cover,
    walkers: &[Walker],
    time_limit: f64,
) -> PyResult<Vec<Design>> {
    let design = |(cam, design): (usize, &gaitcam::synth::Design)| {
        let served = |w: &&Walker| {
            let mut each = cover.each.iter();
            each.any(|a| a.cam == cam && a.error.walker == w.name)
        };
        let served: Vec<Walker> = walkers.iter().filter(served).cloned().collect();
        let force = Force::of_population(py, &served)?;
        let mut table = scene.input.table.clone();
        for (key, value) in law_of_cam(cover, cam) {
            set_value(&mut table, key, value).raise(py)?;
        }
        let files = scene.input.files.clone();
        let asked = Scene::of_table(py, table, files, scene.input.file.clone())?;
        Ok(Design {
            outcome: Outcome::Built(Box::new(design.clone())),
            input: force.named_in(&asked.input).raise(py)?,
            asked,
            force: Some(force),
            time: Timing::default(),
            time_limit,
            recut: None,
            logs: Vec::new(),
        })
    };
    cover.cams.iter().enumerate().map(design).collect()
}

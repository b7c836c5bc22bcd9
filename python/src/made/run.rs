//! Simulation of the cam, with the lift recovered from the points of its exported profile.

use gaitcam::cam::Measures;
use gaitcam::dynamics::{self, Model, Outcome};
use gaitcam::wording::Language;
use gaitcam_app::design::{is_of_machine, put_on, put_under};
use gaitcam_output::simulation;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::{self, Argument, Reduced};
use crate::design::Design;
use crate::error::{NoSuchCam, Raise, argument};
use crate::force::Force;
use crate::html;
use crate::scene::Scene;
use crate::table::Table;

/// Result of a simulation of the cam, with the lift recovered from the points of its exported profile.
#[pyclass(frozen, module = "gaitcam")]
pub struct Run {
    outcome: Outcome,
    verdict: &'static str,
    name: String,
    design: Py<Design>,
    asked: Model,
    machine: Option<Py<PyDict>>,
    force: Option<Py<PyAny>>,
}

/// Simulates the cam of a design. The lift is recovered from the points of the exported profile instead of the exact law.
///
/// Parameters
/// ----------
/// design : Design
/// model : str
///     Model of the machine: "rigid", "flexible", "contact", or "auto" for the simplest sufficient model.
/// machine : dict, optional
///     Changes of the machine in which the cam runs, by dotted keys of a scene: ``{"drive.mass": "9 kg", "drive.speed": "150 rpm",
///     "machine.stiffness": "2e5 N/m", "machine.restitution": 0.4}``. Only ``drive.*`` and ``machine.*`` are allowed, because the
///     cam does not change.
/// force : Force, optional
///     Force of another walker, which is the target force in this simulation. If the scene contains no mass or speed of the machine,
///     they are computed from this force.
///
/// Raises
/// ------
/// NoSuchCam
///     The design has no cam.
#[pyfunction]
#[pyo3(signature = (design, model = "auto", *, machine = None, force = None))]
pub fn simulate(
    py: Python<'_>,
    design: &Bound<'_, PyAny>,
    model: &str,
    machine: Option<&Bound<'_, PyDict>>,
    force: Option<&Bound<'_, PyAny>>,
) -> PyResult<Run> {
    let made = Design::given(design, "design")?;
    let design = made.get();
    let Some(model) = Model::parse(model) else {
        let what = format!("{model:?} is no model; give auto, rigid, flexible or contact");
        return Err(argument(py, "model", what));
    };
    let cam = design.shown()?;
    if let Some(why) = cam.no_cam(Language::En) {
        return Err(NoSuchCam::new_err(why));
    }
    let other = Force::of_argument(force)?;
    let scene = scene_of(py, design, machine, other.as_ref())?;
    let judged = match (&other, machine) {
        (Some(force), _) => put_under(cam.clone(), &scene, &force.curve).raise(py)?,
        (None, Some(_)) => put_on(cam.clone(), &scene).raise(py)?.0,
        (None, None) => cam.clone(),
    };
    let spec = scene.machine;
    let drive = judged.problem.drive;
    let outcome = py.detach(|| dynamics::simulate(&judged.emitted(&spec, drive)?, model));
    let outcome = outcome.raise(py)?;
    let judged = judged.judged_in(&outcome);
    Ok(Run {
        outcome,
        verdict: judged.verdict.name(),
        name: judged.problem.name.clone(),
        design: made.clone().unbind(),
        asked: model,
        machine: machine.map(|m| m.copy()).transpose()?.map(Bound::unbind),
        force: force.map(|f| f.clone().unbind()),
    })
}

/// Scene of a design with a changed machine and, if given, another force.
fn scene_of(
    py: Python<'_>,
    design: &Design,
    changes: Option<&Bound<'_, PyDict>>,
    force: Option<&Force>,
) -> PyResult<gaitcam::scene::Scene> {
    let input = match force {
        Some(force) => force.named_in(&design.input).raise(py)?,
        None => design.input.clone(),
    };
    let Some(changes) = changes else {
        return Ok(input.scene);
    };
    for key in changes.keys() {
        let key: String = key.extract()?;
        if !is_of_machine(&key) {
            let what = "the cam is cut: only keys of drive and machine change".to_string();
            return Err(argument(py, &key, what));
        }
    }
    Ok(Scene::of_input(input).changed(py, changes)?.input.scene)
}

#[pymethods]
impl Run {
    /// Simulated model: "rigid", "flexible" or "contact".
    #[getter]
    fn model(&self) -> &'static str {
        self.outcome.model.name()
    }

    /// Reason why this model was selected, as a sentence.
    #[pyo3(signature = (lang = "en"))]
    fn why(&self, py: Python<'_>, lang: &str) -> PyResult<String> {
        Ok(self.outcome.why.sentence(crate::asked::language(py, lang)?))
    }

    /// Verdict on the cam after the simulation: ``acceptable``, ``not-for-high-speed`` or ``unacceptable``.
    #[getter]
    fn verdict(&self) -> &'static str {
        self.verdict
    }

    /// Whether the follower loses contact with the cam.
    #[getter]
    fn contact_lost(&self) -> bool {
        self.outcome.contact_lost
    }

    /// Results as in ``gaitcam simulate --json``. Numbers are in SI units, and names end with the unit.
    #[getter]
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let mut json = simulation::json(&self.outcome);
        json["verdict"] = self.verdict.into();
        convert::json(py, &json)
    }

    /// One repetition of the motion at equal steps of the cam angle, as in ``dynamics.csv``.
    #[getter]
    fn table(&self) -> Table {
        Table::of_numbers(simulation::columns(&self.outcome))
    }

    fn _repr_html_(&self) -> String {
        let measures = match self.outcome.swings {
            true => Measures::Oscillating,
            false => Measures::Translating,
        };
        let text = simulation::table(&self.outcome, measures, Language::En);
        html::head(&self.name, self.verdict) + &html::fixed(&text)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, (&Py<Design>, &'static str)> {
        // The inputs determine a run, so only the inputs are pickled.
        let simulate = py.import("gaitcam")?.getattr("simulate")?;
        let keywords = PyDict::new(py);
        keywords.set_item("machine", self.machine.as_ref())?;
        keywords.set_item("force", self.force.as_ref())?;
        let partial = py.import("functools")?.getattr("partial")?;
        let question = partial.call((simulate,), Some(&keywords))?;
        Ok((question, (&self.design, self.asked.name())))
    }

    fn __repr__(&self) -> String {
        let model = self.outcome.model.name();
        format!("<gaitcam.Run {:?} ({model}): {}>", self.name, self.verdict)
    }
}

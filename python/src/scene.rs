//! Class `Scene`: the complete definition of a design problem.

use std::path::{Path, PathBuf};

use gaitcam::error::{Error, SceneError};
use gaitcam::scene;
use gaitcam_app::scene::parse;
use gaitcam_app::{Disk, Input};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::{self, Argument, Reduced};
use crate::error::{Raise, raised};

/// A scene: target force, drive (relation between lift and force), law of motion, cam and limits.
///
/// ``Scene({"drive": {"mass": "8 kg"}, ...})`` takes the sections of a scene file. Quantities are texts with their unit, or numbers if the
/// key ends with the SI unit: ``"mass_kg": 8.0``. ``Scene()`` is empty. If a scene contains no force, an argument of :func:`synth` must
/// define the force. Scenes are immutable: ``set`` returns a new scene.
#[pyclass(frozen, module = "gaitcam", eq)]
#[derive(Clone)]
pub struct Scene {
    /// Parsed scene with its table and its folder.
    pub input: Input,
    /// Error of the scene if no force is added to it; `None` if the scene is complete.
    lacks_force: Option<Error>,
}

impl PartialEq for Scene {
    fn eq(&self, other: &Scene) -> bool {
        let source = |s: &Scene| s.input.recording();
        self.input.scene == other.input.scene && source(self) == source(other)
    }
}

impl Scene {
    /// Creates a scene with the given table. `synth` or a sweep can add the force later.
    pub fn of_table(
        py: Python<'_>,
        table: toml::Table,
        files: Disk,
        file: Option<PathBuf>,
    ) -> PyResult<Scene> {
        let input = py.detach(|| Input::new(table.clone(), files.clone(), file.clone()));
        let fault = match input {
            Ok(input) => return Ok(Scene::of_input(input)),
            Err(fault) => fault,
        };
        let open = matches!(
            fault.fault(),
            Some(SceneError::NoForceNamed | SceneError::NothingAsked)
        );
        if !open {
            return Err(raised(py, fault));
        }
        let whole = files.with_motions(&table).raise(py)?;
        let scene = scene::read_keys(&whole).raise(py)?;
        let input = Input {
            scene,
            table,
            whole,
            files,
            file,
        };
        Ok(Scene {
            input,
            lacks_force: Some(fault),
        })
    }

    /// Creates a complete scene, which defines its force or its motion programme.
    pub fn of_input(input: Input) -> Scene {
        Scene {
            input,
            lacks_force: None,
        }
    }

    /// The input of the scene, which must define a force or a motion programme.
    ///
    /// # Errors
    ///
    /// The scene defines neither a force nor a motion programme.
    pub fn whole(&self, py: Python<'_>) -> PyResult<&Input> {
        match &self.lacks_force {
            Some(fault) => Err(raised(py, fault.clone())),
            None => Ok(&self.input),
        }
    }

    /// The given scene, or the built-in footbridge if no scene is given.
    pub fn or_default(py: Python<'_>, scene: Option<&Scene>) -> PyResult<Scene> {
        match scene {
            Some(scene) => Ok(scene.clone()),
            None => Scene::builtin(py, scene::SCENES[0].name),
        }
    }

    /// Copy of the scene in which the values of some keys are changed.
    pub fn changed(&self, py: Python<'_>, changes: &Bound<'_, PyDict>) -> PyResult<Scene> {
        let mut table = self.input.table.clone();
        for (key, value) in changes {
            let (key, value) = convert::entry(key.extract()?, &value)?;
            scene::set_value(&mut table, &key, value).raise(py)?;
        }
        let (files, file) = (self.input.files.clone(), self.input.file.clone());
        Scene::of_table(py, table, files, file)
    }
}

impl Argument for Scene {
    const MADE: &'static str = "Scene.builtin(name), Scene.load(path) and Scene({...}) make one";
}

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (sections = None))]
    fn new(py: Python<'_>, sections: Option<&Bound<'_, PyDict>>) -> PyResult<Scene> {
        let table = sections.map_or(Ok(toml::Table::new()), |s| convert::table(s, ""))?;
        Scene::of_table(py, table, Disk::default(), None)
    }

    /// Scene from a scene file (TOML) or from a ``summary.json``.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Scene> {
        let table = gaitcam_app::scene::table(&path).raise(py)?;
        Scene::of_table(py, table, Disk::beside(&path), Some(path))
    }

    /// Built-in scene with the given name (see :meth:`builtins`).
    #[staticmethod]
    fn builtin(py: Python<'_>, name: &str) -> PyResult<Scene> {
        let table = parse(scene::built_in(name).raise(py)?.toml, None).raise(py)?;
        Scene::of_table(py, table, Disk::default(), None)
    }

    /// Names of the built-in scenes.
    #[staticmethod]
    fn builtins() -> Vec<&'static str> {
        scene::SCENES.iter().map(|s| s.name).collect()
    }

    /// Scene from the text of a scene file. Paths in the text are relative to ``folder``.
    #[staticmethod]
    #[pyo3(signature = (text, folder = None, file = None))]
    fn from_toml(
        py: Python<'_>,
        text: &str,
        folder: Option<PathBuf>,
        file: Option<PathBuf>,
    ) -> PyResult<Scene> {
        let table = parse(text, file.as_deref()).raise(py)?;
        Scene::of_table(py, table, Disk { folder }, file)
    }

    /// New scene in which the values of some dotted keys are changed. Quantities are texts, as in ``scene.set({"limits.stroke": "40 mm"})``, or
    /// numbers in SI units, as in ``scene.set({"limits.stroke_m": 0.04})``.
    fn set(&self, py: Python<'_>, changes: &Bound<'_, PyDict>) -> PyResult<Scene> {
        self.changed(py, changes)
    }

    /// Scene as nested dictionaries, which ``Scene(...)`` accepts. Paths are absolute.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let table = serde_json::to_value(self.input.resolved()).unwrap_or_default();
        convert::json(py, &table)
    }

    /// Scene as the text of a scene file. Paths are absolute.
    fn to_toml(&self) -> String {
        toml::to_string(&self.input.resolved()).unwrap_or_default()
    }

    /// Name of the scene.
    #[getter]
    fn name(&self) -> &str {
        &self.input.scene.name
    }

    /// Path of the recording in the scene; ``None`` without a recording.
    #[getter]
    fn recording(&self) -> Option<PathBuf> {
        self.input.recording()
    }

    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> Reduced<'py, (String, Option<PathBuf>, Option<PathBuf>)> {
        let restore = py.get_type::<Scene>().getattr("from_toml")?;
        let table = toml::to_string(&self.input.whole).unwrap_or_default();
        let absolute = |path: &Path| std::path::absolute(path).ok();
        let folder = self.input.files.folder.as_deref();
        let folder = folder.and_then(|folder| absolute(&folder.join(".")));
        let file = self.input.file.as_deref().and_then(absolute);
        Ok((restore, (table, folder, file)))
    }

    fn __repr__(&self) -> String {
        format!("<gaitcam.Scene {:?}>", self.input.scene.name)
    }
}

/// All keys of scenes: a list of dictionaries ``{key, section, kind, unit, default, range, choices, doc}``.
#[pyfunction]
pub fn keys(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    convert::json(py, &scene::keys::json())
}

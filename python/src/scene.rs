//! Scenes: the complete definition of a problem.

use std::path::{Path, PathBuf};

use gaitcam::error::{Error, SceneError};
use gaitcam::scene;
use gaitcam_app::scene::parse;
use gaitcam_app::{Disk, Input};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::{self, Argument, Reduced};
use crate::error::{Raise, raised};

/// A scene: target force, drive (how lift becomes force), law of motion, cam and limits.
///
/// ``Scene({"drive": {"mass": "8 kg"}, ...})`` takes the sections of a scene file. Quantities are texts with their unit, or
/// numbers under a key with its SI unit: ``"mass_kg": 8.0``. A scene without a force gets its force from :func:`synth`;
/// ``Scene()`` is empty. Scenes are immutable: ``set`` returns a new scene.
#[pyclass(frozen, module = "gaitcam", eq)]
#[derive(Clone)]
pub struct Scene {
    /// Scene with its table and folder.
    pub input: Input,
    /// Error of the scene if no force is given.
    lacks_force: Option<Error>,
}

impl PartialEq for Scene {
    fn eq(&self, other: &Scene) -> bool {
        let source = |s: &Scene| s.input.recording();
        self.input.scene == other.input.scene && source(self) == source(other)
    }
}

impl Scene {
    /// Scene of a table. The force may be given later, by `synth` or a sweep.
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

    /// A scene that specifies its force or a programme.
    pub fn of_input(input: Input) -> Scene {
        Scene {
            input,
            lacks_force: None,
        }
    }

    /// The scene, which must specify its force or a programme.
    ///
    /// # Errors
    ///
    /// The scene specifies neither.
    pub fn whole(&self, py: Python<'_>) -> PyResult<&Input> {
        match &self.lacks_force {
            Some(fault) => Err(raised(py, fault.clone())),
            None => Ok(&self.input),
        }
    }

    /// The given scene, or the built-in footbridge by default.
    pub fn or_default(py: Python<'_>, scene: Option<&Scene>) -> PyResult<Scene> {
        match scene {
            Some(scene) => Ok(scene.clone()),
            None => Scene::builtin(py, scene::SCENES[0].name),
        }
    }

    /// Scene with changes to its table.
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

    /// Reads a scene file (TOML), or the scene in a ``summary.json``.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Scene> {
        let table = gaitcam_app::scene::table(&path).raise(py)?;
        Scene::of_table(py, table, Disk::beside(&path), Some(path))
    }

    /// Built-in scene with this name; see :meth:`builtins`.
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

    /// Scene from the text of a scene file. Its paths are relative to ``folder``.
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

    /// A new scene with values changed by their dotted keys: ``scene.set({"limits.stroke": "40 mm"})`` or, as a number in SI,
    /// ``scene.set({"limits.stroke_m": 0.04})``.
    fn set(&self, py: Python<'_>, changes: &Bound<'_, PyDict>) -> PyResult<Scene> {
        self.changed(py, changes)
    }

    /// Scene as nested dictionaries in the form of ``Scene(...)``; paths are absolute.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let table = serde_json::to_value(self.input.resolved()).unwrap_or_default();
        convert::json(py, &table)
    }

    /// Scene as the text of a scene file; paths are absolute.
    fn to_toml(&self) -> String {
        toml::to_string(&self.input.resolved()).unwrap_or_default()
    }

    /// Name of the scene.
    #[getter]
    fn name(&self) -> &str {
        &self.input.scene.name
    }

    /// Path of the recording in the scene, if any.
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

/// Key table: a list of dictionaries ``{key, section, kind, unit, default, range, choices, doc}``.
#[pyfunction]
pub fn keys(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    convert::json(py, &scene::keys::json())
}

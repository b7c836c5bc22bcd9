//! Definition of a sweep from the arguments of a call or from its pickled state.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use gaitcam::error::Result;
use gaitcam::scene;
use gaitcam::sweep::{Files, Method, NamedScene};
use gaitcam_app::{Disk, SweepQuestion, Varied};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyBytes, PyDict, PyFloat, PyInt, PyList, PyString};

use crate::convert::{self, Argument};
use crate::error::{Raise, argument};
use crate::force::Force;
use crate::scene::Scene;

/// Definition of a sweep: base scenes, force and varied keys.
pub struct Question {
    scenes: Vec<Scene>,
    /// Force that replaces the forces of all scenes; `None` without such a force. It is also `None` if the definition was restored from a
    /// pickle, which contains the files instead of the force.
    force: Option<Force>,
    asked: SweepQuestion,
}

/// Access to the files of a base scene. A file is looked up first in the given force, then on the disk.
struct Given {
    force: Option<Force>,
    disk: Disk,
}

impl Given {
    fn content(&self, name: &Path) -> Option<Arc<Vec<u8>>> {
        self.force.as_ref()?.content(name)
    }
}

impl scene::Files for Given {
    fn has(&self, name: &Path) -> bool {
        self.content(name).is_some() || self.disk.has(name)
    }

    fn read(&self, name: &Path) -> Result<Arc<Vec<u8>>> {
        match self.content(name) {
            Some(content) => Ok(content),
            None => self.disk.read(name),
        }
    }

    fn folder(&self, name: &Path) -> Result<Option<Vec<PathBuf>>> {
        match self.content(name) {
            Some(_) => Ok(None),
            None => self.disk.folder(name),
        }
    }

    fn shown(&self, name: &Path) -> PathBuf {
        self.disk.shown(name)
    }
}

/// Base scenes from a list of scenes or from a single scene.
pub fn scenes(list: &Bound<'_, PyAny>) -> PyResult<Vec<Scene>> {
    let mut out = Vec::new();
    let all = list.try_iter();
    for scene in all.or_else(|_| Scene::given(list, "scene")?.try_iter())? {
        out.push(Scene::given(&scene?, "scene")?.get().clone());
    }
    if out.is_empty() {
        let what = "an empty list of scenes".to_string();
        return Err(argument(list.py(), "scene", what));
    }
    Ok(out)
}

/// Varied key with a range or a list of values, or with a text in the syntax of the command line.
fn of_axis(key: String, values: &Bound<'_, PyAny>, sampled: bool) -> PyResult<Varied> {
    if let Ok(text) = values.cast::<PyString>() {
        return Ok(Varied::Text(format!("{key}={text}")));
    }
    if let Some(si) = convert::si_key(&key) {
        let numbers = convert::numbers(values, &key)?.as_array().to_vec();
        return Ok(match numbers[..] {
            [low, high] if sampled => {
                let unit = si.unit();
                let range = format!("{low} {unit}:{high} {unit}");
                Varied::Text(format!("{}={range}", si.name()))
            }
            _ => Varied::Numbers(key, numbers),
        });
    }
    let list: Vec<Bound<'_, PyAny>> = values.try_iter()?.collect::<PyResult<_>>()?;
    let text = |value: &Bound<'_, PyAny>| value.is_instance_of::<PyString>();
    let range = match &list[..] {
        [first, last, count] => {
            let counted = count.is_instance_of::<PyInt>() && !count.is_instance_of::<PyBool>();
            text(first) && text(last) && counted
        }
        [first, last] => sampled && starts_number(first) && starts_number(last),
        _ => false,
    };
    let words: PyResult<Vec<String>> = list.iter().map(|v| written(v, &key)).collect();
    let words = words?;
    Ok(if range {
        Varied::Text(format!("{key}={}", words.join(":")))
    } else {
        Varied::Listed(key, words)
    })
}

/// Varied key with the values of one column of `rows`.
fn of_column(name: String, values: &Bound<'_, PyAny>) -> PyResult<Varied> {
    if convert::si_key(&name).is_some() {
        let numbers = convert::numbers(values, &name)?.as_array().to_vec();
        return Ok(Varied::Numbers(name, numbers));
    }
    let words: PyResult<Vec<String>> = values
        .try_iter()?
        .map(|value| written(&value?, &name))
        .collect();
    Ok(Varied::Listed(name, words?))
}

fn starts_number(value: &Bound<'_, PyAny>) -> bool {
    let text = value.str().map_or(String::new(), |t| t.to_string());
    text.trim_start()
        .starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
}

/// Value as text, as it is written in a scene file.
fn written(value: &Bound<'_, PyAny>, key: &str) -> PyResult<String> {
    if value.is_instance_of::<PyString>() || value.hasattr("__fspath__")? {
        return Ok(value.str()?.to_string());
    }
    if let Ok(list) = value.cast::<PyList>() {
        let each: PyResult<Vec<String>> = list.iter().map(|v| written(&v, key)).collect();
        return Ok(toml::Value::from(each?).to_string());
    }
    let number = value.is_instance_of::<PyInt>() || value.is_instance_of::<PyFloat>();
    if number || value.hasattr("__index__")? || value.hasattr("__float__")? {
        return Ok(value.str()?.to_string().to_lowercase());
    }
    let kind = value.get_type().name()?;
    let what = format!("{key}: text or a number, not {kind}");
    Err(PyTypeError::new_err(what))
}

impl Question {
    /// Creates a definition with base scenes that does not vary any key yet.
    pub fn new(
        py: Python<'_>,
        scenes: Vec<Scene>,
        sample: Option<u64>,
        method: &str,
        seed: u64,
    ) -> PyResult<Question> {
        let Some(method) = method_of(method) else {
            let what = format!("{method:?} is no method; give \"latin\" or \"sobol\"");
            return Err(argument(py, "method", what));
        };
        let asked = SweepQuestion {
            scenes: scenes.iter().map(named).collect(),
            sample,
            method,
            seed,
            ..SweepQuestion::default()
        };
        Ok(Question {
            scenes,
            force: None,
            asked,
        })
    }

    /// Sets a force that replaces the force of every scene.
    pub fn force(&mut self, py: Python<'_>, force: Option<Force>) -> PyResult<()> {
        for (scene, force) in self.scenes.iter_mut().zip(force.iter().cycle()) {
            *scene = Scene::of_input(force.named_in(&scene.input).raise(py)?);
        }
        self.asked.scenes = self.scenes.iter().map(named).collect();
        self.force = force;
        Ok(())
    }

    /// Adds varied keys. All combinations of their values are computed.
    pub fn vary(&mut self, axes: Option<&Bound<'_, PyDict>>, sampled: bool) -> PyResult<()> {
        for (key, values) in axes.into_iter().flatten() {
            let axis = of_axis(key.extract()?, &values, sampled)?;
            self.asked.vary.push(axis);
        }
        Ok(())
    }

    /// Adds keys whose values are combined row by row.
    pub fn rows(&mut self, rows: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        let Some(rows) = rows else { return Ok(()) };
        for name in convert::keys(rows, "rows")? {
            let values = rows.get_item(&name)?;
            self.asked.list.push(of_column(name, &values)?);
        }
        Ok(())
    }

    /// Adds recordings, each of which is combined with all other values. Without recordings, scenes without a force are rejected.
    pub fn recordings(&mut self, py: Python<'_>, paths: Option<Vec<PathBuf>>) -> PyResult<()> {
        let Some(paths) = paths else {
            return self.scenes.iter().try_for_each(|s| s.whole(py).map(|_| ()));
        };
        let names = paths.iter().map(|p| p.to_string_lossy().into_owned());
        self.asked.recordings = names.collect();
        if paths.is_empty() {
            let what = "an empty list of recordings".to_string();
            return Err(argument(py, "recordings", what));
        }
        Ok(())
    }

    /// Adds manufacturing tolerances: names of the manufactured quantities, with the half widths of their tolerance bands.
    pub fn tolerances(&mut self, parts: Option<&Bound<'_, PyDict>>) -> PyResult<()> {
        for (part, width) in parts.into_iter().flatten() {
            let part: String = part.extract()?;
            let width = written(&width, &part)?;
            self.asked.tolerances.push(format!("{part}={width}"));
        }
        Ok(())
    }

    /// Sweep of this definition. Without `files`, recordings are read from the disk.
    ///
    /// # Errors
    ///
    /// A varied key, a row, a tolerance or a recording is invalid.
    pub fn sweep(&self, files: Option<Files>) -> Result<gaitcam::sweep::Sweep> {
        if let Some(files) = files {
            return gaitcam::sweep::Sweep::with_files(self.asked.subject()?, files);
        }
        let given = |scene: &Scene| Given {
            force: self.force.clone(),
            disk: scene.input.files.clone(),
        };
        let files: Vec<Given> = self.scenes.iter().map(given).collect();
        self.asked.sweep(|index| &files[index])
    }

    /// State for pickling: the scenes, the definition as JSON, and the content of every file once.
    pub fn state<'py>(&self, py: Python<'py>, files: &Files) -> PyResult<Bound<'py, PyAny>> {
        // An object that occurs twice in the state is pickled only once.
        let mut contents: HashMap<*const Vec<u8>, Bound<'py, PyBytes>> = HashMap::new();
        let mut carried = Vec::new();
        for ((scene, name), bytes) in files {
            let content = contents
                .entry(Arc::as_ptr(bytes))
                .or_insert_with(|| PyBytes::new(py, bytes));
            carried.push((*scene, name.clone(), content.clone()));
        }
        let asked = serde_json::to_string(&self.asked).unwrap_or_default();
        let state = (self.scenes.clone(), asked, carried);
        Ok(state.into_pyobject(py)?.into_any())
    }

    /// Definition and files from a state that [`Question::state`] returned.
    pub fn restore(state: &Bound<'_, PyAny>) -> PyResult<(Question, Files)> {
        let item = |i: usize| state.get_item(i);
        let mut files = Files::new();
        let mut contents: HashMap<*mut pyo3::ffi::PyObject, Arc<Vec<u8>>> = HashMap::new();
        for entry in item(2)?.try_iter()? {
            let (scene, name, bytes): (usize, String, Bound<'_, PyBytes>) = entry?.extract()?;
            let content = contents
                .entry(bytes.as_ptr())
                .or_insert_with(|| Arc::new(bytes.as_bytes().to_vec()));
            files.insert((scene, name), Arc::clone(content));
        }
        let scenes = scenes(&item(0)?)?;
        let asked: String = item(1)?.extract()?;
        let asked: SweepQuestion = serde_json::from_str(&asked)
            .map_err(|e| argument(state.py(), "state", e.to_string()))?;
        let question = Question {
            asked: SweepQuestion {
                scenes: scenes.iter().map(named).collect(),
                ..asked
            },
            scenes,
            force: None,
        };
        Ok((question, files))
    }
}

fn method_of(name: &str) -> Option<Method> {
    [Method::Latin, Method::Sobol]
        .into_iter()
        .find(|m| m.name() == name)
}

/// Base scene with its name. The rows of the sweep contain this name.
fn named(scene: &Scene) -> NamedScene {
    NamedScene {
        name: scene.input.scene.name.clone(),
        table: scene.input.whole.clone(),
    }
}

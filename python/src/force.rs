//! The target force: arrays or recordings.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use gaitcam::error::{Placed, SceneError, SweepError};
use gaitcam::force::{self, ForceCurve, Walker};
use gaitcam::scene::{self, BETWEEN_PLATES, Files, content, plates};
use gaitcam_app::{Disk, Input, disk};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use toml::{Table, Value};

use crate::convert::{self, Argument, Reduced};
use crate::error::Raise;

/// One cycle of vertical force.
///
/// ``Force(t_s, f_n)`` is one cycle from its times (s) and forces (N), arrays of one dimension and equal length, times
/// increasing; the first sample may be repeated at the end.
///
/// Parameters
/// ----------
/// t_s : array of shape (n,)
///     Times, s.
/// f_n : array of shape (n,)
///     Vertical forces, N.
/// period_s : float, optional
///     Duration of the cycle, s; without it the cycle ends one step after its last sample.
/// mass_kg : float, optional
///     Mass of the walker, kg.
/// name : str
///     What the force is called in reports.
#[pyclass(frozen, module = "gaitcam")]
#[derive(Clone)]
pub struct Force {
    /// The force cycle.
    pub curve: ForceCurve,
    /// Source of the force.
    pub origin: Origin,
}

/// Source of a force.
#[derive(Clone)]
pub enum Origin {
    /// A force from arrays.
    Arrays,
    /// A force from a recording: its `[gait]` section and its content.
    Recording {
        /// Keys of the `[gait]` section.
        gait: Table,
        /// Content of the file.
        bytes: Arc<Vec<u8>>,
        /// Content of the table of subjects in the folder of the file.
        metadata: Option<Vec<u8>>,
    },
}

impl Files for Origin {
    fn has(&self, name: &Path) -> bool {
        self.read(name).is_ok()
    }

    fn read(&self, name: &Path) -> gaitcam::error::Result<Arc<Vec<u8>>> {
        let missing = || SweepError::NotCarried.in_file(name);
        let Origin::Recording {
            gait,
            bytes,
            metadata,
        } = self
        else {
            return Err(missing());
        };
        let file = gait.get("file").and_then(Value::as_str).map(Path::new);
        if file == Some(name) {
            return Ok(Arc::clone(bytes));
        }
        let beside = file.and_then(force::metadata_name);
        let metadata = metadata.clone().filter(|_| beside.as_deref() == Some(name));
        metadata.map(Arc::new).ok_or_else(missing)
    }
}

/// Keys of `[gait]` that specify a force.
const OF_SOURCE: [&str; 12] = [
    "file",
    "model",
    "step_frequency",
    "body_weight",
    "time",
    "force",
    "unit",
    "rate",
    "mass",
    "kind",
    "period",
    "span",
];

/// Default name of a force.
const UNNAMED: &str = "force";

/// File name of a force from arrays, in the folder of the result.
pub use gaitcam_app::design::FORCE as FILE;

impl Argument for Force {
    const MADE: &'static str = "read_gait(path) and Force(t_s, f_n, period_s=...) make one";
}

impl Force {
    /// The argument `force`, if given.
    pub fn of_argument(force: Option<&Bound<'_, PyAny>>) -> PyResult<Option<Force>> {
        let force = force.map(|f| Force::given(f, "force")).transpose()?;
        Ok(force.map(|f| f.get().clone()))
    }

    fn of_recording(
        py: Python<'_>,
        gait: Table,
        bytes: Arc<Vec<u8>>,
        metadata: Option<Vec<u8>>,
    ) -> PyResult<Force> {
        let table = Table::from_iter([("gait".to_string(), Value::Table(gait.clone()))]);
        let scene = scene::read_keys(&table).raise(py)?;
        let given = scene.gait.unwrap_or_default();
        let origin = Origin::Recording {
            gait,
            bytes,
            metadata,
        };
        let read = || {
            let curve = given.force(&origin)?;
            curve.ok_or_else(|| SceneError::NoForceNamed.into())
        };
        let curve = py.detach(read).raise(py)?;
        Ok(Force { curve, origin })
    }

    /// Several walkers as one target; forces of one name are cycles of one walker, those without a name are numbered.
    pub fn of_walkers(py: Python<'_>, forces: &[PyRef<'_, Force>]) -> PyResult<Force> {
        let walker = |(number, force): (usize, &PyRef<'_, Force>)| {
            let name = match force.curve.name.as_str() {
                UNNAMED => format!("{UNNAMED} {number}"),
                name => name.to_string(),
            };
            Walker::new(&name, force.curve.clone())
        };
        let walkers: Vec<Walker> = (1..).zip(forces).map(walker).collect();
        let table = force::population_csv(&walkers);
        let gait = Table::from_iter([("file".to_string(), Value::from(FILE))]);
        Force::of_recording(py, gait, table.into_bytes().into(), None)
    }

    /// The content of a file of this force: of the recording, of the subjects beside it, or of [`FILE`].
    pub fn content(&self, path: &Path) -> Option<Arc<Vec<u8>>> {
        match &self.origin {
            Origin::Arrays => {
                let text = self.curve.to_csv(&[&self.curve.name]);
                (path == Path::new(FILE)).then(|| Arc::new(text.into_bytes()))
            }
            recording => recording.read(path).ok(),
        }
    }

    /// A scene with this force in its `[gait]`, with unchanged scale, band, phase and weights.
    ///
    /// # Errors
    /// A scene that is invalid with this force.
    pub fn named_in(&self, input: &Input) -> gaitcam::error::Result<Input> {
        let mut table = input.whole.clone();
        let own = table.get("gait").and_then(Value::as_table).cloned();
        let mut gait = own.unwrap_or_default();
        for key in OF_SOURCE {
            gait.remove(key);
        }
        gait.extend(self.gait());
        table.insert("gait".to_string(), Value::Table(gait));
        let scene = scene::read(&table)?;
        Ok(Input {
            scene,
            whole: table.clone(),
            table,
            ..input.clone()
        })
    }

    /// The keys of `[gait]` that name this force.
    fn gait(&self) -> Table {
        match &self.origin {
            Origin::Arrays => Table::from_iter([("file".to_string(), Value::from(FILE))]),
            Origin::Recording { gait, .. } => gait.clone(),
        }
    }
}

#[pymethods]
impl Force {
    #[new]
    #[pyo3(signature = (t_s, f_n, *, period_s = None, mass_kg = None, name = "force"))]
    fn new(
        py: Python<'_>,
        t_s: &Bound<'_, PyAny>,
        f_n: &Bound<'_, PyAny>,
        period_s: Option<f64>,
        mass_kg: Option<f64>,
        name: &str,
    ) -> PyResult<Force> {
        let (t, f) = (convert::numbers(t_s, "t_s")?, convert::numbers(f_n, "f_n")?);
        let (t, f) = (t.as_array(), f.as_array());
        let (t, f) = (t.to_vec(), f.to_vec());
        let curve = py.detach(|| force::of_arrays(name, &t, &f, period_s));
        let mut curve = curve.raise(py)?;
        curve.mass_kg = mass_kg;
        let origin = Origin::Arrays;
        Ok(Force { curve, origin })
    }

    /// A whole recording of a walk from arrays: stances are found and averaged as in :func:`read_gait`.
    ///
    /// ``f_n`` has shape (n,) or (n, plates), N; ``t_s`` shape (n,), s. ``options`` are those of :func:`read_gait`.
    #[staticmethod]
    #[pyo3(signature = (t_s, f_n, **options))]
    fn from_recording(
        t_s: &Bound<'_, PyAny>,
        f_n: &Bound<'_, PyAny>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Force> {
        let py = t_s.py();
        let np = py.import("numpy")?;
        let plates = np.call_method1("atleast_2d", (convert::array(f_n, "f_n")?.getattr("T")?,))?;
        let mut columns = vec![convert::numbers(t_s, "t_s")?];
        for plate in plates.try_iter()? {
            columns.push(convert::numbers(&plate?, "f_n")?);
        }
        let rows = columns[0].as_array().len();
        if let Some(odd) = columns.iter().find(|c| c.as_array().len() != rows) {
            let forces = odd.as_array().len();
            let fault = gaitcam::error::ForceError::Lengths {
                times: rows,
                forces,
            };
            let fault = gaitcam::error::Error::from(fault);
            return Err(fault.at(gaitcam::error::Place::Key("f_n".to_string()))).raise(py);
        }
        let mut text = String::from("time_s");
        for plate in 1..columns.len() {
            text.push_str(&format!(",fz{plate}_n"));
        }
        for row in 0..rows {
            text.push('\n');
            for (i, column) in columns.iter().enumerate() {
                text.push_str(if i > 0 { "," } else { "" });
                text.push_str(&column.as_array()[row].to_string());
            }
        }
        text.push('\n');
        let gait = gait(options, Path::new("recording.csv"))?;
        Force::of_recording(py, gait, text.into_bytes().into(), None)
    }

    /// Samples of one cycle at equal steps of phase from heel strike on, N; shape (n,).
    #[getter]
    fn force_n<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.curve.force_n)
    }

    /// Times of the samples, s; shape (n,).
    #[getter]
    fn time_s<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let n = self.curve.force_n.len();
        let times = (0..n).map(|i| self.curve.period_s * i as f64 / n as f64);
        PyArray1::from_iter(py, times)
    }

    /// Step-to-step standard deviation at the same phases, N, where several cycles were averaged; shape (n,).
    #[getter]
    fn spread_n<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        let spread = self.curve.spread_n.as_ref()?;
        Some(PyArray1::from_slice(py, spread))
    }

    /// Duration of one cycle, s.
    #[getter]
    fn period_s(&self) -> f64 {
        self.curve.period_s
    }

    /// Mean force, N.
    #[getter]
    fn mean_n(&self) -> f64 {
        self.curve.mean_n()
    }

    /// Mass of the walker, kg, where it is known.
    #[getter]
    fn mass_kg(&self) -> Option<f64> {
        self.curve.mass_kg
    }

    /// What the force is.
    #[getter]
    fn name(&self) -> &str {
        &self.curve.name
    }

    /// What was guessed, left out or doubtful in a recording, as sentences.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        let notes = self.curve.warnings();
        notes.map(ToString::to_string).collect()
    }

    /// Force (N) at cam angles ``theta`` (rad), one cycle per turn; of the shape of ``theta``.
    fn __call__<'py>(&self, theta: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        crate::law::shaped(theta, |x| [self.curve.at(x)]).map(|[force]| force)
    }

    fn __len__(&self) -> usize {
        self.curve.force_n.len()
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, Bound<'py, PyAny>> {
        let own = py.get_type::<Force>();
        let state = match &self.origin {
            Origin::Arrays => (
                self.curve.name.clone(),
                self.curve.period_s,
                self.force_n(py),
                self.curve.mass_kg,
            )
                .into_pyobject(py)?,
            Origin::Recording {
                gait,
                bytes,
                metadata,
            } => {
                let gait = toml::to_string(gait).unwrap_or_default();
                let metadata = metadata.as_ref().map(|m| PyBytes::new(py, m));
                (gait, PyBytes::new(py, bytes), metadata, py.None()).into_pyobject(py)?
            }
        };
        Ok((own.getattr("_restore")?, state.into_any()))
    }

    #[staticmethod]
    fn _restore(
        first: String,
        second: &Bound<'_, PyAny>,
        third: &Bound<'_, PyAny>,
        mass_kg: Option<f64>,
    ) -> PyResult<Force> {
        let py = second.py();
        if let Ok(bytes) = second.cast::<PyBytes>() {
            let gait = first.parse().unwrap_or_default();
            let metadata: Option<Vec<u8>> = third.extract()?;
            let bytes = Arc::new(bytes.as_bytes().to_vec());
            return Force::of_recording(py, gait, bytes, metadata);
        }
        let samples = convert::numbers(third, "f_n")?;
        let samples = samples.as_array().to_vec();
        let mut curve = ForceCurve::from_samples(&first, second.extract()?, samples).raise(py)?;
        curve.mass_kg = mass_kg;
        let origin = Origin::Arrays;
        Ok(Force { curve, origin })
    }

    fn __repr__(&self) -> String {
        format!(
            "<gaitcam.Force {:?}: {:.4} s, mean {:.2} N>",
            self.curve.name,
            self.curve.period_s,
            self.curve.mean_n()
        )
    }
}

/// Reads a recording (C3D, OpenSim, text, insole exports) into its mean cycle of force.
///
/// Parameters
/// ----------
/// path : path of the file, or a list of paths: the plates of one trial in a file each
/// options
///     What the file does not say, or says wrongly, as in the section ``[gait]`` of a scene: ``feet`` ("both", "one",
///     "left", "right", "total"), ``rate`` ("1000 Hz"), ``mass`` ("72.6 kg"), ``unit`` ("kN"), ``kind`` ("walking",
///     "running"), ``time`` and ``force`` (names of columns), ``period`` ("0.5 s": the file is one cycle of any
///     machine), ``span`` ("256 deg").
#[pyfunction]
#[pyo3(signature = (path, **options))]
pub fn read_gait(
    py: Python<'_>,
    path: Paths,
    options: Option<&Bound<'_, PyDict>>,
) -> PyResult<Force> {
    let paths = match path {
        Paths::One(path) => plates(&Disk::default(), &path),
        Paths::Several(paths) => paths,
    };
    let names: Vec<_> = paths.iter().map(|p| p.to_string_lossy()).collect();
    let name = names.join(BETWEEN_PLATES);
    let bytes = py.detach(|| content(&Disk::default(), Path::new(&name)));
    let bytes = bytes.raise(py)?;
    let place = |path: &PathBuf| {
        let place = std::path::absolute(path).unwrap_or_else(|_| path.clone());
        place.to_string_lossy().into_owned()
    };
    let places: Vec<String> = paths.iter().map(place).collect();
    let gait = gait(options, Path::new(&places.join(BETWEEN_PLATES)))?;
    let metadata = paths.first().and_then(|path| disk::metadata(path));
    Force::of_recording(py, gait, bytes, metadata)
}

/// A recording in one file, or the plates of one trial in a file each.
#[derive(FromPyObject)]
pub enum Paths {
    One(PathBuf),
    Several(Vec<PathBuf>),
}

fn gait(options: Option<&Bound<'_, PyDict>>, path: &Path) -> PyResult<Table> {
    let mut gait = options.map_or(Ok(Table::new()), |o| convert::table(o, "gait"))?;
    let file = Value::from(path.to_string_lossy().into_owned());
    gait.insert("file".to_string(), file);
    Ok(gait)
}

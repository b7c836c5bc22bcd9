//! Class `Force`: the target force, from arrays or from a recording.

mod options;
mod origin;
mod steps;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use gaitcam::force::{self, ForceCurve, OpenQuestion, Walker};
use gaitcam::scene::{self, BETWEEN_PLATES, Files, content, plates};
use gaitcam_app::{Disk, Input, disk};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::convert::{self, Argument, Reduced};
use crate::error::Raise;
use crate::table::Table;
use options::{OF_ARRAYS, OF_FILE, table_of_arrays};
pub use origin::{FILE, Origin};

/// One cycle of a vertical force.
///
/// ``Force(t_s, f_n)`` defines a cycle by its times and forces. Both are one-dimensional arrays of equal length. The times must increase.
/// The first sample may be repeated at the end.
///
/// Parameters
/// ----------
/// t_s : array of shape (n,)
///     Times, s.
/// f_n : array of shape (n,)
///     Vertical forces, N.
/// period_s : float, optional
///     Duration of the cycle, s. By default the cycle ends one time step after the last sample.
/// mass_kg : float, optional
///     Mass of the walker, kg.
/// name : str, optional
///     Name of the walker in tables and results. The default is "force".
#[pyclass(frozen, module = "gaitcam")]
#[derive(Clone)]
pub struct Force {
    /// Mean cycle of the force.
    pub curve: ForceCurve,
    /// Data from which the force was computed.
    pub origin: Origin,
    /// Name of the walker in tables and results.
    pub name: String,
}

/// Name of a force for which no name is given.
const UNNAMED: &str = "force";

impl Argument for Force {
    const MADE: &'static str = "read_gait(path) and Force(t_s, f_n, period_s=...) make one";
}

impl Force {
    /// Converts the argument `force`; `None` if it is not given.
    pub fn of_argument(force: Option<&Bound<'_, PyAny>>) -> PyResult<Option<Force>> {
        let force = force.map(|f| Force::given(f, "force")).transpose()?;
        Ok(force.map(|f| f.get().clone()))
    }

    /// Mean cycle of a recording. If `name` is `None`, the name is the file name without its extension.
    fn of_recording(py: Python<'_>, origin: Origin, name: Option<&str>) -> PyResult<Force> {
        let file = origin.file();
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        let name = options::name(py, name, &stem)?;
        let curve = py.detach(|| origin.curve()).raise(py)?;
        Ok(Force {
            curve,
            origin,
            name,
        })
    }

    /// Combines several walkers into one target force. Forces with the same name are cycles of one walker. Forces without a name are
    /// numbered.
    pub fn of_walkers(py: Python<'_>, forces: &[PyRef<'_, Force>]) -> PyResult<Force> {
        let walker = |(number, force): (usize, &PyRef<'_, Force>)| {
            let name = match force.name.as_str() {
                UNNAMED => format!("{UNNAMED} {number}"),
                name => name.to_string(),
            };
            Walker::new(&name, force.curve.clone())
        };
        let walkers: Vec<Walker> = (1..).zip(forces).map(walker).collect();
        Force::of_population(py, &walkers)
    }

    /// Combines the cycles of a population of walkers into one target force.
    pub fn of_population(py: Python<'_>, walkers: &[Walker]) -> PyResult<Force> {
        let table = force::population_csv(walkers);
        let origin = Origin::Recording {
            gait: Origin::Arrays.keys(),
            bytes: table.into_bytes().into(),
            metadata: None,
        };
        Force::of_recording(py, origin, None)
    }

    /// Content of a file from which this force is read: the recording, its table of subjects, or [`FILE`] for arrays. `None` for other
    /// files.
    pub fn content(&self, path: &Path) -> Option<Arc<Vec<u8>>> {
        match &self.origin {
            Origin::Arrays => {
                let text = self.curve.to_csv(&[&self.curve.name]);
                (path == Path::new(FILE)).then(|| Arc::new(text.into_bytes()))
            }
            recording => recording.read(path).ok(),
        }
    }

    /// Copy of a scene in which this force is the source in `[gait]`. Keys for scale, band, phase and weights are unchanged.
    ///
    /// # Errors
    ///
    /// The scene is invalid with this force.
    pub fn named_in(&self, input: &Input) -> gaitcam::error::Result<Input> {
        let table = self.origin.named_in(&input.whole);
        let scene = scene::read(&table)?;
        Ok(Input {
            scene,
            whole: table.clone(),
            table,
            ..input.clone()
        })
    }
}

#[pymethods]
impl Force {
    #[new]
    #[pyo3(signature = (t_s, f_n, *, period_s = None, mass_kg = None, name = None))]
    fn new(
        py: Python<'_>,
        t_s: &Bound<'_, PyAny>,
        f_n: &Bound<'_, PyAny>,
        period_s: Option<f64>,
        mass_kg: Option<f64>,
        name: Option<&str>,
    ) -> PyResult<Force> {
        let name = options::name(py, name, UNNAMED)?;
        let (t, f) = (convert::numbers(t_s, "t_s")?, convert::numbers(f_n, "f_n")?);
        let (t, f) = (t.as_array(), f.as_array());
        let (t, f) = (t.to_vec(), f.to_vec());
        let curve = py.detach(|| force::of_arrays(&name, &t, &f, period_s));
        let mut curve = curve.raise(py)?;
        curve.mass_kg = mass_kg;
        Ok(Force {
            curve,
            origin: Origin::Arrays,
            name,
        })
    }

    /// Mean cycle of a recording of walking that is given as arrays. Stances are detected and averaged as in :func:`read_gait`.
    ///
    /// ``t_s`` (s) has shape (n,). ``f_n`` (N) has shape (n,) or (n, plates). The default name is "recording". The options of
    /// :func:`read_gait` are available, except the names of columns and the sampling rate.
    #[staticmethod]
    #[pyo3(signature = (t_s, f_n, name = None, **options), text_signature = "(t_s, f_n, name=None, *, feet=None, mass=None, \
        mass_kg=None, unit=None, kind=None, accept=None, period=None, period_s=None, span=None, span_rad=None, noise=None,
        noise_n=None)")]
    fn from_recording(
        t_s: &Bound<'_, PyAny>,
        f_n: &Bound<'_, PyAny>,
        name: Option<&str>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Force> {
        let py = t_s.py();
        let origin = Origin::Recording {
            gait: options::gait(py, options, &OF_ARRAYS, Path::new("recording.csv"))?,
            bytes: table_of_arrays(t_s, f_n)?.into_bytes().into(),
            metadata: None,
        };
        Force::of_recording(py, origin, name)
    }

    /// Samples of one cycle at equal steps of phase, starting at heel strike, N; shape (n,).
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

    /// Standard deviation of the force between steps at the phases of ``force_n``, N; shape (n,). ``None`` if no cycles were averaged.
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

    /// Mean force over the cycle, N.
    #[getter]
    fn mean_n(&self) -> f64 {
        self.curve.mean_n()
    }

    /// Mass of the walker, kg; ``None`` if unknown.
    #[getter]
    fn mass_kg(&self) -> Option<f64> {
        self.curve.mass_kg
    }

    /// Name of the walker in all tables and results. The default is the file name without its extension, or "force" for arrays of one
    /// cycle.
    #[getter]
    fn name(&self) -> &str {
        &self.name
    }

    /// Recorded movement: "walking", "running", …; ``None`` for a cycle that is given as arrays, and for an unknown movement.
    #[getter]
    fn kind(&self) -> Option<&'static str> {
        Some(self.curve.recording.as_ref()?.kind?.name())
    }

    /// Open questions about a recording that the options do not accept: "kind", "clock", "mass" or "clipped".
    #[getter]
    fn open(&self, py: Python<'_>) -> PyResult<Vec<&'static str>> {
        let accepted = self.origin.gait().raise(py)?.accept;
        let recording = self.curve.recording.iter();
        let open = recording.flat_map(|r| r.doubts());
        let open = open.filter(|question| !accepted.contains(question));
        Ok(open.map(OpenQuestion::name).collect())
    }

    /// Contacts of a recording in the order of time, as a table. The columns are ``column``, ``foot``, ``start_s``, ``end_s``, ``p1_n``,
    /// ``valley_n``, ``p2_n``, ``impulse`` (N s), ``used`` and ``why``. Times are on the clock of the file. ``p1_n``, ``valley_n`` and
    /// ``p2_n`` are the forces at the first peak, the valley and the second peak. ``used`` is 1 or 0, and ``why`` is the reason for 0. A
    /// cycle that is given as arrays has no contacts.
    #[getter]
    fn stances(&self) -> Table {
        let recording = self.curve.recording.as_ref();
        steps::table(&recording.map_or(Vec::new(), |r| r.stance_rows()))
    }

    /// Complete strides of both feet, as a table with the columns of :attr:`stances`. The peaks are measured in the first stance. The
    /// impulse is the sum of both feet.
    #[getter]
    fn strides(&self) -> Table {
        let recording = self.curve.recording.as_ref();
        steps::table(&recording.map_or(Vec::new(), |r| r.stride_rows()))
    }

    /// Warnings about a recording, as sentences: assumptions, exclusions and implausible data.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        let notes = self.curve.warnings();
        notes.map(ToString::to_string).collect()
    }

    /// Force (N) at cam angles ``theta`` (rad), with one cycle per turn. The result has the shape of ``theta``.
    fn __call__<'py>(&self, theta: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        crate::law::shaped(theta, |x| [self.curve.at(x)]).map(|[force]| force)
    }

    fn __len__(&self) -> usize {
        self.curve.force_n.len()
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, Bound<'py, PyAny>> {
        let own = py.get_type::<Force>();
        let state = match &self.origin {
            Origin::Arrays => {
                let samples = (self.curve.period_s, self.force_n(py), self.curve.mass_kg);
                (&self.name, samples, py.None()).into_pyobject(py)?
            }
            Origin::Recording {
                gait,
                bytes,
                metadata,
            } => {
                let gait = toml::to_string(gait).unwrap_or_default();
                let metadata = metadata.as_ref().map(|m| PyBytes::new(py, m));
                (&self.name, (PyBytes::new(py, bytes), metadata), gait).into_pyobject(py)?
            }
        };
        Ok((own.getattr("_restore")?, state.into_any()))
    }

    #[staticmethod]
    fn _restore(
        py: Python<'_>,
        name: String,
        content: &Bound<'_, PyAny>,
        gait: Option<&str>,
    ) -> PyResult<Force> {
        if let Some(gait) = gait {
            let (bytes, metadata): (Vec<u8>, Option<Vec<u8>>) = content.extract()?;
            let origin = Origin::Recording {
                gait: gait.parse().unwrap_or_default(),
                bytes: bytes.into(),
                metadata,
            };
            return Force::of_recording(py, origin, Some(&name));
        }
        let (period_s, samples, mass_kg): (f64, Bound<'_, PyAny>, Option<f64>) =
            content.extract()?;
        let samples = convert::numbers(&samples, "f_n")?.as_array().to_vec();
        let mut curve = ForceCurve::from_samples(&name, period_s, samples).raise(py)?;
        curve.mass_kg = mass_kg;
        Ok(Force {
            curve,
            origin: Origin::Arrays,
            name,
        })
    }

    fn __repr__(&self) -> String {
        format!(
            "<gaitcam.Force {:?}: {:.4} s, mean {:.2} N>",
            self.name,
            self.curve.period_s,
            self.curve.mean_n()
        )
    }
}

/// Reads a recording (C3D, OpenSim, text, insole exports) and computes its mean force cycle.
///
/// Parameters
/// ----------
/// path : path or list of paths
///     File of the recording, or the files of one trial with one file per force plate.
/// name : str, optional
///     Name of the walker in tables and results. The default is the file name without its extension.
/// feet : str
///     Feet from which the force is used: "both" (default), "one", "left", "right" or "total".
/// rate : str ("1000 Hz"), rate_hz : float
///     Sampling rate, if the file does not contain it.
/// mass : str ("72.6 kg"), mass_kg : float
///     Mass of the walker.
/// unit : str ("kN")
///     Unit of the force columns.
/// kind : str
///     Kind of movement: "walking", "running", "standing", "jumping", "sit-to-stand" or "other".
/// accept : str ("clock, mass")
///     Open questions for which the assumption is accepted (see :attr:`Force.open`).
/// time : str, force : str or list of str
///     Names of the columns with the time and with the force.
/// period : str ("0.5 s"), period_s : float
///     Duration of the cycle, if the file contains one cycle of any machine instead of a recording.
/// span : str ("256 deg"), span_rad : float
///     Range of the cam angle that the file covers.
/// noise : str ("8 N" or "auto"), noise_n : float
///     RMS noise of the sensor, which limits the automatically chosen accuracy.
///
/// Raises
/// ------
/// InputError
///     The file cannot be read or contains no cycle, or an option is invalid. The error contains the key of the option in
///     ``[gait]``.
#[pyfunction]
#[pyo3(signature = (path, name = None, **options), text_signature = "(path, name=None, *, feet=None, rate=None, rate_hz=None, \
    mass=None, mass_kg=None, unit=None, kind=None, accept=None, time=None, force=None, period=None, period_s=None, \
    span=None, span_rad=None, noise=None,
        noise_n=None)")]
pub fn read_gait(
    py: Python<'_>,
    path: Paths,
    name: Option<&str>,
    options: Option<&Bound<'_, PyDict>>,
) -> PyResult<Force> {
    let paths = match path {
        Paths::One(path) => plates(&Disk::default(), &path),
        Paths::Several(paths) => paths,
    };
    let names: Vec<_> = paths.iter().map(|p| p.to_string_lossy()).collect();
    let names = names.join(BETWEEN_PLATES);
    let bytes = py.detach(|| content(&Disk::default(), Path::new(&names)));
    let place = |path: &PathBuf| {
        let place = std::path::absolute(path).unwrap_or_else(|_| path.clone());
        place.to_string_lossy().into_owned()
    };
    let places: Vec<String> = paths.iter().map(place).collect();
    let origin = Origin::Recording {
        gait: options::gait(
            py,
            options,
            &OF_FILE,
            Path::new(&places.join(BETWEEN_PLATES)),
        )?,
        bytes: bytes.raise(py)?,
        metadata: paths.first().and_then(|path| disk::metadata(path)),
    };
    Force::of_recording(py, origin, name)
}

/// Path of a recording, or paths of the force plates of one trial, with one file for each plate.
#[derive(FromPyObject)]
pub enum Paths {
    One(PathBuf),
    Several(Vec<PathBuf>),
}

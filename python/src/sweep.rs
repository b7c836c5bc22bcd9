//! Class `Sweep`: thousands of designs, with rows that are the same on every machine.

mod question;

use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use gaitcam::halt::Halt;
use gaitcam::wording::Language;
use gaitcam_app::blocks::SharedBlocks;
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};

use crate::convert::{self, Reduced};
use crate::error::{Raise, argument};
use crate::force::Force;
use crate::html;
use crate::interrupt::{self, Interrupt};
use crate::scene::Scene;
use crate::table::Table;
use question::Question;

/// A sweep over many designs. Each row depends only on the plan and on its row number. It is the same on every machine.
///
/// Parameters
/// ----------
/// scene : Scene or list of Scene, optional
///     Base scenes. The default is the built-in footbridge.
/// force : Force, optional
///     Target force that replaces the forces of all scenes.
/// vary : dict, optional
///     Dotted keys with their values, of which all combinations are computed. ``["1.5 Hz", "2.4 Hz", 10]`` is a range with the
///     number of its values. Any other list contains the values themselves. ``"20 mm:60 mm:5"`` and ``"spline,harmonic"`` have
///     the syntax of ``gaitcam sweep --vary``. With ``sample``, a range is given without a number of values:
///     ``["1.5 Hz", "2.4 Hz"]``. If a key ends with its SI unit, its values are numbers, as in
///     ``{"limits.stroke_m": np.linspace(0.03, 0.06, 4)}``. With ``sample``, two numbers are the ends of a range. A value of
///     ``gait.file`` may be a folder of walkers or a list of files.
/// rows : mapping, optional
///     Keys with lists of values that are combined row by row. Columns of a gaitcam table can be used with their own names,
///     such as ``limits.stroke_m``. These columns contain numbers in SI units.
/// recordings : list of paths, optional
///     Paths of recordings. Each is combined with all other values.
/// sample : int, optional
///     Number of points sampled from the ranges of ``vary``, instead of all combinations.
/// method : str
///     Sampling method: "latin" (Latin hypercube) or "sobol" (Sobol sequence).
/// seed : int
///     Seed of the random number generator.
/// tolerance : dict, optional
///     Manufacturing tolerances of a single design: ``{"profile": "0.02 mm", "mass": "1 %"}``. Each row is a cam with random deviations
///     within the tolerances, and ``sample`` is the number of cams. Tolerances cannot be combined with varied keys.
/// time_limit : float
///     Time limit of the search for one row, s. If it is reached, the row contains an error. Only such a row
///     can depend on the speed of the machine.
///
/// The plan contains the content of each recording once.
#[pyclass(frozen, module = "gaitcam")]
pub struct Sweep {
    question: Question,
    sweep: gaitcam::sweep::Sweep,
    time_limit: f64,
}

impl Sweep {
    fn rows(&self, py: Python<'_>, start: u64, stop: Option<u64>) -> PyResult<Range<u64>> {
        let rows = self.sweep.rows().raise(py)?;
        let stop = stop.unwrap_or(rows);
        if start > stop || stop > rows {
            let what = format!("rows {start} to {stop} are not among the {rows} of this sweep");
            return Err(argument(py, "stop", what));
        }
        Ok(start..stop)
    }
}

#[pymethods]
impl Sweep {
    #[new]
    #[pyo3(signature = (
        scene = None, *, force = None, vary = None, rows = None, recordings = None, sample = None, method = "latin",
        seed = 1, tolerance = None, time_limit = 5.0
    ))]
    #[allow(clippy::too_many_arguments)] // keywords of one call
    fn new(
        py: Python<'_>,
        scene: Option<&Bound<'_, PyAny>>,
        force: Option<&Bound<'_, PyAny>>,
        vary: Option<&Bound<'_, PyDict>>,
        rows: Option<&Bound<'_, PyAny>>,
        recordings: Option<Vec<PathBuf>>,
        #[pyo3(from_py_with = convert::whole)] sample: Option<u64>,
        method: &str,
        #[pyo3(from_py_with = convert::whole)] seed: u64,
        tolerance: Option<&Bound<'_, PyDict>>,
        time_limit: f64,
    ) -> PyResult<Sweep> {
        let time_limit = interrupt::limit(py, time_limit)?;
        let scenes = match scene {
            None => vec![Scene::or_default(py, None)?],
            Some(one) if one.is_instance_of::<Scene>() => vec![one.cast::<Scene>()?.get().clone()],
            Some(list) => question::scenes(list)?,
        };
        let mut question = Question::new(py, scenes, sample, method, seed)?;
        question.force(py, Force::of_argument(force)?)?;
        question.vary(vary, sample.is_some())?;
        question.rows(rows)?;
        question.recordings(py, recordings)?;
        question.tolerances(tolerance)?;
        let sweep = py.detach(|| question.sweep(None)).raise(py)?;
        Ok(Sweep {
            question,
            sweep,
            time_limit,
        })
    }

    /// Computes the rows from ``start`` to ``stop`` - 1 (by default all rows). The first column of the resulting table is ``row``.
    ///
    /// ``jobs`` is the number of threads, by default one per core. ``progress(begun, rows)`` is called about twenty times per second and at
    /// the end. ``begun`` is the number of rows that have been started. ``rows`` is the number of rows of this call. An exception in
    /// ``progress`` ends the computation.
    #[pyo3(signature = (start = 0, stop = None, *, jobs = None, progress = None))]
    fn run(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = convert::whole)] start: u64,
        #[pyo3(from_py_with = convert::whole)] stop: Option<u64>,
        #[pyo3(from_py_with = convert::whole)] jobs: Option<usize>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Table> {
        let rows = self.rows(py, start, stop)?;
        let cores = || std::thread::available_parallelism().map_or(1, usize::from);
        let jobs = jobs.unwrap_or_else(cores).max(1);
        let begun = Arc::new(AtomicU64::new(0));
        let (seen, count) = (Arc::clone(&begun), rows.end - rows.start);
        let report = progress.as_ref().map(|progress| progress.clone_ref(py));
        let interrupt = Interrupt::watched(
            f64::INFINITY,
            report.map(|report| {
                let watch = move |py: Python<'_>| {
                    let rows = seen.load(Ordering::Relaxed).min(count);
                    report.call1(py, (rows, count)).map(drop)
                };
                Box::new(watch) as _
            }),
        );
        let halts = || {
            begun.fetch_add(1, Ordering::Relaxed);
            let row = Interrupt::after(self.time_limit).halt();
            let all = Arc::clone(&interrupt);
            Halt::when(move || row.is_asked() || all.is_raised())
        };
        let found = py.detach(|| {
            self.sweep
                .run(rows, jobs, &halts, &|| interrupt.is_raised())
        });
        interrupt.result()?;
        let records = found.raise(py)?.unwrap_or_default();
        if let Some(progress) = progress {
            progress.call1(py, (count, count))?;
        }
        Ok(Table::new(records, self.sweep.metadata()))
    }

    /// Opens or creates the folder of this sweep and returns the missing blocks. Each block is a tuple of its first row, the row after its
    /// last row, and the path of its file.
    ///
    /// Raises
    /// ------
    /// InputError
    ///     The folder contains another sweep. The message lists all differences, and no file is overwritten.
    #[pyo3(signature = (folder, block_rows = 131_072))]
    fn begin(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        #[pyo3(from_py_with = convert::whole)] block_rows: u64,
    ) -> PyResult<Vec<(u64, u64, PathBuf)>> {
        if block_rows == 0 {
            let what = "a block has at least one row".to_string();
            return Err(argument(py, "block_rows", what));
        }
        let folder = std::path::absolute(&folder).unwrap_or(folder);
        let blocks = py.detach(|| {
            let blocks =
                SharedBlocks::open(&folder, &self.sweep, block_rows, "parquet", Language::En)?;
            let missing = blocks.missing_of(0, 1)?;
            Ok((blocks.blocks, missing))
        });
        let (blocks, missing) = blocks.raise(py)?;
        let entry = |rows: Range<u64>| (rows.start, rows.end, blocks.path(&rows));
        Ok(missing.into_iter().map(entry).collect())
    }

    /// Hexadecimal fingerprint of the whole plan, including the content of its recordings. It is in the metadata of every table of the sweep.
    #[getter]
    fn fingerprint(&self) -> String {
        self.sweep.fingerprint()
    }

    /// Plan of the sweep as data, as in ``_plan.json``.
    #[getter]
    fn description<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        convert::json(py, &self.sweep.description())
    }

    fn __len__(&self) -> PyResult<usize> {
        Python::attach(|py| self.sweep.rows().raise(py)).map(|rows| rows as usize)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, Bound<'py, PyAny>> {
        let restore = py.get_type::<Sweep>().getattr("_restore")?;
        let state = self.question.state(py, self.sweep.files())?;
        Ok((
            restore,
            (state, self.time_limit).into_pyobject(py)?.into_any(),
        ))
    }

    #[staticmethod]
    fn _restore(state: &Bound<'_, PyAny>, time_limit: f64) -> PyResult<Sweep> {
        let (question, files) = Question::restore(state)?;
        let sweep = question.sweep(Some(files)).raise(state.py())?;
        Ok(Sweep {
            question,
            sweep,
            time_limit,
        })
    }

    fn _repr_html_(&self) -> String {
        let mut plan = self.sweep.description();
        for scene in plan["scenes"].as_array_mut().into_iter().flatten() {
            *scene = scene["name"].take();
        }
        let plan = serde_json::to_string_pretty(&plan).unwrap_or_default();
        html::head("Sweep", &self.sweep.fingerprint()) + &html::fixed(&plan)
    }

    fn __repr__(&self) -> String {
        let rows = self.sweep.rows().unwrap_or(u64::MAX);
        format!(
            "<gaitcam.Sweep of {rows} rows, {}>",
            self.sweep.fingerprint()
        )
    }
}

//! Class `Design`: a scene, its cam with all checks, and the files and plots of the design.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use gaitcam::cam::Verdict;
use gaitcam::error::Result;
use gaitcam::identify::Recut;
use gaitcam::synth::Outcome;
use gaitcam_app::design::{self, check_inputs_stay, finish};
use gaitcam_app::files::{self, Source};
use gaitcam_app::workshop::ecam_json;
use gaitcam_app::{Contents, Input, PATIENCE, ROWS, ResultFolder};
use gaitcam_cad::ecam::{self, Dialect};
use gaitcam_output::{self as output, Language, Timing};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyBytes, PyDict};
use serde_json::Value;

use crate::asked::{self, language, rows};
use crate::convert::{self, Argument, Reduced};
use crate::error::{NoSuchCam, Raise, argument};
use crate::force::{FILE, Force};
use crate::html;
use crate::law::Law;
use crate::scene::Scene;
use crate::synth::answer;
use crate::table::Table;

/// Inputs of a design: scene, force, limit of time (s), RMS force errors before and after a correction (N), and log files.
type Inputs = (Scene, Option<Force>, f64, Option<(f64, f64)>, Vec<PathBuf>);

/// A finished design: law of motion, cam, checks and verdict.
#[pyclass(frozen, module = "gaitcam")]
pub struct Design {
    /// Designed cam, or the reason why the scene has no cam.
    pub(crate) outcome: Outcome,
    /// Scene of the design, in which the given force is part of `[gait]`.
    pub input: Input,
    pub(crate) asked: Scene,
    pub(crate) force: Option<Force>,
    pub(crate) time: Timing,
    pub(crate) time_limit: f64,
    /// Force error before the correction, and predicted force error after it. `None` unless the design is a result of `recut`.
    pub(crate) recut: Option<Recut>,
    /// Paths of the log files that were used to correct the cam.
    pub(crate) logs: Vec<PathBuf>,
}

impl Argument for Design {
    const MADE: &'static str = "synth(scene) makes one";
}

impl Design {
    /// The design, even if it violates limits. A scene without a cam is an error.
    pub fn shown(&self) -> PyResult<&gaitcam::synth::Design> {
        match &self.outcome {
            Outcome::Built(design) => Ok(design),
            Outcome::NoCam(why) => Err(NoSuchCam::new_err(why.sentence(Language::En))),
        }
    }

    /// The design, if its cam can be manufactured. An infeasible scene is an error.
    pub fn cam(&self, py: Python<'_>) -> PyResult<&gaitcam::synth::Design> {
        let design = self.shown()?;
        match &design.infeasible {
            Some(why) => Err(NoSuchCam::new_err(why.sentence(Language::En))),
            None => py.check_signals().map(|()| design),
        }
    }

    /// The design with the figures of its correction (`None` without one) and the paths of the log files.
    pub(crate) fn corrected(self, figures: Option<Recut>, logs: Vec<PathBuf>) -> Design {
        Design {
            recut: figures,
            logs,
            ..self
        }
    }

    fn summarised(&self, scene: &toml::Table) -> Value {
        match &self.outcome {
            Outcome::Built(design) => {
                let mut summary = design::summary(design, scene, self.time);
                if let Some(recut) = self.recut {
                    summary["recut"] = serde_json::json!(recut);
                }
                summary
            }
            Outcome::NoCam(why) => {
                design::summary_without_cam(&self.input.scene.name, why, scene, self.time.total_s)
            }
        }
    }

    fn said(&self, language: Language) -> String {
        match &self.outcome {
            Outcome::Built(design) => design.reason(language),
            Outcome::NoCam(why) => why.sentence(language),
        }
    }

    /// Writes all files of the design except the scene and `summary.json`.
    fn write(
        &self,
        contents: &Contents,
        mut put: impl FnMut(&str, &[u8]) -> Result<()>,
    ) -> Result<()> {
        if let Outcome::Built(design) = &self.outcome {
            files::write(&Source::new(design, self.time, contents), &mut put)?;
        }
        match self.force.as_ref().and_then(|f| f.content(Path::new(FILE))) {
            Some(content) => put(FILE, &content),
            None => Ok(()),
        }
    }
}

#[pymethods]
impl Design {
    /// Verdict on the cam: ``acceptable``, ``not-for-high-speed`` or ``unacceptable``.
    #[getter]
    fn verdict(&self) -> &'static str {
        match &self.outcome {
            Outcome::Built(design) => design.verdict.name(),
            Outcome::NoCam(_) => Verdict::Unacceptable.name(),
        }
    }

    /// Reasons for the verdict, as sentences in the language ``lang`` ("en" or "es").
    #[pyo3(signature = (lang = "en"))]
    fn reason(&self, py: Python<'_>, lang: &str) -> PyResult<String> {
        Ok(self.said(language(py, lang)?))
    }

    /// Data of the design as in ``summary.json``. Numbers are in SI units, and names end with the unit.
    #[getter]
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let summary = || self.summarised(&self.input.resolved());
        convert::json(py, &py.detach(summary))
    }

    /// Results of all checks: a list of ``{name, worst, limit, at_rad, pass}``.
    #[getter]
    fn checks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.shown()?;
        self.summary(py)?.get_item("checks")
    }

    /// Law of motion at 1440 equal steps of the cam angle, as in ``law.csv``.
    #[getter]
    fn law(&self, py: Python<'_>) -> PyResult<Table> {
        let design = self.shown()?;
        let columns = py.detach(|| output::csv::law_columns(design, ROWS));
        Ok(Table::of_numbers(columns))
    }

    /// Profile at 1440 equal steps of the cam angle, as in ``profile.csv``. Each row is the contact point at one cam angle.
    #[getter]
    fn profile(&self, py: Python<'_>) -> PyResult<Table> {
        let design = self.cam(py)?;
        let columns = py.detach(|| output::csv::profile_columns(design, ROWS));
        Ok(Table::of_numbers(columns))
    }

    /// Force errors of all cycles of several walkers, as in ``walkers.csv``. The table has no rows for a single force.
    #[getter]
    fn walkers(&self) -> PyResult<Table> {
        let records = output::csv::walkers(self.shown()?);
        Ok(Table::new(records.unwrap_or_default(), Vec::new()))
    }

    /// Tables ``law`` and ``profile`` with a given number of rows.
    fn tables(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = convert::whole)] points: usize,
    ) -> PyResult<(Table, Table)> {
        let points = rows(py, points)?;
        let design = self.cam(py)?;
        let (law, profile) = py.detach(|| {
            (
                output::csv::law_columns(design, points),
                output::csv::profile_columns(design, points),
            )
        });
        Ok((Table::of_numbers(law), Table::of_numbers(profile)))
    }

    /// Law of motion as a function of the cam angle.
    #[getter]
    fn motion(slf: &Bound<'_, Self>) -> PyResult<Law> {
        let own = slf.get().shown()?;
        let design = slf.clone().into_any().unbind();
        Ok(Law::of_design(
            own.family.name(),
            own.cam.law.clone(),
            design,
        ))
    }

    /// Scene of the design, in which a given force replaces the force of the original scene.
    #[getter]
    fn scene(&self) -> Scene {
        Scene::of_input(self.input.clone())
    }

    /// Name of the scene.
    #[getter]
    fn name(&self) -> &str {
        &self.input.scene.name
    }

    /// Calls :func:`identify` for this design.
    fn identify<'py>(
        slf: &Bound<'py, Self>,
        logs: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        (slf.py().import("gaitcam")?).call_method1("identify", (slf, logs))
    }

    /// Calls :func:`recut` for this design.
    fn recut<'py>(slf: &Bound<'py, Self>, logs: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        (slf.py().import("gaitcam")?).call_method1("recut", (slf, logs))
    }

    /// Writes the files of ``gaitcam synth --out DIR`` and returns the folder.
    ///
    /// Parameters
    /// ----------
    /// folder : path
    /// points : int
    ///     Number of rows in the tables.
    /// png : bool
    ///     Also write the figures as PNG, in addition to SVG.
    /// solid : bool
    ///     Also write solids (STEP, STL, 3MF), a workshop drawing (PDF) and a workbook (XLSX).
    /// tool : float (m) or str ("3 mm"), optional
    ///     Radius of a milling cutter. If given, the path of its centre and its program are also written.
    /// wire : float (m) or str ("0.14 mm"), optional
    ///     Half the diameter of a cutting wire plus the spark gap. If given, the program for wire cutting is also written.
    /// dxf : str
    ///     Kind of curves in profile.dxf: "arcs" (R12), "splines" (R2000) or "lines" (R12, chords within 0.002 mm).
    /// cut_only : bool
    ///     Write only the edges to be cut (layers ``CUT_*``) to profile.dxf.
    /// lang : str
    ///     Language of the report and the figures, "en" or "es".
    #[pyo3(signature = (folder, **options), text_signature = "($self, folder, *, points=1440, png=True, solid=False, tool=None, wire=None, dxf='arcs', \
        cut_only=False, lang='en')")]
    fn save(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<PathBuf> {
        let contents = asked::contents(py, options, true, self.input.title())?;
        let written = py.detach(|| {
            check_inputs_stay(&folder, &self.input, &self.logs)?;
            let place = ResultFolder::open(&folder, PATIENCE)?;
            self.write(&contents, |name, bytes| place.write(name, bytes))?;
            let scene = self.input.resolved();
            let summary = self.summarised(&scene);
            finish(place, &self.input, &scene, &summary)
        });
        written.raise(py)
    }

    /// Files that :meth:`save` writes, as a dictionary that maps file names to bytes. The options are the options of :meth:`save`.
    #[pyo3(signature = (**options), text_signature = "($self, *, points=1440, png=False, solid=False, tool=None, wire=None, dxf='arcs', \
        cut_only=False, lang='en')")]
    fn files<'py>(
        &self,
        py: Python<'py>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let contents = asked::contents(py, options, false, self.input.title())?;
        let files = py.detach(|| {
            let mut files = BTreeMap::new();
            self.write(&contents, |name, bytes| {
                files.insert(name.to_string(), bytes.to_vec());
                Ok(())
            })?;
            let scene = self.input.resolved();
            let summary = self.summarised(&scene);
            let summary = serde_json::to_string_pretty(&summary).unwrap_or_default();
            files.insert("summary.json".to_string(), summary.into_bytes());
            let scene = toml::to_string(&scene).unwrap_or_default();
            files.insert("scene.toml".to_string(), scene.into_bytes());
            Ok(files)
        });
        let files = files.raise(py)?.into_iter();
        let files = files.map(|(name, bytes)| (name, PyBytes::new(py, &bytes)));
        files.into_py_dict(py)
    }

    /// Electronic cam for a motion controller, and the force error with this controller.
    ///
    /// Parameters
    /// ----------
    /// dialect : str
    ///     Kind of controller: "codesys", "twincat", "segments", "rockwell" or "csv".
    /// points : int, optional
    ///     Number of equal intervals per cycle. By default it is the smallest number that reproduces the law.
    ///
    /// Returns
    /// -------
    /// dict
    ///     ``text`` is the content of the file, ``file`` its name, ``dialect`` the kind of controller and ``points`` the number of
    ///     intervals. ``rms_error_n`` is the RMS difference between the force and its target. ``added_rms_n`` is the RMS difference
    ///     from the force of the law, and ``added_percent`` is this difference relative to the mean force.
    ///
    /// Raises
    /// ------
    /// InputError
    ///     The dialect is unknown, or the number of points is too small. The message contains a sufficient number.
    #[pyo3(signature = (dialect, points = None))]
    fn ecam<'py>(
        &self,
        py: Python<'py>,
        dialect: &str,
        points: Option<usize>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let Some(known) = Dialect::ALL.into_iter().find(|d| d.name() == dialect) else {
            let names = Dialect::ALL.map(Dialect::name).join(", ");
            let what = format!("{dialect:?} is not a dialect; give one of {names}");
            return Err(argument(py, "dialect", what));
        };
        let design = self.cam(py)?;
        let cam = py.detach(|| ecam::make(design, known, points)).raise(py)?;
        let mut out = ecam_json(&cam, known.file());
        out["text"] = cam.text.into();
        convert::json(py, &out)
    }

    /// Draws the design with matplotlib.
    ///
    /// Parameters
    /// ----------
    /// ax : matplotlib.axes.Axes, optional
    ///     Axes for the plot. By default, new axes are created.
    /// what : str
    ///     "force" plots the force and its target (N) over the cam angle (°). "law" plots the lift (mm) over the cam angle. "profile" plots
    ///     the profile of the cam (mm).
    ///
    /// Returns
    /// -------
    /// matplotlib.axes.Axes
    #[pyo3(signature = (ax = None, what = "force"))]
    fn plot<'py>(
        slf: &Bound<'py, Self>,
        ax: Option<&Bound<'py, PyAny>>,
        what: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = slf.py();
        if !["force", "law", "profile"].contains(&what) {
            let what = format!("{what:?} is no diagram; give \"force\", \"law\" or \"profile\"");
            return Err(argument(py, "what", what));
        }
        let module = py.import("gaitcam._plot")?;
        module.call_method1("plot", (slf, ax, what))
    }

    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        let said = format!("{}. {}", self.verdict(), self.said(Language::En));
        let head = html::head(self.name(), &said);
        let Some(design) = self.shown().ok().filter(|d| d.infeasible.is_none()) else {
            return Ok(head);
        };
        let pictures = py.detach(|| {
            let language = Language::En;
            [
                output::plots::cam(design, language),
                output::plots::force(design, language),
                output::plots::svaj(design, language),
            ]
            .map(|picture| picture.svg())
        });
        let cell = |svg: &String| format!("<div style=\"flex:1 1 24em\">{svg}</div>");
        let cells: String = pictures.iter().map(cell).collect();
        Ok(format!(
            "<div>{head}<div style=\"display:flex;flex-wrap:wrap\">{cells}</div></div>"
        ))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, Inputs> {
        // The inputs determine a design, so only the inputs are pickled. A corrected cam also needs the figures of its logs.
        let restore = py.get_type::<Design>().getattr("_restore")?;
        let figures = self.recut.map(|r| (r.before_rms_n, r.predicted_rms_n));
        let inputs = (
            self.asked.clone(),
            self.force.clone(),
            self.time_limit,
            figures,
            self.logs.clone(),
        );
        Ok((restore, inputs))
    }

    #[staticmethod]
    fn _restore(
        py: Python<'_>,
        scene: PyRef<'_, Scene>,
        force: Option<PyRef<'_, Force>>,
        time_limit: f64,
        figures: Option<(f64, f64)>,
        logs: Vec<PathBuf>,
    ) -> PyResult<Design> {
        let figures = figures.map(|(before_rms_n, predicted_rms_n)| Recut {
            before_rms_n,
            predicted_rms_n,
        });
        let design = answer(py, scene.clone(), force.as_deref().cloned(), time_limit)?;
        Ok(design.corrected(figures, logs))
    }

    fn __repr__(&self) -> String {
        format!("<gaitcam.Design {:?}: {}>", self.name(), self.verdict())
    }
}

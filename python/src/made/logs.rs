//! Evaluation of machine logs: identification of machine parameters, and design of the next cam.

use std::path::{Path, PathBuf};

use gaitcam::identify::{self as machine, Log, LogColumns, LogOptions};
use gaitcam::scene::set_value;
use gaitcam::wording::Language;
use gaitcam_app::read::read_bytes;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

use crate::convert::{self, Argument};
use crate::design::Design;
use crate::error::{NoSuchCam, Raise, argument};
use crate::interrupt;
use crate::scene::Scene;
use crate::synth::answer;

/// Names of the columns in a log that is given as arrays.
const COLUMNS: [&str; 5] = [
    "time_s",
    "theta_rad",
    "force_n",
    "speed_rad_per_s",
    "torque_n_m",
];

/// Options with the names of columns in log files, and the number of encoder counts per turn.
const OPTIONS: [&str; 6] = [
    "time",
    "angle",
    "force",
    "speed",
    "torque",
    "counts_per_turn",
];

/// Identifies the parameters of a machine from its logs. The result is the same as for ``gaitcam identify --json``.
///
/// Parameters
/// ----------
/// design : Design
/// logs : path, mapping of arrays, or a list of these
///     Logs of steady running, at one or several speeds. A file must contain columns of the force, and of the time or the cam
///     angle (or both). Columns of speed and torque are optional. Columns are recognised by their names and units. A
///     mapping must contain ``force_n``, and ``time_s`` or ``theta_rad``. ``speed_rad_per_s`` and ``torque_n_m`` are optional.
///     The values of the mapping are arrays of shape (n,) in SI units.
/// time, angle, force, speed, torque : str
///     Name or number of the column in the files, if the column is not recognised automatically.
/// counts_per_turn : float
///     Encoder counts per turn of the cam, if the angle is given in counts.
///
/// Returns
/// -------
/// dict
///     ``parameters`` is a list of dictionaries with ``key``, ``value``, ``low`` and ``high`` (limits of the 95 % interval), and
///     ``identifiable``. ``noise_rms_n`` and ``repeatable_rms_n`` are the RMS noise and the RMS repeatable force error, N.
///     ``next_run`` describes a further run that would identify more parameters, or is ``None``.
///
/// Raises
/// ------
/// InputError
///     A log contains no steady running of this machine. The message contains the reason.
/// NoSuchCam
///     The design has no cam.
#[pyfunction]
#[pyo3(signature = (design, logs, **columns), text_signature = "(design, logs, *, time=None, angle=None, force=None, \
    speed=None, torque=None, counts_per_turn=None)")]
pub fn identify<'py>(
    py: Python<'py>,
    design: &Bound<'py, PyAny>,
    logs: &Bound<'py, PyAny>,
    columns: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let made = Design::given(design, "design")?.get();
    let cam = made.cam(py)?;
    let (logs, _) = read(logs, columns)?;
    let scene = &made.input.scene;
    let found = py.detach(|| machine::identify(cam, scene, &logs));
    convert::json(py, &serde_json::json!(found.raise(py)?))
}

/// Designs the next cam, which corrects the repeatable force error in logs of the running machine.
///
/// Parameters
/// ----------
/// design : Design
/// logs, time, angle, force, speed, torque, counts_per_turn
///     The arguments of :func:`identify`. The log with the speed closest to the speed of the design is used for the correction. The
///     other logs are used only for the identification.
///
/// Returns
/// -------
/// Design
///     Design of the next cam. ``summary["recut"]`` contains the measured force error before the correction and the predicted
///     force error after it.
///
/// Raises
/// ------
/// InputError
///     A log contains no steady running of this machine.
/// NoSuchCam
///     The differences between logs and design are only noise, or the design has no cam.
#[pyfunction]
#[pyo3(signature = (design, logs, **columns), text_signature = "(design, logs, *, time=None, angle=None, force=None, \
    speed=None, torque=None, counts_per_turn=None)")]
pub fn recut(
    py: Python<'_>,
    design: &Bound<'_, PyAny>,
    logs: &Bound<'_, PyAny>,
    columns: Option<&Bound<'_, PyDict>>,
) -> PyResult<Design> {
    let made = Design::given(design, "design")?.get();
    let cam = made.cam(py)?;
    let (logs, files) = read(logs, columns)?;
    let found = interrupt::run(py, made.time_limit, |search| {
        let named = match &made.force {
            Some(_) => None,
            None => made.input.target()?,
        };
        let target = made.force.as_ref().map(|f| &f.curve).or(named.as_ref());
        machine::recut(cam, &made.input.scene, target, &logs, search)
    });
    let (next, figures, _) = match found? {
        Err(why) if why.is_answer() => {
            return Err(NoSuchCam::new_err(why.sentence(Language::En)));
        }
        found => found.raise(py)?,
    };
    let asked = &made.asked.input;
    let mut table = asked.table.clone();
    let learned = next.to_table()["machine"]["learned_force"].clone();
    set_value(&mut table, "machine.learned_force", learned).raise(py)?;
    let scene = Scene::of_table(py, table, asked.files.clone(), asked.file.clone())?;
    let next = answer(py, scene, made.force.clone(), made.time_limit)?;
    Ok(next.corrected(Some(figures), files))
}

/// Reads logs from files or arrays. Also returns the paths of the log files.
fn read(
    given: &Bound<'_, PyAny>,
    columns: Option<&Bound<'_, PyDict>>,
) -> PyResult<(Vec<Log>, Vec<PathBuf>)> {
    let py = given.py();
    let named = convert::options(py, columns, &OPTIONS)?;
    let options = LogOptions {
        time: convert::option(&named, "time")?,
        angle: convert::option(&named, "angle")?,
        force: convert::option(&named, "force")?,
        speed: convert::option(&named, "speed")?,
        torque: convert::option(&named, "torque")?,
        counts_per_turn: convert::option(&named, "counts_per_turn")?,
    };
    let is_list = given.is_instance_of::<PyList>() || given.is_instance_of::<PyTuple>();
    let each: Vec<Bound<'_, PyAny>> = match is_list {
        true => given.try_iter()?.collect::<PyResult<_>>()?,
        false => vec![given.clone()],
    };
    if each.is_empty() {
        return Err(argument(py, "logs", "an empty list of logs".to_string()));
    }
    let (mut logs, mut files) = (Vec::new(), Vec::new());
    for (number, log) in (1..).zip(&each) {
        let Ok(path) = log.extract::<PathBuf>() else {
            let name = format!("log {number}");
            logs.push(Log::new(Path::new(&name), arrays(log)?).raise(py)?);
            continue;
        };
        let of_file = || Log::read(&path, &read_bytes(&path)?, &options);
        logs.push(py.detach(of_file).raise(py)?);
        files.push(path);
    }
    if files.is_empty() && options != LogOptions::default() {
        let what = "columns are named in files; arrays have the names of their keys";
        return Err(PyTypeError::new_err(what));
    }
    Ok((logs, files))
}

/// Columns of a log in SI units, from a mapping of names to arrays.
fn arrays(log: &Bound<'_, PyAny>) -> PyResult<LogColumns> {
    let mut columns: [Option<Vec<f64>>; 5] = Default::default();
    for name in convert::keys(log, "logs")? {
        let Some(place) = COLUMNS.iter().position(|known| *known == name) else {
            let names = COLUMNS.join(", ");
            let what = format!("{name:?} is not a column of a log; the columns are {names}");
            return Err(argument(log.py(), "logs", what));
        };
        let values = convert::numbers(&log.get_item(&name)?, &name)?;
        columns[place] = Some(values.as_array().to_vec());
    }
    let [time, theta, force, speed, torque] = columns;
    let Some(force) = force else {
        let what = "a log without force_n".to_string();
        return Err(argument(log.py(), "logs", what));
    };
    Ok(LogColumns {
        time,
        theta,
        force,
        speed,
        torque,
    })
}

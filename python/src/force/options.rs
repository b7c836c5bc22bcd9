//! Options for reading recordings: keys of `[gait]` as keyword arguments.

use std::path::Path;

use gaitcam::error::{Error, ForceError, Placed};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use toml::{Table, Value};

use crate::convert;
use crate::error::{Raise, argument};

/// Names of the options for a file. A quantity is a text with its unit, or a number if the option name ends with the SI unit.
pub const OF_FILE: [&str; 16] = [
    "feet", "rate", "rate_hz", "mass", "mass_kg", "unit", "kind", "accept", "time", "force",
    "period", "period_s", "span", "span_rad", "noise", "noise_n",
];
/// Names of the options for arrays. Options for the sampling rate and for column names are excluded, because arrays do not need them.
pub const OF_ARRAYS: [&str; 12] = [
    "feet", "mass", "mass_kg", "unit", "kind", "accept", "period", "period_s", "span", "span_rad",
    "noise", "noise_n",
];

/// Section `[gait]` for a recording, from the keyword arguments of a call.
///
/// # Errors
///
/// `TypeError` for an unknown option and for a quantity that is given twice. For an unknown option, the message contains the valid names.
pub fn gait(
    py: Python<'_>,
    options: Option<&Bound<'_, PyDict>>,
    known: &[&str],
    path: &Path,
) -> PyResult<Table> {
    let mut gait = Table::new();
    for (name, value) in convert::options(py, options, known)? {
        let (key, value) = convert::entry(format!("gait.{name}"), &value)?;
        let key = key.trim_start_matches("gait.").to_string();
        let again = format!("{key}: one value, not one as text and one as a number");
        if gait.insert(key, value).is_some() {
            return Err(PyTypeError::new_err(again));
        }
    }
    let file = Value::from(path.to_string_lossy().into_owned());
    gait.insert("file".to_string(), file);
    Ok(gait)
}

/// Name of a walker: `given`, or `default` if no name is given.
///
/// # Errors
///
/// The name is blank or contains control characters.
pub fn name(py: Python<'_>, given: Option<&str>, default: &str) -> PyResult<String> {
    let Some(name) = given.map(str::trim) else {
        return Ok(default.to_string());
    };
    if name.is_empty() || name.contains(char::is_control) {
        let what = format!("{name:?} is not a name; give text of one line");
        return Err(argument(py, "name", what));
    }
    Ok(name.to_string())
}

/// Text table of a recording that is given as arrays: times in s, and one column in N for each plate.
///
/// # Errors
///
/// The arrays do not contain numbers or have different lengths.
pub fn table_of_arrays(t_s: &Bound<'_, PyAny>, f_n: &Bound<'_, PyAny>) -> PyResult<String> {
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
        let times = rows;
        let fault: Error = ForceError::Lengths { times, forces }.at_key("f_n");
        return Err(fault).raise(py);
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
    Ok(text)
}

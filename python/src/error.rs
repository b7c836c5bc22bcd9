//! Errors as Python exceptions, with message, key and suggested correction.

use gaitcam::error::{Error, Place, Placed};
use gaitcam::wording::Language;
use pyo3::create_exception;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::panic::PanicException;
use pyo3::prelude::*;
use pyo3::types::PyType;

create_exception!(
    gaitcam,
    InputError,
    PyValueError,
    "Error in an input: in a scene, a file or an argument.\n\n\
     Attributes\n----------\n\
     key : str or None\n    Key of the scene, or name of the argument, that is wrong, such as ``limits.stroke``.\n\
     help : str or None\n    Suggested correction.\n\
     code : str\n    Name of the error for use in programs. It does not change if the message is reworded.\n\
     place : str\n    File, line or key of the error, as text; empty if the error has no place."
);
create_exception!(
    gaitcam,
    NoSuchCam,
    PyRuntimeError,
    "The design has no cam: its limits conflict, or a flat face cannot touch the profile everywhere."
);

/// Class of the exception for a panic: `gaitcam.InternalError`, which `except Exception` catches.
///
/// pyo3 raises this exception for a panic in any function or method. The functions therefore need no code for panics.
pub fn internal(py: Python<'_>) -> PyResult<Bound<'_, PyType>> {
    let own = py.get_type::<PanicException>();
    own.setattr("__bases__", (py.get_type::<PyRuntimeError>(),))?;
    own.setattr("__name__", "InternalError")?;
    own.setattr("__qualname__", "InternalError")?;
    own.setattr("__module__", "gaitcam")?;
    own.setattr(
        "__doc__",
        "Internal error of gaitcam. Please report it with the scene.",
    )?;
    let said =
        c"lambda fault: f'internal error ({fault.args[0]}); please report it with the scene'";
    own.setattr("__str__", py.eval(said, None, None)?)?;
    Ok(own)
}

/// Python exception for an error, with the attributes `key`, `code`, `place` and `help`.
pub fn raised(py: Python<'_>, fault: Error) -> PyErr {
    let help = fault.help(Language::En);
    let error = InputError::new_err(fault.sentence(Language::En));
    let value = error.value(py);
    let place = fault.place.to_string();
    let place = place.trim_end_matches(": ");
    let set = |name: &str, attribute: Option<&str>| value.setattr(name, attribute);
    let attributes = set("key", key(&fault.place).as_deref())
        .and_then(|()| set("help", help.as_deref()))
        .and_then(|()| set("code", Some(&fault.code())))
        .and_then(|()| set("place", Some(place)));
    match attributes {
        Ok(()) => error,
        Err(other) => other,
    }
}

/// Key or argument at which an error occurred, without the file; `None` for an error without a key or argument.
pub fn key(place: &Place) -> Option<String> {
    match place {
        Place::Key(key) => Some(key.rsplit(": ").next().unwrap_or(key).to_string()),
        Place::Argument(name) => Some(name.trim_start_matches('-').to_string()),
        Place::Unplaced | Place::File(_) | Place::Line(..) | Place::Byte(..) => None,
    }
}

/// Conversion of results of the library to results of Python functions.
pub trait Raise<T> {
    /// Returns the value, or raises the Python exception for the error.
    fn raise(self, py: Python<'_>) -> PyResult<T>;
}

impl<T> Raise<T> for gaitcam::error::Result<T> {
    fn raise(self, py: Python<'_>) -> PyResult<T> {
        self.map_err(|fault| raised(py, fault))
    }
}

/// Exception for an invalid value of the argument `name`. `what` is the message.
pub fn argument(py: Python<'_>, name: &str, what: String) -> PyErr {
    let fault = Error::own("python-argument", what).at_key(name);
    raised(py, fault)
}

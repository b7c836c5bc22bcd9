//! Faults as Python exceptions: what is wrong, at which key, what would be right.

use std::panic::{AssertUnwindSafe, catch_unwind};

use gaitcam::error::{Error, Place, Placed};
use gaitcam::wording::Language;
use pyo3::create_exception;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

create_exception!(
    gaitcam,
    InputError,
    PyValueError,
    "A fault in what was given.\n\n\
     Attributes\n----------\n\
     key : str or None\n    Key of the scene, or argument, that is wrong: ``limits.stroke``.\n\
     help : str or None\n    What would be right.\n\
     code : str\n    Name of the fault for programs; it does not change with its wording.\n\
     place : str\n    File, line or key, as text; empty where there is nothing to point at."
);
create_exception!(
    gaitcam,
    NoSuchCam,
    PyRuntimeError,
    "There is no cam to run: the limits conflict, or a flat face cannot touch the profile."
);

create_exception!(
    gaitcam,
    InternalError,
    PyRuntimeError,
    "A fault of gaitcam itself. Please report it with the scene."
);

/// Work without the interpreter's lock; a panic, on whatever thread, becomes an exception that ``except Exception``
/// catches.
pub fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let done = py.detach(|| catch_unwind(AssertUnwindSafe(work)));
    done.map_err(|cause| {
        let said = cause.downcast_ref::<String>().map(String::as_str);
        let said = said.or_else(|| cause.downcast_ref::<&str>().copied());
        let said = said.unwrap_or("a thread panicked");
        InternalError::new_err(format!(
            "internal error ({said}); please report it with the scene"
        ))
    })
}

/// The exception of a fault.
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

/// The key without its file.
fn key(place: &Place) -> Option<String> {
    match place {
        Place::Key(key) => Some(key.rsplit(": ").next().unwrap_or(key).to_string()),
        Place::Argument(name) => Some(name.trim_start_matches('-').to_string()),
        Place::Unplaced | Place::File(_) | Place::Line(..) | Place::Byte(..) => None,
    }
}

/// Results of the library as results of Python.
pub trait Raise<T> {
    /// The value, or the exception of the fault.
    fn raise(self, py: Python<'_>) -> PyResult<T>;
}

impl<T> Raise<T> for gaitcam::error::Result<T> {
    fn raise(self, py: Python<'_>) -> PyResult<T> {
        self.map_err(|fault| raised(py, fault))
    }
}

/// A fault of an argument that only Python can have.
pub fn argument(py: Python<'_>, name: &str, what: String) -> PyErr {
    let fault = Error::own("python-argument", what).at_key(name);
    raised(py, fault)
}

//! Conversion of Python values to TOML, and of JSON to Python values.

use gaitcam::error::{Error, nearest};
use gaitcam::scene;
use gaitcam::sweep::Key;
use numpy::{AllowTypeChange, PyArrayLike1};
use pyo3::PyClass;
use pyo3::exceptions::{PyOverflowError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyList, PyString, PyTuple};
use toml::{Table, Value};

use crate::error::{argument, raised};

/// Return value of `__reduce__`: a function, and the arguments with which it restores the object.
pub type Reduced<'py, T> = PyResult<(Bound<'py, PyAny>, T)>;

/// Converts a mapping to the table of a scene. `at` is the dotted key of the table, or empty for the whole scene.
pub fn table(mapping: &Bound<'_, PyDict>, at: &str) -> PyResult<Table> {
    let mut out = Table::new();
    for (key, value) in mapping {
        let Ok(key) = key.extract::<String>() else {
            let what = format!("{}keys are strings, not {}", place(at), kind(&key)?);
            return Err(PyTypeError::new_err(what));
        };
        let path = if at.is_empty() {
            key
        } else {
            format!("{at}.{key}")
        };
        let (path, value) = entry(path, &value)?;
        let key = path.rsplit('.').next().unwrap_or(&path);
        out.insert(key.to_string(), value);
    }
    Ok(out)
}

/// Converts a dotted key and its value. If the key ends in an SI unit, such as ``limits.stroke_m``, a number becomes a quantity with this unit.
pub fn entry(key: String, given: &Bound<'_, PyAny>) -> PyResult<(String, Value)> {
    let value = value(given, &key)?;
    let Some(quantity) = si_key(&key) else {
        return Ok((key, value));
    };
    let number = match &value {
        Value::Integer(x) => x.to_string(),
        Value::Float(x) => x.to_string(),
        _ => return Ok((key, value)),
    };
    let text = format!("{number} {}", quantity.unit());
    Ok((quantity.name().to_string(), Value::String(text)))
}

/// Key and unit of a name that ends in an SI unit. `None` for other names, and for names that are themselves keys of scenes.
pub fn si_key(name: &str) -> Option<Key> {
    let key = Key::of_column(name);
    (key.is_number() && scene::keys::find(name).is_none()).then_some(key)
}

/// Class of this package. Functions accept its objects as arguments.
pub trait Argument: PyClass {
    /// Text for error messages that describes how to create such an object.
    const MADE: &'static str;

    /// Converts the value of the argument `name`. An object of another class is a `TypeError`.
    fn given<'a, 'py>(given: &'a Bound<'py, PyAny>, name: &str) -> PyResult<&'a Bound<'py, Self>> {
        given.cast::<Self>().map_err(|_| {
            let (own, made, other) = (Self::NAME, Self::MADE, kind(given));
            let other = other.unwrap_or_default();
            PyTypeError::new_err(format!("{name}: a {own}, not {other}; {made}"))
        })
    }
}

/// Converts a Python value to a value of a scene. `at` is its dotted key.
pub fn value(given: &Bound<'_, PyAny>, at: &str) -> PyResult<Value> {
    if let Ok(text) = given.cast::<PyString>() {
        return Ok(Value::String(text.to_string()));
    }
    if given.is_instance_of::<PyBool>() {
        return Ok(Value::Boolean(given.extract()?));
    }
    if let Ok(mapping) = given.cast::<PyDict>() {
        return Ok(Value::Table(table(mapping, at)?));
    }
    if given.is_instance_of::<PyList>() || given.is_instance_of::<PyTuple>() {
        let entries = given.try_iter()?.enumerate();
        let list: PyResult<Vec<Value>> = entries
            .map(|(i, entry)| value(&entry?, &format!("{at}.{}", i + 1)))
            .collect();
        return Ok(Value::Array(list?));
    }
    if let Ok(number) = given.extract::<i64>() {
        return Ok(Value::Integer(number));
    }
    if !given.hasattr("__len__")?
        && let Ok(number) = given.extract::<f64>()
    {
        return Ok(Value::Float(number));
    }
    Err(PyTypeError::new_err(format!(
        "{}{} is no value of a scene; give text with a unit, a number, a truth value, a list or a mapping",
        place(at),
        kind(given)?
    )))
}

fn place(at: &str) -> String {
    if at.is_empty() {
        return String::new();
    }
    format!("{at}: ")
}

fn kind(given: &Bound<'_, PyAny>) -> PyResult<String> {
    Ok(given.get_type().name()?.to_string())
}

/// Converts JSON data to Python dictionaries, lists, numbers and strings.
pub fn json<'py>(py: Python<'py>, value: &serde_json::Value) -> PyResult<Bound<'py, PyAny>> {
    py.import("json")?
        .call_method1("loads", (value.to_string(),))
}

/// Converts an integer. A negative or too large integer is an error.
pub fn whole<'py, T>(given: &Bound<'py, PyAny>) -> PyResult<T>
where
    T: for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    let py = given.py();
    given.extract().map_err(|fault: PyErr| {
        if !fault.is_instance_of::<PyOverflowError>(py) {
            return fault;
        }
        let what = format!("{given} is negative or too large; give a whole number from 0");
        raised(py, Error::own("python-argument", what))
    })
}

/// Keyword arguments of a call, after a check of their names.
///
/// # Errors
///
/// `TypeError` for an unknown option. The message contains the valid names.
pub fn options<'py>(
    py: Python<'py>,
    given: Option<&Bound<'py, PyDict>>,
    known: &[&str],
) -> PyResult<Bound<'py, PyDict>> {
    let out = PyDict::new(py);
    for (key, value) in given.into_iter().flatten().filter(|(_, v)| !v.is_none()) {
        let name: String = key.extract()?;
        if !known.contains(&name.as_str()) {
            let near = nearest(&name, known.iter().copied());
            let near = near.map_or(String::new(), |n| format!("; did you mean '{n}'?"));
            let names = known.join(", ");
            let what = format!("unexpected keyword argument '{name}'{near} (options: {names})");
            return Err(PyTypeError::new_err(what));
        }
        out.set_item(key, value)?;
    }
    Ok(out)
}

/// Value of an option; `None` if the call does not contain the option.
pub fn option<'py, T>(given: &Bound<'py, PyDict>, name: &str) -> PyResult<Option<T>>
where
    T: for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    let value = given.get_item(name)?;
    let extracted = value.map(|value| value.extract()).transpose();
    extracted.map_err(|fault: PyErr| {
        let what = format!("{name}: {}", fault.value(given.py()));
        PyTypeError::new_err(what)
    })
}

/// Column names of a mapping. `name` is the argument in error messages.
pub fn keys(columns: &Bound<'_, PyAny>, name: &str) -> PyResult<Vec<String>> {
    let Ok(keys) = columns.call_method0("keys") else {
        let what = format!("{name}: a table or a mapping, not {}", kind(columns)?);
        return Err(PyTypeError::new_err(what));
    };
    keys.try_iter()?.map(|key| key?.extract()).collect()
}

/// Converts an array-like object to a numpy array. `name` is the argument in error messages.
pub fn array<'py>(given: &Bound<'py, PyAny>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    let py = given.py();
    let array = py.import("numpy")?.call_method1("asarray", (given,));
    array.map_err(|fault| match fault.is_instance_of::<PyValueError>(py) {
        true => argument(py, name, fault.value(py).to_string()),
        false => fault,
    })
}

/// Numbers of a one-dimensional object, such as an array, a list or a column of a table.
///
/// An array of 64-bit floating-point numbers is read without a copy.
pub fn numbers<'py>(
    given: &Bound<'py, PyAny>,
    name: &str,
) -> PyResult<PyArrayLike1<'py, f64, AllowTypeChange>> {
    let py = given.py();
    let array = array(given, name)?;
    let dimensions: usize = array.getattr("ndim")?.extract()?;
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    let empty = dimensions == 1 && array.len()? == 0;
    if !(empty || matches!(&*kind, "f" | "i" | "u")) {
        let kind = array.getattr("dtype")?;
        let what = format!("{name}: an array of {kind} holds no numbers");
        return Err(PyTypeError::new_err(what));
    }
    if dimensions != 1 {
        let shape = array.getattr("shape")?;
        let what = format!("an array of shape {shape} has not one dimension");
        return Err(argument(py, name, what));
    }
    array.extract()
}

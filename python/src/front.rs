//! Pareto front of a table of designs.

use gaitcam::sweep::{self, Admission, Objective};
use gaitcam_base::wording::{Language, exact};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;

use crate::convert::{self, Reduced};
use crate::error::Raise;
use crate::html;

/// Pareto front of a table of designs, which contains the non-dominated designs.
#[pyclass(frozen, module = "gaitcam")]
pub struct Front {
    names: Vec<String>,
    positions: Vec<i64>,
    best: Option<i64>,
    values: Vec<Vec<f64>>,
    left_out: usize,
}

/// State of a front for pickling: objectives, row indices, best row, values, and number of excluded designs.
type State = (Vec<String>, Vec<i64>, Option<i64>, Vec<Vec<f64>>, usize);

/// One column name, or a list of column names.
#[derive(FromPyObject)]
pub enum Names {
    One(String),
    Several(Vec<String>),
}

impl Names {
    fn list(self) -> Vec<String> {
        match self {
            Names::One(name) => vec![name],
            Names::Several(names) => names,
        }
    }
}

/// Computes the Pareto front of a table of designs: all designs that no other design dominates.
///
/// Parameters
/// ----------
/// table
///     Table of a sweep: a table of gaitcam, pandas, polars or pyarrow, or a dictionary that maps names to columns.
/// minimise, maximise : str or list of str
///     Objectives: full column names, or their first parts, such as ``["force_error", "torque_max"]``. By default, force error and prime
///     radius are minimised.
/// low_speed : bool
///     Include designs that are not for high speed.
/// all : bool
///     Include unacceptable designs.
#[pyfunction]
#[pyo3(signature = (table, minimise = None, maximise = None, *, low_speed = false, all = false))]
pub fn front(
    table: &Bound<'_, PyAny>,
    minimise: Option<Names>,
    maximise: Option<Names>,
    low_speed: bool,
    all: bool,
) -> PyResult<Front> {
    let py = table.py();
    let names = names(table)?;
    let minimise = match (minimise, &maximise) {
        (None, None) => Objective::usual(),
        (given, _) => given.map_or(Vec::new(), Names::list),
    };
    let maximise = maximise.map_or(Vec::new(), Names::list);
    let mut objectives = Vec::new();
    let wanted = minimise.iter().map(|n| (n, false));
    for (name, maximised) in wanted.chain(maximise.iter().map(|n| (n, true))) {
        objectives.push(Objective::of(name, maximised, &names).raise(py)?);
    }
    let mut columns = Vec::new();
    for objective in &objectives {
        let column = table.get_item(&objective.name)?;
        columns.push(
            convert::numbers(&column, &objective.name)?
                .as_array()
                .to_vec(),
        );
    }
    let (outcomes, verdicts) = (words(table, "outcome")?, words(table, "verdict")?);
    Ok(py.detach(|| {
        let admission = Admission { low_speed, all };
        let mut found = sweep::Front::default();
        let mut left_out = 0;
        let mut costs = vec![0.0; objectives.len()];
        for (row, (outcome, verdict)) in outcomes.iter().zip(&verdicts).enumerate() {
            left_out += usize::from(admission.leaves_out(outcome, verdict));
            if !admission.takes(outcome, verdict) {
                continue;
            }
            for ((cost, objective), column) in costs.iter_mut().zip(&objectives).zip(&columns) {
                *cost = objective.cost(column[row]);
            }
            found.offer(row as u64, &costs, Vec::new);
        }
        let value = |p: &&sweep::Point| -> Vec<f64> {
            let both = objectives.iter().zip(&p.values);
            both.map(|(o, cost)| o.value(*cost)).collect()
        };
        let sorted = found.sorted();
        Front {
            positions: sorted.iter().map(|p| p.row as i64).collect(),
            values: sorted.iter().map(value).collect(),
            best: found.best().map(|p| p.row as i64),
            names: objectives.into_iter().map(|o| o.name).collect(),
            left_out,
        }
    }))
}

/// Column names of a table of any supported kind.
fn names(table: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    for attribute in ["column_names", "columns"] {
        if let Ok(names) = table.getattr(attribute)
            && let Ok(names) = names.try_iter()
        {
            return names.map(|n| n?.extract()).collect();
        }
    }
    convert::keys(table, "table")
}

/// Values of a text column. A missing value becomes an empty text.
fn words(table: &Bound<'_, PyAny>, name: &str) -> PyResult<Vec<String>> {
    let column = table.get_item(name)?;
    // The values of a pyarrow column are not Python strings, so the column is converted to a list.
    let column = match column.call_method0("to_pylist") {
        Ok(list) => list,
        Err(_) => column,
    };
    let text = |word: PyResult<Bound<'_, PyAny>>| -> PyResult<String> {
        Ok(word?.extract::<String>().unwrap_or_default())
    };
    column.try_iter()?.map(text).collect()
}

#[pymethods]
impl Front {
    /// Row indices of the non-dominated designs in the table, sorted by the first objective; shape (n,).
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        PyArray1::from_slice(py, &self.positions)
    }

    /// Values of the objectives in SI units; shape (n, objectives).
    #[getter]
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        Ok(PyArray2::from_vec2(py, &self.values)?)
    }

    /// Column names of the objectives.
    #[getter]
    fn objectives(&self) -> Vec<String> {
        self.names.clone()
    }

    /// Row index of the best compromise; ``None`` for an empty front. The best compromise is the design nearest to the ideal point. Each
    /// objective is scaled to the range 0 … 1 over the front.
    #[getter]
    fn best(&self) -> Option<i64> {
        self.best
    }

    /// Number of designs that were excluded because they are not for high speed.
    #[getter]
    fn left_out(&self) -> usize {
        self.left_out
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, State> {
        let restore = py.get_type::<Front>().getattr("_restore")?;
        let (names, values) = (self.names.clone(), self.values.clone());
        let state = (
            names,
            self.positions.clone(),
            self.best,
            values,
            self.left_out,
        );
        Ok((restore, state))
    }

    #[staticmethod]
    fn _restore(
        names: Vec<String>,
        positions: Vec<i64>,
        best: Option<i64>,
        values: Vec<Vec<f64>>,
        left_out: usize,
    ) -> Front {
        Front {
            names,
            positions,
            best,
            values,
            left_out,
        }
    }

    fn __len__(&self) -> usize {
        self.positions.len()
    }

    fn _repr_html_(&self) -> String {
        let names = [&["position".to_string()], &self.names[..]].concat();
        html::table(&names, self.positions.len(), |row| {
            let values = self.values[row].iter().map(|x| exact(Language::En, *x));
            let position = self.positions[row].to_string();
            std::iter::once(position).chain(values).collect()
        })
    }

    fn __repr__(&self) -> String {
        let names = self.names.join(", ");
        format!(
            "<gaitcam.Front of {} designs by {names}>",
            self.positions.len()
        )
    }
}

//! Class `Table`: named columns that numpy, pandas, polars and pyarrow can read without copies.

use gaitcam::sweep::{Field, FieldValues, Records, Words};
use gaitcam_base::wording::{Language, exact};
use numpy::ndarray::ArrayView1;
use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict, PyList, PyString};

use crate::convert::{self, Reduced};
use crate::html;

/// Pairs of keys and values of the metadata.
type Pairs = Vec<(String, String)>;

/// Text column as integer codes, and the list of distinct words. A code is an index of this list, or -1 for a missing word.
type Coded<'py> = (Bound<'py, PyAny>, Bound<'py, PyList>);

/// A table with named columns of equal length.
///
/// ``table["force_n"]`` is a column. A numeric column is a read-only numpy array that shares the memory of the table (float64, and uint64 for
/// ``row``). A text column is a list of ``str | None``. A missing number is NaN. Column names end with the unit.
///
/// ``t.to_pandas()`` returns a DataFrame. With pyarrow (``pip install 'gaitcam[arrow]'``), the table exports the Arrow PyCapsule interface.
/// ``pyarrow.table(t)`` and ``polars.DataFrame(t)`` then read numeric columns without copies, and text columns with dictionary encoding.
#[pyclass(frozen, module = "gaitcam")]
pub struct Table {
    records: Records,
    /// Pairs of keys and values that are exported together with the table.
    metadata: Pairs,
}

impl Table {
    /// Table with the columns of `records`, and with metadata.
    pub fn new(records: Records, metadata: Pairs) -> Table {
        Table { records, metadata }
    }

    /// Table of numeric columns without metadata.
    pub fn of_numbers(columns: Vec<(&'static str, Vec<f64>)>) -> Table {
        let fields = columns.into_iter().map(|(n, x)| Field::numbers(n, x));
        let fields = fields.collect();
        Table::new(Records { fields }, Vec::new())
    }

    fn field(&self, name: &str) -> Option<&Field> {
        self.records.fields.iter().find(|f| f.name == name)
    }
}

#[pymethods]
impl Table {
    /// Table(columns): a table from a mapping of column names to arrays of numbers or lists of strings.
    #[new]
    #[pyo3(signature = (columns, metadata = None))]
    fn of_columns(columns: &Bound<'_, PyDict>, metadata: Option<Pairs>) -> PyResult<Table> {
        let py = columns.py();
        let mut fields: Vec<Field> = Vec::new();
        for (name, values) in columns {
            let name: String = name.extract()?;
            let field = read(&name, &values)?;
            if let Some(first) = fields
                .first()
                .filter(|f| f.values.len() != field.values.len())
            {
                let what = format!(
                    "{} rows, and {} of \"{}\"",
                    field.values.len(),
                    first.values.len(),
                    first.name
                );
                return Err(crate::error::argument(py, &name, what));
            }
            fields.push(field);
        }
        Ok(Table::new(Records { fields }, metadata.unwrap_or_default()))
    }

    /// Names of the columns, in their order.
    #[getter]
    fn column_names(&self) -> Vec<&str> {
        let fields = self.records.fields.iter();
        fields.map(|f| f.name.as_str()).collect()
    }

    /// Names of the columns, so that ``dict(table)`` is a dictionary of columns.
    fn keys(&self) -> Vec<&str> {
        self.column_names()
    }

    /// Number of rows of the table.
    #[getter]
    fn num_rows(&self) -> usize {
        self.records.len()
    }

    /// SI unit of each column that has a unit, by column name.
    #[getter]
    fn units(&self) -> std::collections::BTreeMap<&str, &str> {
        let fields = self.records.fields.iter();
        let units = fields.map(|f| (f.name.as_str(), f.unit()));
        units.filter(|u| !u.1.is_empty()).collect()
    }

    /// Metadata of the whole table, such as the fingerprint of a sweep.
    #[getter]
    fn metadata<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.metadata.iter().cloned().into_py_dict(py)
    }

    fn __len__(&self) -> usize {
        self.records.len()
    }

    fn __contains__(&self, name: &str) -> bool {
        self.field(name).is_some()
    }

    fn __getitem__<'py>(this: Bound<'py, Self>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let py = this.py();
        let table = this.get();
        let Some(field) = table.field(name) else {
            let names = table.column_names();
            let near = gaitcam::error::nearest(name, names.iter().copied());
            let near = near.map_or(String::new(), |n| format!("; did you mean \"{n}\"?"));
            return Err(PyKeyError::new_err(format!("no column \"{name}\"{near}")));
        };
        match &field.values {
            FieldValues::Rows(x) => shared(x, this.as_any()),
            FieldValues::Numbers(x) => shared(x, this.as_any()),
            FieldValues::Words(words) => texts(py, words),
        }
    }

    /// Codes and distinct words of a text column; `None` for a numeric column. The code of a missing word is -1.
    fn _coded<'py>(this: Bound<'py, Self>, name: &str) -> PyResult<Option<Coded<'py>>> {
        let field = this.get().field(name);
        let Some(FieldValues::Words(words)) = field.map(|f| &f.values) else {
            return Ok(None);
        };
        let names = PyList::new(this.py(), &words.names)?;
        Ok(Some((shared(&words.codes, this.as_any())?, names)))
    }

    /// Table as a ``pandas.DataFrame``. Text columns are categorical.
    fn to_pandas<'py>(this: Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let module = this.py().import("gaitcam._arrow")?;
        module.call_method1("frame", (this,))
    }

    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        this: Bound<'py, Self>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        arrow(&this)?.call_method1("__arrow_c_stream__", (requested_schema,))
    }

    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_array__<'py>(
        this: Bound<'py, Self>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        arrow(&this)?.call_method1("__arrow_c_array__", (requested_schema,))
    }

    fn __arrow_c_schema__(this: Bound<'_, Self>) -> PyResult<Bound<'_, PyAny>> {
        arrow(&this)?
            .getattr("schema")?
            .call_method0("__arrow_c_schema__")
    }

    fn __reduce__<'py>(this: Bound<'py, Self>) -> Reduced<'py, (Bound<'py, PyDict>, Pairs)> {
        let py = this.py();
        let columns = PyDict::new(py);
        for name in this.get().column_names() {
            columns.set_item(name, Table::__getitem__(this.clone(), name)?)?;
        }
        let metadata = this.get().metadata.clone();
        Ok((this.get_type().into_any(), (columns, metadata)))
    }

    fn _repr_html_(&self) -> String {
        let fields = &self.records.fields;
        let names: Vec<String> = fields.iter().map(|f| f.name.clone()).collect();
        html::table(&names, self.__len__(), |row| {
            let cell = |field: &Field| match &field.values {
                FieldValues::Rows(x) => x[row].to_string(),
                FieldValues::Numbers(x) => exact(Language::En, x[row]),
                FieldValues::Words(words) => words.at(row).unwrap_or("").to_string(),
            };
            fields.iter().map(cell).collect()
        })
    }

    fn __repr__(&self) -> String {
        let names = self.column_names().join(", ");
        format!("<gaitcam.Table of {} rows: {names}>", self.__len__())
    }
}

/// Table as a pyarrow record batch.
fn arrow<'py>(table: &Bound<'py, Table>) -> PyResult<Bound<'py, PyAny>> {
    let module = table.py().import("gaitcam._arrow")?;
    module.call_method1("batch", (table,))
}

/// Read-only numpy array that shares the memory of a column of the table.
fn shared<'py, T: Element>(values: &[T], table: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    // SAFETY: the table is frozen and never moves its columns, and the array keeps it alive.
    let array = unsafe { PyArray1::borrow_from_array(&ArrayView1::from(values), table.clone()) };
    let flags = PyDict::new(table.py());
    flags.set_item("write", false)?;
    array.call_method("setflags", (), Some(&flags))?;
    Ok(array.into_any())
}

fn texts<'py>(py: Python<'py>, words: &Words) -> PyResult<Bound<'py, PyAny>> {
    let names: Vec<Bound<'py, PyAny>> = (words.names.iter())
        .map(|name| PyString::new(py, name).into_any())
        .collect();
    let none = py.None().into_bound(py);
    let word = |code: &i32| usize::try_from(*code).map_or(&none, |c| &names[c]);
    Ok(PyList::new(py, words.codes.iter().map(word))?.into_any())
}

/// Converts the values of a column, which are numbers or strings. Strings may be missing.
fn read(name: &str, values: &Bound<'_, PyAny>) -> PyResult<Field> {
    if name == "row"
        && let Ok(rows) = values.extract::<Vec<u64>>()
    {
        let values = FieldValues::Rows(rows);
        let name = name.to_string();
        return Ok(Field { name, values });
    }
    if let Ok(array) = values.cast::<PyArray1<f64>>() {
        return Ok(Field::numbers(name, array.readonly().as_array().to_vec()));
    }
    if let Ok(words) = values.extract::<Vec<Option<String>>>()
        && (words.iter().any(Option::is_some) || words.is_empty() || all_none(values)?)
    {
        let words = words.iter().map(|w| w.as_deref().unwrap_or(""));
        return Ok(Field::words(name, words));
    }
    let numbers = convert::numbers(values, name)?;
    Ok(Field::numbers(name, numbers.as_array().to_vec()))
}

fn all_none(values: &Bound<'_, PyAny>) -> PyResult<bool> {
    for value in values.try_iter()? {
        if !value?.is_none() {
            return Ok(false);
        }
    }
    Ok(true)
}

//! Conversion of keyword arguments to the options of a design's files.

use gaitcam::error::Placed;
use gaitcam::units::{Dimension, parse};
use gaitcam_app::{Contents, ROWS, Workshop};
use gaitcam_cad::drawing::Title;
use gaitcam_cad::dxf::{Content, Curves};
use gaitcam_output::Language;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert;
use crate::error::{Raise, argument};

/// Minimum number of rows of the tables `law` and `profile`.
const FEWEST_ROWS: usize = 16;

/// Names of the options for the files of a design.
const NAMES: [&str; 8] = [
    "points", "png", "solid", "tool", "wire", "dxf", "cut_only", "lang",
];

/// Converts keyword arguments to the options of the files. `png` is the default of the option `png`.
pub fn contents(
    py: Python<'_>,
    options: Option<&Bound<'_, PyDict>>,
    png: bool,
    title: Title,
) -> PyResult<Contents> {
    let given = convert::options(py, options, &NAMES)?;
    let is = |name: &str| convert::option::<bool>(&given, name);
    let text = |name: &str| convert::option::<String>(&given, name);
    let radius = |name: &str| {
        let value = given.get_item(name)?;
        value.map(|value| length(&value, name)).transpose()
    };
    let points = given.get_item("points")?;
    let points = points.map(|points| convert::whole(&points)).transpose()?;
    Ok(Contents {
        points: rows(py, points.unwrap_or(ROWS))?,
        png: is("png")?.unwrap_or(png),
        language: text("lang")?.map_or(Ok(Language::En), |tag| language(py, &tag))?,
        workshop: Workshop {
            solid: is("solid")?.unwrap_or(false),
            tool: radius("tool")?,
            wire: radius("wire")?,
            curves: text("dxf")?.map_or(Ok(Curves::Arcs), |word| curves(py, &word))?,
            drawn: match is("cut_only")? {
                Some(true) => Content::CutOnly,
                _ => Content::All,
            },
            title,
            ..Workshop::default()
        },
    })
}

/// Checks that the number of rows is at least [`FEWEST_ROWS`].
pub fn rows(py: Python<'_>, points: usize) -> PyResult<usize> {
    if points >= FEWEST_ROWS {
        return Ok(points);
    }
    let what = format!("{points} rows do not show a cam; give at least {FEWEST_ROWS}");
    Err(argument(py, "points", what))
}

/// Kind of curves in `profile.dxf`: "arcs", "splines" or "lines".
fn curves(py: Python<'_>, word: &str) -> PyResult<Curves> {
    match word {
        "arcs" => Ok(Curves::Arcs),
        "splines" => Ok(Curves::Splines),
        "lines" => Ok(Curves::Lines),
        _ => {
            let what =
                format!("{word:?} is no kind of edge; give \"arcs\", \"splines\" or \"lines\"");
            Err(argument(py, "dxf", what))
        }
    }
}

/// Language with the tag `en` or `es`. Any other tag is an error.
pub fn language(py: Python<'_>, tag: &str) -> PyResult<Language> {
    Language::of_tag(tag).ok_or_else(|| {
        argument(
            py,
            "lang",
            format!("{tag:?} is no language; give \"en\" or \"es\""),
        )
    })
}

/// Length in m. The value is a number in m, or a text with a unit.
pub fn length(given: &Bound<'_, PyAny>, name: &str) -> PyResult<f64> {
    if let Ok(text) = given.extract::<String>() {
        let value = parse(&text, Dimension::Length);
        return value.map_err(|e| e.at_key(name)).raise(given.py());
    }
    given.extract()
}

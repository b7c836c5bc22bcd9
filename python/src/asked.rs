//! Options of the files of a design.

use gaitcam::error::Placed;
use gaitcam::units::{Dimension, parse};
use gaitcam_app::{Contents, Workshop};
use gaitcam_cad::drawing::Title;
use gaitcam_cad::dxf::{Content, Curves};
use gaitcam_output::Language;
use pyo3::prelude::*;

use crate::error::{Raise, argument};

/// Minimum number of rows.
const FEWEST_ROWS: usize = 16;

/// Options of the files of a design.
pub struct Asked<'a> {
    /// Number of rows of the tables.
    pub points: usize,
    /// Whether to write pictures as PNG too.
    pub png: bool,
    /// Whether to write solids, arcs and a workbook too.
    pub solid: bool,
    /// Radius of the cutter of a path, m or text with its unit.
    pub tool: Option<&'a Bound<'a, PyAny>>,
    /// Half a wire's diameter plus its spark gap, m or text with its unit.
    pub wire: Option<&'a Bound<'a, PyAny>>,
    /// Edges of profile.dxf: `arcs` or `splines`.
    pub dxf: &'a str,
    /// Whether to write only the layers that are cut.
    pub cut_only: bool,
    /// Language of report and pictures.
    pub lang: &'a str,
}

impl Asked<'_> {
    /// The options as the writers take them.
    pub fn contents(&self, py: Python<'_>, title: Title) -> PyResult<Contents> {
        Ok(Contents {
            points: rows(py, self.points)?,
            png: self.png,
            language: language(py, self.lang)?,
            workshop: Workshop {
                solid: self.solid,
                tool: self.tool.map(|t| length(t, "tool")).transpose()?,
                wire: self.wire.map(|w| length(w, "wire")).transpose()?,
                curves: curves(py, self.dxf)?,
                drawn: match self.cut_only {
                    true => Content::CutOnly,
                    false => Content::All,
                },
                title,
                ..Workshop::default()
            },
        })
    }
}

/// A valid number of rows.
pub fn rows(py: Python<'_>, points: usize) -> PyResult<usize> {
    if points >= FEWEST_ROWS {
        return Ok(points);
    }
    let what = format!("{points} rows do not show a cam; give at least {FEWEST_ROWS}");
    Err(argument(py, "points", what))
}

/// The edges of profile.dxf by their word on the command line.
fn curves(py: Python<'_>, word: &str) -> PyResult<Curves> {
    match word {
        "arcs" => Ok(Curves::Arcs),
        "splines" => Ok(Curves::Splines),
        _ => {
            let what = format!("{word:?} is no kind of edge; give \"arcs\" or \"splines\"");
            Err(argument(py, "dxf", what))
        }
    }
}

/// A language by its tag.
pub fn language(py: Python<'_>, tag: &str) -> PyResult<Language> {
    Language::of_tag(tag).ok_or_else(|| {
        argument(
            py,
            "lang",
            format!("{tag:?} is no language; give \"en\" or \"es\""),
        )
    })
}

/// A length: a number in m, or text with its unit.
pub fn length(given: &Bound<'_, PyAny>, name: &str) -> PyResult<f64> {
    if let Ok(text) = given.extract::<String>() {
        let value = parse(&text, Dimension::Length);
        return value.map_err(|e| e.at_key(name)).raise(given.py());
    }
    given.extract()
}

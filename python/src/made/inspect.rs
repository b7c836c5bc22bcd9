//! Inspection of a manufactured cam by measured points.

use std::path::PathBuf;

use gaitcam::sweep::MadeCam;
use gaitcam_app::measured::{self, Points};
use gaitcam_output::inspection_data;
use numpy::{AllowTypeChange, PyArrayLike2, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::asked::length;
use crate::convert::{self, Argument};
use crate::design::Design;
use crate::error::{Raise, argument};
use crate::table::Table;

/// Fits measured points to the profile of a design and predicts the force of the cam as manufactured.
///
/// Parameters
/// ----------
/// design : Design
/// points : path, or array of shape (n, 2)
///     Measured points in any order, in the coordinates of the measuring machine: a CSV file with the columns x_mm,y_mm
///     or angle_deg,radius_mm (units m, in and rad are also accepted), or an array of x and y in m.
/// ball : float (m) or str ("1 mm"), optional
///     Radius of the probing ball. It is required if the points are the centres of the ball.
///
/// Returns
/// -------
/// Inspection
///     ``summary`` is a dictionary as in ``inspection.json``. ``table`` contains the deviation along the normal,
///     ``deviation_m``, at the cam angle ``theta_rad``. ``line`` is the line of the point in the file, or its row in the array, counted
///     from 1.
///
/// Raises
/// ------
/// InputError
///     The points do not fit this cam, or there are no points.
/// NoSuchCam
///     The design has no cam.
#[pyfunction]
#[pyo3(signature = (design, points, *, ball = None))]
pub fn inspect<'py>(
    py: Python<'py>,
    design: &Bound<'py, PyAny>,
    points: &Bound<'py, PyAny>,
    ball: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let made = Design::given(design, "design")?;
    let cam = made.get().cam(py)?;
    let ball = ball.map(|b| length(b, "ball")).transpose()?.unwrap_or(0.0);
    if !(ball >= 0.0 && ball.is_finite()) {
        let what = format!("{ball} m is not a radius; give 0 or more");
        return Err(argument(py, "ball", what));
    }
    let points = read(points)?;
    let found = py.detach(|| {
        let inspected = cam.cam.inspect(&points.xy, ball)?;
        let made = MadeCam::of(cam, &inspected);
        let json = inspection_data::json(cam, &inspected, made.as_ref(), &points.lines);
        Ok((json, inspection_data::table(&inspected, &points.lines)))
    });
    let (json, records) = found.raise(py)?;
    let class = py.import("gaitcam")?.getattr("Inspection")?;
    class.call1((convert::json(py, &json)?, Table::new(records, Vec::new())))
}

/// Measured points from a file, or from an array of x and y in m.
fn read(given: &Bound<'_, PyAny>) -> PyResult<Points> {
    let py = given.py();
    if let Ok(path) = given.extract::<PathBuf>() {
        return py.detach(|| measured::read(&path)).raise(py);
    }
    let array = convert::array(given, "points")?;
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    let array = match &*kind {
        "f" | "i" | "u" => array
            .extract::<PyArrayLike2<'_, f64, AllowTypeChange>>()
            .ok(),
        _ => None,
    };
    let array = array.filter(|a| a.shape()[1] == 2);
    let finite = array.filter(|a| a.as_array().iter().all(|x| x.is_finite()));
    let Some(array) = finite else {
        let what = "not a file and not an array of finite numbers of shape (n, 2)".to_string();
        return Err(argument(py, "points", what));
    };
    let rows = array.as_array();
    let xy: Vec<[f64; 2]> = rows.rows().into_iter().map(|p| [p[0], p[1]]).collect();
    let lines = (1..=xy.len()).collect();
    Ok(Points { xy, lines })
}

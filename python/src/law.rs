//! Class `Law`: laws of motion as functions of arrays.

use gaitcam::law::{self, Extent, Rise, Segment};
use gaitcam::units::{Dimension, parse};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict, PyString, PyTuple};

use crate::convert::{self, Reduced};
use crate::error::Raise;

/// A law of motion. ``law(theta)`` returns lift, velocity, acceleration and jerk, each with the shape of ``theta``.
///
/// The lift s is in m, or in rad for an oscillating follower. The other results are its exact derivatives with respect to the cam angle:
/// m/rad, m/rad², m/rad³. ``theta`` is in rad, and any number of turns is allowed. A law of the catalogue is normalised: its lift increases
/// from 0 to 1 while ``theta`` increases from 0 to 1.
#[pyclass(frozen, module = "gaitcam")]
pub struct Law {
    name: String,
    law: law::Law,
    factors: Option<law::Factors>,
    origin: Origin,
}

/// Origin of a law. Only the origin is pickled. The law is computed again from it when it is unpickled.
enum Origin {
    /// Law of the catalogue, given by its name.
    Catalogue,
    /// Motion programme. Each segment has the name of its motion, its lift (m) and its angle (rad).
    Program(Vec<(String, f64, f64)>),
    Design(Py<PyAny>),
}

impl Law {
    /// Creates the law of a design. The law is pickled together with the design.
    pub fn of_design(name: &str, law: law::Law, design: Py<PyAny>) -> Law {
        Law {
            name: name.to_string(),
            law,
            factors: None,
            origin: Origin::Design(design),
        }
    }

    fn of_rise(rise: &Rise) -> gaitcam::error::Result<Law> {
        Ok(Law {
            name: rise.written(),
            law: rise.law()?,
            factors: Some(rise.factors()?),
            origin: Origin::Catalogue,
        })
    }
}

/// Evaluates N functions at an array of angles. `of` returns the N values at one angle. The resulting arrays have the shape of `theta`.
pub fn shaped<'py, const N: usize>(
    theta: &Bound<'py, PyAny>,
    mut of: impl FnMut(f64) -> [f64; N],
) -> PyResult<[Bound<'py, PyAny>; N]> {
    let py = theta.py();
    let array = convert::array(theta, "theta")?;
    let shape = array.getattr("shape")?;
    let flat = convert::numbers(&array.call_method0("ravel")?, "theta")?;
    let flat = flat.as_array();
    let mut out: [Vec<f64>; N] = std::array::from_fn(|_| Vec::with_capacity(flat.len()));
    for x in flat {
        if !x.is_finite() {
            let what = format!("{x} is no angle");
            return Err(crate::error::argument(py, "theta", what));
        }
        for (column, value) in out.iter_mut().zip(of(*x)) {
            column.push(value);
        }
    }
    let mut arrays = Vec::with_capacity(N);
    for column in out {
        let column = PyArray1::from_vec(py, column);
        // The empty tuple converts an array without dimensions to a number. Other arrays stay unchanged.
        let column = column.call_method1("reshape", (&shape,))?;
        arrays.push(column.get_item(pyo3::types::PyTuple::empty(py))?);
    }
    arrays
        .try_into()
        .map_err(|_| pyo3::exceptions::PyRuntimeError::new_err("columns"))
}

#[pymethods]
impl Law {
    /// Law of the catalogue, given by its name and its parameters: ``Law("scca 0.25 0.25 0.5")``.
    #[new]
    fn new(py: Python<'_>, name: &str) -> PyResult<Law> {
        let law = || Rise::from_name(name).and_then(|rise| Law::of_rise(&rise));
        py.detach(law).raise(py)
    }

    fn __call__<'py>(&self, theta: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let [s, v, a, j] = shaped(theta, |x| {
            let at = self.law.svaj(x);
            [at.s, at.v, at.a, at.j]
        })?;
        let svaj = theta.py().import("gaitcam")?.getattr("Svaj")?;
        svaj.call1((s, v, a, j))
    }

    /// Name of the law. For a law of the catalogue, the name includes its parameters.
    #[getter]
    fn name(&self) -> &str {
        &self.name
    }

    /// Difference between the maximum and the minimum lift, in the unit of the lift.
    #[getter]
    fn stroke(&self) -> f64 {
        self.law.stroke()
    }

    /// First cam angle of the law, and the length of its range of angles, rad.
    #[getter]
    fn extent(&self) -> (f64, f64) {
        self.law.extent()
    }

    /// Whether the law repeats after its range of angles.
    #[getter]
    fn closed(&self) -> bool {
        self.law.is_closed()
    }

    /// Cam angles at which the spans of the law begin and end, rad; shape (spans + 1,).
    #[getter]
    fn breaks<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.law.breaks())
    }

    /// Minimum and maximum of lift (0), velocity (1), acceleration (2) or jerk (3), each with its cam angle in rad. The result is
    /// ``((least, at), (most, at))``. The extrema are computed from the continuous law and not from samples.
    fn extremes(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = convert::whole)] order: usize,
    ) -> PyResult<((f64, f64), (f64, f64))> {
        if order > 3 {
            let what = format!("{order} is no derivative of a law; give 0, 1, 2 or 3");
            return Err(crate::error::argument(py, "order", what));
        }
        let (low, high) = py.detach(|| self.law.extremes(order));
        Ok(((low.value, low.at), (high.value, high.at)))
    }

    /// Peak factors of a law of the catalogue: velocity ``cv``, acceleration ``ca``, jerk ``cj``, torque ``ct``. ``None`` for other laws.
    #[getter]
    fn factors<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let named = |f: &law::Factors| [("cv", f.cv), ("ca", f.ca), ("cj", f.cj), ("ct", f.ct)];
        let factors = self.factors.as_ref().map(named);
        factors.map(|all| all.into_py_dict(py)).transpose()
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, Bound<'py, PyTuple>> {
        let gaitcam = py.import("gaitcam")?;
        Ok(match &self.origin {
            Origin::Catalogue => (gaitcam.getattr("Law")?, (&self.name,).into_pyobject(py)?),
            Origin::Program(segments) => {
                let segments = segments.clone().into_pyobject(py)?;
                (gaitcam.getattr("program")?, (segments,).into_pyobject(py)?)
            }
            Origin::Design(design) => {
                let get = py.import("builtins")?.getattr("getattr")?;
                (get, (design, "motion").into_pyobject(py)?)
            }
        })
    }

    fn __repr__(&self) -> String {
        format!("<gaitcam.Law {:?}>", self.name)
    }
}

/// Catalogue of rise laws: a dictionary that maps names to normalised laws.
#[pyfunction]
pub fn laws(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let out = PyDict::new(py);
    for rise in Rise::catalogue() {
        out.set_item(rise.name(), Law::of_rise(&rise).raise(py)?)?;
    }
    Ok(out)
}

/// Law that consists of segments over one turn: ``program([("cycloidal", "20 mm", "120 deg"), ("dwell", 0, "60 deg"), ...])``.
///
/// Each segment is a motion of the catalogue with its lift (negative for a fall) and its angle. Numbers are in m and rad. Texts have a
/// unit.
#[pyfunction]
pub fn program(
    py: Python<'_>,
    segments: Vec<(String, Bound<'_, PyAny>, Bound<'_, PyAny>)>,
) -> PyResult<Law> {
    let mut all = Vec::with_capacity(segments.len());
    for (i, (motion, lift, angle)) in segments.iter().enumerate() {
        all.push(Segment {
            motion: Rise::from_name(motion).raise(py)?,
            lift: quantity(lift, Dimension::Length, &format!("segment.{}.lift", i + 1))?,
            angle: quantity(angle, Dimension::Angle, &format!("segment.{}.angle", i + 1))?,
        });
    }
    let law = py.detach(|| law::program(&all, Extent::TURN)).raise(py)?;
    let segment =
        |(s, (motion, ..)): (&Segment, &(String, _, _))| (motion.clone(), s.lift, s.angle);
    Ok(Law {
        name: "program".to_string(),
        law,
        factors: None,
        origin: Origin::Program(all.iter().zip(&segments).map(segment).collect()),
    })
}

fn quantity(given: &Bound<'_, PyAny>, dimension: Dimension, key: &str) -> PyResult<f64> {
    if let Ok(text) = given.cast::<PyString>() {
        let value = parse(&text.to_string(), dimension);
        let place = || gaitcam::error::Place::Key(key.to_string());
        return value.map_err(|e| e.at(place())).raise(given.py());
    }
    given.extract()
}

//! Laws that the user brings: a table or the control points of a B-spline.

use super::super::{Condition, Law, hermite_birkhoff};
use super::Rise;
use crate::error::{Error, Result};
use crate::poly::{PiecewisePoly, SplineSpace};
use nalgebra::{DMatrix, DVector};

/// Degree of the spline through a table: continuous to the fourth derivative.
const TABLE_DEGREE: usize = 5;

impl Rise {
    /// A law through a table of (x, s), at least two rows, x increasing: a spline of degree 5, at rest
    /// (v = a = 0) at both ends if asked, otherwise as smooth at the ends as inside (not-a-knot).
    ///
    /// The table is normalised: its first row becomes (0, 0), its last (1, 1).
    pub fn table(name: &str, rows: &[(f64, f64)], rest: bool) -> Result<Rise> {
        let fault = |what: String| Error::new(format!("table {name}: {what}"));
        if rows.len() < 2 {
            return Err(fault(format!("{} rows are too few", rows.len()))
                .help("give at least two rows of x and s"));
        }
        if let Some(i) = rows
            .iter()
            .position(|r| !r.0.is_finite() || !r.1.is_finite())
        {
            return Err(fault(format!("row {} is not a finite number", i + 1)));
        }
        if let Some(i) = rows.windows(2).position(|w| w[1].0 <= w[0].0) {
            return Err(fault(format!(
                "row {} has x = {} after {}",
                i + 2,
                rows[i + 1].0,
                rows[i].0
            ))
            .help("x must increase from row to row"));
        }
        let (first, last) = (rows[0], rows[rows.len() - 1]);
        let lift = last.1 - first.1;
        if lift == 0.0 {
            return Err(
                fault("it ends at the lift it starts from".to_string()).help(
                    "a motion leads from one lift to another: split the table at its highest point",
                ),
            );
        }
        let points: Vec<(f64, f64)> = rows
            .iter()
            .map(|r| ((r.0 - first.0) / (last.0 - first.0), (r.1 - first.1) / lift))
            .collect();
        let poly = through(&points, rest)
            .map_err(|e| fault(e.what()).help(e.cure().unwrap_or_default()))?;
        Ok(Rise::User {
            name: name.to_string(),
            law: Law::from_poly(poly, false),
        })
    }

    /// A law from the control points of a clamped B-spline with equal spans; at least degree + 1 points.
    /// Normalised so that it leads from 0 (first point) to 1 (last point). Three equal points at an end
    /// put it at rest there (v = a = 0).
    pub fn spline(name: &str, degree: usize, control: &[f64]) -> Result<Rise> {
        let fault = |what: String| Error::new(format!("spline {name}: {what}"));
        let n = control.len();
        if degree == 0 || degree > 15 {
            return Err(fault(format!("degree {degree} is out of range")).help("use 3 to 7"));
        }
        if n <= degree {
            return Err(fault(format!(
                "{n} control points are too few for degree {degree}"
            ))
            .help(format!("give at least {}", degree + 1)));
        }
        let lift = control[n - 1] - control[0];
        if control.iter().any(|c| !c.is_finite()) || lift == 0.0 {
            return Err(
                fault("it does not lead from one lift to another".to_string())
                    .help("first and last control point must be finite and differ"),
            );
        }
        let spans = n - degree;
        let breaks: Vec<f64> = (0..=spans).map(|i| i as f64 / spans as f64).collect();
        let space = SplineSpace::clamped(degree, &breaks, &vec![1; spans - 1]);
        let c: Vec<f64> = control.iter().map(|x| (x - control[0]) / lift).collect();
        Ok(Rise::User {
            name: name.to_string(),
            law: Law::from_poly(space.spline(&c), false),
        })
    }
}

/// Spline of degree 5 through points with x from 0 to 1.
fn through(points: &[(f64, f64)], rest: bool) -> Result<PiecewisePoly> {
    let n = points.len();
    let end_conditions: Vec<(f64, usize)> = if rest {
        vec![(0.0, 1), (0.0, 2), (1.0, 1), (1.0, 2)]
    } else {
        Vec::new()
    };
    let unknowns = n + end_conditions.len();
    if unknowns <= TABLE_DEGREE + 1 {
        let mut conditions: Vec<Condition> = points
            .iter()
            .map(|&(theta, value)| Condition {
                theta,
                order: 0,
                value,
            })
            .collect();
        conditions.extend(end_conditions.iter().map(|&(theta, order)| Condition {
            theta,
            order,
            value: 0.0,
        }));
        return hermite_birkhoff(&conditions, 0.0, 1.0);
    }
    // Not-a-knot: two inner points next to each end carry no knot, which saves the four conditions.
    let inner = if rest {
        &points[1..n - 1]
    } else {
        &points[3..n - 3]
    };
    let mut breaks = vec![0.0];
    breaks.extend(inner.iter().map(|p| p.0));
    breaks.push(1.0);
    let space = SplineSpace::clamped(TABLE_DEGREE, &breaks, &vec![1; inner.len()]);
    let mut matrix = DMatrix::zeros(unknowns, unknowns);
    let mut wanted = DVector::zeros(unknowns);
    let rows = points
        .iter()
        .map(|&(x, s)| (x, 0, s))
        .chain(end_conditions.iter().map(|&(x, order)| (x, order, 0.0)));
    for (row, (x, order, value)) in rows.enumerate() {
        let (span, u) = space.locate(x);
        let mut weights = [0.0; 3];
        weights[order] = 1.0;
        for (i, w) in space.row(span, u, &weights).iter().enumerate() {
            matrix[(row, space.index(span, i))] += w;
        }
        wanted[row] = value;
    }
    let c = matrix.lu().solve(&wanted).ok_or_else(|| {
        Error::new("its rows lie so that no spline passes through them")
            .help("space them more evenly")
    })?;
    Ok(space.spline(c.as_slice()))
}

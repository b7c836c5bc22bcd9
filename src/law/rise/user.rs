//! Laws that the user brings: a table or the control points of a B-spline.

use super::super::{Condition, Law, hermite_birkhoff};
use super::Rise;
use crate::error::{LawError, Result};
use crate::poly::{PiecewisePoly, SplineSpace};
use nalgebra::{DMatrix, DVector};

/// Degree of the spline through a table: continuous to the fourth derivative.
const TABLE_DEGREE: usize = 5;

/// Degree of a B-spline whose control points stand in a scene.
const SPLINE_DEGREE: usize = 5;

impl Rise {
    /// The law of `table` or `spline` with its numbers, as a scene has them; `None` for another word.
    pub(super) fn own(word: &str, numbers: &[f64]) -> Option<Result<Rise>> {
        match word {
            "table" => {
                let rows: Vec<(f64, f64)> =
                    numbers.chunks(2).map(|p| (p[0], p[p.len() - 1])).collect();
                if numbers.len() % 2 == 1 {
                    let numbers = numbers.len();
                    return Some(Err(LawError::TablePairs { numbers }.into()));
                }
                Some(Rise::table(word, &rows, true))
            }
            "spline" => Some(Rise::spline(word, SPLINE_DEGREE, numbers)),
            _ => None,
        }
    }

    /// A law through a table of (x, s), at least two rows, x increasing: a spline of degree 5, at rest
    /// (v = a = 0) at both ends if asked, otherwise as smooth at the ends as inside (not-a-knot).
    ///
    /// The table is normalised: its first row becomes (0, 0), its last (1, 1).
    ///
    /// # Errors
    /// Too few rows, numbers that are not finite, x that does not increase, a table that ends at its first lift.
    pub fn table(name: &str, rows: &[(f64, f64)], rest: bool) -> Result<Rise> {
        let table = name.to_string();
        if rows.len() < 2 {
            let rows = rows.len();
            return Err(LawError::TableRows { table, rows }.into());
        }
        if let Some(i) = rows
            .iter()
            .position(|r| !r.0.is_finite() || !r.1.is_finite())
        {
            return Err(LawError::TableNotFinite { table, row: i + 1 }.into());
        }
        if let Some(i) = rows.windows(2).position(|w| w[1].0 <= w[0].0) {
            let (x, before) = (rows[i + 1].0, rows[i].0);
            return Err(LawError::TableOrder {
                table,
                row: i + 2,
                x,
                before,
            }
            .into());
        }
        let (first, last) = (rows[0], rows[rows.len() - 1]);
        let lift = last.1 - first.1;
        if lift == 0.0 {
            return Err(LawError::TableLevel { table }.into());
        }
        let points: Vec<(f64, f64)> = rows
            .iter()
            .map(|r| ((r.0 - first.0) / (last.0 - first.0), (r.1 - first.1) / lift))
            .collect();
        let poly = through(&points, rest).ok_or(LawError::TableSpacing { table })?;
        let numbers = rows.iter().flat_map(|r| [r.0, r.1]);
        Ok(Rise::User {
            name: name.to_string(),
            written: written("table", numbers),
            law: Box::new(Law::from_poly(poly, false)),
        })
    }

    /// A law from the control points of a clamped B-spline with equal spans; at least degree + 1 points.
    /// Normalised so that it leads from 0 (first point) to 1 (last point). Three equal points at an end
    /// put it at rest there (v = a = 0).
    ///
    /// # Errors
    /// A degree outside 1 … 15, too few points, or points that do not lead from one lift to another.
    pub fn spline(name: &str, degree: usize, control: &[f64]) -> Result<Rise> {
        let spline = name.to_string();
        let n = control.len();
        if degree == 0 || degree > 15 {
            return Err(LawError::SplineDegree { spline, degree }.into());
        }
        if n <= degree {
            return Err(LawError::SplinePoints {
                spline,
                points: n,
                degree,
                least: degree + 1,
            }
            .into());
        }
        let lift = control[n - 1] - control[0];
        if control.iter().any(|c| !c.is_finite()) || lift == 0.0 {
            return Err(LawError::SplineLevel { spline }.into());
        }
        let spans = n - degree;
        let breaks: Vec<f64> = (0..=spans).map(|i| i as f64 / spans as f64).collect();
        let space = SplineSpace::clamped(degree, &breaks, &vec![1; spans - 1]);
        let c: Vec<f64> = control.iter().map(|x| (x - control[0]) / lift).collect();
        Ok(Rise::User {
            name: name.to_string(),
            written: written("spline", control.iter().copied()),
            law: Box::new(Law::from_poly(space.spline(&c), false)),
        })
    }
}

/// A word with its numbers.
fn written(word: &str, numbers: impl Iterator<Item = f64>) -> String {
    numbers.fold(word.to_string(), |text, x| format!("{text} {x}"))
}

/// Spline of degree 5 through points with x from 0 to 1; `None` where their spacing admits none.
fn through(points: &[(f64, f64)], rest: bool) -> Option<PiecewisePoly> {
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
        return hermite_birkhoff(&conditions, 0.0, 1.0).ok();
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
    let c = matrix.lu().solve(&wanted)?;
    Some(space.spline(c.as_slice()))
}

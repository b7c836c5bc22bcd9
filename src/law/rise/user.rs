//! Motions that the user defines as a table.

use std::f64::consts::PI;

use super::super::{Condition, Law, hermite_birkhoff};
use super::Rise;
use crate::error::{LawError, Result};
use crate::poly::{PiecewisePoly, SplineSpace};

/// Degree of the spline through a table. The spline is continuous up to the fourth derivative.
const TABLE_DEGREE: usize = 5;

/// Maximum assumed rounding error, relative to the lift. The limit is necessary because lifts in whole numbers may be exact.
const MOST_ROUNDING: f64 = 1e-3;

impl Rise {
    /// File name in a motion such as `table lift.csv`; `None` if the word `table` is followed by numbers or by nothing.
    pub(crate) fn named_file(text: &str) -> Option<&str> {
        let apart = |c: char| c.is_whitespace() || c == ',';
        let (word, file) = text.trim().split_once(apart)?;
        let file = file.trim();
        let first = file.split(apart).find(|w| !w.is_empty())?;
        let is_named = word.eq_ignore_ascii_case("table") && first.parse::<f64>().is_err();
        is_named.then_some(file)
    }

    /// Motion through the points that follow the word `table`: pairs of x and s.
    pub(super) fn of_numbers(numbers: &[f64]) -> Result<Rise> {
        if !numbers.len().is_multiple_of(2) {
            let numbers = numbers.len();
            return Err(LawError::TablePairs { numbers }.into());
        }
        let rows: Vec<(f64, f64)> = numbers.chunks_exact(2).map(|p| (p[0], p[1])).collect();
        Rise::table("table", &rows, true)
    }

    /// Motion through a table of (x, s) with at least two rows and increasing x. It is a spline of degree 5. If `rest` is true, it is at rest (v = a
    /// = 0) at both ends. Otherwise its end conditions are not-a-knot.
    ///
    /// The table is normalised: the first row becomes (0, 0), and the last row becomes (1, 1). In a programme, the lift may be below the base circle
    /// by half a unit of the last decimal.
    ///
    /// # Errors
    ///
    /// - The table has too few rows.
    /// - A number is not finite.
    /// - The x values do not increase.
    /// - The last lift equals the first lift.
    /// - The spacing of the x values does not permit a spline.
    pub fn table(name: &str, rows: &[(f64, f64)], rest: bool) -> Result<Rise> {
        let table = name.to_string();
        if rows.len() < 2 {
            let rows = rows.len();
            return Err(LawError::TableRows { table, rows }.into());
        }
        let is_infinite = |r: &(f64, f64)| !r.0.is_finite() || !r.1.is_finite();
        if let Some(i) = rows.iter().position(is_infinite) {
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
            rows: points,
            rounding: (half_unit(rows) / lift.abs()).min(MOST_ROUNDING),
        })
    }

    /// Error of the lift caused by the rounding of the rows, relative to the lift; 0 for motions without rows.
    pub(in crate::law) fn rounding(&self) -> f64 {
        match self {
            Rise::User { rounding, .. } => *rounding,
            _ => 0.0,
        }
    }

    /// Acceleration that the rounding of the rows can add to a normalised rise. It is the peak acceleration of a wave. The amplitude of the
    /// wave is the rounding error, and its half wavelength is the minimum step of x. 0 for motions without rows.
    pub(crate) fn rounded_acceleration(&self) -> f64 {
        let Rise::User { rows, rounding, .. } = self else {
            return 0.0;
        };
        let steps = rows.windows(2).map(|w| w[1].0 - w[0].0);
        let step = steps.fold(f64::INFINITY, f64::min);
        rounding * (PI / step).powi(2)
    }

    /// Number, from 1, of the last row before x, and the lifts of this row and the next one. `None` for motions without rows.
    pub(in crate::law) fn row_before(&self, x: f64) -> Option<(usize, [f64; 2])> {
        let Rise::User { rows, .. } = self else {
            return None;
        };
        let next = rows.partition_point(|row| row.0 <= x);
        let next = next.clamp(1, rows.len() - 1);
        Some((next, [rows[next - 1].1, rows[next].1]))
    }
}

/// Half a unit of the last decimal of the lifts of a table.
fn half_unit(rows: &[(f64, f64)]) -> f64 {
    let decimals = |s: f64| {
        let text = format!("{s}");
        text.split_once('.').map_or(0, |(_, part)| part.len())
    };
    let most = rows.iter().map(|row| decimals(row.1)).max().unwrap_or(0);
    0.5 * 0.1_f64.powi(most as i32)
}

/// Text of a motion in a scene: a word and numbers, separated by spaces.
fn written(word: &str, numbers: impl Iterator<Item = f64>) -> String {
    numbers.fold(word.to_string(), |text, x| format!("{text} {x}"))
}

/// Spline of degree 5 through points with x from 0 to 1; `None` if the spacing of the points does not permit such a spline.
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
    // Not-a-knot: the two inner points next to each end are not knots. Four end conditions are therefore unnecessary.
    let inner = if rest {
        &points[1..n - 1]
    } else {
        &points[3..n - 3]
    };
    let mut breaks = vec![0.0];
    breaks.extend(inner.iter().map(|p| p.0));
    breaks.push(1.0);
    let space = SplineSpace::clamped(TABLE_DEGREE, &breaks, &vec![1; inner.len()]);
    // The equations are in the order of their positions. The matrix is banded and totally positive, so elimination needs no pivots.
    let end = |at: f64| end_conditions.iter().filter(move |c| c.0 == at);
    let lift = |p: &(f64, f64)| (p.0, 0, p.1);
    let rows = points[..1]
        .iter()
        .map(lift)
        .chain(end(0.0).map(|&(x, order)| (x, order, 0.0)))
        .chain(points[1..n - 1].iter().map(lift))
        .chain(end(1.0).rev().map(|&(x, order)| (x, order, 0.0)))
        .chain(points[n - 1..].iter().map(lift));
    let rows = rows.map(|(x, order, value)| {
        let (span, u) = space.locate(x);
        let mut weights = [0.0; 3];
        weights[order] = 1.0;
        let mut row = [0.0; TABLE_DEGREE + 1];
        row.copy_from_slice(&space.row(span, u, &weights));
        (space.index(span, 0), row, value)
    });
    let c = solve_band(rows.collect())?;
    Some(space.spline(&c))
}

/// One equation: index of its first unknown, coefficients from this unknown on, and right-hand side.
type BandRow = (usize, [f64; TABLE_DEGREE + 1], f64);

/// Solves banded equations by elimination without pivoting. There is one equation for each unknown, in ascending order. `None` if a pivot is zero.
fn solve_band(mut rows: Vec<BandRow>) -> Option<Vec<f64>> {
    const WIDTH: usize = TABLE_DEGREE + 1;
    let n = rows.len();
    for k in 0..n {
        let (first, row, right) = rows[k];
        let pivot = *k.checked_sub(first).and_then(|i| row.get(i))?;
        if !(pivot.is_finite() && pivot != 0.0) {
            return None;
        }
        for (start, below, other) in rows[k + 1..].iter_mut().take_while(|r| r.0 <= k) {
            let factor = below[k - *start] / pivot;
            for column in k..first + WIDTH {
                below[column - *start] -= factor * row[column - first];
            }
            *other -= factor * right;
        }
    }
    let mut solution = vec![0.0; n];
    for k in (0..n).rev() {
        let (first, row, right) = rows[k];
        let known: f64 = (k + 1..n.min(first + WIDTH))
            .map(|column| row[column - first] * solution[column])
            .sum();
        solution[k] = (right - known) / row[k - first];
    }
    Some(solution)
}

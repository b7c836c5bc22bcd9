//! Table of positions as CSV, one point per line.

use std::fmt::Write;

use super::literal::literal;
use super::replay::Curve;
use super::table::Table;

pub fn write(table: &Table) -> String {
    let (x, y) = (table.x_unit, table.y_unit);
    let mut out = format!("# {}\nmaster_{x},slave_{y}\n", table.head());
    for node in table.nodes() {
        let _ = writeln!(out, "{},{}", literal(node.x), literal(node.y));
    }
    out
}

pub fn read(text: &str) -> Option<Curve> {
    let points = rows::<2>(text)?;
    Some(Curve::Points {
        points,
        slopes: None,
    })
}

/// Reads the rows of numbers below the comment line and the heading. `None` if a cell is not a number or a row does not have N cells.
pub fn rows<const N: usize>(text: &str) -> Option<Vec<[f64; N]>> {
    let row = |line: &str| {
        let cells: Option<Vec<f64>> = line.split(',').map(|c| c.parse().ok()).collect();
        cells?.try_into().ok()
    };
    text.lines().skip(2).map(row).collect()
}

//! Table of polynomial segments with lift, velocity and acceleration at both ends.
//!
//! The columns agree with the cam editors of SEW and Siemens (SEW, MOVIRUN CAM editor: X1, Y1, Y′, Y″ … X2, Y2, Y2′, Y2″).

use std::fmt::Write;

use super::literal::literal;
use super::replay::Curve;
use super::table::{Node, Table};

pub fn write(table: &Table) -> String {
    let (x, y) = (table.x_unit, table.y_unit);
    let heads = [1, 2].map(|k| format!("x{k}_{x},y{k}_{y},v{k}_{y}_per_{x},a{k}_{y}_per_{x}2"));
    let mut out = format!("# {}\n{}\n", table.head(), heads.join(","));
    for ends in &table.segments {
        let numbers = ends.iter().flat_map(|n| [n.x, n.y, n.v, n.a]).map(literal);
        let _ = writeln!(out, "{}", numbers.collect::<Vec<_>>().join(","));
    }
    out
}

pub fn read(text: &str) -> Option<Curve> {
    let node = |n: &[f64]| Node {
        x: n[0],
        y: n[1],
        v: n[2],
        a: n[3],
    };
    let rows = super::csv::rows::<8>(text)?;
    Some(Curve::Segments(
        rows.iter()
            .map(|r| [node(&r[..4]), node(&r[4..])])
            .collect(),
    ))
}

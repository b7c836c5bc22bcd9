//! Drawing of a table in blocks side by side.

use super::layout::Layout;
use super::pen::{Anchor, Pen, Stroke};

/// Letter height of the table, mm per em.
const LETTERS: f64 = 2.7;
const ROW: f64 = 3.4;
const LINE: f64 = 4.2;

/// Table of text cells. Every row has one cell per column.
pub struct Table {
    /// Heading of the table, one or two lines.
    pub heading: Vec<String>,
    /// Symbol and unit of each column.
    pub columns: Vec<String>,
    /// Cells of the table, row by row.
    pub rows: Vec<Vec<String>>,
}

/// Right ends of the columns of a block, as fractions of the block's width. The first entry is 0, the left end.
fn stops(columns: usize) -> Vec<f64> {
    let first = if columns > 2 { 0.26 } else { 0.42 };
    let step = (1.0 - first) / (columns - 1) as f64;
    let rest = (0..columns).map(|i| first + step * i as f64);
    [0.0].into_iter().chain(rest).collect()
}

/// Draws the table. Its rows are distributed over the blocks of the layout. A table with two columns has twice as many blocks as the
/// layout.
pub fn draw(pen: &mut Pen, table: &Table, layout: &Layout) {
    let area = layout.table;
    for (i, line) in table.heading.iter().enumerate() {
        let y = area.top - 3.6 - LINE * i as f64;
        let room = area.right - area.left - 4.0;
        pen.text_within(line, [area.left + 2.0, y], LETTERS, room);
    }
    let stops = stops(table.columns.len());
    let blocks = match table.columns.len() {
        2 => 2 * layout.blocks,
        _ => layout.blocks,
    };
    let top = area.top - 3.6 - LINE - 2.4;
    let high = table.rows.len().div_ceil(blocks).max(1);
    let width = (area.right - area.left) / blocks as f64;
    for (k, block) in table.rows.chunks(high).enumerate() {
        let left = area.left + width * k as f64;
        let write = |pen: &mut Pen, cells: &[String], y: f64| {
            for (cell, stop) in cells.iter().zip(&stops[1..]) {
                pen.text(cell, [left + width * stop - 2.0, y], LETTERS, Anchor::End);
            }
        };
        write(pen, &table.columns, top - LINE + 1.2);
        for (i, row) in block.iter().enumerate() {
            let y = top - LINE - ROW * (i + 1) as f64 + 0.8;
            write(pen, row, y);
        }
        let bottom = top - LINE - ROW * high as f64 - 0.4;
        pen.frame([left, bottom], [left + width, top], Stroke::Thin);
        let under = top - LINE;
        pen.line(&[[left, under], [left + width, under]], Stroke::Thin);
        for stop in &stops[1..stops.len() - 1] {
            let x = left + width * stop;
            pen.line(&[[x, bottom], [x, top]], Stroke::Thin);
        }
    }
}

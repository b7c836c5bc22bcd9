//! The table of radii on the sheet.

use super::layout::Layout;
use super::pen::{Anchor, Pen, Stroke};
use super::radii::Radius;
use crate::words::Words;

/// Letters, height of a row and of the lines of the heading, mm.
const LETTERS: f64 = 2.7;
const ROW: f64 = 3.4;
const LINE: f64 = 4.2;
/// Where the columns of a block end, as parts of its width.
const COLUMNS: [f64; 4] = [0.0, 0.26, 0.63, 1.0];

/// Writes the rows, dealt to the blocks of the layout one after the other, for a ball of radius `ball` m.
pub fn draw(pen: &mut Pen, rows: &[Radius], ball: f64, layout: &Layout, words: &Words) {
    let area = layout.table;
    let ball = words.decimal(format!("{:.3}", 1e3 * ball));
    let heading = [
        words.text("drawing-radii"),
        words.fill("drawing-radii-ball", &[("radius", &ball)]),
    ];
    for (i, line) in heading.iter().enumerate() {
        let y = area.top - 3.6 - LINE * i as f64;
        pen.text_within(
            line,
            [area.left + 2.0, y],
            LETTERS,
            area.right - area.left - 4.0,
        );
    }
    let top = area.top - 3.6 - LINE - 2.4;
    let high = rows.len().div_ceil(layout.blocks);
    let width = (area.right - area.left) / layout.blocks as f64;
    for (k, block) in rows.chunks(high).enumerate() {
        let left = area.left + width * k as f64;
        let column = |i: usize| left + width * COLUMNS[i];
        let write = |pen: &mut Pen, cells: [&str; 3], y: f64| {
            for (i, cell) in cells.into_iter().enumerate() {
                pen.text(cell, [column(i + 1) - 2.0, y], LETTERS, Anchor::End);
            }
        };
        write(pen, ["φ, °", "r, mm", "b, mm"], top - LINE + 1.2);
        for (i, row) in block.iter().enumerate() {
            let cells = [
                words.decimal(format!("{:.0}", row.angle.to_degrees())),
                words.decimal(format!("{:.3}", 1e3 * row.profile)),
                words.decimal(format!("{:.3}", 1e3 * row.ball)),
            ];
            let y = top - LINE - ROW * (i + 1) as f64 + 0.8;
            write(pen, [&cells[0], &cells[1], &cells[2]], y);
        }
        let bottom = top - LINE - ROW * high as f64 - 0.4;
        pen.frame([left, bottom], [left + width, top], Stroke::Thin);
        let under = top - LINE;
        pen.line(&[[left, under], [left + width, under]], Stroke::Thin);
        for i in [1, 2] {
            pen.line(&[[column(i), bottom], [column(i), top]], Stroke::Thin);
        }
    }
}

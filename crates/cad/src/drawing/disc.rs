//! Drawing sheet of a rotating cam: plan view, side view and table of radii.

use super::BALL;
use super::layout::{ABOVE, BELOW, BESIDE, LABELS, Layout};
use super::pen::Pen;
use super::piece::Piece;
use super::radii::{Radius, radii};
use super::table::Table;
use super::views::Views;
use crate::words::Labels;

/// Number of rows of the table of radii: one per 5°.
const ROWS: usize = 72;

impl Piece<'_> {
    /// Smallest suitable sheet format for the cam, with the scale and the areas of the sheet.
    pub fn layout(&self) -> Layout {
        let (radius, width) = (1e3 * self.radius(), 1e3 * self.thickness);
        Layout::fitting(|scale| {
            [
                2.0 * scale * radius + 2.0 * LABELS + scale * width + BESIDE,
                2.0 * scale * radius + ABOVE + BELOW,
            ]
        })
    }

    /// Draws the plan view and the side view. Returns the table of radii.
    pub fn draw(&self, pen: &mut Pen, layout: &Layout, words: &Labels) -> Table {
        Views::new(self, layout, words).draw(pen);
        let ball = words.length(BALL, 3);
        let row = |row: &Radius| {
            let angle = format!("{:.0}", row.angle.to_degrees());
            vec![
                angle,
                words.length(row.profile, 3),
                words.length(row.ball, 3),
            ]
        };
        Table {
            heading: vec![
                words.text("drawing-radii"),
                words.fill(
                    "drawing-radii-ball",
                    &[("radius", &ball), ("unit", words.units().name())],
                ),
            ],
            columns: vec!["φ, °".to_string(), words.column("r"), words.column("b")],
            rows: radii(&self.edge, BALL, ROWS).iter().map(row).collect(),
        }
    }
}

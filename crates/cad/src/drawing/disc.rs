//! The sheet of one cam that turns: plan and side view, radii.

use gaitcam::cam::{Bore, Cam, Hole, Hub};
use gaitcam::synth::Design;

use super::BALL;
use super::layout::{ABOVE, BELOW, BESIDE, LABELS, Layout};
use super::pen::Pen;
use super::radii::{farthest, radii};
use super::table::Table;
use super::views::{UNDER_HUB, Views};
use crate::outline::Edge;
use crate::words::Words;

/// Rows of the table: one every 5°.
const ROWS: usize = 72;

/// One cam to be made.
pub struct Piece<'a> {
    pub cam: &'a Cam,
    pub edge: Edge<'a>,
    /// Key of its name where there are two.
    pub name: Option<&'static str>,
    pub bore: Option<Bore>,
    /// The hole that balances it.
    pub balance: Option<Hole>,
    pub hub: Option<Hub>,
    pub thickness: f64,
    pub clockwise: bool,
}

impl<'a> Piece<'a> {
    /// The cams of a design that turn.
    pub fn all(design: &'a Design) -> Vec<Self> {
        let names = match design.conjugate {
            Some(_) => [Some("drawing-first"), Some("drawing-second")],
            None => [None, None],
        };
        let second = design.conjugate.as_ref().map(|pair| &pair.second);
        let cams: Vec<&Cam> = [&design.cam].into_iter().chain(second).collect();
        let last = cams.len() - 1;
        let edges = Edge::all(design).into_iter().zip(names);
        (cams.iter().zip(edges).zip(design.balance_holes()))
            .enumerate()
            .map(|(k, ((cam, (edge, name)), balance))| Piece {
                cam,
                edge,
                name,
                bore: design.bore,
                balance,
                // The hub of a pair stands on its upper cam.
                hub: design.making.hub.filter(|_| k == last),
                thickness: design.thickness,
                clockwise: design.drive.speed < 0.0,
            })
            .collect()
    }

    pub fn base(&self) -> f64 {
        self.cam.follower.base_radius()
    }

    pub fn prime(&self) -> f64 {
        self.cam.follower.prime_radius()
    }

    /// Radius of the circle about the centre that holds everything drawn, m.
    pub fn radius(&self) -> f64 {
        let [x, y] = farthest(&self.edge, 1440).p;
        x.hypot(y).max(self.prime())
    }

    /// Length along the shaft, m.
    pub fn width(&self) -> f64 {
        self.thickness + self.hub.map_or(0.0, |hub| hub.length)
    }

    /// Its sheet.
    pub fn layout(&self) -> Layout {
        let (radius, width) = (1e3 * self.radius(), 1e3 * self.width());
        Layout::fitting(|scale| {
            [
                2.0 * scale * radius + 2.0 * LABELS + scale * width + BESIDE,
                2.0 * scale * radius + ABOVE + BELOW.max(self.hub.map_or(0.0, |_| UNDER_HUB + 4.0)),
            ]
        })
    }

    /// Draws the views; returns the table of radii.
    pub fn draw(&self, pen: &mut Pen, layout: &Layout, words: &Words) -> Table {
        Views::new(self, layout, words).draw(pen);
        let ball = words.decimal(format!("{:.3}", 1e3 * BALL));
        let row = |row: &super::radii::Radius| {
            let mm = |x: f64| words.decimal(format!("{:.3}", 1e3 * x));
            let angle = words.decimal(format!("{:.0}", row.angle.to_degrees()));
            vec![angle, mm(row.profile), mm(row.ball)]
        };
        Table {
            heading: vec![
                words.text("drawing-radii"),
                words.fill("drawing-radii-ball", &[("radius", &ball)]),
            ],
            columns: vec!["φ, °", "r, mm", "b, mm"],
            rows: radii(&self.edge, BALL, ROWS).iter().map(row).collect(),
        }
    }
}

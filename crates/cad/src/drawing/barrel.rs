//! The sheet of a barrel: its surface unrolled as it is seen from outside, its upper end, heights of the roller.

use std::f64::consts::TAU;

use gaitcam::cam::{BarrelGroove, Wall};
use gaitcam::synth::Design;

use super::layout::Layout;
use super::leader;
use super::pen::{Pen, Stroke};
use super::piece::bore_edge;
use super::table::Table;
use crate::step::{Sectors, barrel_ends};
use crate::words::Labels;

const MM: f64 = 1000.0;
/// Rows of the table on one sheet, and their step.
const ROWS: usize = 144;
const STEP: usize = 5;
/// Points of a turn of the groove.
const POINTS: usize = 720;
/// Room around the views, mm: left of the unrolled surface, right of it, above it, between it and the end, below.
const LEFT: f64 = 24.0;
const RIGHT: f64 = 12.0;
const ABOVE: f64 = 16.0;
const BETWEEN: f64 = 30.0;
const BELOW: f64 = 12.0;
/// Room for labels next to the end view, mm.
const LABELS: f64 = 44.0;
/// Where the arrow of rotation begins and ends, from the mark of θ = 0, rad.
const ARROW: [f64; 2] = [0.15, 0.55];

/// A barrel, with the rows of its table from one index to another.
pub struct Barrel<'a> {
    design: &'a Design,
    groove: &'a BarrelGroove,
    /// Heights of both ends, m.
    ends: [f64; 2],
    rows: [usize; 2],
}

impl<'a> Barrel<'a> {
    /// A sheet for every so many rows.
    pub fn sheets(design: &'a Design, groove: &'a BarrelGroove) -> Vec<Self> {
        let turns = (groove.law().extent().1 / TAU).round().max(1.0) as usize;
        let count = turns * 360 / STEP;
        (0..count)
            .step_by(ROWS)
            .map(|from| Barrel {
                design,
                groove,
                ends: barrel_ends(groove),
                rows: [from, (from + ROWS).min(count)],
            })
            .collect()
    }

    fn radius(&self) -> f64 {
        self.groove.depth().1
    }

    fn length(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    pub fn layout(&self) -> Layout {
        let (radius, length) = (MM * self.radius(), MM * self.length());
        Layout::fitting(|scale| {
            let unrolled = scale * TAU * radius + LEFT + RIGHT;
            let end = 2.0 * scale * radius + 2.0 * LABELS;
            [
                unrolled.max(end),
                scale * (length + 2.0 * radius) + ABOVE + BETWEEN + BELOW,
            ]
        })
    }

    /// Draws the views; returns the table of heights.
    pub fn draw(&self, pen: &mut Pen, layout: &Layout, words: &Labels) -> Table {
        let scale = MM * layout.scale.factor();
        let area = layout.views;
        let (wide, high) = (scale * TAU * self.radius(), scale * self.length());
        let round = scale * self.radius();
        let spare = area.height() - (high + 2.0 * round + ABOVE + BETWEEN + BELOW);
        let corner = [
            area.left + 0.5 * (area.width() - wide + LEFT - RIGHT),
            area.bottom + BELOW + 2.0 * round + BETWEEN + 0.6 * spare,
        ];
        self.unrolled(pen, corner, scale, words);
        let centre = [
            0.5 * (area.left + area.right),
            area.bottom + BELOW + round + 0.3 * spare,
        ];
        self.end(pen, centre, scale, words);
        self.table(words)
    }

    /// The surface from θ = 0 at the right to 360° at the left, lower left corner at `corner`.
    fn unrolled(&self, pen: &mut Pen, corner: [f64; 2], scale: f64, words: &Labels) {
        let wide = scale * TAU * self.radius();
        let (right, top) = (corner[0] + wide, corner[1] + scale * self.length());
        let x = |angle: f64| right - scale * self.radius() * angle;
        let y = |z: f64| corner[1] + scale * (z - self.ends[0]);
        pen.frame(corner, [right, top], Stroke::Outline);
        for quarter in 0..=4 {
            let at = x(0.25 * TAU * f64::from(quarter));
            pen.line(&[[at, corner[1]], [at, top + 3.0]], Stroke::Thin);
            pen.note(&format!("{}°", 90 * quarter), [at, top + 4.5]);
        }
        let above = [0.5 * (corner[0] + right), top + 10.0];
        pen.note(&words.text("drawing-unrolled"), above);
        for line in self.walls() {
            let line: Vec<[f64; 2]> = line.iter().map(|[angle, z]| [x(*angle), y(*z)]).collect();
            pen.line(&line, Stroke::Outline);
        }
        let (start, length) = self.groove.law().extent();
        let turns = (length / TAU).round().max(1.0) as usize;
        for turn in 0..turns {
            let line: Vec<[f64; 2]> = (0..=POINTS)
                .map(|i| {
                    let angle = TAU * i as f64 / POINTS as f64;
                    let theta = start + angle + TAU * turn as f64;
                    [x(angle), y(self.groove.law().svaj(theta).s)]
                })
                .collect();
            pen.line(&line, Stroke::Centre);
        }
        let length = words.length(self.length(), 3);
        pen.upright(&length, [corner[1], top], corner[0], corner[0] - 8.0);
        let around = words.length(TAU * self.radius(), 3);
        pen.level(&around, [corner[0], right], corner[1], corner[1] - 9.0);
    }

    /// The edges of the groove on the surface: angle, rad, and height, m.
    fn walls(&self) -> Vec<Vec<[f64; 2]>> {
        let Some(sectors) = Sectors::of(self.groove, vec![self.radius()]) else {
            return Vec::new();
        };
        let mut out = Vec::new();
        for (k, openings) in sectors.openings.iter().enumerate() {
            let (from, to) = (sectors.angle(k, 0), sectors.angle(k + 1, 0));
            let count = ((to - from) / TAU * POINTS as f64).ceil().max(1.0) as usize;
            for bound in openings.iter().flatten() {
                let mut line: Vec<[f64; 2]> = Vec::new();
                for i in 0..=count {
                    let angle = from + (to - from) * i as f64 / count as f64;
                    let turned = angle.rem_euclid(TAU);
                    // The line is split at θ = 0, where the unrolled surface begins.
                    if line.last().is_some_and(|p| turned < p[0]) {
                        out.push(std::mem::take(&mut line));
                    }
                    line.push([turned, sectors.height(*bound, angle, self.radius())]);
                }
                out.push(line);
            }
        }
        out
    }

    /// The upper end, θ = 0 upwards.
    fn end(&self, pen: &mut Pen, centre: [f64; 2], scale: f64, words: &Labels) {
        let (floor, surface) = self.groove.depth();
        let [cx, cy] = centre;
        let round = scale * surface;
        let reach = round + 4.0;
        pen.cross(centre, reach, Stroke::Centre);
        pen.circle(centre, round, Stroke::Outline);
        pen.circle(centre, scale * floor, Stroke::Hidden);
        if let Some(bore) = &self.design.problem.cam.hole() {
            let ring: Vec<[f64; 2]> = (bore_edge(bore, POINTS).iter())
                .map(|[x, y]| [cx + scale * x, cy + scale * y])
                .collect();
            pen.ring(&ring, Stroke::Outline);
        }
        let mark = [[cx, cy + scale * floor], [cx, cy + round]];
        pen.line(&mark, Stroke::Outline);
        pen.note("θ = 0", [cx, cy + reach + 1.5]);
        let clockwise = self.design.problem.drive.speed < 0.0;
        pen.rotation(centre, round + 3.0, ARROW, clockwise);
        self.labels(pen, centre, scale, words);
    }

    /// Diameters of surface, floor, cutter and bore at the end view.
    fn labels(&self, pen: &mut Pen, centre: [f64; 2], scale: f64, words: &Labels) {
        let (floor, surface) = self.groove.depth();
        let [cx, cy] = centre;
        let round = scale * surface;
        let far = round.max(16.0);
        let mut label = |text: [String; 2], from: [f64; 2], side: f64, part: f64| {
            let slot = [cx + side * (round + 6.0), cy + part * far];
            pen.label(&text, from, slot, side);
        };
        let diameter = |key: &str, radius: f64| {
            let size = format!("Ø {}", words.length(2.0 * radius, 3));
            [words.text(key), size]
        };
        let at = |r: f64, angle: f64| [cx + r * angle.cos(), cy + r * angle.sin()];
        let text = diameter("drawing-surface", surface);
        label(text, at(round, 0.5), 1.0, 0.75);
        let text = diameter("drawing-floor", floor);
        label(text, at(scale * floor, -0.4), 1.0, -0.6);
        let mut cutter = diameter("drawing-groove-cutter", self.groove.roller_radius());
        let off = self.groove.axis_offset(Wall::Upper);
        if off > 0.0 {
            cutter[1] += &format!(", z ± {}", words.length(off, 3));
        }
        let cut = [cx, cy - 0.5 * scale * (floor + surface)];
        label(cutter, cut, -1.0, -0.75);
        let Some(bore) = self.design.problem.cam.hole() else {
            return;
        };
        let edge = at(scale * bore.radius(), 3.0);
        label(leader::bore(&bore, words), edge, -1.0, 0.1);
        if let Some(key) = bore.keyway {
            let half = 0.5 * scale * key.width;
            let corner = [cx - half, cy + scale * (bore.radius() + key.depth)];
            label(leader::keyway(&bore, &key, words), corner, -1.0, 0.8);
        }
    }

    fn table(&self, words: &Labels) -> Table {
        let start = self.groove.law().extent().0;
        let row = |k: usize| {
            let degrees = STEP * k;
            let theta = start + (degrees as f64).to_radians();
            let z = self.groove.law().svaj(theta).s - self.ends[0];
            vec![degrees.to_string(), words.length(z, 3)]
        };
        Table {
            heading: vec![
                words.text("drawing-stations"),
                words.text("drawing-stations-height"),
            ],
            columns: vec!["θ, °".to_string(), words.column("z")],
            rows: (self.rows[0]..self.rows[1]).map(row).collect(),
        }
    }
}

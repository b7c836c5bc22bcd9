//! The sheet of a barrel: its surface unrolled as it is seen from outside, its upper end, heights of the roller.

use std::f64::consts::TAU;

use gaitcam::cam::BarrelGroove;
use gaitcam::synth::Design;

use super::layout::{Area, Layout};
use super::leader;
use super::pen::{Anchor, Pen, Stroke};
use super::table::Table;
use crate::step::{Sectors, barrel_ends, turned_hole};
use crate::words::Words;

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
    pub fn draw(&self, pen: &mut Pen, layout: &Layout, words: &Words) -> Table {
        let scale = MM * layout.scale.factor();
        let Area {
            left,
            bottom,
            right,
            top,
        } = layout.views;
        let (wide, high) = (scale * TAU * self.radius(), scale * self.length());
        let round = scale * self.radius();
        let spare = top - bottom - (high + 2.0 * round + ABOVE + BETWEEN + BELOW);
        let corner = [
            left + 0.5 * (right - left - wide + LEFT - RIGHT),
            bottom + BELOW + 2.0 * round + BETWEEN + 0.6 * spare,
        ];
        self.unrolled(pen, corner, scale, words);
        let centre = [0.5 * (left + right), bottom + BELOW + round + 0.3 * spare];
        self.end(pen, centre, scale, words);
        self.table(words)
    }

    /// The surface from θ = 0 at the right to 360° at the left, lower left corner at `corner`.
    fn unrolled(&self, pen: &mut Pen, corner: [f64; 2], scale: f64, words: &Words) {
        let wide = scale * TAU * self.radius();
        let (right, top) = (corner[0] + wide, corner[1] + scale * self.length());
        let x = |angle: f64| right - scale * self.radius() * angle;
        let y = |z: f64| corner[1] + scale * (z - self.ends[0]);
        pen.frame(corner, [right, top], Stroke::Outline);
        for quarter in 0..=4 {
            let at = x(0.25 * TAU * f64::from(quarter));
            pen.line(&[[at, corner[1]], [at, top + 3.0]], Stroke::Thin);
            let text = format!("{}°", 90 * quarter);
            pen.text(&text, [at, top + 4.5], leader::LETTERS, Anchor::Middle);
        }
        let title = words.text("drawing-unrolled");
        pen.text(
            &title,
            [0.5 * (corner[0] + right), top + 10.0],
            leader::LETTERS,
            Anchor::Middle,
        );
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
        let mm = |v: f64| words.decimal(format!("{:.3}", MM * v));
        leader::upright(
            pen,
            &mm(self.length()),
            [corner[1], top],
            corner[0],
            corner[0] - 8.0,
        );
        let text = words.decimal(format!("{:.3}", MM * TAU * self.radius()));
        leader::level(pen, &text, [corner[0], right], corner[1], corner[1] - 9.0);
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
                    // Where the surface is cut open the line goes on at its other side.
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
    fn end(&self, pen: &mut Pen, centre: [f64; 2], scale: f64, words: &Words) {
        let (floor, surface) = self.groove.depth();
        let [cx, cy] = centre;
        let round = scale * surface;
        let reach = round + 4.0;
        pen.line(&[[cx - reach, cy], [cx + reach, cy]], Stroke::Centre);
        pen.line(&[[cx, cy - reach], [cx, cy + reach]], Stroke::Centre);
        pen.circle(centre, round, Stroke::Outline);
        pen.circle(centre, scale * floor, Stroke::Hidden);
        let hole = self.design.bore.map(|bore| turned_hole(&bore, POINTS));
        if let Some(hole) = &hole {
            // The barrel's x axis points up, its y axis to the left.
            let ring: Vec<[f64; 2]> = (hole.iter())
                .map(|[x, y]| [cx - scale * y, cy + scale * x])
                .collect();
            pen.ring(&ring, Stroke::Outline);
        }
        pen.line(
            &[[cx, cy + scale * floor], [cx, cy + round]],
            Stroke::Outline,
        );
        pen.text(
            "θ = 0",
            [cx, cy + reach + 1.5],
            leader::LETTERS,
            Anchor::Middle,
        );
        self.rotation(pen, centre, round + 3.0);
        let far = round.max(16.0);
        let mm = |name: &str, v: f64| {
            [
                words.text(name),
                words.decimal(format!("Ø {:.3}", 2.0 * MM * v)),
            ]
        };
        let at = |r: f64, angle: f64| [cx + r * angle.cos(), cy + r * angle.sin()];
        let slot = |side: f64, part: f64| [cx + side * (round + 6.0), cy + part * far];
        leader::label(
            pen,
            &mm("drawing-surface", surface),
            at(round, 0.5),
            slot(1.0, 0.75),
            1.0,
        );
        leader::label(
            pen,
            &mm("drawing-floor", floor),
            at(scale * floor, -0.4),
            slot(1.0, -0.6),
            1.0,
        );
        let roller = self.groove.roller_radius();
        let mut cutter = mm("drawing-groove-cutter", roller);
        let off = self.groove.axis_offset(gaitcam::cam::Wall::Upper);
        if off > 0.0 {
            cutter[1] += &words.decimal(format!(", z ± {:.3}", MM * off));
        }
        let cut = [cx, cy - 0.5 * scale * (floor + surface)];
        leader::label(pen, &cutter, cut, slot(-1.0, -0.75), -1.0);
        if let Some(bore) = self.design.bore {
            let size = words.decimal(format!("Ø {:.3} H7", MM * bore.diameter));
            let text = [words.text("drawing-bore"), size];
            leader::label(
                pen,
                &text,
                at(scale * bore.radius(), 3.0),
                slot(-1.0, 0.1),
                -1.0,
            );
            if let Some(key) = bore.keyway {
                let size = words.decimal(format!(
                    "{:.1} JS9, {:.2}",
                    MM * key.width,
                    MM * (bore.diameter + key.depth)
                ));
                let text = [words.text("drawing-keyway"), size];
                let corner = [
                    cx - 0.5 * scale * key.width,
                    cy + scale * (bore.radius() + key.depth),
                ];
                leader::label(pen, &text, corner, slot(-1.0, 0.8), -1.0);
            }
        }
    }

    /// The arrow that tells how the barrel turns.
    fn rotation(&self, pen: &mut Pen, [cx, cy]: [f64; 2], radius: f64) {
        let sense = if self.design.drive.speed < 0.0 {
            -1.0
        } else {
            1.0
        };
        let angle = |part: f64| 0.25 * TAU + sense * (0.15 + 0.4 * part);
        let at = |a: f64| [cx + radius * a.cos(), cy + radius * a.sin()];
        let arc: Vec<[f64; 2]> = (0..=24).map(|i| at(angle(f64::from(i) / 24.0))).collect();
        pen.line(&arc, Stroke::Thin);
        let last = angle(1.0);
        pen.arrowhead(at(last), [-sense * last.sin(), sense * last.cos()]);
    }

    fn table(&self, words: &Words) -> Table {
        let start = self.groove.law().extent().0;
        let row = |k: usize| {
            let degrees = STEP * k;
            let z = self
                .groove
                .law()
                .svaj(start + (degrees as f64).to_radians())
                .s
                - self.ends[0];
            vec![degrees.to_string(), words.decimal(format!("{:.3}", MM * z))]
        };
        Table {
            heading: vec![
                words.text("drawing-stations"),
                words.text("drawing-stations-height"),
            ],
            columns: vec!["θ, °", "z, mm"],
            rows: (self.rows[0]..self.rows[1]).map(row).collect(),
        }
    }
}

//! The sheet of a cam that slides: its profile above its foot, from the side, heights.

use gaitcam::synth::Design;

use super::BALL;
use super::layout::Layout;
use super::pen::{Pen, Stroke};
use super::radii::height;
use super::table::Table;
use crate::words::Labels;
use gaitcam::synth::Edge;

const MM: f64 = 1000.0;
/// Points of the profile.
const POINTS: usize = 1440;
/// Most rows of the table.
const ROWS: usize = 72;
/// Room around the views for dimensions, mm: left, between both views, right, below, above.
const LEFT: f64 = 26.0;
const BETWEEN: f64 = 34.0;
const RIGHT: f64 = 24.0;
const BELOW: f64 = 20.0;
const ABOVE: f64 = 22.0;

/// A slide.
pub struct Slide<'a> {
    design: &'a Design,
    edge: Edge<'a>,
    points: Vec<[f64; 2]>,
    pitch: Vec<[f64; 2]>,
    /// Left and right end, and largest height, m.
    ends: [f64; 2],
    top: f64,
}

impl<'a> Slide<'a> {
    pub fn new(design: &'a Design) -> Self {
        let edge = Edge::of(&design.cam);
        let all = edge.points(POINTS);
        let points: Vec<[f64; 2]> = all.iter().map(|e| e.p).collect();
        Slide {
            design,
            edge,
            ends: [points[0][0], points[points.len() - 1][0]],
            top: points.iter().map(|p| p[1]).fold(0.0, f64::max),
            pitch: all.iter().map(|e| e.pitch).collect(),
            points,
        }
    }

    /// Height of everything drawn, m: the pitch curve is above the profile.
    fn high(&self) -> f64 {
        let pitch = self.pitch.iter().map(|p| p[1]);
        pitch.fold(self.top, f64::max)
    }

    pub fn layout(&self) -> Layout {
        let (long, high) = (MM * (self.ends[1] - self.ends[0]), MM * self.high());
        let thick = MM * self.design.problem.cam.thickness;
        Layout::fitting(|scale| {
            [
                scale * (long + thick) + LEFT + BETWEEN + RIGHT,
                scale * high + BELOW + ABOVE,
            ]
        })
    }

    /// Draws the views; returns the table of heights.
    pub fn draw(&self, pen: &mut Pen, layout: &Layout, words: &Labels) -> Table {
        let scale = MM * layout.scale.factor();
        let area = layout.views;
        let long = scale * (self.ends[1] - self.ends[0]);
        let wide = long + scale * self.design.problem.cam.thickness + LEFT + BETWEEN + RIGHT;
        let high = scale * self.high();
        let [x, y] = [
            area.left + 0.5 * (area.width() - wide) + LEFT,
            area.bottom + BELOW + 0.5 * (area.height() - BELOW - ABOVE - high),
        ];
        let place = |p: &[f64; 2]| [x + scale * (p[0] - self.ends[0]), y + scale * p[1]];
        let mut ring: Vec<[f64; 2]> = self.points.iter().map(place).collect();
        ring.extend([[x + long, y], [x, y]]);
        pen.ring(&ring, Stroke::Outline);
        let pitch: Vec<[f64; 2]> = self.pitch.iter().map(place).collect();
        pen.line(&pitch, Stroke::Centre);
        let length = words.length(self.ends[1] - self.ends[0], 3);
        pen.level(&length, [x, x + long], y, y - 10.0);
        let start = self.points[0][1];
        pen.upright(&words.length(start, 3), [y, y + scale * start], x, x - 8.0);
        self.side(pen, [x + long + BETWEEN, y], scale, words);
        // The mark of θ = 0 and the cam's motion, above everything.
        let level = y + high + 6.0;
        pen.line(&[[x, level - 3.0], [x, level + 2.0]], Stroke::Outline);
        pen.note("θ = 0", [x, level + 4.0]);
        let sense = if self.design.problem.drive.speed < 0.0 {
            1.0
        } else {
            -1.0
        };
        let middle = x + 0.5 * long;
        let tip = [middle + sense * 12.0, level];
        pen.line(&[[middle - sense * 12.0, level], tip], Stroke::Thin);
        pen.arrowhead(tip, [sense, 0.0]);
        pen.note(&words.text("drawing-motion"), [middle, level + 1.5]);
        self.table(words)
    }

    /// From the right.
    fn side(&self, pen: &mut Pen, [left, foot]: [f64; 2], scale: f64, words: &Labels) {
        let right = left + scale * self.design.problem.cam.thickness;
        let top = foot + scale * self.top;
        pen.frame([left, foot], [right, top], Stroke::Outline);
        let [first, last] = [0, self.points.len() - 1].map(|i| foot + scale * self.points[i][1]);
        pen.line(&[[left, first], [right, first]], Stroke::Hidden);
        pen.line(&[[left, last], [right, last]], Stroke::Thin);
        let thick = words.length(self.design.problem.cam.thickness, 2);
        pen.level(&thick, [left, right], foot, foot - 10.0);
        pen.upright(&words.length(self.top, 3), [foot, top], left, left - 8.0);
    }

    fn table(&self, words: &Labels) -> Table {
        let ball = words.length(BALL, 3);
        let [first, last] = self.ends;
        let step = step((last - first) / (ROWS - 2) as f64);
        let mut places: Vec<f64> = (0..ROWS)
            .map(|k| first + step * k as f64)
            .take_while(|x| last - x > 0.5 * step)
            .collect();
        places.push(last);
        let row = |&x: &f64| {
            let mm = |y: Option<f64>| y.map_or("–".to_string(), |y| words.length(y, 3));
            let [profile, ball] = [0.0, BALL].map(|off| mm(height(&self.edge, x, off)));
            vec![words.length(x - first, 3), profile, ball]
        };
        Table {
            heading: vec![
                words.text("drawing-heights"),
                words.fill(
                    "drawing-heights-ball",
                    &[("radius", &ball), ("unit", words.units().name())],
                ),
            ],
            columns: ["x", "y", "b"].map(|symbol| words.column(symbol)).into(),
            rows: places.iter().map(row).collect(),
        }
    }
}

/// The smallest of 1, 2, 2.5, 5 times a power of ten that is not below `least`, m.
fn step(least: f64) -> f64 {
    let ten = 10f64.powf(least.log10().floor());
    let steps = [1.0, 2.0, 2.5, 5.0, 10.0];
    let smallest = steps.into_iter().find(|s| s * ten >= least * (1.0 - 1e-9));
    ten * smallest.unwrap_or(10.0)
}

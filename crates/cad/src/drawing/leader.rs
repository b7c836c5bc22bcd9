//! Annotations of the views: labels with leaders, dimensions between two edges, centre lines and the arrow of rotation.

use std::f64::consts::TAU;

use gaitcam::cam::{Bore, Keyway};

use super::pen::{Anchor, Pen, Stroke};
use crate::words::Labels;

/// Letter height of dimensions, mm per em.
const LETTERS: f64 = 3.2;
/// Distance between the two lines of a label, mm.
const LINE: f64 = 3.9;
/// Length of the horizontal end section of a leader, mm.
const SHELF: f64 = 2.0;
/// Width of a dimension, mm, below which its arrows are outside the extension lines.
const NARROW: f64 = 14.0;
/// Distance between the text of a dimension and its dimension line, mm.
const ABOVE: f64 = 1.0;
const BEYOND: f64 = 1.5;

impl Pen {
    /// Draws a leader and two lines of text at its end, on the right (`side` 1) or on the left (−1).
    pub fn label(&mut self, text: &[String; 2], from: [f64; 2], end: [f64; 2], side: f64) {
        let shelf = [end[0] + side * SHELF, end[1]];
        self.line(&[from, end, shelf], Stroke::Thin);
        let far = libm::hypot(from[0] - end[0], from[1] - end[1]);
        self.arrowhead(from, [(from[0] - end[0]) / far, (from[1] - end[1]) / far]);
        let anchor = if side > 0.0 {
            Anchor::Start
        } else {
            Anchor::End
        };
        let x = shelf[0] + side;
        let capital = 0.36 * LETTERS;
        for (line, off) in text.iter().zip([0.5 * LINE, -0.5 * LINE]) {
            self.text(line, [x, end[1] - capital + off], LETTERS, anchor);
        }
    }

    /// Draws the dimension between two vertical edges, with a horizontal dimension line at the height `y`. The edges end at the height `foot`,
    /// above the line.
    pub fn level(&mut self, text: &str, [left, right]: [f64; 2], foot: f64, y: f64) {
        for x in [left, right] {
            self.line(&[[x, foot - ABOVE], [x, y - BEYOND]], Stroke::Thin);
        }
        if right - left >= NARROW {
            self.line(&[[left, y], [right, y]], Stroke::Thin);
            self.arrowhead([left, y], [-1.0, 0.0]);
            self.arrowhead([right, y], [1.0, 0.0]);
            let at = [0.5 * (left + right), y + ABOVE];
            self.text(text, at, LETTERS, Anchor::Middle);
        } else {
            self.line(&[[left - 6.0, y], [right + 6.0, y]], Stroke::Thin);
            self.arrowhead([left, y], [1.0, 0.0]);
            self.arrowhead([right, y], [-1.0, 0.0]);
            let at = [right + 7.0, y - 0.36 * LETTERS];
            self.text(text, at, LETTERS, Anchor::Start);
        }
    }

    /// Writes text in the letter height of dimensions, centred above the point `at`.
    pub fn note(&mut self, text: &str, at: [f64; 2]) {
        self.text(text, at, LETTERS, Anchor::Middle);
    }

    /// Draws a horizontal and a vertical centre line that extend `reach` mm from the centre.
    pub fn cross(&mut self, [x, y]: [f64; 2], reach: f64, stroke: Stroke) {
        self.line(&[[x - reach, y], [x + reach, y]], stroke);
        self.line(&[[x, y - reach], [x, y + reach]], stroke);
    }

    /// Draws an arrow in the direction of rotation. Its start and end are angles in rad from the mark of θ = 0, which points upwards.
    pub fn rotation(
        &mut self,
        [x, y]: [f64; 2],
        radius: f64,
        [from, to]: [f64; 2],
        clockwise: bool,
    ) {
        let sense = if clockwise { -1.0 } else { 1.0 };
        let angle = |part: f64| 0.25 * TAU + sense * (from + (to - from) * part);
        let at = |a: f64| [x + radius * libm::cos(a), y + radius * libm::sin(a)];
        let arc: Vec<[f64; 2]> = (0..=24).map(|i| at(angle(f64::from(i) / 24.0))).collect();
        self.line(&arc, Stroke::Thin);
        let (sin, cos) = libm::sincos(angle(1.0));
        self.arrowhead(arc[24], [-sense * sin, sense * cos]);
    }
}

/// Text of the label for the bore. The first line is its name. The second line contains the diameter with its tolerance class.
pub fn bore(bore: &Bore, words: &Labels) -> [String; 2] {
    let size = format!("Ø {} H7", words.length(bore.diameter, 3));
    [words.text("drawing-bore"), size]
}

/// Text of the label for the keyway. The first line is its name. The second line contains the width with its tolerance class, and the
/// height of the bore through the keyway.
pub fn keyway(bore: &Bore, key: &Keyway, words: &Labels) -> [String; 2] {
    let height = words.length(bore.diameter + key.depth, 2);
    let size = format!("{} JS9, {height}", words.length(key.width, 1));
    [words.text("drawing-keyway"), size]
}

//! Labels with leaders, and dimensions between two edges.

use super::pen::{Anchor, Pen, Stroke};

/// Letters of dimensions, mm per em.
pub const LETTERS: f64 = 3.2;
/// Distance of the two lines of a label.
const LINE: f64 = 3.9;
/// Length of the leader's level end, mm.
const SHELF: f64 = 2.0;
/// Below this width the arrows of a dimension are outside its extension lines, mm.
const NARROW: f64 = 14.0;
/// Distance of a dimension's number from its line, mm, and how far extension lines go beyond it.
const ABOVE: f64 = 1.0;
const BEYOND: f64 = 1.5;

/// Two lines of text at the end of a leader, to the right of it (`side` 1) or to the left (−1).
pub fn label(pen: &mut Pen, text: &[String; 2], from: [f64; 2], end: [f64; 2], side: f64) {
    let shelf = [end[0] + side * SHELF, end[1]];
    pen.line(&[from, end, shelf], Stroke::Thin);
    let far = (from[0] - end[0]).hypot(from[1] - end[1]);
    pen.arrowhead(from, [(from[0] - end[0]) / far, (from[1] - end[1]) / far]);
    let anchor = if side > 0.0 {
        Anchor::Start
    } else {
        Anchor::End
    };
    let x = shelf[0] + side;
    let capital = 0.36 * LETTERS;
    for (line, off) in text.iter().zip([0.5 * LINE, -0.5 * LINE]) {
        pen.text(line, [x, end[1] - capital + off], LETTERS, anchor);
    }
}

/// The distance between two upright edges whose lower ends are at `foot`, on a level line at height `y` below them.
pub fn level(pen: &mut Pen, text: &str, [left, right]: [f64; 2], foot: f64, y: f64) {
    for x in [left, right] {
        pen.line(&[[x, foot - ABOVE], [x, y - BEYOND]], Stroke::Thin);
    }
    if right - left >= NARROW {
        pen.line(&[[left, y], [right, y]], Stroke::Thin);
        pen.arrowhead([left, y], [-1.0, 0.0]);
        pen.arrowhead([right, y], [1.0, 0.0]);
        let at = [0.5 * (left + right), y + ABOVE];
        pen.text(text, at, LETTERS, Anchor::Middle);
    } else {
        pen.line(&[[left - 6.0, y], [right + 6.0, y]], Stroke::Thin);
        pen.arrowhead([left, y], [1.0, 0.0]);
        pen.arrowhead([right, y], [-1.0, 0.0]);
        let at = [right + 7.0, y - 0.36 * LETTERS];
        pen.text(text, at, LETTERS, Anchor::Start);
    }
}

/// The distance between two level edges whose left ends are at `edge`, on an upright line at `x` left of them.
pub fn upright(pen: &mut Pen, text: &str, [low, high]: [f64; 2], edge: f64, x: f64) {
    for y in [low, high] {
        pen.line(&[[edge - ABOVE, y], [x - BEYOND, y]], Stroke::Thin);
    }
    let inside = high - low >= NARROW;
    let out = if inside { 0.0 } else { 6.0 };
    pen.line(&[[x, low - out], [x, high + out]], Stroke::Thin);
    let sense = if inside { 1.0 } else { -1.0 };
    pen.arrowhead([x, low], [0.0, -sense]);
    pen.arrowhead([x, high], [0.0, sense]);
    let middle = 0.5 * (low + high) - 0.36 * LETTERS;
    pen.text(text, [x - ABOVE, middle], LETTERS, Anchor::End);
}

//! Drawing of lines and text on a PDF sheet. Coordinates are in millimetres from the lower left corner, with y upwards.

use pdf_writer::{Buf, Content, Name, Str};

use super::helvetica::{Face, Glyph, glyph, width};

/// PDF points per millimetre.
pub const POINT: f64 = 72.0 / 25.4;
/// Name of the font Helvetica in the PDF resources of the sheet.
pub const HELVETICA: Name<'static> = Name(b"Helvetica");
/// Name of the font Symbol in the PDF resources of the sheet.
pub const SYMBOL: Name<'static> = Name(b"Symbol");

/// Distance between an end point and its control point, if a cubic Bézier curve represents a quarter of the unit circle. The radial error is 3e-4 of
/// the radius.
const QUARTER: f64 = 0.552_284_749_8;

/// Line types of ISO 128, each with a width in mm and a dash pattern.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// Continuous thick line, for visible edges.
    Outline,
    /// Continuous thin line, for dimensions, leaders and tables.
    Thin,
    /// Dashed line, for hidden edges.
    Hidden,
    /// Line of long dashes and dots, for axes and reference circles.
    Centre,
}

impl Stroke {
    fn width(self) -> f64 {
        match self {
            Stroke::Outline => 0.5,
            _ => 0.18,
        }
    }

    fn dashes(self) -> &'static [f64] {
        match self {
            Stroke::Outline | Stroke::Thin => &[],
            Stroke::Hidden => &[2.0, 1.0],
            Stroke::Centre => &[6.0, 1.0, 0.5, 1.0],
        }
    }
}

/// Position of the reference point on the baseline of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Start of the text, at its left end.
    Start,
    /// Middle of the text.
    Middle,
    /// End of the text, at its right end.
    End,
}

/// PDF content of one sheet, to which lines and texts are added.
pub struct Pen {
    content: Content,
}

fn pt(mm: f64) -> f32 {
    (POINT * mm) as f32
}

impl Pen {
    /// Creates the content of an empty sheet.
    pub fn new() -> Self {
        Pen {
            content: Content::new(),
        }
    }

    /// Returns the PDF content stream of the sheet.
    pub fn finish(self) -> Buf {
        self.content.finish()
    }

    fn take(&mut self, stroke: Stroke) {
        self.content.set_line_width(pt(stroke.width()));
        let dashes = stroke.dashes().iter().map(|&d| pt(d));
        self.content.set_dash_pattern(dashes, 0.0);
    }

    fn trace(&mut self, points: &[[f64; 2]]) {
        for (i, [x, y]) in points.iter().enumerate() {
            if i == 0 {
                self.content.move_to(pt(*x), pt(*y));
            } else {
                self.content.line_to(pt(*x), pt(*y));
            }
        }
    }

    /// Draws an open polyline through points, mm.
    pub fn line(&mut self, points: &[[f64; 2]], stroke: Stroke) {
        self.take(stroke);
        self.trace(points);
        self.content.stroke();
    }

    /// Draws a closed polyline through points, mm.
    pub fn ring(&mut self, points: &[[f64; 2]], stroke: Stroke) {
        self.take(stroke);
        self.trace(points);
        self.content.close_and_stroke();
    }

    /// Draws a rectangle, given by its lower left and upper right corners.
    pub fn frame(&mut self, [left, bottom]: [f64; 2], [right, top]: [f64; 2], stroke: Stroke) {
        let corners = [[left, bottom], [right, bottom], [right, top], [left, top]];
        self.ring(&corners, stroke);
    }

    /// Draws a circle of radius `r` mm about a centre.
    pub fn circle(&mut self, [x, y]: [f64; 2], r: f64, stroke: Stroke) {
        self.take(stroke);
        self.content.move_to(pt(x + r), pt(y));
        let mut from = [1.0, 0.0];
        for to in [[0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [1.0, 0.0]] {
            let arm = |a: [f64; 2], b: [f64; 2]| {
                [
                    pt(x + r * (a[0] + QUARTER * b[0])),
                    pt(y + r * (a[1] + QUARTER * b[1])),
                ]
            };
            let ([x1, y1], [x2, y2]) = (arm(from, to), arm(to, from));
            let (x3, y3) = (pt(x + r * to[0]), pt(y + r * to[1]));
            self.content.cubic_to(x1, y1, x2, y2, x3, y3);
            from = to;
        }
        self.content.close_and_stroke();
    }

    /// Draws a filled arrowhead with its tip at `tip`. It points in the direction of the unit vector `along`.
    pub fn arrowhead(&mut self, tip: [f64; 2], along: [f64; 2]) {
        /// Length and half width of an arrowhead, mm.
        const SIZE: [f64; 2] = [2.5, 0.42];
        let back = |side: f64| {
            [
                tip[0] - SIZE[0] * along[0] - side * SIZE[1] * along[1],
                tip[1] - SIZE[0] * along[1] + side * SIZE[1] * along[0],
            ]
        };
        self.trace(&[tip, back(1.0), back(-1.0)]);
        self.content.close_path().fill_nonzero();
    }

    /// Writes a line of text. Its reference point is at (`x`, `y`), and its size is `size` mm per em.
    pub fn text(&mut self, text: &str, [x, y]: [f64; 2], size: f64, anchor: Anchor) {
        let long = size * width(text);
        let start = match anchor {
            Anchor::Start => x,
            Anchor::Middle => x - 0.5 * long,
            Anchor::End => x - long,
        };
        let glyphs: Vec<Glyph> = text.chars().map(glyph).collect();
        self.content.begin_text();
        self.content
            .set_text_matrix([1.0, 0.0, 0.0, 1.0, pt(start), pt(y)]);
        for run in glyphs.chunk_by(|a, b| a.face == b.face) {
            let font = match run[0].face {
                Face::Helvetica => HELVETICA,
                Face::Symbol => SYMBOL,
            };
            let bytes: Vec<u8> = run.iter().map(|g| g.byte).collect();
            self.content.set_font(font, pt(size));
            self.content.show(Str(&bytes));
        }
        self.content.end_text();
    }

    /// Writes a line of text. If it is wider than `room` mm, it is reduced to this width.
    pub fn text_within(&mut self, text: &str, at: [f64; 2], size: f64, room: f64) {
        let long = size * width(text);
        let size = if long > room {
            size * room / long
        } else {
            size
        };
        self.text(text, at, size, Anchor::Start);
    }
}

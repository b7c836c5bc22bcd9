//! The sheet that pictures are drawn on: a list of shapes, from which SVG and PNG are made alike.

use std::cell::RefCell;

use super::outline::straightened;
use super::palette;
use super::text::Line;

/// The typeface, by the name the SVG asks for.
pub const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";
/// Height of the capitals in ems: text is centred on them.
const CAPITAL: f64 = 0.729;

/// An opaque or translucent colour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ink {
    /// Red, green, blue.
    pub rgb: [u8; 3],
    /// Opacity, 0 … 1.
    pub alpha: f64,
}

impl Ink {
    /// An opaque colour.
    pub const fn opaque(r: u8, g: u8, b: u8) -> Ink {
        let rgb = [r, g, b];
        Ink { rgb, alpha: 1.0 }
    }

    /// The colour with a part of its opacity.
    #[must_use]
    pub fn mix(self, part: f64) -> Ink {
        let alpha = part * self.alpha;
        Ink { alpha, ..self }
    }

    /// A shape filled with the colour.
    pub fn filled(self) -> Style {
        let (ink, width) = (self, None);
        Style { ink, width }
    }
}

/// How a shape is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Style {
    /// Colour.
    pub ink: Ink,
    /// Width of its line, points; none fills it.
    pub width: Option<f64>,
}

/// A line of `width` points.
pub fn stroke(ink: Ink, width: f64) -> Style {
    let width = Some(width);
    Style { ink, width }
}

/// One thing on the sheet; lengths in points, y down.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs)] // the names are the documentation
pub enum Shape {
    /// An open line, or a filled polygon.
    Path { points: Vec<[f64; 2]>, style: Style },
    /// A circle.
    Circle {
        centre: [f64; 2],
        radius: f64,
        style: Style,
    },
    /// A line of text.
    Text { line: Line, ink: Ink },
}

/// Shapes drawn so far, in order.
#[derive(Debug, Default)]
pub struct Canvas(RefCell<Vec<Shape>>);

impl Canvas {
    fn add(&self, shape: Shape) {
        self.0.borrow_mut().push(shape);
    }

    /// All that was drawn.
    pub fn shapes(self) -> Vec<Shape> {
        self.0.into_inner()
    }
}

/// Horizontal anchor of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // the names are the documentation
pub enum HPos {
    Left,
    Center,
    Right,
}

/// Vertical anchor of a text: top of the capitals, their middle, or the baseline.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // the names are the documentation
pub enum VPos {
    Top,
    Center,
    Bottom,
}

/// How a piece of text looks and which of its points is placed.
#[derive(Clone, Copy)]
pub struct Lettering {
    /// Size of an em, points.
    pub size: f64,
    /// Colour.
    pub colour: Ink,
    /// Weight.
    pub bold: bool,
    /// Horizontal anchor.
    pub h: HPos,
    /// Vertical anchor.
    pub v: VPos,
    /// Written upwards instead of to the right.
    pub upwards: bool,
}

impl Lettering {
    /// Regular text that starts at its point, centred in height.
    pub fn new(size: f64, colour: Ink) -> Self {
        Lettering {
            size,
            colour,
            bold: false,
            h: HPos::Left,
            v: VPos::Center,
            upwards: false,
        }
    }

    /// The same, written upwards.
    #[must_use]
    pub fn upwards(mut self) -> Self {
        self.upwards = true;
        self
    }

    /// The same, bold.
    #[must_use]
    pub fn bold(mut self) -> Self {
        self.bold = true;
        self
    }

    /// The same, anchored elsewhere.
    #[must_use]
    pub fn anchored(mut self, h: HPos, v: VPos) -> Self {
        (self.h, self.v) = (h, v);
        self
    }
}

/// Writes `text` at a point of the canvas.
pub fn write(canvas: &Canvas, text: &str, [x, y]: [f64; 2], lettering: Lettering) {
    let Lettering { size, upwards, .. } = lettering;
    let drop = match lettering.v {
        VPos::Top => CAPITAL * size,
        VPos::Center => 0.5 * CAPITAL * size,
        VPos::Bottom => 0.0,
    };
    let line = Line {
        text: text.to_string(),
        // Upwards, "below" the anchor is to its right.
        at: match upwards {
            true => [x + drop, y],
            false => [x, y + drop],
        },
        size,
        anchor: match lettering.h {
            HPos::Left => 0.0,
            HPos::Center => 0.5,
            HPos::Right => 1.0,
        },
        bold: lettering.bold,
        upwards,
    };
    let ink = lettering.colour;
    canvas.add(Shape::Text { line, ink });
}

/// A line through points of the canvas, or the polygon that they enclose.
pub fn line(canvas: &Canvas, through: &[[f64; 2]], style: Style) {
    let points = straightened(through);
    canvas.add(Shape::Path { points, style });
}

/// A dashed line through points of the canvas; dashes and gaps in points.
pub fn dashed(canvas: &Canvas, through: &[[f64; 2]], [on, off]: [f64; 2], style: Style) {
    let Some((&first, rest)) = through.split_first() else {
        return;
    };
    let (mut at, mut dash, mut left, mut is_on) = (first, vec![first], on, true);
    for &end in rest {
        loop {
            let way = [end[0] - at[0], end[1] - at[1]];
            let length = way[0].hypot(way[1]);
            if length.is_nan() || length <= left {
                left -= length;
                at = end;
                dash.push(at);
                break;
            }
            at = [0, 1].map(|k| at[k] + left / length * way[k]);
            dash.push(at);
            if is_on {
                line(canvas, &dash, style);
            }
            is_on = !is_on;
            left = if is_on { on } else { off };
            dash = vec![at];
        }
    }
    if is_on {
        line(canvas, &dash, style);
    }
}

/// A circle about a point of the canvas.
pub fn circle(canvas: &Canvas, centre: [f64; 2], radius: f64, style: Style) {
    canvas.add(Shape::Circle {
        centre,
        radius,
        style,
    });
}

/// A rectangle between two corners on the canvas.
pub fn rectangle(canvas: &Canvas, [[a, b], [c, d]]: [[f64; 2]; 2], style: Style) {
    line(canvas, &[[a, b], [c, b], [c, d], [a, d], [a, b]], style);
}

/// A part of the sheet, points.
#[derive(Debug, Clone, Copy)]
#[allow(missing_docs)] // the names are the documentation
pub struct Frame {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
}

impl Frame {
    /// Draws its edges.
    pub fn border(&self, canvas: &Canvas) {
        let corners = [[self.left, self.top], [self.right, self.bottom]];
        rectangle(canvas, corners, stroke(palette::AXIS, 1.0));
    }

    /// Axes over it: `x` and `y` are the values at left and right, at bottom and top.
    pub fn plane<'c>(&self, canvas: &'c Canvas, x: [f64; 2], y: [f64; 2]) -> Plane<'c> {
        let frame = *self;
        Plane {
            canvas,
            frame,
            x,
            y,
        }
    }
}

/// A part of the sheet with axes.
#[derive(Debug, Clone, Copy)]
pub struct Plane<'c> {
    /// The sheet.
    pub canvas: &'c Canvas,
    /// The part of it.
    pub frame: Frame,
    /// Values at its left and right.
    pub x: [f64; 2],
    /// Values at its bottom and top.
    pub y: [f64; 2],
}

impl Plane<'_> {
    /// The place of a value on the sheet.
    pub fn place(&self, (u, v): (f64, f64)) -> [f64; 2] {
        let share = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
        let Frame {
            left,
            right,
            top,
            bottom,
        } = self.frame;
        [
            left + share(u, self.x) * (right - left),
            bottom + share(v, self.y) * (top - bottom),
        ]
    }

    /// Places of many values.
    pub fn places(&self, points: &[(f64, f64)]) -> Vec<[f64; 2]> {
        points.iter().map(|p| self.place(*p)).collect()
    }
}

/// A line on a plane.
pub fn trace(plane: &Plane, points: &[(f64, f64)], style: Style) {
    line(plane.canvas, &plane.places(points), style);
}

/// A filled polygon on a plane.
pub fn fill(plane: &Plane, corners: &[(f64, f64)], ink: Ink) {
    trace(plane, corners, ink.filled());
}

/// A circle on a plane, its radius in points.
pub fn ring(plane: &Plane, at: (f64, f64), radius: f64, style: Style) {
    circle(plane.canvas, plane.place(at), radius, style);
}

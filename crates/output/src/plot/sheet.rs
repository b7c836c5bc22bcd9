//! Sheet on which figures are drawn: a backend of the plotters library that stores shapes and not pixels.
//!
//! The same drawing is used for SVG and PNG. Plotters uses integer coordinates. A sheet therefore has [`UNITS`] units per point, so that
//! curves are smooth.

use std::convert::Infallible;

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters_backend::text_anchor::{HPos, Pos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind,
};

use super::palette;
use super::text::Line;

/// Number of sheet units per point.
pub const UNITS: f64 = 16.0;
/// Names of the fonts in the SVG.
pub const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";
/// Height of capital letters, em. Text is centred vertically on this height.
const CAPITAL: f64 = 0.729;

/// A colour with opacity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ink {
    /// Red, green and blue components.
    pub rgb: [u8; 3],
    /// Opacity, 0 … 1.
    pub alpha: f64,
}

/// A shape on the sheet. Lengths are in points, y is downwards.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs)] // the names are the documentation
pub enum Shape {
    /// An open polyline with the given line width.
    Line {
        points: Vec<[f64; 2]>,
        ink: Ink,
        width: f64,
    },
    /// A filled polygon.
    Area { points: Vec<[f64; 2]>, ink: Ink },
    /// A circle, filled or as a line of the given width.
    Circle {
        centre: [f64; 2],
        radius: f64,
        ink: Ink,
        width: Option<f64>,
    },
    /// A line of text in one colour.
    Text { line: Line, ink: Ink },
}

/// Drawing backend of plotters that stores all shapes.
pub struct Recorder<'a> {
    /// Shapes drawn so far, in order.
    pub shapes: &'a mut Vec<Shape>,
    /// Width and height of the sheet, points.
    pub size: (u32, u32),
}

/// Drawing area of plotters, with coordinates in sheet units.
pub type Canvas<'a> = DrawingArea<Recorder<'a>, Shift>;
/// Drawing area of plotters, with axes in the units of the drawn quantities.
pub type Plane<'a> = DrawingArea<Recorder<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;
/// Result of a drawing function. Errors can only come from plotters itself.
pub type Drawn<T = ()> = Result<T, DrawingAreaErrorKind<Infallible>>;

type Recorded = Result<(), DrawingErrorKind<Infallible>>;

fn points((x, y): BackendCoord) -> [f64; 2] {
    [f64::from(x) / UNITS, f64::from(y) / UNITS]
}

fn ink(color: BackendColor) -> Ink {
    let (r, g, b) = color.rgb;
    Ink {
        rgb: [r, g, b],
        alpha: color.alpha,
    }
}

impl DrawingBackend for Recorder<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        let units = UNITS as u32;
        (self.size.0 * units, self.size.1 * units)
    }

    fn ensure_prepared(&mut self) -> Recorded {
        Ok(())
    }

    fn present(&mut self) -> Recorded {
        Ok(())
    }

    fn draw_pixel(&mut self, _: BackendCoord, _: BackendColor) -> Recorded {
        // A pixel of plotters is one sheet unit, 1/16 point, which is too small to be visible.
        Ok(())
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Recorded {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
        style: &S,
        fill: bool,
    ) -> Recorded {
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        if fill {
            return self.fill_polygon(corners, style);
        }
        self.draw_path(corners.into_iter().chain([corners[0]]), style)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Recorded {
        self.shapes.push(Shape::Line {
            points: path.into_iter().map(points).collect(),
            ink: ink(style.color()),
            width: f64::from(style.stroke_width()) / UNITS,
        });
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Recorded {
        self.shapes.push(Shape::Circle {
            centre: points(center),
            radius: f64::from(radius) / UNITS,
            ink: ink(style.color()),
            width: (!fill).then(|| f64::from(style.stroke_width()) / UNITS),
        });
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        vert: I,
        style: &S,
    ) -> Recorded {
        self.shapes.push(Shape::Area {
            points: vert.into_iter().map(points).collect(),
            ink: ink(style.color()),
        });
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        pos: BackendCoord,
    ) -> Recorded {
        let size = style.size() / UNITS;
        let upwards = matches!(style.transform(), FontTransform::Rotate270);
        let drop = match style.anchor().v_pos {
            VPos::Top => CAPITAL * size,
            VPos::Center => 0.5 * CAPITAL * size,
            VPos::Bottom => 0.0,
        };
        let [x, y] = points(pos);
        let line = Line {
            text: text.to_string(),
            at: if upwards {
                [x + drop, y]
            } else {
                [x, y + drop]
            },
            size,
            anchor: match style.anchor().h_pos {
                HPos::Left => 0.0,
                HPos::Center => 0.5,
                HPos::Right => 1.0,
            },
            bold: matches!(style.style(), FontStyle::Bold),
            upwards,
        };
        let ink = ink(style.color());
        self.shapes.push(Shape::Text { line, ink });
        Ok(())
    }
}

/// Converts points to sheet units.
pub fn units(length: f64) -> i32 {
    (length * UNITS).round() as i32
}

/// Style of a line with a width of `width` points.
pub fn stroke(colour: RGBAColor, width: f64) -> ShapeStyle {
    Color::stroke_width(&colour, units(width).max(1) as u32)
}

/// Style and anchor of a text.
#[derive(Clone, Copy)]
pub struct Lettering {
    /// Font size (one em), points.
    pub size: f64,
    /// Colour of the text.
    pub colour: RGBAColor,
    /// Whether the text is bold.
    pub bold: bool,
    /// Horizontal anchor: left end, middle or right end of the text.
    pub h: HPos,
    /// Vertical anchor: top of the capitals, their middle, or the baseline.
    pub v: VPos,
    /// Whether the text is written upwards instead of to the right.
    pub upwards: bool,
}

impl Lettering {
    /// Regular text that begins at its anchor point and is centred vertically on it.
    pub fn new(size: f64, colour: RGBAColor) -> Self {
        Lettering {
            size,
            colour,
            bold: false,
            h: HPos::Left,
            v: VPos::Center,
            upwards: false,
        }
    }

    /// Copy of the style for text that is written upwards.
    pub fn upwards(mut self) -> Self {
        self.upwards = true;
        self
    }

    /// Copy of the style, with bold letters.
    pub fn bold(mut self) -> Self {
        self.bold = true;
        self
    }

    /// Copy of the style with the anchors `h` (horizontal) and `v` (vertical).
    pub fn anchored(mut self, h: HPos, v: VPos) -> Self {
        (self.h, self.v) = (h, v);
        self
    }

    fn style(self) -> TextStyle<'static> {
        let weight = if self.bold {
            FontStyle::Bold
        } else {
            FontStyle::Normal
        };
        let font = FontDesc::new(FontFamily::Name(FAMILY), self.size * UNITS, weight);
        let font = if self.upwards {
            font.transform(FontTransform::Rotate270)
        } else {
            font
        };
        TextStyle {
            font,
            color: self.colour.to_backend_color(),
            pos: Pos::new(self.h, self.v),
        }
    }
}

/// Writes `text` at a point of the canvas, given in points.
pub fn write(canvas: &Canvas, text: &str, [x, y]: [f64; 2], lettering: Lettering) -> Drawn {
    canvas.draw(&Text::new(
        text.to_string(),
        (units(x), units(y)),
        lettering.style(),
    ))
}

/// Draws a polyline through points of the canvas, given in points.
pub fn line(canvas: &Canvas, through: &[[f64; 2]], style: ShapeStyle) -> Drawn {
    let path: Vec<(i32, i32)> = through.iter().map(|&[x, y]| (units(x), units(y))).collect();
    canvas.draw(&PathElement::new(path, style))
}

/// Draws a dashed line. Its ends and the lengths of dashes and gaps are in points.
pub fn dashed(
    canvas: &Canvas,
    ends: [[f64; 2]; 2],
    [on, off]: [f64; 2],
    style: ShapeStyle,
) -> Drawn {
    let ends = ends.map(|[x, y]| (units(x), units(y)));
    canvas.draw(&DashedPathElement::new(ends, units(on), units(off), style))
}

/// Draws a circle on the canvas. Centre and radius are in points.
pub fn circle(canvas: &Canvas, [x, y]: [f64; 2], radius: f64, style: ShapeStyle) -> Drawn {
    canvas.draw(&Circle::new((units(x), units(y)), units(radius), style))
}

/// Draws a rectangle between two corners on the canvas, given in points.
pub fn rectangle(canvas: &Canvas, corners: [[f64; 2]; 2], style: ShapeStyle) -> Drawn {
    let corners = corners.map(|[x, y]| (units(x), units(y)));
    canvas.draw(&Rectangle::new(corners, style))
}

/// A rectangular part of the sheet, points.
#[derive(Debug, Clone, Copy)]
#[allow(missing_docs)] // the names are the documentation
pub struct Frame {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
}

impl Frame {
    /// Draws the edges of the frame.
    pub fn border(&self, canvas: &Canvas) -> Drawn {
        let corners = [[self.left, self.top], [self.right, self.bottom]];
        rectangle(canvas, corners, stroke(palette::AXIS, 1.0))
    }

    /// Axes that fill the frame. `x` contains the values at the left and right edge, `y` the values at the bottom and top edge.
    pub fn plane<'a>(&self, canvas: &Canvas<'a>, x: [f64; 2], y: [f64; 2]) -> Plane<'a> {
        let across = units(self.left)..units(self.right);
        let up = units(self.bottom)..units(self.top);
        let axes = Cartesian2d::new(x[0]..x[1], y[0]..y[1], (across, up));
        canvas.apply_coord_spec(axes)
    }

    /// Position on the sheet, points, of the point (u, v) of a diagram whose axes have the ranges `x` and `y`.
    pub fn place(&self, x: [f64; 2], y: [f64; 2], (u, v): (f64, f64)) -> [f64; 2] {
        let share = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
        [
            self.left + share(u, x) * (self.right - self.left),
            self.bottom + share(v, y) * (self.top - self.bottom),
        ]
    }
}

/// Draws a polyline in the coordinates of the axes.
pub fn trace(plane: &Plane, points: impl Into<Vec<(f64, f64)>>, style: ShapeStyle) -> Drawn {
    plane.draw(&PathElement::new(points.into(), style))
}

/// Draws a filled polygon in the coordinates of the axes.
pub fn fill(plane: &Plane, corners: &[(f64, f64)], colour: RGBAColor) -> Drawn {
    plane.draw(&Polygon::new(corners, colour.filled()))
}

//! Pictures as lists of shapes, and their conversion to SVG and PNG.

use std::fmt::Write;

use plotters::prelude::*;

use super::palette;

use super::raster;
use super::sheet::{Canvas, Drawn, FAMILY, Ink, Recorder, Shape};
use gaitcam_base::text::escaped;
use gaitcam_base::text::{append, append_decimal};

/// A finished picture on a white background.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) shapes: Vec<Shape>,
}

impl Picture {
    /// Creates a picture of the given size, points. `draw` draws its shapes. One point is one pixel of the PNG.
    pub fn drawn(width: u32, height: u32, draw: impl FnOnce(&Canvas) -> Drawn) -> Self {
        let mut shapes = Vec::new();
        let canvas = Recorder {
            shapes: &mut shapes,
            size: (width, height),
        }
        .into_drawing_area();
        // The recorder accepts every shape. Only an internal check of plotters could fail.
        let drawn = draw(&canvas);
        debug_assert!(drawn.is_ok());
        drop(canvas);
        Picture {
            width,
            height,
            shapes,
        }
    }

    /// SVG text for a separate file, with fixed colours on a white background.
    pub fn svg(&self) -> String {
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" \
             viewBox=\"0 0 {w} {h}\" font-family=\"{FAMILY}\">\n<rect width=\"{w}\" height=\"{h}\" fill=\"#fff\"/>\n",
            w = self.width,
            h = self.height
        );
        self.write_shapes(&mut out, false);
        out.push_str("</svg>\n");
        out
    }

    /// SVG element for an HTML page. It has no background, and its colours are variables of the page (`--ink`, `--blue` …). `attributes`
    /// are added to the element unchanged.
    pub(crate) fn svg_for_page(&self, id: &str, title: &str, attributes: &str) -> String {
        let mut out = format!(
            "<svg id=\"{id}\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{title}\"{attributes}>",
            self.width,
            self.height,
            title = escaped(title)
        );
        self.write_shapes(&mut out, true);
        out.push_str("</svg>");
        out
    }

    /// PNG with 8-bit RGB and one pixel per point.
    pub fn png(&self) -> Vec<u8> {
        raster::png(self.width as usize, self.height as usize, &self.shapes)
    }

    fn write_shapes(&self, out: &mut String, variables: bool) {
        for shape in &self.shapes {
            // Writing to a String cannot fail.
            let _ = write_shape(out, shape, variables);
        }
    }
}

fn write_shape(out: &mut String, shape: &Shape, variables: bool) -> std::fmt::Result {
    let stroke = |ink: &Ink| paint("stroke", *ink, variables);
    let fill = |ink: &Ink| paint("fill", *ink, variables);
    match shape {
        Shape::Line { points, ink, width } => {
            let paint = stroke(ink);
            writeln!(
                out,
                "<path d=\"{}\" fill=\"none\" {paint} stroke-width=\"{}\" stroke-linejoin=\"round\"/>",
                path(points),
                short(*width)
            )
        }
        Shape::Area { points, ink } => {
            writeln!(out, "<path d=\"{}Z\" {}/>", path(points), fill(ink))
        }
        Shape::Circle {
            centre: [x, y],
            radius,
            ink,
            width,
        } => {
            let paint = match width {
                None => fill(ink),
                Some(w) => {
                    let (stroke, w) = (stroke(ink), short(*w));
                    format!("fill=\"none\" {stroke} stroke-width=\"{w}\"")
                }
            };
            let [x, y, r] = [x, y, radius].map(|q| short(*q));
            writeln!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" {paint}/>")
        }
        Shape::Text { line, ink } => {
            let [x, y, size] = [line.at[0], line.at[1], line.size].map(short);
            let anchor = match line.anchor {
                0.0 => "",
                1.0 => " text-anchor=\"end\"",
                _ => " text-anchor=\"middle\"",
            };
            let weight = if line.bold {
                " font-weight=\"bold\""
            } else {
                ""
            };
            let turn = match line.upwards {
                true => format!(" transform=\"rotate(-90 {x} {y})\""),
                false => String::new(),
            };
            let paint = fill(ink);
            writeln!(
                out,
                "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\"{anchor}{weight}{turn} {paint}>{}</text>",
                escaped(&line.text)
            )
        }
    }
}

/// SVG path data. Coordinates are relative to the previous point, which shortens the text.
fn path(points: &[[f64; 2]]) -> String {
    let mut d = String::with_capacity(8 * points.len());
    let mut last = [0i64; 2];
    for (i, p) in points.iter().enumerate() {
        let now = p.map(|x| (x * 100.0).round() as i64);
        d.push(if i == 0 { 'M' } else { 'l' });
        append_decimal(&mut d, now[0] - last[0], 2);
        d.push(' ');
        append_decimal(&mut d, now[1] - last[1], 2);
        last = now;
    }
    d
}

/// A number as text with at most two decimals, without trailing zeros.
fn short(x: f64) -> String {
    let mut out = String::new();
    append(&mut out, x, 2);
    out
}

fn paint(property: &str, ink: Ink, variables: bool) -> String {
    let [r, g, b] = ink.rgb;
    let name = palette::NAMES
        .iter()
        .find(|(c, _)| variables && (c.0, c.1, c.2) == (r, g, b));
    let colour = match name {
        Some((_, name)) => format!("var(--{name})"),
        None => format!("#{r:02x}{g:02x}{b:02x}"),
    };
    let mut out = if name.is_some() {
        format!("style=\"{property}:{colour}\"")
    } else {
        format!("{property}=\"{colour}\"")
    };
    if ink.alpha < 1.0 {
        let _ = write!(out, " {property}-opacity=\"{}\"", short(ink.alpha));
    }
    out
}

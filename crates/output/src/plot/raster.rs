//! Shapes to pixels: exact area coverage.

use std::sync::LazyLock;

use ab_glyph::{Font, FontRef, PxScale, ScaleFont, point};

use super::coverage::Coverage;
use super::sheet::{Ink, Shape};
use crate::plot::picture::Picture;

/// Corners of a round dot or line end.
const CORNERS: usize = 24;
/// Sine of the turn from which two segments get a round joint between them.
const SHARP: f64 = 0.1;

struct Fonts {
    regular: Option<FontRef<'static>>,
    bold: Option<FontRef<'static>>,
}

static FONTS: LazyLock<Fonts> = LazyLock::new(|| Fonts {
    regular: FontRef::try_from_slice(dejavu::sans::regular()).ok(),
    bold: FontRef::try_from_slice(dejavu::sans::bold()).ok(),
});

/// The picture as an 8-bit RGB PNG.
pub fn png(picture: &Picture) -> Vec<u8> {
    let mut page = Page::new(picture.width as usize, picture.height as usize);
    for shape in &picture.shapes {
        page.draw(shape);
    }
    super::png::encode(page.width, page.height, &page.rgb)
}

/// Width of a text in ems, regular weight.
pub fn text_width(text: &str) -> f64 {
    let Some(font) = &FONTS.regular else {
        return 0.0;
    };
    let em = f64::from(font.units_per_em().unwrap_or(2048.0));
    text.chars()
        .map(|c| f64::from(font.h_advance_unscaled(font.glyph_id(c))) / em)
        .sum()
}

struct Page {
    width: usize,
    height: usize,
    rgb: Vec<u8>,
    coverage: Coverage,
}

impl Page {
    fn new(width: usize, height: usize) -> Self {
        Page {
            width,
            height,
            rgb: vec![255; 3 * width * height],
            coverage: Coverage::new(width, height),
        }
    }

    fn draw(&mut self, shape: &Shape) {
        match shape {
            Shape::Line { points, ink, width } => self.fill(&outline(points, *width), *ink),
            Shape::Area { points, ink } => self.fill(std::slice::from_ref(points), *ink),
            Shape::Circle {
                centre,
                radius,
                ink,
                width: None,
            } => self.fill(&[disc(*centre, *radius)], *ink),
            Shape::Circle {
                centre,
                radius,
                ink,
                width: Some(w),
            } => {
                let mut ring = disc(*centre, *radius);
                ring.push(ring[0]);
                self.fill(&outline(&ring, *w), *ink);
            }
            Shape::Text {
                text,
                at,
                size,
                ink,
                anchor,
                bold,
                upwards,
            } => {
                let font = if *bold { &FONTS.bold } else { &FONTS.regular };
                if let Some(font) = font {
                    self.text(font, text, *at, *size, *ink, *anchor, *upwards);
                }
            }
        }
    }

    /// Fills the union of polygons of one orientation.
    fn fill(&mut self, polygons: &[Vec<[f64; 2]>], ink: Ink) {
        // NaN is no place, and infinity none on a page.
        if !polygons.iter().flatten().flatten().all(|x| x.is_finite()) {
            return;
        }
        for polygon in polygons {
            let Some(&last) = polygon.last() else {
                continue;
            };
            let mut from = last;
            for &to in polygon {
                self.coverage.edge(from, to);
                from = to;
            }
        }
        let (width, rgb) = (self.width, &mut self.rgb);
        self.coverage.take(|row, first, end, c| {
            let alpha = ink.alpha as f32 * c;
            let pixels = &mut rgb[3 * (row * width + first)..3 * (row * width + end)];
            for pixel in pixels.chunks_exact_mut(3) {
                mix(pixel, ink.rgb, alpha);
            }
        });
    }

    fn blend(&mut self, x: i64, y: i64, ink: Ink, coverage: f32) {
        if x < 0 || y < 0 || x >= self.width as i64 || y >= self.height as i64 {
            return;
        }
        let i = 3 * (y as usize * self.width + x as usize);
        let alpha = ink.alpha as f32 * coverage.min(1.0);
        mix(&mut self.rgb[i..i + 3], ink.rgb, alpha);
    }

    #[allow(clippy::too_many_arguments)] // the fields of one kind of shape
    fn text(
        &mut self,
        font: &FontRef<'static>,
        text: &str,
        at: [f64; 2],
        size: f64,
        ink: Ink,
        anchor: f64,
        upwards: bool,
    ) {
        let em = font.units_per_em().unwrap_or(2048.0);
        let scale = PxScale::from(size as f32 * font.height_unscaled() / em);
        let scaled = font.as_scaled(scale);
        let total: f32 = text
            .chars()
            .map(|c| scaled.h_advance(scaled.glyph_id(c)))
            .sum();
        let mut pen = -total * anchor as f32;
        for c in text.chars() {
            let id = scaled.glyph_id(c);
            // Upright text is placed to a fraction of a pixel; turned text is turned pixel by pixel.
            let place = if upwards {
                point(pen, 0.0)
            } else {
                point(at[0] as f32 + pen, at[1] as f32)
            };
            if let Some(glyph) = font.outline_glyph(id.with_scale_and_position(scale, place)) {
                let corner = glyph.px_bounds().min;
                glyph.draw(|x, y, c| {
                    let px = corner.x as i64 + i64::from(x);
                    let py = corner.y as i64 + i64::from(y);
                    if upwards {
                        let (ax, ay) = (at[0].round() as i64, at[1].round() as i64);
                        self.blend(ax + py, ay - px, ink, c);
                    } else {
                        self.blend(px, py, ink, c);
                    }
                });
            }
            pen += scaled.h_advance(id);
        }
    }
}

fn mix(pixel: &mut [u8], colour: [u8; 3], alpha: f32) {
    for (under, over) in pixel.iter_mut().zip(colour) {
        let below = f32::from(*under);
        *under = (below + alpha * (f32::from(over) - below) + 0.5) as u8;
    }
}

fn disc([x, y]: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    // Corners beyond the radius make up for what the sides cut off.
    let corners = CORNERS.max((4.0 * radius) as usize);
    let half = std::f64::consts::PI / corners as f64;
    let r = radius * (half / half.sin()).sqrt();
    (0..corners)
        .map(|i| {
            let (sin, cos) = (2.0 * half * i as f64).sin_cos();
            [x + r * cos, y + r * sin]
        })
        .collect()
}

/// A line of given width as polygons of one orientation: a rectangle per segment, a disc per sharp corner.
fn outline(points: &[[f64; 2]], width: f64) -> Vec<Vec<[f64; 2]>> {
    let half = 0.5 * width;
    let mut out = Vec::with_capacity(points.len());
    let mut before: Option<[f64; 2]> = None;
    for pair in points.windows(2) {
        let (p, q) = (pair[0], pair[1]);
        let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
        let length = dx.hypot(dy);
        if length <= 0.0 {
            continue;
        }
        let t = [dx / length, dy / length];
        if let Some(b) = before {
            let turn = b[0] * t[1] - b[1] * t[0];
            if turn.abs() > SHARP || b[0] * t[0] + b[1] * t[1] < 0.0 {
                out.push(disc(p, half));
            }
        }
        before = Some(t);
        let n = [-t[1] * half, t[0] * half];
        // Counter-clockwise in the sense of `disc`: both have positive area in these coordinates.
        out.push(vec![
            [p[0] - n[0], p[1] - n[1]],
            [q[0] - n[0], q[1] - n[1]],
            [q[0] + n[0], q[1] + n[1]],
            [p[0] + n[0], p[1] + n[1]],
        ]);
    }
    out
}

//! Shapes to pixels: exact area coverage, in bands from the top, so that a band stays in the
//! processor's cache.

use super::coverage::{Coverage, Covered};
use super::outline::{disc, outline, straightened};
use super::png::{Encoder, Rows, stride};
use super::sheet::{Ink, Shape};
use super::text::Letter;

/// Rows of a band.
const BAND: usize = 64;

/// The shapes on a white page as an 8-bit RGB PNG.
pub fn png(width: usize, height: usize, shapes: &[Shape]) -> Vec<u8> {
    let layers: Vec<Layer> = shapes.iter().map(Layer::of).collect();
    let mut band = Band::new(width, BAND.min(height));
    let mut file = Encoder::new(width, height);
    for top in (0..height).step_by(BAND) {
        band.begin(top, BAND.min(height - top));
        for layer in &layers {
            band.draw(layer);
        }
        file.rows(band.rows());
    }
    file.finish()
}

/// A shape as filled regions.
struct Layer {
    ink: Ink,
    content: Content,
    /// Rows that it may touch: first, one past the last.
    rows: [f64; 2],
}

enum Content {
    /// The union of polygons of one orientation.
    Polygons(Vec<Polygon>),
    Letters(Vec<Letter>),
}

struct Polygon {
    corners: Vec<[f64; 2]>,
    rows: [f64; 2],
}

/// No rows.
const NONE: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

fn both(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

impl Layer {
    fn of(shape: &Shape) -> Layer {
        match shape {
            Shape::Line { points, ink, width } => {
                Layer::filled(outline(&straightened(points), *width), *ink)
            }
            Shape::Area { points, ink } => Layer::filled(vec![straightened(points)], *ink),
            Shape::Circle {
                centre,
                radius,
                ink,
                width,
            } => {
                let mut ring = disc(*centre, *radius);
                let Some(width) = width else {
                    return Layer::filled(vec![ring], *ink);
                };
                ring.push(ring[0]);
                Layer::filled(outline(&ring, *width), *ink)
            }
            Shape::Text { line, ink } => Layer::written(Letter::all(line), *ink),
        }
    }

    fn filled(polygons: Vec<Vec<[f64; 2]>>, ink: Ink) -> Layer {
        // NaN and infinity are no coordinates.
        let placed = polygons.iter().flatten().flatten().all(|x| x.is_finite());
        let polygons = if placed { polygons } else { Vec::new() };
        let polygons: Vec<Polygon> = polygons
            .into_iter()
            .map(|corners| Polygon {
                rows: corners.iter().fold(NONE, |r, p| both(r, [p[1]; 2])),
                corners,
            })
            .collect();
        Layer {
            ink,
            rows: polygons.iter().fold(NONE, |r, p| both(r, p.rows)),
            content: Content::Polygons(polygons),
        }
    }

    fn written(letters: Vec<Letter>, ink: Ink) -> Layer {
        Layer {
            ink,
            rows: letters.iter().fold(NONE, |r, l| both(r, l.rows())),
            content: Content::Letters(letters),
        }
    }
}

/// Some rows of the page.
struct Band {
    width: usize,
    /// The band's first row on the page.
    top: usize,
    height: usize,
    /// Rows as PNG has them, a zero, then the pixels; before them the last row of the band before.
    rows: Vec<u8>,
    coverage: Coverage,
}

impl Band {
    fn new(width: usize, height: usize) -> Self {
        Band {
            width,
            top: 0,
            height: 0,
            rows: vec![0; stride(width) * (height + 1)],
            coverage: Coverage::new(width, height),
        }
    }

    /// Empty rows from `top` on.
    fn begin(&mut self, top: usize, height: usize) {
        let stride = stride(self.width);
        let last = self.height * stride;
        self.rows.copy_within(last..last + stride, 0);
        (self.top, self.height) = (top, height);
        self.coverage.begin(top, height);
        let rows = &mut self.rows[stride..][..height * stride];
        rows.fill(255);
        rows.iter_mut()
            .step_by(stride)
            .for_each(|filter| *filter = 0);
    }

    /// The rows, and before them, except in the first band, the one above.
    fn rows(&self) -> Rows<'_> {
        let stride = stride(self.width);
        let first = if self.top == 0 { stride } else { 0 };
        Rows {
            bytes: &self.rows[first..(self.height + 1) * stride],
            known: stride - first,
        }
    }

    fn touches(&self, rows: [f64; 2]) -> bool {
        let top = self.top as f64;
        rows[0] < top + self.height as f64 && rows[1] > top
    }

    fn draw(&mut self, layer: &Layer) {
        if !self.touches(layer.rows) {
            return;
        }
        match &layer.content {
            Content::Polygons(polygons) => self.fill(polygons, layer.ink),
            Content::Letters(letters) => {
                for letter in letters {
                    if self.touches(letter.rows()) {
                        letter.draw(|x, y, covered| self.blend(x, y, layer.ink, covered));
                    }
                }
            }
        }
    }

    /// Fills the union of the polygons.
    fn fill(&mut self, polygons: &[Polygon], ink: Ink) {
        for polygon in polygons {
            if !self.touches(polygon.rows) {
                continue;
            }
            let Some(&last) = polygon.corners.last() else {
                continue;
            };
            let mut from = last;
            for &to in &polygon.corners {
                self.coverage.edge(from, to);
                from = to;
            }
        }
        let stride = stride(self.width);
        let rows = &mut self.rows[stride..];
        self.coverage.take(|row, first, covered| {
            let pixels = &mut rows[row * stride + 1..][3 * first..];
            let pixels = pixels.as_chunks_mut::<3>().0;
            match covered {
                Covered::Evenly(count, c) => {
                    let alpha = ink.alpha as f32 * c;
                    // Most pixels have the background of their neighbour.
                    let (mut under, mut over) = ([0; 3], mixed([0; 3], ink.rgb, alpha));
                    for pixel in &mut pixels[..count] {
                        if *pixel != under {
                            (under, over) = (*pixel, mixed(*pixel, ink.rgb, alpha));
                        }
                        *pixel = over;
                    }
                }
                Covered::Each(parts) => {
                    for (pixel, &c) in pixels.iter_mut().zip(parts).filter(|(_, c)| **c > 0.0) {
                        *pixel = mixed(*pixel, ink.rgb, ink.alpha as f32 * c);
                    }
                }
            }
        });
    }

    fn blend(&mut self, x: i64, y: i64, ink: Ink, coverage: f32) {
        let y = y - self.top as i64;
        if x < 0 || y < 0 || x >= self.width as i64 || y >= self.height as i64 {
            return;
        }
        let i = (y as usize + 1) * stride(self.width) + 1 + 3 * x as usize;
        let alpha = ink.alpha as f32 * coverage.min(1.0);
        for pixel in self.rows[i..i + 3].as_chunks_mut::<3>().0 {
            *pixel = mixed(*pixel, ink.rgb, alpha);
        }
    }
}

fn mixed(under: [u8; 3], colour: [u8; 3], alpha: f32) -> [u8; 3] {
    std::array::from_fn(|k| {
        let below = f32::from(under[k]);
        (below + alpha * (f32::from(colour[k]) - below) + 0.5) as u8
    })
}

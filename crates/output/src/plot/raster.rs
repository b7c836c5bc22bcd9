//! Shapes to pixels: exact area coverage.

use super::coverage::Coverage;
use super::outline::{disc, outline, straightened};
use super::png;
use super::sheet::{Ink, Shape};

/// The shapes on a white page as an 8-bit RGB PNG.
pub fn png(width: usize, height: usize, shapes: &[Shape]) -> Vec<u8> {
    let mut page = Page {
        width,
        pixels: vec![[255; 3]; width * height],
        coverage: Coverage::new(width, height),
    };
    shapes.iter().for_each(|shape| page.draw(shape));
    png::png(width, &page.pixels)
}

struct Page {
    width: usize,
    /// Rows from the top.
    pixels: Vec<[u8; 3]>,
    coverage: Coverage,
}

impl Page {
    fn draw(&mut self, shape: &Shape) {
        match shape {
            Shape::Line { points, ink, width } => {
                self.fill(&outline(&straightened(points), *width), *ink);
            }
            Shape::Area { points, ink } => self.fill(&[straightened(points)], *ink),
            Shape::Circle {
                centre,
                radius,
                ink,
                width,
            } => {
                let mut ring = disc(*centre, *radius);
                let Some(width) = width else {
                    return self.fill(&[ring], *ink);
                };
                ring.push(ring[0]);
                self.fill(&outline(&ring, *width), *ink);
            }
            Shape::Text { line, ink } => self.fill(&line.outline(), *ink),
        }
    }

    /// Fills the union of polygons of one orientation.
    fn fill(&mut self, polygons: &[Vec<[f64; 2]>], ink: Ink) {
        // NaN and infinity are no coordinates.
        if !polygons.iter().flatten().flatten().all(|x| x.is_finite()) {
            return;
        }
        for polygon in polygons {
            let others = polygon.iter().skip(1).chain(polygon.first());
            for (from, to) in polygon.iter().zip(others) {
                self.coverage.edge(*from, *to);
            }
        }
        let (width, pixels) = (self.width, &mut self.pixels);
        self.coverage.take(|row, columns, covered| {
            let alpha = ink.alpha as f32 * covered;
            // Most pixels have the background of their neighbour.
            let (mut under, mut over) = ([0; 3], mixed([0; 3], ink.rgb, alpha));
            for pixel in &mut pixels[row * width..][columns] {
                if *pixel != under {
                    (under, over) = (*pixel, mixed(*pixel, ink.rgb, alpha));
                }
                *pixel = over;
            }
        });
    }
}

fn mixed([r, g, b]: [u8; 3], [red, green, blue]: [u8; 3], alpha: f32) -> [u8; 3] {
    let mix = |below: u8, over: u8| {
        let below = f32::from(below);
        (below + alpha * (f32::from(over) - below) + 0.5) as u8
    };
    [mix(r, red), mix(g, green), mix(b, blue)]
}

//! Conversion of the shapes of a picture to pixels.

use crate::raster::{Page, disc, outline, straightened};

use super::sheet::{Ink, Shape};

/// PNG (8-bit RGB) of shapes on a white page.
pub fn png(width: usize, height: usize, shapes: &[Shape]) -> Vec<u8> {
    let mut page = Page::new(width, height);
    shapes.iter().for_each(|shape| draw(&mut page, shape));
    page.png()
}

fn draw(page: &mut Page, shape: &Shape) {
    let mut fill = |polygons: &[Vec<[f64; 2]>], ink: &Ink| page.fill(polygons, ink.rgb, ink.alpha);
    match shape {
        Shape::Line { points, ink, width } => fill(&outline(&straightened(points), *width), ink),
        Shape::Area { points, ink } => fill(&[straightened(points)], ink),
        Shape::Circle {
            centre,
            radius,
            ink,
            width,
        } => {
            let mut ring = disc(*centre, *radius);
            let Some(width) = width else {
                return fill(&[ring], ink);
            };
            ring.push(ring[0]);
            fill(&outline(&ring, *width), ink);
        }
        Shape::Text { line, ink } => fill(&line.outline(), ink),
    }
}

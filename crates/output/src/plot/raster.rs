//! Shapes to pixels: exact area coverage.

use std::cell::Cell;
use std::sync::LazyLock;

use ab_glyph::{Font, FontRef, PxScale, ScaleFont, point};

use super::coverage::{Coverage, Covered};
use super::png::stride;
use super::sheet::{Ink, Shape};
use crate::plot::picture::Picture;

/// Corners of a round dot or line end.
const CORNERS: usize = 24;
/// A point nearer than this to the straight way past it is not seen, pixels; places are known to a sixteenth.
const UNSEEN: f64 = 0.06;
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

thread_local! {
    /// The page of the picture before: pictures of one size follow each other, and fresh memory costs more than drawing.
    static PAGE: Cell<Option<Page>> = const { Cell::new(None) };
}

/// The picture as an 8-bit RGB PNG.
pub fn png(picture: &Picture) -> Vec<u8> {
    let (width, height) = (picture.width as usize, picture.height as usize);
    let before = PAGE.take();
    let mut page = match before.filter(|page| (page.width, page.height) == (width, height)) {
        Some(page) => page.emptied(),
        None => Page::new(width, height),
    };
    for shape in &picture.shapes {
        page.draw(shape);
    }
    let file = super::png::encode(width, height, &page.rows);
    PAGE.set(Some(page));
    file
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
    /// Rows as PNG has them: a zero, then the pixels.
    rows: Vec<u8>,
    coverage: Coverage,
}

impl Page {
    fn new(width: usize, height: usize) -> Self {
        let page = Page {
            width,
            height,
            rows: vec![0; stride(width) * height],
            coverage: Coverage::new(width, height),
        };
        page.emptied()
    }

    /// The same page with nothing on it.
    fn emptied(mut self) -> Self {
        self.rows.fill(255);
        let filters = self.rows.iter_mut().step_by(stride(self.width));
        filters.for_each(|filter| *filter = 0);
        self
    }

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
        let (stride, rows) = (stride(self.width), &mut self.rows);
        self.coverage.take(|row, first, covered| {
            let pixels = &mut rows[row * stride + 1..][3 * first..];
            let pixels = pixels.as_chunks_mut::<3>().0;
            match covered {
                Covered::Evenly(count, c) => {
                    let alpha = ink.alpha as f32 * c;
                    // Most pixels lie on what their neighbour lies on.
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
        if x < 0 || y < 0 || x >= self.width as i64 || y >= self.height as i64 {
            return;
        }
        let i = y as usize * stride(self.width) + 1 + 3 * x as usize;
        let alpha = ink.alpha as f32 * coverage.min(1.0);
        for pixel in self.rows[i..i + 3].as_chunks_mut::<3>().0 {
            *pixel = mixed(*pixel, ink.rgb, alpha);
        }
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

fn mixed(under: [u8; 3], colour: [u8; 3], alpha: f32) -> [u8; 3] {
    std::array::from_fn(|k| {
        let below = f32::from(under[k]);
        (below + alpha * (f32::from(colour[k]) - below) + 0.5) as u8
    })
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

/// The line without the points that lie on the way from those before to those after: a curve has more of them than
/// the page has pixels.
fn straightened(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut out: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    let Some((&first, rest)) = points.split_first() else {
        return out;
    };
    out.push(first);
    let (mut corner, mut last) = (first, first);
    // Directions from the corner that pass all points since by, none being known at first.
    let mut passing: Option<[[f64; 2]; 2]> = None;
    for &point in rest {
        let mut way = [point[0] - corner[0], point[1] - corner[1]];
        let onward = (point[0] - last[0]) * (last[0] - corner[0])
            + (point[1] - last[1]) * (last[1] - corner[1]);
        let passes = passing.is_none_or(|[left, right]| {
            cross(left, way) >= 0.0 && cross(way, right) >= 0.0 && onward >= 0.0
        });
        if !passes {
            out.push(last);
            (corner, passing) = (last, None);
            way = [point[0] - corner[0], point[1] - corner[1]];
        }
        let square = way[0] * way[0] + way[1] * way[1];
        if square > UNSEEN * UNSEEN {
            let lean = UNSEEN / square.sqrt();
            let left = [way[0] + lean * way[1], way[1] - lean * way[0]];
            let right = [way[0] - lean * way[1], way[1] + lean * way[0]];
            passing = Some(passing.map_or([left, right], |[l, r]| {
                [
                    if cross(l, left) > 0.0 { left } else { l },
                    if cross(right, r) > 0.0 { right } else { r },
                ]
            }));
        }
        last = point;
    }
    out.push(last);
    out
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
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

#[cfg(test)]
mod tests {
    use super::*;

    fn off(points: &[[f64; 2]], at: [f64; 2]) -> f64 {
        let to = |pair: &[[f64; 2]]| {
            let way = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
            let here = [at[0] - pair[0][0], at[1] - pair[0][1]];
            let square = way[0] * way[0] + way[1] * way[1];
            let t = ((here[0] * way[0] + here[1] * way[1]) / square.max(1e-300)).clamp(0.0, 1.0);
            (here[0] - t * way[0]).hypot(here[1] - t * way[1])
        };
        points.windows(2).map(to).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn a_straightened_line_passes_every_point_by_less_than_is_seen() {
        let wave = |i: i32| {
            let x = f64::from(i) * 0.76;
            [x, 200.0 + 150.0 * (0.02 * x).sin() + 3.0 * (0.1 * x).cos()]
        };
        let circle = |i: i32| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 1440.0).sin_cos();
            [300.0 + 250.0 * cos, 300.0 + 250.0 * sin]
        };
        let there_and_back = |i: i32| [f64::from(i.min(1440 - i)), 5.0];
        let shapes: [&dyn Fn(i32) -> [f64; 2]; 3] = [&wave, &circle, &there_and_back];
        for shape in shapes {
            let points: Vec<[f64; 2]> = (0..=1440).map(shape).collect();
            let fewer = straightened(&points);
            assert!(fewer.len() < points.len() / 2, "{}", fewer.len());
            let most = points.iter().map(|p| off(&fewer, *p)).fold(0.0, f64::max);
            assert!(most <= UNSEEN + 1e-9, "{most}");
        }
    }

    #[test]
    fn corners_and_ends_stay() {
        let corner = [[0.0, 0.0], [5.0, 0.0], [10.0, 0.0], [10.0, 10.0]];
        let kept = vec![[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]];
        assert_eq!(straightened(&corner), kept);
        let ring = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0], [0.0, 0.0]];
        assert_eq!(straightened(&ring), ring.to_vec());
        assert_eq!(straightened(&[]), Vec::<[f64; 2]>::new());
        assert_eq!(straightened(&[[1.0, 2.0]]).len(), 2);
    }
}

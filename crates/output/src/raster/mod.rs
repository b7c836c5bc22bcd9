//! Conversion of polygons to pixels on a white page with exact coverage, and conversion of the page to PNG.

mod coverage;
mod outline;
mod png;

pub use coverage::Coverage;
pub use outline::{disc, outline, straightened};

/// Opacity above which the mixed colour equals the drawn colour after rounding.
const OPAQUE: f32 = 1.0 - 1.0 / 1024.0;

/// A page of pixels. It is white initially. x is to the right, y is downwards, and the unit is one pixel.
pub struct Page {
    width: usize,
    /// Colours of the pixels, row by row from the top.
    pixels: Vec<[u8; 3]>,
    coverage: Coverage,
}

impl Page {
    /// Creates a white page; sizes in pixels.
    #[must_use]
    pub fn new(width: usize, height: usize) -> Page {
        Page {
            width,
            pixels: vec![[255; 3]; width * height],
            coverage: Coverage::new(width, height),
        }
    }

    /// Fills the union of several polygons of equal orientation with a colour of opacity `alpha`, 0 … 1. If a coordinate is not finite,
    /// nothing is filled.
    pub fn fill(&mut self, polygons: &[Vec<[f64; 2]>], rgb: [u8; 3], alpha: f64) {
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
            let alpha = alpha as f32 * covered;
            let run = &mut pixels[row * width..][columns];
            if alpha > OPAQUE {
                match rgb {
                    [red, green, blue] if red == green && green == blue => {
                        run.as_flattened_mut().fill(red);
                    }
                    _ => run.fill(rgb),
                }
                return;
            }
            // Most pixels have the same background as the previous pixel, so the mixed colour is reused.
            let (mut under, mut over) = ([0; 3], mixed([0; 3], rgb, alpha));
            for pixel in run {
                if *pixel != under {
                    (under, over) = (*pixel, mixed(*pixel, rgb, alpha));
                }
                *pixel = over;
            }
        });
    }

    /// The page as an 8-bit RGB PNG.
    #[must_use]
    pub fn png(&self) -> Vec<u8> {
        png::png(self.width, &self.pixels)
    }
}

fn mixed([r, g, b]: [u8; 3], [red, green, blue]: [u8; 3], alpha: f32) -> [u8; 3] {
    let mix = |below: u8, over: u8| {
        let below = f32::from(below);
        (below + alpha * (f32::from(over) - below) + 0.5) as u8
    };
    [mix(r, red), mix(g, green), mix(b, blue)]
}

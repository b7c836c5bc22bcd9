//! How a picture is laid out: alone or as a figure of the report; title, strips, key of the curves.

use plotters::prelude::*;
use plotters_backend::text_anchor::{HPos, VPos};

use super::axes::{Frame, Panel, dashes, ticks};
use super::palette::{INK, QUIET};
use super::text::text_width;
use crate::plot::sheet::{Canvas, Drawn, Lettering, line, stroke, write};
use gaitcam::cam::Measures;
use gaitcam::synth::Design;

/// Size of the pictures that are files, pixels.
pub const SIZE: (u32, u32) = (1200, 800);
/// Size of their lettering.
const LETTERS: f64 = 17.0;

/// How a picture is laid out: alone, or as a figure of the report under a caption.
#[derive(Debug, Clone, Copy)]
pub struct Layout {
    /// Width and height, points.
    pub size: (u32, u32),
    /// Lettering, points.
    pub letters: f64,
    /// Whether the picture carries its own title.
    pub title: bool,
}

impl Layout {
    /// A file of its own.
    pub const ALONE: Layout = Layout {
        size: SIZE,
        letters: LETTERS,
        title: true,
    };

    /// A figure of the report.
    pub const fn figure(height: u32) -> Self {
        Layout {
            size: (FIGURE_WIDTH, height),
            letters: 13.0,
            title: false,
        }
    }

    /// The outer frame of the diagrams.
    pub fn frame(&self) -> Frame {
        let e = self.letters;
        Frame {
            left: 6.8 * e,
            right: f64::from(self.size.0) - 1.8 * e,
            top: if self.title { 4.6 * e } else { 0.8 * e },
            bottom: f64::from(self.size.1) - 4.0 * e,
        }
    }
}

/// Width of the report's figures, points.
pub const FIGURE_WIDTH: u32 = 820;

/// A diagram over the whole law: degrees, or mm of travel.
pub fn over_the_law<'a, 'c>(
    canvas: &'c Canvas<'a>,
    synthesis: &Design,
    frame: Frame,
    y: [f64; 2],
    size: f64,
) -> Result<Panel<'a, 'c>, DrawingAreaErrorKind<std::convert::Infallible>> {
    let measures = synthesis.cam.follower.measures();
    let x = ends_of(synthesis).map(|t| measures.angle().factor * t);
    match measures {
        Measures::Straight => Panel::over(canvas, frame, x, ticks(x[0], x[1], 8.0), y, size),
        _ => Panel::new(canvas, frame, x, y, size),
    }
}

pub fn ends_of(synthesis: &Design) -> [f64; 2] {
    let (start, length) = synthesis.cam.law.extent();
    [start, start + length]
}

/// Splits a frame into strips of given shares, one above the other.
pub fn strips(frame: Frame, shares: &[f64], gap: f64) -> Vec<Frame> {
    let total: f64 = shares.iter().sum();
    let free = frame.bottom - frame.top - gap * (shares.len() as f64 - 1.0);
    let mut top = frame.top;
    shares
        .iter()
        .map(|share| {
            let bottom = top + free * share / total;
            let strip = Frame {
                top,
                bottom,
                ..frame
            };
            top = bottom + gap;
            strip
        })
        .collect()
}

/// The design's name and what is shown.
pub fn title(canvas: &Canvas, layout: Layout, name: &str, what: &str) -> Drawn {
    if !layout.title {
        return Ok(());
    }
    let e = layout.letters;
    let at = [layout.frame().left, 2.2 * e];
    let big = Lettering::new(1.35 * e, INK).bold();
    write(canvas, name, at, big)?;
    // Bold runs about a tenth wider than regular.
    let after = at[0] + 1.35 * e * 1.12 * text_width(name) + 0.9 * e;
    write(
        canvas,
        what,
        [after, at[1]],
        Lettering::new(1.35 * e, QUIET),
    )
}

/// Swatches with their names, from the left.
pub fn key(
    canvas: &Canvas,
    place: [f64; 2],
    size: f64,
    entries: &[(RGBAColor, f64, &str)],
) -> Drawn {
    key_and_levels(canvas, place, size, entries, &[])
}

/// The same with dashed levels ([`Panel::level`]) after them.
pub fn key_and_levels(
    canvas: &Canvas,
    [mut x, y]: [f64; 2],
    size: f64,
    entries: &[(RGBAColor, f64, &str)],
    levels: &[(RGBAColor, &str)],
) -> Drawn {
    let levels = levels.iter().map(|&(colour, name)| (colour, None, name));
    let curves = entries
        .iter()
        .map(|&(c, width, name)| (c, Some(width), name));
    for (colour, width, name) in curves.chain(levels) {
        let ends = [[x, y], [x + 2.0 * size, y]];
        match width {
            Some(width) => line(canvas, &ends, stroke(colour, width))?,
            None => dashes(canvas, ends, colour)?,
        }
        x += 2.6 * size;
        let lettering = Lettering::new(size, INK).anchored(HPos::Left, VPos::Center);
        write(canvas, name, [x, y], lettering)?;
        x += size * text_width(name) + 1.7 * size;
    }
    Ok(())
}

/// A bar of a round length in mm, at most `room` points long, that shows the scale of a drawing.
pub fn scale_bar(canvas: &Canvas, [x, y]: [f64; 2], per_mm: f64, room: f64, size: f64) -> Drawn {
    let most = room / per_mm;
    let power = 10f64.powf(most.log10().floor());
    let length = [5.0, 2.0, 1.0]
        .into_iter()
        .map(|m| m * power)
        .find(|l| *l <= most)
        .unwrap_or(power);
    let end = x + length * per_mm;
    let tick = 0.35 * size;
    line(canvas, &[[x, y], [end, y]], stroke(INK, 2.0))?;
    for at in [x, end] {
        line(canvas, &[[at, y - tick], [at, y + tick]], stroke(INK, 2.0))?;
    }
    let lettering = Lettering::new(size, INK).anchored(HPos::Left, VPos::Center);
    let text = format!("{length} mm");
    write(canvas, &text, [end + 0.6 * size, y], lettering)
}

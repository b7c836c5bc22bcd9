//! Layout of figures, as separate files or in the report: title, frames, legend.

use plotters::prelude::*;

use super::axes::{Panel, angle_ticks, dashes, ticks};
use super::palette::{INK, QUIET};
use super::picture::Picture;
use super::sheet::{Canvas, Drawn, Frame, Lettering, line, stroke, write};
use super::text::text_width;
use gaitcam::cam::{Measures, Unit};
use gaitcam::synth::Design;
use gaitcam::wording::{Language, number};

/// Size of figures that are separate files, pixels.
pub const SIZE: (u32, u32) = (1200, 800);
/// Font size in figures that are separate files, points.
pub const LETTERS: f64 = 17.0;

/// Layout of a figure. A separate file contains the title; a figure in the report has no title.
#[derive(Debug, Clone, Copy)]
pub struct Layout {
    /// Width and height, points.
    pub size: (u32, u32),
    /// Font size, points.
    pub letters: f64,
    /// Whether the figure contains its title.
    pub title: bool,
}

impl Layout {
    /// Layout of a figure that is a separate file.
    pub const ALONE: Layout = Layout {
        size: SIZE,
        letters: LETTERS,
        title: true,
    };

    /// Layout of a figure of the given height, points, in the report.
    pub const fn figure(height: u32) -> Self {
        Layout {
            size: (FIGURE_WIDTH, height),
            letters: 13.0,
            title: false,
        }
    }

    /// Draws a picture with this layout and with the number format of a language.
    pub fn picture(self, language: Language, draw: impl FnOnce(Figure) -> Drawn) -> Picture {
        let (layout, e) = (self, self.letters);
        let (width, height) = self.size;
        Picture::drawn(width, height, |canvas| {
            draw(Figure {
                canvas,
                layout,
                e,
                language,
            })
        })
    }

    /// Frame for all diagrams of the figure, inside the margins for labels and title.
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

/// Width of figures in the report, points.
pub const FIGURE_WIDTH: u32 = 820;

/// A figure while it is being drawn.
#[derive(Clone, Copy)]
pub struct Figure<'a, 'c> {
    /// Canvas on which the figure is drawn.
    pub canvas: &'c Canvas<'a>,
    /// Layout of the figure.
    pub layout: Layout,
    /// Font size, points; one em.
    pub e: f64,
    /// Language of the numbers.
    pub language: Language,
}

/// Positions of vertical grid lines. The horizontal axis is an angle in degrees if `is_angle` is set, otherwise another quantity.
pub fn columns(x: [f64; 2], is_angle: bool) -> Vec<f64> {
    if is_angle {
        angle_ticks(x)
    } else {
        ticks(x[0], x[1], 8.0)
    }
}

pub fn ends_of(synthesis: &Design) -> [f64; 2] {
    let (start, length) = synthesis.cam.law.extent();
    [start, start + length]
}

/// Divides a frame into frames one above the other. Their heights are proportional to `shares`, with gaps of `gap` points.
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

/// Distance from the start of a line sample in the legend to the start of its name, em.
const SWATCH: f64 = 2.6;

/// Width of an entry of the legend with the name `name`, including the gap to the next entry, em.
pub fn key_width(name: &str) -> f64 {
    SWATCH + text_width(name) + 1.7
}

impl<'a, 'c> Figure<'a, 'c> {
    /// Starts a diagram with the ranges `x` and `y` and vertical grid lines at `columns`.
    pub fn panel(
        &self,
        frame: Frame,
        x: [f64; 2],
        columns: Vec<f64>,
        y: [f64; 2],
    ) -> Drawn<Panel<'a, 'c>> {
        Panel::new(self.canvas, frame, x, columns, y, self.e, self.language)
    }

    /// Starts a diagram over the whole range of the law, in degrees or in the unit of the travel.
    pub fn over_the_law(
        &self,
        synthesis: &Design,
        frame: Frame,
        y: [f64; 2],
    ) -> Drawn<Panel<'a, 'c>> {
        let measures = synthesis.cam.follower.measures();
        let x = ends_of(synthesis).map(|t| measures.angle().factor * t);
        self.panel(frame, x, columns(x, measures != Measures::Straight), y)
    }

    /// Writes text at a point of the sheet.
    pub fn write(&self, text: &str, at: [f64; 2], lettering: Lettering) -> Drawn {
        write(self.canvas, text, at, lettering)
    }

    /// Writes the name of the design and the title, if the layout includes them.
    pub fn title(&self, name: &str, what: &str) -> Drawn {
        if !self.layout.title {
            return Ok(());
        }
        let [x, y] = [self.layout.frame().left, 2.2 * self.e];
        let big = Lettering::new(1.35 * self.e, INK).bold();
        self.write(name, [x, y], big)?;
        // Bold text is about 12 % wider than regular text.
        let after = x + 1.35 * self.e * 1.12 * text_width(name) + 0.9 * self.e;
        let plain = Lettering::new(1.35 * self.e, QUIET);
        self.write(what, [after, y], plain)
    }

    /// Draws the legend of the curves: a line sample and a name for each curve, from left to right.
    pub fn key(&self, place: [f64; 2], size: f64, entries: &[(RGBAColor, f64, &str)]) -> Drawn {
        self.key_and_levels(place, size, entries, &[])
    }

    /// Draws the legend of the curves, followed by the legend of dashed lines ([`Panel::level`]).
    pub fn key_and_levels(
        &self,
        [mut x, y]: [f64; 2],
        size: f64,
        entries: &[(RGBAColor, f64, &str)],
        levels: &[(RGBAColor, &str)],
    ) -> Drawn {
        let levels = levels.iter().map(|&(colour, name)| (colour, None, name));
        let curves = (entries.iter()).map(|&(c, width, name)| (c, Some(width), name));
        let lettering = Lettering::new(size, INK);
        for (colour, width, name) in curves.chain(levels) {
            let ends = [[x, y], [x + 2.0 * size, y]];
            match width {
                Some(width) => line(self.canvas, &ends, stroke(colour, width))?,
                None => dashes(self.canvas, ends, colour)?,
            }
            x += SWATCH * size;
            self.write(name, [x, y], lettering)?;
            x += size * (key_width(name) - SWATCH);
        }
        Ok(())
    }

    /// Draws a scale bar with a round length in the displayed unit. It is at most `room` points long.
    pub fn scale_bar(&self, [x, y]: [f64; 2], per_mm: f64, room: f64) -> Drawn {
        let unit = Unit::length();
        let per_unit = per_mm * 1e3 / unit.factor;
        let most = room / per_unit;
        let power = libm::pow(10f64, libm::log10(most).floor());
        let length = [5.0, 2.0, 1.0]
            .into_iter()
            .map(|m| m * power)
            .find(|l| *l <= most)
            .unwrap_or(power);
        let end = x + length * per_unit;
        let tick = 0.35 * self.e;
        line(self.canvas, &[[x, y], [end, y]], stroke(INK, 2.0))?;
        for at in [x, end] {
            let ends = [[at, y - tick], [at, y + tick]];
            line(self.canvas, &ends, stroke(INK, 2.0))?;
        }
        let at = [end + 0.6 * self.e, y];
        let text = unit.after(&number(self.language, length));
        self.write(&text, at, Lettering::new(self.e, INK))
    }
}

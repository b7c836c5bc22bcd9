//! Figure for sets of cams: force error as a function of the number of cams.

use plotters::style::{Color, RGBAColor};

use crate::plot::axes::padded;
use crate::plot::layout::Layout;
use crate::plot::palette::{BLUE, GREEN, ORANGE};
use crate::plot::picture::Picture;
use gaitcam::wording::Language;

/// Radius of a plotted point, in points. The line of the lower bound is twice as wide.
const DOT: f64 = 4.5;

/// Curve of an error as a function of the number of cams; the curve may be empty.
#[derive(Debug, Clone)]
pub struct Curve {
    /// Name of the curve in the legend.
    pub name: String,
    /// Points of the curve: number of cams, and error in the unit of the vertical axis.
    pub points: Vec<(f64, f64)>,
}

/// Texts of the figure.
#[derive(Debug, Clone)]
pub struct CoverWords<'a> {
    /// Name of the population.
    pub name: &'a str,
    /// Title of the figure.
    pub what: &'a str,
    /// Name of the vertical axis.
    pub error: &'a str,
    /// Name of the horizontal axis.
    pub number: &'a str,
}

/// Figure with six curves over the number of cams. They are, in this order: lower bound, objective of the optimisation, mean and maximum
/// error of cross-validation, and mean and maximum error of the designed cams.
pub fn cover(words: &CoverWords, curves: &[Curve; 6], language: Language) -> Picture {
    let layout = Layout {
        size: (1200, 560),
        ..Layout::ALONE
    };
    let styles = styles();
    layout.picture(language, |f| {
        f.title(words.name, words.what)?;
        let mut frame = layout.frame();
        let entries: Vec<(RGBAColor, f64, &str)> = (styles.iter().zip(curves))
            .filter(|(_, curve)| !curve.points.is_empty())
            .map(|((colour, width), curve)| (*colour, *width, curve.name.as_str()))
            .collect();
        for line in entries.chunks(3) {
            f.key([frame.left, frame.top + 0.4 * f.e], 0.9 * f.e, line)?;
            frame.top += 1.6 * f.e;
        }
        frame.top += 0.8 * f.e;
        let all = || curves.iter().flat_map(|c| &c.points);
        let (low, high) = all().fold((f64::INFINITY, 0.0_f64), |(l, h), p| {
            (l.min(p.0), h.max(p.0))
        });
        let numbers = (low as usize..=high as usize).map(|n| n as f64).collect();
        let y = padded(all().map(|p| p.1).chain([0.0]), 0.06);
        let panel = f.panel(frame, [low - 0.3, high + 0.3], numbers, [0.0, y[1]])?;
        for ((colour, width), curve) in styles.iter().zip(curves) {
            panel.curve(&curve.points, *colour, *width)?;
            panel.dots(&curve.points, *colour, DOT)?;
        }
        panel.quantity(words.error)?;
        panel.across(words.number)
    })
}

/// Colour and width of each curve. The line of the lower bound is wide and light, because the errors may coincide with the bound.
fn styles() -> [(RGBAColor, f64); 6] {
    [
        (GREEN.mix(0.35), 9.0),
        (GREEN, 2.6),
        (BLUE.mix(0.45), 2.0),
        (ORANGE.mix(0.45), 2.0),
        (BLUE, 2.6),
        (ORANGE, 2.6),
    ]
}

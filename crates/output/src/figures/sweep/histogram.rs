//! Histogram of a quantity over many designs.

use plotters::style::Color;
use plotters_backend::text_anchor::{HPos, VPos};

use super::axes::{Axis, axes};
use super::{LETTERS, Quantity, SIZE, frame};
use crate::plot::axes::{padded, tick_text, ticks};
use crate::plot::palette::{BLUE, INK, ORANGE};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Lettering, fill, stroke, trace, write};
use crate::words;
use gaitcam::wording::Language;

/// Number of bars of a histogram.
const BARS: usize = 40;

/// Histogram of a quantity, with vertical lines at the given values, each with its name.
pub fn histogram(title: &str, q: &Quantity, levels: &[(f64, &str)], language: Language) -> Picture {
    let shown = q.values.iter().copied().chain(levels.iter().map(|l| l.0));
    let range = padded(shown, 0.03);
    let mut counts = vec![0.0_f64; BARS];
    for v in q.values.iter().filter(|v| v.is_finite()) {
        let u = (v - range[0]) / (range[1] - range[0]);
        counts[((u * BARS as f64) as usize).min(BARS - 1)] += 1.0;
    }
    let most = counts.iter().fold(1.0_f64, |m, c| m.max(*c));
    // Counts of designs are integers, so ticks at fractions are removed.
    let whole = ticks(0.0, 1.08 * most, 10.0);
    let whole = whole.into_iter().filter(|v| v.fract() == 0.0);
    let label = words::words(language).text("figure-designs");
    Picture::drawn(SIZE.0, SIZE.1, |canvas| {
        let f = frame(2.0 * LETTERS);
        let count = Axis {
            label: &label,
            range: [0.0, 1.08 * most],
            marks: whole.map(|v| (v, tick_text(v, 1.0, language))).collect(),
        };
        let inner = axes(canvas, title, f, Axis::across(q, range, f, language), count)?;
        let at = |i: usize| range[0] + (range[1] - range[0]) * i as f64 / BARS as f64;
        for (i, &c) in counts.iter().enumerate() {
            let corners = [(at(i), 0.0), (at(i + 1), 0.0), (at(i + 1), c), (at(i), c)];
            fill(&inner, &corners, BLUE.mix(0.75))?;
        }
        for (v, name) in levels {
            let level = [(*v, 0.0), (*v, 1.08 * most)];
            trace(&inner, level, stroke(ORANGE, 2.0))?;
            let x = f.left + (v - range[0]) / (range[1] - range[0]) * (f.right - f.left);
            let (side, gap) = if x > 0.5 * (f.left + f.right) {
                (HPos::Right, -0.4)
            } else {
                (HPos::Left, 0.4)
            };
            let at = [x + gap * LETTERS, f.top + LETTERS];
            let lettering = Lettering::new(LETTERS, INK).anchored(side, VPos::Center);
            write(canvas, name, at, lettering)?;
        }
        f.border(canvas)
    })
}

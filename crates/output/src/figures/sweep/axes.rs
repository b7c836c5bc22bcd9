//! Axes of figures of many designs: names, ticks and frame.

use plotters_backend::text_anchor::{HPos, VPos};

use super::{LETTERS, Quantity};
use crate::plot::axes::{tick_text, ticks};
use crate::plot::palette::{GRID, INK, QUIET};
use crate::plot::sheet::{Canvas, Drawn, Frame, Lettering, Plane, stroke, trace, write};
use crate::plot::text::text_width;
use gaitcam::wording::Language;

/// An axis: name, range of values, and positions and texts of the ticks.
pub(super) struct Axis<'a> {
    pub(super) label: &'a str,
    pub(super) range: [f64; 2],
    pub(super) marks: Vec<(f64, String)>,
}

impl<'a> Axis<'a> {
    pub(super) fn new(q: &'a Quantity, range: [f64; 2], count: f64, language: Language) -> Self {
        Axis {
            label: &q.label,
            range,
            marks: marks(q, range, count, language),
        }
    }

    pub(super) fn across(q: &'a Quantity, range: [f64; 2], f: Frame, language: Language) -> Self {
        Axis::new(q, range, (f.right - f.left) / (6.0 * LETTERS), language)
    }

    pub(super) fn up(q: &'a Quantity, range: [f64; 2], f: Frame, language: Language) -> Self {
        Axis::new(q, range, (f.bottom - f.top) / (3.5 * LETTERS), language)
    }
}

/// Draws the title, the ticks and the names of both axes. Returns the coordinate system.
pub(super) fn axes<'a>(
    canvas: &Canvas<'a>,
    title: &str,
    f: Frame,
    x: Axis,
    y: Axis,
) -> Drawn<Plane<'a>> {
    let e = LETTERS;
    let bold = Lettering::new(1.25 * e, INK).bold();
    write(canvas, title, [f.left, 2.0 * e], bold)?;
    let inner = f.plane(canvas, x.range, y.range);
    let grid = stroke(GRID, 1.0);
    for (value, text) in &x.marks {
        trace(&inner, y.range.map(|end| (*value, end)), grid)?;
        let across = f.place(x.range, y.range, (*value, y.range[0]))[0];
        let at = [across, f.bottom + 0.6 * e];
        let letters = Lettering::new(e, QUIET).anchored(HPos::Center, VPos::Top);
        write(canvas, text, at, letters)?;
    }
    for (value, text) in &y.marks {
        trace(&inner, x.range.map(|end| (end, *value)), grid)?;
        let up = f.place(x.range, y.range, (x.range[0], *value))[1];
        let at = [f.left - 0.5 * e, up];
        let letters = Lettering::new(e, QUIET).anchored(HPos::Right, VPos::Center);
        write(canvas, text, at, letters)?;
    }
    let middle = [0.5 * (f.left + f.right), 0.5 * (f.top + f.bottom)];
    let below = Lettering::new(e, INK).anchored(HPos::Center, VPos::Top);
    write(canvas, x.label, [middle[0], f.bottom + 2.3 * e], below)?;
    let left = Lettering::new(e, INK)
        .anchored(HPos::Center, VPos::Center)
        .upwards();
    let widest = y.marks.iter().map(|m| text_width(&m.1));
    let widest = widest.fold(0.0, f64::max);
    let beside = (f.left - (widest + 1.8) * e).max(1.2 * e);
    write(canvas, y.label, [beside, middle[1]], left)?;
    Ok(inner)
}

/// Positions and texts of the ticks: the words of the quantity, or about `count` round numbers.
fn marks(q: &Quantity, range: [f64; 2], count: f64, language: Language) -> Vec<(f64, String)> {
    if !q.words.is_empty() {
        let all = q.words.iter().enumerate();
        return all.map(|(i, w)| (i as f64, w.clone())).collect();
    }
    let at = ticks(range[0], range[1], count.max(2.0));
    let step = at.get(1).map_or(1.0, |b| b - at[0]);
    at.into_iter()
        .map(|v| (v, tick_text(v, step, language)))
        .collect()
}

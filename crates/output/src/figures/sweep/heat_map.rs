//! Heat map: best value of many designs as a function of two parameters.

use plotters::prelude::*;
use plotters_backend::text_anchor::{HPos, VPos};

use super::axes::{Axis, axes};
use super::{LETTERS, Quantity, SIZE, frame, shown};
use crate::plot::axes::{padded, tick_text, ticks};
use crate::plot::palette::{INK, QUIET, shade};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Canvas, Drawn, Frame, Lettering, fill, units, write};
use gaitcam::wording::Language;

/// Number of bins along an axis if the values do not form a grid.
const BINS: usize = 40;

/// Maximum number of distinct values on an axis for which the values are treated as a grid.
const GRID_VALUES: usize = 200;

/// Rule that selects one of the designs in a cell of a heat map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Best {
    /// The design with the minimum value is selected.
    Least,
    /// The design with the maximum value is selected.
    Largest,
}

impl Best {
    /// Colour of a value at the fraction `share` of the range of values. Good values have light colours.
    fn colour(self, share: f64) -> RGBAColor {
        shade(match self {
            Best::Least => 1.0 - share,
            Best::Largest => share,
        })
    }
}

/// Edges of the cells of the heat map along an axis. For a grid, they are midway between adjacent values; otherwise the cells have equal
/// width.
fn edges(values: &[f64]) -> Vec<f64> {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    match sorted.as_slice() {
        [] => vec![0.0, 1.0],
        [one] => vec![one - 0.5, one + 0.5],
        list if list.len() <= GRID_VALUES => {
            let n = list.len();
            let mut out = vec![1.5 * list[0] - 0.5 * list[1]];
            out.extend(list.windows(2).map(|w| 0.5 * (w[0] + w[1])));
            out.push(1.5 * list[n - 1] - 0.5 * list[n - 2]);
            out
        }
        list => {
            let (low, high) = (list[0], list[list.len() - 1]);
            (0..=BINS)
                .map(|i| low + (high - low) * i as f64 / BINS as f64)
                .collect()
        }
    }
}

/// Index of the cell that contains the value `v`.
fn cell(edges: &[f64], v: f64) -> usize {
    edges[1..edges.len() - 1].partition_point(|e| *e <= v)
}

/// Heat map of `z` as a function of `x` and `y`. The colour of a cell shows the best value of `z` in it. Good values are light. Cells
/// without a design remain empty.
pub fn heat_map(title: &str, [x, y, z]: [&Quantity; 3], best: Best, language: Language) -> Picture {
    let ([x, y, z], _) = shown([x, y, z]);
    let (ex, ey) = (edges(&x.values), edges(&y.values));
    let mut cells = vec![f64::INFINITY; (ex.len() - 1) * (ey.len() - 1)];
    for ((&a, &b), &c) in x.values.iter().zip(&y.values).zip(&z.values) {
        if a.is_finite() && b.is_finite() && c.is_finite() {
            let at = &mut cells[cell(&ey, b) * (ex.len() - 1) + cell(&ex, a)];
            *at = match best {
                Best::Largest if at.is_finite() => at.max(c),
                _ => at.min(c),
            };
        }
    }
    let [low, high] = padded(cells.iter().copied(), 0.0);
    let share = move |c: f64| (c - low) / (high - low);
    Picture::drawn(SIZE.0, SIZE.1, |canvas| {
        let f = frame(9.0 * LETTERS);
        let (rx, ry) = ([ex[0], ex[ex.len() - 1]], [ey[0], ey[ey.len() - 1]]);
        let (across, up) = (
            Axis::across(&x, rx, f, language),
            Axis::up(&y, ry, f, language),
        );
        let inner = axes(canvas, title, f, across, up)?;
        for (k, &c) in cells.iter().enumerate().filter(|c| c.1.is_finite()) {
            let (i, j) = (k % (ex.len() - 1), k / (ex.len() - 1));
            // Each rectangle is slightly larger than its cell, so that no gap is visible between two cells.
            let right = (ex[i + 1] + 0.001 * (rx[1] - rx[0])).min(rx[1]);
            let top = (ey[j + 1] + 0.001 * (ry[1] - ry[0])).min(ry[1]);
            let corners = [(ex[i], ey[j]), (right, ey[j]), (right, top), (ex[i], top)];
            fill(&inner, &corners, best.colour(share(c)))?;
        }
        f.border(canvas)?;
        scale(canvas, f, [low, high], &z.label, best, language)
    })
}

/// Draws the colour scale at the right of the figure.
fn scale(
    canvas: &Canvas,
    f: Frame,
    range: [f64; 2],
    label: &str,
    best: Best,
    language: Language,
) -> Drawn {
    let e = LETTERS;
    let (left, width) = (f.right + 1.2 * e, 1.3 * e);
    let steps = 64;
    for i in 0..steps {
        let at = |k: usize| f.bottom + (f.top - f.bottom) * k as f64 / steps as f64;
        let corners = [
            (units(left), units(at(i + 1))),
            (units(left + width), units(at(i)) + 1),
        ];
        let colour = best.colour(i as f64 / (steps - 1) as f64).filled();
        canvas.draw(&Rectangle::new(corners, colour))?;
    }
    let marks = ticks(range[0], range[1], 5.0);
    let step = marks.get(1).map_or(1.0, |next| next - marks[0]);
    for mark in marks {
        let share = (mark - range[0]) / (range[1] - range[0]);
        let at = [
            left + width + 0.4 * e,
            f.bottom + (f.top - f.bottom) * share,
        ];
        let text = tick_text(mark, step, language);
        write(canvas, &text, at, Lettering::new(0.9 * e, QUIET))?;
    }
    let letters = Lettering::new(e, INK)
        .anchored(HPos::Center, VPos::Center)
        .upwards();
    let at = [f64::from(SIZE.0) - 1.1 * e, 0.5 * (f.top + f.bottom)];
    write(canvas, label, at, letters)
}

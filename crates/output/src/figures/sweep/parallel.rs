//! Parallel coordinates: each design is a line across several parallel axes.

use plotters::style::{Color, WHITE};
use plotters_backend::text_anchor::{HPos, VPos};

use super::{LETTERS, Quantity, SIZE};
use crate::plot::axes::padded;
use crate::plot::palette::{AXIS, BLUE, INK, QUIET, RED};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Canvas, Drawn, Frame, Lettering, line, rectangle, stroke, write};
use crate::plot::text::text_width;
use gaitcam::wording::{Language, number};

/// Figure with one line per design across parallel axes. Each axis extends from the minimum to the maximum value. Designs on the front are
/// blue, and the best design is red.
pub fn parallel(
    title: &str,
    quantities: &[Quantity],
    on_front: &[usize],
    best: Option<usize>,
    language: Language,
) -> Picture {
    let quantities: Vec<Quantity> = quantities.iter().map(|q| q.shown().0).collect();
    let ranges: Vec<[f64; 2]> = quantities
        .iter()
        .map(|q| padded(q.values.iter().copied(), 0.0))
        .collect();
    Picture::drawn(SIZE.0, SIZE.1, |canvas| {
        let e = LETTERS;
        let f = Frame {
            left: 5.0 * e,
            right: f64::from(SIZE.0) - 5.0 * e,
            top: 7.0 * e,
            bottom: f64::from(SIZE.1) - 3.0 * e,
        };
        let bold = Lettering::new(1.25 * e, INK).bold();
        write(canvas, title, [2.0 * e, 2.0 * e], bold)?;
        let last = quantities.len().saturating_sub(1).max(1) as f64;
        let across = |k: usize| f.left + (f.right - f.left) * k as f64 / last;
        let up = |k: usize, v: f64| {
            let [low, high] = ranges[k];
            f.bottom + (f.top - f.bottom) * (v - low) / (high - low)
        };
        let path = |row: usize| -> Option<Vec<[f64; 2]>> {
            (0..quantities.len())
                .map(|k| {
                    let v = *quantities[k].values.get(row)?;
                    v.is_finite().then(|| [across(k), up(k, v)])
                })
                .collect()
        };
        let rows = quantities.first().map_or(0, |q| q.values.len());
        for points in (0..rows).filter_map(path) {
            line(canvas, &points, stroke(AXIS.mix(0.25), 0.8))?;
        }
        for points in on_front.iter().filter_map(|&r| path(r)) {
            line(canvas, &points, stroke(BLUE.mix(0.8), 1.4))?;
        }
        if let Some(points) = best.and_then(path) {
            line(canvas, &points, stroke(RED, 2.6))?;
        }
        for (k, q) in quantities.iter().enumerate() {
            let x = across(k);
            line(canvas, &[[x, f.bottom], [x, f.top]], stroke(INK, 1.2))?;
            heading(canvas, q, x, k)?;
            for (v, text) in ends(q, ranges[k], language) {
                let (half, y) = (0.55 * e * text_width(&text), up(k, v));
                let corners = [[x - half, y - 0.6 * e], [x + half, y + 0.6 * e]];
                rectangle(canvas, corners, WHITE.mix(0.8).filled())?;
                let letters = Lettering::new(0.9 * e, QUIET).anchored(HPos::Center, VPos::Center);
                write(canvas, &text, [x, y], letters)?;
            }
        }
        Ok(())
    })
}

/// Draws the name of an axis with its unit in parentheses. Adjacent names have different heights, so that long names do not overlap.
fn heading(canvas: &Canvas, q: &Quantity, x: f64, k: usize) -> Drawn {
    let e = LETTERS;
    let (name, unit) = q.label.rsplit_once(", ").unwrap_or((&q.label, ""));
    let y = if k.is_multiple_of(2) {
        3.6 * e
    } else {
        5.0 * e
    };
    let text = if unit.is_empty() {
        name.to_string()
    } else {
        format!("{name} ({unit})")
    };
    let half = 0.5 * 0.9 * e * text_width(&text);
    let x = x.clamp(half + 0.5 * e, f64::from(SIZE.0) - half - 0.5 * e);
    let letters = Lettering::new(0.9 * e, INK).anchored(HPos::Center, VPos::Center);
    write(canvas, &text, [x, y], letters)
}

fn ends(q: &Quantity, range: [f64; 2], language: Language) -> Vec<(f64, String)> {
    if q.words.is_empty() {
        return range.map(|v| (v, number(language, v))).to_vec();
    }
    q.words
        .iter()
        .enumerate()
        .map(|(i, w)| (i as f64, w.clone()))
        .collect()
}

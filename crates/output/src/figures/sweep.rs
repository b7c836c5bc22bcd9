//! Pictures of many designs: heat map, parallel coordinates, fronts, histograms. Plain numbers in.

use plotters::prelude::*;
use plotters_backend::text_anchor::{HPos, VPos};

use crate::number::number;
use crate::plot::axes::{Frame, padded, tick_text, ticks};
use crate::plot::palette::{AXIS, BLUE, GRID, INK, ORANGE, QUIET, RED};
use crate::plot::picture::Picture;
use crate::plot::raster::text_width;
use crate::plot::sheet::{Canvas, Drawn, Lettering, Plane, line, plane, stroke, units, write};
use crate::words::Words;
use gaitcam::wording::Language;

/// Size of the pictures, points.
const SIZE: (u32, u32) = (1100, 720);
/// Lettering, points.
const LETTERS: f64 = 16.0;
/// Bins across a heat map of scattered points.
const BINS: usize = 40;
/// More distinct values than this on an axis are scattered, not a grid.
const GRID_VALUES: usize = 200;

/// A column with its name and unit for people.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// `limits.stroke, m`.
    pub label: String,
    /// One value per design; those that are not finite are left out of the picture.
    pub values: Vec<f64>,
    /// Names of the values 0, 1, 2 … where they are words.
    pub words: Vec<String>,
}

/// SI units of labels with the ones that people use and the factor between them.
const SHOWN: [(&str, &str, f64); 6] = [
    ("m", "mm", 1e3),
    ("m/rad", "mm/rad", 1e3),
    ("m/rad²", "mm/rad²", 1e3),
    ("m/rad³", "mm/rad³", 1e3),
    ("rad", "°", 180.0 / std::f64::consts::PI),
    ("Pa", "MPa", 1e-6),
];

/// A label in the unit that people use, and SI's factor to it: `stroke, m` is read as `stroke, mm`.
pub fn unit_for_people(label: &str) -> (String, f64) {
    let found = label.rsplit_once(", ").and_then(|(name, unit)| {
        let row = SHOWN.iter().find(|row| row.0 == unit)?;
        Some((name, row))
    });
    match found {
        Some((name, (_, unit, factor))) => (format!("{name}, {unit}"), *factor),
        None => (label.to_string(), 1.0),
    }
}

/// Which of several designs in one cell of a heat map counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Best {
    /// The one with the least value.
    Least,
    /// The one with the largest.
    Largest,
}

impl Quantity {
    /// The same in the unit that people use, and the factor to it.
    fn shown(&self) -> (Quantity, f64) {
        let (label, factor) = unit_for_people(&self.label);
        let shown = Quantity {
            label,
            values: self.values.iter().map(|v| factor * v).collect(),
            words: self.words.clone(),
        };
        (shown, factor)
    }
}

/// Colours from low (dark blue) to high (yellow), in even steps of lightness: five stops of viridis.
fn shade(u: f64) -> RGBAColor {
    const STOPS: [[f64; 3]; 5] = [
        [68.0, 1.0, 84.0],
        [59.0, 82.0, 139.0],
        [33.0, 145.0, 140.0],
        [94.0, 201.0, 98.0],
        [253.0, 231.0, 37.0],
    ];
    let x = u.clamp(0.0, 1.0) * 4.0;
    let i = (x as usize).min(3);
    let mix = |k: usize| (STOPS[i][k] + (x - i as f64) * (STOPS[i + 1][k] - STOPS[i][k])) as u8;
    RGBAColor(mix(0), mix(1), mix(2), 1.0)
}

fn frame(right_room: f64) -> Frame {
    Frame {
        left: 7.6 * LETTERS,
        right: f64::from(SIZE.0) - right_room,
        top: 4.2 * LETTERS,
        bottom: f64::from(SIZE.1) - 4.6 * LETTERS,
    }
}

/// An axis: its name, its ends, and the places that are marked, with their text.
struct Axis<'a> {
    label: &'a str,
    range: [f64; 2],
    marks: Vec<(f64, String)>,
}

impl<'a> Axis<'a> {
    fn new(q: &'a Quantity, range: [f64; 2], count: f64) -> Self {
        Axis {
            label: &q.label,
            range,
            marks: marks(q, range, count),
        }
    }

    fn across(q: &'a Quantity, range: [f64; 2], f: Frame) -> Self {
        Axis::new(q, range, (f.right - f.left) / (6.0 * LETTERS))
    }

    fn up(q: &'a Quantity, range: [f64; 2], f: Frame) -> Self {
        Axis::new(q, range, (f.bottom - f.top) / (3.5 * LETTERS))
    }
}

/// Title, frame, ticks and names of both axes.
fn axes<'a>(
    canvas: &Canvas<'a>,
    title: &str,
    f: Frame,
    x: Axis,
    y: Axis,
) -> Result<Plane<'a>, DrawingAreaErrorKind<std::convert::Infallible>> {
    let e = LETTERS;
    write(
        canvas,
        title,
        [f.left, 2.0 * e],
        Lettering::new(1.25 * e, INK).bold(),
    )?;
    let inner = plane(
        canvas,
        x.range,
        y.range,
        [f.left, f.right],
        [f.bottom, f.top],
    );
    let grid = stroke(GRID, 1.0);
    for (value, text) in &x.marks {
        let ends = y.range.map(|end| (*value, end));
        inner.draw(&PathElement::new(ends, grid))?;
        let share = (value - x.range[0]) / (x.range[1] - x.range[0]);
        let at = [f.left + share * (f.right - f.left), f.bottom + 0.6 * e];
        let letters = Lettering::new(e, QUIET).anchored(HPos::Center, VPos::Top);
        write(canvas, text, at, letters)?;
    }
    for (value, text) in &y.marks {
        let ends = x.range.map(|end| (end, *value));
        inner.draw(&PathElement::new(ends, grid))?;
        let share = (value - y.range[0]) / (y.range[1] - y.range[0]);
        let at = [f.left - 0.5 * e, f.bottom + share * (f.top - f.bottom)];
        let letters = Lettering::new(e, QUIET).anchored(HPos::Right, VPos::Center);
        write(canvas, text, at, letters)?;
    }
    let middle = [0.5 * (f.left + f.right), 0.5 * (f.top + f.bottom)];
    let below = Lettering::new(e, INK).anchored(HPos::Center, VPos::Top);
    write(canvas, x.label, [middle[0], f.bottom + 2.3 * e], below)?;
    let beside = Lettering::new(e, INK)
        .anchored(HPos::Center, VPos::Center)
        .upwards();
    write(canvas, y.label, [1.2 * e, middle[1]], beside)?;
    Ok(inner)
}

fn border(canvas: &Canvas, f: Frame) -> Drawn {
    let corners = [
        [f.left, f.top],
        [f.right, f.top],
        [f.right, f.bottom],
        [f.left, f.bottom],
        [f.left, f.top],
    ];
    line(canvas, &corners, stroke(AXIS, 1.0))
}

/// Where an axis is marked, and with what.
fn marks(q: &Quantity, range: [f64; 2], count: f64) -> Vec<(f64, String)> {
    if !q.words.is_empty() {
        let all = q.words.iter().enumerate();
        return all.map(|(i, w)| (i as f64, w.clone())).collect();
    }
    let at = ticks(range[0], range[1], count.max(2.0));
    let step = at.get(1).map_or(1.0, |b| b - at[0]);
    at.into_iter().map(|v| (v, tick_text(v, step))).collect()
}

/// Edges of the cells of an axis: halfway between the values of a grid, or even bins.
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

/// Index of the cell that holds `v`.
fn cell(edges: &[f64], v: f64) -> usize {
    edges[1..edges.len() - 1].partition_point(|e| *e <= v)
}

/// Several quantities in the units that people use, with the factors to them.
fn shown<const N: usize>(all: [&Quantity; N]) -> ([Quantity; N], [f64; N]) {
    let both = all.map(Quantity::shown);
    let factors = both.each_ref().map(|b| b.1);
    (both.map(|b| b.0), factors)
}

/// The best value of `z` over two parameters, as colour; cells without a design stay blank.
pub fn heat_map(title: &str, x: &Quantity, y: &Quantity, z: &Quantity, best: Best) -> Picture {
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
        let inner = axes(
            canvas,
            title,
            f,
            Axis::across(&x, rx, f),
            Axis::up(&y, ry, f),
        )?;
        for (k, &c) in cells.iter().enumerate().filter(|c| c.1.is_finite()) {
            let (i, j) = (k % (ex.len() - 1), k / (ex.len() - 1));
            // A little wider than the cell, so that no ground shines through between two.
            let right = (ex[i + 1] + 0.001 * (rx[1] - rx[0])).min(rx[1]);
            let top = (ey[j + 1] + 0.001 * (ry[1] - ry[0])).min(ry[1]);
            let corners = vec![(ex[i], ey[j]), (right, ey[j]), (right, top), (ex[i], top)];
            inner.draw(&Polygon::new(corners, shade(share(c)).filled()))?;
        }
        border(canvas, f)?;
        scale(canvas, f, [low, high], &z.label)
    })
}

/// The colour scale right of a picture.
fn scale(canvas: &Canvas, f: Frame, range: [f64; 2], label: &str) -> Drawn {
    let e = LETTERS;
    let (left, width) = (f.right + 1.2 * e, 1.3 * e);
    let steps = 64;
    for i in 0..steps {
        let at = |k: usize| f.bottom + (f.top - f.bottom) * k as f64 / steps as f64;
        let corners = [
            (units(left), units(at(i + 1))),
            (units(left + width), units(at(i)) + 1),
        ];
        canvas.draw(&Rectangle::new(
            corners,
            shade(i as f64 / (steps - 1) as f64).filled(),
        ))?;
    }
    for k in 0..=4 {
        let share = f64::from(k) / 4.0;
        let at = [
            left + width + 0.4 * e,
            f.bottom + (f.top - f.bottom) * share,
        ];
        let text = number(range[0] + share * (range[1] - range[0]), 3);
        write(canvas, &text, at, Lettering::new(0.9 * e, QUIET))?;
    }
    let letters = Lettering::new(e, INK)
        .anchored(HPos::Center, VPos::Center)
        .upwards();
    let at = [f64::from(SIZE.0) - 1.1 * e, 0.5 * (f.top + f.bottom)];
    write(canvas, label, at, letters)
}

/// All designs as dots, the front as a line through its dots; `front` are indices into the values.
pub fn front(
    title: &str,
    x: &Quantity,
    y: &Quantity,
    on_front: &[(f64, f64)],
    best: Option<(f64, f64)>,
) -> Picture {
    let ([x, y], [fx, fy]) = shown([x, y]);
    let scaled = |&(a, b): &(f64, f64)| (fx * a, fy * b);
    let on_front: Vec<(f64, f64)> = on_front.iter().map(scaled).collect();
    let best = best.as_ref().map(scaled);
    let all = |q: &Quantity, own: &dyn Fn(&(f64, f64)) -> f64| {
        let mut v = q.values.clone();
        v.extend(on_front.iter().map(own));
        padded(v.into_iter(), 0.05)
    };
    let (rx, ry) = (all(&x, &|p| p.0), all(&y, &|p| p.1));
    Picture::drawn(SIZE.0, SIZE.1, |canvas| {
        let f = frame(2.0 * LETTERS);
        let inner = axes(
            canvas,
            title,
            f,
            Axis::across(&x, rx, f),
            Axis::up(&y, ry, f),
        )?;
        for (&a, &b) in x.values.iter().zip(&y.values) {
            if a.is_finite() && b.is_finite() {
                inner.draw(&Circle::new((a, b), units(2.0), AXIS.filled()))?;
            }
        }
        inner.draw(&PathElement::new(on_front.clone(), stroke(BLUE, 1.6)))?;
        for &p in &on_front {
            inner.draw(&Circle::new(p, units(3.6), BLUE.filled()))?;
        }
        if let Some(p) = best {
            inner.draw(&Circle::new(p, units(6.5), stroke(RED, 2.4)))?;
        }
        border(canvas, f)
    })
}

/// One line per design over parallel axes, each from its smallest to its largest value; designs on the
/// front in colour, the best in red.
pub fn parallel(
    title: &str,
    quantities: &[Quantity],
    on_front: &[usize],
    best: Option<usize>,
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
        write(
            canvas,
            title,
            [2.0 * e, 2.0 * e],
            Lettering::new(1.25 * e, INK).bold(),
        )?;
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
            for (v, text) in ends(q, ranges[k]) {
                let ground_half = 0.55 * e * text_width(&text);
                let y = up(k, v);
                let corners = [
                    (units(x - ground_half), units(y - 0.6 * e)),
                    (units(x + ground_half), units(y + 0.6 * e)),
                ];
                canvas.draw(&Rectangle::new(corners, WHITE.mix(0.8).filled()))?;
                let letters = Lettering::new(0.9 * e, QUIET).anchored(HPos::Center, VPos::Center);
                write(canvas, &text, [x, y], letters)?;
            }
        }
        Ok(())
    })
}

/// The name of an axis, its unit below; neighbours stand at two heights, so that long names do not meet.
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

fn ends(q: &Quantity, range: [f64; 2]) -> Vec<(f64, String)> {
    if q.words.is_empty() {
        return range.map(|v| (v, number(v, 3))).to_vec();
    }
    q.words
        .iter()
        .enumerate()
        .map(|(i, w)| (i as f64, w.clone()))
        .collect()
}

/// Bars of a histogram.
const BARS: usize = 40;

/// How often each value occurs, with levels drawn across.
pub fn histogram(title: &str, q: &Quantity, levels: &[(f64, &str)], language: Language) -> Picture {
    let wanted = q.values.iter().copied().chain(levels.iter().map(|l| l.0));
    let range = padded(wanted, 0.03);
    let mut counts = vec![0.0_f64; BARS];
    for v in q.values.iter().filter(|v| v.is_finite()) {
        let u = (v - range[0]) / (range[1] - range[0]);
        counts[((u * BARS as f64) as usize).min(BARS - 1)] += 1.0;
    }
    let most = counts.iter().fold(1.0_f64, |m, c| m.max(*c));
    // Designs are counted whole.
    let whole = ticks(0.0, 1.08 * most, 10.0);
    let whole = whole.into_iter().filter(|v| v.fract() == 0.0);
    let label = Words::new(language).text("figure-designs");
    Picture::drawn(SIZE.0, SIZE.1, |canvas| {
        let f = frame(2.0 * LETTERS);
        let count = Axis {
            label: &label,
            range: [0.0, 1.08 * most],
            marks: whole.map(|v| (v, tick_text(v, 1.0))).collect(),
        };
        let inner = axes(canvas, title, f, Axis::across(q, range, f), count)?;
        let at = |i: usize| range[0] + (range[1] - range[0]) * i as f64 / BARS as f64;
        for (i, &c) in counts.iter().enumerate() {
            let corners = vec![(at(i), 0.0), (at(i + 1), 0.0), (at(i + 1), c), (at(i), c)];
            inner.draw(&Polygon::new(corners, BLUE.mix(0.75).filled()))?;
        }
        for (v, name) in levels {
            inner.draw(&PathElement::new(
                [(*v, 0.0), (*v, 1.08 * most)],
                stroke(ORANGE, 2.0),
            ))?;
            let x = f.left + (v - range[0]) / (range[1] - range[0]) * (f.right - f.left);
            let h = if x > 0.5 * (f.left + f.right) {
                HPos::Right
            } else {
                HPos::Left
            };
            let gap = if matches!(h, HPos::Right) { -0.4 } else { 0.4 } * LETTERS;
            write(
                canvas,
                name,
                [x + gap, f.top + LETTERS],
                Lettering::new(LETTERS, INK).anchored(h, VPos::Center),
            )?;
        }
        border(canvas, f)
    })
    .in_language(language)
}

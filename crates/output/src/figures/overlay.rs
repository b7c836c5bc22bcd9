//! Several designs in one figure: overlaid diagrams over the cam angle, and overlaid profiles.

use plotters::style::{Color, RGBAColor};

use crate::plot::axes::padded;
use crate::plot::layout::{LETTERS, Layout, columns, key_width, strips};
use crate::plot::palette::{BLUE, GREEN, INK, ORANGE, PURPLE, RED};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Frame, circle, stroke, trace};
use gaitcam::cam::Measures;
use gaitcam::wording::Language;

/// Colours of the designs. They repeat after twelve designs.
const COLOURS: [RGBAColor; 12] = [
    BLUE,
    ORANGE,
    GREEN,
    RED,
    PURPLE,
    INK,
    RGBAColor(86, 180, 233, 1.0),
    RGBAColor(140, 108, 0, 1.0),
    RGBAColor(120, 200, 80, 1.0),
    RGBAColor(240, 150, 150, 1.0),
    RGBAColor(90, 60, 160, 1.0),
    RGBAColor(140, 146, 155, 1.0),
];

/// A diagram: name of its quantity, and one curve of (degrees, value) for each design.
#[derive(Debug, Clone)]
pub struct Strip {
    /// Name of the quantity with its unit.
    pub quantity: String,
    /// One curve for each design; an empty curve is not drawn.
    pub curves: Vec<Vec<(f64, f64)>>,
}

/// Style of the curves of a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Look {
    /// A line.
    Line,
    /// A wide pale line, on which a later curve with the same values remains visible.
    Wide,
    /// Separate dots.
    Dots,
}

impl Look {
    /// Colour and width of the line in the legend. Dots have no line.
    fn sample(self, colour: RGBAColor) -> (RGBAColor, f64) {
        match self {
            Look::Line => (colour, 2.6),
            Look::Wide => (colour.mix(0.35), 8.0),
            Look::Dots => (colour.mix(0.0), 2.6),
        }
    }
}

/// Radius of dots, points.
const DOT: f64 = 5.0;

/// Diagrams over the cam angle, one above the other. Each design has one colour in all diagrams; colours repeat after twelve designs.
pub fn diagrams(head: &str, what: &str, names: &[String], rows: &[Strip]) -> Picture {
    let across = Measures::Translating.angle_words();
    diagrams_over(across, head, what, names, rows, Language::En)
}

/// Diagrams over the cam angle, one above the other. `looks` contains the style of each design; the rest are lines.
pub fn diagrams_with(
    looks: &[Look],
    head: &str,
    what: &str,
    names: &[String],
    rows: &[Strip],
) -> Picture {
    let across = Measures::Translating.angle_words();
    drawn(across, looks, [head, what], names, rows, Language::En)
}

/// Diagrams over any quantity, one above the other. `across` is the name of the quantity on the horizontal axis.
pub fn diagrams_over(
    across: &str,
    head: &str,
    what: &str,
    names: &[String],
    rows: &[Strip],
    language: Language,
) -> Picture {
    drawn(across, &[], [head, what], names, rows, language)
}

fn drawn(
    across: &str,
    looks: &[Look],
    [head, what]: [&str; 2],
    names: &[String],
    rows: &[Strip],
    language: Language,
) -> Picture {
    let colour = |i: usize| COLOURS[i % COLOURS.len()];
    let look = |i: usize| looks.get(i).copied().unwrap_or(Look::Line);
    let rows: Vec<Strip> = rows
        .iter()
        .map(|row| Strip {
            quantity: row.quantity.clone(),
            curves: row.curves.iter().map(|c| whole(c)).collect(),
        })
        .collect();
    let entries: Vec<(RGBAColor, f64, &str)> = names
        .iter()
        .enumerate()
        .map(|(i, n)| {
            let (colour, width) = look(i).sample(colour(i));
            (colour, width, n.as_str())
        })
        .collect();
    let frame = Layout::ALONE.frame();
    let lines = lines(&entries, (frame.right - frame.left) / (0.9 * LETTERS));
    // If the names do not fit three to a line, the figure is made higher.
    let more = 1.6 * LETTERS * (lines.len() - names.len().div_ceil(3)) as f64;
    let layout = Layout {
        size: (1200, 300 + 260 * rows.len().max(1) as u32 + more as u32),
        ..Layout::ALONE
    };
    layout.picture(language, |f| {
        let e = f.e;
        f.title(head, what)?;
        let mut frame = layout.frame();
        let mut first = 0;
        for line in &lines {
            let at = [frame.left, frame.top + 0.4 * e];
            f.key(at, 0.9 * e, line)?;
            for (k, x) in samples(line, at[0], 0.9 * e).enumerate() {
                if look(first + k) == Look::Dots {
                    circle(f.canvas, [x, at[1]], DOT, colour(first + k).filled())?;
                }
            }
            first += line.len();
            frame.top += 1.6 * e;
        }
        frame.top += 0.8 * e;
        let frames = strips(frame, &vec![1.0; rows.len()], 0.9 * e);
        let all = rows.iter().flat_map(|r| &r.curves).flatten();
        let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| {
            (l.min(p.0), h.max(p.0))
        });
        let x = if low < high {
            [low, high]
        } else {
            [0.0, 360.0]
        };
        for (k, row) in rows.iter().enumerate() {
            let y = padded(row.curves.iter().flatten().map(|p| p.1), 0.08);
            let panel = f.panel(frames[k], x, columns(x, across.contains('θ')), y)?;
            for (i, curve) in row.curves.iter().enumerate().filter(|c| !c.1.is_empty()) {
                match look(i) {
                    Look::Line => panel.curve(curve, colour(i), 2.2)?,
                    Look::Wide => panel.curve(curve, colour(i).mix(0.35), 8.0)?,
                    Look::Dots => panel.dots(curve, colour(i), DOT)?,
                }
            }
            panel.quantity(&row.quantity)?;
            if k + 1 == rows.len() {
                panel.across(across)?;
            }
        }
        Ok(())
    })
}

/// Horizontal positions of the middles of the line samples in a line of the legend, which starts at `left` with letters of the given size.
fn samples(line: &[(RGBAColor, f64, &str)], left: f64, size: f64) -> impl Iterator<Item = f64> {
    line.iter().scan(left, move |x, entry| {
        let middle = *x + size;
        *x += size * key_width(entry.2);
        Some(middle)
    })
}

/// Divides the entries of the legend into lines of at most three entries and at most `room` em.
fn lines<'a>(
    entries: &'a [(RGBAColor, f64, &'a str)],
    room: f64,
) -> Vec<&'a [(RGBAColor, f64, &'a str)]> {
    let mut lines = Vec::new();
    let mut rest = entries;
    while !rest.is_empty() {
        let long = |n: usize| rest[..n].iter().map(|e| key_width(e.2)).sum::<f64>();
        let count = (2..=rest.len().min(3)).rev().find(|&n| long(n) <= room);
        let (line, after) = rest.split_at(count.unwrap_or(1));
        lines.push(line);
        rest = after;
    }
    lines
}

/// Copy of a curve for drawing. If the curve covers whole turns, its first value is repeated at its end.
fn whole(curve: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut out = curve.to_vec();
    if let ([first, ..], [.., before, last]) = (curve, curve) {
        let end = last.0 + (last.0 - before.0);
        let turns = (end - first.0) / 360.0;
        if turns > 0.5 && (turns - turns.round()).abs() < 1e-6 {
            out.push((first.0 + 360.0 * turns.round(), first.1));
        }
    }
    out
}

/// Profiles at equal scale about a common centre. `curves` contains points in m.
pub fn profiles(
    head: &str,
    what: &str,
    names: &[String],
    curves: &[Vec<[f64; 2]>],
    language: Language,
) -> Picture {
    let layout = Layout {
        size: (1200, 1000),
        ..Layout::ALONE
    };
    layout.picture(language, |f| {
        let e = f.e;
        f.title(head, what)?;
        for (i, name) in names.iter().enumerate() {
            let entry = [(COLOURS[i % COLOURS.len()], 2.6, name.as_str())];
            let y = (5.0 + 1.6 * i as f64) * e;
            f.key([2.0 * e, y], 0.9 * e, &entry)?;
        }
        let bounds = |k: usize| {
            let values = curves.iter().flatten().map(|p| 1e3 * p[k]);
            padded(values.chain([0.0]), 0.05)
        };
        let (across, up) = (bounds(0), bounds(1));
        let (width, height) = (f64::from(layout.size.0), f64::from(layout.size.1));
        let widest = names.iter().map(|n| key_width(n)).fold(0.0, f64::max);
        let frame = Frame {
            left: (2.0 * e + 0.9 * e * widest).clamp(0.25 * width, 0.6 * width),
            right: width - e,
            top: 4.6 * e,
            bottom: height - e,
        };
        let room = [frame.right - frame.left, frame.bottom - frame.top];
        let scale = (room[0] / (across[1] - across[0])).min(room[1] / (up[1] - up[0]));
        let spread = |[low, high]: [f64; 2], room: f64| {
            let (middle, half) = (0.5 * (low + high), 0.5 * room / scale);
            [middle - half, middle + half]
        };
        let plane = frame.plane(f.canvas, spread(across, room[0]), spread(up, room[1]));
        for (i, curve) in curves.iter().enumerate() {
            let path: Vec<(f64, f64)> = curve.iter().map(|p| (1e3 * p[0], 1e3 * p[1])).collect();
            trace(&plane, path, stroke(COLOURS[i % COLOURS.len()], 2.2))?;
        }
        let cross = 0.04 * (across[1] - across[0]);
        for path in [[(-cross, 0.0), (cross, 0.0)], [(0.0, -cross), (0.0, cross)]] {
            trace(&plane, path, stroke(INK, 1.4))?;
        }
        f.scale_bar([2.0 * e, height - 2.0 * e], scale, 0.18 * width)
    })
}

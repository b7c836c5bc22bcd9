//! Figure of a Pareto front.

use plotters::prelude::*;
use plotters_backend::text_anchor::{HPos, VPos};

use super::axes::{Axis, axes};
use super::{LETTERS, Quantity, SIZE, frame, shown};
use crate::plot::axes::{dashes, padded};
use crate::plot::palette::{AXIS, BLUE, INK, RED};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Canvas, Drawn, Frame, Lettering, circle, stroke, trace, units, write};
use crate::plot::text::text_width;
use crate::words::{self, Words};
use gaitcam::wording::Language;

/// Figure of two objectives: all designs as dots, the front as larger dots, and the best design with a ring. Without a best design, the
/// front is a computed curve, and its dots are connected by a line. The designs of a table are not connected, because there are no designs
/// between them. `limit` is the permitted value of `y`, in SI units, which is drawn as a dashed line.
pub fn front(
    title: &str,
    x: &Quantity,
    y: &Quantity,
    on_front: &[(f64, f64)],
    best: Option<(f64, f64)>,
    limit: Option<f64>,
    language: Language,
) -> Picture {
    let ([x, y], [fx, fy]) = shown([x, y]);
    let scaled = |&(a, b): &(f64, f64)| (fx * a, fy * b);
    let on_front: Vec<(f64, f64)> = on_front.iter().map(scaled).collect();
    let best = best.as_ref().map(scaled);
    let words = words::words(language);
    let all = |q: &Quantity, own: &dyn Fn(&(f64, f64)) -> f64| {
        let mut v = q.values.clone();
        v.extend(on_front.iter().map(own));
        padded(v.into_iter(), 0.05)
    };
    let (rx, ry) = (all(&x, &|p| p.0), all(&y, &|p| p.1));
    Picture::drawn(SIZE.0, SIZE.1, |canvas| {
        let all = frame(2.0 * LETTERS);
        let top = all.top + best.map_or(0.0, |_| LETTERS);
        let f = Frame { top, ..all };
        let (across, up) = (
            Axis::across(&x, rx, f, language),
            Axis::up(&y, ry, f, language),
        );
        let inner = axes(canvas, title, f, across, up)?;
        for (&a, &b) in x.values.iter().zip(&y.values) {
            if a.is_finite() && b.is_finite() {
                inner.draw(&Circle::new((a, b), units(2.0), AXIS.filled()))?;
            }
        }
        if let Some(limit) = limit.map(|l| fy * l) {
            let level = Level {
                value: limit,
                unit: y.label.rsplit_once(", ").map_or("", |label| label.1),
            };
            level.draw(canvas, f, [rx, ry], &on_front, &words)?;
        }
        if best.is_none() {
            trace(&inner, on_front.as_slice(), stroke(BLUE, 1.6))?;
        }
        for &p in &on_front {
            inner.draw(&Circle::new(p, units(3.6), BLUE.filled()))?;
        }
        if let Some(p) = best {
            inner.draw(&Circle::new(p, units(6.5), stroke(RED, 2.4)))?;
        }
        let mut left = f.left;
        let dots = [
            ("figure-designs", 2.0, AXIS.filled()),
            ("figure-non-dominated", 3.6, BLUE.filled()),
            ("figure-best", 6.5, stroke(RED, 2.4)),
        ];
        // A figure with only the points of the front needs no legend.
        for (key, radius, style) in dots.into_iter().filter(|_| best.is_some()) {
            let (text, up) = (words.text(key), f.top - 0.9 * LETTERS);
            circle(canvas, [left + 6.5, up], radius, style)?;
            let lettering = Lettering::new(LETTERS, INK);
            write(canvas, &text, [left + 1.4 * LETTERS, up], lettering)?;
            left += (2.9 + text_width(&text)) * LETTERS;
        }
        f.border(canvas)
    })
}

/// Permitted value of the vertical axis, in the displayed unit.
struct Level<'a> {
    value: f64,
    unit: &'a str,
}

impl Level<'_> {
    /// Draws a dashed line with the value, if the value is in the range of the axis. The text is at the end that is farther from the minimum
    /// of the front.
    fn draw(
        &self,
        canvas: &Canvas,
        f: Frame,
        [x, y]: [[f64; 2]; 2],
        on_front: &[(f64, f64)],
        words: &Words,
    ) -> Drawn {
        if !(self.value > y[0] && self.value < y[1]) {
            return Ok(());
        }
        let [left, right] = x.map(|end| f.place(x, y, (end, self.value)));
        dashes(canvas, [left, right], RED)?;
        let lowest = on_front.iter().min_by(|a, b| a.1.total_cmp(&b.1));
        let (at, side) = match lowest {
            Some(p) if p.0 < 0.5 * (x[0] + x[1]) => (right[0] - 0.5 * LETTERS, HPos::Right),
            _ => (left[0] + 0.5 * LETTERS, HPos::Left),
        };
        let value = format!("{} {}", words.number(self.value), self.unit);
        let text = words.fill("figure-limit", &[("value", value.trim_end())]);
        let lettering = Lettering::new(0.88 * LETTERS, INK).anchored(side, VPos::Bottom);
        write(canvas, &text, [at, left[1] - 0.4 * LETTERS], lettering)
    }
}

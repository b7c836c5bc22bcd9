//! Diagram over the cam angle or another quantity: frame, grid, curves, marked extremes.

use plotters::prelude::*;
use plotters_backend::text_anchor::{HPos, VPos};

use crate::plot::palette;
use crate::plot::sheet::{
    Canvas, Drawn, Frame, Lettering, Plane, circle, dashed, fill, line, rectangle, stroke, trace,
    write,
};
use crate::plot::text::text_width;
use gaitcam::wording::{Language, fixed, number};

/// A diagram of a quantity on the vertical axis. The horizontal axis is the cam angle in degrees or another quantity.
pub struct Panel<'a, 'c> {
    canvas: &'c Canvas<'a>,
    plane: Plane<'a>,
    frame: Frame,
    x: [f64; 2],
    /// Positions of the vertical grid lines, in the unit of the horizontal axis.
    columns: Vec<f64>,
    y: [f64; 2],
    /// Font size, points.
    size: f64,
    /// Exponent of the power of ten by which the values of the vertical ticks are divided.
    power: i32,
    language: Language,
}

/// Distance between the label of the vertical axis and the frame, em.
pub const QUANTITY: f64 = 5.7;
/// Maximum width of a tick label, em, for which the label of the axis has enough space next to it.
const WIDEST_TICK: f64 = 4.3;

/// Approximately `count` equally spaced round numbers in [low, high].
pub fn ticks(low: f64, high: f64, count: f64) -> Vec<f64> {
    let raw = (high - low) / count;
    if !(raw > 0.0 && raw.is_finite()) {
        return Vec::new();
    }
    let power = libm::pow(10f64, libm::log10(raw).floor());
    let far = |step: &f64| libm::log(step / raw).abs();
    let step = [1.0, 2.0, 2.5, 5.0, 10.0]
        .map(|m| m * power)
        .into_iter()
        .min_by(|a, b| far(a).total_cmp(&far(b)))
        .unwrap_or(power);
    multiples(low, high, step)
}

fn multiples(low: f64, high: f64, step: f64) -> Vec<f64> {
    let (first, last) = (
        (low / step - 1e-9).ceil() as i64,
        (high / step + 1e-9).floor() as i64,
    );
    (first..=last).map(|k| k as f64 * step).collect()
}

/// Tick positions in the range `x`, degrees. They are multiples of a step, which is the smallest of 5°, 15°, 30°, 45°, 90° … that gives
/// at most nine intervals.
pub fn angle_ticks(x: [f64; 2]) -> Vec<f64> {
    let length = x[1] - x[0];
    let step = [5.0, 15.0, 30.0, 45.0, 90.0, 180.0, 360.0]
        .into_iter()
        .find(|s| length / s <= 9.0)
        .unwrap_or(720.0);
    multiples(x[0], x[1], step)
}

/// Text of a tick. The number of decimals is just sufficient for the step between ticks.
pub fn tick_text(value: f64, step: f64, language: Language) -> String {
    let decimals = (0..9)
        .find(|&d| {
            let scaled = step * 10f64.powi(d);
            (scaled - scaled.round()).abs() < 1e-6
        })
        .unwrap_or(9) as usize;
    fixed(language, value, decimals).replace('-', "−")
}

/// Exponent of the power of ten by which the values of wide tick labels are divided. The exponent is a multiple of 3. It is 0 for labels
/// of normal width.
fn power(values: &[f64], step: f64) -> i32 {
    let widest = values
        .iter()
        .map(|&v| text_width(&tick_text(v, step, Language::En)))
        .fold(0.0, f64::max);
    let largest = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    if widest <= WIDEST_TICK || largest == 0.0 {
        return 0;
    }
    3 * (libm::log10(largest) / 3.0).floor() as i32
}

/// An exponent in superscript digits.
fn raised(power: i32) -> String {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let text = power.to_string();
    text.chars()
        .map(|c| c.to_digit(10).map_or('⁻', |d| digits[d as usize]))
        .collect()
}

/// Range of the finite `values`, extended at both ends by the fraction `share` of its length. The length is never zero.
pub fn padded(values: impl Iterator<Item = f64>, share: f64) -> [f64; 2] {
    let (low, high) = values
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
            (l.min(v), h.max(v))
        });
    if low > high {
        return [-1.0, 1.0];
    }
    let mut span = high - low;
    if span <= 1e-12 * (low.abs() + high.abs()) || span == 0.0 {
        span = if high == 0.0 { 2.0 } else { high.abs() };
        return [low - 0.5 * span, high + 0.5 * span];
    }
    [low - share * span, high + share * span]
}

/// Draws a dashed line between two positions on the sheet.
pub(crate) fn dashes(canvas: &Canvas, ends: [[f64; 2]; 2], colour: RGBAColor) -> Drawn {
    dashed(canvas, ends, [7.0, 5.0], stroke(colour, 1.4))
}

impl<'a, 'c> Panel<'a, 'c> {
    /// Draws the frame, vertical grid lines at `columns`, horizontal grid lines, and the ticks of the vertical axis.
    pub fn new(
        canvas: &'c Canvas<'a>,
        frame: Frame,
        x: [f64; 2],
        columns: Vec<f64>,
        y: [f64; 2],
        size: f64,
        language: Language,
    ) -> Drawn<Self> {
        let rows = ((frame.bottom - frame.top) / (2.6 * size)).clamp(2.0, 8.0);
        let values = ticks(y[0], y[1], rows);
        let step = values.get(1).map_or(1.0, |b| b - values[0]);
        let power = power(&values, step);
        let panel = Panel {
            canvas,
            plane: frame.plane(canvas, x, y),
            frame,
            x,
            columns,
            y,
            size,
            power,
            language,
        };
        let grid = stroke(palette::GRID, 1.0);
        for &t in &panel.columns {
            trace(&panel.plane, [(t, y[0]), (t, y[1])], grid)?;
        }
        let scale = 10f64.powi(-power);
        let lettering = Lettering::new(size, palette::QUIET).anchored(HPos::Right, VPos::Center);
        let level = |v: f64| [(x[0], v), (x[1], v)];
        for &v in &values {
            trace(&panel.plane, level(v), grid)?;
            let at = [frame.left - 0.6 * size, panel.place(x[0], v)[1]];
            let text = tick_text(scale * v, scale * step, language);
            write(canvas, &text, at, lettering)?;
        }
        if y[0] < 0.0 && y[1] > 0.0 {
            trace(&panel.plane, level(0.0), stroke(palette::AXIS, 1.4))?;
        }
        frame.border(canvas)?;
        Ok(panel)
    }

    /// Writes the label of the vertical axis ("force, N") to the left of the ticks.
    pub fn quantity(&self, text: &str) -> Drawn {
        let power = raised(self.power);
        let text = &match text.split_once(", ") {
            _ if self.power == 0 => text.to_string(),
            Some((name, unit)) => format!("{name}, 10{power} {unit}"),
            None => format!("{text}, 10{power}"),
        };
        let middle = 0.5 * (self.frame.top + self.frame.bottom);
        let lettering = Lettering::new(self.size, palette::INK)
            .anchored(HPos::Center, VPos::Center)
            .upwards();
        let at = [self.frame.left - QUANTITY * self.size, middle];
        write(self.canvas, text, at, lettering)
    }

    /// Writes the values of the vertical grid lines and the label of the horizontal axis below the frame.
    pub fn across(&self, quantity: &str) -> Drawn {
        let small = Lettering::new(self.size, palette::QUIET).anchored(HPos::Center, VPos::Top);
        let step = match self.columns[..] {
            [a, b, ..] => b - a,
            _ => 1.0,
        };
        for &t in &self.columns {
            let at = [
                self.place(t, self.y[0])[0],
                self.frame.bottom + 0.6 * self.size,
            ];
            write(self.canvas, &tick_text(t, step, self.language), at, small)?;
        }
        let middle = 0.5 * (self.frame.left + self.frame.right);
        let name = Lettering::new(self.size, palette::INK).anchored(HPos::Center, VPos::Top);
        let at = [middle, self.frame.bottom + 2.1 * self.size];
        write(self.canvas, quantity, at, name)
    }

    /// Draws a curve, clipped at the lower and upper edge of the frame.
    pub fn curve(&self, points: &[(f64, f64)], colour: RGBAColor, width: f64) -> Drawn {
        // Points that are slightly outside the frame due to rounding or interpolation are still drawn.
        let slack = 0.01 * (self.y[1] - self.y[0]);
        let [low, high] = [self.y[0] - slack, self.y[1] + slack];
        let mut part: Vec<(f64, f64)> = Vec::new();
        let mut parts = Vec::new();
        for (i, &(x, v)) in points.iter().enumerate() {
            let inside = v >= low && v <= high;
            if let Some(&(x0, v0)) = i.checked_sub(1).map(|k| &points[k]) {
                let was_inside = v0 >= low && v0 <= high;
                if inside != was_inside && (v - v0).is_finite() {
                    let edge = if v.max(v0) > high { high } else { low };
                    part.push((x0 + (x - x0) * (edge - v0) / (v - v0), edge));
                }
            }
            if inside {
                part.push((x, v));
            } else if !part.is_empty() {
                parts.push(std::mem::take(&mut part));
            }
        }
        parts.push(part);
        for part in parts.into_iter().filter(|p| p.len() > 1) {
            trace(&self.plane, part, stroke(colour, width))?;
        }
        Ok(())
    }

    /// Draws a dot at each point.
    pub fn dots(&self, points: &[(f64, f64)], colour: RGBAColor, radius: f64) -> Drawn {
        let mut each = points.iter().map(|p| self.place(p.0, p.1));
        each.try_for_each(|at| circle(self.canvas, at, radius, colour.filled()))
    }

    /// Fills the area between two curves with the same horizontal positions.
    pub fn band(&self, upper: &[(f64, f64)], lower: &[(f64, f64)], colour: RGBAColor) -> Drawn {
        let around: Vec<(f64, f64)> = upper.iter().chain(lower.iter().rev()).copied().collect();
        fill(&self.plane, &around, colour)
    }

    /// Draws a dashed horizontal line at `value`. Its name, if any, is above (`Bottom`) or below (`Top`) the line, at the end that is
    /// farther from `curve`.
    pub fn level(
        &self,
        value: f64,
        name: Option<(&str, VPos)>,
        colour: RGBAColor,
        curve: &[(f64, f64)],
    ) -> Drawn {
        if !(value > self.y[0] && value < self.y[1]) {
            return Ok(());
        }
        let [left, right] = self.x.map(|x| self.place(x, value));
        dashes(self.canvas, [left, right], colour)?;
        let Some((name, side)) = name else {
            return Ok(());
        };
        let shift = self.size
            * match side {
                VPos::Bottom => -0.4,
                VPos::Center => 0.0,
                VPos::Top => 0.4,
            };
        let (letters, gap) = (0.88 * self.size, 0.5 * self.size);
        let long = letters * text_width(name) + 2.0 * gap;
        // Distance between the curve and the name, if the name starts at `from`, points.
        let free = |from: f64| {
            let points = curve.iter().map(|p| self.place(p.0, p.1));
            let beside = points.filter(|p| p[0] >= from && p[0] <= from + long);
            let away = beside.map(|p| (p[1] - right[1] - 2.0 * shift).abs());
            away.fold(2.5 * self.size, f64::min)
        };
        let (x, end) = if free(left[0]) > free(right[0] - long) {
            (left[0] + gap, HPos::Left)
        } else {
            (right[0] - gap, HPos::Right)
        };
        // The name is in the colour of text, because thin coloured letters would have little contrast.
        let lettering = Lettering::new(letters, palette::INK).anchored(end, side);
        write(self.canvas, name, [x, right[1] + shift], lettering)
    }

    /// Draws an arrow from zero to the edge of the frame, labelled ∞ or −∞, at an angle at which the quantity is infinite.
    pub fn infinity(&self, degrees: f64, up: bool, colour: RGBAColor) -> Drawn {
        let level = 0.0_f64.clamp(self.y[0], self.y[1]);
        let [x, from] = self.place(degrees, level);
        let (edge, away) = if up {
            (self.frame.top, 1.0)
        } else {
            (self.frame.bottom, -1.0)
        };
        let tip = edge + away * 2.0;
        let head = 0.55 * self.size;
        line(self.canvas, &[[x, from], [x, tip]], stroke(colour, 2.0))?;
        let sides = [-1.0, 1.0].map(|side| [x + side * 0.4 * head, tip + away * head]);
        let head = [sides[0], [x, tip], sides[1]];
        line(self.canvas, &head, stroke(colour, 2.0))?;
        // At the right edge of the frame, the symbol ∞ is to the left of the arrow.
        let room = self.frame.right - x > 2.5 * self.size;
        let (gap, side) = if room {
            (0.4, HPos::Left)
        } else {
            (-0.4, HPos::Right)
        };
        let text = if up { "∞" } else { "−∞" };
        let at = [x + gap * self.size, tip + away * 0.7 * self.size];
        let letters = Lettering::new(0.88 * self.size, palette::INK).anchored(side, VPos::Center);
        write(self.canvas, text, at, letters)
    }

    /// Marks an extreme with a dot and its value. The value is written above a maximum and below a minimum, if there is space inside the
    /// frame. If `ground` is set, the value has a light background, so that it is legible in front of dashed lines.
    pub fn mark(
        &self,
        (x, value): (f64, f64),
        maximum: bool,
        colour: RGBAColor,
        ground: bool,
    ) -> Drawn {
        let [x, y] = self.place(x, value);
        circle(self.canvas, [x, y], 3.6, colour.filled())?;
        // A value that is zero up to rounding errors is shown as 0.
        let noise = 1e-9 * (self.y[1] - self.y[0]);
        let value = if value.abs() < noise { 0.0 } else { value };
        let text = number(self.language, value);
        let size = 0.88 * self.size;
        let half = 0.5 * size * text_width(&text) + 0.4 * size;
        let x = x.clamp(self.frame.left + half, self.frame.right - half);
        let room = 1.5 * size;
        let above = if maximum {
            y - room > self.frame.top
        } else {
            y + room > self.frame.bottom
        };
        let (v, shift) = if above {
            (VPos::Bottom, -0.6 * size)
        } else {
            (VPos::Top, 0.6 * size)
        };
        if ground {
            let middle = y + shift + if above { -0.5 } else { 0.5 } * 0.73 * size;
            let off = 0.55 * size;
            let corners = [[x - half, middle - off], [x + half, middle + off]];
            rectangle(self.canvas, corners, palette::PAPER.mix(0.8).filled())?;
        }
        let lettering = Lettering::new(size, palette::INK).anchored(HPos::Center, v);
        write(self.canvas, &text, [x, y + shift], lettering)
    }

    /// Position of the point (`x`, `value`) of the diagram on the sheet, points.
    fn place(&self, x: f64, value: f64) -> [f64; 2] {
        self.frame.place(self.x, self.y, (x, value))
    }
}

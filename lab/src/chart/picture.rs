//! Picture of error against cost on logarithmic axes.

use plotters::prelude::*;
use plotters_backend::text_anchor::{HPos, VPos};

use super::{Across, Chart, Row};
use gaitcam_output::sheet::{Canvas, Drawn, Lettering, line, stroke, units, write};
use gaitcam_output::{Picture, palette};

const WIDTH: u32 = 900;
const HEIGHT: u32 = 560;
/// Left, right, top and bottom of the plot area, points. The right margin contains the legend.
const FIELD: [f64; 4] = [86.0, 640.0, 62.0, 496.0];
/// Smallest error drawn. Smaller errors are rounding.
const SMALLEST: f64 = 1e-16;
/// Colours of the methods. Methods with the same colour differ in the shape of the mark.
const COLOURS: [RGBAColor; 6] = [
    palette::BLUE,
    palette::RED,
    palette::GREEN,
    palette::PURPLE,
    palette::ORANGE,
    palette::QUIET,
];

/// Picture of the chart: a mark per row, the front as a stepped line, the default with a ring.
pub fn picture(chart: &Chart) -> Picture {
    Picture::drawn(WIDTH, HEIGHT, |canvas| draw(canvas, chart))
}

/// Range of decades on an axis.
struct Axis {
    low: i32,
    high: i32,
    from: f64,
    to: f64,
}

impl Axis {
    fn new(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
            (l.min(v.log10()), h.max(v.log10()))
        });
        let (low, high) = if low.is_finite() {
            (low, high)
        } else {
            (0.0, 1.0)
        };
        // A mark on the frame would be cut off, so the range is extended by a tenth of a decade.
        let (low, high) = ((low - 0.1).floor() as i32, (high + 0.1).ceil() as i32);
        Axis {
            low,
            high: high.max(low + 1),
            from,
            to,
        }
    }

    fn place(&self, value: f64) -> f64 {
        let share = (value.log10() - f64::from(self.low)) / f64::from(self.high - self.low);
        self.from + share.clamp(0.0, 1.0) * (self.to - self.from)
    }
}

fn drawn_error(row: &Row) -> f64 {
    row.error.max(SMALLEST)
}

fn draw(canvas: &Canvas, chart: &Chart) -> Drawn {
    let [left, right, top, bottom] = FIELD;
    let shown: Vec<&Row> = chart.rows.iter().filter(|r| r.error.is_finite()).collect();
    let x = Axis::new(shown.iter().map(|r| r.across(chart.across)), left, right);
    let levels = chart.levels.iter().map(|l| l.0);
    let y = Axis::new(
        shown.iter().map(|r| drawn_error(r)).chain(levels),
        bottom,
        top,
    );
    frame(canvas, chart, &x, &y)?;
    for (value, name) in &chart.levels {
        let at = y.place(*value);
        line(
            canvas,
            &[[left, at], [right, at]],
            stroke(palette::AXIS, 1.4),
        )?;
        let style = Lettering::new(11.0, palette::QUIET).anchored(HPos::Right, VPos::Bottom);
        write(canvas, name, [right - 5.0, at - 4.0], style)?;
    }
    front(canvas, chart, &x, &y)?;
    let mut methods: Vec<&str> = Vec::new();
    for row in &shown {
        if !methods.contains(&row.method.as_str()) {
            methods.push(&row.method);
        }
        let kind = methods.iter().position(|m| *m == row.method).unwrap_or(0);
        let at = [x.place(row.across(chart.across)), y.place(drawn_error(row))];
        mark(canvas, at, kind)?;
        if row.default {
            circle(canvas, at, 9.0, palette::INK, Some(1.8))?;
        }
    }
    legend(canvas, &methods, chart)
}

fn front(canvas: &Canvas, chart: &Chart, x: &Axis, y: &Axis) -> Drawn {
    let at: Vec<[f64; 2]> = (chart.front().iter())
        .map(|&i| &chart.rows[i])
        .map(|r| [x.place(r.across(chart.across)), y.place(drawn_error(r))])
        .collect();
    let mut steps = Vec::new();
    for (i, p) in at.iter().enumerate() {
        if i > 0 {
            steps.push([p[0], at[i - 1][1]]);
        }
        steps.push(*p);
    }
    if steps.len() < 2 {
        return Ok(());
    }
    line(canvas, &steps, stroke(palette::INK.mix(0.45), 1.6))
}

fn frame(canvas: &Canvas, chart: &Chart, x: &Axis, y: &Axis) -> Drawn {
    let [left, right, top, bottom] = FIELD;
    write(
        canvas,
        &chart.title,
        [left, 22.0],
        Lettering::new(16.0, palette::INK).bold(),
    )?;
    let small = Lettering::new(11.0, palette::QUIET);
    write(canvas, &chart.error, [left, 45.0], small)?;
    for decade in x.low..=x.high {
        let at = x.place(10f64.powi(decade));
        line(
            canvas,
            &[[at, top], [at, bottom]],
            stroke(palette::GRID, 1.0),
        )?;
        let style = Lettering::new(11.0, palette::INK).anchored(HPos::Center, VPos::Top);
        let text = match chart.across {
            Across::Time => time_name(decade),
            Across::Points | Across::Spans => format!("{}", 10f64.powi(decade)),
        };
        write(canvas, &text, [at, bottom + 8.0], style)?;
    }
    // Labels need 13 points of height.
    let every = (f64::from(y.high - y.low) * 13.0 / (bottom - top))
        .ceil()
        .max(1.0) as i32;
    for decade in (y.low..=y.high).filter(|d| (d - y.low) % every == 0) {
        let at = y.place(10f64.powi(decade));
        line(
            canvas,
            &[[left, at], [right, at]],
            stroke(palette::GRID, 1.0),
        )?;
        let style = Lettering::new(11.0, palette::INK).anchored(HPos::Right, VPos::Center);
        write(canvas, &format!("1e{decade}"), [left - 8.0, at], style)?;
    }
    line(
        canvas,
        &[[left, top], [left, bottom], [right, bottom]],
        stroke(palette::AXIS, 1.2),
    )?;
    let across = match chart.across {
        Across::Time => "time of one run, median",
        Across::Points => "points written",
        Across::Spans => "spans",
    };
    let style = Lettering::new(12.0, palette::INK).anchored(HPos::Center, VPos::Top);
    write(canvas, across, [0.5 * (left + right), bottom + 30.0], style)
}

fn time_name(decade: i32) -> String {
    let (unit, power) = match decade {
        ..-6 => ("ns", -9),
        -6..-3 => ("µs", -6),
        -3..0 => ("ms", -3),
        _ => ("s", 0),
    };
    format!("{} {unit}", 10f64.powi(decade - power).round())
}

fn circle(canvas: &Canvas, at: [f64; 2], r: f64, colour: RGBAColor, width: Option<f64>) -> Drawn {
    let style = match width {
        Some(width) => stroke(colour, width),
        None => colour.filled(),
    };
    canvas.draw(&Circle::new((units(at[0]), units(at[1])), units(r), style))
}

fn mark(canvas: &Canvas, at: [f64; 2], kind: usize) -> Drawn {
    let colour = COLOURS[kind % COLOURS.len()];
    let polygon = |corners: &[[f64; 2]]| {
        let points: Vec<(i32, i32)> = (corners.iter())
            .map(|c| (units(at[0] + c[0]), units(at[1] + c[1])))
            .collect();
        canvas.draw(&Polygon::new(points, colour.filled()))
    };
    match kind / COLOURS.len() {
        0 => circle(canvas, at, 4.6, colour, None),
        1 => polygon(&[[-4.4, -4.4], [4.4, -4.4], [4.4, 4.4], [-4.4, 4.4]]),
        _ => polygon(&[[0.0, -5.6], [5.2, 4.2], [-5.2, 4.2]]),
    }
}

fn legend(canvas: &Canvas, methods: &[&str], chart: &Chart) -> Drawn {
    let left = FIELD[1] + 24.0;
    let mut at = FIELD[2] + 4.0;
    let style = Lettering::new(11.0, palette::INK);
    for (kind, method) in methods.iter().enumerate() {
        mark(canvas, [left, at], kind)?;
        write(canvas, method, [left + 13.0, at], style)?;
        at += 20.0;
    }
    at += 8.0;
    if chart.default_on_front().is_some() {
        circle(canvas, [left, at], 7.0, palette::INK, Some(1.8))?;
        write(canvas, "the default", [left + 13.0, at], style)?;
        at += 20.0;
    }
    if chart.front().len() > 1 {
        let ends = [[left - 8.0, at], [left + 8.0, at]];
        line(canvas, &ends, stroke(palette::INK.mix(0.45), 1.6))?;
        write(canvas, "Pareto front", [left + 13.0, at], style)?;
    }
    Ok(())
}

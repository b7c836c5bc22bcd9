//! The mean stance of each foot, apart, with its stances, band, landmarks and an axis in body weights.

use plotters::prelude::*;
use plotters_backend::text_anchor::{HPos, VPos};

use super::{Curve, colour, foot_name, thinned};
use crate::plot::axes::{Frame, Panel, padded, tick_text, ticks};
use crate::plot::layout::key;
use crate::plot::palette::{INK, QUIET};
use crate::plot::sheet::{Canvas, Drawn, Lettering, line, stroke, units, write};
use crate::plot::text::text_width;
use crate::words::Words;
use gaitcam::force::{Interpretation, MeanStanceCurve, Overlay, Point};
use gaitcam::units::G;

/// Opacity of one stance; many together still show the mean and its band.
const THIN: f64 = 0.3;
/// Opacity of the band of one standard deviation.
const BAND: f64 = 0.25;
/// Names of loading peak, valley and push-off peak.
const LANDMARKS: [&str; 3] = ["P1", "V", "P2"];

pub(super) fn draw(
    canvas: &Canvas,
    frame: Frame,
    understood: &Interpretation,
    e: f64,
    words: &Words,
) -> Drawn {
    let Some(overlay) = &understood.overlay else {
        return none(canvas, frame, e, words);
    };
    let singles = overlay.stances.iter().flat_map(|s| &s.1).copied();
    let weight = understood.mass.map_or(0.0, |m| m.0 * G);
    let y = padded(singles.chain([0.0, weight]), 0.1);
    let y = [y[0].max(-0.02 * y[1]), y[1]];
    let means = understood.means();
    for (k, mean) in means.iter().enumerate() {
        let place = column(frame, k, means.len(), e);
        draw_foot(canvas, place, y, overlay, mean, e, words)?;
        body_weights(canvas, place, y, weight, e, words)?;
        if k > 0 {
            continue;
        }
        let axis = words.text("figure-force");
        let lettering = Lettering::new(e, INK)
            .anchored(HPos::Center, VPos::Center)
            .upwards();
        let middle = 0.5 * (place.top + place.bottom);
        write(canvas, &axis, [place.left - 5.7 * e, middle], lettering)?;
    }
    Ok(())
}

/// One of several frames side by side.
fn column(frame: Frame, k: usize, count: usize, e: f64) -> Frame {
    let gap = 8.6 * e;
    let width = (frame.right - frame.left - gap * (count as f64 - 1.0)) / count as f64;
    let left = frame.left + k as f64 * (width + gap);
    Frame {
        left,
        right: left + width,
        ..frame
    }
}

fn draw_foot(
    canvas: &Canvas,
    frame: Frame,
    y: [f64; 2],
    overlay: &Overlay,
    mean: &MeanStanceCurve,
    e: f64,
    words: &Words,
) -> Drawn {
    let share = |i: usize, n: usize| 100.0 * i as f64 / (n - 1) as f64;
    let on_phase = |force: &[f64]| -> Curve { thinned(force, share) };
    let x = [0.0, 100.0];
    let panel = Panel::over(canvas, frame, x, ticks(0.0, 100.0, 5.0), y, e)?;
    let ink = colour(mean.foot);
    let own = overlay.stances.iter().filter(|s| s.0 == mean.foot);
    for (_, force) in own.filter(|_| mean.count > 1) {
        panel.curve(&on_phase(force), QUIET.mix(THIN), 1.0)?;
    }
    if let Some(spread) = &mean.spread_n {
        let edge = |sign: f64| -> Curve {
            let both = mean.mean_n.iter().zip(spread);
            let edge: Vec<f64> = both.map(|(m, s)| m + sign * s).collect();
            on_phase(&edge)
        };
        panel.band(&edge(1.0), &edge(-1.0), ink.mix(BAND))?;
    }
    panel.curve(&on_phase(&mean.mean_n), ink, 2.8)?;
    for (k, point) in mean.landmarks.iter().enumerate() {
        if let Some(point) = point {
            // The only peak, late in the stance, is the push-off.
            let lone = mean.landmarks[1].is_none() && point.at > 0.6;
            let name = LANDMARKS[if lone { 2 } else { k }];
            landmark(canvas, frame, y, name, *point, e)?;
        }
    }
    let seconds = format!("{:.3}", mean.duration_s);
    panel.across(&words.fill("figure-stance-share", &[("seconds", &seconds)]))?;
    let side = foot_name(mean.foot, words);
    let count = mean.count.to_string();
    let name = match mean.count {
        1 => words.text("figure-one-stance"),
        _ => words.fill("figure-mean-of-stances", &[("count", &count)]),
    };
    let name = format!("{side}, {name}");
    let sd = words.text("figure-sd");
    let mut entries = vec![(ink, 2.8, name.as_str())];
    if mean.spread_n.is_some() {
        entries.push((ink.mix(BAND), 14.0, &sd));
    }
    key(
        canvas,
        [frame.left, frame.top - 1.1 * e],
        0.95 * e,
        &entries,
    )
}

/// A dot at a peak or valley with its name and force.
fn landmark(canvas: &Canvas, frame: Frame, y: [f64; 2], name: &str, point: Point, e: f64) -> Drawn {
    let across = frame.left + point.at * (frame.right - frame.left);
    let up = up(frame, y, point.force_n);
    let dot = Circle::new((units(across), units(up)), units(3.4), INK.filled());
    canvas.draw(&dot)?;
    let text = format!("{name} {:.0} N", point.force_n);
    let above = name != "V";
    let (v, shift) = if above {
        (VPos::Bottom, -0.55 * e)
    } else {
        (VPos::Top, 0.55 * e)
    };
    let size = 0.88 * e;
    let half = 0.5 * size * text_width(&text);
    let x = across.clamp(frame.left + half + 2.0, frame.right - half - 2.0);
    let lettering = Lettering::new(size, INK).anchored(HPos::Center, v);
    write(canvas, &text, [x, up + shift], lettering)
}

fn up(frame: Frame, y: [f64; 2], force: f64) -> f64 {
    frame.bottom + (force - y[0]) / (y[1] - y[0]) * (frame.top - frame.bottom)
}

/// An axis in body weights at the right of a frame.
pub(super) fn body_weights(
    canvas: &Canvas,
    frame: Frame,
    y: [f64; 2],
    weight: f64,
    e: f64,
    words: &Words,
) -> Drawn {
    if weight <= 0.0 {
        return Ok(());
    }
    let values = ticks(y[0] / weight, y[1] / weight, 5.0);
    let step = values.get(1).map_or(0.5, |b| b - values[0]);
    let small = Lettering::new(0.85 * e, QUIET).anchored(HPos::Left, VPos::Center);
    for &v in &values {
        let at = up(frame, y, v * weight);
        let tick = [[frame.right, at], [frame.right + 0.35 * e, at]];
        line(canvas, &tick, stroke(QUIET, 1.2))?;
        let text = tick_text(v, step);
        write(canvas, &text, [frame.right + 0.6 * e, at], small)?;
    }
    let unit = words.text("figure-body-weights");
    let head = Lettering::new(0.85 * e, QUIET).anchored(HPos::Left, VPos::Bottom);
    write(
        canvas,
        &unit,
        [frame.right + 0.3 * e, frame.top - 0.5 * e],
        head,
    )
}

/// A recording without a stance.
fn none(canvas: &Canvas, frame: Frame, e: f64, words: &Words) -> Drawn {
    let lettering = Lettering::new(e, QUIET).anchored(HPos::Left, VPos::Top);
    let text = words.text("figure-no-stance");
    write(canvas, &text, [frame.left, frame.top], lettering)
}

//! Mean stances in a figure of a recording. Each foot has a frame with its stances, their mean and band, characteristic points, and an
//! axis in body weights.

use plotters::style::Color;
use plotters_backend::text_anchor::{HPos, VPos};

use super::{colour, edges, foot_name, thinned};
use crate::plot::axes::{QUANTITY, padded, tick_text, ticks};
use crate::plot::layout::Figure;
use crate::plot::palette::{INK, QUIET};
use crate::plot::sheet::{Drawn, Frame, Lettering, circle, line, stroke};
use crate::plot::text::text_width;
use crate::words::Words;
use gaitcam::force::{Interpretation, MeanStanceCurve, Overlay, Point};
use gaitcam::units::G;

/// Opacity of the line of a single stance. It is low, so that the mean is visible among many stances.
const THIN: f64 = 0.3;
/// Opacity of the band of one standard deviation.
const BAND: f64 = 0.25;
/// Names of the characteristic points: loading peak, valley, push-off peak.
const LANDMARKS: [&str; 3] = ["P1", "V", "P2"];

pub(super) fn draw(f: &Figure, frame: Frame, understood: &Interpretation, words: &Words) -> Drawn {
    let Some(overlay) = &understood.overlay else {
        let lettering = Lettering::new(f.e, QUIET).anchored(HPos::Left, VPos::Top);
        let text = words.text("figure-no-stance");
        return f.write(&text, [frame.left, frame.top], lettering);
    };
    let singles = overlay.stances.iter().flat_map(|s| &s.1).copied();
    let weight = understood.mass.map_or(0.0, |m| m.0 * G);
    let y = padded(singles.chain([0.0, weight]), 0.1);
    let y = [y[0].max(-0.02 * y[1]), y[1]];
    let means = understood.means();
    for (k, mean) in means.iter().enumerate() {
        let place = column(frame, k, means.len(), f.e);
        draw_foot(f, place, y, (overlay, mean), words)?;
        body_weights(f, place, y, weight, words)?;
        if k > 0 {
            continue;
        }
        let axis = words.text("figure-force");
        let lettering = Lettering::new(f.e, INK)
            .anchored(HPos::Center, VPos::Center)
            .upwards();
        let middle = 0.5 * (place.top + place.bottom);
        f.write(&axis, [place.left - QUANTITY * f.e, middle], lettering)?;
    }
    Ok(())
}

/// Frame with the index `k`, from 0, if `frame` is divided into `count` adjacent frames. `e` is the font size, points.
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
    f: &Figure,
    frame: Frame,
    y: [f64; 2],
    (overlay, mean): (&Overlay, &MeanStanceCurve),
    words: &Words,
) -> Drawn {
    let share = |i: usize, n: usize| 100.0 * i as f64 / (n - 1) as f64;
    let on_phase = |force: &[f64]| thinned(force, share);
    let panel = f.panel(frame, [0.0, 100.0], ticks(0.0, 100.0, 5.0), y)?;
    let ink = colour(mean.foot);
    let own = overlay.stances.iter().filter(|s| s.0 == mean.foot);
    for (_, force) in own.filter(|_| mean.count > 1) {
        panel.curve(&on_phase(force), QUIET.mix(THIN), 1.0)?;
    }
    if let Some(spread) = &mean.spread_n {
        let [upper, lower] = edges(&mean.mean_n, spread).map(|edge| on_phase(&edge));
        panel.band(&upper, &lower, ink.mix(BAND))?;
    }
    panel.curve(&on_phase(&mean.mean_n), ink, 2.8)?;
    for (k, point) in mean.landmarks.iter().enumerate() {
        if let Some(point) = point {
            // A single peak late in the stance is the push-off peak.
            let lone = mean.landmarks[1].is_none() && point.at > 0.6;
            let name = LANDMARKS[if lone { 2 } else { k }];
            landmark(f, frame, y, name, *point)?;
        }
    }
    let seconds = words.fixed(mean.duration_s, 3);
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
    let place = [frame.left, frame.top - 1.1 * f.e];
    f.key(place, 0.95 * f.e, &entries)
}

/// Draws a dot at a peak or valley, with its name and force.
fn landmark(f: &Figure, frame: Frame, y: [f64; 2], name: &str, point: Point) -> Drawn {
    let e = f.e;
    let across = frame.left + point.at * (frame.right - frame.left);
    let up = up(frame, y, point.force_n);
    circle(f.canvas, [across, up], 3.4, INK.filled())?;
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
    f.write(&text, [x, up + shift], lettering)
}

fn up(frame: Frame, y: [f64; 2], force: f64) -> f64 {
    frame.bottom + (force - y[0]) / (y[1] - y[0]) * (frame.top - frame.bottom)
}

/// Draws an axis in body weights on the right side of a frame.
pub(super) fn body_weights(
    f: &Figure,
    frame: Frame,
    y: [f64; 2],
    weight: f64,
    words: &Words,
) -> Drawn {
    let e = f.e;
    if weight <= 0.0 {
        return Ok(());
    }
    let values = ticks(y[0] / weight, y[1] / weight, 5.0);
    let step = values.get(1).map_or(0.5, |b| b - values[0]);
    let small = Lettering::new(0.85 * e, QUIET).anchored(HPos::Left, VPos::Center);
    for &v in &values {
        let at = up(frame, y, v * weight);
        let tick = [[frame.right, at], [frame.right + 0.35 * e, at]];
        line(f.canvas, &tick, stroke(QUIET, 1.2))?;
        f.write(
            &tick_text(v, step, f.language),
            [frame.right + 0.6 * e, at],
            small,
        )?;
    }
    let unit = words.text("figure-body-weights");
    let head = Lettering::new(0.85 * e, QUIET).anchored(HPos::Left, VPos::Bottom);
    let at = [frame.right + 0.3 * e, frame.top - 0.5 * e];
    f.write(&unit, at, head)
}

//! The picture of a recording: its stances over their mean, and the mean cycle below.

use plotters::prelude::*;

use crate::plot::axes::{Frame, Panel, padded, ticks};
use crate::plot::layout::{Layout, key, key_and_levels, strips, title};
use crate::plot::palette::{BLUE, GREEN, INK, ORANGE, QUIET};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Canvas, Drawn};
use crate::words::Words;
use gaitcam::force::{Cycle, Foot, Overlay};
use gaitcam::units::G;
use gaitcam::wording::Language;

/// A curve as it is drawn.
type Curve = Vec<(f64, f64)>;

/// Points drawn of a curve: one for every other pixel of a wide picture.
const POINTS: usize = 512;
/// Opacity of one stance; many together still show the band below them.
const THIN: f64 = 0.45;
/// Opacity of the band of one standard deviation about the mean stance.
const BAND: f64 = 0.16;

/// Stances on their own phase over the mean with its band of one standard deviation; below them the mean
/// cycle with its band and the body weight.
pub fn stances(name: &str, overlay: &Overlay, cycle: &Cycle, language: Language) -> Picture {
    let words = Words::new(language);
    let layout = Layout {
        size: (1200, 1000),
        ..Layout::ALONE
    };
    Picture::drawn(layout.size.0, layout.size.1, |canvas| {
        let e = layout.letters;
        title(canvas, layout, name, &words.text("figure-vertical-force"))?;
        let frame = Frame {
            top: layout.frame().top + 1.9 * e,
            ..layout.frame()
        };
        let frames = strips(frame, &[1.35, 1.0], 7.4 * e);
        draw_stances(canvas, frames[0], overlay, e, &words)?;
        draw_cycle(canvas, frames[1], cycle, e, &words)
    })
}

fn draw_stances(canvas: &Canvas, frame: Frame, overlay: &Overlay, e: f64, words: &Words) -> Drawn {
    let share = |i: usize, n: usize| 100.0 * i as f64 / (n - 1) as f64;
    let on_phase = |force: &[f64]| thinned(force, share);
    let mean = on_phase(&overlay.mean_n);
    let band = overlay.spread_n.as_ref().map(|s| {
        let edge = |sign: f64| -> Vec<f64> {
            let both = overlay.mean_n.iter().zip(s);
            both.map(|(m, s)| m + sign * s).collect()
        };
        (on_phase(&edge(1.0)), on_phase(&edge(-1.0)))
    });
    let singles: Vec<(Option<Foot>, Curve)> = overlay
        .stances
        .iter()
        .map(|(foot, force)| (*foot, on_phase(force)))
        .collect();
    let shown = singles.iter().flat_map(|s| &s.1).chain(&mean);
    let edges = band.iter().flat_map(|(u, l)| u.iter().chain(l));
    let y = padded(shown.chain(edges).map(|p| p.1).chain([0.0]), 0.08);
    let y = [y[0].max(-0.02 * y[1]), y[1]];
    let x = [0.0, 100.0];
    let panel = Panel::over(canvas, frame, x, ticks(0.0, 100.0, 10.0), y, e)?;
    let single = singles.len() == 1;
    for (foot, curve) in singles.iter().filter(|_| !single) {
        panel.curve(curve, colour(*foot).mix(THIN), 1.2)?;
    }
    if let Some((upper, lower)) = &band {
        // On top of the stances, edged, so that many of them do not hide it.
        panel.band(upper, lower, INK.mix(BAND))?;
        panel.curve(upper, INK.mix(0.6), 1.2)?;
        panel.curve(lower, INK.mix(0.6), 1.2)?;
    }
    panel.curve(&mean, INK, 3.0)?;
    panel.quantity(&words.text("figure-force"), 5.7 * e)?;
    let seconds = format!("{:.3}", overlay.duration_s);
    panel.across(&words.fill("figure-stance-share", &[("seconds", &seconds)]))?;

    let mean_of = match overlay.count {
        1 => words.text("figure-one-stance"),
        n => words.fill("figure-mean-of-stances", &[("count", &n.to_string())]),
    };
    let sd = words.text("figure-sd");
    let mut entries = vec![(INK, 3.0, mean_of.as_str())];
    if band.is_some() {
        entries.push((INK.mix(BAND), 14.0, &sd));
    }
    let sides = [
        (Some(Foot::Left), words.text("figure-left")),
        (Some(Foot::Right), words.text("figure-right")),
        (None, words.text("figure-foot-unknown")),
    ];
    for (foot, word) in &sides {
        let foot = *foot;
        if !single && singles.iter().any(|s| s.0 == foot) {
            entries.push((colour(foot).mix(0.8), 2.0, word));
        }
    }
    key(canvas, [frame.left, frame.top - 1.1 * e], e, &entries)
}

fn draw_cycle(canvas: &Canvas, frame: Frame, cycle: &Cycle, e: f64, words: &Words) -> Drawn {
    let curve = &cycle.curve;
    // The cycle closes: its first sample is drawn again at the end.
    let closed = |v: &[f64]| -> Curve {
        let around: Vec<f64> = v.iter().chain(v.first()).copied().collect();
        thinned(&around, |i, n| curve.period_s * i as f64 / (n - 1) as f64)
    };
    let mean = closed(&curve.force_n);
    let band = curve.spread_n.as_ref().map(|s| {
        let edge = |sign: f64| -> Vec<f64> {
            let both = curve.force_n.iter().zip(s);
            both.map(|(m, s)| m + sign * s).collect()
        };
        (closed(&edge(1.0)), closed(&edge(-1.0)))
    });
    let weight = cycle.mass_kg * G;
    let edges = band.iter().flat_map(|(u, l)| u.iter().chain(l));
    let values = mean.iter().chain(edges).map(|p| p.1).chain([0.0, weight]);
    let y = padded(values, 0.1);
    let y = [y[0].max(-0.02 * y[1]), y[1]];
    let x = [0.0, curve.period_s];
    let panel = Panel::over(canvas, frame, x, ticks(x[0], x[1], 8.0), y, e)?;
    if let Some((upper, lower)) = &band {
        panel.band(upper, lower, ORANGE.mix(0.22))?;
    }
    panel.level(weight, None, QUIET)?;
    panel.curve(&mean, BLUE, 2.6)?;
    panel.quantity(&words.text("figure-force"), 5.7 * e)?;
    panel.across(&words.text("figure-time"))?;
    let [mean, step, weight] = [
        "figure-mean-cycle",
        "figure-step-band",
        "figure-body-weight",
    ]
    .map(|k| words.text(k));
    let mut entries = vec![(BLUE, 2.6, mean.as_str())];
    if band.is_some() {
        entries.push((ORANGE.mix(0.22), 14.0, &step));
    }
    let levels = [(QUIET, weight.as_str())];
    let place = [frame.left, frame.top - 1.1 * e];
    key_and_levels(canvas, place, e, &entries, &levels)
}

fn colour(foot: Option<Foot>) -> RGBAColor {
    match foot {
        Some(Foot::Left) => BLUE,
        Some(Foot::Right) => ORANGE,
        None => GREEN,
    }
}

/// Every n-th sample and the last, over what `across` makes of their places.
fn thinned(force: &[f64], across: impl Fn(usize, usize) -> f64) -> Curve {
    let n = force.len();
    if n < 2 {
        return Vec::new();
    }
    let step = n.div_ceil(POINTS);
    let places = (0..n - 1).step_by(step).chain([n - 1]);
    places.map(|i| (across(i, n), force[i])).collect()
}

//! The picture of a recording: the whole of it with every contact, the mean stance of each foot, the mean cycle.

mod facts;
mod joint;
mod means;
mod whole;

use plotters::prelude::*;

pub use joint::joint_mean;

use crate::plot::axes::{Frame, Panel, padded, ticks};
use crate::plot::layout::{Layout, key_and_levels, strips, title};
use crate::plot::palette::{BLUE, GREEN, ORANGE, QUIET};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Canvas, Drawn};
use crate::words::{self, Words};
use gaitcam::force::{Foot, ForceCurve, Interpretation};
use gaitcam::units::G;
use gaitcam::wording::Language;

/// A curve as it is drawn.
type Curve = Vec<(f64, f64)>;

/// The layout of a figure of the report: as tall as its lanes of contacts ask.
pub(crate) fn figure_layout(understood: &Interpretation, words: &Words) -> Layout {
    let letters = Layout::figure(0).letters;
    let lanes = whole::height(understood, letters, words);
    Layout::figure(700 + lanes as u32)
}

/// The whole recording with contacts marked used or rejected (and why), the mean stances of the left and the right
/// foot with loading peak, valley and push-off, and below them the mean cycle, where there is one.
pub fn recording(
    understood: &Interpretation,
    cycle: Option<&ForceCurve>,
    language: Language,
) -> Picture {
    let words = &words::words(language);
    let lanes = whole::height(understood, Layout::ALONE.letters, words) as u32;
    let layout = Layout {
        size: (
            1200,
            lanes
                + match (cycle, &understood.overlay) {
                    (Some(_), _) => 1330,
                    (None, Some(_)) => 980,
                    (None, None) => 560,
                },
        ),
        ..Layout::ALONE
    };
    recording_in(understood, cycle, layout, words)
}

pub(crate) fn recording_in(
    understood: &Interpretation,
    cycle: Option<&ForceCurve>,
    layout: Layout,
    words: &Words,
) -> Picture {
    Picture::drawn(layout.size.0, layout.size.1, |canvas| {
        let e = layout.letters;
        title(
            canvas,
            layout,
            &understood.file,
            &words.text("figure-vertical-force"),
        )?;
        let frame = layout.frame();
        let top = facts::write_facts(canvas, understood, frame, e, words)?;
        let frame = Frame {
            top: top + 1.6 * e,
            right: frame.right - 3.2 * e,
            ..frame
        };
        let lanes = whole::height(understood, e, words);
        let shares: &[f64] = match (cycle, &understood.overlay) {
            (Some(_), _) => &[1.0, 1.0, 0.85],
            (None, Some(_)) => &[1.0, 1.05],
            // A line of words in place of the means.
            (None, None) => &[1.0, 0.05],
        };
        // Lanes of contacts and their key stand between the recording and the means.
        let gap = 7.6 * e;
        let frames = strips(
            Frame {
                bottom: frame.bottom - lanes,
                ..frame
            },
            shares,
            gap,
        );
        let below = |f: Frame| Frame {
            top: f.top + lanes,
            bottom: f.bottom + lanes,
            ..f
        };
        whole::draw(canvas, frames[0], understood, e, words)?;
        means::draw(canvas, below(frames[1]), understood, e, words)?;
        match cycle {
            Some(curve) => draw_cycle(canvas, below(frames[2]), curve, &[], e, words),
            None => Ok(()),
        }
    })
    .in_language(words.language())
}

/// A mean cycle with its band, over the single cycles where there are any.
fn draw_cycle(
    canvas: &Canvas,
    frame: Frame,
    curve: &ForceCurve,
    single: &[Curve],
    e: f64,
    words: &Words,
) -> Drawn {
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
    let weight = curve.mass_kg.unwrap_or(0.0) * G;
    let edges = band.iter().flat_map(|(u, l)| u.iter().chain(l));
    let all = mean.iter().chain(edges).chain(single.iter().flatten());
    let values = all.map(|p| p.1).chain([0.0, weight]);
    let y = padded(values, 0.1);
    let y = [y[0].max(-0.02 * y[1]), y[1]];
    let x = [0.0, curve.period_s];
    let panel = Panel::over(canvas, frame, x, ticks(x[0], x[1], 8.0), y, e)?;
    if let Some((upper, lower)) = &band {
        panel.band(upper, lower, BLUE.mix(0.22))?;
    }
    for one in single {
        panel.curve(one, QUIET.mix(0.5), 1.0)?;
    }
    panel.level(weight, None, QUIET)?;
    panel.curve(&mean, BLUE, 2.6)?;
    means::body_weights(canvas, frame, y, weight, e, words)?;
    panel.quantity(&words.text("figure-force"), 5.7 * e)?;
    panel.across(&words.text("figure-time"))?;
    let [mean, step, weight] = [
        "figure-mean-cycle",
        "figure-step-band",
        "figure-body-weight",
    ]
    .map(|k| words.text(k));
    let mut entries = vec![(BLUE, 2.6, mean.as_str())];
    let each = words.text("figure-each-recording");
    if !single.is_empty() {
        entries.push((QUIET.mix(0.5), 1.0, &each));
    }
    if band.is_some() {
        entries.push((BLUE.mix(0.22), 14.0, &step));
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

fn foot_name(foot: Option<Foot>, words: &Words) -> String {
    words.text(match foot {
        Some(Foot::Left) => "figure-left",
        Some(Foot::Right) => "figure-right",
        None => "figure-foot-unknown",
    })
}

/// Points drawn of a curve: one for every other pixel of a wide picture.
const POINTS: usize = 512;

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

//! Figure of a recording: all contacts, mean stance of each foot, and mean cycle.

mod facts;
mod joint;
mod means;
mod whole;

use plotters::style::{Color, RGBAColor};

pub use joint::joint_mean;

use crate::plot::axes::padded;
use crate::plot::layout::{Figure, Layout, columns, strips};
use crate::plot::palette::{BLUE, GREEN, ORANGE, QUIET};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Drawn, Frame};
use crate::words::{self, Words};
use gaitcam::force::{Foot, ForceCurve, Interpretation};
use gaitcam::units::G;
use gaitcam::wording::Language;

/// Points (x, y) of a curve.
type Curve = Vec<(f64, f64)>;

/// Layout of the figure in the report. The height depends on the number of rows with contacts.
pub(crate) fn figure_layout(understood: &Interpretation, words: &Words) -> Layout {
    let letters = Layout::figure(0).letters;
    let lanes = whole::height(understood, letters, words);
    Layout::figure(700 + lanes as u32)
}

/// Figure of a recording in three parts. The first part is the whole recording with its contacts, marked as used or as rejected with the
/// reason. The second part contains the mean stance of each foot with loading peak, valley and push-off peak. The third part is the mean
/// cycle, if there is one.
pub fn recording(
    understood: &Interpretation,
    cycle: Option<&ForceCurve>,
    language: Language,
) -> Picture {
    let words = &words::words(language);
    let lanes = whole::height(understood, Layout::ALONE.letters, words) as u32;
    let parts = match (cycle, &understood.overlay) {
        (Some(_), _) => 1330,
        (None, Some(_)) => 980,
        (None, None) => 560,
    };
    let layout = Layout {
        size: (1200, lanes + parts),
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
    layout.picture(words.language(), |f| {
        let e = f.e;
        f.title(&understood.file, &words.text("figure-vertical-force"))?;
        let frame = layout.frame();
        let top = facts::write_facts(&f, understood, frame, words)?;
        let frame = Frame {
            top: top + 1.6 * e,
            right: frame.right - 3.2 * e,
            ..frame
        };
        let lanes = whole::height(understood, e, words);
        let shares: &[f64] = match (cycle, &understood.overlay) {
            (Some(_), _) => &[1.0, 1.0, 0.85],
            (None, Some(_)) => &[1.0, 1.05],
            // A line of text replaces mean stances and mean cycle.
            (None, None) => &[1.0, 0.05],
        };
        // The lanes with the contacts and their legend are between the recording and the mean stances.
        let above = Frame {
            bottom: frame.bottom - lanes,
            ..frame
        };
        let frames = strips(above, shares, 7.6 * e);
        let below = |part: Frame| Frame {
            top: part.top + lanes,
            bottom: part.bottom + lanes,
            ..part
        };
        whole::draw(&f, frames[0], understood, words)?;
        means::draw(&f, below(frames[1]), understood, words)?;
        match cycle {
            Some(curve) => draw_cycle(&f, below(frames[2]), curve, &[], words),
            None => Ok(()),
        }
    })
}

/// Draws a mean cycle with its band. `single` contains the cycles of single recordings, which are drawn as thin lines.
fn draw_cycle(
    f: &Figure,
    frame: Frame,
    curve: &ForceCurve,
    single: &[Curve],
    words: &Words,
) -> Drawn {
    let closed = |force: &[f64]| closed(force, curve.period_s);
    let mean = closed(&curve.force_n);
    let band =
        (curve.spread_n.as_ref()).map(|s| edges(&curve.force_n, s).map(|edge| closed(&edge)));
    let weight = curve.mass_kg.unwrap_or(0.0) * G;
    let edges = band.iter().flatten().flatten();
    let all = mean.iter().chain(edges).chain(single.iter().flatten());
    let values = all.map(|p| p.1).chain([0.0, weight]);
    let y = padded(values, 0.1);
    let y = [y[0].max(-0.02 * y[1]), y[1]];
    let x = [0.0, curve.period_s];
    let panel = f.panel(frame, x, columns(x, false), y)?;
    if let Some([upper, lower]) = &band {
        panel.band(upper, lower, BLUE.mix(0.22))?;
    }
    for one in single {
        panel.curve(one, QUIET.mix(0.5), 1.0)?;
    }
    panel.level(weight, None, QUIET, &[])?;
    panel.curve(&mean, BLUE, 2.6)?;
    means::body_weights(f, frame, y, weight, words)?;
    panel.quantity(&words.text("figure-force"))?;
    panel.across(&words.text("figure-time"))?;
    let names = [
        "figure-mean-cycle",
        "figure-step-band",
        "figure-body-weight",
    ];
    let [mean, step, weight] = names.map(|k| words.text(k));
    let mut entries = vec![(BLUE, 2.6, mean.as_str())];
    let each = words.text("figure-each-recording");
    if !single.is_empty() {
        entries.push((QUIET.mix(0.5), 1.0, &each));
    }
    if band.is_some() {
        entries.push((BLUE.mix(0.22), 14.0, &step));
    }
    let levels = [(QUIET, weight.as_str())];
    let place = [frame.left, frame.top - 1.1 * f.e];
    f.key_and_levels(place, f.e, &entries, &levels)
}

/// Points of a cycle over time, s, with the first sample repeated at the end.
fn closed(force: &[f64], period_s: f64) -> Curve {
    let around: Vec<f64> = force.iter().chain(force.first()).copied().collect();
    thinned(&around, |i, n| period_s * i as f64 / (n - 1) as f64)
}

/// Upper and lower edge of a band of one standard deviation about the mean.
fn edges(mean: &[f64], spread: &[f64]) -> [Vec<f64>; 2] {
    [1.0, -1.0].map(|sign| {
        let both = mean.iter().zip(spread);
        both.map(|(m, s)| m + sign * s).collect()
    })
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

/// Maximum number of drawn points per curve, approximately one per two pixels of the figure.
const POINTS: usize = 512;

/// Points of a curve for every n-th sample and the last sample. `across` returns the horizontal position of a sample from its index and
/// the number of samples.
fn thinned(force: &[f64], across: impl Fn(usize, usize) -> f64) -> Curve {
    let n = force.len();
    if n < 2 {
        return Vec::new();
    }
    let step = n.div_ceil(POINTS);
    let places = (0..n - 1).step_by(step).chain([n - 1]);
    places.map(|i| (across(i, n), force[i])).collect()
}

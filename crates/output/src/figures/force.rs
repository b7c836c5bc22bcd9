//! The force picture: what the cam gives on what was wanted, with the difference below.

use plotters::prelude::*;

use crate::number::number;
use crate::plot::axes::{Frame, Panel, padded};
use crate::plot::layout::{Layout, ends_of, key, over_the_law, strips, title};
use crate::plot::palette::{BLUE, ORANGE, QUIET, RED};
use crate::plot::picture::Picture;
use crate::pose::motion;
use crate::pose::{angles, target_at};
use gaitcam::cam::Measures;
use gaitcam::drive::Drive;
use gaitcam::force::ForceCurve;
use gaitcam::synth::Synthesis;

/// Points of the target and of its band.
const TARGET_POINTS: usize = 720;

/// The cam's force on the wanted one with the difference below; the step-to-step spread as a band.
pub fn force(synthesis: &Synthesis) -> Picture {
    force_in(synthesis, Layout::ALONE)
}

pub(crate) fn force_in(synthesis: &Synthesis, layout: Layout) -> Picture {
    Picture::drawn(layout.size.0, layout.size.1, |canvas| {
        let law = synthesis.pressing();
        let e = layout.letters;
        let measures = synthesis.cam.follower.measures();
        let across = |t: f64| measures.angle().factor * t;
        let (drive, words) = pressed(synthesis);
        let achieved: Vec<(f64, f64)> = motion(law)
            .iter()
            .map(|(t, m)| (across(*t), drive.force(*m)))
            .collect();
        title(canvas, layout, &synthesis.name, words.head)?;
        let frame = force_frame(layout);
        let legend = [frame.left, frame.top - 1.1 * e];
        let (low, high) = drive.force_curve(law).extremes();
        let ends = [low, high].map(|x| (across(x.at), x.value));
        // A force that never pulls is drawn from zero.
        let pushes = low.value >= -1e-9 * high.value.abs();
        let marks = |panel: &Panel| {
            panel.mark(ends[1].0, ends[1].1, true, BLUE)?;
            if high.value - low.value > 1e-9 * high.value.abs() {
                panel.mark(ends[0].0, ends[0].1, false, BLUE)?;
            }
            Ok(())
        };
        let Some(target) = &synthesis.target else {
            let y = padded(achieved.iter().map(|p| p.1).chain([0.0]), 0.12);
            let y = if pushes { [0.0, y[1]] } else { y };
            let panel = over_the_law(canvas, synthesis, frame, y, e)?;
            panel.curve(&achieved, BLUE, 2.6)?;
            marks(&panel)?;
            panel.quantity(words.axis, 5.7 * e)?;
            panel.across(measures.angle_words())?;
            return key(canvas, legend, e, &[(BLUE, 2.6, words.curve)]);
        };
        let thetas: Vec<f64> = ends_of(synthesis)
            .into_iter()
            .chain(angles(law, TARGET_POINTS))
            .collect();
        let mut wanted: Vec<(f64, f64)> = thetas
            .iter()
            .map(|&t| (across(t), target_at(target, law, t)))
            .collect();
        wanted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let asked = asked_band(synthesis, &wanted);
        let band = asked.clone().or_else(|| spread(synthesis, &wanted));
        let frames = strips(frame, &[2.6, 1.0], 1.0 * e);

        let values = achieved.iter().chain(&wanted).map(|p| p.1);
        let edges = band
            .iter()
            .flat_map(|(u, l)| u.iter().chain(l))
            .map(|p| p.1);
        let y = padded(values.chain(edges).chain([0.0]), 0.1);
        let y = if pushes { [0.0, y[1]] } else { y };
        let panel = over_the_law(canvas, synthesis, frames[0], y, e)?;
        if let Some((upper, lower)) = &band {
            panel.band(upper, lower, ORANGE.mix(0.22))?;
        }
        panel.curve(&wanted, ORANGE.mix(0.55), 8.0)?;
        panel.curve(&achieved, BLUE, 2.4)?;
        marks(&panel)?;
        panel.quantity("force, N", 5.7 * e)?;

        let error: Vec<(f64, f64)> = motion(law)
            .iter()
            .map(|(t, m)| {
                let wanted = target_at(target, law, *t);
                (across(*t), synthesis.drive.force(*m) - wanted)
            })
            .collect();
        let rms = synthesis.force.rms_error_n;
        // What the difference is held against: the band that was asked for, the mean otherwise.
        let bounds: Vec<Vec<(f64, f64)>> = match &asked {
            Some((upper, lower)) => [upper, lower].map(|e| apart(e, &wanted)).to_vec(),
            None => [rms, -rms]
                .map(|level| ends_of(synthesis).map(|t| (across(t), level)).to_vec())
                .to_vec(),
        };
        let around = bounds.iter().flatten().map(|p| p.1);
        let y = padded(error.iter().map(|p| p.1).chain(around), 0.3);
        let panel = over_the_law(canvas, synthesis, frames[1], y, e)?;
        let zero: Vec<(f64, f64)> = error.iter().map(|p| (p.0, 0.0)).collect();
        panel.band(&error, &zero, RED.mix(0.14))?;
        panel.curve(&error, RED, 1.8)?;
        for bound in &bounds {
            panel.curve(bound, QUIET, 1.2)?;
        }
        panel.quantity("error, N", 5.7 * e)?;
        panel.across(measures.angle_words())?;

        let difference = if layout.title {
            let percent = number(synthesis.force.rms_error_percent_of_mean, 2);
            format!("difference, RMS {} N ({percent} % of mean)", number(rms, 3))
        } else {
            "difference".to_string()
        };
        let mut entries = vec![
            (ORANGE.mix(0.55), 8.0, "wanted"),
            (BLUE, 2.4, "given by the cam"),
            (RED, 1.8, difference.as_str()),
        ];
        if band.is_some() {
            let what = if asked.is_some() {
                "band asked for"
            } else {
                "± SD, step to step"
            };
            entries.insert(1, (ORANGE.mix(0.22), 14.0, what));
        }
        key(canvas, legend, e, &entries)
    })
}

/// What the diagram of forces is about.
struct Pressed {
    head: &'static str,
    axis: &'static str,
    curve: &'static str,
}

/// The drive whose force is drawn: where nothing presses, one unit of moved mass.
fn pressed(synthesis: &Synthesis) -> (Drive, Pressed) {
    let swings = synthesis.cam.follower.measures() == Measures::Oscillating;
    let words = |head, axis, curve| Pressed { head, axis, curve };
    let mut drive = synthesis.drive;
    if synthesis.is_idle() {
        drive.mass = 1.0;
        let words = if swings {
            words(
                "inertia, no load given",
                "moment, N·m",
                "moment of 1 kg·m² about the pivot",
            )
        } else {
            words("inertia, no load given", "force, N", "force of 1 kg moved")
        };
        return (drive, words);
    }
    let words = if swings {
        words("moment on the arm", "moment, N·m", "moment of the cam")
    } else {
        words("vertical force", "force, N", "force of the cam")
    };
    (drive, words)
}

/// The diagrams' frame below the line that names the curves.
pub(crate) fn force_frame(layout: Layout) -> Frame {
    let frame = layout.frame();
    Frame {
        top: frame.top + 1.9 * layout.letters,
        ..frame
    }
}

/// Upper and lower edge of the band that was asked for, at the angles of what is wanted.
#[allow(clippy::type_complexity)] // two curves
fn asked_band(
    synthesis: &Synthesis,
    wanted: &[(f64, f64)],
) -> Option<(Vec<(f64, f64)>, Vec<(f64, f64)>)> {
    let [low, high] = synthesis.band.as_ref()?;
    let cam = &synthesis.cam;
    let factor = cam.follower.measures().angle().factor;
    let edge = |curve: &ForceCurve| {
        let at = |across: f64| target_at(curve, &cam.law, across / factor);
        wanted.iter().map(|&(x, _)| (x, at(x))).collect()
    };
    Some((edge(high), edge(low)))
}

/// A curve less another at the same angles.
fn apart(curve: &[(f64, f64)], other: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let pairs = curve.iter().zip(other);
    pairs.map(|(c, o)| (c.0, c.1 - o.1)).collect()
}

/// Upper and lower edge of the step-to-step spread about the wanted force.
#[allow(clippy::type_complexity)] // two curves
fn spread(
    synthesis: &Synthesis,
    wanted: &[(f64, f64)],
) -> Option<(Vec<(f64, f64)>, Vec<(f64, f64)>)> {
    let target = synthesis.target.as_ref()?;
    let sd = target.spread_n.as_ref()?;
    let n = sd.len();
    if n == 0 {
        return None;
    }
    let (start, length) = synthesis.cam.law.extent();
    let at = |degrees: f64| {
        let x = ((degrees.to_radians() - start) / length).rem_euclid(1.0) * n as f64;
        let (i, u) = (x.floor() as usize, x.fract());
        (1.0 - u) * sd[i % n] + u * sd[(i + 1) % n]
    };
    let edge = |sign: f64| wanted.iter().map(|&(d, f)| (d, f + sign * at(d))).collect();
    Some((edge(1.0), edge(-1.0)))
}

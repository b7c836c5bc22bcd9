//! Force diagram: achieved force and target, with the error below.

use plotters::style::Color;

use crate::facts::{self, error_percent};
use crate::plot::axes::{Panel, padded};
use crate::plot::layout::{Figure, Layout, ends_of, strips};
use crate::plot::palette::{BLUE, ORANGE, QUIET, RED};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Drawn, Frame};
use crate::pose::motion;
use crate::pose::{angles, target_at};
use crate::words::{self, Words};
use gaitcam::cam::Measures;
use gaitcam::force::ForceCurve;
use gaitcam::law::Svaj;
use gaitcam::synth::Design;
use gaitcam::wording::Language;

/// Number of sampled points of the target and of its band.
const TARGET_POINTS: usize = 720;

/// Figure of the achieved force and the target, with the error in a second diagram below. A band shows the tolerance in the scene.
/// Without a tolerance, the band shows the step-to-step spread of the recording.
pub fn force(synthesis: &Design, language: Language) -> Picture {
    force_in(synthesis, Layout::ALONE, &words::words(language))
}

pub(crate) fn force_in(synthesis: &Design, layout: Layout, words: &Words) -> Picture {
    layout.picture(words.language(), |f| {
        let e = f.e;
        let names = Names::new(synthesis, words);
        f.title(&synthesis.problem.name, &names.head)?;
        let frame = force_frame(layout);
        let legend = [frame.left, frame.top - 1.1 * e];
        let achieved = Achieved::new(synthesis);
        let Some(target) = synthesis.target() else {
            let panel = achieved.panel(&f, synthesis, frame, std::iter::empty())?;
            panel.curve(&achieved.curve, BLUE, 2.6)?;
            achieved.marks(&panel)?;
            panel.quantity(&names.axis)?;
            let measures = synthesis.cam.follower.measures();
            panel.across(&words::across(words, measures))?;
            return f.key(legend, e, &[(BLUE, 2.6, &names.curve)]);
        };
        let desired = desired(synthesis, target);
        let tolerance = tolerance_band(synthesis, &desired);
        let band = tolerance.clone().or_else(|| spread(synthesis, &desired));
        let frames = strips(frame, &[2.6, 1.0], 1.0 * e);
        let edges = band.iter().flat_map(|(u, l)| u.iter().chain(l));
        let others = desired.iter().chain(edges).map(|p| p.1);
        let panel = achieved.panel(&f, synthesis, frames[0], others)?;
        if let Some((upper, lower)) = &band {
            panel.band(upper, lower, ORANGE.mix(0.22))?;
        }
        panel.curve(&desired, ORANGE.mix(0.55), 8.0)?;
        panel.curve(&achieved.curve, BLUE, 2.4)?;
        achieved.marks(&panel)?;
        panel.quantity(&names.axis)?;
        let held = tolerance.as_ref().map(|band| (band, desired.as_slice()));
        difference(&f, synthesis, target, frames[1], held, words)?;

        let text = |key: &str| words.text(key);
        let error = if layout.title {
            let percent = error_percent(synthesis, words.language());
            let (column, value) = ("force_rms_error_n", synthesis.force.rms_error_n);
            let rms = facts::force(synthesis, column, value, words.language());
            let arguments = [("rms", rms.as_str()), ("percent", &percent)];
            words.fill("figure-difference-rms", &arguments)
        } else {
            text("figure-difference")
        };
        let (target, given) = (text("figure-target"), text("figure-achieved"));
        let around = text(match tolerance {
            Some(_) => "figure-tolerance-band",
            None => "figure-step-band",
        });
        let mut entries = vec![
            (ORANGE.mix(0.55), 8.0, target.as_str()),
            (BLUE, 2.4, &given),
            (RED, 1.8, &error),
        ];
        if band.is_some() {
            entries.insert(1, (ORANGE.mix(0.22), 14.0, &around));
        }
        if tolerance.is_none() {
            entries.push((QUIET, 1.2, "± RMS"));
        }
        f.key(legend, e, &entries)
    })
}

/// Force of the cam over the displayed cam angle, with its minimum and maximum.
struct Achieved {
    curve: Vec<(f64, f64)>,
    low: (f64, f64),
    high: (f64, f64),
}

impl Achieved {
    fn new(synthesis: &Design) -> Self {
        let law = synthesis.pressing();
        let factor = synthesis.cam.follower.measures().angle().factor;
        let mut drive = synthesis.problem.drive;
        if synthesis.is_idle() {
            // Without mass, spring, damping and preload, the force is zero. The force of a moved mass of 1 kg is drawn instead.
            drive.mass = 1.0;
        }
        let idle = synthesis.is_idle();
        let curve = if idle {
            drive.force_curve(law)
        } else {
            synthesis.force_curve()
        };
        let (low, high) = curve.extremes();
        let force = |t: f64, m: Svaj| {
            if idle {
                drive.force(m)
            } else {
                synthesis.force_at(t)
            }
        };
        Achieved {
            curve: motion(law)
                .iter()
                .map(|(t, m)| (factor * t, force(*t, *m)))
                .collect(),
            low: (factor * low.at, low.value),
            high: (factor * high.at, high.value),
        }
    }

    /// Diagram with a vertical range that contains the force and the values `others`. If the force is never negative, the range begins at
    /// zero.
    fn panel<'a, 'c>(
        &self,
        f: &Figure<'a, 'c>,
        synthesis: &Design,
        frame: Frame,
        others: impl Iterator<Item = f64>,
    ) -> Drawn<Panel<'a, 'c>> {
        let values = self.curve.iter().map(|p| p.1).chain(others);
        let y = padded(values.chain([0.0]), 0.12);
        let pushes = self.low.1 >= -1e-9 * self.high.1.abs();
        let y = if pushes { [0.0, y[1]] } else { y };
        f.over_the_law(synthesis, frame, y)
    }

    fn marks(&self, panel: &Panel) -> Drawn {
        panel.mark(self.high, true, BLUE, false)?;
        // A minimum of zero is not marked, because the axis shows it.
        let [low, high] = [self.low.1, self.high.1];
        if high - low > 1e-9 * high.abs() && low.abs() > 1e-6 * high.abs() {
            panel.mark(self.low, false, BLUE, false)?;
        }
        Ok(())
    }
}

/// Points (displayed cam angle, force) of the target.
fn desired(synthesis: &Design, target: &ForceCurve) -> Vec<(f64, f64)> {
    let law = synthesis.pressing();
    let factor = synthesis.cam.follower.measures().angle().factor;
    let mut curve: Vec<(f64, f64)> = ends_of(synthesis)
        .into_iter()
        .chain(angles(law, TARGET_POINTS))
        .map(|t| (factor * t, target_at(target, law, t)))
        .collect();
    curve.sort_by(|a, b| a.0.total_cmp(&b.0));
    curve
}

/// Diagram of the force error. It contains the edges of the tolerance band relative to the target. Without a band, it contains lines at
/// plus and minus the RMS error.
fn difference(
    f: &Figure,
    synthesis: &Design,
    target: &ForceCurve,
    frame: Frame,
    held: Option<(&Band, &[(f64, f64)])>,
    words: &Words,
) -> Drawn {
    let law = synthesis.pressing();
    let measures = synthesis.cam.follower.measures();
    let across = |t: f64| measures.angle().factor * t;
    let error: Vec<(f64, f64)> = motion(law)
        .iter()
        .map(|(t, _)| {
            let desired = target_at(target, law, *t);
            (across(*t), synthesis.force_at(*t) - desired)
        })
        .collect();
    let rms = synthesis.force.rms_error_n;
    let bounds: Vec<Vec<(f64, f64)>> = match held {
        Some(((upper, lower), desired)) => [upper, lower].map(|e| apart(e, desired)).to_vec(),
        None => [rms, -rms]
            .map(|level| ends_of(synthesis).map(|t| (across(t), level)).to_vec())
            .to_vec(),
    };
    let around = bounds.iter().flatten().map(|p| p.1);
    let y = padded(error.iter().map(|p| p.1).chain(around), 0.3);
    let panel = f.over_the_law(synthesis, frame, y)?;
    let zero: Vec<(f64, f64)> = error.iter().map(|p| (p.0, 0.0)).collect();
    panel.band(&error, &zero, RED.mix(0.14))?;
    panel.curve(&error, RED, 1.8)?;
    for bound in &bounds {
        panel.curve(bound, QUIET, 1.2)?;
    }
    panel.quantity(&words.text(match measures {
        Measures::Oscillating => "figure-error-moment",
        _ => "figure-error",
    }))?;
    panel.across(&words::across(words, measures))
}

/// Texts of the force diagram: title, vertical axis, and name of the curve.
struct Names {
    head: String,
    axis: String,
    curve: String,
}

impl Names {
    fn new(synthesis: &Design, words: &Words) -> Self {
        let swings = synthesis.cam.follower.measures() == Measures::Oscillating;
        let (head, curve) = match (synthesis.is_idle(), swings) {
            (true, true) => ("figure-inertia", "figure-moment-of-unit"),
            (true, false) => ("figure-inertia", "figure-force-of-unit"),
            (false, true) => ("figure-arm-moment", "figure-moment-alone"),
            (false, false) => ("figure-vertical-force", "figure-force-alone"),
        };
        let axis = if swings {
            "figure-moment"
        } else {
            "figure-force"
        };
        let [head, axis, curve] = [head, axis, curve].map(|key| words.text(key));
        Names { head, axis, curve }
    }
}

/// Frame of the diagrams of a layout, with space above it for the legend.
pub(crate) fn force_frame(layout: Layout) -> Frame {
    let frame = layout.frame();
    Frame {
        top: frame.top + 1.9 * layout.letters,
        ..frame
    }
}

/// Upper and lower edge of a band.
type Band = (Vec<(f64, f64)>, Vec<(f64, f64)>);

/// Upper and lower edge of the tolerance band of the scene, at the angles of `desired`; `None` without a band.
fn tolerance_band(synthesis: &Design, desired: &[(f64, f64)]) -> Option<Band> {
    let [low, high] = synthesis.band()?;
    let cam = &synthesis.cam;
    let factor = cam.follower.measures().angle().factor;
    let edge = |curve: &ForceCurve| {
        let at = |across: f64| target_at(curve, &cam.law, across / factor);
        desired.iter().map(|&(x, _)| (x, at(x))).collect()
    };
    Some((edge(high), edge(low)))
}

/// Difference `curve` − `other` of two curves at the same angles.
fn apart(curve: &[(f64, f64)], other: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let pairs = curve.iter().zip(other);
    pairs.map(|(c, o)| (c.0, c.1 - o.1)).collect()
}

/// Upper and lower edge of the step-to-step spread about the target force; `None` without a spread.
fn spread(synthesis: &Design, desired: &[(f64, f64)]) -> Option<Band> {
    let target = synthesis.target()?;
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
    let edge = |sign: f64| {
        desired
            .iter()
            .map(|&(d, f)| (d, f + sign * at(d)))
            .collect()
    };
    Some((edge(1.0), edge(-1.0)))
}

//! Figure of a walk at resonance: response of a vibration mode as a function of its natural frequency.

use plotters::style::{Color, RGBAColor};

use crate::figures::force::force_frame;
use crate::plot::axes::{padded, ticks};
use crate::plot::layout::Layout;
use crate::plot::palette::{BLUE, GREEN, ORANGE, QUIET};
use crate::plot::picture::Picture;
use crate::words::{self, Words};
use gaitcam::dynamics::RepeatedForce;
use gaitcam::force::Walk;
use gaitcam::synth::Design;
use gaitcam::wording::Language;

/// Damping ratio of the vibration mode in the figure.
const DAMPING: f64 = 0.005;
/// Number of recorded strides that an electronic cam repeats. The figure shows the response to this repeated force.
const STRIDES: usize = 16;

/// A force for which the response of a mode is computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    /// Source of the force.
    pub of: Responding,
    /// Periodic force that excites the mode.
    pub force: RepeatedForce,
}

/// Source of a force that excites a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Responding {
    /// Force of the recorded strides.
    Recorded,
    /// Force of the generated strides.
    Generated,
    /// Force of the cam at constant speed.
    Cam,
    /// Force of the given number of recorded strides, repeated periodically.
    Strides(usize),
    /// Force of the cam with a speed programme.
    Programme,
}

/// Figure of three responses: to the recorded walk, to this cam at constant speed, and to a few recorded strides that are repeated.
/// Without a recorded walk, only the frame is drawn.
pub fn resonance(design: &Design, language: Language) -> Picture {
    resonance_in(design, Layout::ALONE, &words::words(language))
}

/// Draws the figure of [`resonance`] with a given layout.
pub(crate) fn resonance_in(design: &Design, layout: Layout, words: &Words) -> Picture {
    let mut all = Vec::new();
    if let Some((walk, [recorded, cam])) = design.repeated() {
        let response = |of, force| Response { of, force };
        all.push(response(Responding::Recorded, recorded));
        all.push(response(Responding::Cam, cam));
        all.extend(repeated_strides(&walk));
    }
    drawn(&design.problem.name, &all, layout, words)
}

/// Figure of the responses of a vibration mode to several forces. The range of natural frequencies is around the step frequency of the
/// first force.
pub fn responses(name: &str, all: &[Response], language: Language) -> Picture {
    drawn(name, all, Layout::ALONE, &words::words(language))
}

/// Periodic force of 16 typical consecutive strides of a walk. `None` if the walk has at most 16 strides.
pub fn repeated_strides(walk: &Walk) -> Option<Response> {
    let part = walk.typical(STRIDES).filter(|_| walk.strides() > STRIDES)?;
    Some(Response {
        of: Responding::Strides(STRIDES),
        force: RepeatedForce::of(&part),
    })
}

fn look(of: Responding) -> (RGBAColor, f64) {
    match of {
        Responding::Recorded | Responding::Generated => (ORANGE.mix(0.55), 8.0),
        Responding::Cam => (BLUE, 2.2),
        Responding::Strides(_) => (QUIET, 2.2),
        Responding::Programme => (GREEN, 2.2),
    }
}

fn drawn(name: &str, all: &[Response], layout: Layout, words: &Words) -> Picture {
    let step_frequency = all.first().map_or(1.0, |r| r.force.step_frequency_hz);
    let at = RepeatedForce::tunings(step_frequency);
    let curve = |r: &Response| -> Vec<(f64, f64)> {
        let response = r.force.about(step_frequency, DAMPING);
        at.iter().copied().zip(response).collect()
    };
    let curves: Vec<_> = all.iter().map(curve).collect();
    layout.picture(words.language(), |f| {
        let damping = words.number(100.0 * DAMPING);
        f.title(
            name,
            &words.fill("figure-resonance", &[("damping", &damping)]),
        )?;
        let most = curves.iter().flatten().map(|p| p.1).fold(0.0, f64::max);
        let x = [at[0], at[at.len() - 1]];
        let y = padded([0.0, most].into_iter(), 0.12);
        let frame = force_frame(layout);
        let panel = f.panel(frame, x, ticks(x[0], x[1], 8.0), [0.0, y[1]])?;
        for (response, curve) in all.iter().zip(&curves) {
            let (colour, width) = look(response.of);
            panel.curve(curve, colour, width)?;
        }
        let names: Vec<String> = all
            .iter()
            .map(|r| match r.of {
                Responding::Recorded => words.text("figure-resonance-recorded"),
                Responding::Generated => words.text("figure-resonance-generated"),
                Responding::Cam => words.text("figure-resonance-cam"),
                Responding::Strides(count) => {
                    words.fill("figure-resonance-strides", &[("count", &count.to_string())])
                }
                Responding::Programme => words.text("figure-resonance-programme"),
            })
            .collect();
        let entries: Vec<_> = (all.iter().zip(&names))
            .map(|(r, name)| {
                let (colour, width) = look(r.of);
                (colour, width, name.as_str())
            })
            .collect();
        f.key([frame.left, frame.top - 1.1 * f.e], f.e, &entries)?;
        panel.quantity(&words.text("figure-resonance-acceleration"))?;
        panel.across(&words.text("figure-resonance-frequency"))
    })
}

//! Diagrams of the law of motion.

use crate::plot::axes::padded;
use crate::plot::layout::{Layout, strips};
use crate::plot::palette::{BLUE, GREEN, PURPLE, RED};
use crate::plot::picture::Picture;
use crate::pose::motion;
use crate::words::{self, Words};
use gaitcam::cam::{Cam, Unit};
use gaitcam::law::Svaj;
use gaitcam::synth::Design;
use gaitcam::wording::Language;

/// Figure of lift, velocity, acceleration and jerk over the cam angle, with marked extremes.
pub fn svaj(synthesis: &Design, language: Language) -> Picture {
    svaj_in(synthesis, Layout::ALONE, &words::words(language))
}

pub(crate) fn svaj_in(synthesis: &Design, layout: Layout, words: &Words) -> Picture {
    layout.picture(words.language(), |f| {
        let law = &synthesis.cam.law;
        let measures = synthesis.cam.follower.measures();
        let across = |t: f64| measures.angle().factor * t;
        let motion = motion(law);
        let names = ["s", "v", "a", "j"];
        let pick: [fn(&Svaj) -> f64; 4] = [|m| m.s, |m| m.v, |m| m.a, |m| m.j];
        let colours = [BLUE, GREEN, RED, PURPLE];
        f.title(&synthesis.problem.name, &words.text("figure-law"))?;
        let frames = strips(layout.frame(), &[1.0; 4], 0.9 * f.e);
        for k in 0..4 {
            let Unit { factor, name: unit } = measures.lift(k);
            let curve: Vec<(f64, f64)> = motion
                .iter()
                .map(|(t, m)| (across(*t), factor * pick[k](m)))
                .collect();
            let (low, high) = law.extremes(k);
            let ends = [low.value, high.value].map(|v| factor * v);
            let y = padded(ends.into_iter(), 0.26);
            let panel = f.over_the_law(synthesis, frames[k], y)?;
            panel.curve(&curve, colours[k], 2.4)?;
            let (lowest, highest) = synthesis.cam.derivative_extremes(k);
            if ends[1] > ends[0] && highest.value.is_finite() {
                panel.mark((across(high.at), ends[1]), true, colours[k], false)?;
            }
            if ends[1] > ends[0] && lowest.value.is_finite() {
                panel.mark((across(low.at), ends[0]), false, colours[k], false)?;
            }
            for (at, up) in infinities(&synthesis.cam, k) {
                panel.infinity(across(at), up, colours[k])?;
            }
            panel.quantity(&format!("{}, {unit}", names[k]))?;
            if k == 3 {
                panel.across(&words::across(words, measures))?;
            }
        }
        Ok(())
    })
}

/// Positions at which the derivative of order `order` is infinite, each with its sign (`true` for +∞). A jump of the derivative of order
/// `order` − 1 gives an infinite value of one sign. A jump of a derivative of lower order gives infinite values of both signs.
fn infinities(cam: &Cam, order: usize) -> Vec<(f64, bool)> {
    let mut out = Vec::new();
    for below in 0..order {
        for jump in cam.jumps(below) {
            let both = below + 1 < order;
            if both || jump.value > 0.0 {
                out.push((jump.at, true));
            }
            if both || jump.value < 0.0 {
                out.push((jump.at, false));
            }
        }
    }
    out
}

//! Figure of a moving floor: peak acceleration over the step frequency.

use plotters::style::Color;
use plotters_backend::text_anchor::VPos;

use crate::figures::force::force_frame;
use crate::plot::axes::{padded, ticks};
use crate::plot::layout::Layout;
use crate::plot::palette::{BLUE, ORANGE, QUIET};
use crate::plot::picture::Picture;
use crate::words::{self, Words};
use gaitcam::dynamics::FloorMotion;
use gaitcam::synth::{AtFrequency, Design};
use gaitcam::wording::Language;

/// Figure of the peak acceleration of the floor as a function of the step frequency.
pub fn floor(design: &Design, language: Language) -> Picture {
    resonance_in(design, Layout::ALONE, &words::words(language))
}

/// Peak acceleration for the required force and for the cam, with the limits of the comfort classes. Without a floor, only the frame is
/// drawn.
fn resonance_in(design: &Design, layout: Layout, words: &Words) -> Picture {
    let points = design.resonance();
    let curve = |of: fn(&AtFrequency) -> FloorMotion| -> Vec<(f64, f64)> {
        let at = |p: &AtFrequency| (p.step_frequency, of(p).acceleration_peak_m_per_s2);
        points.iter().map(at).collect()
    };
    let (wanted, own) = (curve(|p| p.motion), curve(|p| p.of_cam));
    layout.picture(words.language(), |f| {
        f.title(&design.problem.name, &words.text("figure-floor"))?;
        let ends = wanted.first().zip(wanted.last());
        let x = ends.map_or([0.0, 1.0], |(a, b)| [a.0, b.0]);
        let most = wanted.iter().chain(&own).map(|p| p.1).fold(0.0, f64::max);
        let y = padded([0.0, most].into_iter(), 0.12);
        let frame = force_frame(layout);
        let panel = f.panel(frame, x, ticks(x[0], x[1], 8.0), [0.0, y[1]])?;
        panel.curve(&wanted, ORANGE.mix(0.55), 8.0)?;
        panel.curve(&own, BLUE, 2.2)?;
        for (class, bound) in (1..).zip(FloorMotion::CLASSES) {
            if bound < y[1] {
                let name = format!("CL{class}");
                panel.level(bound, Some((&name, VPos::Top)), QUIET, &wanted)?;
            }
        }
        let [target, cam] = ["figure-floor-wanted", "figure-floor-cam"].map(|k| words.text(k));
        let entries = [(ORANGE.mix(0.55), 8.0, &*target), (BLUE, 2.2, &*cam)];
        f.key([frame.left, frame.top - 1.1 * f.e], f.e, &entries)?;
        panel.quantity(&words.text("figure-floor-acceleration"))?;
        panel.across(&words.text("figure-step-frequency"))
    })
}

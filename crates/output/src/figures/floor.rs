//! The picture of a floor that moves: its peak acceleration over the step frequency.

use plotters_backend::text_anchor::VPos;

use crate::plot::axes::{padded, ticks};
use crate::plot::layout::Layout;
use crate::plot::palette::{BLUE, QUIET};
use crate::plot::picture::Picture;
use crate::words::{self, Words};
use gaitcam::dynamics::FloorMotion;
use gaitcam::synth::Design;
use gaitcam::wording::Language;

/// The peak acceleration of the floor over the step frequency.
pub fn floor(design: &Design, language: Language) -> Picture {
    resonance_in(design, Layout::ALONE, &words::words(language))
}

/// The resonance curve with the bounds of the comfort classes; nothing but its frame without a floor.
fn resonance_in(design: &Design, layout: Layout, words: &Words) -> Picture {
    let points = design.floor.iter().flat_map(|f| &f.resonance);
    let curve: Vec<(f64, f64)> = points
        .map(|p| (p.step_frequency, p.motion.acceleration_peak_m_per_s2))
        .collect();
    layout.picture(words.language(), |f| {
        f.title(&design.name, &words.text("figure-floor"))?;
        let ends = curve.first().zip(curve.last());
        let x = ends.map_or([0.0, 1.0], |(a, b)| [a.0, b.0]);
        let most = curve.iter().map(|p| p.1).fold(0.0, f64::max);
        let y = padded([0.0, most].into_iter(), 0.12);
        let panel = f.panel(layout.frame(), x, ticks(x[0], x[1], 8.0), [0.0, y[1]])?;
        panel.curve(&curve, BLUE, 2.2)?;
        for (class, bound) in (1..).zip(FloorMotion::CLASSES) {
            if bound < y[1] {
                let name = format!("CL{class}");
                panel.level(bound, Some((&name, VPos::Top)), QUIET, &curve)?;
            }
        }
        panel.quantity(&words.text("figure-floor-acceleration"))?;
        panel.across(&words.text("figure-step-frequency"))
    })
}

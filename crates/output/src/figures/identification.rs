//! Figure of an identified machine: measured force, modelled force and residual over the cam angle.

use gaitcam::identify::Identified;
use gaitcam::synth::Design;
use gaitcam::wording::Language;

use super::overlay::{Strip, diagrams_over};
use crate::plot::picture::Picture;
use crate::words;

/// Figure of the mean measured cycle of the first log, the force of the model, and their difference.
pub fn identification(design: &Design, found: &Identified, language: Language) -> Picture {
    let words = words::words(language);
    let log = &found.logs[0];
    let count = log.measured_n.len();
    let curve = |of: &dyn Fn(usize) -> f64| -> Vec<(f64, f64)> {
        (0..=count)
            .map(|i| (360.0 * i as f64 / count as f64, of(i % count)))
            .collect()
    };
    let (measured, modelled) = (&log.measured_n, &log.modelled_n);
    let unit = |key: &str| format!("{}, N", words.text(key));
    let rows = [
        Strip {
            quantity: unit("figure-inspected-force"),
            curves: vec![curve(&|i| measured[i]), curve(&|i| modelled[i]), Vec::new()],
        },
        Strip {
            quantity: unit("figure-residual"),
            curves: vec![
                Vec::new(),
                Vec::new(),
                curve(&|i| measured[i] - modelled[i]),
            ],
        },
    ];
    let names = ["figure-measured", "figure-modelled", "figure-residual"];
    let names = names.map(|key| words.text(key));
    let across = words::across(&words, design.cam.follower.measures());
    let what = words.text("figure-identification");
    diagrams_over(
        &across,
        &design.problem.name,
        &what,
        &names,
        &rows,
        language,
    )
}

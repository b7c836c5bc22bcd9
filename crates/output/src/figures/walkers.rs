//! Figure of a population: required forces of all walkers, and the cam force for the walker with the maximum error.

use std::f64::consts::TAU;

use plotters::style::Color;

use super::force::force_frame;
use crate::plot::axes::{angle_ticks, padded};
use crate::plot::layout::Layout;
use crate::plot::palette::{BLUE, ORANGE};
use crate::plot::picture::Picture;
use crate::words::{self, Words};
use gaitcam::problem::Served;
use gaitcam::scene::ErrorMeasure;
use gaitcam::synth::Design;
use gaitcam::wording::{Language, walker};

/// Number of angle steps per turn.
const STEPS: usize = 360;

/// Figure with the required forces of all walkers as a band, in percent of the mean force of each walker. For the walker with the maximum
/// error, it also contains the required force and the force of the cam.
pub fn walkers(design: &Design, language: Language) -> Picture {
    walkers_in(design, Layout::ALONE, &words::words(language))
}

fn walkers_in(design: &Design, layout: Layout, words: &Words) -> Picture {
    let walkers = design.problem.walkers.as_deref();
    let each = walkers.map_or(&[][..], |w| &w.each);
    let report = design.population.as_ref();
    let worst = report.and_then(|p| Some((each.get(p.worst)?, &p.each[p.worst])));
    let part = |walker: &Served, force: f64| 100.0 * force / walker.target.mean_n().abs();
    let places = (0..=STEPS).map(|i| TAU * i as f64 / STEPS as f64);
    let degrees = |x: f64| x.to_degrees();
    let (mut low, mut high, mut wanted, mut given) = (vec![], vec![], vec![], vec![]);
    for x in places {
        let forces = each.iter().map(|w| part(w, w.target.at(x)));
        let ends = forces.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], f| {
            [a.min(f), b.max(f)]
        });
        low.push((degrees(x), ends[0]));
        high.push((degrees(x), ends[1]));
        if let Some((walker, _)) = worst {
            wanted.push((degrees(x), part(walker, walker.target.at(x))));
            let force = walker.drive.force(design.pressing().svaj(x));
            given.push((degrees(x), part(walker, force)));
        }
    }
    layout.picture(words.language(), |f| {
        f.title(&design.problem.name, &words.text("figure-walkers"))?;
        let frame = force_frame(layout);
        let curves = [&low, &high, &given, &wanted];
        let values = curves.into_iter().flatten().map(|p| p.1);
        let y = padded(values, 0.12);
        let panel = f.panel(frame, [0.0, 360.0], angle_ticks([0.0, 360.0]), y)?;
        panel.band(&high, &low, ORANGE.mix(0.22))?;
        panel.curve(&wanted, ORANGE.mix(0.8), 3.0)?;
        panel.curve(&given, BLUE, 2.4)?;
        panel.quantity(&words.text("figure-walkers-force"))?;
        panel.across(&words.text("figure-angle"))?;
        let name = worst.map_or(String::new(), |(w, _)| walker(words.language(), &w.name));
        let error = worst.map_or(String::new(), |(_, e)| match walkers.map(|w| w.error) {
            Some(ErrorMeasure::Absolute) => format!("{} N", words.number(e.rms_error_n)),
            _ => format!("{} %", words.number(e.rms_error_percent)),
        });
        let wanted = words.fill("figure-walkers-worst", &[("name", &name)]);
        let given = words.fill("figure-walkers-cam", &[("error", &error)]);
        let band = words.text("figure-walkers-band");
        let legend = [frame.left, frame.top - 1.1 * f.e];
        f.key(
            legend,
            f.e,
            &[
                (ORANGE.mix(0.22), 14.0, &band),
                (ORANGE.mix(0.8), 3.0, &wanted),
                (BLUE, 2.4, &given),
            ],
        )
    })
}

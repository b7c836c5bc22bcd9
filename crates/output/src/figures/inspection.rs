//! Figures of a measured cam: deviations over the cam angle, and deviations along the profile.

use gaitcam::cam::Inspection;
use gaitcam::sweep::MadeCam;
use gaitcam::synth::Design;
use gaitcam::wording::Language;

use super::overlay::{Strip, diagrams_over, profiles};
use crate::plot::picture::Picture;
use crate::words;

/// Number of points of the profile and of the force curves.
const POINTS: usize = 1440;
/// Maximum length of a drawn deviation in the polar figure, as a fraction of the prime radius.
const SHOWN: f64 = 0.08;

/// Diagram of the deviations normal to the profile, µm. If `made` is given, a second diagram contains the forces of the cam as designed and
/// as manufactured.
pub fn diagram(
    design: &Design,
    inspected: &Inspection,
    made: Option<&MadeCam>,
    language: Language,
) -> Picture {
    let words = words::words(language);
    let measures = design.cam.follower.measures();
    let points = inspected
        .deviations
        .iter()
        .map(|d| (d.theta.to_degrees(), 1e6 * d.normal));
    let mut rows = vec![Strip {
        quantity: words.text("figure-deviation"),
        curves: vec![points.collect(), Vec::new()],
    }];
    let forces = made.filter(|_| !design.is_idle()).map(|made| {
        let force = |law: &gaitcam::law::Law| -> Vec<(f64, f64)> {
            (0..=POINTS)
                .map(|i| {
                    let theta = std::f64::consts::TAU * i as f64 / POINTS as f64;
                    (
                        theta.to_degrees(),
                        design.problem.drive.force(law.svaj(theta)),
                    )
                })
                .collect()
        };
        vec![force(&made.law), force(design.pressing())]
    });
    if let Some(curves) = forces {
        let name = format!(
            "{}, {}",
            words.text("figure-inspected-force"),
            measures.force().name
        );
        rows.push(Strip {
            quantity: name,
            curves,
        });
    }
    let names = ["figure-as-made", "figure-as-designed"].map(|key| words.text(key));
    let across = words::across(&words, measures);
    let what = words.text("figure-inspection");
    diagrams_over(
        &across,
        &design.problem.name,
        &what,
        &names,
        &rows,
        language,
    )
}

/// Figure of the profile with the deviations along its normals, magnified by a factor of the sequence 1, 2, 5, 10, 20 …
pub fn polar(design: &Design, inspected: &Inspection, language: Language) -> Picture {
    let words = words::words(language);
    let cam = &design.cam;
    let largest = inspected
        .deviations
        .iter()
        .fold(0.0_f64, |m, d| m.max(d.normal.abs()));
    let factor = round_down(SHOWN * cam.follower.prime_radius() / largest.max(1e-12));
    let profile = cam.profile(POINTS);
    let mut exact: Vec<[f64; 2]> = profile.iter().map(|p| [p.x, p.y]).collect();
    exact.extend(exact.first().copied());
    let mut measured: Vec<[f64; 2]> = inspected
        .deviations
        .iter()
        .map(|d| {
            let p = cam.point(d.theta);
            let [nx, ny] = cam.normal(&p);
            let off = factor * d.normal;
            [p.x + off * nx, p.y + off * ny]
        })
        .collect();
    measured.extend(measured.first().copied());
    let shown = words.number(factor);
    let names = [
        words.text("figure-as-designed"),
        words.fill("figure-exaggerated", &[("factor", &shown)]),
    ];
    let what = words.text("figure-inspection");
    profiles(
        &design.problem.name,
        &what,
        &names,
        &[exact, measured],
        language,
    )
}

/// Maximum number of the sequence 1, 2, 5, 10, 20 … that does not exceed `x`; 1 if `x` is smaller.
fn round_down(x: f64) -> f64 {
    let ten = libm::pow(10f64, libm::log10(x.max(1.0)).floor());
    let part = x.max(1.0) / ten;
    let step = [5.0, 2.0].into_iter().find(|s| *s <= part);
    ten * step.unwrap_or(1.0)
}

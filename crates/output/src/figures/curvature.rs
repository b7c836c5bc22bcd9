//! Figure with two diagrams: the radius of curvature, and the pressure angle or the contact position on a flat face.

use plotters_backend::text_anchor::VPos;

use crate::plot::axes::{Panel, padded};
use crate::plot::layout::{Figure, Layout, strips};
use crate::plot::palette::{BLUE, GREEN, RED};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Drawn, Frame};
use crate::pose::{largest_radius, motion};
use crate::words::{self, Words};
use gaitcam::cam::{Cam, Check, Unit};
use gaitcam::criterion::Diagram;
use gaitcam::criterion::LimitKind;
use gaitcam::law::Svaj;
use gaitcam::poly::Extreme;
use gaitcam::synth::Design;

/// Maximum radius of curvature in the figure, as a multiple of the prime radius or the stroke, whichever is larger. Profiles with larger
/// radii look straight.
const CAP: f64 = 2.2;

/// Figure of the radius of curvature and the pressure angle over the cam angle. For a flat face, the contact position replaces the
/// pressure angle.
pub(crate) fn geometry_in(synthesis: &Design, layout: Layout, words: &Words) -> Picture {
    layout.picture(words.language(), |f| {
        let measures = synthesis.cam.follower.measures();
        let lengths = Unit::length().factor;
        f.title(&synthesis.problem.name, &words.text("figure-curvature"))?;
        let frames = strips(layout.frame(), &[1.0, 1.0], 1.2 * f.e);
        radius(&f, synthesis, frames[0], words)?;
        let place = |e: Extreme, value: f64| (measures.angle().factor * e.at, value);
        let (panel, name, [low, high]) = match synthesis.cam.contact_travel() {
            Some((low, high)) => {
                let ends = [low, high].map(|e| place(e, lengths * e.value));
                let panel = contact(&f, synthesis, frames[1], ends)?;
                (panel, "figure-contact-travel", ends)
            }
            None => {
                let (low, high) = synthesis.pressure_angle_extremes();
                let ends = [low, high].map(|e| place(e, e.value.to_degrees()));
                let panel = pressure(&f, synthesis, frames[1], words, ends)?;
                (panel, "figure-pressure-angle", ends)
            }
        };
        panel.mark(high, true, GREEN, true)?;
        panel.mark(low, false, GREEN, true)?;
        panel.quantity(&words::with_length_unit(words, name))?;
        panel.across(&words::across(words, measures))
    })
}

/// Points (displayed cam angle, value) of a quantity at the sampled angles of the law.
fn over_the_angle(cam: &Cam, value: impl Fn(f64, Svaj) -> f64) -> Vec<(f64, f64)> {
    let across = cam.follower.measures().angle().factor;
    let motion = motion(&cam.law);
    let points = motion.iter().map(|(t, m)| (across * t, value(*t, *m)));
    points.collect()
}

fn radius(f: &Figure, synthesis: &Design, frame: Frame, words: &Words) -> Drawn {
    let (cam, lengths) = (&synthesis.cam, Unit::length().factor);
    let rho = over_the_angle(cam, |t, _| lengths * cam.point(t).rho);
    let radii = rho.iter().map(|p| p.1.abs());
    let cap = largest_radius(cam, lengths * CAP, radii);
    let sharpest = cam.curvature().convex;
    let shown = rho.iter().map(|p| p.1).filter(|r| r.abs() <= cap);
    let y = padded(shown.chain([0.0, lengths * sharpest.value]), 0.18);
    let panel = f.over_the_law(synthesis, frame, y)?;
    // The radius passes through infinity between convex and concave parts of the profile.
    for part in rho.chunk_by(|a, b| a.1.signum() == b.1.signum() || a.1.abs() < cap) {
        panel.curve(part, BLUE, 2.2)?;
    }
    // A limit of 0 only excludes undercut. The line of this limit would coincide with the axis and is not drawn.
    let limits = synthesis.checks.iter();
    for check in limits.filter(|c| c.name == LimitKind::Curvature && c.limit > 0.0) {
        let value = words.length(check.limit);
        let name = words.fill("figure-limit", &[("value", &value)]);
        let level = lengths * check.limit;
        panel.level(level, Some((&name, VPos::Bottom)), RED, &rho)?;
    }
    if sharpest.value.is_finite() {
        let across = cam.follower.measures().angle().factor;
        let at = (across * sharpest.at, lengths * sharpest.value);
        panel.mark(at, true, BLUE, true)?;
    }
    panel.quantity(&words::with_length_unit(words, "figure-rho"))
}

/// Diagram of the position of the contact along a flat face.
fn contact<'a, 'c>(
    f: &Figure<'a, 'c>,
    synthesis: &Design,
    frame: Frame,
    ends: [(f64, f64); 2],
) -> Drawn<Panel<'a, 'c>> {
    let y = padded(ends.into_iter().map(|e| e.1), 0.26);
    let panel = f.over_the_law(synthesis, frame, y)?;
    let (cam, lengths) = (&synthesis.cam, Unit::length().factor);
    let contact = over_the_angle(cam, |_, m| lengths * cam.contact_along(m));
    panel.curve(&contact, GREEN, 2.2)?;
    Ok(panel)
}

/// Diagram of the pressure angle, degrees, with its limits.
fn pressure<'a, 'c>(
    f: &Figure<'a, 'c>,
    synthesis: &Design,
    frame: Frame,
    words: &Words,
    ends: [(f64, f64); 2],
) -> Drawn<Panel<'a, 'c>> {
    let limits = synthesis.checks.iter().flat_map(pressure_lines);
    let values = ends.into_iter().map(|e| e.1).chain(limits.clone());
    let y = padded(values.chain([0.0]), 0.2);
    let panel = f.over_the_law(synthesis, frame, y)?;
    let phi = over_the_angle(&synthesis.cam, |theta, _| {
        let angle = match &synthesis.groove {
            Some(groove) => groove.pressure_angle(theta, groove.depth().0),
            None => synthesis.cam.point(theta).pressure_angle,
        };
        angle.to_degrees()
    });
    panel.curve(&phi, GREEN, 2.2)?;
    for limit in limits {
        let side = if limit < 0.0 { VPos::Top } else { VPos::Bottom };
        let value = format!("{}°", words.number(limit));
        let name = words.fill("figure-limit", &[("value", &value)]);
        panel.level(limit, Some((&name, side)), RED, &phi)?;
    }
    Ok(panel)
}

/// Values of the pressure angle at which lines for its limit are drawn, degrees.
fn pressure_lines(check: &Check) -> Vec<f64> {
    let shown = check.name.limit().and_then(|kind| kind.facts().diagram);
    match shown {
        Some((Diagram::PressureAngle, lines)) => lines.heights(check.limit.to_degrees(), 0.0),
        _ => Vec::new(),
    }
}

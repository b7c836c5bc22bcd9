//! The picture of curvature and contact.

use plotters_backend::text_anchor::VPos;

use crate::plot::axes::padded;
use crate::plot::layout::{Layout, strips};
use crate::plot::palette::{BLUE, GREEN, RED};
use crate::plot::picture::Picture;
use crate::pose::motion;
use crate::words::{self, Words};
use gaitcam::cam::LimitKind;
use gaitcam::synth::Design;
use gaitcam_base::text::{millimetres, number};

/// Largest radius of curvature shown, in prime radii: what is beyond is straight to the eye.
const CAP: f64 = 2.2;

/// Radius of curvature and pressure angle (a flat face: the contact's wandering) over the cam angle.
pub(crate) fn geometry_in(synthesis: &Design, layout: Layout, words: &Words) -> Picture {
    layout.picture(words.language(), |f| {
        let cam = &synthesis.cam;
        let measures = cam.follower.measures();
        let across = |t: f64| measures.angle().factor * t;
        let points: Vec<_> = motion(&cam.law)
            .iter()
            .map(|(t, _)| cam.point(*t))
            .collect();
        f.title(&synthesis.name, &words.text("figure-curvature"))?;
        let frames = strips(layout.frame(), &[1.0, 1.0], 1.2 * f.e);

        let rho: Vec<(f64, f64)> = points
            .iter()
            .map(|p| (across(p.theta), 1000.0 * p.rho))
            .collect();
        let cap = cap(synthesis, &rho);
        let sharpest = cam.curvature().convex;
        let shown = rho.iter().map(|p| p.1).filter(|r| r.abs() <= cap);
        let y = padded(shown.chain([0.0, 1000.0 * sharpest.value]), 0.18);
        let panel = f.over_the_law(synthesis, frames[0], y)?;
        // The radius passes through infinity where the flank turns from convex to concave.
        for part in rho.chunk_by(|a, b| a.1.signum() == b.1.signum() || a.1.abs() < cap) {
            panel.curve(part, BLUE, 2.2)?;
        }
        // A limit of 0 is the undercut's own bound: the axis.
        let limits = synthesis.checks.iter();
        for check in limits.filter(|c| c.name == LimitKind::Curvature && c.limit > 0.0) {
            let value = millimetres(check.limit, 3);
            let name = words.fill("figure-limit", &[("value", &value)]);
            let level = 1000.0 * check.limit;
            panel.level(level, Some((&name, VPos::Bottom)), RED, &rho)?;
        }
        if sharpest.value.is_finite() {
            let at = (across(sharpest.at), 1000.0 * sharpest.value);
            panel.mark(at, true, BLUE, true)?;
        }
        panel.quantity(&words.text("figure-rho"))?;

        if let Some((low, high)) = cam.contact_travel() {
            let ends = [low.value, high.value].map(|v| 1000.0 * v);
            let y = padded(ends.into_iter(), 0.26);
            let panel = f.over_the_law(synthesis, frames[1], y)?;
            let contact: Vec<(f64, f64)> = motion(&cam.law)
                .iter()
                .map(|(t, m)| (across(*t), 1000.0 * cam.contact_along(*m)))
                .collect();
            panel.curve(&contact, GREEN, 2.2)?;
            panel.mark((across(high.at), ends[1]), true, GREEN, true)?;
            panel.mark((across(low.at), ends[0]), false, GREEN, true)?;
            panel.quantity(&words.text("figure-contact-travel"))?;
            return panel.across(&words::across(words, measures));
        }
        let (low, high) = synthesis.pressure_angle_extremes();
        let limits = synthesis.checks.iter().filter_map(pressure_limit);
        let ends = [low.value, high.value].map(f64::to_degrees);
        let y = padded(ends.into_iter().chain(limits.clone()).chain([0.0]), 0.2);
        let panel = f.over_the_law(synthesis, frames[1], y)?;
        let phi: Vec<(f64, f64)> = points
            .iter()
            .map(|p| {
                let angle = match &synthesis.groove {
                    Some(groove) => groove.pressure_angle(p.theta, groove.depth().0),
                    None => p.pressure_angle,
                };
                (across(p.theta), angle.to_degrees())
            })
            .collect();
        panel.curve(&phi, GREEN, 2.2)?;
        for limit in limits {
            let side = if limit < 0.0 { VPos::Top } else { VPos::Bottom };
            let value = format!("{}°", number(limit, 3));
            let name = words.fill("figure-limit", &[("value", &value)]);
            panel.level(limit, Some((&name, side)), RED, &phi)?;
        }
        panel.mark((across(high.at), ends[1]), true, GREEN, true)?;
        panel.mark((across(low.at), ends[0]), false, GREEN, true)?;
        panel.quantity(&words.text("figure-pressure-angle"))?;
        panel.across(&words::across(words, measures))
    })
}

/// Largest radius of curvature drawn, mm. Beside a disc's own size everything larger is straight; what is
/// unrolled has no such size, and shows three quarters of its radii.
fn cap(synthesis: &Design, rho: &[(f64, f64)]) -> f64 {
    let cam = &synthesis.cam;
    let size = 1000.0 * CAP * cam.follower.prime_radius().max(cam.law.stroke());
    if !cam.follower.is_unrolled() {
        return size;
    }
    let mut all: Vec<f64> = rho.iter().map(|p| p.1.abs()).collect();
    all.retain(|r| r.is_finite());
    all.sort_by(f64::total_cmp);
    all.get(all.len() * 3 / 4).map_or(size, |r| r.max(size))
}

/// The signed level of a pressure-angle limit, degrees.
fn pressure_limit(check: &gaitcam::cam::Check) -> Option<f64> {
    let limit = check.limit.abs().to_degrees();
    match check.name.limit()? {
        LimitKind::PressureAngle | LimitKind::PressureAngleRise => Some(limit),
        LimitKind::PressureAngleFall => Some(-limit),
        _ => None,
    }
}

//! The pictures: lift and its derivatives, force against target, curvature and pressure angle, the cam.

use plotters::prelude::*;
use plotters_backend::text_anchor::{HPos, VPos};

use super::geometry::{angles, target_at};
use super::panel::{Frame, Panel, padded};
use super::picture::palette::{BLUE, GREEN, INK, ORANGE, PURPLE, QUIET, RED};
use super::raster::text_width;
use super::samples::{lift_unit, motion, number};
use super::sheet::{Canvas, Drawn, Lettering, line, stroke, write};
use crate::law::Svaj;
use crate::synth::Synthesis;

pub use super::cam_picture::cam;
pub use super::picture::Picture;

/// Size of the pictures that stand alone, pixels.
pub(super) const SIZE: (u32, u32) = (1200, 800);
/// Size of their lettering.
const LETTERS: f64 = 17.0;
/// Largest radius of curvature shown, in prime radii: what is beyond is straight to the eye.
const CAP: f64 = 2.2;
/// Points of the target and of its band.
const TARGET_POINTS: usize = 720;

/// How a picture is laid out: alone, or as a figure of the report under a caption.
#[derive(Debug, Clone, Copy)]
pub(super) struct Layout {
    /// Width and height, points.
    pub size: (u32, u32),
    /// Lettering, points.
    pub letters: f64,
    /// Whether the picture carries its own title.
    pub title: bool,
}

impl Layout {
    /// A file of its own.
    pub const ALONE: Layout = Layout {
        size: SIZE,
        letters: LETTERS,
        title: true,
    };

    /// A figure of the report.
    pub const fn figure(height: u32) -> Self {
        Layout {
            size: (FIGURE_WIDTH, height),
            letters: 13.0,
            title: false,
        }
    }

    /// The outer frame of the diagrams.
    pub fn frame(&self) -> Frame {
        let e = self.letters;
        Frame {
            left: 6.8 * e,
            right: f64::from(self.size.0) - 1.8 * e,
            top: if self.title { 4.6 * e } else { 0.8 * e },
            bottom: f64::from(self.size.1) - 4.0 * e,
        }
    }
}

/// Width of the report's figures, points.
pub(super) const FIGURE_WIDTH: u32 = 820;

/// Lift, velocity, acceleration and jerk over the cam angle, extremes marked.
pub fn svaj(synthesis: &Synthesis) -> Picture {
    svaj_in(synthesis, Layout::ALONE)
}

pub(super) fn svaj_in(synthesis: &Synthesis, layout: Layout) -> Picture {
    Picture::drawn(layout.size.0, layout.size.1, |canvas| {
        let law = &synthesis.cam.law;
        let (factor, unit) = lift_unit(synthesis);
        let motion = motion(law);
        let names = ["s", "v", "a", "j"];
        let per = ["", "/rad", "/rad²", "/rad³"];
        let pick: [fn(&Svaj) -> f64; 4] = [|m| m.s, |m| m.v, |m| m.a, |m| m.j];
        let colours = [BLUE, GREEN, RED, PURPLE];
        title(canvas, layout, &synthesis.name, "law of motion")?;
        let frames = strips(layout.frame(), &[1.0; 4], 0.9 * layout.letters);
        for k in 0..4 {
            let curve: Vec<(f64, f64)> = motion
                .iter()
                .map(|(t, m)| (t.to_degrees(), factor * pick[k](m)))
                .collect();
            let (low, high) = law.extremes(k);
            let ends = [low.value, high.value].map(|v| factor * v);
            let y = padded(ends.into_iter(), 0.26);
            let panel = Panel::new(canvas, frames[k], turn(synthesis), y, layout.letters)?;
            panel.curve(&curve, colours[k], 2.4)?;
            if ends[1] > ends[0] {
                panel.mark(high.at.to_degrees(), ends[1], true, colours[k])?;
                panel.mark(low.at.to_degrees(), ends[0], false, colours[k])?;
            }
            panel.quantity(
                &format!("{}, {unit}{}", names[k], per[k]),
                5.7 * layout.letters,
            )?;
            if k == 3 {
                panel.angles()?;
            }
        }
        Ok(())
    })
}

/// The cam's force on the wanted one with the difference below; the step-to-step spread as a band.
pub fn force(synthesis: &Synthesis) -> Picture {
    force_in(synthesis, Layout::ALONE)
}

pub(super) fn force_in(synthesis: &Synthesis, layout: Layout) -> Picture {
    Picture::drawn(layout.size.0, layout.size.1, |canvas| {
        let law = synthesis.pressing();
        let e = layout.letters;
        let achieved: Vec<(f64, f64)> = motion(law)
            .iter()
            .map(|(t, m)| (t.to_degrees(), synthesis.drive.force(*m)))
            .collect();
        title(canvas, layout, &synthesis.name, "vertical force")?;
        let frame = force_frame(layout);
        let legend = [frame.left, frame.top - 1.1 * e];
        let (low, high) = synthesis.drive.force_curve(law).extremes();
        let ends = [low, high].map(|x| (x.at.to_degrees(), x.value));
        // A force that never pulls is drawn from zero.
        let pushes = low.value >= -1e-9 * high.value.abs();
        let marks = |panel: &Panel| {
            panel.mark(ends[1].0, ends[1].1, true, BLUE)?;
            if high.value - low.value > 1e-9 * high.value.abs() {
                panel.mark(ends[0].0, ends[0].1, false, BLUE)?;
            }
            Ok(())
        };
        let Some(target) = &synthesis.target else {
            let y = padded(achieved.iter().map(|p| p.1).chain([0.0]), 0.12);
            let y = if pushes { [0.0, y[1]] } else { y };
            let panel = Panel::new(canvas, frame, turn(synthesis), y, e)?;
            panel.curve(&achieved, BLUE, 2.6)?;
            marks(&panel)?;
            panel.quantity("force, N", 5.7 * e)?;
            panel.angles()?;
            return key(canvas, legend, e, &[(BLUE, 2.6, "force of the cam")]);
        };
        let thetas: Vec<f64> = ends_of(synthesis)
            .into_iter()
            .chain(angles(law, TARGET_POINTS))
            .collect();
        let mut wanted: Vec<(f64, f64)> = thetas
            .iter()
            .map(|&t| (t.to_degrees(), target_at(target, law, t)))
            .collect();
        wanted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let band = spread(synthesis, &wanted);
        let frames = strips(frame, &[2.6, 1.0], 1.0 * e);

        let values = achieved.iter().chain(&wanted).map(|p| p.1);
        let edges = band
            .iter()
            .flat_map(|(u, l)| u.iter().chain(l))
            .map(|p| p.1);
        let y = padded(values.chain(edges).chain([0.0]), 0.1);
        let y = if pushes { [0.0, y[1]] } else { y };
        let panel = Panel::new(canvas, frames[0], turn(synthesis), y, e)?;
        if let Some((upper, lower)) = &band {
            panel.band(upper, lower, ORANGE.mix(0.22))?;
        }
        panel.curve(&wanted, ORANGE.mix(0.55), 8.0)?;
        panel.curve(&achieved, BLUE, 2.4)?;
        marks(&panel)?;
        panel.quantity("force, N", 5.7 * e)?;

        let error: Vec<(f64, f64)> = motion(law)
            .iter()
            .map(|(t, m)| {
                let wanted = target_at(target, law, *t);
                (t.to_degrees(), synthesis.drive.force(*m) - wanted)
            })
            .collect();
        let rms = synthesis.force.rms_error_n;
        let y = padded(error.iter().map(|p| p.1).chain([rms, -rms]), 0.3);
        let panel = Panel::new(canvas, frames[1], turn(synthesis), y, e)?;
        let zero: Vec<(f64, f64)> = error.iter().map(|p| (p.0, 0.0)).collect();
        panel.band(&error, &zero, RED.mix(0.14))?;
        panel.curve(&error, RED, 1.8)?;
        panel.level(rms, None, QUIET)?;
        panel.level(-rms, None, QUIET)?;
        panel.quantity("error, N", 5.7 * e)?;
        panel.angles()?;

        let difference = if layout.title {
            let percent = number(synthesis.force.rms_error_percent_of_mean, 2);
            format!("difference, RMS {} N ({percent} % of mean)", number(rms, 3))
        } else {
            "difference".to_string()
        };
        let mut entries = vec![
            (ORANGE.mix(0.55), 8.0, "wanted"),
            (BLUE, 2.4, "given by the cam"),
            (RED, 1.8, difference.as_str()),
        ];
        if band.is_some() {
            entries.insert(1, (ORANGE.mix(0.22), 14.0, "± SD, step to step"));
        }
        key(canvas, legend, e, &entries)
    })
}

/// The diagrams' frame below the line that names the curves.
pub(super) fn force_frame(layout: Layout) -> Frame {
    let frame = layout.frame();
    Frame {
        top: frame.top + 1.9 * layout.letters,
        ..frame
    }
}

/// Radius of curvature and pressure angle (a flat face: the contact's wandering) over the cam angle.
pub(super) fn geometry_in(synthesis: &Synthesis, layout: Layout) -> Picture {
    Picture::drawn(layout.size.0, layout.size.1, |canvas| {
        let cam = &synthesis.cam;
        let e = layout.letters;
        let points: Vec<_> = motion(&cam.law)
            .iter()
            .map(|(t, _)| cam.point(*t))
            .collect();
        title(canvas, layout, &synthesis.name, "curvature and contact")?;
        let frames = strips(layout.frame(), &[1.0, 1.0], 1.2 * e);

        let cap = 1000.0 * CAP * cam.follower.prime_radius().max(cam.law.stroke());
        let rho: Vec<(f64, f64)> = points
            .iter()
            .map(|p| (p.theta.to_degrees(), 1000.0 * p.rho))
            .collect();
        let sharpest = cam.curvature().convex;
        let shown = rho.iter().map(|p| p.1).filter(|r| r.abs() <= cap);
        let y = padded(shown.chain([0.0, 1000.0 * sharpest.value]), 0.18);
        let panel = Panel::new(canvas, frames[0], turn(synthesis), y, e)?;
        // The radius passes through infinity where the flank turns from convex to concave.
        for part in rho.chunk_by(|a, b| a.1.signum() == b.1.signum() || a.1.abs() < cap) {
            panel.curve(part, BLUE, 2.2)?;
        }
        for check in synthesis.checks.iter().filter(|c| c.name == "curvature") {
            let name = format!("limit {} mm", number(1000.0 * check.limit, 3));
            panel.level(1000.0 * check.limit, Some((&name, VPos::Bottom)), RED)?;
        }
        if sharpest.value.is_finite() {
            let at = sharpest.at.to_degrees();
            panel.mark_on_ground(at, 1000.0 * sharpest.value, true, BLUE)?;
        }
        panel.quantity("radius ρ, mm", 5.7 * e)?;

        if cam.face_width().is_some() {
            let (low, high) = cam.law.extremes(1);
            let y = padded(
                [low.value, high.value].map(|v| 1000.0 * v).into_iter(),
                0.26,
            );
            let panel = Panel::new(canvas, frames[1], turn(synthesis), y, e)?;
            let contact: Vec<(f64, f64)> = motion(&cam.law)
                .iter()
                .map(|(t, m)| (t.to_degrees(), 1000.0 * m.v))
                .collect();
            panel.curve(&contact, GREEN, 2.2)?;
            panel.mark_on_ground(high.at.to_degrees(), 1000.0 * high.value, true, GREEN)?;
            panel.mark_on_ground(low.at.to_degrees(), 1000.0 * low.value, false, GREEN)?;
            panel.quantity("contact, mm", 5.7 * e)?;
            return panel.angles();
        }
        let (low, high) = cam.pressure_angle_extremes();
        let limits = synthesis.checks.iter().filter_map(pressure_limit);
        let ends = [low.value, high.value].map(f64::to_degrees);
        let y = padded(ends.into_iter().chain(limits.clone()).chain([0.0]), 0.2);
        let panel = Panel::new(canvas, frames[1], turn(synthesis), y, e)?;
        let phi: Vec<(f64, f64)> = points
            .iter()
            .map(|p| (p.theta.to_degrees(), p.pressure_angle.to_degrees()))
            .collect();
        panel.curve(&phi, GREEN, 2.2)?;
        for limit in limits {
            let side = if limit < 0.0 { VPos::Top } else { VPos::Bottom };
            let name = format!("limit {}°", number(limit, 3));
            panel.level(limit, Some((&name, side)), RED)?;
        }
        panel.mark_on_ground(high.at.to_degrees(), ends[1], true, GREEN)?;
        panel.mark_on_ground(low.at.to_degrees(), ends[0], false, GREEN)?;
        panel.quantity("pressure angle, °", 5.7 * e)?;
        panel.angles()
    })
}

/// The signed level of a pressure-angle limit, degrees.
fn pressure_limit(check: &crate::cam::Check) -> Option<f64> {
    if !check.name.starts_with("pressure_angle") {
        return None;
    }
    let falling = check.name.ends_with("fall");
    let limit = check.limit.abs().to_degrees();
    Some(if falling { -limit } else { limit })
}

/// Upper and lower edge of the step-to-step spread about the wanted force.
#[allow(clippy::type_complexity)] // two curves
fn spread(
    synthesis: &Synthesis,
    wanted: &[(f64, f64)],
) -> Option<(Vec<(f64, f64)>, Vec<(f64, f64)>)> {
    let target = synthesis.target.as_ref()?;
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
    let edge = |sign: f64| wanted.iter().map(|&(d, f)| (d, f + sign * at(d))).collect();
    Some((edge(1.0), edge(-1.0)))
}

/// First and last angle of the law, degrees.
fn turn(synthesis: &Synthesis) -> [f64; 2] {
    ends_of(synthesis).map(f64::to_degrees)
}

fn ends_of(synthesis: &Synthesis) -> [f64; 2] {
    let (start, length) = synthesis.cam.law.extent();
    [start, start + length]
}

/// Splits a frame into strips of given shares, one above the other.
pub(super) fn strips(frame: Frame, shares: &[f64], gap: f64) -> Vec<Frame> {
    let total: f64 = shares.iter().sum();
    let free = frame.bottom - frame.top - gap * (shares.len() as f64 - 1.0);
    let mut top = frame.top;
    shares
        .iter()
        .map(|share| {
            let bottom = top + free * share / total;
            let strip = Frame {
                top,
                bottom,
                ..frame
            };
            top = bottom + gap;
            strip
        })
        .collect()
}

/// The design's name and what is shown.
pub(super) fn title(canvas: &Canvas, layout: Layout, name: &str, what: &str) -> Drawn {
    if !layout.title {
        return Ok(());
    }
    let e = layout.letters;
    let at = [layout.frame().left, 2.2 * e];
    let big = Lettering::new(1.35 * e, INK).bold();
    write(canvas, name, at, big)?;
    // Bold runs about a tenth wider than regular.
    let after = at[0] + 1.35 * e * 1.12 * text_width(name) + 0.9 * e;
    write(
        canvas,
        what,
        [after, at[1]],
        Lettering::new(1.35 * e, QUIET),
    )
}

/// Swatches with their names, from the left.
pub(super) fn key(
    canvas: &Canvas,
    [mut x, y]: [f64; 2],
    size: f64,
    entries: &[(RGBAColor, f64, &str)],
) -> Drawn {
    for &(colour, width, name) in entries {
        line(
            canvas,
            &[[x, y], [x + 2.0 * size, y]],
            stroke(colour, width),
        )?;
        x += 2.6 * size;
        let lettering = Lettering::new(size, INK).anchored(HPos::Left, VPos::Center);
        write(canvas, name, [x, y], lettering)?;
        x += size * text_width(name) + 1.7 * size;
    }
    Ok(())
}

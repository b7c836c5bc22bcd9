//! Contour of a cam with its colours, and the positions where limits are active.

use serde::{Deserialize, Serialize};

use super::{MM, Sample, Shown, short};
use gaitcam::cam::{Cam, Check};
use gaitcam::criterion::{Criterion, LimitKind};
use gaitcam::synth::Design;

/// Contour in the frame of the cam, mm.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Contour {
    x: Vec<Shown>,
    y: Vec<Shown>,
    /// Centre of curvature, and the radius with its sign.
    centre_x: Vec<Shown>,
    centre_y: Vec<Shown>,
    radius: Vec<Shown>,
    /// Meaning and values of the colour; empty without colours.
    colour: Colour,
    values: Vec<Shown>,
}

/// Quantity that colours the contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Colour {
    /// The contour has one colour.
    #[default]
    None,
    /// Pressure angle along the contour, °.
    PressureAngle,
    /// Curvature of the contour, 1/m.
    Curvature,
    /// Curvature as a percentage of the allowed curvature.
    CurvatureUse,
    /// Contact force along the contour, N.
    Force,
    /// Hertz pressure along the contour, MPa.
    Hertz,
}

/// Point of the contour where a limit is active.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Place {
    /// Name of the limit in data.
    pub limit: String,
    /// Position in the unit of the angle.
    pub theta: f64,
    /// Position on the contour, mm.
    pub x: f64,
    /// Position on the contour, mm.
    pub y: f64,
    /// Whether the limit is violated there.
    pub broken: bool,
}

/// Contour of a design at the sampled angles.
pub(super) fn contour(design: &Design, samples: &[Sample], colour: Colour) -> Contour {
    let cam = &design.cam;
    let all = |value: &dyn Fn(&Sample) -> f64| -> Vec<Shown> {
        samples.iter().map(|s| short(value(s))).collect()
    };
    let normal = |s: &Sample| normal(cam, s);
    let most = 20.0 * cam.follower.prime_radius();
    let bent = |s: &Sample| {
        if s.point.rho.abs() > most {
            f64::NAN
        } else {
            s.point.rho
        }
    };
    Contour {
        x: all(&|s| MM * s.point.x),
        y: all(&|s| MM * s.point.y),
        centre_x: all(&|s| MM * (s.point.x - bent(s) * libm::cos(normal(s)))),
        centre_y: all(&|s| MM * (s.point.y - bent(s) * libm::sin(normal(s)))),
        radius: all(&|s| MM * bent(s)),
        colour,
        values: match colour {
            Colour::None => Vec::new(),
            Colour::PressureAngle => all(&|s| s.point.pressure_angle.to_degrees().abs()),
            Colour::Curvature => all(&|s| 1.0 / s.point.rho),
            Colour::CurvatureUse => {
                let [convex, concave] = smallest_radii(design);
                let least = |s: &Sample| if s.point.rho > 0.0 { convex } else { concave };
                all(&|s| 100.0 * least(s) / s.point.rho.abs())
            }
            Colour::Force => all(&|s| s.force),
            Colour::Hertz => all(&|s| 1e-6 * design.contact_pressure_at(s.theta)),
        },
    }
}

/// Minimum radii of curvature for the convex and the concave parts of the contour, m; NaN without a limit.
fn smallest_radii(design: &Design) -> [f64; 2] {
    [Criterion::from(LimitKind::Curvature), Criterion::Concave].map(|name| {
        let limits = |c: &&Check| c.name == name && c.limit > 0.0;
        design
            .checks
            .iter()
            .find(limits)
            .map_or(f64::NAN, |c| c.limit)
    })
}

/// Direction of the contact normal in the cam frame, rad.
fn normal(cam: &Cam, s: &Sample) -> f64 {
    let [x, y] = cam.motion(s.theta);
    let unrolled = cam.follower.is_unrolled();
    let turned = if unrolled { 0.0 } else { s.theta };
    libm::atan2(y, x) + s.point.pressure_angle - turned
}

/// Points where limits are active or violated, without repetitions.
pub(super) fn places(design: &Design) -> Vec<Place> {
    let cam = &design.cam;
    let factor = cam.follower.measures().angle().factor;
    let acting = design.binding.iter().map(|b| (b.limit.name(), b.at, false));
    let broken = design.checks.iter().filter(|c| !c.pass && c.at.is_finite());
    let broken = broken.map(|c| (c.name.name(), c.at, true));
    let mut out: Vec<Place> = Vec::new();
    for (limit, at, broken) in broken.chain(acting) {
        let theta = factor * at;
        let near = |p: &Place| p.limit == limit && (p.theta - theta).abs() < 0.5;
        if out.iter().any(near) || out.len() >= 24 {
            continue;
        }
        let point = cam.point(at);
        let (limit, x, y) = (limit.to_string(), MM * point.x, MM * point.y);
        out.push(Place {
            limit,
            theta,
            x,
            y,
            broken,
        });
    }
    out
}

//! Contour of a cam with its colours, and the points at which limits are active or violated.

use serde::{Deserialize, Serialize};

use super::{MM, Sample, Shown, short};
use gaitcam::cam::{Cam, Check};
use gaitcam::criterion::{Criterion, LimitKind};
use gaitcam::synth::Design;

/// Contour of a cam and its centres of curvature in the cam frame. Lengths are in mm.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Contour {
    x: Vec<Shown>,
    y: Vec<Shown>,
    /// x coordinate of the centre of curvature, mm. `centre_y` is its y coordinate, mm. `radius` is the radius of curvature, mm, positive
    /// where the contour is convex.
    centre_x: Vec<Shown>,
    centre_y: Vec<Shown>,
    radius: Vec<Shown>,
    /// Quantity that colours the contour. `values` contains this quantity at each point and is empty without colours.
    colour: Colour,
    values: Vec<Shown>,
}

/// Quantity by which the contour is coloured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Colour {
    /// No quantity: the whole contour has the same colour.
    #[default]
    None,
    /// Absolute value of the pressure angle, °.
    PressureAngle,
    /// Curvature, 1/m, positive where convex.
    Curvature,
    /// Utilisation of the curvature limit, %: permitted minimum radius of curvature divided by the absolute local radius of curvature.
    CurvatureUse,
    /// Contact force between cam and follower, N.
    Force,
    /// Maximum Hertz pressure at the contact, MPa.
    Hertz,
}

/// Point of the contour at which a limit is active or violated.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Place {
    /// Name of the limit in JSON data.
    pub limit: String,
    /// Cam angle or travel of the point, in the unit of the diagrams.
    pub theta: f64,
    /// x coordinate of the point, mm.
    pub x: f64,
    /// y coordinate of the point, mm.
    pub y: f64,
    /// Whether the limit is violated at the point.
    pub broken: bool,
}

/// Contour of a design at the sampled cam angles, with the values of the quantity `colour`.
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

/// Permitted minimum radii of curvature of convex and concave parts, m. A radius without a limit is NaN.
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

/// Direction of the outward contact normal in the cam frame, rad.
fn normal(cam: &Cam, s: &Sample) -> f64 {
    let [x, y] = cam.motion(s.theta);
    let unrolled = cam.follower.is_unrolled();
    let turned = if unrolled { 0.0 } else { s.theta };
    libm::atan2(y, x) + s.point.pressure_angle - turned
}

/// Points at which limits are active or violated, at most 24. Points of the same limit that almost coincide are listed once.
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

//! Limit on the Hertz pressure between cam and follower. For a flat face, the limit is linear in law and size. For a roller, the limit is not
//! convex.

use std::f64::consts::PI;

use super::finished::Finished;
use super::press::Press;
use super::slack::{ProfileSize, Slack};
use crate::cam::{FollowerKind, LimitKind};
use crate::drive::Drive;
use crate::dynamics::hertz::flat_face_limit;
use crate::law::{Law, Svaj};
use crate::poly::{Extreme, PiecewisePoly};
use crate::problem::Problem;
use crate::synth::qp::{Limit, Meaning, RADIUS, structural};

/// Fraction of the squared pressure limit. If the curvature of the roller alone causes a larger fraction, a larger cam hardly reduces the
/// pressure, so the cam is not enlarged.
const WORTH_GROWING: f64 = 0.95;

/// Pressure limit for a flat face, F ≤ π L p²/E*·(Rb + s + a), which is linear in law and base radius Rb together. F is the contact force,
/// L the contact length, E* the contact modulus, s the lift and a its second derivative. If `is_sized` is true, the base radius is a
/// variable of the program.
pub fn row(problem: &Problem, is_sized: bool) -> Option<Limit> {
    if !is_sized {
        return pressed(problem, problem.base_radius()?);
    }
    let mut limit = pressed(problem, 0.0)?;
    limit.extra[RADIUS] = limit.weights[2] - problem.drive.weights()[2];
    Some(limit)
}

/// Pressure limit for a flat face on a base circle of radius `base_radius`, m. If the radius is a variable, `base_radius` is 0 and the caller
/// adds the variable.
fn pressed(problem: &Problem, base_radius: f64) -> Option<Limit> {
    let (cam, pressure) = (&problem.cam, problem.limits[LimitKind::HertzPressure]?);
    if cam.follower != FollowerKind::FlatTranslating {
        return None;
    }
    let modulus = cam.contact_modulus();
    let ([s, v, a, j], bound) = flat_face_limit(
        &problem.drive,
        base_radius,
        cam.thickness,
        modulus,
        pressure,
    );
    let scale = bound.abs().max(problem.drive.rest_force.abs());
    let weights = [s, v, a, j, 0.0];
    let limit = structural(LimitKind::HertzPressure, weights, bound, scale);
    Some(Meaning::Sized.of(limit))
}

/// Minimum base radius of a flat-faced cam with the pressure limit, m: the maximum of F E*/(π L p²) − s − a. The result is 0 without a limit
/// on the pressure.
pub fn smallest_base_radius(problem: &Problem, law: &Law, pressing: &Law) -> f64 {
    let Some(limit) = pressed(problem, 0.0) else {
        return 0.0;
    };
    let per_radius = problem.drive.weights()[2] - limit.weights[2];
    let force = problem.force_curve(pressing);
    let bend = law.combination([1.0, 0.0, 1.0, 0.0], 0.0);
    let bend = bend.cut_at(force.breaks());
    let force = force.cut_at(bend.breaks());
    PiecewisePoly::combine(&[(1.0 / per_radius, &force), (-1.0, &bend)], 0.0)
        .extremes()
        .1
        .value
}

/// Limit on the Hertz pressure, Pa, if a sufficiently large cam can satisfy it; otherwise `None`. Even on a very large cam, the curvature of
/// the roller causes a pressure.
pub fn bearable_on_some_size(problem: &Problem, pressing: &Law) -> Option<f64> {
    let (most, roller) = (
        problem.limits[LimitKind::HertzPressure]?,
        problem.cam.roller_radius,
    );
    let force = problem.force_extremes(pressing).1.value;
    let least = force * problem.cam.contact_modulus() / (PI * problem.cam.thickness * roller);
    (roller > 0.0 && least < WORTH_GROWING * most * most).then_some(most)
}

/// Limit on the Hertz pressure between a roller and its cam.
#[derive(Debug, Clone, Copy)]
pub struct Pressure {
    /// Factor π L/E*, m³/N. The squared pressure p² is the product of normal force and sum of curvatures, divided by this factor.
    pub spread: f64,
    /// Radius R_f of the roller, m.
    pub roller: f64,
    /// Maximum permitted pressure p, Pa.
    pub most: f64,
}

impl Pressure {
    /// Clearance h = q X (w^{3/2} − R_f K) − F w², with q = p² π L R_f/E*, X = D + s, Y = v − e, w = X² + Y² and K = w + vY − aX. F is the
    /// contact force, L the contact length and E* the contact modulus.
    pub fn slack(&self, drive: &Drive, at: Svaj, force: f64, size: ProfileSize) -> Slack {
        let [k, c, m, _] = drive.weights();
        let (x, y) = (size.rise + at.s, at.v - size.offset);
        let w = x * x + y * y;
        let root = w.sqrt();
        let bend = w + at.v * y - at.a * x;
        let gap = w * root - self.roller * bend;
        let q = self.most * self.most * self.spread * self.roller;
        // Partial derivatives of h with respect to X, Y, v and a, for a constant contact force.
        let by_x =
            q * (gap + x * (3.0 * root * x - self.roller * (2.0 * x - at.a))) - force * 4.0 * w * x;
        let by_y = q * x * (3.0 * root * y - self.roller * (2.0 * y + at.v)) - force * 4.0 * w * y;
        let by_v = -q * x * self.roller * y;
        let by_a = q * x * self.roller * x;
        // Scale q X w^{3/2} of h. The ratio of h to this scale depends little on the size of the cam.
        let unit = q * size.rise.max(size.rho) * w * root;
        Slack {
            h: q * x * gap - force * w * w,
            w: unit,
            largest: unit,
            by_lift: by_x - k * w * w,
            by_rise: by_x,
            by_velocity: by_y + by_v - c * w * w,
            by_acceleration: by_a - m * w * w,
            by_offset: -by_y,
            ..Slack::none(LimitKind::HertzPressure)
        }
    }
}

/// Maximum Hertz pressure on the finished cam, Pa; infinite on an undercut profile, and 0 for a drive without a force.
pub fn worst(design: &Finished) -> Extreme {
    if design.problem.drive.is_idle() {
        return design.cam.curvature().convex.map(|_| 0.0);
    }
    let press = Press::of(design.problem, design.pressing);
    let worst = press.worst(design.cam, design.second, design.groove);
    worst.unwrap_or_else(|| design.cam.curvature().convex.map(|_| f64::INFINITY))
}

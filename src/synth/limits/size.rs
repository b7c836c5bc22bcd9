//! Limits on face width, prime radius and bore.

use super::finished::{GEOMETRY, SLACK};
use super::nonconvex::ENLARGED;
use crate::cam::{Cam, Check, Criterion, FollowerKind, LimitKind};
use crate::poly::Extreme;
use crate::problem::Problem;
use crate::scene::Minimise;
use crate::synth::qp::{Limit, Meaning, OFFSET, Program, RADIUS, RISE, Variable, structural};

/// Adds the cost of the size of the cam to the program, and the cone Rp ≥ ‖(D, e)‖ for a free offset. Returns the limits on the size.
pub fn priced(problem: &Problem, program: &mut Program) -> Vec<Limit> {
    let cost = match problem.objective() {
        Minimise::Size => 1.0,
        _ => 0.0,
    };
    let limit = problem.limits[LimitKind::PrimeRadius];
    // A cam cannot be smaller than its bore or have a negative base radius. The checks report a limit below this minimum.
    let least = problem.hub_radius() + problem.cam.roller_radius;
    let below = limit.map_or(f64::INFINITY, |limit| limit * (1.0 - 4.0 * ENLARGED));
    let least = least.min(below);
    let mut limits = Vec::new();
    if let Some([least, most]) = problem.reach_of_arm() {
        // A limit above the reach of the arm is inactive.
        let limit = limit.filter(|limit| *limit <= most);
        let most = limit.map_or_else(
            || on_size(problem, RADIUS, 1.0, most),
            |limit| at_most(problem, limit, RADIUS),
        );
        limits.extend([most, at_least(problem, least, RADIUS)]);
        program.cost[RADIUS] = cost;
    } else if problem.cam.follower == FollowerKind::FlatTranslating {
        limits.extend(limit.map(|r| at_most(problem, r, RADIUS)));
        limits.push(at_least(problem, least, RADIUS));
        program.cost[RADIUS] = cost;
    } else if let Some(offset) = problem.offset() {
        // With a given offset, the prime radius increases with D. Minimising D therefore minimises the prime radius.
        let rise = |r: f64| (r * r - offset * offset).max(0.0).sqrt();
        limits.extend(limit.map(|r| at_most(problem, rise(r), RISE)));
        limits.push(at_least(problem, rise(least), RISE));
        program.cost[RISE] = cost;
    } else {
        limits.extend(limit.map(|r| at_most(problem, r, RADIUS)));
        limits.push(at_least(problem, least, RADIUS));
        // The cone alone would permit a negative D.
        limits.push(at_least(problem, 0.0, RISE));
        program.cost[RADIUS] = cost;
        program.cone(Criterion::BaseCircle, RADIUS, &[RISE, OFFSET]);
    }
    limits
}

/// Upper limit of the scene on a size variable, m. This limit does not depend on the angle, so it is a single row.
fn at_most(problem: &Problem, radius: f64, variable: Variable) -> Limit {
    Limit {
        name: LimitKind::PrimeRadius.into(),
        ..Meaning::times(1.0).of(on_size(problem, variable, 1.0, radius))
    }
}

/// Tightens the upper limits on the size by twice the relative enlargement at the end of a sequence of convex programs.
pub fn leave_room(program: &mut Program) {
    let is_of_size = |l: &&mut Limit| l.name == LimitKind::PrimeRadius;
    for limit in program.limits.iter_mut().filter(is_of_size) {
        limit.bound *= 1.0 - 2.0 * ENLARGED;
    }
}

/// Lower bound on a size variable: `variable` ≥ `size`. It is geometric and not a limit of the scene.
fn at_least(problem: &Problem, size: f64, variable: Variable) -> Limit {
    on_size(problem, variable, -1.0, -size)
}

/// Geometric bound on a size variable that is not a limit of the scene: `weight` · `variable` ≤ `bound`.
fn on_size(problem: &Problem, variable: Variable, weight: f64, bound: f64) -> Limit {
    let scale = problem.length() * problem.lever();
    let mut limit = structural(Criterion::BaseCircle, [0.0; 5], bound, scale);
    limit.extra[variable] = weight;
    limit.domain = (0.0, 0.0);
    limit
}

/// Checks of face width, prime radius and bore of the finished cam.
pub fn checks(problem: &Problem, cam: &Cam) -> Vec<Check> {
    let size = |value: f64| Extreme { at: 0.0, value };
    let follower = &cam.follower;
    let mut out = Vec::new();
    if let (Some(limit), Some(width)) = (problem.limits[LimitKind::FaceWidth], cam.face_width()) {
        let worst = cam.law.extremes(1).1.map(|_| width);
        out.push(Check::of(LimitKind::FaceWidth, worst, limit, SLACK));
    }
    if let Some(limit) = problem.limits[LimitKind::PrimeRadius] {
        let prime = size(follower.prime_radius());
        out.push(Check::of(LimitKind::PrimeRadius, prime, limit, GEOMETRY));
    }
    if let Some(hole) = problem.cam.hole() {
        let (base, reach) = (size(follower.base_radius()), hole.reach());
        out.push(Check::of(Criterion::BaseOutsideBore, base, reach, GEOMETRY));
    }
    out
}

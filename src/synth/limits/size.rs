//! Prime radius and bore.

use super::finished::{GEOMETRY, SLACK};
use super::nonconvex::ENLARGED;
use super::profile::Profile;
use crate::cam::{Cam, Check, Criterion, FollowerKind, LimitKind};
use crate::poly::Extreme;
use crate::problem::Problem;
use crate::scene::Minimise;
use crate::synth::qp::{Limit, Meaning, Program, RADIUS, RISE};

/// Cost of a size among the variables, the limit on it, and the cone Rp ≥ ‖(D, e)‖ of an open offset.
pub fn priced(problem: &Problem, program: &mut Program) {
    let cost = match problem.objective() {
        Minimise::Size => 1.0,
        Minimise::Weighed(weigh) => weigh.prime_radius.map_or(0.0, |one| 1.0 / one),
        _ => 0.0,
    };
    let limit = problem.limits[LimitKind::PrimeRadius];
    if let Some([least, most]) = problem.reach_of_arm() {
        // A limit larger than the arm can reach is inactive.
        let limit = limit.filter(|limit| *limit <= most);
        let most = limit.map_or_else(
            || of_arm(problem, 1.0, most),
            |limit| at_most(problem, limit, RADIUS),
        );
        program.limits.extend([most, of_arm(problem, -1.0, -least)]);
        program.cost[RADIUS] = cost;
    } else if problem.cam.follower == FollowerKind::FlatTranslating {
        program
            .limits
            .extend(limit.map(|r| at_most(problem, r, RADIUS)));
        program.cost[RADIUS] = cost;
    } else if let Some(offset) = problem.offset() {
        // With the offset given, the prime radius grows with D alone.
        let rise = |r: f64| (r * r - offset * offset).max(0.0).sqrt();
        program
            .limits
            .extend(limit.map(|r| at_most(problem, rise(r), RISE)));
        program.cost[RISE] = cost;
    } else {
        program
            .limits
            .extend(limit.map(|r| at_most(problem, r, RADIUS)));
        program.cost[RADIUS] = cost;
        program.cone = true;
    }
}

/// A size that no cost holds down is held by its limit: one row, at angle 0. What the sequence for a
/// roller's curvature enlarges in the end is kept free.
fn at_most(problem: &Problem, radius: f64, variable: usize) -> Limit {
    let kept = if Profile::of(problem).is_some() {
        1.0 - 2.0 * ENLARGED
    } else {
        1.0
    };
    let mut limit = Limit::new(
        LimitKind::PrimeRadius,
        [0.0; 5],
        radius * kept,
        problem.length * problem.lever(),
    );
    limit.extra[variable] = 1.0;
    limit.domain = (0.0, 0.0);
    limit.meaning = Meaning::times(1.0);
    limit
}

/// Implicit bound on the prime radius from the geometry of the arm: weight · radius ≤ bound.
fn of_arm(problem: &Problem, weight: f64, bound: f64) -> Limit {
    let scale = problem.length * problem.lever();
    let mut limit = Limit::new(Criterion::BaseCircle, [0.0; 5], bound, scale);
    limit.extra[RADIUS] = weight;
    limit.domain = (0.0, 0.0);
    limit
}

/// Face width, prime radius and bore of the finished cam.
pub fn checks(problem: &Problem, cam: &Cam) -> Vec<Check> {
    let size = |value: f64| Extreme { at: 0.0, value };
    let mut out = Vec::new();
    if let (Some(limit), Some(width)) = (problem.limits[LimitKind::FaceWidth], cam.face_width()) {
        let worst = Extreme {
            at: cam.law.extremes(1).1.at,
            value: width,
        };
        out.push(Check::at_most(LimitKind::FaceWidth, worst, limit, SLACK));
    }
    if let Some(limit) = problem.limits[LimitKind::PrimeRadius] {
        let worst = size(cam.follower.prime_radius());
        out.push(Check::at_most(
            LimitKind::PrimeRadius,
            worst,
            limit,
            GEOMETRY,
        ));
    }
    if let Some(hole) = problem.cam.hole() {
        let worst = size(cam.follower.base_radius());
        out.push(Check::at_least(
            Criterion::Bore,
            worst,
            hole.reach(),
            GEOMETRY,
        ));
    }
    out
}

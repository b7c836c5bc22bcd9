//! Limits on base circle, stroke, face width, velocity, acceleration and jerk, on monotone flanks, and on a minimised peak of a derivative.

use super::finished::SLACK;
use crate::cam::{Cam, Check, Criterion, FollowerKind, LimitKind};
use crate::poly::Extreme;
use crate::problem::{Problem, sum};
use crate::scene::Minimise;
use crate::synth::qp::{
    FACE_END, LOWEST, Limit, Meaning, PEAK, Program, Variable, only, structural,
};

/// Depth below the base circle, relative to the stroke, that counts as a rounding error.
const DIP: f64 = 1e-7;
/// Depth below the base circle, m or rad, that counts as zero. It is the tolerance of the program for a lift of a centimetre.
const NO_LIFT: f64 = 1e-11;

/// Limit s ≥ 0 on the lift s, which keeps the law above its base circle. `None` if nothing fixes the level of the lift and no limit depends
/// on this level.
pub fn base_circle(problem: &Problem) -> Option<Limit> {
    let stroke = problem.limits[LimitKind::Stroke];
    let scale = stroke.map_or(problem.length(), |h| h.min(problem.length()));
    let limit = structural(Criterion::BaseCircle, only(0, -1.0), 0.0, scale);
    // Limits on stroke and diameter are measured from the base circle.
    let is_limited = stroke.is_some() || problem.limits[LimitKind::Diameter].is_some();
    (problem.level_is_known() || is_limited).then_some(limit)
}

/// Limit s ≥ 0 on the lift s, which keeps the law above its base circle. It is returned for every problem.
pub fn above_base_circle(problem: &Problem) -> Limit {
    structural(Criterion::BaseCircle, only(0, -1.0), 0.0, problem.length())
}

/// Check that the law is not below its base circle (lift 0). `None` if this check passes.
pub fn base_circle_check(cam: &Cam) -> Option<Check> {
    let lowest = cam.law.extremes(0).0;
    let dips = lowest.value < -(DIP * cam.law.stroke()).max(NO_LIFT);
    dips.then(|| Check::of(Criterion::BaseCircle, lowest, 0.0, 0.0))
}

/// Limit on the stroke. If the level of the lift is fixed, the stroke is counted from the minimum lift. Otherwise the minimum lift is on the
/// base circle, and the stroke is counted from the base circle.
pub fn stroke(problem: &Problem) -> Vec<Limit> {
    let Some(h) = problem.limits[LimitKind::Stroke] else {
        return Vec::new();
    };
    let window = problem.level_is_known().then_some(LOWEST);
    range(problem, LimitKind::Stroke, 0, h, window)
}

/// Limit on the length of a flat face. The position of the contact on the face is v (theory §6).
pub fn face_width(problem: &Problem) -> Vec<Limit> {
    match (problem.limits[LimitKind::FaceWidth], problem.cam.follower) {
        (Some(width), FollowerKind::FlatTranslating) => {
            range(problem, LimitKind::FaceWidth, 1, width, Some(FACE_END))
        }
        _ => Vec::new(),
    }
}

/// Limits a derivative of the lift to a range of the given width. The range begins at 0, or at the value of the variable `window`.
fn range(
    problem: &Problem,
    name: LimitKind,
    order: usize,
    width: f64,
    window: Option<Variable>,
) -> Vec<Limit> {
    let side = Limit::on(name, only(order, 1.0));
    let scale = if width == 0.0 {
        problem.length()
    } else {
        width
    };
    let read = |top: Limit| Meaning::times(1.0).of(top.scaled(scale));
    match window.map(|from| side.within(width, from)) {
        Some([top, bottom]) => vec![read(top), bottom.exact()],
        None => vec![read(side.at_most(width))],
    }
}

/// Limits of the scene on time derivatives of the lift: limit, order of the derivative, bound.
fn limited(problem: &Problem) -> impl Iterator<Item = (LimitKind, usize, f64)> {
    LimitKind::by_time().filter_map(|(kind, order)| Some((kind, order, problem.limits[kind]?)))
}

/// Limits on velocity, acceleration and jerk: one limit for each sign of each derivative.
pub fn timed(problem: &Problem) -> Vec<Limit> {
    let mut out = Vec::new();
    for (name, order, limit) in limited(problem) {
        let per_time = problem.drive.speed.powi(order as i32);
        for sign in [1.0, -1.0] {
            let bound = limit / per_time;
            let scale = if bound == 0.0 {
                problem.length()
            } else {
                bound
            };
            let limit = structural(name, only(order, sign), bound, scale);
            out.push(Meaning::times(per_time).of(limit));
        }
    }
    out
}

/// Checks of stroke and time derivatives of the finished cam. A derivative is infinite where the next lower derivative is discontinuous.
pub fn checks(problem: &Problem, cam: &Cam) -> Vec<Check> {
    let mut out = Vec::new();
    let (bottom, top) = cam.law.extremes(0);
    if let Some(h) = problem.limits[LimitKind::Stroke] {
        let stroke = top.map(|highest| highest - bottom.value);
        out.push(Check::of(LimitKind::Stroke, stroke, h, SLACK));
    }
    for (name, order, limit) in limited(problem) {
        let per_time = problem.drive.speed.powi(order as i32);
        let extra = problem.on_shaft.as_ref();
        let timed = match extra.and_then(|shaft| shaft.extra.timed[order - 1].as_ref()) {
            None => Extreme::largest(cam.derivative_extremes(order)).map(|value| value * per_time),
            Some(extra) => {
                let [weights @ .., _] = only(order, per_time);
                let own = cam.law.combination(weights, 0.0);
                Extreme::largest(sum(&own, extra).extremes())
            }
        };
        out.push(Check::of(name, timed, limit, SLACK));
    }
    out
}

/// Limits that make the law monotone between adjacent points of different lift, if the scene requires it.
pub fn monotone(problem: &Problem) -> Vec<Limit> {
    if !problem.law.monotone {
        return Vec::new();
    }
    let lift_of = |force: f64| problem.lift_of_force(force);
    let mut points: Vec<(f64, f64)> = problem
        .law
        .points
        .iter()
        .filter_map(|p| Some((p.angle, p.lift.or_else(|| lift_of(p.force?))?)))
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let flank = |((from, before), (to, after)): ((f64, f64), (f64, f64))| {
        let sign = if after > before { -1.0 } else { 1.0 };
        Limit {
            domain: (from, to),
            ..structural(Criterion::Monotone, only(1, sign), 0.0, problem.length())
        }
    };
    points
        .windows(2)
        .filter(|pair| pair[0].1 != pair[1].1)
        .map(|pair| flank((pair[0], pair[1])))
        .collect()
}

/// Limits ±s⁽ᵏ⁾ ≤ peak if the objective is the maximum absolute value of a derivative. The cost of the peak variable is added to the program.
pub fn peak(problem: &Problem, program: &mut Program) -> Vec<Limit> {
    let Minimise::Peak(order) = problem.objective() else {
        return Vec::new();
    };
    program.cost[PEAK] = 1.0;
    let side = |sign: f64| {
        structural(Criterion::Peak, only(order, sign), 0.0, problem.length()).minimised()
    };
    vec![side(1.0), side(-1.0)]
}

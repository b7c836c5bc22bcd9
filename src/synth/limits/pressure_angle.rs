//! Pressure angle on rise and fall.

use std::f64::consts::FRAC_PI_2;

use super::finished::GEOMETRY;
use super::slack::Slack;
use crate::cam::{Check, FollowerKind, LimitKind};
use crate::law::Svaj;
use crate::poly::Extreme;
use crate::problem::Problem;
use crate::synth::qp::{Limit, Meaning, OFFSET, RISE, structural};

/// A pressure angle that is no limit, where its tangent must be a number.
pub const NEARLY_RIGHT: f64 = FRAC_PI_2 - 1e-3;

/// Limits on rise and fall, in this order.
pub const SIDES: [LimitKind; 2] = [LimitKind::PressureAngleRise, LimitKind::PressureAngleFall];
/// Sign of velocity less offset at which each of them is active.
const SIGNS: [f64; 2] = [1.0, -1.0];

/// On a given prime circle: ±(v − e) ≤ tan φ·(s + D) (theory §6).
pub fn rows(problem: &Problem) -> Vec<Limit> {
    let kind = problem.cam.follower;
    let slides = kind.is_translating() && kind != FollowerKind::FlatTranslating;
    let Some(prime) = problem.prime_radius().filter(|_| slides) else {
        return Vec::new();
    };
    let e = problem.cam.offset.unwrap_or(0.0);
    let rise = (prime * prime - e * e).max(0.0).sqrt();
    (SIDES.into_iter().zip(SIGNS))
        .filter_map(|(name, side)| {
            let tan = problem.limits[name]?.tan();
            let offset = side * e;
            let meaning = Meaning::PrimeRadius { tan, offset };
            let weights = [-tan, side, 0.0, 0.0, 0.0];
            let limit = structural(name, weights, tan * rise + offset, prime);
            Some(meaning.of(limit))
        })
        .collect()
}

/// With D, and e where it is open, among the variables.
pub fn rows_with_size(problem: &Problem) -> [Limit; 2] {
    let angles = problem.sizing_pressure_angles();
    [0, 1].map(|i| {
        let (name, side) = (SIDES[i], SIGNS[i]);
        let t = angles[i].min(NEARLY_RIGHT).tan();
        let bound = side * problem.offset().unwrap_or(0.0);
        let weights = [-t, side, 0.0, 0.0, 0.0];
        let limit = structural(name, weights, bound, problem.length);
        let mut limit = Meaning::Sized.of(limit);
        limit.extra[RISE] = -t;
        if problem.offset().is_none() {
            limit.extra[OFFSET] = -side;
        }
        limit
    })
}

/// Of a roller on an arm: t c sin ξ ∓ (A(1 + ξ′) − c cos ξ), from tan φ = (A(1 + ξ′) − c cos ξ)/(c sin ξ).
pub fn arm_slack(at: Svaj, c: f64, arm: f64, rest: f64, tan: f64, side: f64) -> Slack {
    let (sin, cos) = (rest + at.s).sin_cos();
    let [rising, falling] = SIDES;
    Slack {
        h: tan * c * sin - side * (arm * (1.0 + at.v) - c * cos),
        w: c,
        largest: tan * c + arm,
        by_lift: tan * c * cos - side * c * sin,
        by_velocity: -side * arm,
        ..Slack::none(if side > 0.0 { rising } else { falling })
    }
}

/// Pressure angles up to which a cam is good for any machine and for slow ones, where the scene limits neither
/// side: the bounds of CAM-DAS (Serrano Muñoz 2010). A flat face has none to judge.
pub fn usual_pressure_angle(problem: &Problem) -> Option<[f64; 2]> {
    let limits = &problem.limits;
    if SIDES.iter().any(|side| limits[*side].is_some()) || limits.unjudged.pressure_angle {
        return None;
    }
    let any_machine: f64 = match problem.cam.follower {
        FollowerKind::FlatTranslating | FollowerKind::FlatOscillating => return None,
        FollowerKind::RollerOscillating
        | FollowerKind::KnifeOscillating
        | FollowerKind::MushroomOscillating => 35.0,
        FollowerKind::RollerTranslating
        | FollowerKind::KnifeTranslating
        | FollowerKind::MushroomTranslating
        | FollowerKind::TranslatingCam
        | FollowerKind::Barrel => 30.0,
    };
    Some([any_machine, 45.0].map(f64::to_radians))
}

/// Both sides of the finished cam's pressure angle against its limits, or against what is usual.
pub fn checks(problem: &Problem, (low, high): (Extreme, Extreme)) -> Vec<Check> {
    let usual = usual_pressure_angle(problem).map(|[_, slow]| slow);
    let worst = [high, low.map(|angle| -angle)];
    (SIDES.into_iter().zip(worst))
        .filter_map(|(name, worst)| {
            let limit = problem.limits[name].or(usual)?;
            Some(Check::of(name, worst, limit, GEOMETRY))
        })
        .collect()
}

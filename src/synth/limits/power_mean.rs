//! Limit on the mean shaft power without friction: the power dissipated by damping (theory §10).
//!
//! Over a closed law, spring, mass and weight return their energy. At constant speed, the mean of F·v·ω is then ω·w₁·mean(v²), where w₁ is the
//! damping force per velocity. The limit is therefore a limit on the root mean square of v.

use super::finished::{Finished, SLACK};
use super::loads::torque_curve;
use crate::cam::{Check, LimitKind};
use crate::poly::Extreme;
use crate::problem::Problem;
use crate::synth::qp::{Basis, MeanSquare, Meaning, RmsLimit, only};

/// Number of quadrature nodes per span if the law is a sum of harmonics.
const HARMONIC_NODES: usize = 9;

/// Limit √mean(v²) ≤ √(P/(ω w₁)) for the permitted mean power P, at the mean speed ω. `None` without a limit or without damping.
pub fn root_mean_square(problem: &Problem, basis: &Basis) -> Option<RmsLimit> {
    let limit = problem.limits[LimitKind::PowerMean]?;
    let factor = problem.drive.speed * problem.drive.weights()[1];
    if factor <= 0.0 {
        return None;
    }
    let nodes = match basis {
        Basis::Spline { space, .. } => space.degree(),
        Basis::Harmonic { .. } => HARMONIC_NODES,
    };
    Some(RmsLimit {
        name: LimitKind::PowerMean.into(),
        half: MeanSquare::distance(basis, &only(1, 1.0), nodes, |_, _, _, out| out.fill(0.0)),
        most: (limit / factor).sqrt(),
        meaning: Meaning::Square { factor },
    })
}

/// Check of the mean power over time. This power is the product of the mean torque over the angle and the mean speed.
pub fn check(design: &Finished) -> Option<Check> {
    let problem = design.problem;
    let limit = problem.limits[LimitKind::PowerMean]?;
    let law = &design.cam.law;
    let torque = torque_curve(problem.force_curve(design.pressing), law);
    let (start, length) = law.extent();
    let worst = Extreme {
        at: start,
        value: problem.drive.speed * torque.integral() / length,
    };
    Some(Check::of(LimitKind::PowerMean, worst, limit, SLACK))
}

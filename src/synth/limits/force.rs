//! Limits on the contact force, the force band about the target, and the force error.

use super::finished::{Finished, SLACK};
use crate::cam::{Check, Criterion, LimitKind};
use crate::force::ForceCurve;
use crate::poly::{Extreme, PiecewisePoly};
use crate::problem::{Problem, piecewise};
use crate::scene::Minimise;
use crate::synth::qp::{
    Limit, MeanSquare, Meaning, PEAK, Program, RmsLimit, TOLERANCE, structural,
};

/// Limits on the minimum and maximum contact force over the turn.
pub fn rows(problem: &Problem) -> Vec<Limit> {
    let [s, v, a, _] = problem.drive.weights();
    let rest = problem.drive.rest_force;
    let scale = problem
        .target
        .as_ref()
        .map_or(rest.abs(), |t| t.mean_n().abs());
    let meaning = |factor: f64| Meaning::Value {
        factor,
        offset: rest,
    };
    let mut out = Vec::new();
    if let Some(low) = problem.limits[LimitKind::ForceMin] {
        let weights = [-s, -v, -a, 0.0, 0.0];
        let limit = structural(LimitKind::ForceMin, weights, rest - low, scale);
        out.push(meaning(-1.0).of(limit));
    }
    if let Some(high) = problem.limits[LimitKind::ForceMax] {
        let weights = [s, v, a, 0.0, 0.0];
        let limit = structural(LimitKind::ForceMax, weights, high - rest, scale);
        out.push(meaning(1.0).of(limit));
    }
    out
}

/// Limits on the difference between force and target: the force band, and the maximum error if it is the objective. The function adds their
/// angle-dependent bounds and the cost of the maximum error to the program.
pub fn about_the_target(problem: &Problem, program: &mut Program) -> Vec<Limit> {
    let Some(target) = &problem.target else {
        return Vec::new();
    };
    let [s, v, a, _] = problem.drive.weights();
    let rest = problem.drive.rest_force;
    let scale = target.mean_n().abs().max(f64::MIN_POSITIVE);
    let mut out = Vec::new();
    // Limit on one side of the target: ±(F₀ + w·svaj) ≤ ±edge(θ) + bound, with the force at rest F₀.
    let mut side = |name: Criterion, sign: f64, edge: &ForceCurve, meaning: Meaning| {
        program.shapes.push(PiecewisePoly::combine(
            &[(sign, &piecewise(edge))],
            -sign * rest,
        ));
        let weights = [sign * s, sign * v, sign * a, 0.0, 0.0];
        Limit {
            shape: Some(program.shapes.len() - 1),
            ..meaning.of(structural(name, weights, 0.0, scale))
        }
    };
    if let Some([low, high]) = &problem.band {
        // The bound is displayed as the mean half width of the band.
        let half_width = Meaning::Value {
            factor: 1.0,
            offset: 0.5 * (high.mean_n() - low.mean_n()),
        };
        out.push(side(Criterion::Band, 1.0, high, half_width));
        out.push(side(Criterion::Band, -1.0, low, half_width));
    }
    if problem.objective() == Minimise::PeakForceError {
        for sign in [1.0, -1.0] {
            out.push(side(Criterion::Peak, sign, target.curve(), Meaning::Structure).minimised());
        }
        program.cost[PEAK] = 1.0;
    }
    out
}

/// Limit on the RMS force error if the objective is another quantity. `half` is half the mean square of the force error.
pub fn accuracy(problem: &Problem, half: impl FnOnce() -> MeanSquare) -> Option<RmsLimit> {
    let most = problem.limited_error()?;
    Some(RmsLimit {
        name: Criterion::Accuracy,
        half: half(),
        most,
        meaning: Meaning::times(1.0 / problem.target_mean()),
    })
}

/// Maximum magnitude of a negative contact force that counts as a rounding error, relative to the maximum absolute force.
const TOUCHES: f64 = 1e-7;

/// Checks of the minimum and maximum force. Without a minimum force in the scene, the default minimum is checked, which ensures contact.
pub fn checks(design: &Finished) -> Vec<Check> {
    let limits = &design.problem.limits;
    let (low, high) = design.problem.force_extremes(design.pressing);
    let mut out = Vec::new();
    if let Some(limit) = limits[LimitKind::ForceMin] {
        let mut check = Check::of(LimitKind::ForceMin, low, limit, SLACK);
        check.pass = low.value >= limit - slack(design);
        out.push(check);
    } else if let Some(limit) = design.problem.usual_force_min() {
        let mut check = Check::of(LimitKind::ForceMin, low, limit, 0.0);
        check.pass = low.value >= limit - TOUCHES * high.value.abs().max(low.value.abs());
        out.push(check);
    }
    if let Some(limit) = limits[LimitKind::ForceMax] {
        out.push(Check::of(LimitKind::ForceMax, high, limit, SLACK));
    }
    out
}

/// Check of the force band. Without a band, check of the RMS force error; `None` if this error has no limit.
pub fn accuracy_check(design: &Finished) -> Option<Check> {
    let (problem, force) = (design.problem, design.force);
    if let Some([low, high]) = &problem.band {
        let curve = problem.drive.force_curve(design.pressing);
        let below = difference(&piecewise(low), &curve).extremes().1;
        let above = difference(&curve, &piecewise(high)).extremes().1;
        let worst = if below.value > above.value {
            below
        } else {
            above
        };
        let mut check = Check::of(Criterion::Band, worst, 0.0, 0.0);
        check.pass = worst.value <= slack(design);
        return Some(check);
    }
    let limit = problem.judged_error()?;
    let worst = Extreme {
        at: 0.0,
        value: force.rms_error_n,
    };
    Some(Check::of(Criterion::RmsError, worst, limit, TOLERANCE))
}

/// Tolerance of a force in the checks, N.
fn slack(design: &Finished) -> f64 {
    let rest = design.problem.drive.rest_force.abs();
    SLACK * design.force.target_mean_n.abs().max(rest)
}

fn difference(own: &PiecewisePoly, target: &PiecewisePoly) -> PiecewisePoly {
    let own = own.cut_at(target.breaks());
    let target = target.cut_at(own.breaks());
    PiecewisePoly::combine(&[(1.0, &own), (-1.0, &target)], 0.0)
}

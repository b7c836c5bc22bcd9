//! Law and cam for one problem, or the reason why the limits are infeasible.
//!
//! For a rigid machine at constant speed and a single force, this is the whole design. For a machine whose motion depends on the cam, a
//! compliant follower or a population, several such problems are derived and solved.

use std::sync::Arc;

use super::families::{self, SolvedLaw};
use super::infeasible;
use super::limits;
use super::optimum::{Refusal, Sought};
use super::report::proof::Doubt;
use super::search::Search;
use super::sizing::checked_cam::{CheckedCam, checked_cam};
use crate::cam::{Check, LimitKind};
use crate::error::{Placed, Result};
use crate::problem::Problem;
use crate::scene::{LawSpec, Minimise};

/// A law with its cam, force and checks.
#[derive(Clone)]
pub struct Attempt {
    /// Best law within the limits, or without them if they are infeasible. Its minimum lift is on the base circle, unless the drive or a
    /// condition fixes the level of the lift.
    pub law: SolvedLaw,
    /// Cam of the law, with force and checks.
    pub cam: CheckedCam,
    /// Reason why the limits are infeasible; `None` if the law satisfies them.
    pub refusal: Option<Arc<Refusal>>,
}

/// Law within the limits of a problem, on the given or the smallest cam. If the limits are infeasible, the result contains the best law without
/// them and the reason.
///
/// # Errors
///
/// Errors of the input, and conditions that no law satisfies even without limits.
pub fn attempt(problem: &Problem, search: &Search) -> Result<Attempt> {
    let refusal = match under_limits(problem, search)? {
        Ok(attempt) => return Ok(attempt),
        Err(refusal) => refusal,
    };
    // The law is computed first: it is more important than the reason, and the time limit may end the search before both are found.
    match without_limits(problem, search, &refusal)? {
        Ok(attempt) => Ok(Attempt {
            refusal: Some(Arc::from(refusal)),
            ..attempt
        }),
        Err(_) => {
            let why = infeasible::explain(problem, &refusal);
            Err(why.no_law().at_key(why.key_of_demands()))
        }
    }
}

/// Law within the limits of a problem, on the given or the smallest cam.
///
/// # Errors
///
/// Errors of the input.
pub fn under_limits(problem: &Problem, search: &Search) -> Sought<Attempt> {
    if let Some(attempt) = within_diameter(problem, search)? {
        return Ok(Ok(attempt));
    }
    on_cam(problem, families::law(problem, search)?)
}

/// Law computed without the nonconvex limit on the diameter. A law that satisfies this limit is also the optimum with the limit, so the
/// sequence of convex programs is not needed. `None` if the law violates the limit, if no law exists, or if the problem has no such limit.
fn within_diameter(problem: &Problem, search: &Search) -> Result<Option<Attempt>> {
    if !limits::diameter_is_nonconvex(problem) {
        return Ok(None);
    }
    let mut open = problem.limits.clone();
    open[LimitKind::Diameter] = None;
    let law = families::law(&problem.with_limits(open), search)?;
    let attempt = on_cam(problem, law)?.ok();
    let keeps = |c: &Check| c.name != LimitKind::Diameter || c.pass;
    Ok(attempt.filter(|attempt| attempt.cam.checks.iter().all(keeps)))
}

/// Combines a law with the given or the smallest feasible cam of a problem.
fn on_cam(
    problem: &Problem,
    sought: std::result::Result<SolvedLaw, Box<Refusal>>,
) -> Sought<Attempt> {
    let law = match sought {
        Ok(law) => law,
        Err(refusal) => return Ok(Err(refusal)),
    };
    let cam = checked_cam(problem, &law.law, law.circle, None)?;
    Ok(Ok(Attempt::of(law, cam)))
}

impl Attempt {
    /// Combines a law with its cam. The coefficients of the law are changed such that the lift increases by the shift to the base circle.
    pub fn of(mut law: SolvedLaw, cam: CheckedCam) -> Attempt {
        law.functions.raise(&mut law.coefficients, cam.raised);
        law.law = cam.pressing().clone();
        Attempt {
            law,
            cam,
            refusal: None,
        }
    }
}

/// Best law without some limits. If the limits are infeasible only because of the required accuracy, the law is computed without this
/// accuracy. Otherwise it is computed without any limit. If this fails, the lift may also be below the base circle. If the force error is
/// limited but is not the objective, the law minimises the force error.
fn without_limits(problem: &Problem, search: &Search, refusal: &Refusal) -> Sought<Attempt> {
    let timely = Search::until(search.halt.clone());
    let of_accuracy = refusal.is_of_accuracy();
    let bare = if of_accuracy {
        problem.without_accuracy()
    } else {
        problem.without_limits()
    };
    let of_force =
        problem.limited_error().is_some() && problem.objective() != Minimise::PeakForceError;
    let bare = bare.with_law(LawSpec {
        family: refusal.family(),
        minimise: match of_force {
            true => Some(Minimise::ForceError),
            false => bare.law.minimise,
        },
        ..bare.law.clone()
    });
    // After the time limit, the least-squares problem is solved without a time limit, because it takes little time.
    let endless = Search::default().below_base_circle();
    let is_late = search.halt.is_asked();
    let timely = (!is_late)
        .then(|| families::law(&bare, &timely))
        .transpose()?;
    let law = match timely {
        Some(Ok(law)) => Ok(law),
        None => families::law(&quick(&bare), &endless)?,
        Some(Err(_)) if search.halt.is_asked() => families::law(&quick(&bare), &endless)?,
        Some(Err(_)) => families::law(&bare, &endless)?,
    };
    // The optimum within the limits keeps its certificate although it violates the accuracy, as if the force error were minimised.
    if of_accuracy {
        return on_cam(problem, law);
    }
    // The certificate does not apply to a law that violates the limits.
    let unproved = |mut law: SolvedLaw| {
        law.easing.clear();
        law.solver.certificate = None;
        law.solver.certified = false;
        law.solver.doubt = Some(Doubt::Limits);
        law
    };
    on_cam(problem, law.map(unproved))
}

/// The problem with a quadratic objective instead of a peak. A least-squares problem or a closed form then gives the law.
fn quick(problem: &Problem) -> Problem {
    match problem.objective() {
        Minimise::Peak(order) => problem.minimising(Minimise::Energy(order)),
        Minimise::PeakForceError => problem.minimising(Minimise::ForceError),
        Minimise::ForceError | Minimise::Energy(_) | Minimise::Size => problem.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synth::samples::{FLAT, amplitude, one_wave};
    use crate::units::G;

    #[test]
    fn one_wave_without_limits_is_its_closed_form_on_the_base_circle() {
        let problem = one_wave(FLAT, "");
        let found = attempt(&problem, &Search::default()).unwrap();
        let stroke = found.cam.cam.law.stroke();
        assert!((stroke / (2.0 * amplitude(&problem)) - 1.0).abs() < 1e-9);
        assert!(found.cam.force.rms_error_n < 1e-6 * problem.target_mean());
        assert!(found.refusal.is_none() && found.cam.cam.law.extremes(0).0.value.abs() < 1e-12);
        // The coefficients are those of the law where it stands.
        assert!((found.law.coefficients[0] - amplitude(&problem)).abs() < 1e-9);
    }

    #[test]
    fn half_the_acceleration_leaves_half_the_wave_and_its_price_is_the_slope_of_the_error() {
        let problem = one_wave(FLAT, &format!("acceleration = \"{} m/s^2\"", 0.15 * G));
        let found = attempt(&problem, &Search::default()).unwrap();
        assert!((found.law.law.stroke() / amplitude(&problem) - 1.0).abs() < 1e-6);
        let error = 0.15 * problem.target_mean() / 2.0_f64.sqrt();
        assert!((found.cam.force.rms_error_n / error - 1.0).abs() < 1e-6);
        assert_eq!(found.law.binding[0].limit, LimitKind::Acceleration);
        // 1 % more acceleration is 1 % less of what is missing.
        let easing = &found.law.easing[0];
        let gained = (easing.before - easing.after) / (0.01 * error);
        assert!((gained - 1.0).abs() < 0.02, "{gained}");
    }

    #[test]
    fn where_limits_leave_no_law_the_best_without_them_is_shown_without_a_proof() {
        // The mean of the force is the weight.
        let problem = one_wave(FLAT, "force_min = \"2 kN\"");
        let found = attempt(&problem, &Search::default()).unwrap();
        assert!(found.refusal.is_some() && !found.law.solver.certified);
        let stroke = found.law.law.stroke();
        assert!((stroke / (2.0 * amplitude(&problem)) - 1.0).abs() < 1e-9);
        let strict = under_limits(&problem, &Search::default()).unwrap();
        assert!(strict.is_err());
    }

    #[test]
    fn the_smallest_flat_cam_of_one_wave_has_the_radius_that_is_asked_for() {
        // s + a is constant: ρ = R + A.
        let problem = one_wave(FLAT, "curvature = \"50 mm\"");
        let found = attempt(&problem, &Search::default()).unwrap();
        let base = found.cam.cam.follower.base_radius();
        assert!((base + amplitude(&problem) - 0.05).abs() < 1e-9, "{base}");
    }
}

//! Polydyne cam of a compliant follower. The law of the follower's end is optimised. The cam is computed so that the end performs this law in
//! spite of the deflection of the follower. All limits of the cam apply to the law of the cam.

use crate::cam::Criterion;
use crate::dynamics::Train;
use crate::dynamics::flexible::polydyne::{end_error, polydyne};
use crate::error::{Error, Placed, Result};
use crate::law::Law;
use crate::problem::Problem;
use crate::scene::Limits;
use crate::synth::attempt::{Attempt, attempt};
use crate::synth::design::Design;
use crate::synth::families::{self, SolvedLaw};
use crate::synth::finish::{Reports, finished};
use crate::synth::report::end::End;
use crate::synth::search::Search;
use crate::synth::sizing::checked_cam::checked_cam;

/// Maximum number of corrections of the limits for the follower's end.
const ROUNDS: usize = 12;
/// Relative margin by which a changed limit for the follower's end is tightened further, so that the iteration ends.
const AIM: f64 = 1e-6;
/// Maximum relative difference between the value of the cam and its limit at which the cam reaches the limit. It is used for limits that are
/// active in the law of the follower's end.
const NEAR: f64 = 1e-4;

/// Designs the law of the follower's end and the cam that produces it.
///
/// The limits of the program apply to the law of the end. The law of the cam differs from the law of the end by the deflection of the
/// follower. The cam may therefore violate a limit, or have a margin to a limit that is active for the end. The limit for the end is then
/// changed, and the law is computed again.
pub fn designed(problem: &Problem, search: &Search, train: &Train) -> Result<Design> {
    let first = attempt(problem, search)?;
    let mut best = Attempt {
        refusal: first.refusal,
        ..on_train(problem, first.law, train)?
    };
    let rounds = if best.refusal.is_none() { ROUNDS } else { 0 };
    let mut limits = problem.limits.clone();
    let mut last = best.clone();
    for _ in 0..rounds {
        if !move_limits(&last, &mut limits) {
            break;
        }
        last = match families::law(&problem.with_limits(limits.clone()), search)? {
            Ok(law) => on_train(problem, law, train)?,
            // Tightened limits may be infeasible. The checks of the previous iteration then show the violated limits.
            Err(_) => break,
        };
        if last.cam.broken().is_none() || best.cam.broken().is_some() {
            best = last.clone();
        }
    }
    let wanted = best.cam.pressing().clone();
    let reports = Reports {
        end: Some(end_of(problem, train, &best.cam.cam.law, wanted)),
        ..Reports::default()
    };
    Ok(finished(problem, search, best, reports))
}

/// Cam for a law of the follower's end, with the checks of the problem.
fn on_train(problem: &Problem, law: SolvedLaw, train: &Train) -> Result<Attempt> {
    let key = |e: Error| e.at_key("law.polydyne");
    let whole = polydyne(&law.law, &problem.drive, train).map_err(key)?;
    let cam = checked_cam(problem, &whole, None, Some(&law.law))?;
    Ok(Attempt::of(law, cam))
}

/// Changes the limits for the follower's end by the distances of the cam from these limits. Returns `false` if no change is necessary.
fn move_limits(tried: &Attempt, limits: &mut Limits) -> bool {
    let mut any = false;
    for check in &tried.cam.checks {
        let binds = tried.law.binding.iter().any(|b| b.limit == check.name);
        let apart = check.worst - check.limit;
        let idle = binds && apart.abs() > NEAR * check.limit.abs();
        if check.pass && !idle {
            continue;
        }
        let Some(limit) = own_limit(limits, check.name) else {
            continue;
        };
        let inside = -check.name.direction().sign();
        let next = *limit - apart + inside * AIM * check.limit.abs();
        if next.is_finite() && next > 0.0 {
            *limit = next;
            any = true;
        }
    }
    any
}

/// Limit for the follower's end that corresponds to a check of the cam. `None` if the limit is absent, or if changing it cannot bring the
/// value of the cam to its bound.
fn own_limit(limits: &mut Limits, check: Criterion) -> Option<&mut f64> {
    let kind = check.limit().filter(|kind| kind.facts().moves_with_end)?;
    limits[kind].as_mut()
}

/// Report on the end of the follower. It contains the deviation of the end from its law, for this cam and for a cam whose lift is the law of
/// the end.
fn end_of(problem: &Problem, train: &Train, own: &Law, wanted: Law) -> End {
    let Train { stiffness, damping } = *train;
    // Without damping and at resonance with a harmonic, there is no steady state.
    let miss = |law: &Law| end_error(law, &wanted, &problem.drive, train).ok();
    End {
        stiffness,
        damping,
        miss: miss(own),
        plain_miss: miss(&wanted),
        law: wanted,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::built_in;

    /// Without damping, s = y + F(y)/k. For one harmonic, the stroke of the cam is 1 − (ω/ωₙ)² times the stroke of the follower's end.
    #[test]
    fn the_cam_of_one_wave_has_the_stroke_of_its_end_less_what_the_follower_gives() {
        let scene = built_in("footbridge").unwrap().scene().unwrap();
        let changes = [
            ("law.family", "harmonic"),
            ("law.harmonics", "1"),
            ("machine.natural_frequency", "12 Hz"),
            ("machine.damping_ratio", "0"),
            ("law.polydyne", "true"),
            ("accuracy.rms", "none"),
        ];
        let scene = (changes.iter()).fold(scene, |s, (key, value)| s.with(key, value).unwrap());
        let force = scene.model_force().unwrap();
        let problem = Problem::resolve(&scene, force.as_ref()).unwrap();
        let train = problem.train().unwrap().unwrap();
        let design = designed(&problem, &Search::default(), &train).unwrap();
        let end = design.end.as_ref().unwrap();
        let ratio = problem.drive.speed / (std::f64::consts::TAU * 12.0);
        let part = design.cam.law.stroke() / end.law.stroke();
        assert!((part - (1.0 - ratio * ratio)).abs() < 1e-9, "{part}");
        // The coefficients are those of the end where it stands.
        let [level, cosine] = [design.coefficients[0], design.coefficients[1]];
        assert!((level + cosine - end.law.svaj(0.0).s).abs() < 1e-12);
    }
}

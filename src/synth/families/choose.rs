//! Which family of laws a scene gets that does not insist on one: families simpler than the spline are tried first.

use super::double_harmonic::double_harmonic_law;
use super::harmonic::{harmonic_law, inverted};
use super::solved::SolvedLaw;
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use crate::synth::infeasible::explain;
use crate::synth::optimum::NoLaw;
use crate::synth::report::method::PassedOver;
use crate::synth::report::reason::quantity;
use crate::synth::search::Search;
use crate::synth::sizing::checked_cam::checked_cam;
use crate::units::Quantity;

/// What the families simpler than the spline come to.
pub enum Simpler {
    /// The first one whose cam passes every check.
    Passes(Box<SolvedLaw>),
    /// What each one misses.
    Missed(Vec<PassedOver>),
}

/// What a family simpler than the spline is called on the ladder, and how its law is found.
type Candidate = (&'static str, fn(&Problem, &Search) -> Attempt);
/// A law, or what it misses, where that is worth telling.
type Attempt = Result<SolvedLaw, Option<PassedOver>>;

/// The harmonics in closed form: where every limit and the accuracy hold with them they are the optimum (theory §1).
const INVERSE: Candidate = ("inverse-by-harmonics", inverse);
/// The first of the simpler families whose cam passes every check.
pub fn simpler(problem: &Problem, search: &Search) -> Result<Simpler, NoLaw> {
    let mut passed_over = Vec::new();
    for (family, attempt) in candidates(problem, search) {
        let mut law = match attempt(problem, search) {
            Ok(law) => law,
            Err(miss) => {
                passed_over.extend(miss);
                continue;
            }
        };
        let checked = checked_cam(problem, &law.law, law.circle, None)?;
        // Without a required accuracy the usual one applies.
        let excess = checked.force.rms_error_n - problem.wanted_error();
        if problem.target.is_some() && problem.accuracy.is_none() && excess > 0.0 {
            let excess = Quantity::force(excess);
            passed_over.push(PassedOver::Accuracy { family, excess });
            continue;
        }
        let Some(broken) = checked.broken() else {
            law.solver.passed_over = passed_over;
            return Ok(Simpler::Passes(Box::new(law)));
        };
        let measures = checked.cam.follower.measures();
        passed_over.push(PassedOver::Check {
            family,
            value: quantity(measures, broken.name, broken.worst),
            limit: quantity(measures, broken.name, broken.limit),
            check: broken.name,
        });
    }
    Ok(Simpler::Missed(passed_over))
}

/// The families that the problem may have. Only a spline meets demands and other objectives.
fn candidates(problem: &Problem, search: &Search) -> Vec<Candidate> {
    let law = &problem.law;
    let is_ladder = law.family == Family::Ladder;
    let unsuited = if is_ladder {
        problem.is_weighed() || law.monotone || law.polydyne
    } else {
        // Only the spline can decide feasibility: where nothing else is of use, simpler families are skipped.
        search.only_passing
    };
    let only_spline = problem.target.is_none()
        || problem.has_demands()
        || problem.objective() != Minimise::ForceError;
    if only_spline || unsuited {
        return Vec::new();
    }
    if is_ladder {
        return vec![INVERSE];
    }
    vec![
        (Family::DoubleHarmonic.name(), double_harmonic),
        (Family::Harmonic.name(), harmonic),
    ]
}

fn inverse(problem: &Problem, _: &Search) -> Attempt {
    let (family, wanted) = (INVERSE.0, problem.wanted_error());
    // In resonance a spline may still have a law: it distributes the force of the missing harmonic.
    let (law, left_over) = inverted(problem, None, wanted).map_err(|fault| {
        let fault = fault.to_string();
        PassedOver::Fault { family, fault }
    })?;
    let excess = Quantity::force(left_over - wanted);
    if left_over > wanted {
        return Err(Some(PassedOver::Accuracy { family, excess }));
    }
    Ok(law)
}

fn double_harmonic(problem: &Problem, _: &Search) -> Attempt {
    double_harmonic_law(problem).map_err(|_| None)
}

fn harmonic(problem: &Problem, search: &Search) -> Attempt {
    harmonic_law(problem, search).map_err(|no_law| match no_law {
        NoLaw::Fault(_) => None,
        NoLaw::Refused(refusal) => Some(PassedOver::Limits {
            family: Family::Harmonic.name(),
            limits: explain(problem, &refusal).conflict,
        }),
    })
}

//! Which family of laws a scene gets that does not insist on one: families simpler than the spline are tried first.

use super::{NoLaw, SolvedLaw, double_harmonic, harmonic};
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use crate::synth::checked_cam::CheckedCam;
use crate::synth::design::method::PassedOver;
use crate::synth::design::reason::quantity;
use crate::synth::infeasible::explain;
use crate::synth::search::Search;
use crate::units::Quantity;

/// The harmonics in closed form, as the ladder names them.
const INVERSE: &str = "the inverse by harmonics";

/// What the families simpler than the spline come to.
pub enum Simpler {
    /// The first one whose cam passes every check.
    Passes(Box<SolvedLaw>),
    /// What each one misses.
    Missed(Vec<PassedOver>),
}

/// The first of the simpler families whose cam passes every check.
pub fn simpler(problem: &Problem, search: &Search) -> Result<Simpler, NoLaw> {
    if problem.law.family == Family::Ladder {
        inverse(problem, search)
    } else {
        simplest(problem, search)
    }
}

/// Harmonics in closed form, where every limit and the accuracy hold with them, because then they are the optimum
/// already (theory §1).
fn inverse(problem: &Problem, search: &Search) -> Result<Simpler, NoLaw> {
    let law = &problem.law;
    let only_splines = problem.is_weighed()
        || law.monotone
        || law.polydyne
        || problem.has_demands()
        || problem.objective() != Minimise::ForceError;
    if problem.target.is_none() || only_splines {
        return Ok(Simpler::Missed(Vec::new()));
    }
    let wanted = problem.wanted_error();
    // In resonance a spline may still have a law: it distributes the force of the missing harmonic.
    let missed = match harmonic::inverted(problem, None, wanted) {
        Ok((_, left_over)) if left_over > wanted => PassedOver::Accuracy {
            family: INVERSE,
            excess: Quantity::force(left_over - wanted),
        },
        Ok((found, _)) => match missed_by(problem, search, &found, INVERSE)? {
            None => return Ok(Simpler::Passes(Box::new(found))),
            Some(miss) => miss,
        },
        Err(fault) => PassedOver::Fault {
            family: INVERSE,
            fault: fault.to_string(),
        },
    };
    Ok(Simpler::Missed(vec![missed]))
}

/// A double harmonic, or a few harmonics: the first whose cam passes every check.
fn simplest(problem: &Problem, search: &Search) -> Result<Simpler, NoLaw> {
    let mut passed_over = Vec::new();
    // Only the spline can decide feasibility: where nothing else is of use, simpler families are skipped.
    let only_spline = search.only_passing
        || problem.target.is_none()
        || problem.has_demands()
        || problem.objective() != Minimise::ForceError;
    if only_spline {
        return Ok(Simpler::Missed(passed_over));
    }
    for family in [Family::DoubleHarmonic, Family::Harmonic] {
        let law = match family {
            Family::DoubleHarmonic => double_harmonic::law(problem, search),
            _ => harmonic::law(problem, search),
        };
        passed_over.push(match law {
            Err(NoLaw::Fault(_)) => continue,
            Err(NoLaw::Refused(refusal)) => PassedOver::Limits {
                family: family.name(),
                limits: explain(problem, &refusal).conflict,
            },
            Ok(mut law) => match missed_by(problem, search, &law, family.name())? {
                Some(miss) => miss,
                None => {
                    law.solver.passed_over = passed_over;
                    return Ok(Simpler::Passes(Box::new(law)));
                }
            },
        });
    }
    Ok(Simpler::Missed(passed_over))
}

/// What the cam of a law breaks first; `None` when it passes.
fn missed_by(
    problem: &Problem,
    search: &Search,
    found: &SolvedLaw,
    family: &'static str,
) -> Result<Option<PassedOver>, NoLaw> {
    let checked = CheckedCam::of(problem, search, &found.law, None)?;
    let error = checked.force.rms_error_n;
    // Without a required accuracy the usual one applies.
    let wanted = problem.wanted_error();
    if problem.target.is_some() && problem.accuracy.is_none() && error > wanted {
        let excess = Quantity::force(error - wanted);
        return Ok(Some(PassedOver::Accuracy { family, excess }));
    }
    let measures = checked.cam.follower.measures();
    Ok(checked.broken().map(|c| PassedOver::Check {
        family,
        value: quantity(measures, c.name, c.worst),
        limit: quantity(measures, c.name, c.limit),
        check: c.name,
    }))
}

//! Which family of laws a scene gets that does not insist on one.

use super::{NoLaw, SolvedLaw, double_harmonic, harmonic, on_base_circle, spline};
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use crate::synth::design::method::PassedOver;
use crate::synth::design::reason::quantity;
use crate::synth::infeasible::explain;
use crate::synth::limits::{Finished, force_report};
use crate::synth::search::Search;
use crate::synth::sizing;
use crate::units::Quantity;

/// The harmonics in closed form, as the ladder names them.
const INVERSE: &str = "the inverse by harmonics";

/// The first rungs of the ladder as families: harmonics in closed form where every limit and the accuracy
/// hold with them, because then they are the optimum already (theory §1); a spline otherwise. The spline
/// says what the harmonics missed.
pub fn ladder(problem: &Problem, search: &Search) -> Result<SolvedLaw, NoLaw> {
    let law = &problem.law;
    let weighed = problem.is_weighed();
    let only_splines = weighed
        || law.monotone
        || law.polydyne
        || problem.has_demands()
        || problem.objective() != Minimise::ForceError;
    if problem.target.is_none() || only_splines {
        return spline::law(problem, search);
    }
    let wanted = problem.wanted_error();
    // In resonance a spline may still have a law: it distributes the force of the missing harmonic.
    let missed = match harmonic::inverted(problem, None, wanted) {
        Ok((_, left_over)) if left_over > wanted => PassedOver::Accuracy {
            family: INVERSE,
            excess: Quantity::force(left_over - wanted),
        },
        Ok((found, _)) => match missed_by(problem, search, &found, INVERSE)? {
            None => return Ok(found),
            Some(miss) => miss,
        },
        Err(fault) => PassedOver::Fault {
            family: INVERSE,
            fault: fault.to_string(),
        },
    };
    let mut found = spline::law(problem, search)?;
    found.solver.passed_over.push(missed);
    Ok(found)
}

/// The simplest family whose cam passes every check: a double harmonic, a few harmonics, a spline. The
/// families that were passed over say what they missed by.
pub fn simplest(problem: &Problem, search: &Search) -> Result<SolvedLaw, NoLaw> {
    let mut passed_over = Vec::new();
    // Only the spline can decide feasibility: where nothing else is of use, simpler families are skipped.
    if !search.only_passing
        && problem.target.is_some()
        && !problem.has_demands()
        && problem.objective() == Minimise::ForceError
    {
        let double: super::FamilyLaw = double_harmonic::law;
        for (family, law) in [
            (Family::DoubleHarmonic, double),
            (Family::Harmonic, harmonic::law),
        ] {
            let miss = match law(problem, search) {
                Err(NoLaw::Fault(_)) => continue,
                Err(NoLaw::Refused(refusal)) => PassedOver::Limits {
                    family: family.name(),
                    limits: explain(problem, &refusal).conflict,
                },
                Ok(mut found) => match missed_by(problem, search, &found, family.name())? {
                    Some(miss) => miss,
                    None => {
                        found.solver.passed_over = passed_over;
                        return Ok(found);
                    }
                },
            };
            passed_over.push(miss);
        }
    }
    let mut found = spline::law(problem, search)?;
    found.solver.passed_over = passed_over;
    Ok(found)
}

/// What the cam of a law breaks first; `None` when it passes.
fn missed_by(
    problem: &Problem,
    search: &Search,
    found: &SolvedLaw,
    family: &'static str,
) -> Result<Option<PassedOver>, NoLaw> {
    let law = on_base_circle(problem, search, &found.law);
    let cam = sizing::cam(problem, law.clone(), &law)?;
    let force = force_report(problem, search, &cam.law);
    // Without a required accuracy the usual one applies.
    let wanted = problem.wanted_error();
    if problem.target.is_some() && problem.accuracy.is_none() && force.rms_error_n > wanted {
        let excess = Quantity::force(force.rms_error_n - wanted);
        return Ok(Some(PassedOver::Accuracy { family, excess }));
    }
    let checks = Finished::of_one_cam(problem, &cam, &cam.law, &force).checks();
    let measures = cam.follower.measures();
    let broken = checks.into_iter().find(|c| !c.pass);
    Ok(broken.map(|c| PassedOver::Check {
        family,
        value: quantity(measures, c.name, c.worst),
        limit: quantity(measures, c.name, c.limit),
        check: c.name,
    }))
}

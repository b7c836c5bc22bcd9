//! Which family of laws a scene gets that does not insist on one: families simpler than the spline are tried first.

use super::double_harmonic::double_harmonic_law;
use super::harmonic::{harmonic_law, inverted};
use super::solved::SolvedLaw;
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use crate::synth::design::method::PassedOver;
use crate::synth::design::reason::quantity;
use crate::synth::infeasible::explain;
use crate::synth::optimum::NoLaw;
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

/// A family simpler than the spline.
#[derive(Clone, Copy)]
enum Candidate {
    /// The harmonics in closed form: where every limit and the accuracy hold with them they are the optimum (theory §1).
    Inverse,
    /// One double harmonic.
    DoubleHarmonic,
    /// A few harmonics.
    Harmonic,
}

/// The first of the simpler families whose cam passes every check.
pub fn simpler(problem: &Problem, search: &Search) -> Result<Simpler, NoLaw> {
    let mut passed_over = Vec::new();
    for &candidate in candidates(problem, search) {
        let mut law = match attempt(candidate, problem, search) {
            Ok(law) => law,
            Err(miss) => {
                passed_over.extend(miss);
                continue;
            }
        };
        let family = candidate.name();
        let checked = checked_cam(problem, search, &law.law, None)?;
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
fn candidates(problem: &Problem, search: &Search) -> &'static [Candidate] {
    let law = &problem.law;
    let only_spline = problem.target.is_none()
        || problem.has_demands()
        || problem.objective() != Minimise::ForceError;
    if law.family == Family::Ladder {
        let only_spline = only_spline || problem.is_weighed() || law.monotone || law.polydyne;
        return if only_spline {
            &[]
        } else {
            &[Candidate::Inverse]
        };
    }
    // Only the spline can decide feasibility: where nothing else is of use, simpler families are skipped.
    if only_spline || search.only_passing {
        &[]
    } else {
        &[Candidate::DoubleHarmonic, Candidate::Harmonic]
    }
}

impl Candidate {
    /// The family as the ladder names it.
    fn name(self) -> &'static str {
        match self {
            Candidate::Inverse => "the inverse by harmonics",
            Candidate::DoubleHarmonic => Family::DoubleHarmonic.name(),
            Candidate::Harmonic => Family::Harmonic.name(),
        }
    }
}

/// The law of a candidate, or what it misses, where that is worth telling.
fn attempt(
    candidate: Candidate,
    problem: &Problem,
    search: &Search,
) -> Result<SolvedLaw, Option<PassedOver>> {
    let family = candidate.name();
    let law = match candidate {
        Candidate::DoubleHarmonic => double_harmonic_law(problem).map_err(NoLaw::Fault),
        Candidate::Inverse => {
            let wanted = problem.wanted_error();
            // In resonance a spline may still have a law: it distributes the force of the missing harmonic.
            return match inverted(problem, None, wanted) {
                Ok((_, left_over)) if left_over > wanted => Err(Some(PassedOver::Accuracy {
                    family,
                    excess: Quantity::force(left_over - wanted),
                })),
                Ok((law, _)) => Ok(law),
                Err(fault) => Err(Some(PassedOver::Fault {
                    family,
                    fault: fault.to_string(),
                })),
            };
        }
        Candidate::Harmonic => harmonic_law(problem, search),
    };
    law.map_err(|no_law| match no_law {
        NoLaw::Fault(_) => None,
        NoLaw::Refused(refusal) => Some(PassedOver::Limits {
            family,
            limits: explain(problem, &refusal).conflict,
        }),
    })
}

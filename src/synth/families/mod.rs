//! Computation of a law for a problem, one file per family. The automatic family uses harmonics in closed form if these satisfy all
//! requirements, and a spline otherwise.

mod demands;
mod double_harmonic;
mod formulation;
mod harmonic;
pub mod inverse;
mod polynomial;
mod program;
mod solved;
mod spline;

pub use solved::SolvedLaw;
pub use spline::{TELLING, WORTHWHILE, larger, notes_on_size};

use super::optimum::Sought;
use super::search::Search;
use crate::error::Result;
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use crate::synth::report::method::PassedOver;
use crate::synth::report::reason::quantity;
use crate::synth::report::solver::SolverReport;
use crate::synth::sizing::checked_cam::checked_cam;
use crate::units::Quantity;
use harmonic::inverted;

/// Computes the law of a problem, in the family that the scene selects. For the family `auto`, this is the harmonic law in closed form, or a
/// spline law if the harmonic law fails a check.
pub fn law(problem: &Problem, search: &Search) -> Sought<SolvedLaw> {
    let passed_over = match problem.law.family {
        Family::Polynomial => return Ok(Ok(polynomial::polynomial_law(problem)?)),
        Family::Program => return Ok(Ok(program::program_law(problem)?)),
        Family::DoubleHarmonic => return Ok(Ok(double_harmonic::double_harmonic_law(problem)?)),
        Family::Harmonic => return harmonic::harmonic_law(problem, search),
        Family::Spline => None,
        Family::Auto => match closed_form(problem)? {
            ClosedForm::Passes(law) => return Ok(Ok(*law)),
            ClosedForm::Missed(passed_over) => passed_over,
        },
    };
    let law = spline::spline_law(problem, search)?;
    Ok(law.map(|law| {
        let solver = SolverReport {
            passed_over,
            ..law.solver
        };
        SolvedLaw { solver, ..law }
    }))
}

/// Result of the harmonic law in closed form.
enum ClosedForm {
    /// The cam of this law passes every check, so the law is the optimum (theory §1).
    Passes(Box<SolvedLaw>),
    /// Requirement that the harmonic law does not satisfy; `None` if harmonics cannot be used for the problem.
    Missed(Option<PassedOver>),
}

/// Name of the harmonic closed form in [`PassedOver`].
const FAMILY: &str = "inverse-by-harmonics";

/// Harmonic law in closed form, or the requirement that this law does not satisfy.
fn closed_form(problem: &Problem) -> Result<ClosedForm> {
    if !suits(problem) {
        return Ok(ClosedForm::Missed(None));
    }
    let missed = |miss| Ok(ClosedForm::Missed(Some(miss)));
    let (family, wanted) = (FAMILY, problem.wanted_error());
    // At a resonance, a spline may still be feasible, because it distributes the force of the missing harmonic.
    let (law, left_over) = match inverted(problem, problem.law.harmonics, wanted) {
        Ok(found) => found,
        Err(fault) => {
            let fault = fault.to_string();
            return missed(PassedOver::Fault { family, fault });
        }
    };
    let excess = |error: f64| Quantity::force(error - wanted);
    if left_over > wanted {
        let excess = excess(left_over);
        return missed(PassedOver::Accuracy { family, excess });
    }
    let checked = checked_cam(problem, &law.law, law.circle, None)?;
    // Without a required accuracy, the default accuracy applies.
    let error = checked.force.rms_error_n;
    if problem.accuracy.is_none() && error > wanted {
        let excess = excess(error);
        return missed(PassedOver::Accuracy { family, excess });
    }
    let Some(broken) = checked.broken() else {
        return Ok(ClosedForm::Passes(Box::new(law)));
    };
    let measures = checked.cam.follower.measures();
    missed(PassedOver::Check {
        family,
        value: quantity(measures, broken.name, broken.worst),
        limit: quantity(measures, broken.name, broken.limit),
        check: broken.name,
    })
}

/// Whether harmonics can be used. This requires a target force, the force error without weights as objective, and no conditions on the law.
/// Conditions, weights and other objectives require a spline.
fn suits(problem: &Problem) -> bool {
    let law = &problem.law;
    problem.target.is_some()
        && problem.objective() == Minimise::ForceError
        && !(problem.has_demands() || problem.is_weighed() || law.monotone || law.polydyne)
}

//! The law of a scene that leaves the family open: the harmonics in closed form where they suffice.

use super::harmonic::inverted;
use super::solved::SolvedLaw;
use crate::error::Result;
use crate::problem::Problem;
use crate::scene::Minimise;
use crate::synth::report::method::PassedOver;
use crate::synth::report::reason::quantity;
use crate::synth::sizing::checked_cam::checked_cam;
use crate::units::Quantity;

/// What the harmonics in closed form come to.
pub enum ClosedForm {
    /// Their cam passes every check: the optimum (theory §1).
    Passes(Box<SolvedLaw>),
    /// What they miss; `None` where they cannot be asked.
    Missed(Option<PassedOver>),
}

/// The name of the closed form in [`PassedOver`].
const FAMILY: &str = "inverse-by-harmonics";

/// The harmonics in closed form, or what they miss.
pub fn closed_form(problem: &Problem) -> Result<ClosedForm> {
    if !suits(problem) {
        return Ok(ClosedForm::Missed(None));
    }
    let missed = |miss| Ok(ClosedForm::Missed(Some(miss)));
    let (family, wanted) = (FAMILY, problem.wanted_error());
    // In resonance a spline may still have a law: it distributes the force of the missing harmonic.
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
    // Without a required accuracy the usual one applies.
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

/// Whether only the force is asked for. Only a spline meets demands and other objectives.
fn suits(problem: &Problem) -> bool {
    let law = &problem.law;
    problem.target.is_some()
        && problem.objective() == Minimise::ForceError
        && !(problem.has_demands() || problem.is_weighed() || law.monotone || law.polydyne)
}

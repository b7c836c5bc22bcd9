//! Which family of laws a scene gets that does not insist on one.

use super::{Found, NoLaw, double_harmonic, on_base_circle, spectral, spline};
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use crate::synth::infeasible::explain;
use crate::synth::limits::force_report;
use crate::synth::method::PassedOver;
use crate::synth::reason::quantity;
use crate::synth::{sizing, verify};
use crate::units::Quantity;

/// Finds a law of one family.
type Maker = fn(&Problem) -> Result<Found, NoLaw>;

/// The harmonics in closed form, as the ladder names them.
const INVERSE: &str = "the inverse by harmonics";

/// The first rungs of the ladder as families: harmonics in closed form where every limit and the accuracy
/// hold with them, because then they are the optimum already (theory §1); a spline otherwise. The spline
/// says what the harmonics missed.
pub fn ladder(problem: &Problem) -> Result<Found, NoLaw> {
    let law = &problem.law;
    let weighed = problem.is_weighed();
    let only_splines = weighed
        || law.monotone
        || law.polydyne
        || problem.has_demands()
        || problem.objective() != Minimise::ForceError;
    if problem.target.is_none() || only_splines {
        return spline::found(problem);
    }
    let wanted = problem.wanted_error();
    // A resonance is a reason to climb, not to stop: the spline spreads what one harmonic cannot have.
    let missed = match spectral::inverted(problem, None, wanted) {
        Ok((_, left_over)) if left_over > wanted => PassedOver::Accuracy {
            family: INVERSE,
            excess: Quantity::force(left_over - wanted),
        },
        Ok((found, _)) => match missed_by(problem, &found, INVERSE)? {
            None => return Ok(found),
            Some(miss) => miss,
        },
        Err(fault) => PassedOver::Fault {
            family: INVERSE,
            fault: fault.to_string(),
        },
    };
    let mut found = spline::found(problem)?;
    found.solver.passed_over.push(missed);
    Ok(found)
}

/// The simplest family whose cam passes every check: a double harmonic, a few harmonics, a spline. The
/// families that were passed over say what they missed by.
pub fn simplest(problem: &Problem) -> Result<Found, NoLaw> {
    let mut passed_over = Vec::new();
    // Whether any family passes is seen by the last of them alone.
    if !problem.only_passing
        && problem.target.is_some()
        && !problem.has_demands()
        && problem.objective() == Minimise::ForceError
    {
        let simple: [(Family, Maker); 2] = [
            (Family::DoubleHarmonic, double_harmonic::found),
            (Family::Harmonic, spectral::found),
        ];
        for (family, found) in simple {
            let miss = match found(problem) {
                Err(NoLaw::Fault(_)) => continue,
                Err(NoLaw::Stuck(stuck)) => PassedOver::Limits {
                    family: family.name(),
                    limits: explain(problem, &stuck).conflict,
                },
                Ok(mut found) => match missed_by(problem, &found, family.name())? {
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
    let mut found = spline::found(problem)?;
    found.solver.passed_over = passed_over;
    Ok(found)
}

/// What the cam of a law breaks first; `None` when it passes.
fn missed_by(
    problem: &Problem,
    found: &Found,
    family: &'static str,
) -> Result<Option<PassedOver>, NoLaw> {
    let law = on_base_circle(problem, found.law.clone());
    let cam = sizing::cam(problem, law.clone(), &law)?;
    let force = force_report(problem, &cam.law);
    // A scene that asks for no accuracy still asks for its force.
    let wanted = problem.wanted_error();
    if problem.target.is_some() && problem.accuracy.is_none() && force.rms_error_n > wanted {
        let excess = Quantity::force(force.rms_error_n - wanted);
        return Ok(Some(PassedOver::Accuracy { family, excess }));
    }
    let checks = verify::checks_of_one(problem, &cam, &cam.law, &force);
    let measures = cam.follower.measures();
    let broken = checks.into_iter().find(|c| !c.pass);
    Ok(broken.map(|c| PassedOver::Check {
        family,
        value: quantity(measures, c.name, c.worst),
        limit: quantity(measures, c.name, c.limit),
        check: c.name,
    }))
}

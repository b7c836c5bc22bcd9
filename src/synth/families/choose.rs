//! Which family of laws a scene gets that does not insist on one.

use super::{Found, NoLaw, Stuck, double_harmonic, on_base_circle, spectral, spline};
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use crate::synth::infeasible::{explain, in_units};
use crate::synth::limits::force_report;
use crate::synth::{sizing, verify};

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
        Ok((_, left_over)) if left_over > wanted => {
            format!("the accuracy by {:.4} N", left_over - wanted)
        }
        Ok((found, _)) => match missed_by(problem, &found)? {
            None => return Ok(found),
            Some(miss) => miss,
        },
        Err(fault) => fault.to_string(),
    };
    let mut found = spline::found(problem)?;
    let passed_over = format!("; the inverse by harmonics misses {missed}");
    found.solver.status.push_str(&passed_over);
    Ok(found)
}

/// The simplest family whose cam passes every check: a double harmonic, a few harmonics, a spline. The
/// families that were passed over say what they missed by.
pub fn simplest(problem: &Problem) -> Result<Found, NoLaw> {
    let mut passed_over = String::new();
    if problem.target.is_some()
        && !problem.has_demands()
        && problem.objective() == Minimise::ForceError
    {
        let simple: [(Family, fn(&Problem) -> Result<Found, NoLaw>); 2] = [
            (Family::DoubleHarmonic, double_harmonic::found),
            (Family::Harmonic, spectral::found),
        ];
        for (family, found) in simple {
            let miss = match found(problem) {
                Err(NoLaw::Fault(_)) => continue,
                Err(NoLaw::Stuck(stuck)) => conflict(problem, &stuck),
                Ok(mut found) => match missed_by(problem, &found)? {
                    Some(miss) => miss,
                    None => {
                        found.solver.status.push_str(&passed_over);
                        return Ok(found);
                    }
                },
            };
            passed_over.push_str(&format!("; {} misses {miss}", family.name()));
        }
    }
    let mut found = spline::found(problem)?;
    found.solver.status.push_str(&passed_over);
    Ok(found)
}

fn conflict(problem: &Problem, stuck: &Stuck) -> String {
    explain(problem, stuck).conflict.join(", ")
}

/// What the cam of a law breaks first, in words; `None` when it passes.
fn missed_by(problem: &Problem, found: &Found) -> Result<Option<String>, NoLaw> {
    let law = on_base_circle(problem, found.law.clone());
    let cam = sizing::cam(problem, law.clone(), &law)?;
    let force = force_report(problem, &cam.law);
    // A scene that asks for no accuracy still asks for its force.
    let wanted = problem.wanted_error();
    if problem.target.is_some() && problem.accuracy.is_none() && force.rms_error_n > wanted {
        let over = force.rms_error_n - wanted;
        return Ok(Some(format!("the accuracy by {over:.4} N")));
    }
    let checks = verify::checks(problem, &cam, &cam.law, &force);
    let broken = checks.iter().find(|c| !c.pass);
    let measures = cam.follower.measures();
    Ok(broken.map(|c| {
        format!(
            "{} ({} against {})",
            c.name,
            in_units(measures, &c.name, c.worst),
            in_units(measures, &c.name, c.limit)
        )
    }))
}

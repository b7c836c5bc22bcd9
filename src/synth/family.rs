//! Which family of laws a scene gets that does not insist on one.

use super::demand::Demand;
use super::{
    Found, design, from_double_harmonic, from_harmonics, from_spline, in_units, inverted, machine,
    on_base_circle, spline, verify,
};
use crate::error::Result;
use crate::scene::{Minimise, Scene};

/// The first rungs of the ladder as families: harmonics in closed form where every limit and the accuracy
/// hold with them, because then they are the optimum already (theory §1); a spline otherwise. The spline
/// says what the harmonics missed.
pub fn ladder(scene: &Scene, demand: &Demand) -> Result<Found> {
    let law = &scene.law;
    let weighed = scene.gait.as_ref().is_some_and(|g| !g.weights.is_empty());
    let only_splines = weighed
        || law.monotone
        || law.polydyne
        || !(law.points.is_empty() && law.dwells.is_empty())
        || spline::objective(scene) != Minimise::ForceError;
    let Some(target) = demand.target.as_ref().filter(|_| !only_splines) else {
        return from_spline(scene, demand);
    };
    let wanted = spline::accuracy(scene, target);
    // A resonance is a reason to climb, not to stop: the spline spreads what one harmonic cannot have.
    let missed = match inverted(demand, None, wanted) {
        Ok((_, left_over)) if left_over > wanted => {
            format!("the accuracy by {:.4} N", left_over - wanted)
        }
        Ok((found, _)) => match missed_by(scene, demand, &found)? {
            None => return Ok(found),
            Some(miss) => miss,
        },
        Err(fault) => fault.to_string(),
    };
    let mut found = from_spline(scene, demand)?;
    let passed_over = format!("; the inverse by harmonics misses {missed}");
    found.solver.status.push_str(&passed_over);
    Ok(found)
}

/// The simplest family whose cam passes every check: a double harmonic, a few harmonics, a spline. The
/// families that were passed over say what they missed by.
pub fn simplest(scene: &Scene, demand: &Demand) -> Result<Found> {
    let free_of_demands = scene.law.points.is_empty() && scene.law.dwells.is_empty();
    let mut passed_over = String::new();
    if demand.target.is_some()
        && free_of_demands
        && spline::objective(scene) == Minimise::ForceError
    {
        for family in [from_double_harmonic, from_harmonics] {
            let Ok(mut found) = family(scene, demand) else {
                continue;
            };
            match missed_by(scene, demand, &found)? {
                None => {
                    found.solver.status.push_str(&passed_over);
                    return Ok(found);
                }
                Some(miss) => {
                    passed_over.push_str(&format!("; {} misses {miss}", found.family.name()));
                }
            }
        }
    }
    let mut found = from_spline(scene, demand)?;
    found.solver.status.push_str(&passed_over);
    Ok(found)
}

/// What the cam of a law breaks first, in words; `None` when it passes.
fn missed_by(scene: &Scene, demand: &Demand, found: &Found) -> Result<Option<String>> {
    if let Some(infeasible) = &found.infeasible {
        return Ok(Some(infeasible.conflict.join(", ")));
    }
    let law = on_base_circle(scene, demand, found.law.clone());
    let cam = design::cam(scene, demand, law.clone(), &law)?;
    let force = verify::law_force(demand, &cam.law);
    let mut checks = verify::checks(scene, demand, &cam, &cam.law, &force);
    checks.extend(machine::checks(scene, demand, &cam, &cam.law));
    // A scene that asks for no accuracy still asks for its force.
    if let Some(target) = &demand.target {
        let wanted = spline::accuracy(scene, target);
        if scene.rms.is_none() && force.rms_error_n > wanted {
            let over = force.rms_error_n - wanted;
            return Ok(Some(format!("the accuracy by {over:.4} N")));
        }
    }
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

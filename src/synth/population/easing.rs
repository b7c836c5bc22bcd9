//! Gain for all walkers from relaxing a limit of the scene. This gain is computed from the gain for the mean curve with the reference
//! machine.

use super::limits::for_all;
use crate::criterion::{Criterion, DependsOn};
use crate::problem::{Problem, Served, Walkers};
use crate::scene::Robust;
use crate::synth::optimum::easing::RELAXED;
use crate::synth::report::limited::{Easing, Minimised};

/// Gain for all walkers from relaxing a limit. `square` is the mean square error of all walkers. `None` if the objective is not the mean
/// error, because the weights of the walkers then change. The result is also `None` if the relaxation would reduce the error of the mean
/// curve to zero.
pub fn of_all(
    easing: &Easing,
    problem: &Problem,
    walkers: &Walkers,
    square: f64,
    loads: f64,
) -> Option<Easing> {
    if walkers.robust != Robust::Mean || walkers.adjust.phase || easing.after <= 0.0 {
        return None;
    }
    let (mut from, mut to, mut scale) = (easing.from, easing.to, 1.0);
    if let Criterion::Limit(kind) = easing.limit
        && let Some(own) = problem.limits[kind]
    {
        if own == 0.0 {
            return None;
        }
        let eased = own + (easing.to - easing.from).signum() * RELAXED * own.abs();
        if kind.facts().depends_on == DependsOn::Force {
            let mut wider = problem.limits.clone();
            wider[kind] = Some(eased);
            let of = |problem: &Problem| for_all(problem, walkers, loads).limits[kind];
            let reached = of(&problem.with_limits(wider))? - of(problem)?;
            scale = reached / (easing.to - easing.from);
        }
        (from, to) = (own, eased);
    }
    let (before, after) = match easing.objective {
        Minimised::RmsError => {
            // The mean square error of the walkers equals the mean square error of the mean curve times this factor, plus a constant.
            let part = |w: &Served| w.share * (w.factor / w.unit).powi(2);
            let factor: f64 = walkers.each.iter().map(part).sum();
            let gain = factor * scale * (easing.before.powi(2) - easing.after.powi(2));
            let mean = problem.target_mean();
            let root = |square: f64| mean * square.max(0.0).sqrt();
            (root(square), root(square - gain))
        }
        _ => (
            easing.before,
            easing.before - scale * (easing.before - easing.after),
        ),
    };
    Some(Easing {
        from,
        to,
        before,
        after,
        ..easing.clone()
    })
}

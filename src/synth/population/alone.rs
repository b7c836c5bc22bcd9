//! Forces of the individual cams, each designed for one walker.

use super::errors::{Aim, Nodes};
use super::{gap, limits, phase, weighed};
use crate::error::Result;
use crate::problem::{Problem, Walkers};
use crate::synth::families;
use crate::synth::report::solver::Tier;
use crate::synth::search::Search;

/// Force of the cam designed for one walker alone, with its error bounds. The force is a vector of values at quadrature nodes.
pub struct Point {
    /// Force at the quadrature nodes, N, multiplied by the square roots of the weights.
    pub at: Vec<f64>,
    /// Upper bound of the RMS difference between this force and the force of the optimum, N.
    pub slack: f64,
    /// Factor γ of the walker, 1/N.
    pub scale: f64,
    /// Minimum mean square error of the walker, in the square of the walker's unit.
    pub least: f64,
}

/// Force of the individual cam for each cycle. If the phases are adjustable, the amplitudes of the target's harmonics replace this force.
/// The list is empty if the limits are infeasible for a walker, or if the feasible laws do not form a convex set.
pub fn points(problem: &Problem, search: &Search) -> Result<Vec<Point>> {
    let Some(walkers) = problem.walkers.as_deref() else {
        return Ok(Vec::new());
    };
    if walkers.adjust.phase || problem.phase_is_free {
        let of = |aim: Aim| Point {
            at: aim.towards.iter().map(|y| y / aim.scale).collect(),
            slack: 0.0,
            scale: aim.scale,
            least: 0.0,
        };
        return Ok(phase::amplitudes_of(walkers).into_iter().map(of).collect());
    }
    let mut out = Vec::new();
    for walker in &walkers.each {
        let alone = Walkers {
            each: vec![walker.clone()],
            ..walkers.clone()
        };
        let limited = limits::for_all(&problem.of_mean(), &alone, 1.0);
        // The load limits of the reference machine do not apply to the machine of this walker, so they are removed.
        let mut left = limited.limits.clone();
        limits::loads().for_each(|kind| left[kind] = None);
        let limited = limited.with_limits(left);
        let own = families::law(&weighed(&limited, &alone, &[1.0]), search);
        let Some(law) = own
            .ok()
            .and_then(std::result::Result::ok)
            .filter(|law| law.solver.tier != Tier::Scp)
        else {
            return Ok(Vec::new());
        };
        let nodes = Nodes::of(&law.law);
        let (aim, at) = (nodes.aim(walker), nodes.force(&problem.drive, &law.law));
        let gap = 2.0 * gap(&law);
        let least = (aim.square(&at) - aim.scale.powi(2) * gap).max(0.0);
        out.push(Point {
            at,
            slack: gap.sqrt(),
            scale: aim.scale,
            least,
        });
    }
    Ok(out)
}

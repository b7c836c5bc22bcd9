//! Non-convex limits of a law, by a sequence of convex programs with feasible iterates. Examples of such limits are the curvature of a roller
//! cam, and curvature and pressure angle of followers on an arm.
//!
//! Let X = D + s, Y = v − e, w = X² + Y² and ρ = ρ_cam,min + R_f. The radius of curvature of the pitch curve is nowhere below ρ if h =
//! w^{3/2}/ρ − (w + vY − aX) ≥ 0 (theory §6). This limit is not convex. It is linearised about the last law at the points where h is near
//! zero, and the convex program is solved again. If the complete step violates the limit, the limit is linearised again at the end of the
//! step (second-order correction). If this fails, the step is shortened until h ≥ 0 over the whole turn. Convex limits are satisfied along
//! the whole step.
//!
//! The first steps use the restriction a ≥ X − X²/ρ with X² ≥ 2X₀X − X₀². This restriction is sufficient for X ≥ 4ρ/3 and e = 0, and needs no
//! linearisation of h. For followers on an arm, h is a different function. Concave parts of the profile need no row. Their radius of
//! curvature is the sum of the radii of pitch curve and roller, so the roller always fits.

mod at_size;
mod last;
mod linearised;
mod start;
mod steps;
#[cfg(test)]
mod tests;
mod trial;

pub use at_size::AtSize;
pub use start::of_least_size;

use last::{held, resolved};
use linearised::least_of;
use steps::descended;

use crate::synth::limits::{ENLARGED, NonconvexLimits};
use crate::synth::qp::{Program, Solution, TOLERANCE};
use crate::synth::report::method::Ended;
use crate::synth::report::solver::Step;

/// Relative tolerance of the limits between steps. The final law is solved up to rounding errors.
const STEP_TOLERANCE: f64 = 0.25 * ENLARGED;

/// Sequence of convex programs. It begins at the best feasible point that is reached from the `starts`. It ends when no step improves the
/// objective, or when `enough` returns `true` for the law. The starts satisfy the convex limits, except limits on the size. If the size is a
/// variable of the program, the size in `limits` is ignored.
///
/// Returns the last solution with its size, the steps, and the reason for the end; `None` if no feasible start was found.
pub fn refine(
    program: &Program,
    starts: &[Solution],
    limits: NonconvexLimits,
    enough: impl Fn(&Solution) -> bool,
) -> Option<(Solution, Vec<Step>, Ended)> {
    // Between the steps, a coarse tolerance is sufficient, because the next step changes the law by more than this tolerance.
    let mut program = program.clone();
    program.settings.tolerance = STEP_TOLERANCE;
    let program = &program;
    let at_size = AtSize::new(limits, program);
    let start = start::best(program, starts, &at_size)?;
    let (mut current, steps, ended) = descended(program, start, &at_size, enough);
    // If no step was made and the start satisfies the convex limits up to rounding errors, no final program is necessary.
    let as_it_came = steps.is_empty() && current.violation <= TOLERANCE;
    let exact =
        || held(program, &current, &at_size).or_else(|| resolved(program, &current, &at_size));
    if let Some(exact) = (!as_it_came).then(exact).flatten() {
        let active = current.active;
        current = Solution {
            active,
            iterations: current.iterations + exact.iterations,
            ..exact
        };
    }
    Some((current, steps, ended))
}

/// Whether a solution satisfies the non-convex limits for its size of the cam.
pub fn keeps(program: &Program, solution: &Solution, limits: &NonconvexLimits) -> bool {
    let at_size = AtSize::new(limits.clone(), program);
    least_of(&at_size.clear(program, solution)) >= 0.0
}

/// Solution that also satisfies the non-convex limits, computed from a solution of the program; `None` if the search fails.
pub fn feasible(program: &Program, start: &Solution, limits: NonconvexLimits) -> Option<Solution> {
    let mut program = program.clone();
    program.settings.tolerance = STEP_TOLERANCE;
    let program = &program;
    let at_size = AtSize::new(limits, program);
    start::feasible(program, start, &at_size).or_else(|| start::tightened(program, start, &at_size))
}

//! What relaxing each active limit would buy, in the quantity that a scene minimises.

use super::design::{Easing, Minimised};
use super::qp::{EXTRAS, OFFSET, PEAK, Program, RADIUS, RISE, Solution, sensitivities};
use crate::scene::Minimise;

/// What easing each active limit by 1 % would do to the objective, to first order; the limits that are
/// numbers of the scene, largest gain first.
pub fn easings(program: &Program, solution: &Solution, minimised: Minimise) -> Vec<Easing> {
    // A size that is given becomes no smaller, whatever a limit allows.
    if minimised == Minimise::Size && (1..EXTRAS).all(|k| program.cost[k] == 0.0) {
        return Vec::new();
    }
    sensitivities(program, solution)
        .into_iter()
        .map(|s| {
            let (objective, before, after) = measured(program, solution, minimised, s.gain);
            Easing {
                limit: s.limit,
                from: s.from,
                to: s.to,
                objective,
                before,
                after,
            }
        })
        .collect()
}

/// A gain of the objective as the quantity that is minimised: name, before, after.
fn measured(
    program: &Program,
    solution: &Solution,
    minimised: Minimise,
    gain: f64,
) -> (Minimised, f64, f64) {
    let root = |name: Minimised, before: f64| {
        let after = (before * before - 2.0 * gain).max(0.0).sqrt();
        (name, before, after)
    };
    let mean_square = 2.0 * (program.objective(&solution.x) + program.constant);
    match minimised {
        Minimise::ForceError => root(Minimised::RmsError, mean_square.max(0.0).sqrt()),
        Minimise::Energy(order) => {
            root(Minimised::RmsDerivative(order), mean_square.max(0.0).sqrt())
        }
        Minimise::Peak(order) => {
            let peak = solution.extra[PEAK];
            (Minimised::PeakDerivative(order), peak, peak - gain)
        }
        Minimise::PeakForceError => {
            let peak = solution.extra[PEAK];
            (Minimised::MaxError, peak, peak - gain)
        }
        Minimise::Weighed(_) => {
            let sizes: f64 = (1..EXTRAS)
                .map(|k| program.cost[k] * solution.extra[k])
                .sum();
            let before = 0.5 * mean_square + sizes;
            (Minimised::Weighed, before, before - gain)
        }
        Minimise::Size => {
            let radius = if program.cone {
                solution.extra[RADIUS]
            } else if program.cost[RISE] != 0.0 {
                solution.extra[RISE].hypot(solution.extra[OFFSET])
            } else {
                solution.extra[RADIUS]
            };
            (Minimised::Radius, radius, radius - gain)
        }
    }
}

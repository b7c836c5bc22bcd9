//! Gain from relaxing each active limit, expressed in the minimised quantity.

use crate::criterion::Criterion;
use crate::law::Law;
use crate::scene::Minimise;
use crate::synth::qp::{Limit, Meaning, OFFSET, PEAK, Program, RADIUS, RISE, Row, SIZES, Solution};
use crate::synth::report::limited::{Easing, Minimised};

/// Relative change by which a limit is relaxed.
pub const RELAXED: f64 = 0.01;

/// First-order change of the objective if one limit is relaxed by 1 %.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Sensitivity {
    /// Limit, or given value of the scene, that is relaxed.
    limit: Criterion,
    /// Present value of the limit, in SI units.
    from: f64,
    /// Relaxed value of the limit, in SI units.
    to: f64,
    /// Decrease of the objective.
    gain: f64,
}

/// First-order effect of relaxing each active limit of the scene by 1 % on the minimised quantity, in descending order of the gain.
pub fn easings(program: &Program, solution: &Solution, minimised: Minimise) -> Vec<Easing> {
    // A given size does not decrease if a limit is relaxed.
    if minimised == Minimise::Size && SIZES.iter().all(|&k| program.cost[k] == 0.0) {
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

/// Converts a gain of the objective to the minimised quantity, such as an RMS from a mean square. Returns the quantity and its values before
/// and after the change.
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
        Minimise::Size => {
            let radius = if !program.cones.is_empty() {
                solution.extra[RADIUS]
            } else if program.cost[RISE] != 0.0 {
                libm::hypot(solution.extra[RISE], solution.extra[OFFSET])
            } else {
                solution.extra[RADIUS]
            };
            (Minimised::Radius, radius, radius - gain)
        }
    }
}

/// Criterion of the scene value that determines the bound of a limit. It is the limit itself, or the given prime radius.
pub fn key(limit: &Limit) -> Criterion {
    match limit.meaning {
        Meaning::PrimeRadius { .. } => Criterion::GivenPrimeRadius,
        _ => limit.name,
    }
}

/// First-order effect of relaxing each active limit of the scene by 1 % on the objective, in descending order of the gain.
fn sensitivities(program: &Program, solution: &Solution) -> Vec<Sensitivity> {
    let mut out: Vec<Sensitivity> = Vec::new();
    for row in &solution.active {
        for one in of_row(program, solution, row) {
            match out.iter_mut().find(|e| e.limit == one.limit) {
                Some(known) => known.gain += one.gain,
                None => out.push(one),
            }
        }
    }
    out.sort_by(|a, b| b.gain.total_cmp(&a.gain));
    out
}

/// Effect of relaxing a limit on a root mean square. `row` is a tangent of this limit. For other rows, the result is `None`.
fn of_rms(program: &Program, row: &Row) -> Option<Sensitivity> {
    let limit = program.rms.iter().find(|l| l.is_tangent(row))?;
    let from = limit.meaning.value(limit.most)?;
    Some(Sensitivity {
        limit: limit.name,
        from,
        to: (1.0 + RELAXED) * from,
        gain: row.multiplier * RELAXED * from / limit.meaning.slope(limit.most),
    })
}

/// Effects of relaxing the values of the scene on which the bound of one row depends.
fn of_row(program: &Program, solution: &Solution, row: &Row) -> Vec<Sensitivity> {
    let Some(limit) = row.limit.map(|i| &program.limits[i]) else {
        return of_rms(program, row).into_iter().collect();
    };
    let relaxed = RELAXED;
    let mut out = Vec::new();
    if let Some(from) = limit.meaning.value(limit.bound) {
        let slope = limit.meaning.slope(limit.bound);
        let typical = limit.scale * slope;
        let by = relaxed * if from == 0.0 { typical } else { from.abs() };
        let downwards = matches!(limit.meaning, Meaning::Value { factor, .. } if factor < 0.0);
        out.push(Sensitivity {
            limit: key(limit),
            from,
            to: if downwards { from - by } else { from + by },
            gain: row.multiplier * by / slope,
        });
    }
    // v − e ≤ t (s + D): a larger t relaxes the limit in proportion to the height s + D of the roller centre.
    let rise = match limit.meaning {
        Meaning::PressureAngle => Some(solution.extra[RISE]),
        Meaning::PrimeRadius { tan, offset } => Some((limit.bound - offset) / tan),
        _ => None,
    };
    if let Some(rise) = rise {
        let tan = -limit.weights[0];
        let from = libm::atan(tan);
        let height = rise + Law::of(&program.basis, &solution.x).svaj(row.peak.at).s;
        out.push(Sensitivity {
            limit: limit.name,
            from,
            to: (1.0 + relaxed) * from,
            gain: row.multiplier * height * (1.0 + tan * tan) * relaxed * from,
        });
    }
    out
}

//! Vibration that is left over in a dwell.
//!
//! The law without it is looked at first; where it leaves more than allowed, two equalities per motion leave
//! none. Whatever shaped the law, the finished cam is checked.

use std::f64::consts::TAU;

use super::finished::Finished;
use crate::cam::{Check, LimitKind};
use crate::dynamics::flexible::linear::gauss_points;
use crate::dynamics::flexible::polydyne::end_error;
use crate::law::Law;
use crate::poly::Extreme;
use crate::problem::Problem;
use crate::synth::qp::{Basis, Demand, Entries, Equality};
use crate::units::Quantity;

/// A limit counts as kept within this part of it.
const SLACK: f64 = 1e-6;

/// Whether a dwell is left with more vibration than the scene allows. A polydyne follower's end rests where
/// its law does, whatever the natural frequency.
pub fn rings(problem: &Problem, law: &Law) -> bool {
    let silenced = problem.limits[LimitKind::Residual].filter(|_| !problem.law.polydyne);
    silenced.is_some_and(|r| left_over(problem, law).is_some_and(|x| x.value > r * (1.0 + SLACK)))
}

/// The vibration of the finished cam: of a polydyne follower's end, what it misses of its law.
pub fn check(design: &Finished) -> Option<Check> {
    let problem = design.problem;
    let limit = problem.limits[LimitKind::Residual]?;
    let worst = match problem.train() {
        Ok(Some(train)) if problem.law.polydyne => {
            let miss = end_error(&design.cam.law, design.pressing, &problem.drive, &train);
            miss.ok().map(|m| m.lift)
        }
        _ => left_over(problem, &design.cam.law),
    };
    Some(Check::at_most(LimitKind::Residual, worst?, limit, SLACK))
}

/// Motions from the end of one rest to the begin of the next, as angles counted on over the turn.
fn motions(problem: &Problem) -> Vec<(f64, f64)> {
    let rests = problem.rests();
    (0..rests.len())
        .map(|k| {
            let from = rests[k].1;
            match rests.get(k + 1) {
                Some(next) => (from, next.0),
                None => (from, rests[0].0 + TAU),
            }
        })
        .collect()
}

/// Angles with weights for ∫ f(θ) cos and sin of ratio·θ over one motion: Gauss points on parts of at
/// most a radian of phase between the breaks, eight to a part (1e-14 for the degrees used here).
fn quadrature(breaks: &[f64], (from, to): (f64, f64), ratio: f64) -> Vec<(f64, [f64; 2])> {
    let gauss = gauss_points(8);
    let mut cuts: Vec<f64> = breaks
        .iter()
        .flat_map(|b| [*b, b + TAU])
        .filter(|b| *b > from && *b < to)
        .collect();
    cuts.extend([from, to]);
    cuts.sort_by(f64::total_cmp);
    let mut out = Vec::new();
    for pair in cuts.windows(2).filter(|w| w[1] - w[0] > 1e-12) {
        let parts = ((pair[1] - pair[0]) * ratio).ceil().max(1.0) as usize;
        let width = (pair[1] - pair[0]) / parts as f64;
        for p in 0..parts {
            for (x, w) in &gauss {
                let theta = pair[0] + (p as f64 + x) * width;
                let (sin, cos) = (ratio * (theta - to)).sin_cos();
                out.push((theta, [w * width * cos, w * width * sin]));
            }
        }
    }
    out
}

/// Largest amplitude that rings on in a rest, m: the follower, at rest and undamped before each motion,
/// obeys ẍ + ω²x = −s̈, so |(∫a cos, ∫a sin)|/ratio is left. `None` without rests or frequency.
fn left_over(problem: &Problem, law: &Law) -> Option<Extreme> {
    let ratio = problem.frequency_ratio()?;
    motions(problem)
        .into_iter()
        .map(|motion| {
            let mut parts = [0.0; 2];
            for (theta, weights) in quadrature(law.breaks(), motion, ratio) {
                let a = law.svaj(theta).a;
                parts[0] += weights[0] * a;
                parts[1] += weights[1] * a;
            }
            Extreme {
                at: motion.1.rem_euclid(TAU),
                value: parts[0].hypot(parts[1]) / ratio,
            }
        })
        .max_by(|a, b| a.value.total_cmp(&b.value))
}

/// Two equalities per motion that leave no vibration in the rest after it.
pub fn silence(problem: &Problem, basis: &Basis) -> Vec<Equality> {
    let Some(ratio) = problem.frequency_ratio() else {
        return Vec::new();
    };
    let mut out = Vec::new();
    for motion in motions(problem) {
        let points = quadrature(&basis.breaks(), motion, ratio);
        for k in 0..2 {
            let mut dense = vec![0.0; basis.columns()];
            for (theta, weights) in &points {
                for (i, x) in basis.row(*theta, &[0.0, 0.0, 1.0, 0.0]) {
                    dense[i] += weights[k] * x;
                }
            }
            let entries: Entries = dense
                .into_iter()
                .enumerate()
                .filter(|e| e.1 != 0.0)
                .collect();
            out.push(Equality {
                name: Demand::NoVibration {
                    after: Quantity::angle(motion.1),
                },
                entries,
                value: 0.0,
            });
        }
    }
    out
}

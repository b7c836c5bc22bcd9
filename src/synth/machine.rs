//! Limits of the running machine: Hertz pressure, shaft torque, vibration that is left over in a dwell.
//!
//! Pressure under a flat face is linear in law and size: a row from the start. The others join only when the
//! law without them breaks them: torque, its rate and the pressure under a roller in a sequence of convex
//! programs; a dwell's vibration as two equalities, which leave none. Every one is checked on the finished
//! cam whatever shaped it.

use super::answer::Step;
use super::nonconvex::{self, Beyond};
use super::qp::{Basis, Entries, Equality, Limit, Meaning, Program, Solution};
use super::{limits, sequence};
use crate::cam::{Cam, Check, Follower, FollowerKind};
use crate::drive::Drive;
use crate::dynamics::design::hertz_at_most;
use crate::dynamics::hertz::{STEEL, modulus};
use crate::dynamics::linear::gauss_points;
use crate::dynamics::polydyne::end_error;
use crate::dynamics::touch::touch;
use crate::law::Law;
use crate::poly::{Extreme, PiecewisePoly, stand_in};
use crate::problem::Problem;
use std::f64::consts::{PI, TAU};

/// A cam is not made larger for a pressure of whose square the roller alone makes more than this part.
const WORTH_GROWING: f64 = 0.95;
/// A limit counts as kept within this part of it.
const SLACK: f64 = 1e-6;

/// Rows that are linear in the law from the start: steel on steel under a flat face of given base radius.
pub fn rows(problem: &Problem) -> Vec<Limit> {
    let base = problem.base_radius();
    base.and_then(|base| pressed(problem, base))
        .into_iter()
        .collect()
}

/// The pressure limit under a flat face on a base circle, which counts among the variables where it is 0.
pub fn pressed(problem: &Problem, base_radius: f64) -> Option<Limit> {
    let (cam, pressure) = (&problem.cam, problem.limits.hertz_pressure?);
    if cam.follower != FollowerKind::FlatTranslating {
        return None;
    }
    let face = Follower::FlatTranslating { base_radius };
    let steel = modulus(STEEL, STEEL);
    let l = hertz_at_most(&problem.drive, &face, cam.thickness, steel, pressure)?;
    let [s, v, a, j] = l.weights;
    let bound = l.upper - l.constant;
    let scale = bound.abs().max(problem.drive.rest_force.abs());
    let mut row = Limit::new("hertz_pressure", [s, v, a, j, 0.0], bound, scale);
    row.meaning = Meaning::Sized;
    Some(row)
}

/// What a law became that has to hold the limits of the running machine as well.
pub struct Held {
    pub program: Program,
    pub solution: Solution,
    /// The sequence of convex programs, where the loads needed one, and why it ended.
    pub sequence: Option<(Vec<Step>, &'static str)>,
}

/// The law again with the limits that were broken brought in: a dwell's vibration as equalities, loads by a
/// sequence of convex programs. Where no law keeps the loads, the program comes back with them.
pub fn hold(
    problem: &Problem,
    program: Program,
    solution: Solution,
) -> Result<Held, (Program, Beyond)> {
    let mut held = Held {
        program,
        solution,
        sequence: None,
    };
    if rings(problem, &held.program.basis.law(&held.solution.x)) {
        let mut next = held.program.clone();
        next.equalities.extend(silence(problem, &next.basis));
        // Without a solution the check says what is left over.
        if let Ok(solution) = next.solve() {
            (held.program, held.solution) = (next, solution);
        }
    }
    let Some(beyond) = limits::beyond_convex(problem) else {
        return Ok(held);
    };
    let loads = Beyond {
        loads: beyond.loads,
        ..beyond
    };
    if beyond.loads.is_none() || holds(&held, loads) {
        return Ok(held);
    }
    match sequence::refine(&held.program, &held.solution, beyond) {
        Some((solution, steps, ended)) => {
            held.solution = solution;
            held.sequence = Some((steps, ended));
            Ok(held)
        }
        None => Err((held.program, beyond)),
    }
}

/// Whether the loads are kept without having been asked for.
fn holds(held: &Held, beyond: Beyond) -> bool {
    let law = held.program.basis.law(&held.solution.x);
    let present = held.program.present();
    let beyond = sequence::sized(&beyond, &present, beyond.size(), &held.solution.extra);
    nonconvex::loaded(&law, &beyond) >= 0.0
}

/// Whether a dwell is left with more vibration than the scene allows. A polydyne follower's end rests where
/// its law does, whatever the natural frequency.
fn rings(problem: &Problem, law: &Law) -> bool {
    let silenced = problem.limits.residual.filter(|_| !problem.law.polydyne);
    silenced.is_some_and(|r| left_over(problem, law).is_some_and(|x| x.value > r * (1.0 + SLACK)))
}

/// Shaft torque F·v without friction, N·m: the force of the law that presses, the velocity of the cam's.
fn torque_curve(drive: &Drive, pressing: &Law, law: &Law) -> PiecewisePoly {
    let force = drive.force_curve(pressing);
    let velocity = law.combination([0.0, 1.0, 0.0, 0.0], 0.0);
    let force = force.cut_at(velocity.breaks());
    velocity.cut_at(force.breaks()).times(&force)
}

/// Largest absolute value, by roots.
fn largest(curve: &PiecewisePoly) -> Extreme {
    let (low, high) = curve.extremes();
    if high.value >= -low.value {
        return high;
    }
    Extreme {
        at: low.at,
        value: -low.value,
    }
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
fn silence(problem: &Problem, basis: &Basis) -> Vec<Equality> {
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
                name: format!("no vibration after {:.2}°", motion.1.to_degrees()),
                entries,
                value: 0.0,
            });
        }
    }
    out
}

/// Pressure, torque and vibration of the finished cam against the scene's limits.
pub fn checks(problem: &Problem, cam: &Cam, pressing: &Law) -> Vec<Check> {
    let limits = &problem.limits;
    let mut out = Vec::new();
    let torque = || torque_curve(&problem.drive, pressing, &cam.law);
    if let Some(limit) = limits.torque {
        out.push(Check::at_most("torque", largest(&torque()), limit, SLACK));
    }
    if let Some(limit) = limits.torque_rate {
        let worst = largest(&torque().derivative());
        out.push(Check::at_most("torque_rate", worst, limit, SLACK));
    }
    if let Some(limit) = limits.hertz_pressure {
        let worst = pressure(problem, cam, pressing);
        out.push(Check::at_most("hertz_pressure", worst, limit, SLACK));
    }
    let ringing = match problem.train() {
        _ if limits.residual.is_none() => None,
        Ok(Some(train)) if problem.law.polydyne => {
            let miss = end_error(&cam.law, pressing, &problem.drive, &train);
            miss.ok().map(|m| m.lift)
        }
        _ => left_over(problem, &cam.law),
    };
    if let (Some(limit), Some(worst)) = (limits.residual, ringing) {
        out.push(Check::at_most("residual", worst, limit, SLACK));
    }
    out
}

/// Smallest base radius under a flat face on which the pressure limit holds: the largest of F E*/(π L p²) − s − a.
pub fn smallest_base_radius(problem: &Problem, law: &Law, pressing: &Law) -> f64 {
    let Some(limit) = pressed(problem, 0.0) else {
        return 0.0;
    };
    let per_radius = problem.drive.weights()[2] - limit.weights[2];
    let force = problem.drive.force_curve(pressing);
    let bend = law.combination([1.0, 0.0, 1.0, 0.0], 0.0);
    let bend = bend.cut_at(force.breaks());
    let force = force.cut_at(bend.breaks());
    PiecewisePoly::combine(&[(1.0 / per_radius, &force), (-1.0, &bend)], 0.0)
        .extremes()
        .1
        .value
}

/// The pressure limit, where a roller cam that is large enough keeps it: the roller itself is curved, and
/// that presses on any cam.
pub fn bearable_on_some_size(problem: &Problem, pressing: &Law) -> Option<f64> {
    let (most, roller) = (problem.limits.hertz_pressure?, problem.cam.roller_radius);
    let force = problem.drive.force_curve(pressing).extremes().1.value;
    let least = force * modulus(STEEL, STEEL) / (PI * problem.cam.thickness * roller);
    (roller > 0.0 && least < WORTH_GROWING * most * most).then_some(most)
}

/// Highest line pressure, Pa, steel on steel over the plate's thickness: p₀² = N κ E*/(π L).
pub fn pressure(problem: &Problem, cam: &Cam, pressing: &Law) -> Extreme {
    let start = cam.law.extent().0;
    if !cam.follower.is_flat() && cam.follower.roller_radius() == 0.0 {
        // A knife edge presses on a line without width.
        return Extreme {
            at: start,
            value: f64::INFINITY,
        };
    }
    let factor = modulus(STEEL, STEEL) / (PI * problem.cam.thickness);
    let breaks = cam.law.breaks();
    let square = stand_in(breaks, 1e-12, |i, x| {
        let u = (x - breaks[i]) / (breaks[i + 1] - breaks[i]);
        let at = cam.law.svaj_on(i, u);
        let force = problem.drive.force(pressing.svaj_on(i, u));
        let here = touch(&cam.follower, problem.drive.speed, 0.0, at, force);
        factor * here.normal * here.curvature
    })
    .extremes()
    .1;
    Extreme {
        at: square.at,
        value: square.value.max(0.0).sqrt(),
    }
}

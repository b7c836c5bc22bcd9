//! Limits of the running machine: Hertz pressure, shaft torque, vibration that is left over in a dwell.
//!
//! What is linear in the law is a row from the start (pressure under a flat face of given size). The
//! others join only when the law without them breaks them: torque F·v with the force of the law before,
//! |v| ≤ T/|F(θ)|, in a short sequence; a dwell's vibration as two equalities, which leave none. Every
//! one is checked on the finished cam whatever shaped it.

use super::basis::{Basis, Entries};
use super::demand::Demand;
use super::problem::{Equality, Limit, Meaning, Program, Solution};
use crate::cam::{Cam, Check, Follower};
use crate::drive::Drive;
use crate::dynamics::design::hertz_at_most;
use crate::dynamics::hertz::{STEEL, modulus};
use crate::dynamics::linear::gauss_points;
use crate::dynamics::polydyne::end_error;
use crate::dynamics::touch::touch;
use crate::law::Law;
use crate::poly::{Extreme, PiecewisePoly, stand_in};
use crate::scene::Scene;
use std::f64::consts::{PI, TAU};

/// Programs in sequence for a torque limit; the force hardly changes after the second.
const ROUNDS: usize = 8;
/// A limit counts as kept within this part of it.
const SLACK: f64 = 1e-6;
/// The next program aims below the torque limit by this part, so that the sequence ends below it.
const AIM: f64 = 1e-4;
/// The sequence goes on until the torque is this near its limit.
const NEAR: f64 = 5e-4;
/// Forces below this part of the largest allow any velocity.
const SMALL: f64 = 0.01;

/// Rows that are linear in the law from the start: steel on steel under a flat face of given base radius.
pub fn rows(scene: &Scene, demand: &Demand) -> Vec<Limit> {
    let (cam, limits) = (&scene.cam, &scene.limits);
    let (Some(pressure), Some(base_radius)) = (limits.hertz_pressure, cam.base_radius) else {
        return Vec::new();
    };
    if cam.follower != "flat-translating" {
        return Vec::new();
    }
    let face = Follower::FlatTranslating { base_radius };
    let steel = modulus(STEEL, STEEL);
    hertz_at_most(&demand.drive, &face, cam.thickness, steel, pressure)
        .map(|l| {
            let [s, v, a, j] = l.weights;
            let bound = l.upper - l.constant;
            let mut row = Limit::new("hertz_pressure", [s, v, a, j, 0.0], bound, bound.abs());
            row.meaning = Meaning::Sized;
            row
        })
        .into_iter()
        .collect()
}

/// The law again with the limits that were broken brought in, until none is; the last one that could be
/// solved where no law keeps them (the checks then say so).
pub fn hold(
    scene: &Scene,
    demand: &Demand,
    program: Program,
    solution: Solution,
) -> (Program, Solution) {
    let first = program.clone();
    let mut last = (program, solution);
    let mut kept = None;
    let (mut quiet, mut braked) = (false, false);
    for _ in 0..ROUNDS {
        let law = first.basis.law(&last.1.x);
        let peak = largest(&torque_curve(&demand.drive, &law, &law)).value;
        let above = |limit: f64| scene.limits.torque.is_some_and(|t| peak > t * limit);
        // A polydyne follower's end rests where its law does, whatever the natural frequency.
        let silenced = scene.limits.residual.filter(|_| !scene.law.polydyne);
        let rings = silenced.is_some_and(|r| {
            left_over(scene, demand, &law).is_some_and(|x| x.value > r * (1.0 + SLACK))
        });
        let strained = above(1.0 + SLACK);
        if !strained && !rings {
            // Braked by the force of the law before, it may stay below what is allowed.
            let done = !braked || above(1.0 - NEAR);
            kept = Some(last.clone());
            if done {
                break;
            }
        }
        quiet |= rings;
        braked |= strained;
        let mut next = first.clone();
        if let (Some(t), true) = (scene.limits.torque, braked) {
            hold_torque(&mut next, &demand.drive, &law, t * (1.0 - AIM));
        }
        if quiet {
            next.equalities.extend(silence(scene, demand, &next.basis));
        }
        let Ok(solution) = next.solve() else { break };
        last = (next, solution);
    }
    kept.unwrap_or(last)
}

/// |v| ≤ T/|F(θ)| with the force of the law before.
fn hold_torque(program: &mut Program, drive: &Drive, law: &Law, torque: f64) {
    let force = drive.force_curve(law);
    let (low, high) = force.extremes();
    let most = high.value.max(-low.value);
    // The shape is smooth but where a small force is lifted to the floor.
    let room = stand_in(force.breaks(), 1e-9, |_, x| {
        let f = force.eval(x) / most;
        torque / most / (f * f + SMALL * SMALL).sqrt()
    });
    let shape = program.shapes.len();
    program.shapes.push(room);
    for sign in [1.0, -1.0] {
        let mut row = Limit::new("torque", [0.0, sign, 0.0, 0.0, 0.0], 0.0, torque / most);
        row.shape = Some(shape);
        row.meaning = Meaning::Sized;
        program.limits.push(row);
    }
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

/// The rests of a law in order: dwells asked for, or a programme's.
fn rests(scene: &Scene) -> Vec<(f64, f64)> {
    let mut all: Vec<(f64, f64)> = scene.law.dwells.iter().map(|d| (d.from, d.to)).collect();
    let mut at = 0.0;
    for segment in &scene.law.segments {
        if segment.motion == "dwell" {
            all.push((at, at + segment.angle));
        }
        at += segment.angle;
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all
}

/// Motions from the end of one rest to the begin of the next, as angles counted on over the turn.
fn motions(scene: &Scene) -> Vec<(f64, f64)> {
    let rests = rests(scene);
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

/// Natural frequency over shaft speed, where the scene knows it.
fn ratio(scene: &Scene, demand: &Demand) -> Option<f64> {
    scene
        .machine
        .natural_frequency
        .map(|hz| TAU * hz / demand.drive.speed)
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
fn left_over(scene: &Scene, demand: &Demand, law: &Law) -> Option<Extreme> {
    let ratio = ratio(scene, demand)?;
    motions(scene)
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
fn silence(scene: &Scene, demand: &Demand, basis: &Basis) -> Vec<Equality> {
    let Some(ratio) = ratio(scene, demand) else {
        return Vec::new();
    };
    let mut out = Vec::new();
    for motion in motions(scene) {
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
pub fn checks(scene: &Scene, demand: &Demand, cam: &Cam, pressing: &Law) -> Vec<Check> {
    let limits = &scene.limits;
    let mut out = Vec::new();
    let torque = || torque_curve(&demand.drive, pressing, &cam.law);
    if let Some(limit) = limits.torque {
        out.push(Check::at_most("torque", largest(&torque()), limit, SLACK));
    }
    if let Some(limit) = limits.torque_rate {
        let worst = largest(&torque().derivative());
        out.push(Check::at_most("torque_rate", worst, limit, SLACK));
    }
    if let Some(limit) = limits.hertz_pressure {
        let worst = pressure(scene, demand, cam, pressing);
        out.push(Check::at_most("hertz_pressure", worst, limit, SLACK));
    }
    let ringing = match scene.machine.train(&demand.drive) {
        _ if limits.residual.is_none() => None,
        Ok(Some(train)) if scene.law.polydyne => {
            let miss = end_error(&cam.law, pressing, &demand.drive, &train);
            miss.ok().map(|m| m.lift)
        }
        _ => left_over(scene, demand, &cam.law),
    };
    if let (Some(limit), Some(worst)) = (limits.residual, ringing) {
        out.push(Check::at_most("residual", worst, limit, SLACK));
    }
    out
}

/// Highest line pressure, Pa, steel on steel over the plate's thickness: p₀² = N κ E*/(π L).
fn pressure(scene: &Scene, demand: &Demand, cam: &Cam, pressing: &Law) -> Extreme {
    let start = cam.law.extent().0;
    if !cam.follower.is_flat() && cam.follower.roller_radius() == 0.0 {
        // A knife edge presses on a line without width.
        return Extreme {
            at: start,
            value: f64::INFINITY,
        };
    }
    let factor = modulus(STEEL, STEEL) / (PI * scene.cam.thickness);
    let breaks = cam.law.breaks();
    let square = stand_in(breaks, 1e-12, |i, x| {
        let u = (x - breaks[i]) / (breaks[i + 1] - breaks[i]);
        let at = cam.law.svaj_on(i, u);
        let force = demand.drive.force(pressing.svaj_on(i, u));
        let here = touch(&cam.follower, demand.drive.speed, 0.0, at, force);
        factor * here.normal * here.curvature
    })
    .extremes()
    .1;
    Extreme {
        at: square.at,
        value: square.value.max(0.0).sqrt(),
    }
}

//! Limits that hold for every walker: as one set of limits at the reference machine, and checked at the machine of each.

use crate::cam::{Check, Criterion, LimitKind};
use crate::error::Result;
use crate::law::Law;
use crate::problem::{Problem, Served, Walkers};
use crate::synth::sizing::checked_cam::{CheckedCam, checked_cam};

/// Limits that no factor carries from one machine to another.
pub const LOADS: [LimitKind; 4] = [
    LimitKind::Torque,
    LimitKind::Power,
    LimitKind::TorqueRate,
    LimitKind::HertzPressure,
];

/// The problem at its reference machine whose limits on motion and force are those of the walker who needs most; `loads` is the
/// part of the limits on loads that the reference machine may use.
pub fn for_all(problem: &Problem, walkers: &Walkers, loads: f64) -> Problem {
    let mut out = problem.clone();
    let (drive, limits) = (problem.drive, &mut out.limits);
    let fastest = walkers
        .each
        .iter()
        .fold(0.0_f64, |m, w| m.max(w.drive.speed));
    let timed = [
        LimitKind::Velocity,
        LimitKind::Acceleration,
        LimitKind::Jerk,
    ];
    for (kind, order) in timed.into_iter().zip(1..) {
        let factor = (drive.speed / fastest).powi(order);
        limits[kind] = limits[kind].map(|bound| factor * bound);
    }
    let reached = |bound: f64, better: fn(f64, f64) -> f64, start: f64| {
        let of = |w: &Served| (bound - w.drive.rest_force) / w.factor;
        drive.rest_force + walkers.each.iter().map(of).fold(start, better)
    };
    let kind = LimitKind::ForceMin;
    limits[kind] = limits[kind].map(|low| reached(low, f64::max, f64::NEG_INFINITY));
    let kind = LimitKind::ForceMax;
    limits[kind] = limits[kind].map(|high| reached(high, f64::min, f64::INFINITY));
    for kind in LOADS {
        limits[kind] = limits[kind].map(|bound| loads * bound);
    }
    out
}

/// A law on its cam, every limit checked at the machine of the walker for whom it is nearest to its bound.
pub fn checked(problem: &Problem, walkers: &Walkers, law: &Law) -> Result<CheckedCam> {
    let mut out = checked_cam(problem, law, None)?;
    for walker in extremes(walkers) {
        let mut own = problem.clone();
        own.required.drive = walker.drive;
        let of_walker = checked_cam(&own, law, None)?;
        for (worst, check) in out.checks.iter_mut().zip(of_walker.checks) {
            if worst.name == check.name && is_nearer(&check, worst) {
                *worst = check;
            }
        }
    }
    Ok(out)
}

/// Whether a check leaves less of its limit than another of the same limit.
fn is_nearer(check: &Check, other: &Check) -> bool {
    let is_least = check.name == Criterion::Limit(LimitKind::ForceMin);
    let sign = if is_least { -1.0 } else { 1.0 };
    sign * (check.worst - check.limit) > sign * (other.worst - other.limit)
}

/// Part of the usable limits on loads after checks that fail; `None` where none of them does.
pub fn less_loaded(checks: &[Check]) -> Option<f64> {
    let failing = checks.iter().filter(|c| !c.pass);
    let of_loads = failing.filter(|c| LOADS.iter().any(|k| c.name == Criterion::Limit(*k)));
    let parts = of_loads.map(|c| (c.limit / c.worst).abs());
    parts.reduce(f64::min)
}

/// The walkers one of whom is the worst in every quantity that grows with speed, mass and force: force and torque are linear in
/// (M, M ω²), so that their largest values stand at the corners of the hull of these.
fn extremes(walkers: &Walkers) -> Vec<&Served> {
    const DIRECTIONS: usize = 32;
    let each = &walkers.each;
    let of = |walker: &Served| {
        let speed = walker.drive.speed;
        let mass = if walker.drive.rest_force == 0.0 {
            walker.drive.mass
        } else {
            walker.drive.rest_force
        };
        [
            mass,
            mass * speed * speed,
            mass * speed,
            mass * speed.powi(3),
            speed,
        ]
    };
    let all: Vec<[f64; 5]> = each.iter().map(of).collect();
    let mut places: Vec<usize> = Vec::new();
    for (x, y) in [(0, 1), (2, 3), (4, 0)] {
        let span = |k: usize| {
            let values = all.iter().map(|v| v[k]);
            values.fold(f64::MIN_POSITIVE, |m, v| m.max(v.abs()))
        };
        let (wide, high) = (span(x), span(y));
        for step in 0..DIRECTIONS {
            let (sin, cos) = (std::f64::consts::TAU * step as f64 / DIRECTIONS as f64).sin_cos();
            let along = |v: &[f64; 5]| cos * v[x] / wide + sin * v[y] / high;
            let best = (0..all.len()).max_by(|i, j| along(&all[*i]).total_cmp(&along(&all[*j])));
            places.extend(best);
        }
    }
    places.sort_unstable();
    places.dedup();
    places.into_iter().map(|i| &each[i]).collect()
}

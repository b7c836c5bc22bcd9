//! Random scenes by kind. The limits are random values near those of the law without limits, so that most are active and some are infeasible.

use super::asked::{Asked, Dwell, Follower, Limits, Objective, Point, Range};
use super::machines::{Random, fixed, hydraulic, light, moving};
use super::reference::Reference;
use super::splines::ORDERS;
use super::swing::{Train, swings};
use std::f64::consts::TAU;

/// Kinds of random scenes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Moving axis, force error, limits.
    Moving,
    /// Fixed axis with spring and damping, force error, limits.
    Fixed,
    /// Hydraulic, force error, limits.
    Hydraulic,
    /// Points, minimum jerk or acceleration.
    Points,
    /// Dwells with points or another dwell.
    Dwells,
    /// Flat face on a moving axis with a curvature limit, on a base circle that is given or limited.
    Touching,
    /// Flat face with the minimum size for its curvature limit, or with a limited size.
    FlatSize,
    /// Pressure angle on a given prime circle.
    PressureAngle,
    /// Minimum peak of acceleration, jerk or force error.
    Peaks,
    /// Force error with different weights in ranges of the cycle whose edges are inside spans.
    Ranges,
    /// Limit with many spans for peaks and energies.
    Many = 11,
    /// Any of the other kinds on 4 to 200 spans.
    Long,
    /// Force inside a band around the target.
    Bands,
    /// Vibration of a compliant follower in its dwells, or without dwells.
    Residual,
}

pub const KINDS: [Kind; 14] = [
    Kind::Moving,
    Kind::Fixed,
    Kind::Hydraulic,
    Kind::Points,
    Kind::Dwells,
    Kind::Touching,
    Kind::FlatSize,
    Kind::PressureAngle,
    Kind::Peaks,
    Kind::Ranges,
    Kind::Many,
    Kind::Long,
    Kind::Bands,
    Kind::Residual,
];

/// Requirements of the scene of a kind and seed.
pub fn scene(kind: Kind, seed: usize) -> Asked {
    let mut random = Random::new(kind, seed);
    let r = &mut random;
    match kind {
        Kind::Moving => limited(moving(r), r),
        Kind::Fixed => limited(fixed(r), r),
        Kind::Hydraulic => limited(hydraulic(r), r),
        Kind::Points => {
            let limits = r.chance(0.5);
            let asked = points(r);
            if limits { limited(asked, r) } else { asked }
        }
        Kind::Dwells => {
            let limits = r.chance(0.4);
            let asked = dwells(r);
            if limits { limited(asked, r) } else { asked }
        }
        Kind::Touching => touching(r),
        Kind::FlatSize => flat_size(r),
        Kind::PressureAngle => pressure_angle(r),
        Kind::Peaks => peaks(r),
        Kind::Ranges => ranges(r),
        Kind::Bands => bands(r),
        Kind::Many => many(r),
        Kind::Residual => residual(r),
        Kind::Long => match r.below(8) {
            0 => limited(moving(r), r),
            1 => limited(fixed(r), r),
            2 => limited(hydraulic(r), r),
            3 => limited(points(r), r),
            4 => dwells(r),
            5 => ranges(r),
            6 => pressure_angle(r),
            _ => Asked {
                objective: Objective::Peak(2),
                ..points(r)
            },
        },
    }
}

fn ranges(r: &mut Random) -> Asked {
    let mut asked = match r.below(3) {
        0 => moving(r),
        1 => hydraulic(r),
        _ => fixed(r),
    };
    for _ in 0..1 + r.below(3) {
        let (from, to) = (r.within(0.0, TAU), r.within(0.0, TAU));
        let weight = 10f64.powf(r.within(-1.0, 2.0));
        asked.ranges.push(Range { from, to, weight });
    }
    let limits = r.chance(0.5);
    if limits { limited(asked, r) } else { asked }
}

/// Requirements with a force band. Its half-width is based on the largest error of the closest law.
fn bands(r: &mut Random) -> Asked {
    let mut asked = match r.below(3) {
        0 => moving(r),
        1 => hydraulic(r),
        _ => fixed(r),
    };
    asked.spans = [8, 10, 12, 16, 24, 32, 48, 64][r.below(8)];
    let Some(free) = free(&asked) else {
        return asked;
    };
    let reference = Reference::new(&asked);
    let target = asked.target.as_ref().map(|t| &t.0);
    let misses = reference.scan.iter().map(|place| {
        let at = reference.splines.law(place.span, place.theta, &free.x);
        let [k, c, m] = asked.weights;
        let force = asked.rest + k * at[0] + c * at[1] + m * at[2];
        (force - target.map_or(0.0, |t| t.at(place.theta))).abs()
    });
    let most = misses.fold(0.0, f64::max);
    let limits = r.chance(0.3);
    if limits {
        asked = limited(asked, r);
    }
    asked.band = Some(r.within(0.7, 3.0) * most.max(0.01));
    // No energy sees the level of a lift that a spring makes a force of: the reference's matrix would be singular.
    asked.objective = match r.below(4) {
        0 => Objective::ForceError,
        1 if asked.degree > 3 => Objective::Peak(2),
        _ if asked.weights[0] != 0.0 => Objective::ForceError,
        2 => Objective::Energy(2),
        _ => Objective::Energy(3),
    };
    asked
}

/// Requirements with a vibration limit, which is a fraction of the vibration without the limit.
fn residual(r: &mut Random) -> Asked {
    let mut asked = if r.chance(0.85) { dwells(r) } else { points(r) };
    let (speed, mass) = (asked.speed, 2.0);
    let own = r.within(4.0, 14.0) * speed;
    let stiff = mass * own * own;
    let (spring, damping) = (r.within(0.0, 1.5) * stiff, r.within(0.0, 0.1) * mass * own);
    let spring = r.maybe(0.7, spring).unwrap_or(0.0);
    let damping = r.maybe(0.7, damping).unwrap_or(0.0);
    asked.weights = [spring, damping * speed, mass * speed * speed];
    asked.machine += &format!("spring_rate = \"{spring} N/m\"\ndamping = \"{damping} N s/m\"\n");
    asked.train = Some(Train {
        own,
        ratio: r.within(0.03, 0.13),
        mass,
        most: 1.0,
    });
    let limits = r.chance(0.3);
    if limits {
        asked = limited(asked, r);
    }
    let part = 10f64.powf(r.within(-2.0, 0.05));
    if let (Some(free), Some(mut train)) = (free(&asked), asked.train) {
        let reference = Reference::new(&asked);
        let each = swings(&asked, &reference.splines).into_iter();
        let left = each.map(|swing| reference.amplitude(&swing, &free.x).0);
        train.most = part * left.fold(1e-6, f64::max);
        asked.train = Some(train);
    }
    asked
}

fn many(r: &mut Random) -> Asked {
    let mut asked = if r.chance(0.5) { points(r) } else { dwells(r) };
    asked.spans = [4, 5, 6, 48, 64, 100][r.below(6)];
    asked.degree = asked.degree.max(4);
    if r.chance(0.5) {
        asked.objective = Objective::Peak(2 + r.below(2));
    }
    asked
}

fn points(r: &mut Random) -> Asked {
    let count = 2 + r.below(3);
    let begin = r.within(0.0, 0.5);
    let mut points = Vec::new();
    for k in 0..count {
        let angle = begin + (TAU - 0.6) * (k as f64 + r.within(0.0, 0.6)) / count as f64;
        let lift = if k == 0 || k > 1 && r.chance(0.2) {
            0.0
        } else {
            r.within(0.002, 0.03)
        };
        let level = r.chance(0.4);
        points.push(Point {
            angle,
            lift,
            velocity: level.then_some(0.0),
            acceleration: if level { r.maybe(0.2, 0.0) } else { None },
        });
    }
    Asked { points, ..light(r) }
}

fn dwells(r: &mut Random) -> Asked {
    let turned = if r.chance(0.3) {
        r.within(0.1, 0.6)
    } else {
        0.0
    };
    let place = |x: f64| (x - turned).rem_euclid(TAU);
    let first = Dwell {
        from: place(0.0),
        to: place(r.within(0.7, 1.5)),
        lift: r.maybe(0.7, 0.0),
    };
    let lift = r.within(0.005, 0.03);
    let (from, to) = (r.within(2.6, 3.2), r.within(3.6, 4.6));
    let (mut dwells, mut points) = (vec![first], Vec::new());
    if first.lift.is_none() || r.chance(0.5) {
        dwells.push(Dwell {
            from: place(from),
            to: place(to),
            lift: Some(lift),
        });
        if first.lift.is_none() {
            points.push(Point {
                angle: place(5.2),
                lift: 0.5 * lift,
                velocity: None,
                acceleration: None,
            });
        }
    } else {
        points.push(Point {
            angle: place(from),
            lift,
            velocity: r.maybe(0.5, 0.0),
            acceleration: None,
        });
    }
    Asked {
        dwells,
        points,
        ..light(r)
    }
}

/// Minimum and maximum of s, v, a, j and force of the law without limits.
struct Free {
    ranges: [(f64, f64); ORDERS],
    force: (f64, f64),
    x: Vec<f64>,
}

/// Ranges of the law without limits; `None` if the demands are contradictory. Such a scene has no limits.
fn free(asked: &Asked) -> Option<Free> {
    let mut own = asked.clone();
    own.limits = Limits::default();
    own.objective = match asked.objective {
        Objective::Peak(_) | Objective::Size => Objective::Energy(asked.degree.min(4) - 1),
        Objective::PeakForceError => Objective::ForceError,
        other => other,
    };
    let reference = Reference::new(&own);
    let x = reference.space(None)?.origin;
    let x = x.as_slice().to_vec();
    let (mut ranges, mut force) = ([(f64::MAX, f64::MIN); ORDERS], (f64::MAX, f64::MIN));
    let widen = |range: &mut (f64, f64), value: f64| {
        *range = (range.0.min(value), range.1.max(value));
    };
    for place in &reference.scan {
        let at = reference.splines.law(place.span, place.theta, &x);
        for (range, value) in ranges.iter_mut().zip(at) {
            widen(range, value);
        }
        let [k, c, m] = own.weights;
        widen(&mut force, own.rest + k * at[0] + c * at[1] + m * at[2]);
    }
    Some(Free { ranges, force, x })
}

/// Adds one to three limits.
fn limited(mut asked: Asked, r: &mut Random) -> Asked {
    let Some(free) = free(&asked) else {
        return asked;
    };
    let largest = |order: usize| free.ranges[order].1.max(-free.ranges[order].0);
    let timed = |order: usize| largest(order) * asked.speed.powi(order as i32);
    let stroke = free.ranges[0].1 - free.ranges[0].0;
    let mean = asked.target.as_ref().map_or(0.0, |t| t.0.mean_n());
    let mut limits = asked.limits;
    for _ in 0..1 + r.below(3) {
        let share = r.within(0.75, 1.02);
        match r.below(if asked.target.is_some() { 6 } else { 4 }) {
            0 => limits.acceleration = Some(share * timed(2)),
            1 => limits.jerk = Some(share * timed(3)),
            2 => limits.stroke = Some(share * stroke),
            3 => limits.velocity = Some(r.within(0.9, 1.05) * timed(1)),
            4 => limits.force_min = Some(mean - share * (mean - free.force.0).max(0.01 * mean)),
            _ => limits.force_max = Some(mean + share * (free.force.1 - mean).max(0.01 * mean)),
        }
    }
    asked.limits = limits;
    asked
}

fn touching(r: &mut Random) -> Asked {
    let mut asked = moving(r);
    asked.spans = [8, 10, 12, 16][r.below(4)];
    let Some(free) = free(&asked) else {
        return asked;
    };
    let reference = Reference::new(&asked);
    let lowest = free.ranges[0].0;
    let sharpest = reference.scan.iter().map(|p| {
        let at = reference.splines.law(p.span, p.theta, &free.x);
        at[0] - lowest + at[2]
    });
    let rho = r.within(0.005, 0.03);
    // Smallest base circle for the law as it is: ρ − min (s + a).
    let needed = (rho - sharpest.fold(f64::MAX, f64::min)).max(0.005);
    let base = r.within(0.6, 1.0) * needed;
    asked.limits.curvature = Some(rho);
    if r.chance(0.7) {
        asked.follower = Follower::Flat { base: Some(base) };
    } else {
        asked.limits.prime_radius = Some(base);
    }
    let stroke = free.ranges[0].1 - lowest;
    let share = r.within(0.8, 1.0);
    asked.limits.stroke = r.maybe(0.3, share * stroke);
    asked
}

fn flat_size(r: &mut Random) -> Asked {
    let mut asked = points(r);
    asked.degree = asked.degree.max(4);
    let rho = r.within(0.002, 0.02);
    if r.chance(0.6) {
        asked.objective = Objective::Size;
        asked.limits.curvature = r.maybe(0.7, rho);
        if r.chance(0.5) {
            let curvature = asked.limits.curvature;
            let loose = limited(asked.clone(), r);
            let speed = asked.speed;
            let Some(free) = free(&asked) else {
                return asked;
            };
            let largest = |order: usize| {
                free.ranges[order].1.max(-free.ranges[order].0) * speed.powi(order as i32)
            };
            asked.limits = Limits {
                curvature,
                jerk: loose.limits.jerk.map(|_| r.within(1.0, 2.0) * largest(3)),
                acceleration: Some(r.within(1.0, 2.0) * largest(2)),
                ..Limits::default()
            };
        }
        return asked;
    }
    let Some(free) = free(&asked) else {
        return asked;
    };
    let reference = Reference::new(&asked);
    let sharpest = reference.scan.iter().map(|p| {
        let at = reference.splines.law(p.span, p.theta, &free.x);
        at[0] + at[2]
    });
    let needed = (rho - sharpest.fold(f64::MAX, f64::min)).max(0.005);
    asked.limits.curvature = Some(rho);
    asked.limits.prime_radius = Some(r.within(0.85, 1.0) * needed);
    asked
}

fn pressure_angle(r: &mut Random) -> Asked {
    let mut asked = match r.below(4) {
        0 => hydraulic(r),
        1 => fixed(r),
        _ => points(r),
    };
    if !asked.level_is_known() {
        asked = hydraulic(r);
    }
    let Some(free) = free(&asked) else {
        return asked;
    };
    let prime = r.within(1.0, 3.0) * (free.ranges[0].1 - free.ranges[0].0).max(0.01);
    let offset = if r.chance(0.5) {
        r.within(-0.3, 0.3) * prime
    } else {
        0.0
    };
    let rise = (prime * prime - offset * offset).sqrt();
    let reference = Reference::new(&asked);
    let (mut up, mut down) = (0.05_f64, 0.05_f64);
    for p in &reference.scan {
        let at = reference.splines.law(p.span, p.theta, &free.x);
        let angle = ((at[1] - offset).abs() / (at[0] + rise).max(0.2 * rise)).atan();
        if at[1] >= 0.0 {
            up = up.max(angle);
        }
        if at[1] <= 0.0 {
            down = down.max(angle);
        }
    }
    asked.follower = Follower::Knife { prime, offset };
    let share = r.within(0.8, 1.0);
    // No law has less where the follower turns on the prime circle.
    let turn = 1.01 * (offset.abs() / rise).atan();
    let [up, down] = [up, down].map(|angle| f64::max(share * angle, turn));
    asked.limits.pressure_angle = [r.maybe(0.8, up), r.maybe(0.6, down)];
    asked
}

fn peaks(r: &mut Random) -> Asked {
    if r.chance(0.4) {
        let mut asked = match r.below(3) {
            0 => moving(r),
            1 => hydraulic(r),
            _ => fixed(r),
        };
        asked.spans = [8, 10, 12][r.below(3)];
        asked.objective = Objective::PeakForceError;
        return if r.chance(0.5) {
            limited(asked, r)
        } else {
            asked
        };
    }
    let mut asked = points(r);
    asked.objective = Objective::Peak(if asked.degree > 3 { 2 + r.below(2) } else { 2 });
    if r.chance(0.3) {
        let Some(free) = free(&asked) else {
            return asked;
        };
        asked.limits.stroke = Some(r.within(1.0, 1.2) * (free.ranges[0].1 - free.ranges[0].0));
    }
    asked
}

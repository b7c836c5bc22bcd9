//! Rigid bodies that stay in contact: force, torque and what they ask of parts and motor.
//!
//! F = F₀ + k s + c ω v + m ω² a on the machine's line of motion (theory §1); the camshaft gives
//! T = F·v, plus μ|F|·d against the turning under a flat face (Campillo de Blas 2017, eq. 27).

use super::piecewise_force::combination;
use crate::cam::Follower;
use crate::drive::Drive;
use crate::law::{Law, Svaj};
use crate::poly::{Extreme, PiecewisePoly};

/// Rounds of the searches below; they settle in fewer than ten.
const ROUNDS: usize = 60;

/// What the machine does at one cam angle.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Instant {
    /// Lift, m.
    pub lift: f64,
    /// Force along the follower's motion, N: what a plate or load cell feels.
    pub force: f64,
    /// Torque the shaft must give in the sense of growing θ, N·m.
    pub torque: f64,
    /// Power of the shaft, W.
    pub power: f64,
}

/// Force, torque and power at every angle of a table of the motion; `friction` is μ between cam and flat
/// face, `reach` the height of the contact over the cam's centre at s = 0, m (0 where the follower rolls).
pub fn cycle(motion: &[Svaj], drive: &Drive, friction: f64, reach: f64) -> Vec<Instant> {
    let [k, c, m, _] = drive.weights();
    let rub = friction * drive.speed.signum();
    let instant = |at: &Svaj| {
        let force = drive.rest_force + k * at.s + c * at.v + m * at.a;
        let torque = force * at.v + rub * force.abs() * (reach + at.s);
        Instant {
            lift: at.s,
            force,
            torque,
            power: torque * drive.speed,
        }
    };
    motion.iter().map(instant).collect()
}

/// Height over the centre at which friction acts when s = 0: the base radius under a flat face; a
/// roller's friction is in its bearing and is left out.
pub fn reach(follower: &Follower) -> f64 {
    if let Follower::FlatTranslating { base_radius } = follower {
        *base_radius
    } else {
        0.0
    }
}

/// Torque over the whole law, N·m, as a piecewise polynomial; friction included where the force presses
/// all the way round (with a force that changes sign it is not a polynomial: `None`).
pub fn torque_curve(law: &Law, drive: &Drive, friction: f64, reach: f64) -> Option<PiecewisePoly> {
    let force = drive.force_curve(law);
    let rub = friction * drive.speed.signum();
    if rub != 0.0 && force.extremes().0.value < 0.0 {
        return None;
    }
    let arm = law.combination([rub, 1.0, 0.0, 0.0], rub * reach);
    Some(force.times(&arm))
}

/// Place of the guide's line beside the cam's centre, m, that makes the largest tipping moment |F·(v − x)|
/// of a flat face smallest, with that moment, N·m.
///
/// Each offset's worst angle gives a line in x; the lowest point of their upper envelope is the next
/// offset, until no angle is worse.
pub fn best_guide_offset(law: &Law, drive: &Drive) -> (f64, f64) {
    let force = drive.force_curve(law);
    let moment = force.times(&law.combination([0.0, 1.0, 0.0, 0.0], 0.0));
    // |p − f·x| at the worst angles met so far, each of both signs as (intercept, slope).
    let mut lines: Vec<(f64, f64)> = Vec::new();
    let mut x = 0.0;
    let mut best = (0.0, f64::INFINITY);
    let lifted = PiecewisePoly::combine(&[(0.0, &moment), (1.0, &force)], 0.0);
    for _ in 0..ROUNDS {
        let (low, high) = PiecewisePoly::combine(&[(1.0, &moment), (-x, &lifted)], 0.0).extremes();
        let worst = high.value.max(-low.value);
        if worst < best.1 {
            best = (x, worst);
        }
        for (end, sign) in [(high.at, 1.0), (low.at, -1.0)] {
            lines.push((sign * moment.eval(end), -sign * lifted.eval(end)));
        }
        let Some((next, bound)) = lowest_of_envelope(&lines) else {
            break;
        };
        if best.1 - bound <= 1e-12 * best.1.abs() {
            break;
        }
        x = next;
    }
    best
}

/// Lowest point of max(intercept + slope·x), if the lines enclose one.
fn lowest_of_envelope(lines: &[(f64, f64)]) -> Option<(f64, f64)> {
    let mut best: Option<(f64, f64)> = None;
    for (i, a) in lines.iter().enumerate() {
        for b in &lines[..i] {
            if a.1 * b.1 >= 0.0 {
                continue;
            }
            let x = (a.0 - b.0) / (b.1 - a.1);
            let height = a.0 + a.1 * x;
            if best.is_none_or(|(_, h)| height > h) {
                best = Some((x, height));
            }
        }
    }
    best
}

/// Lowest speed, rad/s, at which the force first falls to zero: there the contact is lost. 0 when the
/// force is below zero at rest already, `None` when no speed lifts the follower off.
///
/// The worst angle at one speed gives, by its own quadratic in ω, a lower speed; from above, each is
/// nearer, and the extremes are exact.
pub fn liftoff_speed(law: &Law, drive: &Drive) -> Option<f64> {
    let springs = combination(law, [drive.spring_rate, 0.0, 0.0], drive.rest_force);
    let (rest, most) = springs.extremes();
    // A lift of zero is known from emitted points to their spline's error only, where the jerk steps into a
    // dwell most of all.
    if rest.value < -1e-7 * most.value.abs() {
        return Some(0.0);
    }
    if drive.mass <= 0.0 && drive.damping <= 0.0 {
        return None;
    }
    // A speed at which inertia (or damping) surely outweighs springs somewhere, if any does.
    let highest = most.value;
    let least_a = combination(law, [0.0, 0.0, 1.0], 0.0).extremes().0;
    let mut speed = if drive.mass > 0.0 && least_a.value < 0.0 {
        let at = law.svaj(least_a.at);
        let pull = (drive.mass * at.a.min(least_a.value)).abs();
        2.0 * (highest.max(0.0) / pull).sqrt() + drive.damping * at.v.abs() / pull
    } else {
        let least_v = law.extremes(1).0;
        if drive.damping <= 0.0 || least_v.value >= 0.0 {
            return None;
        }
        2.0 * highest.max(0.0) / (drive.damping * -least_v.value)
    };
    let sign = if drive.speed < 0.0 { -1.0 } else { 1.0 };
    for _ in 0..ROUNDS {
        let here = Drive {
            speed: sign * speed,
            ..*drive
        };
        let [k, c, m, _] = here.weights();
        let worst = combination(law, [k, c, m], drive.rest_force).extremes().0;
        if worst.value >= 0.0 {
            break;
        }
        let at = one_sided(law, worst, &here);
        let (p, q, r) = (
            drive.mass * at.a,
            sign * drive.damping * at.v,
            drive.rest_force + drive.spring_rate * at.s,
        );
        let next = smallest_positive_root(p, q, r);
        if next.is_none_or(|n| n >= speed * (1.0 - 1e-15)) {
            break;
        }
        speed = next.unwrap_or(speed);
    }
    Some(speed)
}

/// The motion at an extreme, from whichever side of a break gave it.
fn one_sided(law: &Law, extreme: Extreme, drive: &Drive) -> Svaj {
    let right = law.svaj(extreme.at);
    let n = law.breaks().len() - 1;
    let left = law
        .breaks()
        .iter()
        .position(|b| (b - extreme.at).abs() <= 1e-12 * (1.0 + b.abs()))
        .map(|i| law.svaj_on((i + n - 1) % n, 1.0));
    match left {
        Some(left)
            if (drive.force(left) - extreme.value).abs()
                < (drive.force(right) - extreme.value).abs() =>
        {
            left
        }
        _ => right,
    }
}

/// Smallest positive root of p x² + q x + r with r ≥ 0, written without cancellation.
fn smallest_positive_root(p: f64, q: f64, r: f64) -> Option<f64> {
    let discriminant = q * q - 4.0 * p * r;
    if discriminant < 0.0 {
        return None;
    }
    let t = -0.5 * (q + q.signum() * discriminant.sqrt());
    let roots = [t / p, r / t];
    roots
        .into_iter()
        .filter(|x| x.is_finite() && *x > 0.0)
        .min_by(f64::total_cmp)
}

/// Preload, N, with which the spring of rate k just keeps `margin` N of contact all the way round.
pub fn least_preload(law: &Law, drive: &Drive, margin: f64) -> f64 {
    let free = Drive {
        rest_force: 0.0,
        ..*drive
    };
    (margin - free.force_curve(law).extremes().0.value).max(0.0)
}

/// Spring rate, N/m, that with the given rest force just keeps `margin` N of contact; `None` when no
/// spring can (the force is short where the lift is zero).
///
/// k ≥ (margin − F without spring)/s wherever s > 0; the worst angle at one k gives the next, larger k.
pub fn least_spring_rate(law: &Law, drive: &Drive, margin: f64) -> Option<f64> {
    let mut rate = 0.0;
    let mut last = f64::NAN;
    for _ in 0..ROUNDS {
        let worst = Drive {
            spring_rate: rate,
            ..*drive
        }
        .force_curve(law)
        .extremes()
        .0;
        if worst.value >= margin - 1e-12 * (margin.abs() + drive.rest_force.abs()) {
            return Some(rate);
        }
        let lift = law.svaj(worst.at).s;
        let more = (margin - worst.value) / lift;
        if !(lift > 0.0 && more.is_finite()) || rate == last {
            return None;
        }
        last = rate;
        rate += more;
    }
    let worst = Drive {
        spring_rate: rate,
        ..*drive
    }
    .force_curve(law)
    .extremes()
    .0;
    (worst.value >= margin - 1e-9 * (1.0 + margin.abs())).then_some(rate)
}

#[cfg(test)]
#[path = "rigid_tests.rs"]
mod tests;

//! Rigid bodies in contact: force, torque, power, lift-off speed.
//!
//! The force along the line of motion is F = F₀ + k s + c ω v + m ω² a (theory §1). The shaft torque is T = F·v. Under a flat face,
//! friction at the distance d from the cam centre increases the torque by μ|F|·d against the rotation (Campillo de Blas 2017, eq. 27).

pub mod hertz;
pub(crate) mod touch;

use super::surface::NO_PULL;
use crate::cam::Follower;
use crate::drive::Drive;
use crate::law::{Law, Svaj};
use crate::poly::{Extreme, PiecewisePoly};

/// Maximum number of iterations for the lift-off speed. Fewer than ten are needed.
const ROUNDS: usize = 60;
/// Force at rest, relative to the maximum force, below which a negative force counts as zero. Where the lift should be zero, it deviates by
/// the tolerance of the spline or of the solver.
const NO_PULL_AT_REST: f64 = 1e-6;

/// Height above the cam centre, m, at which friction acts at s = 0: the base radius for a translating flat face, otherwise 0. Bearing
/// friction of a roller is neglected.
pub(crate) fn reach(follower: &Follower) -> f64 {
    if let Follower::FlatTranslating { base_radius } = follower {
        *base_radius
    } else {
        0.0
    }
}

/// Torque over the whole law, N·m, as a piecewise polynomial. With friction, the result is `None` if the force becomes negative, because
/// the torque is then not a polynomial.
pub fn torque_curve(law: &Law, drive: &Drive, friction: f64, reach: f64) -> Option<PiecewisePoly> {
    let force = drive.force_curve(law);
    let rub = friction * drive.speed.signum();
    if rub != 0.0 && drive.force_extremes(law).0.value < 0.0 {
        return None;
    }
    let arm = law.combination([rub, 1.0, 0.0, 0.0], rub * reach);
    Some(force.times(&arm))
}

/// Minimum speed of lift-off, rad/s. The result is 0 if the force is negative at rest, and `None` if the follower never lifts off. Each
/// iteration computes the angle with the minimum force at the present speed. The force at this angle is a quadratic function of ω, and its
/// root is the next, lower speed. The iteration converges from above, and the extremes are exact.
pub fn liftoff_speed(law: &Law, drive: &Drive) -> Option<f64> {
    let extremes = |[s, v, a]: [f64; 3], constant| law.extremes_of([s, v, a, 0.0], constant);
    let (rest, most) = extremes([drive.spring_rate, 0.0, 0.0], drive.rest_force);
    if rest.value < -NO_PULL_AT_REST * most.value.abs() {
        return Some(0.0);
    }
    if lifts_at_rest(law, drive, rest, most) {
        return Some(0.0);
    }
    if drive.mass <= 0.0 && drive.damping <= 0.0 {
        return None;
    }
    // Initial speed at which inertia or damping certainly exceeds the spring force at some angle, if such a speed exists.
    let highest = most.value;
    let least_a = extremes([0.0, 0.0, 1.0], 0.0).0;
    let mut speed = if drive.mass > 0.0 && least_a.value < 0.0 {
        let at = one_sided(law, least_a, &|at| at.a);
        let pull = (drive.mass * at.a.min(least_a.value)).abs();
        2.0 * (highest.max(0.0) / pull).sqrt() + drive.damping * at.v.abs() / pull
    } else {
        let least_v = extremes([0.0, 1.0, 0.0], 0.0).0;
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
        let (worst, largest) = extremes([k, c, m], drive.rest_force);
        // A force that only reaches zero, as in a dwell without preload, does not cause lift-off.
        if worst.value >= -NO_PULL * largest.value.abs() {
            break;
        }
        let at = one_sided(law, worst, &|at| here.force(at));
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

/// Whether damping causes lift-off at any speed, if the minimum force at rest is zero. Near the angle of this minimum, the lift is s = α
/// φⁿ, with a constant α and the angle φ measured from the minimum. Consider the force k s + c ω s′ + m ω² s″ at angles before the minimum.
/// If c² is above 4 k m (n − 1)/n, the force is negative at some of these angles for any speed. If c² is below this value, the force is not
/// negative for any speed. The order n is 2, or 3 at the end of a dwell.
fn lifts_at_rest(law: &Law, drive: &Drive, rest: Extreme, most: Extreme) -> bool {
    let touches = rest.value <= NO_PULL_AT_REST * most.value.abs();
    let order = if law.svaj(rest.at).a > NO_PULL_AT_REST * law.stroke() {
        2.0
    } else {
        3.0
    };
    let critical = 4.0 * drive.spring_rate * drive.mass * (order - 1.0) / order;
    touches && law.stroke() > 0.0 && drive.damping.powi(2) > critical
}

/// Motion at the angle of an extreme. If this angle is a break, the motion is evaluated on the side of the break on which `quantity` is
/// closer to the extreme value.
fn one_sided(law: &Law, extreme: Extreme, quantity: &dyn Fn(Svaj) -> f64) -> Svaj {
    let right = law.svaj(extreme.at);
    let n = law.breaks().len() - 1;
    let left = law
        .breaks()
        .iter()
        .position(|b| (b - extreme.at).abs() <= 1e-12 * (1.0 + b.abs()))
        .map(|i| law.svaj_on((i + n - 1) % n, 1.0));
    let off = |at: Svaj| (quantity(at) - extreme.value).abs();
    match left {
        Some(left) if off(left) < off(right) => left,
        _ => right,
    }
}

/// Smallest positive root of p x² + q x + r with r ≥ 0, computed without cancellation; `None` without such a root.
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

/// Minimum preload, N, for which the contact force is at least `margin`, N, over the whole turn. Spring rate, mass, damping and speed are
/// taken from `drive`.
pub fn least_preload(law: &Law, drive: &Drive, margin: f64) -> f64 {
    let free = Drive {
        rest_force: 0.0,
        ..*drive
    };
    (margin - free.force_extremes(law).0.value).max(0.0)
}

#[cfg(test)]
mod tests;

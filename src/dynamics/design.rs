//! Dynamics handed back to the design: limits that are linear in the law, and tangents of those that are not.

use crate::cam::Follower;
use crate::drive::Drive;
use crate::law::{Law, Svaj};
use std::f64::consts::PI;

/// One limit on the law: lower ≤ w₀s + w₁v + w₂a + w₃j + constant ≤ upper, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearLimit {
    /// Weights of s, v, a, j.
    pub weights: [f64; 4],
    /// What is added.
    pub constant: f64,
    /// Smallest value allowed (−∞: none).
    pub lower: f64,
    /// Largest value allowed (∞: none).
    pub upper: f64,
}

/// Contact force at least `margin` N: the spring (or gravity) keeps the follower on the cam. Exact.
pub fn force_at_least(drive: &Drive, margin: f64) -> LinearLimit {
    LinearLimit {
        weights: drive.weights(),
        constant: drive.rest_force,
        lower: margin,
        upper: f64::INFINITY,
    }
}

/// Line pressure under a flat face at most `pressure` Pa, exact: F ≤ π L p²/E*·(Rb + s + a), because the
/// radius of curvature is itself linear in the law (theory §6). `None` for a roller, whose curvature is
/// not; it is checked instead.
pub fn hertz_at_most(
    drive: &Drive,
    follower: &Follower,
    length: f64,
    modulus: f64,
    pressure: f64,
) -> Option<LinearLimit> {
    let Follower::FlatTranslating { base_radius } = *follower else {
        return None;
    };
    let per_radius = PI * length * pressure * pressure / modulus;
    let mut weights = drive.weights();
    weights[0] -= per_radius;
    weights[2] -= per_radius;
    Some(LinearLimit {
        weights,
        constant: drive.rest_force - per_radius * base_radius,
        lower: f64::NEG_INFINITY,
        upper: 0.0,
    })
}

/// Torque at most `torque` N·m wherever the force is at most `force` N: |v| ≤ T/F. Safe side.
pub fn torque_at_most(torque: f64, force: f64) -> LinearLimit {
    LinearLimit {
        weights: [0.0, 1.0, 0.0, 0.0],
        constant: 0.0,
        lower: -torque / force,
        upper: torque / force,
    }
}

/// Tangent of the torque T = F·v at one angle of a law: (weights, constant) with
/// T(law + δ) = w·(law + δ) + constant + second order in δ. For sequential convex programs.
pub fn torque_tangent(drive: &Drive, at: Svaj) -> ([f64; 4], f64) {
    let force = drive.force(at);
    let mut weights = drive.weights().map(|w| w * at.v);
    weights[1] += force;
    let value = force * at.v;
    (weights, value - dot(weights, at))
}

/// Tangent of the torque's rate dT/dθ = F′·v + F·a at one angle of a law, as [`torque_tangent`]; F′ has
/// the jerk in it.
pub fn torque_rate_tangent(drive: &Drive, at: Svaj) -> ([f64; 4], f64) {
    let [k, c, m, _] = drive.weights();
    let force = drive.force(at);
    let rate = k * at.v + c * at.a + m * at.j;
    let value = rate * at.v + force * at.a;
    let weights = [
        k * at.a,
        k * at.v + rate + c * at.a,
        c * at.v + force + m * at.a,
        m * at.v,
    ];
    (weights, value - dot(weights, at))
}

/// Both parts of the residual vibration a law leaves after its extent, as integrals of its acceleration
/// against cos and sin of `ratio`·θ: linear in the law. Undamped; amplitude = |(c, s)|/ratio.
pub fn residual_parts(law: &Law, ratio: f64) -> (f64, f64) {
    let (start, length) = law.extent();
    // Gauss points over parts of at most a radian of phase: exact to rounding for the law's polynomials.
    let a = law.combination([0.0, 0.0, 1.0, 0.0], 0.0);
    let (mut cos, mut sin) = (0.0, 0.0);
    let gauss = super::linear::gauss_points(20);
    for i in 0..a.pieces() {
        let (from, to) = (a.breaks()[i], a.breaks()[i + 1]);
        let parts = ((to - from) * ratio).ceil().max(1.0) as usize;
        for p in 0..parts {
            let (u0, u1) = (p as f64 / parts as f64, (p + 1) as f64 / parts as f64);
            for (x, w) in &gauss {
                let u = u0 + (u1 - u0) * x;
                let value =
                    crate::poly::bernstein::eval(a.piece(i), u) * w * (u1 - u0) * (to - from);
                let phase = ratio * (from + u * (to - from) - start - length);
                cos += value * phase.cos();
                sin += value * phase.sin();
            }
        }
    }
    (cos, sin)
}

fn dot(w: [f64; 4], at: Svaj) -> f64 {
    w[0] * at.s + w[1] * at.v + w[2] * at.a + w[3] * at.j
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{flexible, hertz, thesis};

    fn machine() -> Drive {
        Drive {
            spring_rate: 700.0,
            damping: 6.0,
            ..thesis::real(20.0)
        }
    }

    #[test]
    fn tangents_touch_torque_and_its_rate() {
        let (drive, law) = (machine(), thesis::double_harmonic().law);
        let torque = |at: Svaj| drive.force(at) * at.v;
        let [k, c, m, _] = drive.weights();
        let rate = |at: Svaj| (k * at.v + c * at.a + m * at.j) * at.v + drive.force(at) * at.a;
        for i in 0..20 {
            let at = law.svaj(0.3 * f64::from(i) + 0.05);
            let d = Svaj {
                s: 1e-6,
                v: -2e-6,
                a: 3e-6,
                j: 1e-6,
            };
            let near = Svaj {
                s: at.s + d.s,
                v: at.v + d.v,
                a: at.a + d.a,
                j: at.j + d.j,
            };
            for (tangent, f) in [
                (torque_tangent(&drive, at), &torque as &dyn Fn(Svaj) -> f64),
                (torque_rate_tangent(&drive, at), &rate),
            ] {
                let linear = |p: Svaj| dot(tangent.0, p) + tangent.1;
                assert!((linear(at) - f(at)).abs() < 1e-14);
                assert!((linear(near) - f(near)).abs() < 1e-8);
            }
        }
    }

    #[test]
    fn the_hertz_limit_binds_exactly_at_its_pressure() {
        let cam = thesis::double_harmonic();
        let drive = thesis::real(20.0);
        let star = hertz::modulus(hertz::STEEL, hertz::STEEL);
        let at = cam.law.svaj(1.1);
        let contact = hertz::line(drive.force(at), 0.01, 1.0 / (0.03 + at.s + at.a), star);
        let limit = hertz_at_most(&drive, &cam.follower, 0.01, star, contact.pressure).unwrap();
        assert!((dot(limit.weights, at) + limit.constant).abs() < 1e-9);
    }

    #[test]
    fn force_and_torque_limits_say_what_their_names_say() {
        let (drive, law) = (machine(), thesis::double_harmonic().law);
        let at = law.svaj(0.8);
        let limit = force_at_least(&drive, 2.0);
        assert!((dot(limit.weights, at) + limit.constant - drive.force(at)).abs() < 1e-14);
        let limit = torque_at_most(0.5, 25.0);
        assert_eq!((limit.lower, limit.upper), (-0.02, 0.02));
    }

    #[test]
    fn residual_parts_are_the_residual_vibration() {
        let p345 = crate::poly::bernstein::from_power(&[0.0, 0.0, 0.0, 10.0, -15.0, 6.0]);
        let law = Law::from_poly(
            crate::poly::PiecewisePoly::new(vec![0.0, 1.0], 5, p345),
            false,
        );
        for ratio in [3.0, 12.0, 31.0, 64.0] {
            let (c, s) = residual_parts(&law, ratio);
            let amplitude = flexible::residual_vibration(&law, ratio);
            assert!((c.hypot(s) / ratio - amplitude).abs() < 1e-13, "{ratio}");
        }
    }
}

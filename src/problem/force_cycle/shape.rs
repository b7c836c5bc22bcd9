//! A harmonic law without its mean. Its torque is a product and its contact pressure a quotient of sums of harmonics.

use std::f64::consts::TAU;

use crate::drive::Drive;
use crate::law::{Law, weighted};
use crate::poly::{amplitudes, harmonic_extremes, harmonic_sums, harmonic_values};

/// Maximum number of Newton steps in the search for a maximum. Usually, three or four steps are sufficient.
const STEPS: usize = 12;
/// Step of the angle, rad, below which the Newton iteration ends. A parabola then gives the value at the maximum.
const FLAT: f64 = 1e-5;
/// Relative difference from the highest maximum on the grid up to which a local maximum is refined.
const NEAR: f64 = 0.1;

/// Pair of minimum and maximum.
type Range = [f64; 2];

/// A harmonic law, with its extremes and the harmonics of its force.
#[derive(Debug)]
pub struct Shape {
    /// The law, with zero mean.
    pub law: Law,
    /// Minimum and maximum of lift s, velocity v, acceleration a and jerk j, as derivatives with respect to the cam angle.
    pub svaj: [Range; 4],
    /// Minimum and maximum of the alternating force, N.
    pub force_range: Range,
    /// Minimum of lift plus acceleration, s + a, m. It determines the minimum radius of curvature under a flat face.
    pub least_bent: f64,
    /// Minimum and maximum of the torque F·v, N·m. The force F includes its mean.
    pub torque_range: Range,
    pub torque_mean_and_rms: [f64; 2],
    /// Harmonics of the alternating force as (cosine, sine), N.
    force: Vec<(f64, f64)>,
    /// Harmonics of s + a as (cosine, sine), m.
    bent: Vec<(f64, f64)>,
    /// Alternating force and s + a at equal steps of the angle, at least 16 per period of the highest harmonic.
    grid: Vec<(f64, f64)>,
}

impl Shape {
    /// Law with which a drive produces a force of the given mean and harmonics, N; `None` at resonance.
    pub fn of(mean: f64, force: &[(f64, f64)], drive: &Drive) -> Option<Shape> {
        let lift = (1..).zip(force).map(|(n, wave)| drive.lift_of(n, *wave));
        let lift: Vec<(f64, f64)> = lift.collect::<Option<_>>()?;
        let velocity = weighted(&lift, [0.0, 1.0, 0.0, 0.0]);
        let bent = weighted(&lift, [1.0, 0.0, 1.0, 0.0]);
        let [forces, velocities, bends] = [force, &velocity, &bent].map(harmonic_values);
        // F·v has twice as many harmonics as F. The grid resolves these harmonics and the harmonics of their squares.
        let torques = forces.iter().zip(velocities);
        let torques: Vec<f64> = torques.map(|(f, v)| (mean + f) * v).collect();
        let spectrum = amplitudes(&torques);
        let (low, high) = harmonic_extremes(&spectrum[1..=2 * force.len()]);
        let square: f64 = torques.iter().map(|t| t * t).sum();
        let law = Law::harmonic(0.0, &lift);
        let range = |weights| {
            let (low, high) = law.extremes_of(weights, 0.0);
            [low.value, high.value]
        };
        Some(Shape {
            svaj: [0, 1, 2, 3].map(|order| range(std::array::from_fn(|k| f64::from(k == order)))),
            force_range: range(drive.weights()),
            least_bent: range([1.0, 0.0, 1.0, 0.0])[0],
            torque_range: [low, high].map(|torque| spectrum[0].0 + torque.value),
            torque_mean_and_rms: [spectrum[0].0, (square / torques.len() as f64).sqrt()],
            law,
            force: force.to_vec(),
            bent,
            grid: forces.into_iter().zip(bends).collect(),
        })
    }

    /// Maximum over the turn of (`mean` + `scale` · f) / (`radius` + `factor` · (s + a)), at least 0. Here f is the alternating force.
    pub fn highest_quotient(&self, [mean, scale]: [f64; 2], [radius, factor]: [f64; 2]) -> f64 {
        let quotient =
            |(force, bent): &(f64, f64)| (mean + scale * force) / (radius + factor * bent);
        let quotients: Vec<f64> = self.grid.iter().map(quotient).collect();
        let larger = |most: f64, &q: &f64| if q > most { q } else { most };
        let mut most = quotients.iter().fold(0.0, larger);
        let least = (1.0 - NEAR) * most;
        let n = quotients.len();
        for (i, &here) in quotients.iter().enumerate() {
            if here < least {
                continue;
            }
            let (before, after) = (quotients[(i + n - 1) % n], quotients[(i + 1) % n]);
            if here >= before && here >= after {
                // Maximum of the parabola through the values at three neighbouring grid points.
                let bend = before - 2.0 * here + after;
                let off = if bend < 0.0 {
                    0.5 * (before - after) / bend
                } else {
                    0.0
                };
                let near = TAU * (i as f64 + off) / n as f64;
                most = most.max(self.crest(near, [mean, scale], [radius, factor]));
            }
        }
        most
    }

    /// Local maximum of the quotient of [`Shape::highest_quotient`] near an angle, rad. It is found by Newton's method.
    fn crest(&self, near: f64, [mean, scale]: [f64; 2], [radius, factor]: [f64; 2]) -> f64 {
        let mut at = near;
        let mut most = f64::NEG_INFINITY;
        for _ in 0..STEPS {
            let [force, bent] = harmonic_sums([&self.force, &self.bent], at);
            let ([f, f1, f2], [g, g1, g2]) = (force.map(|x| scale * x), bent.map(|x| factor * x));
            let (f, g) = (mean + f, radius + g);
            let (slope, bend) = (f1 * g - f * g1, f2 * g - f * g2);
            let step = -slope / bend;
            most = most.max(f / g);
            if bend >= 0.0 {
                break;
            }
            if step.abs() < FLAT {
                // The value at the maximum is extrapolated by a parabola over the remaining step.
                return most.max(f / g + 0.5 * step * slope / (g * g));
            }
            at += step;
        }
        most
    }
}

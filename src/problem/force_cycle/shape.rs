//! A law of harmonics without its mean, with its torque and its pressure: sums and quotients of harmonics.

use std::f64::consts::TAU;

use crate::drive::Drive;
use crate::law::{Law, weighted};
use crate::poly::{amplitudes, harmonic_extremes, harmonic_sums, harmonic_values};

/// Steps of Newton's method to a crest; it settles in three or four.
const STEPS: usize = 12;
/// A crest is that flat within this angle, rad, that its value is found by one more parabola.
const FLAT: f64 = 1e-5;
/// Crests of a grid within this part of the highest are searched: with 16 points for the fastest wave they miss their tops
/// by less.
const NEAR: f64 = 0.1;

/// Smallest and largest value.
type Range = [f64; 2];

/// A law with all that is scaled with it.
#[derive(Debug)]
pub struct Shape {
    /// The law; its mean is zero.
    pub law: Law,
    /// s, v, a, j.
    pub svaj: [Range; 4],
    /// Force without its mean.
    pub force_range: Range,
    /// Least s + a.
    pub least_bent: f64,
    /// Torque F·v under the whole force.
    pub torque_range: Range,
    pub torque_mean_and_rms: [f64; 2],
    /// Harmonics of the force.
    force: Vec<(f64, f64)>,
    /// Harmonics of s + a.
    bent: Vec<(f64, f64)>,
    /// Both at even steps, 16 for the fastest wave or more.
    grid: Vec<(f64, f64)>,
}

impl Shape {
    /// The law of a drive whose force has these harmonics about a mean; `None` in resonance.
    pub fn of(mean: f64, force: &[(f64, f64)], drive: &Drive) -> Option<Shape> {
        let lift = (1..).zip(force).map(|(n, wave)| drive.lift_of(n, *wave));
        let lift: Vec<(f64, f64)> = lift.collect::<Option<_>>()?;
        let velocity = weighted(&lift, [0.0, 1.0, 0.0, 0.0]);
        let bent = weighted(&lift, [1.0, 0.0, 1.0, 0.0]);
        let [forces, velocities, bends] = [force, &velocity, &bent].map(harmonic_values);
        // F·v has twice as many harmonics: the grid holds them, and those of its square.
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

    /// Highest quotient of `mean` + `scale` times the force and `radius` + `factor` times s + a.
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
                // The top of the parabola through the three.
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

    /// The quotient at the crest near a place, by Newton's method.
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
                // What is left of the way changes the value by the rest of a parabola.
                return most.max(f / g + 0.5 * step * slope / (g * g));
            }
            at += step;
        }
        most
    }
}

//! Torque, power, lift-off and pressure of a harmonic law under a flat face, all sums of harmonics.

use super::figures::Motion;
use super::target::{Fit, Torque};
use crate::drive::Drive;
use crate::dynamics::hertz::{STEEL, modulus};
use crate::dynamics::rigid::lowest_liftoff;
use crate::law::Svaj;
use crate::poly::{harmonic_extremes, harmonic_sum};
use crate::synth::MachineReport;
use crate::synth::design::machine::mean_power;
use std::f64::consts::{PI, TAU};

/// Within this relative distance the mean force is that of the target, whose torque is cached.
const SAME: f64 = 1e-13;
/// Steps of Newton's method to a crest of the pressure; it settles in three or four.
const STEPS: usize = 12;
/// A crest is that flat within this angle, rad, that its value is found by one more parabola.
const FLAT: f64 = 1e-5;
/// Crests of a grid within this part of the range below the highest are searched.
const NEAR: f64 = 0.1;

/// Forces and size of a design, as the machine feels them.
pub struct Load<'a> {
    /// The machine.
    pub drive: &'a Drive,
    /// The target's harmonics.
    pub fit: &'a Fit,
    /// The law.
    pub motion: &'a Motion,
    /// Times the target's harmonics is the cam's force, N.
    pub scale: f64,
    /// Mean of the target, N.
    pub mean: f64,
    /// Mean of the cam's force, N.
    pub mean_force: f64,
    /// Radius of the base circle, m.
    pub base_radius: f64,
    /// Thickness of the plate, m.
    pub thickness: f64,
}

impl Load<'_> {
    /// What the design asks of the machine, as [`Design::machine`](crate::synth::Design::machine) finds it.
    pub fn report(&self) -> MachineReport {
        let torque = self.torque();
        let speed = self.drive.speed;
        let (low, high) = torque.range;
        MachineReport {
            torque_max_n_m: Some(high.max(-low)),
            torque_rms_n_m: Some(torque.square.sqrt()),
            power_max_w: Some(high.max(-low) * speed),
            power_mean_w: Some(mean_power(
                speed * torque.mean,
                [low, high].map(|t| t * speed),
            )),
            liftoff_speed_rad_per_s: self.liftoff(),
            hertz_pressure_max_pa: self.pressure(),
        }
    }

    fn torque(&self) -> Torque {
        let motion = self.motion;
        let factor = self.scale * motion.factor;
        if (self.mean_force - self.mean).abs() <= SAME * self.mean.abs() {
            return motion.unit.torque.scaled(factor);
        }
        let mean = self.mean_force / self.scale;
        Torque::of(mean, self.fit.harmonics(), &motion.terms).scaled(factor)
    }

    fn liftoff(&self) -> Option<f64> {
        let (drive, motion) = (self.drive, self.motion);
        if drive.spring_rate == 0.0 && drive.damping == 0.0 {
            // F = M(g + ω²a): it vanishes where ω² = g/(−a).
            let pull = -drive.mass * motion.range(2).0;
            return (pull > 0.0).then(|| (drive.rest_force / pull).sqrt());
        }
        let terms = |[k, c, m]: [f64; 3]| -> Vec<(f64, f64)> {
            let waves = (1..).zip(&motion.terms);
            waves
                .map(|(n, &(a, b))| {
                    let n = f64::from(n);
                    let (even, odd) = (motion.factor * (k - m * n * n), motion.factor * c * n);
                    (even * a + odd * b, even * b - odd * a)
                })
                .collect()
        };
        lowest_liftoff(
            drive,
            |weights, constant| {
                let (mut low, mut high) = harmonic_extremes(&terms(weights));
                let level = constant + weights[0] * motion.level;
                low.value += level;
                high.value += level;
                (low, high)
            },
            |extreme, _| {
                let at = harmonic_sum(&motion.terms, extreme.at).map(|x| motion.factor * x);
                Svaj {
                    s: motion.level + at[0],
                    v: at[1],
                    a: at[2],
                    j: 0.0,
                }
            },
        )
    }

    /// p² = E*/(π L)·F/(Rb + s + a): the highest quotient of two sums of harmonics.
    fn pressure(&self) -> Option<f64> {
        let radius = self.base_radius + self.motion.level;
        let (factor, scale) = (self.motion.factor, self.scale);
        let grid = self.motion.grid.iter();
        let quotients: Vec<f64> = grid
            .map(|(force, bent)| (self.mean_force + scale * force) / (radius + factor * bent))
            .collect();
        let most = self.highest(&quotients, radius);
        let factor = modulus(STEEL, STEEL) / (PI * self.thickness);
        Some((factor * most.max(0.0)).sqrt())
    }

    /// From every crest of the grid that could be the highest on to its top. Between two points a sum of
    /// harmonics exceeds them by less than 2 % of the range, as there are 16 for the fastest wave.
    fn highest(&self, grid: &[f64], radius: f64) -> f64 {
        let (mut low, mut high) = (grid[0], grid[0]);
        for &q in grid {
            low = if q < low { q } else { low };
            high = if q > high { q } else { high };
        }
        let near = high - NEAR * (high - low);
        let n = grid.len();
        let mut most = high;
        for (i, &here) in grid.iter().enumerate() {
            if here < near {
                continue;
            }
            let (before, after) = (grid[(i + n - 1) % n], grid[(i + 1) % n]);
            if here >= before && here >= after {
                // The top of the parabola through the three.
                let bend = before - 2.0 * here + after;
                let off = if bend < 0.0 {
                    0.5 * (before - after) / bend
                } else {
                    0.0
                };
                most = most.max(self.crest(TAU * (i as f64 + off) / n as f64, radius));
            }
        }
        most
    }

    /// The quotient at the crest near a place, by Newton's method.
    fn crest(&self, start: f64, radius: f64) -> f64 {
        let mut at = start;
        let mut most = f64::NEG_INFINITY;
        for _ in 0..STEPS {
            let ([f0, f1, f2], [g0, g1, g2]) = self.force_and_bent(at);
            let (f0, g0) = (self.mean_force + f0, radius + g0);
            most = most.max(f0 / g0);
            let (slope, bend) = (f1 * g0 - f0 * g1, f2 * g0 - f0 * g2);
            let step = -slope / bend;
            if bend >= 0.0 || step.abs() < FLAT {
                // What is left of the way changes the value by the rest of a parabola.
                if bend < 0.0 {
                    most = most.max(f0 / g0 + 0.5 * step * slope / (g0 * g0));
                }
                break;
            }
            at += step;
        }
        most
    }

    /// The force less its mean, and s + a = Σ (1 − n²)(aₙ cos nθ + bₙ sin nθ) less its level, with two derivatives each.
    fn force_and_bent(&self, at: f64) -> ([f64; 3], [f64; 3]) {
        let (sin, cos) = at.sin_cos();
        let (mut c, mut s) = (1.0, 0.0);
        let (mut force, mut bent) = ([0.0; 3], [0.0; 3]);
        let waves = self.fit.harmonics().iter().zip(&self.motion.terms);
        for (n, (own, law)) in (1..).zip(waves) {
            (c, s) = (c * cos - s * sin, s * cos + c * sin);
            let n = f64::from(n);
            let square = n * n;
            let add = |sums: &mut [f64; 3], (a, b): (f64, f64), factor: f64| {
                let (even, odd) = (factor * (a * c + b * s), factor * (b * c - a * s));
                sums[0] += even;
                sums[1] += n * odd;
                sums[2] -= square * even;
            };
            add(&mut force, *own, self.scale);
            add(&mut bent, *law, self.motion.factor * (1.0 - square));
        }
        (force, bent)
    }
}

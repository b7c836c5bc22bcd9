//! Torque, power, lift-off and pressure of a harmonic law under a flat face, all sums of harmonics.

use super::figures::Motion;
use super::target::{Fit, Torque};
use crate::drive::Drive;
use crate::dynamics::hertz::{STEEL, modulus};
use crate::dynamics::rigid::lowest_liftoff;
use crate::law::Svaj;
use crate::poly::{harmonic_extremes, harmonic_maximum, harmonic_sum};
use crate::synth::MachineReport;
use crate::synth::machine::mean_power;
use std::f64::consts::PI;

/// A mean force nearer to the target's, as a part of it, is the target's: its torque is known already.
const SAME: f64 = 1e-13;
/// Rounds of the search for the highest quotient; it settles in one or two.
const ROUNDS: usize = 40;
/// Steps of Newton's method before it.
const STEPS: usize = 8;
/// A gain below this part of the quotient is rounding.
const SETTLED: f64 = 1e-14;

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
            power_max_w: Some((low * speed).max(high * speed)),
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
        let motion = self.motion;
        let force = Sum {
            mean: self.mean_force,
            terms: (self.fit.harmonics().iter())
                .map(|t| (self.scale * t.0, self.scale * t.1))
                .collect(),
        };
        let bent = (1..).zip(&motion.terms).map(|(n, t)| {
            let factor = motion.factor * (1.0 - f64::from(n * n));
            (factor * t.0, factor * t.1)
        });
        let radius = Sum {
            mean: self.base_radius + motion.level,
            terms: bent.collect(),
        };
        let most = highest_quotient(&force, &radius, self.fit.highest_at);
        let factor = modulus(STEEL, STEEL) / (PI * self.thickness);
        Some((factor * most.max(0.0)).sqrt())
    }
}

/// A mean and its harmonics.
struct Sum {
    mean: f64,
    terms: Vec<(f64, f64)>,
}

impl Sum {
    fn at(&self, theta: f64) -> [f64; 3] {
        let [value, slope, bend] = harmonic_sum(&self.terms, theta);
        [self.mean + value, slope, bend]
    }
}

/// Largest f/g, g > 0: Newton's method from `start`, then Dinkelbach's: the largest f − λg gives a higher
/// quotient λ, until there is none.
fn highest_quotient(f: &Sum, g: &Sum, start: f64) -> f64 {
    let quotient = |theta: f64| f.at(theta)[0] / g.at(theta)[0];
    let mut at = start;
    for _ in 0..STEPS {
        let ([f0, f1, f2], [g0, g1, g2]) = (f.at(at), g.at(at));
        let (slope, bend) = (f1 * g0 - f0 * g1, f2 * g0 - f0 * g2);
        if bend >= 0.0 {
            break;
        }
        let step = -slope / bend;
        at += step;
        if step.abs() < 1e-9 {
            break;
        }
    }
    let mut most = quotient(start).max(quotient(at));
    let mut gain = vec![(0.0, 0.0); f.terms.len()];
    for _ in 0..ROUNDS {
        for (out, (a, b)) in gain.iter_mut().zip(f.terms.iter().zip(&g.terms)) {
            *out = (a.0 - most * b.0, a.1 - most * b.1);
        }
        let next = quotient(harmonic_maximum(&gain).at);
        if next <= most * (1.0 + SETTLED) {
            break;
        }
        most = next;
    }
    most
}

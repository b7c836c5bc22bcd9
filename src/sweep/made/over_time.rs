//! Force error of a design, from forces at equal cam angles: over the angle at constant speed, otherwise over time with the optimal phase. The phase
//! is linearised, because manufacturing errors change it only slightly.

use std::f64::consts::TAU;

use crate::force::ForceCurve;
use crate::synth::Design;

/// Number of equal angles per turn. The trapezoidal rule converges fast for smooth functions.
pub const POINTS: usize = 4096;

/// Weights for the mean square force error over time.
pub struct OverTime {
    /// Weight of each angle, as a fraction of the period.
    pub weights: Vec<f64>,
    /// Derivative of the target with respect to its phase, up to a factor, N; zero at constant speed.
    pub rates: Vec<f64>,
}

impl OverTime {
    /// Error measure of a design, with its target over the cam angle.
    pub fn of(design: &Design, target: &ForceCurve) -> OverTime {
        if design.shaft.is_none() {
            return OverTime {
                weights: vec![1.0 / POINTS as f64; POINTS],
                rates: vec![0.0; POINTS],
            };
        }
        let speed = |i: usize| design.speed_and_time(angle(i)).0;
        let lasting: f64 = (0..POINTS).map(|i| 1.0 / speed(i)).sum();
        let step = angle(1);
        let rate = |i: usize| target.at(angle(i) + step) - target.at(angle(i) - step);
        OverTime {
            weights: (0..POINTS).map(|i| 1.0 / speed(i) / lasting).collect(),
            rates: (0..POINTS).map(|i| speed(i) * rate(i)).collect(),
        }
    }

    /// Minimum root mean square over the phase, N, of differences at the angles.
    pub fn error(&self, off: impl Fn(usize) -> f64) -> f64 {
        let [mut square, mut slope, mut bend] = [0.0; 3];
        for (i, (weight, rate)) in self.weights.iter().zip(&self.rates).enumerate() {
            let off = off(i);
            square += weight * off * off;
            slope += weight * off * rate;
            bend += weight * rate * rate;
        }
        let gained = if bend > 0.0 {
            slope * slope / bend
        } else {
            0.0
        };
        (square - gained).max(0.0).sqrt()
    }

    /// Subtracts the reduction by the optimal phase from mean products of functions. The last function is the derivative with respect to the phase.
    pub fn free_of_phase(mut products: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        let of_rate = products.pop().unwrap_or_default();
        let bend = of_rate.last().copied().unwrap_or_default();
        for (line, own) in products.iter_mut().zip(&of_rate) {
            line.pop();
            if bend > 0.0 {
                let gained = line.iter_mut().zip(&of_rate);
                gained.for_each(|(product, other)| *product -= own * other / bend);
            }
        }
        products
    }
}

/// Equally spaced angle with index i, rad.
pub fn angle(i: usize) -> f64 {
    TAU * i as f64 / POINTS as f64
}

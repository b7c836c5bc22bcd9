//! Force error of a design, computed from forces at equally spaced cam angles. At constant speed, the mean square is a mean over the angle.
//! Otherwise, it is a mean over time, with the phase that minimises the error. The effect of the phase is linearised, because manufacturing
//! errors change the phase only slightly.

use std::f64::consts::TAU;

use crate::force::ForceCurve;
use crate::synth::Design;

/// Number of equally spaced angles per turn. For smooth periodic functions, the trapezoidal rule converges fast.
pub const POINTS: usize = 4096;

/// Weights of the cam angles in a mean over time.
pub struct OverTime {
    /// Weight of each angle: its fraction of the period.
    pub weights: Vec<f64>,
    /// Derivative of the target with respect to its phase at each angle, up to a common factor. It is zero at constant speed.
    pub rates: Vec<f64>,
}

impl OverTime {
    /// Weights for a design. `target` is its target force as a function of the cam angle.
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

    /// RMS of the force differences `off`, N, at the equally spaced angles. The phase of the target is chosen so that the RMS is a minimum.
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

    /// Corrects the mean products of several functions for the optimal phase. The last function must be the derivative of the target with
    /// respect to its phase. It is removed from the result.
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

/// Angle number i of the [`POINTS`] equally spaced angles, rad.
pub fn angle(i: usize) -> f64 {
    TAU * i as f64 / POINTS as f64
}

//! What a load cell shows: the force through the cell's own resonance, blows included.

use super::linear::Linear;
use crate::poly::PiecewisePoly;
use nalgebra::{Matrix4, Vector4};
use std::f64::consts::TAU;

/// A load cell as one mass on a spring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadCell {
    /// Natural frequency as mounted, Hz.
    pub hertz: f64,
    /// Damping ratio; above 0.
    pub damping_ratio: f64,
}

impl LoadCell {
    /// Reading at equal angles over one repetition of `length` rad, from the force there (N, linear between)
    /// and blows (angle from the start in rad, N·s), at `speed` rad/s.
    ///
    /// Exact for that force: y″ + 2ζw y′ + w²y = w²F, a blow J steps y′ by w²J. Returns the force itself
    /// when the cell has no finite frequency or the shaft stands still.
    pub fn reading(
        &self,
        force: &[f64],
        blows: &[(f64, f64)],
        length: f64,
        speed: f64,
    ) -> Vec<f64> {
        let w = TAU * self.hertz / speed;
        if force.len() < 2 || !(w.is_finite() && w > 0.0 && self.damping_ratio > 0.0) {
            return force.to_vec();
        }
        let n = force.len();
        let step = length / n as f64;
        let value = |x: f64| {
            let (i, u) = ((x / step) as usize % n, (x / step).fract());
            force[i] * (1.0 - u) + force[(i + 1) % n] * u
        };
        let mut breaks: Vec<f64> = (0..=n).map(|i| step * i as f64).collect();
        let inside = blows
            .iter()
            .map(|b| b.0)
            .filter(|x| *x > 0.0 && *x < length);
        breaks.extend(inside);
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|b, a| *b - *a < 1e-9 * step);
        let last = breaks.len() - 1;
        let at = |x: f64| if x >= length { force[0] } else { value(x) };
        let mut coef = Vec::with_capacity(2 * last);
        for pair in breaks.windows(2) {
            coef.extend([at(pair[0]), at(pair[1])]);
        }
        let mut kicks = vec![Vector4::zeros(); last];
        for (x, impulse) in blows {
            let i = breaks.partition_point(|b| *b < x - 1e-9 * step).min(last) % last;
            // Per radian: dt = dθ/ω, so the step of y′ is w²·J·ω.
            kicks[i][1] += w * impulse * speed;
        }
        let mut rates = -Matrix4::identity();
        (rates[(0, 0)], rates[(0, 1)]) = (0.0, w);
        (rates[(1, 0)], rates[(1, 1)]) = (-w, -2.0 * self.damping_ratio * w);
        let linear = Linear {
            rates,
            inputs: vec![Vector4::new(0.0, w, 0.0, 0.0)],
        };
        let forcing = PiecewisePoly::new(breaks.clone(), 1, coef);
        let Some(states) = linear.periodic(&[&forcing], |i| kicks[i]) else {
            return force.to_vec();
        };
        (0..n)
            .map(|i| {
                let x = step * i as f64;
                let k = breaks.partition_point(|b| *b < x - 1e-9 * step).min(last);
                states[k][0]
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slow_force_is_read_as_it_is_and_a_blow_keeps_its_impulse() {
        let n = 1440;
        let force: Vec<f64> = (0..n)
            .map(|i| 10.0 + (TAU * f64::from(i) / f64::from(n)).sin())
            .collect();
        let cell = LoadCell {
            hertz: 60.0,
            damping_ratio: 0.1,
        };
        let speed = 12.0;
        let still = cell.reading(&force, &[], TAU, speed);
        // At a slow harmonic the cell lags by 2ζr and lifts by r².
        let r = speed / (TAU * 60.0);
        let lag = (2.0 * 0.1 * r).hypot(r * r);
        assert!(
            force
                .iter()
                .zip(&still)
                .all(|(a, b)| (a - b).abs() < 1.2 * lag)
        );
        // Mean reading = mean force + impulse per period.
        let struck = cell.reading(&force, &[(1.234_567, 0.2)], TAU, speed);
        let mean = |x: &[f64]| x.iter().sum::<f64>() / x.len() as f64;
        let expected = mean(&force) + 0.2 * speed / TAU;
        assert!(
            (mean(&struck) - expected).abs() < 1e-3,
            "{} {expected}",
            mean(&struck)
        );
        assert!(struck.iter().cloned().fold(0.0, f64::max) > 50.0);
    }
}

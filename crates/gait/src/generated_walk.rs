//! A walk with the statistics of human steps, for designs without a recording.

use std::f64::consts::TAU;

use gaitcam_base::random::Sequence;

use crate::statistics::{mean, sample_deviation};
use crate::walk::Walk;

/// Exponent of the long-range correlation of step times.
///
/// A published value is 0.83 for one healthy person over nine minutes (Goldberger et al., PhysioNet tutorial on fractal mechanisms).
/// Another is 0.76 on average for ten young men (Hausdorff et al. 1995, quoted from memory).
const EXPONENT: f64 = 0.8;

/// Statistics of the steps of a generated walk.
///
/// ```
/// use gaitcam_gait::StepStatistics;
///
/// // The coefficient of variation of the stride time of a healthy person is 1 to 4 %.
/// assert_eq!(StepStatistics::default().step_time_cv, 0.03);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct StepStatistics {
    /// Number of strides of two steps each.
    pub strides: usize,
    /// Coefficient of variation of the step time.
    pub step_time_cv: f64,
    /// Coefficient of variation of the amplitude with which the force varies about its mean.
    pub amplitude_cv: f64,
    /// Seed of the random numbers. Equal seeds give equal walks.
    pub seed: u64,
}

impl Default for StepStatistics {
    /// Default values: 128 strides, a coefficient of variation of the step time of 3 %, and a constant amplitude.
    fn default() -> StepStatistics {
        StepStatistics {
            strides: 128,
            step_time_cv: 0.03,
            amplitude_cv: 0.0,
            seed: 1,
        }
    }
}

impl Walk {
    /// Walk whose steps vary at random. `step_s` is the mean duration of a step, s, and `force` is the periodic force, N, at a phase in
    /// steps.
    ///
    /// The step times have a long-range correlation. The amplitudes of the steps are independent. The step times and the amplitudes have
    /// exactly the given coefficients of variation. `None` for fewer than eight strides, or if the random duration of a step is not
    /// positive.
    ///
    /// ```
    /// use gaitcam_gait::{StepStatistics, Walk};
    ///
    /// let force = |phase: f64| 700.0 + 250.0 * (std::f64::consts::TAU * phase).sin();
    /// let walk = Walk::generated(0.54, &StepStatistics::default(), force).unwrap();
    /// let of = walk.variability();
    /// assert_eq!((of.strides, walk.runs.len()), (128, 1));
    /// assert!((of.step_time_s - 0.54).abs() < 1e-9 && (of.step_time_cv - 0.03).abs() < 3e-4);
    /// // Consecutive step times are correlated.
    /// assert!(of.autocorrelation > 0.2);
    /// ```
    pub fn generated(
        step_s: f64,
        statistics: &StepStatistics,
        force: impl Fn(f64) -> f64,
    ) -> Option<Walk> {
        let count = 2 * statistics.strides;
        let mut dice = Dice(Sequence::new(statistics.seed));
        let times = varied(correlated(&mut dice, count), statistics.step_time_cv);
        let parts = varied(
            (0..count).map(|_| dice.normal()).collect(),
            statistics.amplitude_cv,
        );
        if times.iter().any(|t| *t <= 0.0) {
            return None;
        }
        let mut strikes = vec![0.0];
        for time in &times {
            strikes.push(strikes[strikes.len() - 1] + step_s * time);
        }
        let samples = 256;
        let whole = (0..samples).map(|i| force(2.0 * f64::from(i) / f64::from(samples)));
        let level = whole.sum::<f64>() / f64::from(samples);
        let strides: Vec<[f64; 3]> = strikes
            .windows(3)
            .step_by(2)
            .map(|s| [s[0], s[1], s[2]])
            .collect();
        Walk::of(&strides, false, |stride, time| {
            let step = 2 * stride + usize::from(time >= strikes[2 * stride + 1]);
            let part = (time - strikes[step]) / (strikes[step + 1] - strikes[step]);
            // The amplitude changes linearly from one heel strike to the next, so that the force is continuous.
            let [a, b] = [parts[step], parts[(step + 1) % count]];
            level + (a + part * (b - a)) * (force(step as f64 + part) - level)
        })
    }
}

/// Random numbers, shifted and scaled to the mean 1 and a given coefficient of variation.
fn varied(random: Vec<f64>, cv: f64) -> Vec<f64> {
    let centre = mean(&random);
    let spread = sample_deviation(&random)
        .filter(|s| *s > 0.0)
        .unwrap_or(1.0);
    let scaled = random.iter().map(|x| 1.0 + cv * (x - centre) / spread);
    scaled.collect()
}

/// Fractional Gaussian noise, by the recursion of Hosking (1984). Each value is normally distributed about its prediction from all previous
/// values.
fn correlated(dice: &mut Dice, count: usize) -> Vec<f64> {
    let covariance = |k: usize| {
        let power = |x: f64| libm::pow(x.abs(), 2.0 * EXPONENT);
        let k = k as f64;
        0.5 * (power(k + 1.0) - 2.0 * power(k) + power(k - 1.0))
    };
    let (mut values, mut weights) = (Vec::with_capacity(count), Vec::<f64>::new());
    let mut variance = 1.0;
    for n in 0..count {
        if n > 0 {
            let known: f64 = (weights.iter().enumerate())
                .map(|(j, w)| w * covariance(n - 1 - j))
                .sum();
            let last = (covariance(n) - known) / variance;
            let before = weights.clone();
            for (w, other) in weights.iter_mut().zip(before.iter().rev()) {
                *w -= last * other;
            }
            weights.push(last);
            variance *= 1.0 - last * last;
        }
        // Weight j belongs to the value j + 1 steps earlier.
        let predicted: f64 = weights
            .iter()
            .zip(values.iter().rev())
            .map(|(w, x)| w * x)
            .sum();
        values.push(predicted + variance.sqrt() * dice.normal());
    }
    values
}

/// Generator of normally distributed random numbers.
struct Dice(Sequence);

impl Dice {
    /// Random number, uniformly distributed in (0, 1].
    fn uniform(&mut self) -> f64 {
        self.0.next_unit() + 0.5 * f64::EPSILON
    }

    /// Normally distributed random number with mean 0 and standard deviation 1, by the method of Box and Muller.
    fn normal(&mut self) -> f64 {
        let (radius, angle) = (
            (-2.0 * libm::log(self.uniform())).sqrt(),
            TAU * self.uniform(),
        );
        radius * libm::cos(angle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn correlated_numbers_have_the_covariance_of_their_exponent() {
        let many = 400;
        let (mut square, mut next, mut fifth) = (0.0, 0.0, 0.0);
        for seed in 0..many {
            let x = correlated(&mut Dice(Sequence::new(seed)), 64);
            let sum = |lag: usize| x.iter().zip(&x[lag..]).map(|(a, b)| a * b).sum::<f64>();
            square += sum(0) / 64.0 / many as f64;
            next += sum(1) / 63.0 / many as f64;
            fifth += sum(5) / 59.0 / many as f64;
        }
        let exact = |k: f64| 0.5 * ((k + 1.0).powf(1.6) - 2.0 * k.powf(1.6) + (k - 1.0).powf(1.6));
        assert!((square - 1.0).abs() < 0.1, "{square}");
        assert!((next - exact(1.0)).abs() < 0.1, "{next}");
        assert!((fifth - exact(5.0)).abs() < 0.1, "{fifth}");
    }

    #[test]
    fn steps_without_variation_repeat_the_force() {
        let force =
            |phase: f64| 700.0 + 200.0 * (TAU * phase).cos() + 50.0 * (0.5 * TAU * phase).sin();
        let even = StepStatistics {
            strides: 8,
            step_time_cv: 0.0,
            ..StepStatistics::default()
        };
        let walk = Walk::generated(0.5, &even, force).unwrap();
        assert!((walk.duration_s - 8.0).abs() < 1e-12);
        for (i, f) in walk.force_n().iter().enumerate() {
            let phase = 16.0 * i as f64 / walk.samples() as f64;
            assert!((f - force(phase)).abs() < 1e-9, "{i}");
        }
        let few = StepStatistics { strides: 7, ..even };
        assert!(Walk::generated(0.5, &few, force).is_none());
    }
}

//! Mean, duration and spread of a cycle of force.

use crate::force::ForceCurve;

/// Mean, duration, spread and noise of a cycle of force, without its samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanForce {
    /// Mean force, N, over one cycle.
    pub mean_n: f64,
    /// Duration of the cycle, s.
    pub period_s: f64,
    /// Root mean square of the step-to-step spread of the force, N; 0 if unknown.
    pub spread_n: f64,
    /// Root mean square of the sensor noise in the samples, N; 0 if unknown.
    pub noise_n: f64,
}

impl MeanForce {
    /// Mean, duration, spread and noise of a force curve.
    pub fn of(curve: &ForceCurve) -> MeanForce {
        MeanForce {
            mean_n: curve.mean_n(),
            period_s: curve.period_s,
            spread_n: curve.spread_rms_n().unwrap_or(0.0),
            noise_n: curve.noise_n.unwrap_or(0.0),
        }
    }

    /// Mean, duration, spread and noise of the force multiplied by `factor`.
    pub fn times(self, factor: f64) -> MeanForce {
        MeanForce {
            mean_n: factor * self.mean_n,
            spread_n: factor * self.spread_n,
            noise_n: factor * self.noise_n,
            ..self
        }
    }
}

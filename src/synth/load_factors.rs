//! Dynamic load factors, as codes for footbridges quote them: the harmonics of a force as parts of its mean.

use std::f64::consts::TAU;

use serde::Serialize;

use super::design::Design;

/// Harmonics that are quoted.
const HARMONICS: usize = 6;
/// Samples of a turn that the harmonics are taken from.
const SAMPLES: usize = 1024;

/// One harmonic of the target and of the achieved force: F = mean (1 + Σ αₖ sin(kθ − φₖ)).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LoadFactor {
    /// Number of the harmonic in a turn of the cam.
    pub harmonic: usize,
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// αₖ of the target.
    pub target: f64,
    /// φₖ of the target, rad.
    pub target_phase_rad: f64,
    /// αₖ of the achieved force.
    pub achieved: f64,
    /// φₖ of the achieved force, rad.
    pub achieved_phase_rad: f64,
}

impl Design {
    /// Harmonics 1 to 6 of target and achieved force as parts of the target's mean; empty where no force is wanted or
    /// its mean is not positive.
    pub fn load_factors(&self) -> Vec<LoadFactor> {
        let Some(target) = &self.target else {
            return Vec::new();
        };
        let mean = target.mean_n();
        if mean <= 0.0 || self.is_idle() {
            return Vec::new();
        }
        let achieved = self.drive.force_curve(self.pressing());
        let angles = || (0..SAMPLES).map(|i| TAU * i as f64 / SAMPLES as f64);
        let wanted: Vec<f64> = angles().map(|t| target.at(t)).collect();
        let given: Vec<f64> = angles().map(|t| achieved.eval(t)).collect();
        let turns_per_s = self.drive.speed.abs() / TAU;
        (1..=HARMONICS)
            .map(|k| {
                let (target, target_phase_rad) = harmonic(&wanted, k);
                let (achieved, achieved_phase_rad) = harmonic(&given, k);
                LoadFactor {
                    harmonic: k,
                    frequency_hz: k as f64 * turns_per_s,
                    target: target / mean,
                    target_phase_rad,
                    achieved: achieved / mean,
                    achieved_phase_rad,
                }
            })
            .collect()
    }
}

/// Amplitude and phase of a harmonic of one turn of samples: A sin(kθ − φ).
fn harmonic(samples: &[f64], k: usize) -> (f64, f64) {
    let n = samples.len() as f64;
    let step = TAU * k as f64 / n;
    let (mut sine, mut cosine) = (0.0, 0.0);
    for (i, f) in samples.iter().enumerate() {
        let angle = step * i as f64;
        sine += 2.0 / n * f * angle.sin();
        cosine += 2.0 / n * f * angle.cos();
    }
    (sine.hypot(cosine), (-cosine).atan2(sine))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_sum_gives_its_factors() {
        let force = |t: f64| 700.0 * (1.0 + 0.4 * t.sin() + 0.1 * (2.0 * t - 0.7).sin());
        let samples: Vec<f64> = (0..256)
            .map(|i| force(TAU * f64::from(i) / 256.0))
            .collect();
        let (first, second, third) = (
            harmonic(&samples, 1),
            harmonic(&samples, 2),
            harmonic(&samples, 3),
        );
        assert!((first.0 - 280.0).abs() < 1e-9 && first.1.abs() < 1e-9);
        assert!((second.0 - 70.0).abs() < 1e-9 && (second.1 - 0.7).abs() < 1e-9);
        assert!(third.0 < 1e-9);
    }
}

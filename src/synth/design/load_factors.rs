//! Dynamic load factors as in codes for footbridges: harmonics of the step frequency relative to the weight of the walker.

use std::f64::consts::TAU;

use serde::Serialize;

use super::Design;
use crate::poly::amplitudes;

/// Number of harmonics of the step frequency.
const HARMONICS: usize = 6;
/// Number of force samples per turn from which the harmonics are computed. For a force with jumps of its slope, the load factors are
/// accurate to 2e-5.
const SAMPLES: usize = 8192;
/// Number of samples of the target force if it is a load model, which has only a few harmonics.
const MODEL_SAMPLES: usize = 1024;
/// Load factor below which a harmonic counts as a rounding error. Its load factor and phase are then set to 0.
const ROUNDING: f64 = 1e-9;

/// One harmonic of the target and of the achieved force, F = F₀ + W Σ αₖ sin(kθ − φₖ), where W is the weight of the walker. Here the phase is
/// subtracted. In the key `gait.harmonics` it is added.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // Young (2001) at 1.85 Hz: α₁ = 0.37 (f − 0.95).
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let first = synthesise(&scene, scene.model_force()?.as_ref())?.load_factors()[0];
/// assert!((first.target - 0.37 * (1.85 - 0.95)).abs() < 1e-6);
/// assert!((first.frequency_hz - 1.85).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LoadFactor {
    /// Order of the harmonic with respect to one turn of the cam.
    pub harmonic: usize,
    /// Order of the harmonic with respect to the step frequency. If a turn is a stride of two steps, this order is half of `harmonic`.
    pub of_step: f64,
    /// Frequency of the load factor, Hz.
    pub frequency_hz: f64,
    /// Load factor αₖ of the target.
    pub target: f64,
    /// Phase φₖ of the target, rad; 0 if the harmonic is absent.
    pub target_phase_rad: f64,
    /// Load factor αₖ of the achieved force.
    pub achieved: f64,
    /// Phase φₖ of the achieved force, rad; 0 if the harmonic is absent.
    pub achieved_phase_rad: f64,
}

impl Design {
    /// Harmonics of target and achieved force, relative to the weight of the walker, up to six times the step frequency. The list is empty
    /// without a target force or without a positive weight.
    ///
    /// A turn of a recording, or of a load model of one foot, is a stride of two steps. A file that contains one cycle does not state whether it
    /// is a step or a stride. The cycle counts as a stride if the second harmonic of the target is larger than the first.
    pub fn load_factors(&self) -> Vec<LoadFactor> {
        let Some(target) = self.target_in_time() else {
            return Vec::new();
        };
        let weight = self.problem.weight_n.unwrap_or(target.mean_n());
        if weight <= 0.0 || self.is_idle() {
            return Vec::new();
        }
        let achieved = self.force_curve();
        let angles = || (0..SAMPLES).map(|i| TAU * i as f64 / SAMPLES as f64);
        let of = |samples: Vec<f64>| amplitudes(&samples);
        let wanted = if target.force_n.len() == MODEL_SAMPLES {
            amplitudes(&target.force_n)
        } else {
            of(angles().map(|t| target.at(t)).collect())
        };
        let given = of(angles().map(|t| achieved.eval(self.angle_at(t))).collect());
        let turns_per_s = self.problem.drive.speed.abs() / TAU;
        let stated = self.problem.steps_per_turn;
        let steps = stated.unwrap_or_else(|| steps_per_turn(&wanted));
        let part = |amplitudes: &[(f64, f64)], k: usize| {
            let (amplitude, phase) = harmonic(amplitudes, k);
            let part = amplitude / weight;
            if part < ROUNDING {
                (0.0, 0.0)
            } else {
                (part, phase)
            }
        };
        (1..=steps * HARMONICS)
            .map(|k| {
                let (target, target_phase_rad) = part(&wanted, k);
                let (achieved, achieved_phase_rad) = part(&given, k);
                LoadFactor {
                    harmonic: k,
                    of_step: k as f64 / steps as f64,
                    frequency_hz: k as f64 * turns_per_s,
                    target,
                    target_phase_rad,
                    achieved,
                    achieved_phase_rad,
                }
            })
            .collect()
    }
}

/// Number of steps in one turn of the force (1 or 2). If a turn contains two equal steps, its first harmonic is nearly zero.
fn steps_per_turn(amplitudes: &[(f64, f64)]) -> usize {
    if harmonic(amplitudes, 2).0 > harmonic(amplitudes, 1).0 {
        2
    } else {
        1
    }
}

/// Amplitude A and phase φ, rad, of the harmonic A sin(kθ − φ).
fn harmonic(amplitudes: &[(f64, f64)], k: usize) -> (f64, f64) {
    let (cosine, sine) = amplitudes[k];
    (libm::hypot(sine, cosine), libm::atan2(-cosine, sine))
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
        let found = amplitudes(&samples);
        let (first, second, third) = (
            harmonic(&found, 1),
            harmonic(&found, 2),
            harmonic(&found, 3),
        );
        assert!((first.0 - 280.0).abs() < 1e-9 && first.1.abs() < 1e-9);
        assert!((second.0 - 70.0).abs() < 1e-9 && (second.1 - 0.7).abs() < 1e-9);
        assert!(third.0 < 1e-9);
        assert_eq!(steps_per_turn(&found), 1);
        let stride: Vec<f64> = (0..256).map(|i| samples[2 * i % 256]).collect();
        assert_eq!(steps_per_turn(&amplitudes(&stride)), 2);
    }
}

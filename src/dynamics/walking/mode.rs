//! Mode of unit mass under a periodically repeated force. The natural frequency of the mode is varied about the step frequency.
//!
//! A force of period T has spectral lines at the frequencies k/T. Let Pₖ be the mean square of line k at ω = 2πk/T. A mode of angular
//! frequency ωₘ and damping ratio ζ has the mean square acceleration Σ Pₖ ω⁴/((ωₘ² − ω²)² + 4ζ²ωₘ²ω²) in steady vibration. No initial part
//! of the force is omitted, and no window function is applied.

use std::f64::consts::{PI, TAU};

use serde::Serialize;

use crate::force::Walk;
use crate::poly::amplitudes;

/// Number of equally spaced natural frequencies of the mode, and their range relative to the step frequency.
const TUNINGS: usize = 401;
const BAND: [f64; 2] = [0.9, 1.1];
/// Number of harmonics of the stride frequency. The response to higher harmonics is negligible.
const OF_STRIDE: usize = 48;

/// Spectral lines of a periodically repeated force.
///
/// ```
/// use gaitcam::dynamics::RepeatedForce;
///
/// // At resonance, a mode of 1 kg under 280 N·sin ωt has the acceleration amplitude 280/(2ζ). Its RMS value is smaller by the factor √2.
/// let wave = |i: u32| 700.0 + 280.0 * (2.0 * std::f64::consts::TAU * f64::from(i) / 64.0).sin();
/// let force = RepeatedForce::new(&(0..64).map(wave).collect::<Vec<_>>(), 1.0, 1);
/// let peak = force.peak(0.005);
/// assert!((peak / (280.0 / 0.01 / 2_f64.sqrt()) - 1.0).abs() < 1e-9);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RepeatedForce {
    /// Square of the angular frequency of each line, (rad/s)². `means` contains the mean square of the force of each line, N².
    squares: Vec<f64>,
    means: Vec<f64>,
    strides: usize,
    /// Step frequency of the walk, Hz.
    pub step_frequency_hz: f64,
}

impl RepeatedForce {
    /// Damping ratios for which modes are compared, typical of footbridges of steel, of composite decks and of concrete.
    pub const DAMPING_RATIOS: [f64; 3] = [0.003, 0.005, 0.01];

    /// Spectral lines of a force, N, that is given at equal steps of its duration, s. The duration contains `strides` strides of two steps.
    pub fn new(force: &[f64], duration_s: f64, strides: usize) -> RepeatedForce {
        let lines = amplitudes(force);
        let lines = lines.iter().enumerate().skip(1).take(OF_STRIDE * strides);
        let (squares, means) = lines
            .map(|(k, (a, b))| ((TAU * k as f64 / duration_s).powi(2), 0.5 * (a * a + b * b)))
            .unzip();
        RepeatedForce {
            squares,
            means,
            strides,
            step_frequency_hz: 2.0 * strides as f64 / duration_s,
        }
    }

    /// Spectral lines of the force of a recorded walk, repeated periodically.
    pub fn of(walk: &Walk) -> RepeatedForce {
        RepeatedForce::new(&walk.force_n(), walk.duration_s, walk.strides())
    }

    /// Natural frequencies of the mode, Hz: 401 equally spaced values from 0.9 to 1.1 times a step frequency.
    pub fn tunings(step_frequency_hz: f64) -> Vec<f64> {
        let part = |i: usize| i as f64 / (TUNINGS - 1) as f64;
        let at = |i: usize| step_frequency_hz * (BAND[0] + part(i) * (BAND[1] - BAND[0]));
        (0..TUNINGS).map(at).collect()
    }

    /// RMS acceleration, m/s², of a mode of 1 kg, at each of its natural frequencies about a step frequency, Hz
    /// ([`RepeatedForce::tunings`]).
    pub fn about(&self, step_frequency_hz: f64, damping_ratio: f64) -> Vec<f64> {
        let at = |frequency: f64| {
            let mode = TAU * frequency;
            let (own, damping) = (mode * mode, (2.0 * damping_ratio * mode).powi(2));
            let lines = self.squares.iter().zip(&self.means);
            let sum: f64 = lines
                .map(|(w, p)| p * w * w / ((own - w) * (own - w) + damping * w))
                .sum();
            sum.sqrt()
        };
        let tunings = RepeatedForce::tunings(step_frequency_hz);
        tunings.into_iter().map(at).collect()
    }

    /// RMS acceleration, m/s², of a mode of 1 kg, at each of its natural frequencies about the step frequency of this force.
    pub fn response(&self, damping_ratio: f64) -> Vec<f64> {
        self.about(self.step_frequency_hz, damping_ratio)
    }

    /// Maximum RMS acceleration, m/s², of a mode of 1 kg with a natural frequency from 0.9 to 1.1 times the step frequency.
    pub fn peak(&self, damping_ratio: f64) -> f64 {
        self.response(damping_ratio).into_iter().fold(0.0, f64::max)
    }

    /// Whether the spacing of the spectral lines is at most the bandwidth π ζ f of the mode: 2π ζ N ≥ 1 for N strides.
    pub fn resolves(&self, damping_ratio: f64) -> bool {
        self.strides >= RepeatedForce::strides_for(damping_ratio)
    }

    /// Minimum number of strides for which the spacing of the spectral lines is at most the bandwidth of a mode.
    pub fn strides_for(damping_ratio: f64) -> usize {
        (0.5 / (PI * damping_ratio)).ceil() as usize
    }

    /// Differences between the responses to this force and to another force, about the step frequency of this force, for every damping
    /// ratio.
    pub fn misfits(&self, other: &RepeatedForce) -> [Misfit; 3] {
        RepeatedForce::DAMPING_RATIOS.map(|damping_ratio| {
            let at = self.step_frequency_hz;
            let (own, its) = (
                self.about(at, damping_ratio),
                other.about(at, damping_ratio),
            );
            let logs = own.iter().zip(&its).map(|(a, b)| libm::log(b / a).abs());
            let peak = |of: &[f64]| of.iter().copied().fold(0.0, f64::max);
            Misfit {
                damping_ratio,
                misfit: logs.sum::<f64>() / TUNINGS as f64,
                peak_ratio: peak(&its) / peak(&own),
            }
        })
    }
}

/// Difference between the responses of a mode to two forces, about the step frequency of the first force.
///
/// ```
/// use gaitcam::dynamics::RepeatedForce;
///
/// // For a force twice as large, the response ratio is 2 at every natural frequency.
/// let wave = |size: f64| move |i: u32| size * (2.0 * std::f64::consts::TAU * f64::from(i) / 64.0).sin();
/// let [one, two] = [1.0, 2.0].map(|size| RepeatedForce::new(&(0..64).map(wave(size)).collect::<Vec<_>>(), 1.0, 1));
/// for of in one.misfits(&two) {
///     assert!((of.misfit - 2_f64.ln()).abs() < 1e-9 && (of.peak_ratio - 2.0).abs() < 1e-9);
/// }
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Misfit {
    /// Damping ratio of the mode, relative to critical damping.
    pub damping_ratio: f64,
    /// Mean of |ln(response ratio)| over natural frequencies from 0.9 to 1.1 times the step frequency.
    pub misfit: f64,
    /// Maximum response to the second force, relative to the maximum response to the first force.
    pub peak_ratio: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// RMS acceleration of a mode of 1 kg in the last repetition of a force that is linear between its samples. The integration uses the
    /// exact step of a linear oscillator.
    fn integrated(force: &[f64], duration_s: f64, mode_hz: f64, damping_ratio: f64) -> f64 {
        let (w, z) = (TAU * mode_hz, damping_ratio);
        let h = duration_s / force.len() as f64;
        let wd = w * (1.0 - z * z).sqrt();
        let (decay, (s, c)) = ((-z * w * h).exp(), (wd * h).sin_cos());
        // Under F = f + g t the particular motion is f/w² − 2ζg/w³ + g t/w².
        let (mut x, mut v) = (0.0, 0.0);
        let repeats = (3.0 / (z * w * duration_s)).ceil() as usize * 3;
        let (mut sum, mut count) = (0.0, 0);
        for repeat in 0..=repeats {
            for i in 0..force.len() {
                let (f, next) = (force[i], force[(i + 1) % force.len()]);
                let g = (next - f) / h;
                let rest = |t: f64| (f + g * t) / (w * w) - 2.0 * z * g / w.powi(3);
                let (a, b) = (x - rest(0.0), v - g / (w * w));
                let k = (b + z * w * a) / wd;
                x = decay * (a * c + k * s) + rest(h);
                v = decay * ((k * wd - z * w * a) * c - (a * wd + z * w * k) * s) + g / (w * w);
                if repeat == repeats {
                    sum += (next - 2.0 * z * w * v - w * w * x).powi(2);
                    count += 1;
                }
            }
        }
        (sum / count as f64).sqrt()
    }

    #[test]
    fn the_lines_give_what_direct_integration_gives() {
        // Twelve uneven strides of about 1.1 s.
        let strides = 12;
        let duration_s = 1.1 * strides as f64;
        let n = 512 * strides;
        let force: Vec<f64> = (0..n)
            .map(|i| {
                let x = TAU * i as f64 / n as f64;
                let walk = 2.0 * strides as f64 * x + 0.5 * (3.0 * x).sin() + 0.3 * (7.0 * x).cos();
                250.0 * (1.0 + 0.1 * (5.0 * x).cos()) * walk.sin() + 60.0 * (2.0 * walk).cos()
            })
            .collect();
        let lines = RepeatedForce::new(&force, duration_s, strides);
        for damping in RepeatedForce::DAMPING_RATIOS {
            let response = lines.response(damping);
            for i in [0, 100, 200, 230, 400] {
                let mode = lines.step_frequency_hz * (0.9 + 0.2 * i as f64 / 400.0);
                let direct = integrated(&force, duration_s, mode, damping);
                assert!(
                    (response[i] / direct - 1.0).abs() < 2e-3,
                    "{damping} {i}: {} {direct}",
                    response[i]
                );
            }
        }
        assert!(lines.resolves(0.02) && !lines.resolves(0.01));
    }
}

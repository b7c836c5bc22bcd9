//! A force given as a finite Fourier series. It is evaluated exactly, without interpolation between samples.

use std::f64::consts::TAU;

use super::{period, phases, title};
use crate::curve::ForceCurve;
use crate::error::{ForceError, Result};
use crate::quantity::seconds;
use crate::recording::Feet;

/// Force of both feet together as a Fourier series: F(t) = G (1 + Σ aᵢ sin(2π i f t + pᵢ)). G is the body weight, N, and f the step
/// frequency, Hz. aᵢ is the load factor and pᵢ the phase, rad, of harmonic i.
///
/// ```
/// use gaitcam_gait::{Feet, of_harmonics};
///
/// // 700 N with a harmonic of 40 %. Its maximum is a quarter of a step after heel strike.
/// let force = of_harmonics(&[(0.4, 0.0)], Some(2.0), 700.0, Feet::Both)?;
/// assert_eq!((force.mean_n(), force.period_s()), (700.0, 0.5));
/// assert_eq!(force.waves(), [(0.0, 280.0)]);
/// assert!((force.curve().range_n().1 - 980.0).abs() < 1e-9);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FourierForce {
    name: String,
    /// Load factor aᵢ and phase pᵢ, rad, of each harmonic.
    harmonics: Vec<(f64, f64)>,
    step_frequency_hz: f64,
    body_weight_n: f64,
    feet: Feet,
}

impl FourierForce {
    /// Creates the force from its Fourier coefficients at a step frequency, Hz.
    ///
    /// # Errors
    ///
    /// The period is not positive.
    pub(super) fn new(
        name: &str,
        harmonics: Vec<(f64, f64)>,
        step_frequency_hz: f64,
        body_weight_n: f64,
        feet: Feet,
    ) -> Result<FourierForce> {
        let out = FourierForce {
            name: name.to_string(),
            harmonics,
            step_frequency_hz,
            body_weight_n,
            feet,
        };
        if out.period_s().is_finite() && out.period_s() > 0.0 {
            return Ok(out);
        }
        let period = seconds(out.period_s());
        Err(ForceError::PeriodNotPositive { period }.into())
    }

    /// Mean force over a cycle, N.
    pub fn mean_n(&self) -> f64 {
        self.body_weight_n
    }

    /// Duration of one cycle, s.
    pub fn period_s(&self) -> f64 {
        period(self.step_frequency_hz, self.feet)
    }

    /// Amplitudes, N, of the cosine and the sine of the harmonics 1, 2, … of the cycle.
    pub fn waves(&self) -> Vec<(f64, f64)> {
        let wave = |&(a, p): &(f64, f64)| {
            let (sin, cos) = libm::sincos(p);
            let amplitude = a * self.body_weight_n;
            (amplitude * sin, amplitude * cos)
        };
        self.harmonics.iter().map(wave).collect()
    }

    /// The cycle as a curve of equally spaced samples.
    pub fn curve(&self) -> ForceCurve {
        let at = |x: f64| {
            let waves = self.harmonics.iter().zip(1..);
            let sum: f64 = waves
                .map(|(&(a, p), i)| a * libm::sin(TAU * f64::from(i) * x + p))
                .sum();
            (1.0 + sum) * self.body_weight_n
        };
        ForceCurve {
            name: title(
                &self.name,
                self.step_frequency_hz,
                self.body_weight_n,
                self.feet,
            ),
            period_s: self.period_s(),
            force_n: phases().map(at).collect(),
            spread_n: None,
            mass_kg: None,
            noise_n: None,
            walk: None,
            steps: None,
            notes: Vec::new(),
            recording: None,
            population: None,
        }
    }
}

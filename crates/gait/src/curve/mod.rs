//! One cycle of vertical force.

mod csv;
mod mot;
mod slopes;

use serde::{Serialize, Serializer};
use std::f64::consts::TAU;
use std::sync::Arc;

use slopes::{slope_at, slopes};

use crate::error::{ForceError, Result};
use crate::interpretation::Interpretation;
use crate::population::Population;
use crate::quantity::seconds;
use crate::recording::Note;
use crate::statistics::ends;
use crate::walk::Walk;

/// Number of samples in one cycle of a load model, and in a mean cycle.
pub const SAMPLES: usize = 1024;

/// One cycle of vertical force, sampled at equal steps of phase. It is periodic.
///
/// Sample `i` of `n` is at phase θ = 2π·i/n (heel strike at 0) and time `period_s`·i/n.
///
/// ```
/// use gaitcam_gait::ForceCurve;
///
/// // 500 N with a harmonic of 120 N, at equal steps of a cycle of 0.8 s.
/// let at = |i: u32| 500.0 + 120.0 * (std::f64::consts::TAU * f64::from(i) / 256.0).sin();
/// let force = ForceCurve::from_samples("a harmonic", 0.8, (0..256).map(at).collect())?;
/// assert!((force.mean_n() - 500.0).abs() < 1e-9);
/// assert!((force.range_n().1 - 620.0).abs() < 1e-6);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ForceCurve {
    /// Description of the curve for reports: "Young 2001, 1.85 Hz" or "walk1.forces, 3 strides".
    pub name: String,
    /// Duration of one cycle, s; positive.
    pub period_s: f64,
    /// Force at equal steps of phase, N; at least 4 samples, all finite.
    pub force_n: Vec<f64>,
    /// Step-to-step standard deviation at the same phases, N, if several cycles were averaged.
    pub spread_n: Option<Vec<f64>>,
    /// Mass of the walker, kg, if known.
    pub mass_kg: Option<f64>,
    /// Root mean square of the sensor noise that remains in the samples, N, if known.
    pub noise_n: Option<f64>,
    /// Consecutive strides of the recording as a force over time, scaled like the samples of the cycle. `None` for fewer than eight
    /// consecutive strides.
    #[serde(skip)]
    pub walk: Option<Walk>,
    /// Number of steps of a walker in the cycle, if the file gives it.
    #[serde(skip)]
    pub steps: Option<usize>,
    /// Notes on the reading of a file that contains one cycle or a part of a cycle.
    #[serde(skip)]
    pub notes: Vec<Note>,
    /// Interpretation of the recording from which the cycle was averaged.
    #[serde(serialize_with = "interpretation")]
    pub recording: Option<Arc<Interpretation>>,
    /// Walkers from whose cycles the curve was averaged; `None` if the curve does not belong to a population.
    #[serde(skip)]
    pub population: Option<Arc<Population>>,
}

/// Serialises the interpretation as the JSON of [`Interpretation::json`].
fn interpretation<S: Serializer>(
    recording: &Option<Arc<Interpretation>>,
    serializer: S,
) -> std::result::Result<S::Ok, S::Error> {
    recording.as_ref().map(|r| r.json()).serialize(serializer)
}

impl ForceCurve {
    /// Creates a curve from samples of one cycle at equal phases. The first sample is not repeated at the end.
    ///
    /// # Errors
    ///
    /// Fewer than 4 samples; a value that is not finite; a period that is not positive.
    pub fn from_samples(name: &str, period_s: f64, force_n: Vec<f64>) -> Result<Self> {
        if force_n.len() < 4 {
            let samples = force_n.len();
            return Err(ForceError::FewSamples { samples }.into());
        }
        if let Some(i) = force_n.iter().position(|f| !f.is_finite()) {
            return Err(ForceError::SampleNotFinite { sample: i }.into());
        }
        if !(period_s.is_finite() && period_s > 0.0) {
            let period = seconds(period_s);
            return Err(ForceError::PeriodNotPositive { period }.into());
        }
        Ok(ForceCurve {
            name: name.to_string(),
            period_s,
            force_n,
            spread_n: None,
            mass_kg: None,
            noise_n: None,
            walk: None,
            steps: None,
            notes: Vec::new(),
            recording: None,
            population: None,
        })
    }

    /// Mean force over the cycle, N.
    pub fn mean_n(&self) -> f64 {
        // Eight partial sums, because a processor can compute independent sums at the same time.
        let mut sums = [0.0; 8];
        let eights = self.force_n.chunks_exact(8);
        let rest: f64 = eights.remainder().iter().sum();
        for eight in eights {
            for (sum, f) in sums.iter_mut().zip(eight) {
                *sum += f;
            }
        }
        (sums.iter().sum::<f64>() + rest) / self.force_n.len() as f64
    }
}

impl ForceCurve {
    /// Notes on the recording, except the notes on mean force and mass, which change when the curve is scaled.
    pub fn warnings(&self) -> impl Iterator<Item = &Note> {
        let on_mass = |n: &Note| {
            matches!(
                n,
                Note::MeanForceNotWeight { .. } | Note::MassImplausible { .. }
            )
        };
        let all = self.recording.iter().flat_map(|r| &r.warnings);
        all.filter(move |n| !on_mass(n))
    }

    /// Minimum and maximum sample, N.
    pub fn range_n(&self) -> (f64, f64) {
        ends(&self.force_n).unwrap_or_default()
    }

    /// Force, N, at the phase `theta`, rad, which may be in any turn. It is computed by cubic interpolation without overshoot.
    pub fn at(&self, theta: f64) -> f64 {
        let n = self.force_n.len();
        let x = (theta / TAU).rem_euclid(1.0) * n as f64;
        let i = (x as usize).min(n - 1);
        let u = x - i as f64;
        let v = 1.0 - u;
        // Bernstein coefficients of the Hermite cubic.
        let (first, last) = (self.force_n[i], self.force_n[(i + 1) % n]);
        let rising = first + 1.0 / 3.0 * slope_at(&self.force_n, i);
        let falling = last - 1.0 / 3.0 * slope_at(&self.force_n, i + 1);
        ((first * v + u * 3.0 * rising) * v + u * u * 3.0 * falling) * v + u * u * u * last
    }

    /// Slopes of the interpolating cubics at every sample and at the end of the cycle, N per sample.
    pub fn slopes(&self) -> Vec<f64> {
        slopes(&self.force_n)
    }

    /// Step-to-step standard deviation, N, as root mean square over the cycle; `None` if it is unknown.
    pub fn spread_rms_n(&self) -> Option<f64> {
        let s = self.spread_n.as_ref()?;
        Some((s.iter().map(|x| x * x).sum::<f64>() / s.len().max(1) as f64).sqrt())
    }

    /// The curve with every force multiplied by `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let times = |x: &Vec<f64>| x.iter().map(|f| f * factor).collect();
        ForceCurve {
            force_n: times(&self.force_n),
            spread_n: self.spread_n.as_ref().map(times),
            noise_n: self.noise_n.map(|noise| noise * factor.abs()),
            walk: self.walk.clone().map(|w| w.scaled(factor)),
            ..self.clone()
        }
    }

    /// The cycle with another start. Sample 0 of the result is the force at `phase`, rad.
    #[must_use]
    pub fn begun_at(&self, phase: f64) -> Self {
        let n = self.force_n.len();
        let moved = |curve: &Self| {
            (0..n)
                .map(|i| curve.at(phase + TAU * i as f64 / n as f64))
                .collect()
        };
        let spread_n = self
            .spread_n
            .as_ref()
            .map(|s| moved(&self.with_forces(s.clone())));
        ForceCurve {
            force_n: moved(self),
            spread_n,
            ..self.clone()
        }
    }

    /// The cycle with other forces, N, one per sample.
    #[must_use]
    pub fn with_forces(&self, force_n: Vec<f64>) -> Self {
        ForceCurve {
            force_n,
            spread_n: None,
            ..self.clone()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scaled_force_has_its_spread_and_noise_scaled_too() {
        let mut curve =
            ForceCurve::from_samples("test", 0.5, vec![700.0, 800.0, 700.0, 600.0]).unwrap();
        curve.spread_n = Some(vec![10.0; 4]);
        curve.noise_n = Some(4.0);
        let scaled = curve.scaled(1.5);
        assert_eq!(scaled.force_n, [1050.0, 1200.0, 1050.0, 900.0]);
        assert_eq!(scaled.spread_n, Some(vec![15.0; 4]));
        assert_eq!(scaled.noise_n, Some(6.0));
    }

    #[test]
    fn smooth_curves_are_interpolated_to_third_order_or_better() {
        let f = |x: f64| 700.0 + 250.0 * x.sin() + 40.0 * (3.0 * x).cos();
        let worst = |n: usize| {
            let samples = (0..n).map(|i| f(TAU * i as f64 / n as f64)).collect();
            let curve = ForceCurve::from_samples("test", 0.5, samples).unwrap();
            (0..5000)
                .map(|i| TAU * f64::from(i) / 5000.0)
                .fold(0.0_f64, |m, x| m.max((curve.at(x) - f(x)).abs()))
        };
        let (coarse, fine) = (worst(128), worst(1024));
        assert!(fine < 2e-4 && fine < coarse / 60.0, "{coarse} {fine}");
    }

    /// Error of the cubics for a sum of harmonics: n⁴h⁴/384 of each harmonic n with h = 2π/1024, plus the fifth-order error of the slopes.
    /// It is the same at a maximum as elsewhere.
    #[test]
    fn sums_of_harmonics_are_interpolated_to_fourth_order() {
        let (mut worst, mut cases) = (0.0_f64, 0);
        for case in 0..100_u32 {
            let waves: Vec<(f64, f64, f64)> = (1..=1 + case % 6)
                .map(|n| {
                    (
                        f64::from(n),
                        f64::from(7 * n * n + case).sin(),
                        f64::from(case * n),
                    )
                })
                .collect();
            let bound: f64 = waves.iter().map(|(n, a, _)| a.abs() * n.powi(4)).sum();
            let f = |x: f64| {
                waves
                    .iter()
                    .map(|(n, a, p)| a * (n * x + p).sin())
                    .sum::<f64>()
            };
            let samples = (0..1024).map(|i| f(TAU * f64::from(i) / 1024.0)).collect();
            let curve = ForceCurve::from_samples("harmonics", 1.0, samples).unwrap();
            for i in 0..7000 {
                let x = TAU * f64::from(i) / 7000.0;
                worst = worst.max((curve.at(x) - f(x)).abs() / bound);
                cases += 1;
            }
        }
        let h = TAU / 1024.0;
        assert!(worst < 2.0 * h.powi(4) / 384.0, "{worst} of {cases}");
    }

    #[test]
    fn a_cycle_begun_elsewhere_is_the_same_cycle() {
        let samples = (0..200)
            .map(|i| 700.0 + 250.0 * (TAU * f64::from(i) / 200.0).sin())
            .collect();
        let mut curve = ForceCurve::from_samples("test", 0.5, samples).unwrap();
        curve.spread_n = Some((0..200).map(f64::from).collect());
        // A quarter turn is fifty samples.
        let moved = curve.begun_at(TAU / 4.0);
        for i in 0..200 {
            assert!((moved.force_n[i] - curve.force_n[(i + 50) % 200]).abs() < 1e-9);
        }
        assert!((moved.spread_n.unwrap()[0] - 50.0).abs() < 1e-9);
        let there_and_back = curve.begun_at(0.3).begun_at(-0.3);
        for (a, b) in there_and_back.force_n.iter().zip(&curve.force_n) {
            // Third order at a crest: 2e-4 N at 1024 samples (above) are 0.027 N at 200.
            assert!((a - b).abs() < 0.03, "{a} {b}");
        }
    }

    #[test]
    fn a_step_is_not_overshot() {
        let samples = (0..40)
            .map(|i| if (10..30).contains(&i) { 800.0 } else { 0.0 })
            .collect();
        let curve = ForceCurve::from_samples("step", 1.0, samples).unwrap();
        let values = (0..5000).map(|i| curve.at(TAU * f64::from(i) / 5000.0));
        let (low, high) = values.fold((800.0_f64, 0.0_f64), |(l, h), f| (l.min(f), h.max(f)));
        assert!(low >= 0.0 && high <= 800.0 + 1e-9, "{low} {high}");
    }

    #[test]
    fn impossible_cycles_are_refused() {
        assert!(ForceCurve::from_samples("x", 1.0, vec![1.0]).is_err());
        assert!(ForceCurve::from_samples("x", 0.0, vec![1.0; 8]).is_err());
        assert!(ForceCurve::from_samples("x", 1.0, vec![1.0, f64::NAN, 1.0, 1.0]).is_err());
    }
}

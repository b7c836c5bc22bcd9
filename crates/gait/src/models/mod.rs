//! Published models of the vertical walking force.
//!
//! There are two families of models:
//!
//! - The *continuous* models describe the force of both feet together: `F(t) = G (1 + Σ aᵢ sin(2π i f t + pᵢ))`. This is a Fourier series
//!   with the body weight G, the step frequency f, the load factors aᵢ and the phases pᵢ. One cycle is one step, with the duration 1/f.
//! - The *single-foot* models describe one stance. One cycle is one stride, with the duration 2/f and zero force in the swing phase. The
//!   force of both feet is the sum of two stances half a stride apart. Its period is one step.

mod catalogue;
mod continuous;
mod fourier;
mod single_foot;

use catalogue::CATALOGUE;
use continuous::harmonics;
use single_foot::single_foot;

use crate::curve::{ForceCurve, SAMPLES};
use crate::error::{ForceError, Result, nearest};
use crate::quantity::{hertz, newtons};
use crate::recording::Feet;

pub use catalogue::{ModelInfo, Status, catalogue};
pub use fourier::FourierForce;

/// One cycle of the load model with a given name.
///
/// `step_frequency_hz` may be omitted only for `iso-22675`. `body_weight_n` is the weight G, N (for `iso-22675` the load F1cmax).
/// Continuous models exist only for both feet. For a single-foot model, the curve is the same for the left, the right and one foot.
///
/// # Errors
///
/// The name is unknown; the frequency is missing or outside the range of the model; the weight is not positive; one foot is requested from
/// a continuous model.
pub fn model(
    name: &str,
    step_frequency_hz: Option<f64>,
    body_weight_n: f64,
    feet: Feet,
) -> Result<ForceCurve> {
    if let Some(series) = series(name, step_frequency_hz, body_weight_n, feet)? {
        return Ok(series.curve());
    }
    let info = find(name)?;
    let f = frequency(info, step_frequency_hz)?;
    let shape = single_foot(info.name, f, feet);
    let force = shape.iter().map(|w| w * body_weight_n).collect();
    let title = title(info.name, f, body_weight_n, feet);
    ForceCurve::from_samples(&title, period(f, feet), force)
}

/// Fourier series of a load model of both feet together; `None` for models of one foot, which have no finite series.
///
/// # Errors
///
/// The errors of [`model`].
pub fn series(
    name: &str,
    step_frequency_hz: Option<f64>,
    body_weight_n: f64,
    feet: Feet,
) -> Result<Option<FourierForce>> {
    let info = find(name)?;
    check_weight(body_weight_n)?;
    let f = frequency(info, step_frequency_hz)?;
    if info.single_foot {
        return Ok(None);
    }
    if feet.share() < 1.0 {
        let model = info.name.to_string();
        return Err(ForceError::BothFeetOnly { model }.into());
    }
    let harmonics = harmonics(info.name, f);
    FourierForce::new(info.name, harmonics, f, body_weight_n, feet).map(Some)
}

/// One cycle of a force of both feet with given load factors: F(t) = G (1 + Σ aᵢ sin(2π i f t + pᵢ)). G is the body weight, N, and f the
/// step frequency, Hz.
///
/// Each of the harmonics 1, 2, … has a pair (aᵢ, pᵢ) of load factor and phase, rad.
///
/// # Errors
///
/// There is no step frequency; one foot is requested; a frequency or a weight is not positive.
pub fn of_harmonics(
    harmonics: &[(f64, f64)],
    step_frequency_hz: Option<f64>,
    body_weight_n: f64,
    feet: Feet,
) -> Result<FourierForce> {
    check_weight(body_weight_n)?;
    let model = || OWN.to_string();
    let f = step_frequency_hz.ok_or_else(|| ForceError::FrequencyMissing { model: model() })?;
    if feet.share() < 1.0 {
        return Err(ForceError::BothFeetOnly { model: model() }.into());
    }
    FourierForce::new(OWN, harmonics.to_vec(), f, body_weight_n, feet)
}

fn check_weight(body_weight_n: f64) -> Result<()> {
    if body_weight_n.is_finite() && body_weight_n > 0.0 {
        return Ok(());
    }
    let weight = newtons(body_weight_n);
    Err(ForceError::WeightNotPositive { weight }.into())
}

/// Relative tolerance for frequencies at the ends of the range of a model, because of rounding errors.
const ROUNDING: f64 = 1e-9;

/// Name of a force whose load factors are given in the scene instead of being taken from a published model.
const OWN: &str = "gait.harmonics";

/// Duration of a cycle, s. A cycle of both feet is one step. A cycle of one foot is a stride of two steps.
fn period(f: f64, feet: Feet) -> f64 {
    let steps = 1.0 / feet.share();
    steps / f
}

/// Title of a cycle, which contains the key of the model and does not depend on the language.
fn title(name: &str, f: f64, body_weight_n: f64, feet: Feet) -> String {
    let feet = feet.name();
    format!("{name} {f} Hz, {body_weight_n} N, feet = \"{feet}\"")
}

fn find(name: &str) -> Result<&'static ModelInfo> {
    let plain = name.trim().to_lowercase().replace([' ', '_'], "-");
    CATALOGUE.iter().find(|m| m.name == plain).ok_or_else(|| {
        let names = CATALOGUE.iter().map(|m| m.name);
        let name = name.to_string();
        match nearest(&plain, names.clone()) {
            Some(near) => ForceError::MisspeltModel {
                name,
                near: near.to_string(),
            },
            None => ForceError::UnknownModel {
                name,
                known: names.collect::<Vec<_>>().join(", "),
            },
        }
        .into()
    })
}

fn frequency(info: &ModelInfo, given: Option<f64>) -> Result<f64> {
    let (low, high) = info.frequency_hz;
    match given {
        Some(f) if f >= low * (1.0 - ROUNDING) && f <= high * (1.0 + ROUNDING) => Ok(f),
        Some(f) => Err(ForceError::FrequencyOutOfRange {
            model: info.name.to_string(),
            frequency: hertz(f),
            low: hertz(low),
            high: hertz(high),
        }
        .into()),
        None if info.name == "iso-22675" => Ok(2.0),
        None => Err(ForceError::FrequencyMissing {
            model: info.name.to_string(),
        }
        .into()),
    }
}

/// Phases of the samples of a cycle, as fractions.
fn phases() -> impl Iterator<Item = f64> {
    (0..SAMPLES).map(|i| i as f64 / SAMPLES as f64)
}

#[cfg(test)]
mod tests {
    use super::single_foot::{iso_22675, li_2010};
    use super::*;
    use std::f64::consts::{PI, TAU};

    /// Local extrema of a sampled stance, in order: fraction of the stance, value.
    fn turning_points(stance: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        let n = 20_000;
        let y: Vec<f64> = (0..=n)
            .map(|i| stance(f64::from(i) / f64::from(n)))
            .collect();
        let turns = |w: &[f64]| (w[1] - w[0]) * (w[2] - w[1]) < 0.0;
        y.windows(3)
            .enumerate()
            .filter(|(_, w)| turns(w))
            .map(|(i, w)| ((i as f64 + 1.0) / f64::from(n), w[1]))
            .collect()
    }

    fn is_near(got: (f64, f64), at: f64, value: f64) -> bool {
        (got.0 - at).abs() < 0.006 && (got.1 - value).abs() < 0.0006
    }

    #[test]
    fn li_2010_meets_its_landmarks_and_carries_the_body() {
        // theory §12: at 1.9 Hz P1 1.139 @22 %, V 0.669 @49 %, P2 0.980 @74 %.
        let p = turning_points(|x| li_2010(1.9, x / (0.76 * 1.9)));
        assert!(is_near(p[0], 0.22, 1.139), "{p:?}");
        assert!(is_near(p[1], 0.49, 0.669), "{p:?}");
        assert!(is_near(p[2], 0.74, 0.980), "{p:?}");
        // Mean of the sine series over a stance, in closed form: even waves vanish, odd ones give
        // 2/(n pi). Two feet: 1.015 body weights at 1.6 Hz, 1.027 at 2.2 Hz. (theory §12 says
        // 1.005-1.017, which is the sum of 101 samples divided by 101 instead of 100.)
        for f in [1.6, 1.75, 1.9, 2.05, 2.2] {
            let odd =
                (1.211 - 0.0698 * f) + (0.3002 * f - 0.1534) / 3.0 + (0.0608 - 0.0275 * f) / 5.0;
            let mean = model("li-2010", Some(f), 1.0, Feet::Both).unwrap().mean_n();
            assert!(
                (mean - odd * 2.0 / (PI * 0.76)).abs() < 1e-5,
                "{f} Hz: {mean}"
            );
            assert!(
                (1.0045..1.0175).contains(&(mean * 100.0 / 101.0)),
                "{f} Hz: {mean}"
            );
        }
    }

    #[test]
    fn iso_22675_meets_its_landmarks() {
        // theory §12: 1.000 at 151 ms, 0.668 at 300 ms, 0.987 at 447 ms, 0 at 0 and 600 ms.
        let p = turning_points(|x| iso_22675(0.6 * x));
        assert!(is_near(p[0], 151.0 / 600.0, 1.0), "{p:?}");
        assert!(is_near(p[1], 300.0 / 600.0, 0.668), "{p:?}");
        assert!(is_near(p[2], 447.0 / 600.0, 0.987), "{p:?}");
        assert_eq!(iso_22675(0.0), 0.0);
        assert!(iso_22675(0.6).abs() < 1e-3);
        let one = model("iso-22675", None, 1000.0, Feet::One).unwrap();
        assert_eq!(one.period_s, 1.0);
        assert_eq!(one.force_n[SAMPLES * 7 / 10], 0.0);
    }

    #[test]
    fn young_at_185_hz_asks_for_a_stroke_of_49_2_mm() {
        // theory §1: d'' = g Σ aᵢ sin(i w t + pᵢ) integrates to d = -g Σ aᵢ/(i w)² sin(i w t + pᵢ).
        // Only harmonics that crest together give the 49.2 mm; in sine phase it would be 47.6 mm.
        let h = harmonics("young", 1.85);
        let w = TAU * 1.85;
        let d = |x: f64| -> f64 {
            let waves = h.iter().zip(1..);
            waves
                .map(|(&(a, p), i)| {
                    let i = f64::from(i);
                    -9.81 * a / (i * w).powi(2) * (TAU * i * x + p).sin()
                })
                .sum()
        };
        let all: Vec<f64> = (0..100_000).map(|i| d(f64::from(i) / 1e5)).collect();
        let high = all.iter().fold(f64::MIN, |a, &b| a.max(b));
        let low = all.iter().fold(f64::MAX, |a, &b| a.min(b));
        assert!((1e3 * (high - low) - 49.2).abs() < 0.05, "{}", high - low);
    }

    #[test]
    fn coefficients_are_the_published_ones_at_two_hertz() {
        // theory §12 evaluated by hand at f = 2 Hz.
        let a = |name| -> Vec<f64> { harmonics(name, 2.0).iter().map(|h| h.0).collect() };
        let expect: &[(&str, &[f64])] = &[
            ("blanchard", &[0.2571428571]),
            ("bachmann", &[0.4, 0.1, 0.1]),
            ("setra", &[0.4, 0.1, 0.1]),
            ("rebelo", &[0.48, 0.175, 0.1]),
            ("kerr", &[0.4051, 0.07, 0.05]),
            ("young", &[0.3885, 0.0716, 0.056, 0.0508]),
            ("young-design", &[0.4305, 0.0914, 0.0714, 0.065]),
            ("sci-p354", &[0.4578, 0.0978, 0.0784, 0.07]),
            ("iso-10137", &[0.37, 0.1, 0.06, 0.06, 0.06]),
        ];
        for (name, wanted) in expect {
            let got = a(name);
            assert_eq!(got.len(), wanted.len(), "{name}");
            for (g, w) in got.iter().zip(*wanted) {
                assert!((g - w).abs() < 1e-9, "{name}: {got:?}");
            }
        }
        assert!((harmonics("bachmann", 2.4)[0].0 - 0.5).abs() < 1e-12);
    }

    #[test]
    fn every_continuous_model_has_the_body_weight_as_its_mean() {
        for m in catalogue().iter().filter(|m| !m.single_foot) {
            let c = model(m.name, Some(2.0), 700.0, Feet::Both).unwrap();
            assert!((c.mean_n() - 700.0).abs() < 1e-9, "{}", m.name);
            assert_eq!(c.period_s, 0.5);
        }
    }

    #[test]
    fn two_single_feet_half_a_stride_apart_make_the_sum() {
        let one = model("li-2010", Some(1.9), 700.0, Feet::One).unwrap();
        let both = model("li-2010", Some(1.9), 700.0, Feet::Both).unwrap();
        assert!((one.period_s - 2.0 * both.period_s).abs() < 1e-15);
        for i in 0..SAMPLES / 2 {
            let sum = one.force_n[i] + one.force_n[i + SAMPLES / 2];
            assert!((both.force_n[2 * i] - sum).abs() < 1e-9);
        }
    }

    #[test]
    fn wrong_names_frequencies_and_feet_are_refused() {
        let kind = |n, f, g, feet| {
            let error = model(n, f, g, feet).unwrap_err();
            error
                .fault::<ForceError>()
                .cloned()
                .expect("a fault of the model")
        };
        let both = |n, f, g| kind(n, f, g, Feet::Both);
        assert!(matches!(
            both("yuong", Some(1.85), 700.0),
            ForceError::MisspeltModel { near, .. } if near == "young"
        ));
        assert!(matches!(
            both("zzzzzzzz", Some(1.85), 700.0),
            ForceError::UnknownModel { .. }
        ));
        assert!(matches!(
            both("young", None, 700.0),
            ForceError::FrequencyMissing { .. }
        ));
        for f in [0.1, f64::NAN] {
            assert!(matches!(
                both("young", Some(f), 700.0),
                ForceError::FrequencyOutOfRange { low, .. } if low.value == 1.0
            ));
        }
        assert!(matches!(
            both("young", Some(1.85), 0.0),
            ForceError::WeightNotPositive { .. }
        ));
        assert!(matches!(
            kind("setra", Some(2.0), 700.0, Feet::Left),
            ForceError::BothFeetOnly { .. }
        ));
    }
}

//! The spectral tier for many scenes of one force shape, without solving anything twice.
//!
//! A harmonic law gives the force of its harmonics exactly, so its error depends on the shape alone. Where
//! the drive is pure inertia or pure spring, the law itself is one fixed curve times a factor: all extremes
//! of lift, velocity, acceleration, jerk, force and flat-face curvature are those of the fixed curve, scaled.
//! They are taken once, by the same exact roots as in a single synthesis.

use std::f64::consts::TAU;
use std::sync::OnceLock;

use crate::gait::ForceCurve;
use crate::law::Law;
use crate::poly::PiecewisePoly;

/// Most harmonics that an automatic count takes.
const MOST_AUTO: usize = 60;
/// A remainder this near to what is asked (as part of the whole power) leaves the count to the solver.
const UNDECIDED: f64 = 1e-10;

/// One turn of force with what can be said of it before a scene is known.
pub struct Shape {
    /// The force at its own scale.
    pub curve: ForceCurve,
    /// Mean of its samples, N.
    pub mean: f64,
    /// (cosine, sine) of harmonics 1, 2, …
    spectrum: Vec<(f64, f64)>,
    /// Power that is left above each count of harmonics, subtracted one by one.
    fits: Vec<OnceLock<Fit>>,
}

/// Smallest and largest value.
pub type Range = (f64, f64);

/// A fixed curve in the law's derivatives by the cam angle, and the minimum of s + a.
#[derive(Debug, Clone, Copy)]
pub struct Unit {
    /// s, v, a, j.
    pub ranges: [Range; 4],
    /// Least s + a.
    pub bend: f64,
}

/// What a count of harmonics gives.
pub struct Fit {
    /// Range of the force's harmonics without the mean, N.
    pub force: Range,
    /// Range of the difference to the target, both without their mean, N.
    pub error: Range,
    /// Its mean, N, and mean square, N².
    pub error_mean: f64,
    /// Mean square of the difference, N².
    pub error_square: f64,
    /// The law for m ω² = 1 and no spring.
    pub inertia: Unit,
    /// The law for k = 1 without mass and damping.
    pub spring: Unit,
}

impl Shape {
    /// Takes the curve apart; `None` for a curve whose spectrum cannot be had.
    pub fn new(curve: ForceCurve) -> Option<Shape> {
        let n = curve.force_n.len();
        let fft = realfft::RealFftPlanner::<f64>::new().plan_fft_forward(n);
        let mut output = fft.make_output_vec();
        fft.process(&mut curve.force_n.clone(), &mut output).ok()?;
        let scale = 2.0 / n as f64;
        let most = (n - 1) / 2;
        let spectrum: Vec<(f64, f64)> = output[1..=most]
            .iter()
            .map(|c| (c.re * scale, -c.im * scale))
            .collect();
        Some(Shape {
            mean: curve.mean_n(),
            fits: (0..=most).map(|_| OnceLock::new()).collect(),
            spectrum,
            curve,
        })
    }

    /// Fewest harmonics whose remainder is at most `wanted` newtons RMS (at the shape's own scale);
    /// `None` where rounding would decide.
    pub fn count(&self, wanted: f64) -> Option<usize> {
        let most = self.spectrum.len();
        let power = |h: usize| 0.5 * (self.spectrum[h].0.powi(2) + self.spectrum[h].1.powi(2));
        let all: f64 = (0..most).map(power).sum();
        let (mut left, mut count) = (all, 0);
        while count < most.min(MOST_AUTO) {
            if (left - wanted * wanted).abs() <= UNDECIDED * all {
                return None;
            }
            if left.max(0.0).sqrt() <= wanted {
                break;
            }
            left -= power(count);
            count += 1;
        }
        Some(count.max(1))
    }

    /// Most harmonics that the samples hold.
    pub fn most(&self) -> usize {
        self.spectrum.len()
    }

    /// What `count` harmonics give; `count` is from 1 to [`Shape::most`].
    pub fn fit(&self, count: usize) -> &Fit {
        self.fits[count].get_or_init(|| self.make_fit(count))
    }

    fn make_fit(&self, count: usize) -> Fit {
        let harmonics = &self.spectrum[..count];
        let force = Law::harmonic(0.0, harmonics);
        let wave = force.combination([1.0, 0.0, 0.0, 0.0], 0.0);
        let (low, high) = wave.extremes();
        let target = self.curve.curve();
        let error = difference(&wave, &target, self.mean);
        let (least, most) = error.extremes();
        let divided = |by: fn(f64) -> f64| -> Vec<(f64, f64)> {
            let terms = harmonics.iter().zip(1..);
            terms
                .map(|(&(a, b), n)| (a / by(f64::from(n)), b / by(f64::from(n))))
                .collect()
        };
        Fit {
            force: (low.value, high.value),
            error: (least.value, most.value),
            error_mean: error.integral() / TAU,
            error_square: error.integral_of_square() / TAU,
            inertia: Unit::of(&Law::harmonic(0.0, &divided(|n| -n * n))),
            spring: Unit::of(&Law::harmonic(0.0, &divided(|_| 1.0))),
        }
    }
}

/// wave − (target − mean), on the pieces of both.
fn difference(wave: &PiecewisePoly, target: &PiecewisePoly, mean: f64) -> PiecewisePoly {
    let own = wave.cut_at(target.breaks());
    let target = target.cut_at(own.breaks());
    PiecewisePoly::combine(&[(1.0, &own), (-1.0, &target)], mean)
}

impl Unit {
    fn of(law: &Law) -> Unit {
        let ranges = [0, 1, 2, 3].map(|order| {
            let (low, high) = law.extremes(order);
            (low.value, high.value)
        });
        let (bend, _) = law.combination([1.0, 0.0, 1.0, 0.0], 0.0).extremes();
        Unit {
            ranges,
            bend: bend.value,
        }
    }
}

//! The harmonics of a force, and the figures of laws of its first harmonics, each computed once.

use std::sync::{Arc, OnceLock};

use super::limited_slopes::LimitedSlopes;
use super::{MOST_AUTO, Range};
use crate::force::ForceCurve;
use crate::law::Law;
use crate::poly::{PiecewisePoly, amplitudes, harmonic_extremes, harmonic_values};
use crate::problem::piecewise;

/// Where the remainder is this near to the required one (relative to the whole power), the solver decides the count.
const UNDECIDED: f64 = 1e-10;

/// One turn of force with everything about it that depends on no scene.
pub struct HarmonicTarget {
    /// Mean of its samples, N.
    pub mean: f64,
    /// Duration of a cycle, s.
    pub period_s: f64,
    /// (cosine, sine) of harmonics 1, 2, …; further ones are zero.
    spectrum: Vec<(f64, f64)>,
    /// Harmonics that the samples hold.
    most: usize,
    /// What its samples' interpolation adds to the harmonics.
    interpolation: Interpolation,
    fits: Vec<OnceLock<Box<Fit>>>,
}

enum Interpolation {
    /// Any samples.
    Curve(ForceCurve),
    /// Samples of the harmonics themselves.
    Limited(LimitedSlopes),
}

/// Ranges of a law's derivatives by the cam angle, the minimum of s + a, and the torque of its force.
#[derive(Debug, Clone, Copy)]
pub struct LawRanges {
    /// s, v, a, j.
    pub svaj: [Range; 4],
    /// Least s + a.
    pub bend: f64,
    /// F·v with the force that the law was made for.
    pub torque: Torque,
}

/// Range and mean square of a torque F·v.
#[derive(Debug, Clone, Copy)]
pub struct Torque {
    /// Smallest and largest.
    pub range: Range,
    /// Mean.
    pub mean: f64,
    /// Mean square.
    pub square: f64,
}

/// (cosine, sine) of harmonics 1, 2, …
pub type Terms = Vec<(f64, f64)>;

/// What a count of harmonics gives.
pub struct Fit {
    harmonics: Vec<(f64, f64)>,
    /// Mean of the target, N.
    mean: f64,
    /// Range of the force's harmonics without the mean, N.
    pub force: Range,
    /// Range of the difference to the target, both without their mean, N.
    pub error: Range,
    /// Its mean, N.
    pub error_mean: f64,
    /// Mean square of the difference, N².
    pub error_square: f64,
    inertia: OnceLock<LawRanges>,
    spring: OnceLock<LawRanges>,
    inertia_grid: OnceLock<Arc<Vec<(f64, f64)>>>,
    spring_grid: OnceLock<Arc<Vec<(f64, f64)>>>,
}

impl HarmonicTarget {
    /// Takes the curve apart; `None` for a curve whose spectrum cannot be had.
    pub fn of_curve(curve: ForceCurve) -> Option<HarmonicTarget> {
        let most = (curve.force_n.len() - 1) / 2;
        let spectrum = amplitudes(&curve.force_n)[1..=most].to_vec();
        Some(HarmonicTarget {
            mean: curve.mean_n(),
            period_s: curve.period_s,
            fits: fits(spectrum.len()),
            most,
            spectrum,
            interpolation: Interpolation::Curve(curve),
        })
    }

    /// The curve that it was taken from, where it was one.
    pub fn curve(&self) -> Option<&ForceCurve> {
        match &self.interpolation {
            Interpolation::Curve(curve) => Some(curve),
            Interpolation::Limited(_) => None,
        }
    }

    /// A mean of 1 with the given harmonics, sampled `samples` times; `None` for more harmonics than are
    /// worth it.
    pub fn of_harmonics(
        period_s: f64,
        spectrum: Vec<(f64, f64)>,
        samples: usize,
    ) -> Option<HarmonicTarget> {
        Some(HarmonicTarget {
            mean: 1.0,
            period_s,
            fits: fits(spectrum.len()),
            most: (samples - 1) / 2,
            interpolation: Interpolation::Limited(LimitedSlopes::of(&spectrum, samples)?),
            spectrum,
        })
    }

    /// Fewest harmonics whose remainder is at most `wanted` newtons RMS (at its own scale);
    /// `None` where rounding would decide.
    pub fn count(&self, wanted: f64) -> Option<usize> {
        let power = |h: usize| 0.5 * (self.spectrum[h].0.powi(2) + self.spectrum[h].1.powi(2));
        let all: f64 = (0..self.spectrum.len()).map(power).sum();
        let (mut left, mut count) = (all, 0);
        while count < self.spectrum.len().min(MOST_AUTO) {
            if (left - wanted * wanted).abs() <= UNDECIDED * all {
                return None;
            }
            if left.max(0.0).sqrt() <= wanted {
                break;
            }
            left -= power(count);
            count += 1;
        }
        // What is left after the last known harmonic is rounding.
        (count < self.spectrum.len() || wanted * wanted > UNDECIDED * all || count == MOST_AUTO)
            .then_some(count.max(1))
    }

    /// Most harmonics that the samples hold.
    pub fn most(&self) -> usize {
        self.most
    }

    /// What `count` harmonics give; `count` is from 1 to [`HarmonicTarget::most`]. `None` where the difference to the
    /// target has no simple form.
    pub fn fit(&self, count: usize) -> Option<&Fit> {
        let count = count.min(self.spectrum.len());
        let slot = self.fits.get(count)?;
        if let Some(fit) = slot.get() {
            return Some(fit);
        }
        let fit = Box::new(self.make_fit(count)?);
        Some(slot.get_or_init(|| fit))
    }

    fn make_fit(&self, count: usize) -> Option<Fit> {
        let (harmonics, rest) = self.spectrum.split_at(count);
        let (error, error_mean, error_square) = match &self.interpolation {
            Interpolation::Curve(curve) => error_to(curve, harmonics, self.mean),
            Interpolation::Limited(limited) => {
                let error = limited.error(count, rest)?;
                (error.range, error.mean, error.square)
            }
        };
        let (low, high) = harmonic_extremes(harmonics);
        Some(Fit {
            harmonics: harmonics.to_vec(),
            mean: self.mean,
            force: (low.value, high.value),
            error,
            error_mean,
            error_square,
            inertia: OnceLock::new(),
            spring: OnceLock::new(),
            inertia_grid: OnceLock::new(),
            spring_grid: OnceLock::new(),
        })
    }
}

fn fits(count: usize) -> Vec<OnceLock<Box<Fit>>> {
    (0..=count).map(|_| OnceLock::new()).collect()
}

/// Range, mean and mean square of Σ harmonics − (target − mean), exact on the pieces of both.
fn error_to(curve: &ForceCurve, harmonics: &[(f64, f64)], mean: f64) -> (Range, f64, f64) {
    let wave = Law::harmonic(0.0, harmonics).combination([1.0, 0.0, 0.0, 0.0], 0.0);
    let target = piecewise(curve);
    let own = wave.cut_at(target.breaks());
    let target = target.cut_at(own.breaks());
    let error = PiecewisePoly::combine(&[(1.0, &own), (-1.0, &target)], mean);
    let (low, high) = error.extremes();
    let turn = std::f64::consts::TAU;
    (
        (low.value, high.value),
        error.integral() / turn,
        error.integral_of_square() / turn,
    )
}

impl Fit {
    /// Number of harmonics.
    pub fn count(&self) -> usize {
        self.harmonics.len()
    }

    /// Harmonics of the force, N.
    pub fn harmonics(&self) -> &[(f64, f64)] {
        &self.harmonics
    }

    /// The law for m ω² = 1 and no spring: ŝₙ = −F̂ₙ/n².
    pub fn inertia(&self) -> &LawRanges {
        self.inertia.get_or_init(|| {
            let law = self.inertia_terms();
            LawRanges::of(&law, self.torque(&law), Some((2, self.force)))
        })
    }

    /// Its harmonics.
    pub fn inertia_terms(&self) -> Terms {
        let terms = (1..).zip(&self.harmonics);
        terms
            .map(|(n, &(a, b))| {
                let gain = -f64::from(n * n);
                (a / gain, b / gain)
            })
            .collect()
    }

    /// The law for k = 1 without mass and damping: ŝₙ = F̂ₙ.
    pub fn spring(&self) -> &LawRanges {
        self.spring.get_or_init(|| {
            let torque = self.torque(&self.harmonics);
            LawRanges::of(&self.harmonics, torque, Some((0, self.force)))
        })
    }

    /// The law of any drive: ŝₙ = F̂ₙ/(re + i·im) with the drive's gain at harmonic n.
    pub fn divided(&self, gain: impl Fn(usize) -> (f64, f64)) -> Terms {
        let divided = (1..).zip(&self.harmonics).map(|(n, &(a, b))| {
            let (re, im) = gain(n);
            let square = re * re + im * im;
            ((a * re - b * im) / square, (b * re + a * im) / square)
        });
        divided.collect()
    }

    /// The force's harmonics and s + a of a law of these harmonics at even steps, 16 for the fastest wave or more.
    pub fn grid(&self, law: &[(f64, f64)]) -> Vec<(f64, f64)> {
        let bent: Terms = (1..)
            .zip(law)
            .map(|(n, &(a, b))| {
                let factor = f64::from(1 - n * n);
                (factor * a, factor * b)
            })
            .collect();
        let force = harmonic_values(&self.harmonics, 1).into_iter();
        force.zip(harmonic_values(&bent, 1)).collect()
    }

    /// The same of the law for pure inertia, found once.
    pub fn inertia_grid(&self, law: &[(f64, f64)]) -> Arc<Vec<(f64, f64)>> {
        let found = self.inertia_grid.get_or_init(|| Arc::new(self.grid(law)));
        found.clone()
    }

    /// The same of the law for a pure spring, found once.
    pub fn spring_grid(&self, law: &[(f64, f64)]) -> Arc<Vec<(f64, f64)>> {
        let found = self.spring_grid.get_or_init(|| Arc::new(self.grid(law)));
        found.clone()
    }

    /// The ranges of a law of these harmonics, and its torque under the target's force.
    pub fn ranges(&self, law: &[(f64, f64)]) -> LawRanges {
        LawRanges::of(law, self.torque(law), None)
    }

    fn torque(&self, law: &[(f64, f64)]) -> Torque {
        Torque::of(self.mean, &self.harmonics, law)
    }
}

impl Torque {
    /// (mean + Σ force) times the derivative of Σ law: a sum of harmonics itself.
    pub fn of(mean: f64, force: &[(f64, f64)], law: &[(f64, f64)]) -> Torque {
        let velocity: Terms = (1..)
            .zip(law)
            .map(|(n, &(a, b))| (f64::from(n) * b, -f64::from(n) * a))
            .collect();
        let mut terms = vec![(0.0, 0.0); force.len() + law.len()];
        let mut constant = 0.0;
        for (m, &(c, d)) in velocity.iter().enumerate() {
            terms[m].0 += mean * c;
            terms[m].1 += mean * d;
            for (n, &(a, b)) in force.iter().enumerate() {
                // cos nθ cos mθ and so on as waves of n + m and |n − m|.
                let sum = &mut terms[n + m + 1];
                sum.0 += 0.5 * (a * c - b * d);
                sum.1 += 0.5 * (a * d + b * c);
                let (even, odd) = (0.5 * (a * c + b * d), 0.5 * (b * c - a * d));
                if n == m {
                    constant += even;
                } else {
                    let difference = &mut terms[n.abs_diff(m) - 1];
                    difference.0 += even;
                    difference.1 += if n > m { odd } else { -odd };
                }
            }
        }
        let (low, high) = harmonic_extremes(&terms);
        let power: f64 = terms.iter().map(|t| 0.5 * (t.0 * t.0 + t.1 * t.1)).sum();
        Torque {
            range: (constant + low.value, constant + high.value),
            mean: constant,
            square: constant * constant + power,
        }
    }

    /// The same in other units of force and lift.
    pub fn scaled(&self, factor: f64) -> Torque {
        let (low, high) = self.range;
        Torque {
            range: (factor * low, factor * high),
            mean: factor * self.mean,
            square: factor * factor * self.square,
        }
    }
}

impl LawRanges {
    /// Of the curve Σ aₙ cos nθ + bₙ sin nθ; one derivative, by its order, may be known already.
    fn of(harmonics: &[(f64, f64)], torque: Torque, known: Option<(usize, Range)>) -> LawRanges {
        let mut terms = Vec::with_capacity(harmonics.len());
        let mut range = |turned: bool, power: &dyn Fn(f64) -> f64| {
            terms.clear();
            terms.extend((1..).zip(harmonics).map(|(n, &(a, b))| {
                let n = f64::from(n);
                let f = power(n);
                // A derivative of odd order turns cosines into sines.
                if turned {
                    (f * b, -f * a)
                } else {
                    (f * a, f * b)
                }
            }));
            let (low, high) = harmonic_extremes(&terms);
            (low.value, high.value)
        };
        let mut derivative = |order: usize| match known {
            Some((own, range)) if own == order => range,
            _ => {
                let sign = if order < 2 { 1.0 } else { -1.0 };
                range(order % 2 == 1, &|n| sign * n.powi(order as i32))
            }
        };
        let svaj = [0, 1, 2, 3].map(&mut derivative);
        LawRanges {
            svaj,
            bend: range(false, &|n| 1.0 - n * n).0,
            torque,
        }
    }
}

//! Fourier series of a force. It also caches laws with the first harmonics, and the force errors of these laws.

use std::sync::OnceLock;

use super::shape::Shape;
use crate::drive::Drive;
use crate::force::ForceCurve;
use crate::law::Law;
use crate::poly::{amplitudes, harmonic_extremes};

/// Maximum automatic number of harmonics.
const MOST_AUTO: usize = 60;
/// Amplitude, as a fraction of the maximum sample, below which it counts as a rounding error.
const ROUNDING: f64 = 1e-12;

/// Fourier series of one cycle of a force.
#[derive(Debug)]
pub struct Series {
    /// Mean of the force, N.
    pub mean_n: f64,
    /// Harmonics 1, 2, … as (cosine, sine), N. They are the harmonics that the samples determine, or all harmonics of a finite series.
    pub waves: Vec<(f64, f64)>,
    /// Mean square of the sum of all harmonics above harmonic n, N², for n = 0, 1, 2, …
    rest: Vec<f64>,
    /// Whether the force is exactly a finite sum of these harmonics.
    is_finite: bool,
    /// Cached results for laws with n harmonics, for n = 0, 1, 2, …
    fits: Vec<Fit>,
}

/// Cached results for a number of harmonics. The first contains the RMS and the maximum force error, N. The second is the law of a mass
/// without spring and damping with m ω² = 1, for the mass m and the speed ω.
type Fit = (OnceLock<[f64; 2]>, OnceLock<Option<Box<Shape>>>);

impl Series {
    /// Fourier series of samples. If the upper half of the harmonics contains only rounding errors, the force counts as a finite series,
    /// such as a load model.
    pub fn of(curve: &ForceCurve) -> Series {
        let spectrum = &amplitudes(&curve.force_n)[..=most(curve.force_n.len())];
        let (mean_n, waves) = (spectrum[0].0, &spectrum[1..]);
        let (least, most) = curve.range_n();
        let rounding = ROUNDING * most.max(-least);
        let last = waves
            .iter()
            .rposition(|(a, b)| libm::hypot(*a, *b) > rounding);
        let used = last.map_or(0, |last| last + 1);
        if 2 * used <= waves.len() {
            return Series::finite(mean_n, waves[..used].to_vec());
        }
        Series::new(mean_n, waves.to_vec(), false)
    }

    /// Creates the series of a force that is exactly a sum of harmonics about a mean.
    pub fn finite(mean_n: f64, waves: Vec<(f64, f64)>) -> Series {
        Series::new(mean_n, waves, true)
    }

    fn new(mean_n: f64, waves: Vec<(f64, f64)>, is_finite: bool) -> Series {
        // The sum starts at the highest harmonic, so that small sums keep their significant digits.
        let mut rest = vec![0.0; waves.len() + 1];
        for (count, (a, b)) in waves.iter().enumerate().rev() {
            rest[count] = rest[count + 1] + 0.5 * (a * a + b * b);
        }
        Series {
            mean_n,
            fits: (0..=waves.len()).map(|_| Fit::default()).collect(),
            waves,
            rest,
            is_finite,
        }
    }

    /// Whether the force is exactly the sum of its mean and [`Series::waves`].
    pub fn is_finite(&self) -> bool {
        self.is_finite
    }

    /// RMS and maximum difference, N, between the force and a sum of the harmonics `waves`. The mean of this sum exceeds the mean of the
    /// force by `gap`, N. The RMS is computed by Parseval's theorem. Differences of the size of rounding errors count as zero.
    pub fn error_of(&self, gap: f64, waves: &[(f64, f64)]) -> [f64; 2] {
        let rounding = ROUNDING * (self.mean_n.abs() + self.rest[0].sqrt());
        let is_apart = |x: f64| if x.abs() > rounding { x } else { 0.0 };
        let at = |waves: &[(f64, f64)], n: usize| waves.get(n).copied().unwrap_or_default();
        let apart = (0..self.waves.len().max(waves.len())).map(|n| {
            let ((a, b), (c, d)) = (at(&self.waves, n), at(waves, n));
            (is_apart(c - a), is_apart(d - b))
        });
        let (gap, apart) = (is_apart(gap), apart.collect::<Vec<_>>());
        let square: f64 = apart.iter().map(|(a, b)| 0.5 * (a * a + b * b)).sum();
        let (low, high) = harmonic_extremes(&apart);
        [
            (gap * gap + square).sqrt(),
            (high.value + gap).max(-low.value - gap),
        ]
    }

    /// First `count` harmonics as (cosine, sine), N. A finite series can have fewer harmonics.
    pub fn first(&self, count: usize) -> &[(f64, f64)] {
        &self.waves[..count.min(self.waves.len())]
    }

    fn fit(&self, count: usize) -> &Fit {
        &self.fits[count.min(self.waves.len())]
    }

    /// RMS of the sum of all harmonics above the first `count`, N.
    pub fn left_over(&self, count: usize) -> f64 {
        self.rest[count.min(self.waves.len())].sqrt()
    }

    /// Minimum number of harmonics for which the RMS of all higher harmonics is at most `wanted`, N. The result is between 1 and 60.
    pub fn fewest(&self, wanted: f64) -> usize {
        let enough = self.rest.partition_point(|rest| *rest > wanted * wanted);
        enough.clamp(1, MOST_AUTO)
    }

    /// Mean and first `count` harmonics of the force, N, in the form of a law of motion.
    pub fn law(&self, count: usize) -> Law {
        Law::harmonic(self.mean_n, self.first(count))
    }

    /// Cache cell for the RMS and the maximum difference between the force and [`Series::law`], N. The cell is empty until these values are
    /// computed.
    pub fn error(&self, count: usize) -> &OnceLock<[f64; 2]> {
        &self.fit(count).0
    }

    /// Law with which a drive produces the first `count` harmonics of the force; `None` at resonance.
    pub fn shape(&self, count: usize, drive: &Drive) -> Option<Shape> {
        Shape::of(self.mean_n, self.first(count), drive)
    }

    /// Law of a mass without spring and damping with m ω² = 1, computed once. It is scaled for other masses m and speeds ω. With this
    /// cache, such designs are 15 times as fast.
    pub fn inertia(&self, count: usize) -> Option<&Shape> {
        let unit = Drive::moving_axis(1.0, self.mean_n, 1.0);
        let shape = || self.shape(count, &unit).map(Box::new);
        self.fit(count).1.get_or_init(shape).as_deref()
    }
}

/// Order of the highest harmonic that a number of samples determines.
pub fn most(samples: usize) -> usize {
    (samples - 1) / 2
}

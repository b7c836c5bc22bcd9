//! The Fourier series of a force, and what laws of its first harmonics leave of it.

use std::sync::OnceLock;

use super::shape::Shape;
use crate::drive::Drive;
use crate::force::ForceCurve;
use crate::law::Law;
use crate::poly::amplitudes;

/// Most harmonics that an automatic count takes.
const MOST_AUTO: usize = 60;

/// Harmonics of one cycle of force.
#[derive(Debug)]
pub struct Series {
    /// Mean force, N.
    pub mean_n: f64,
    /// (cosine, sine) of harmonics 1, 2, …, N: as many as the samples hold.
    pub waves: Vec<(f64, f64)>,
    /// Mean square of the harmonics above each number of them, N².
    rest: Vec<f64>,
    /// By the number of harmonics of a law.
    fits: Vec<Fit>,
}

/// Root mean square and largest distance of a law from the force, N, and the law of pure inertia with m ω² = 1.
type Fit = (OnceLock<[f64; 2]>, OnceLock<Option<Box<Shape>>>);

impl Series {
    /// The harmonics that samples hold.
    pub fn of(curve: &ForceCurve) -> Series {
        let spectrum = &amplitudes(&curve.force_n)[..=most(curve.force_n.len())];
        let waves = spectrum[1..].to_vec();
        // From the highest down, so that small remainders keep their digits.
        let mut rest = vec![0.0; waves.len() + 1];
        for (count, (a, b)) in waves.iter().enumerate().rev() {
            rest[count] = rest[count + 1] + 0.5 * (a * a + b * b);
        }
        Series {
            mean_n: spectrum[0].0,
            fits: (0..=waves.len()).map(|_| Fit::default()).collect(),
            waves,
            rest,
        }
    }

    /// RMS force in the harmonics above the first `count`, N.
    pub fn left_over(&self, count: usize) -> f64 {
        self.rest[count].sqrt()
    }

    /// Fewest harmonics that leave at most `wanted` newtons RMS, one at least.
    pub fn fewest(&self, wanted: f64) -> usize {
        let enough = self.rest.partition_point(|rest| *rest > wanted * wanted);
        enough.clamp(1, MOST_AUTO)
    }

    /// The force of the first harmonics, as a law.
    pub fn law(&self, count: usize) -> Law {
        Law::harmonic(self.mean_n, &self.waves[..count])
    }

    /// Root mean square and largest distance of [`Series::law`] from the force, N, once they are known.
    pub fn error(&self, count: usize) -> &OnceLock<[f64; 2]> {
        &self.fits[count].0
    }

    /// The law of a drive from so many harmonics; `None` in resonance.
    pub fn shape(&self, count: usize, drive: &Drive) -> Option<Shape> {
        Shape::of(self.mean_n, &self.waves[..count], drive)
    }

    /// The same for m ω² = 1 without spring and damping, found once: such a design takes 6 µs instead of 90.
    pub fn inertia(&self, count: usize) -> Option<&Shape> {
        let unit = Drive::moving_axis(1.0, self.mean_n, 1.0);
        let shape = || self.shape(count, &unit).map(Box::new);
        self.fits[count].1.get_or_init(shape).as_deref()
    }
}

/// Harmonics that so many samples hold.
pub fn most(samples: usize) -> usize {
    (samples - 1) / 2
}

//! The Fourier series of a force, and what laws of its first harmonics leave of it.

use std::f64::consts::TAU;
use std::sync::OnceLock;

use super::Waves;
use super::inverse::{fewest, most, rms};
use super::shape::Shape;
use crate::drive::Drive;
use crate::force::{ForceCurve, SAMPLES};
use crate::law::Law;
use crate::poly::{amplitudes, harmonic_extremes};
use crate::problem::{MeanForce, Target};

/// One turn of force with everything about it that depends on no scene.
pub struct Series {
    /// Its mean, period and spread.
    pub mean_force: MeanForce,
    /// Further harmonics are zero.
    waves: Vec<(f64, f64)>,
    /// The samples that are interpolated; `None` where the force is the series.
    curve: Option<ForceCurve>,
    /// By the number of harmonics of a law.
    fits: Vec<Fit>,
}

/// Root mean square and largest of the distance of a law from its force, N, and the law for m ω² = 1 and nothing else.
type Fit = (OnceLock<[f64; 2]>, OnceLock<Option<Box<Shape>>>);

impl Series {
    /// The harmonics that samples hold.
    pub fn of_curve(curve: ForceCurve) -> Series {
        let waves = &amplitudes(&curve.force_n)[1..=most(curve.force_n.len())];
        Series::new(MeanForce::of(&curve), waves.to_vec(), Some(curve))
    }

    /// Of the harmonics, N, of a force that is their sum, or that has samples between which it is interpolated.
    pub fn new(mean_force: MeanForce, waves: Vec<(f64, f64)>, curve: Option<ForceCurve>) -> Series {
        let fits = (0..=waves.len()).map(|_| Default::default());
        Series {
            mean_force,
            fits: fits.collect(),
            waves,
            curve,
        }
    }

    /// Harmonics of the law: those asked for, or the fewest whose remainder is at most `wanted` newtons RMS. `None` where
    /// the samples hold fewer.
    pub fn count(&self, asked: Option<usize>, wanted: f64) -> Option<usize> {
        let samples = self.curve.as_ref().map_or(SAMPLES, |c| c.force_n.len());
        let count = asked.unwrap_or_else(|| fewest(&self.waves, wanted));
        (count <= most(samples)).then(|| count.min(self.waves.len()))
    }

    fn waves(&self, count: usize) -> &Waves {
        &self.waves[..count]
    }

    /// The law of a drive from so many harmonics; `None` in resonance.
    pub fn shape(&self, count: usize, drive: &Drive) -> Option<Shape> {
        Shape::of(self.mean_force.mean_n, self.waves(count), drive)
    }

    /// The same for m ω² = 1 without spring and damping, found once.
    pub fn inertia(&self, count: usize) -> Option<&Shape> {
        let unit = Drive::moving_axis(1.0, self.mean_force.mean_n, 1.0);
        let shape = || self.shape(count, &unit).map(Box::new);
        self.fits[count].1.get_or_init(shape).as_deref()
    }

    /// Root mean square and largest of what the force has beside its first harmonics, N, found once.
    pub fn error(&self, count: usize) -> [f64; 2] {
        *self.fits[count].0.get_or_init(|| match &self.curve {
            Some(curve) => {
                let own = Law::harmonic(self.mean_force.mean_n, self.waves(count));
                let own = own.combination([1.0, 0.0, 0.0, 0.0], 0.0);
                let apart = Target::new(curve.clone()).cells().distance(&own);
                [(apart.square / TAU).max(0.0).sqrt(), apart.largest]
            }
            None => {
                let mut rest = self.waves.clone();
                rest[..count].fill((0.0, 0.0));
                let (low, high) = harmonic_extremes(&rest);
                [rms(&rest), high.value.max(-low.value)]
            }
        })
    }
}

//! The spectral inverse: ŝₙ = F̂ₙ/(k + i c n ω − m n²ω²), harmonic by harmonic (theory §1).

use super::Waves;
use crate::drive::Drive;
use crate::error::{Placed, Result, SynthError};
use crate::force::ForceCurve;
use crate::law::Law;
use crate::poly::amplitudes;
use crate::synth::qp::Basis;

/// Most harmonics that an automatic count takes.
const MOST_AUTO: usize = 60;
/// A gain below this part of the largest term that makes it up is a resonance: the force there cannot be
/// had from any finite lift.
const RESONANCE: f64 = 1e-9;

/// A harmonic law and its remainder.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::scene;
/// use gaitcam::synth::invert;
///
/// // Under pure inertia ŝ₁ = F̂₁/(−m ω²).
/// let force = scene::built_in("footbridge")?.scene()?.model_force()?.unwrap();
/// let drive = Drive::moving_axis(70.0, 9.81, 10.0);
/// let inverse = invert(&force, &drive, Some(1), 0.0)?;
/// let wave = inverse.x[1].hypot(inverse.x[2]);
/// let share = wave * 70.0 * 100.0 / force.mean_n();
/// assert!(share > 0.2 && share < 0.5);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
pub struct Spectral {
    /// Mean, then cosine and sine amplitudes of lift, m.
    pub x: Vec<f64>,
    /// Number of harmonics.
    pub count: usize,
    /// RMS force left in the harmonics that are not used, N.
    pub left_over: f64,
}

impl Spectral {
    /// The law; its mean is that of the drive, or zero where the drive leaves it open.
    pub fn law(&self) -> Law {
        let count = self.count;
        Law::of(&Basis::Harmonic { count }, &self.x)
    }
}

/// The best law of `count` harmonics, or of the fewest whose remainder is at most `wanted` newtons RMS.
///
/// # Errors
/// Fewer samples than the harmonics asked need; a drive in resonance with a harmonic that the force contains.
pub fn invert(
    target: &ForceCurve,
    drive: &Drive,
    count: Option<usize>,
    wanted: f64,
) -> Result<Spectral> {
    let n = target.force_n.len();
    let most = most(n);
    if count.is_some_and(|c| c > most) {
        return Err(SynthError::TooManyHarmonics { samples: n, most }.at_key("law.harmonics"));
    }
    let spectrum = &amplitudes(&target.force_n)[..=most];
    let (mean, waves) = (spectrum[0].0, &spectrum[1..]);
    let count = count.unwrap_or_else(|| fewest(waves, wanted));
    let k = drive.spring_rate;
    let mut x = Vec::with_capacity(2 * count + 1);
    x.push(if k == 0.0 {
        0.0
    } else {
        (mean - drive.rest_force) / k
    });
    for (harmonic, &(a, b)) in (1..).zip(&waves[..count]) {
        let is_nothing = a.hypot(b) <= RESONANCE * mean.abs();
        let (cos, sin) = match lift_of(drive, harmonic, (a, b)) {
            Some(lift) => lift,
            None if is_nothing => (0.0, 0.0),
            None => return Err(SynthError::Resonance { harmonic }.at_key("drive")),
        };
        x.extend([cos, sin]);
    }
    Ok(Spectral {
        x,
        count,
        left_over: rms(&waves[count..]),
    })
}

/// Harmonics that so many samples hold.
pub fn most(samples: usize) -> usize {
    (samples - 1) / 2
}

/// Fewest harmonics that leave at most `wanted` RMS; one at least.
pub fn fewest(waves: &Waves, wanted: f64) -> usize {
    let (mut left, mut count) = (0.0, waves.len());
    while count > 1 && left + power(waves[count - 1]) <= wanted * wanted {
        left += power(waves[count - 1]);
        count -= 1;
    }
    count.min(MOST_AUTO)
}

/// Root mean square of a sum of harmonics; from the highest down, so that small remainders keep their digits.
pub fn rms(waves: &Waves) -> f64 {
    waves
        .iter()
        .rev()
        .map(|wave| power(*wave))
        .sum::<f64>()
        .sqrt()
}

fn power((a, b): (f64, f64)) -> f64 {
    0.5 * (a * a + b * b)
}

/// The harmonic of lift under one of force; `None` in resonance.
pub fn lift_of(drive: &Drive, harmonic: usize, (a, b): (f64, f64)) -> Option<(f64, f64)> {
    let (re, im) = drive.gain(harmonic);
    let square = re * re + im * im;
    let nw = harmonic as f64 * drive.speed;
    let largest = (drive.spring_rate.abs())
        .max(drive.mass * nw * nw)
        .max(im.abs());
    // F = a cos + b sin = Re((a − ib) e^{ihθ}); dividing by re + i·im.
    let lift = ((a * re - b * im) / square, (b * re + a * im) / square);
    (square.sqrt() > RESONANCE * largest).then_some(lift)
}

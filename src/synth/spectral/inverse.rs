//! The spectral inverse: ŝₙ = F̂ₙ/(k + i c n ω − m n²ω²), harmonic by harmonic (theory §1).

use super::MOST_AUTO;
use crate::drive::Drive;
use crate::error::{Placed, Result, SynthError};
use crate::force::ForceCurve;
use crate::law::Law;
use crate::poly::amplitudes;

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
        let terms: Vec<(f64, f64)> = (0..self.count)
            .map(|n| (self.x[2 * n + 1], self.x[2 * n + 2]))
            .collect();
        Law::harmonic(self.x[0], &terms)
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
    let most = (n - 1) / 2;
    if count.is_some_and(|c| c > most) {
        return Err(SynthError::TooManyHarmonics { samples: n, most }.at_key("law.harmonics"));
    }
    let spectrum = amplitudes(&target.force_n);
    let power = |k: usize| 0.5 * (spectrum[k].0.powi(2) + spectrum[k].1.powi(2));
    // From the highest down, so that small remainders keep their digits.
    let mut left = 0.0;
    let mut fewest = most;
    let stop = count.unwrap_or(1);
    while fewest > stop && (count.is_some() || left + power(fewest) <= wanted * wanted) {
        left += power(fewest);
        fewest -= 1;
    }
    if count.is_none() && fewest > MOST_AUTO {
        left += (MOST_AUTO + 1..=fewest).map(power).sum::<f64>();
        fewest = MOST_AUTO;
    }
    let (count, left_over) = (fewest, left.sqrt());
    let mut x = Vec::with_capacity(2 * count + 1);
    let k0 = drive.spring_rate;
    x.push(if k0 != 0.0 {
        (spectrum[0].0 - drive.rest_force) / k0
    } else {
        0.0
    });
    for (h, &(a, b)) in spectrum.iter().enumerate().take(count + 1).skip(1) {
        let (re, im) = drive.gain(h);
        let square = re * re + im * im;
        let nw = h as f64 * drive.speed;
        let largest = drive
            .spring_rate
            .abs()
            .max(drive.mass * nw * nw)
            .max(im.abs());
        if square.sqrt() <= RESONANCE * largest {
            if a.hypot(b) <= RESONANCE * target.mean_n().abs() {
                x.extend([0.0, 0.0]);
                continue;
            }
            return Err(SynthError::Resonance { harmonic: h }.at_key("drive"));
        }
        // F = a cos + b sin = Re((a − ib) e^{ihθ}); dividing by re + i·im.
        x.push((a * re - b * im) / square);
        x.push((b * re + a * im) / square);
    }
    Ok(Spectral {
        x,
        count,
        left_over,
    })
}

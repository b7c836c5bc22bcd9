//! Spectral inverse ŝₙ = F̂ₙ/(k + i c n ω − m n²ω²), which computes the lift from the force separately for each harmonic n (theory §1). The
//! spring rate is k, the damping c, the mass m and the shaft speed ω.

use crate::drive::{Drive, RESONANCE};
use crate::error::{Placed, Result, SynthError};
use crate::law::Law;
use crate::problem::Target;
use crate::synth::qp::Basis;

/// A harmonic law and the force that its harmonics do not reproduce.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::problem::Target;
/// use gaitcam::scene;
/// use gaitcam::synth::invert;
///
/// // For a pure inertia, ŝ₁ = F̂₁/(−m ω²).
/// let force = scene::built_in("footbridge")?.scene()?.model_force()?.unwrap();
/// let drive = Drive::moving_axis(70.0, 9.81, 10.0);
/// let target = Target::new(force);
/// let inverse = invert(&target, &drive, Some(1), 0.0)?;
/// let wave = inverse.x[1].hypot(inverse.x[2]);
/// let share = wave * 70.0 * 100.0 / target.mean_n();
/// assert!(share > 0.2 && share < 0.5);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
pub struct Spectral {
    /// Coefficients of the lift, m: mean, then cosine and sine amplitude of each harmonic.
    pub x: Vec<f64>,
    /// Number of harmonics of the law.
    pub count: usize,
    /// Root mean square of the omitted force harmonics, N.
    pub left_over: f64,
}

impl Spectral {
    /// Harmonic law with these coefficients. The mean lift follows from the mean force and the drive. It is zero if the force does not
    /// depend on the mean lift.
    pub fn law(&self) -> Law {
        let count = self.count;
        Law::of(&Basis::Harmonic { count }, &self.x)
    }
}

/// Law whose force has the same first `count` harmonics as the target. Without `count`, it has the minimum number of harmonics for which
/// the RMS of the omitted force is at most `wanted`, N.
///
/// # Errors
///
/// The samples do not determine so many harmonics, or the drive is at resonance with a harmonic of the force.
pub fn invert(
    target: &Target,
    drive: &Drive,
    count: Option<usize>,
    wanted: f64,
) -> Result<Spectral> {
    let most = target.most_harmonics();
    if count.is_some_and(|c| c > most) {
        let samples = target.samples();
        return Err(SynthError::TooManyHarmonics { samples, most }.at_key("law.harmonics"));
    }
    let mean = target.mean_n();
    let count = count.unwrap_or_else(|| target.fewest_harmonics(wanted));
    let k = drive.spring_rate;
    let mut x = Vec::with_capacity(2 * count + 1);
    x.push(if k == 0.0 {
        0.0
    } else {
        (mean - drive.rest_force) / k
    });
    for (harmonic, (a, b)) in (1..).zip(target.harmonics(count)) {
        let is_nothing = libm::hypot(a, b) <= RESONANCE * mean.abs();
        let (cos, sin) = match drive.lift_of(harmonic, (a, b)) {
            Some(lift) => lift,
            None if is_nothing => (0.0, 0.0),
            None => return Err(SynthError::Resonance { harmonic }.at_key("drive")),
        };
        x.extend([cos, sin]);
    }
    Ok(Spectral {
        x,
        count,
        left_over: target.left_over(count),
    })
}

//! Residual vibration of the follower in a dwell.
//!
//! In a dwell, the rigid force is a constant F. The follower vibrates about its static deflection −F/K. K = k + k₁ is the sum of the
//! stiffnesses of return spring and train. The amplitude is √(2 E/K) with the energy E of this vibration at the start of the dwell. This
//! amplitude is an upper bound of the motion in the dwell. Without damping, the amplitude is reached in every cycle (theory §10).

use super::{SAME, Train, periodic};
use crate::drive::Drive;
use crate::error::Result;
use crate::law::Law;

/// Damping ratio that is used if an undamped natural frequency equals a harmonic. If the law excites this frequency, the vibration grows
/// without bound. Otherwise the follower is at rest in the dwells.
const HARDLY_DAMPED: f64 = 1e-6;

/// Amplitude of the residual vibration in each dwell, m, in the periodic steady state. `starts` contains the cam angles, rad, at which the
/// dwells start.
///
/// # Errors
///
/// Invalid stiffness or damping.
pub fn in_rests(law: &Law, drive: &Drive, train: &Train, starts: &[f64]) -> Result<Vec<f64>> {
    train.check()?;
    let (own, states) = match periodic(law, drive, train, starts) {
        Ok(Some(vibration)) => vibration,
        Ok(None) => return Ok(vec![0.0; starts.len()]),
        Err(resonance) => {
            let damping = 2.0 * HARDLY_DAMPED * (train.stiffness * drive.mass).sqrt();
            if train.damping >= damping {
                return Err(resonance);
            }
            return in_rests(law, drive, &Train { damping, ..*train }, starts);
        }
    };
    let give = 1.0 / (train.stiffness + drive.spring_rate);
    let breaks = own.force.breaks();
    let amplitude = |start: &f64| {
        let piece = breaks.partition_point(|b| *b < start + SAME).max(1) - 1;
        let piece = piece % own.force.pieces();
        let swing = states[piece][0] + give * own.force.piece(piece)[0];
        libm::hypot(
            swing,
            if own.scale > 0.0 {
                states[piece][1]
            } else {
                0.0
            },
        )
    };
    Ok(starts.iter().map(amplitude).collect())
}

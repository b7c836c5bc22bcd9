//! Clipping: the amplifier or converter stops at a level below the peaks of the force.

use super::longest_run;

/// Shortest plateau that is counted, s.
const HELD_S: f64 = 0.03;
/// Curvature of a walking peak over its force, 1/s²: rounding to a step q makes a plateau of 2 √(2q/(κF)).
const CURVATURE: f64 = 40.0;

/// The level at which readings stop: their maximum, where two contacts (or one for twice as long) hold it to the last
/// digit for longer than the rounding of the readings explains.
pub(super) fn clipped(force: &[f64], rate_hz: f64) -> Option<f64> {
    let top = force.iter().copied().fold(0.0, f64::max);
    let plateau = |contact: &[f64]| longest_run(contact, top - 1e-9 * top, top);
    let samples = |s: f64| ((s * rate_hz).round() as usize).max(3);
    // Steps are looked at in the few recordings that reach this.
    if plateau(force) < samples(HELD_S) {
        return None;
    }
    let steps = force.windows(2).map(|w| (w[1] - w[0]).abs());
    let rounding = steps.filter(|s| *s > 1e-9 * top).fold(top, f64::min);
    let rounded_s = 2.5 * (2.0 * rounding / (CURVATURE * top)).sqrt();
    let fewest = samples(HELD_S.max(rounded_s));
    let contacts = force.split(|f| *f < 0.5 * top);
    let plateaus: Vec<usize> = contacts.map(plateau).filter(|n| *n >= fewest).collect();
    (plateaus.len() > 1 || plateaus.iter().any(|n| *n >= 2 * fewest)).then_some(top)
}

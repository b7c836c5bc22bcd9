//! Profile for the contact model: its lift, and the ranges of negative contact force.

use crate::drive::Drive;
use crate::law::{Law, Svaj};
use crate::poly::PiecewisePoly;
use std::f64::consts::TAU;

/// Fraction of the maximum force below which a negative force is a rounding error.
pub(super) const NO_PULL: f64 = 1e-11;
/// Fraction of the maximum force below which a negative force is a rounding error in a machine without inertia. If the coordinates are
/// rounded, the recovered lift deviates from zero by about a nanometre per millimetre.
const NO_PULL_STATIC: f64 = 1e-6;

/// A closed lift, with the ranges in which contact cannot be maintained.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::Surface;
/// use gaitcam::law::Law;
///
/// // Above the lift-off speed, contact at the highest point requires a negative force.
/// let drive = Drive::moving_axis(10.0, 9.81, 1.3 * (9.81_f64 / 0.01).sqrt());
/// let surface = Surface::new(Law::harmonic(0.01, &[(0.0, 0.01)]), &drive);
/// let (from, to) = surface.next_pull(0.0).unwrap();
/// assert!((0.5 * (from + to) - std::f64::consts::FRAC_PI_2).abs() < 1e-9);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Lift over one turn as a function of the angle in the direction of rotation.
    pub law: Law,
    /// Contact force under the assumption of permanent contact, N.
    pub force: PiecewisePoly,
    /// Ranges (from, to) of negative force in ascending order. `from` is in the first turn; `to` may be in the second.
    pub pulls: Vec<(f64, f64)>,
    /// Maximum second derivative of the lift, m/rad².
    pub steepest: f64,
    /// Minimum second derivative of the lift, m/rad².
    pub hollowest: f64,
    start: f64,
}

impl Surface {
    /// Creates the surface of a law for a drive with positive speed.
    pub fn new(law: Law, drive: &Drive) -> Self {
        let force = drive.force_curve(&law);
        let (low, high) = law.extremes(2);
        let none = if drive.mass > 0.0 {
            NO_PULL
        } else {
            NO_PULL_STATIC
        };
        let pulls = pulls(&force, none);
        Surface {
            start: law.extent().0,
            force,
            pulls,
            steepest: high.value,
            hollowest: low.value,
            law,
        }
    }

    /// Lift and derivatives at any angle, over several turns.
    pub fn at(&self, angle: f64) -> Svaj {
        self.law.svaj(angle)
    }

    /// First range of negative force that ends after `angle`. Like `angle`, the angles of the range increase over several turns.
    pub fn next_pull(&self, angle: f64) -> Option<(f64, f64)> {
        let turn = ((angle - self.start) / TAU).floor();
        (-1..=1)
            .flat_map(|k| {
                let shift = (turn + f64::from(k)) * TAU;
                self.pulls.iter().map(move |(a, b)| (a + shift, b + shift))
            })
            .find(|(_, to)| *to > angle + 1e-12)
    }
}

/// Ranges of negative force, joined across the end of the turn.
fn pulls(force: &PiecewisePoly, none: f64) -> Vec<(f64, f64)> {
    let (first, last) = (force.breaks()[0], force.breaks()[force.pieces()]);
    let (low, high) = force.extremes();
    let none = none * low.value.abs().max(high.value.abs());
    if low.value >= -none {
        return Vec::new();
    }
    if high.value < 0.0 {
        return vec![(first, last)];
    }
    let mut marks = force.roots();
    marks.retain(|r| *r > first && *r < last);
    marks.insert(0, first);
    marks.push(last);
    let mut out: Vec<(f64, f64)> = Vec::new();
    for pair in marks.windows(2) {
        if force.eval(0.5 * (pair[0] + pair[1])) >= 0.0 {
            continue;
        }
        match out.last_mut() {
            Some(stretch) if stretch.1 == pair[0] => stretch.1 = pair[1],
            _ => out.push((pair[0], pair[1])),
        }
    }
    let wraps = out.len() > 1 && out[0].0 == first && out[out.len() - 1].1 == last;
    if wraps {
        let (_, to) = out.remove(0);
        if let Some(stretch) = out.last_mut() {
            stretch.1 = to + (last - first);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::thesis;

    #[test]
    fn the_pull_of_a_fast_eccentric_is_where_its_sine_says() {
        // M(g − ω²e sin θ) < 0 between asin(g/ω²e) and its supplement.
        let drive = thesis::real(35.0);
        let surface = Surface::new(thesis::eccentric().law, &drive);
        let edge = (9.81 / (35.0 * 35.0 * 0.01_f64)).asin();
        let (from, to) = surface.next_pull(2.0 * TAU).unwrap();
        assert!((from - edge - 2.0 * TAU).abs() < 1e-12);
        assert!((to - (std::f64::consts::PI - edge) - 2.0 * TAU).abs() < 1e-12);
        // Shifted by a quarter turn, the range of negative force crosses the end of the turn and remains one range.
        let turned = Law::harmonic(0.0, &[(0.01, 0.0)]);
        let surface = Surface::new(turned, &drive);
        assert_eq!(surface.pulls.len(), 1);
        let (from, to) = surface.next_pull(0.0).unwrap();
        assert!(from < 0.0 && to > 0.0 && (from + to).abs() < 1e-9);
    }
}

//! Extent of a profile, and the lift recovered from its points.

use std::f64::consts::TAU;

use crate::law::{Law, Svaj};
use crate::poly::bernstein;

/// Motion of a follower, recovered from the points of an output profile.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::dynamics::recover;
/// use gaitcam::law::Law;
///
/// // The lift recovered from an eccentric disc is its harmonic.
/// let follower = Follower::FlatTranslating { base_radius: 0.02 };
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), follower)?;
/// let emitted = recover(&follower, &cam.profile(360))?;
/// assert!((emitted.law.svaj(1.0).s - 0.01 * (1.0 + 1f64.sin())).abs() < 1e-9);
/// assert!(emitted.mismatch < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Emitted {
    /// Lift above the base circle (prime circle): polynomials of degree 4 between the angles of the points, C³ at all points except the breakpoints.
    pub law: Law,
    /// Lift and its derivatives at the points of the profile.
    pub nodes: Vec<Svaj>,
    /// Maximum difference between the lift of a point and the recovered lift, m. It is caused by noise, rounding, or rows that are not
    /// contact points.
    pub mismatch: f64,
}

/// Length of a profile, and whether it is closed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// Length, rad (m of travel for a translating cam).
    pub length: f64,
    /// Whether the profile is closed; its first point is then not repeated.
    pub closed: bool,
}

impl Cycle {
    /// Full turn of a closed profile.
    pub const TURN: Cycle = Cycle {
        length: TAU,
        closed: true,
    };

    /// Length of a law, and whether the law is closed.
    pub fn of(law: &Law) -> Cycle {
        Cycle {
            length: law.extent().1,
            closed: law.is_closed(),
        }
    }

    /// Distance between neighbouring points if the extent has n points.
    pub fn step(&self, n: usize) -> f64 {
        self.length / if self.closed { n } else { n - 1 } as f64
    }
}

/// Bernstein coefficients of one span of the lift. The span begins at `lift` and is the integral of a cubic velocity with the given values
/// and slopes at both ends.
pub(super) fn lift_piece(lift: f64, width: f64, [[v, a], [w, b]]: [[f64; 2]; 2]) -> Vec<f64> {
    let velocity = [v, v + a * width / 3.0, w - b * width / 3.0, w];
    let rise = bernstein::antiderivative(&velocity);
    rise.iter().map(|x| lift + width * x).collect()
}

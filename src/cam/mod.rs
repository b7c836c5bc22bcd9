//! Cams: law of motion and follower, profile, checks and minimum size.
//!
//! Signs (theory §6): the cam turns counter-clockwise by θ, and the follower moves along +y. In the cam's frame, a fixed point is rotated
//! by R(−θ) = [[cos θ, sin θ], [−sin θ, cos θ]]. The profile is therefore traversed clockwise. Curvature is positive where the cam is
//! convex.

mod barrel;
mod checks;
mod conjugate;
mod continuity;
mod follower;
mod geometry;
mod inspect;
mod interference;
mod making;
mod profile;
mod size;

pub(crate) use crate::criterion::{Criterion, LimitKind};
pub use barrel::{BarrelGroove, Rollers, Wall};
pub(crate) use checks::Curvature;
pub use checks::{Check, Verdict};
pub use conjugate::{Closure, Conjugate};
pub use continuity::Continuity;
pub(crate) use follower::Arm;
pub use follower::{Follower, FollowerKind, Measures, Unit};
pub(crate) use geometry::{Contact, Geometry, Kind};
pub use inspect::{Deviation, Inspection};
pub use interference::Body;
pub use making::{Bore, Hardness, Keyway, Making, Material, STEEL, StatedMaterial, Stock};
pub use profile::ProfilePoint;
pub(crate) use size::PrimeCircle;
pub(crate) use size::least_between;
pub use size::{SizeLimits, smallest_base_radius, smallest_for, smallest_prime_circle};

use crate::error::Result;
use crate::law::Law;
use serde::Serialize;

/// A law of motion together with its follower.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::law::Law;
///
/// // For s = 10 mm (1 + sin θ) and a flat face, the cam is a disc of radius 30 mm about (10 mm, 0).
/// let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.02 })?;
/// for p in cam.profile(360) {
///     assert!(((p.x - 0.01).hypot(p.y) - 0.03).abs() < 1e-15);
/// }
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cam {
    /// The law of motion. Its lift is measured from the base circle, or from the prime circle for a roller.
    pub law: Law,
    /// Follower of the cam with its dimensions.
    pub follower: Follower,
}

impl Cam {
    /// Creates a cam and checks that its follower can execute the law. The pivot of an arm must lie outside the profile.
    ///
    /// # Errors
    ///
    /// [`Cam::check`] fails.
    pub fn new(law: Law, follower: Follower) -> Result<Cam> {
        let cam = Cam { law, follower };
        cam.check()?;
        Ok(cam)
    }

    /// Creates a cam whose arm is in another plane, so that its pivot may lie within the profile.
    ///
    /// # Errors
    ///
    /// [`Cam::check_beside`] fails.
    pub fn beside(law: Law, follower: Follower) -> Result<Cam> {
        let cam = Cam { law, follower };
        cam.check_beside()?;
        Ok(cam)
    }
}

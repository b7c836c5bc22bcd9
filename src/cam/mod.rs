//! A cam: a law of motion with a follower, its profile, its checks, its smallest size.
//!
//! Signs (theory §6): the cam turns counter-clockwise by θ, the follower moves along +y, a
//! point fixed in space is seen in the cam's frame turned by R(−θ) = [[cos θ, sin θ], [−sin θ, cos θ]].
//! The profile is therefore traversed clockwise; curvature is positive where the cam is convex.

mod arc_tangent;
mod barrel;
mod breadth;
mod checks;
mod conjugate;
mod eccentric;
mod fit;
mod follower;
mod follower_kind;
mod geometry;
mod interference;
mod measures;
mod pair;
mod profile;
mod shape;
mod size;
mod space;

pub use barrel::{BarrelGroove, Rollers, Wall};
pub use breadth::{constant_breadth_cam, constant_diameter_cam};
pub use checks::{Check, Curvature, Judgement, Verdict, judge};
pub use conjugate::{Closure, Conjugate};
pub use eccentric::{eccentric_disc, eccentric_roller_law};
pub use follower::Follower;
pub use follower_kind::FollowerKind;
pub use interference::{Body, Interference};
pub use measures::{Measures, Unit};
pub use pair::{Carrier, Handover, Pair};
pub use profile::ProfilePoint;
pub use size::{
    PrimeCircle, SizeLimits, smallest_base_radius, smallest_for, smallest_prime_circle,
};

use crate::error::Result;
use crate::law::Law;

/// A law of motion on its follower.
#[derive(Debug, Clone, PartialEq)]
pub struct Cam {
    /// The law of motion; its lift is measured from the base (prime) circle.
    pub law: Law,
    /// The follower.
    pub follower: Follower,
}

impl Cam {
    /// A cam whose follower fits its law: [`Cam::check`] passes.
    pub fn new(law: Law, follower: Follower) -> Result<Cam> {
        let cam = Cam { law, follower };
        cam.check()?;
        Ok(cam)
    }
}

//! A cam: a law of motion with a follower, its profile, its checks, its smallest size.
//!
//! Signs (INTERFACE conventions): the cam turns counter-clockwise by θ, the follower moves along +y, a
//! point fixed in space is seen in the cam's frame turned by R(−θ) = [[cos θ, sin θ], [−sin θ, cos θ]].
//! The profile is therefore traversed clockwise; curvature is positive where the cam is convex.

mod checks;
mod flat;
mod profile;
mod roller;
mod size;

pub use checks::{Check, Curvature, Verdict};
pub use profile::ProfilePoint;
pub use size::{PrimeCircle, smallest_base_radius, smallest_prime_circle};

use crate::law::Law;
use crate::poly::Extreme;

/// What rides on the cam, with the lengths that fix it, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Follower {
    /// A flat face normal to the follower's motion.
    FlatTranslating {
        /// Radius of the base circle: the face stands at base_radius + s.
        base_radius: f64,
    },
    /// A roller on a follower that slides along a line `offset` beside the cam's centre. A knife edge is
    /// a roller of radius 0.
    RollerTranslating {
        /// Radius of the prime circle: the roller centre's distance at s = 0.
        prime_radius: f64,
        /// Offset e of the line of motion, positive towards +x.
        offset: f64,
        /// Radius of the roller; 0 for a knife edge.
        roller_radius: f64,
    },
}

/// A law of motion on its follower.
#[derive(Debug, Clone, PartialEq)]
pub struct Cam {
    /// The law of motion; its lift is measured from the base (prime) circle.
    pub law: Law,
    /// The follower.
    pub follower: Follower,
}

impl Follower {
    /// The name users write in a scene.
    pub fn name(&self) -> &'static str {
        match self {
            Follower::FlatTranslating { .. } => "flat-translating",
            Follower::RollerTranslating { roller_radius, .. } if *roller_radius == 0.0 => {
                "knife-translating"
            }
            Follower::RollerTranslating { .. } => "roller-translating",
        }
    }

    /// Radius of the base circle, the largest circle about the centre inside the profile's dwell at s = 0.
    pub fn base_radius(&self) -> f64 {
        match *self {
            Follower::FlatTranslating { base_radius } => base_radius,
            Follower::RollerTranslating {
                prime_radius,
                roller_radius,
                ..
            } => prime_radius - roller_radius,
        }
    }

    /// Radius of the prime circle (the base circle's for a flat face).
    pub fn prime_radius(&self) -> f64 {
        match *self {
            Follower::FlatTranslating { base_radius } => base_radius,
            Follower::RollerTranslating { prime_radius, .. } => prime_radius,
        }
    }

    /// Offset of the follower's line of motion, m (0 for a flat face, whose offset changes nothing).
    pub fn offset(&self) -> f64 {
        match *self {
            Follower::FlatTranslating { .. } => 0.0,
            Follower::RollerTranslating { offset, .. } => offset,
        }
    }

    /// Radius of the roller, 0 where there is none.
    pub fn roller_radius(&self) -> f64 {
        match *self {
            Follower::FlatTranslating { .. } => 0.0,
            Follower::RollerTranslating { roller_radius, .. } => roller_radius,
        }
    }
}

impl Cam {
    /// Smallest and largest pressure angle, rad, signed (positive leans the push towards the rise).
    pub fn pressure_angle_extremes(&self) -> (Extreme, Extreme) {
        match self.follower {
            Follower::FlatTranslating { .. } => flat::no_pressure_angle(&self.law),
            Follower::RollerTranslating { .. } => roller::pressure_angle_extremes(self),
        }
    }

    /// Curvature of the finished profile: where it is sharpest, on the convex and the concave side.
    pub fn curvature(&self) -> Curvature {
        match self.follower {
            Follower::FlatTranslating { base_radius } => flat::curvature(&self.law, base_radius),
            Follower::RollerTranslating { roller_radius, .. } => {
                roller::curvature(self, roller_radius)
            }
        }
    }

    /// Least length of the flat face, m: max v − min v (paper of thesis 000); `None` for other followers.
    pub fn face_width(&self) -> Option<f64> {
        match self.follower {
            Follower::FlatTranslating { .. } => Some(flat::face_width(&self.law)),
            Follower::RollerTranslating { .. } => None,
        }
    }
}

//! Contact of cam and follower in the fixed frame.
//!
//! Followers with a circle (roller, knife edge, mushroom): C(θ) is the centre of the circle in the fixed frame, and R(−θ)·C is the pitch
//! curve in the cam's frame. In the fixed frame, the tangent of the pitch curve is t = C′ − J·C and the derivative of t is C″ − 2J·C′ − C,
//! where J is the rotation by 90°. The curve is traversed clockwise. Its curvature is −det(t, t′)/|t|³, positive where convex. The cam is
//! the inner parallel curve at the radius of the circle.
//!
//! Flat faces: a face with the outward normal n at the angle ψ has the distance p from the cam's centre. The cam is the envelope p·n +
//! (dp/dψ)·n⊥ with the radius of curvature p + d²p/dψ².

mod contact;
mod fit;
mod kinds;
mod shape;
mod space;

pub(crate) use contact::Contact;
pub(super) use shape::finished_radius;

use super::{Arm, Follower};
use crate::law::Svaj;
pub(crate) use kinds::Kind;
use kinds::{Circle, CircleOnArm, Flat, FlatOnArm, Unrolled};

/// Contact geometry of a follower, with precomputed values that do not depend on θ.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Geometry {
    Flat(Flat),
    FlatOnArm(FlatOnArm),
    Circle(Circle),
    CircleOnArm(CircleOnArm),
    Unrolled(Unrolled),
}

impl Geometry {
    pub fn new(follower: &Follower) -> Self {
        let start = follower.start_angle().unwrap_or(0.0);
        let radius = follower.roller_radius();
        if let Some(Arm { pivot, length }) = follower.arm() {
            return Geometry::CircleOnArm(CircleOnArm {
                pivot: pivot.abs(),
                side: pivot.signum(),
                arm: length,
                start,
                radius,
            });
        }
        match *follower {
            Follower::FlatTranslating { base_radius } => Geometry::Flat(Flat { base: base_radius }),
            Follower::FlatOscillating { pivot_distance, .. } => Geometry::FlatOnArm(FlatOnArm {
                pivot: pivot_distance.abs(),
                side: pivot_distance.signum(),
                offset: follower.face_offset(),
                start,
            }),
            Follower::TranslatingCam { base_height, .. } => Geometry::Unrolled(Unrolled {
                scale: 1.0,
                base: base_height + radius,
                radius,
            }),
            Follower::Barrel { radius: scale, .. } => Geometry::Unrolled(Unrolled {
                scale,
                base: 0.0,
                radius,
            }),
            // Arms are handled above.
            Follower::RollerTranslating { .. }
            | Follower::MushroomTranslating { .. }
            | Follower::RollerOscillating { .. }
            | Follower::MushroomOscillating { .. } => Geometry::Circle(Circle {
                rise: follower.start_height(),
                offset: follower.offset(),
                radius,
            }),
        }
    }

    /// Contact at one instant of the motion.
    pub fn contact(&self, at: Svaj) -> Contact {
        let at = [at.s, at.v, at.a];
        match self {
            Geometry::Flat(kind) => kind.contact(at),
            Geometry::FlatOnArm(kind) => kind.contact(at),
            Geometry::Circle(kind) => kind.contact(at),
            Geometry::CircleOnArm(kind) => kind.contact(at),
            Geometry::Unrolled(kind) => kind.contact(at),
        }
    }

    /// Signed curvature of the pitch curve, 1/m; finite even if the radius is infinite.
    pub fn pitch_curvature(&self, at: Svaj) -> f64 {
        match self {
            Geometry::Unrolled(unrolled) => unrolled.pitch_curvature(at),
            _ => 1.0 / (self.contact(at).rho + self.radius()),
        }
    }

    /// Radius of the roller or arc, m; 0 for a flat face.
    pub fn radius(&self) -> f64 {
        match self {
            Geometry::Flat(_) | Geometry::FlatOnArm(_) => 0.0,
            Geometry::Circle(circle) => circle.radius,
            Geometry::CircleOnArm(circle) => circle.radius,
            Geometry::Unrolled(unrolled) => unrolled.radius,
        }
    }

    /// Position of the contact on the follower, m. On a flat face, it is measured from the foot of the perpendicular on the face. The
    /// perpendicular starts at the cam centre (translating) or at the pivot (oscillating). On a mushroom, the position is measured along
    /// the chord from the middle of the arc.
    pub fn travel(&self, at: Svaj) -> f64 {
        match self {
            Geometry::Flat(_) => at.v,
            Geometry::FlatOnArm(face) => face.travel(at),
            _ => {
                let tan = self.contact(at).tan_pressure;
                self.radius() * tan / (1.0 + tan * tan).sqrt()
            }
        }
    }
}

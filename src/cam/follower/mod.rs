//! Followers of a cam with their dimensions.

mod kind;
mod measures;

pub use kind::FollowerKind;
pub use measures::{Measures, Unit};

use crate::law::Law;
use crate::units::Quantity;
use serde::Serialize;

/// A follower with its dimensions, m. A knife edge is a roller of radius 0. A mushroom is a face rounded to an arc, convex towards the cam.
/// It touches the cam like a roller with the radius of the arc, but only a part of the circle exists.
///
/// ```
/// use gaitcam::cam::Follower;
///
/// let roller = Follower::RollerTranslating {
///     prime_radius: 0.05,
///     offset: 0.0,
///     roller_radius: 0.01,
/// };
/// assert!((roller.base_radius() - 0.04).abs() < 1e-15);
/// assert_eq!(roller.name(), "roller-translating");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Follower {
    /// A flat face perpendicular to the motion of the follower.
    FlatTranslating {
        /// Radius of the base circle. At the lift s, the distance of the face from the cam centre is base_radius + s.
        base_radius: f64,
    },
    /// A roller on a follower that slides along a line with the distance `offset` from the cam centre.
    RollerTranslating {
        /// Radius of the prime circle: distance of the roller centre from the cam centre at s = 0.
        prime_radius: f64,
        /// Offset e of the line of motion, positive towards +x.
        offset: f64,
        /// Radius of the roller; 0 for a knife edge.
        roller_radius: f64,
    },
    /// An arc on a follower that slides along a line with the distance `offset` from the cam centre.
    MushroomTranslating {
        /// Distance of the arc's centre from the cam centre at s = 0: base radius + arc radius.
        prime_radius: f64,
        /// Offset e of the line of motion of the arc's centre, positive towards +x.
        offset: f64,
        /// Radius of the arc of the face.
        arc_radius: f64,
    },
    /// A roller on an arm. Its centre is at (c − A cos ξ, A sin ξ), with the arm angle ξ = ξ₀ + s and the lift s, rad.
    RollerOscillating {
        /// Distance c of the pivot at (c, 0); negative for a pivot on −x.
        pivot_distance: f64,
        /// Length A of the arm from pivot to roller centre.
        arm: f64,
        /// Radius Rp of the prime circle. It determines ξ₀ by cos ξ₀ = (A² + c² − Rp²)/(2Ac).
        prime_radius: f64,
        /// Radius of the roller; 0 for a knife edge.
        roller_radius: f64,
    },
    /// An arc-shaped face on an arm. Its centre moves like the centre of an oscillating roller.
    MushroomOscillating {
        /// Distance c of the pivot at (c, 0); negative for a pivot on −x.
        pivot_distance: f64,
        /// Length A of the arm from the pivot to the arc's centre.
        arm: f64,
        /// Distance of the arc's centre from the cam centre at s = 0.
        prime_radius: f64,
        /// Radius of the arc of the face.
        arc_radius: f64,
    },
    /// A flat face on an arm. Its distance from the cam centre is f + c sin ξ, with the arm angle ξ = ξ₀ + s and the lift s, rad.
    FlatOscillating {
        /// Distance c of the pivot at (c, 0); negative for a pivot on −x.
        pivot_distance: f64,
        /// Offset f of the face from its parallel through the pivot, positive away from the cam.
        face_offset: f64,
        /// Radius Rb of the base circle. It determines ξ₀ by f + |c| sin ξ₀ = Rb.
        base_radius: f64,
    },
    /// A roller on a translating cam. The cam moves along −x, the roller along +y. The law is a function of the travel in m.
    TranslatingCam {
        /// Height of the profile above the lower edge of the cam at s = 0.
        base_height: f64,
        /// Radius of the roller; 0 for a knife edge.
        roller_radius: f64,
    },
    /// A roller with a radial axis in the groove of a cylinder. The profile is the lower wall, unrolled at `radius`.
    /// [`BarrelGroove`](super::BarrelGroove) describes both walls in space.
    Barrel {
        /// Radius of the cylinder on which the profile is unrolled.
        radius: f64,
        /// Radius of the roller.
        roller_radius: f64,
    },
}

/// Arm of an oscillating follower with a circular contact (roller, knife edge or mushroom); lengths in m.
///
/// ```
/// use gaitcam::cam::Follower;
///
/// let follower = Follower::RollerOscillating { pivot_distance: -0.08, arm: 0.07, prime_radius: 0.05, roller_radius: 0.01 };
/// let arm = follower.arm().unwrap();
/// assert_eq!((arm.pivot, arm.length), (-0.08, 0.07));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arm {
    /// Distance c of the pivot at (c, 0); negative for a pivot on −x.
    pub pivot: f64,
    /// Length A from the pivot to the centre of the roller or arc.
    pub length: f64,
}

impl Follower {
    /// Arm of an oscillating roller or mushroom; `None` for other followers.
    pub fn arm(&self) -> Option<Arm> {
        match *self {
            Follower::RollerOscillating {
                pivot_distance: pivot,
                arm: length,
                ..
            }
            | Follower::MushroomOscillating {
                pivot_distance: pivot,
                arm: length,
                ..
            } => Some(Arm { pivot, length }),
            _ => None,
        }
    }

    /// Radius of the base circle, m. It is the radius of the profile where the follower rests at s = 0. For a translating cam, the result
    /// is the base height. For a barrel, it is the radius of the cylinder.
    pub fn base_radius(&self) -> f64 {
        match *self {
            Follower::FlatTranslating { base_radius }
            | Follower::FlatOscillating { base_radius, .. } => base_radius,
            Follower::TranslatingCam { base_height, .. } => base_height,
            Follower::Barrel { radius, .. } => radius,
            _ => self.prime_radius() - self.roller_radius(),
        }
    }

    /// Radius of the prime circle, m; for a flat face the radius of the base circle.
    pub fn prime_radius(&self) -> f64 {
        match *self {
            Follower::FlatTranslating { base_radius }
            | Follower::FlatOscillating { base_radius, .. } => base_radius,
            Follower::RollerTranslating { prime_radius, .. }
            | Follower::MushroomTranslating { prime_radius, .. }
            | Follower::RollerOscillating { prime_radius, .. }
            | Follower::MushroomOscillating { prime_radius, .. } => prime_radius,
            Follower::TranslatingCam {
                base_height,
                roller_radius,
            } => base_height + roller_radius,
            Follower::Barrel { radius, .. } => radius,
        }
    }

    /// Copy of the follower with the base radius `base`, m. For a barrel, `base` is the radius of the cylinder.
    #[must_use]
    pub fn with_base_radius(mut self, base: f64) -> Follower {
        let rolling = self.roller_radius();
        match &mut self {
            Follower::FlatTranslating { base_radius }
            | Follower::FlatOscillating { base_radius, .. } => *base_radius = base,
            Follower::RollerTranslating { prime_radius, .. }
            | Follower::MushroomTranslating { prime_radius, .. }
            | Follower::RollerOscillating { prime_radius, .. }
            | Follower::MushroomOscillating { prime_radius, .. } => *prime_radius = base + rolling,
            Follower::TranslatingCam { base_height, .. } => *base_height = base,
            Follower::Barrel { radius, .. } => *radius = base,
        }
        self
    }

    /// Offset of the follower's line of motion, m; 0 for followers without an offset.
    pub fn offset(&self) -> f64 {
        match *self {
            Follower::RollerTranslating { offset, .. }
            | Follower::MushroomTranslating { offset, .. } => offset,
            _ => 0.0,
        }
    }

    /// Offset of a flat face on an arm from its parallel through the pivot, m; 0 for other followers.
    pub(super) fn face_offset(&self) -> f64 {
        match *self {
            Follower::FlatOscillating { face_offset, .. } => face_offset,
            _ => 0.0,
        }
    }

    /// Radius of the roller or of the mushroom's arc, m; 0 for other followers.
    pub fn roller_radius(&self) -> f64 {
        match *self {
            Follower::FlatTranslating { .. } | Follower::FlatOscillating { .. } => 0.0,
            Follower::RollerTranslating { roller_radius, .. }
            | Follower::RollerOscillating { roller_radius, .. }
            | Follower::TranslatingCam { roller_radius, .. }
            | Follower::Barrel { roller_radius, .. } => roller_radius,
            Follower::MushroomTranslating { arc_radius, .. }
            | Follower::MushroomOscillating { arc_radius, .. } => arc_radius,
        }
    }

    /// Whether the profile extends along a line: a translating cam, or an unrolled barrel. Such a profile has two ends even if the law is
    /// closed.
    pub fn is_unrolled(&self) -> bool {
        matches!(
            self,
            Follower::TranslatingCam { .. } | Follower::Barrel { .. }
        )
    }

    /// Height D = √(Rp² − e²) of a translating follower at s = 0, m, with the prime radius Rp and the offset e. It is the height of the
    /// face, or of the circle's centre, above the cam centre.
    pub fn start_height(&self) -> f64 {
        let (rp, e) = (self.prime_radius(), self.offset());
        (rp * rp - e * e).sqrt()
    }

    /// Position of the follower at s = 0. It is the height above the cam centre, m, or the angle of the arm, rad.
    pub(super) fn start_place(&self) -> f64 {
        self.start_angle().unwrap_or_else(|| self.start_height())
    }

    /// Base radius, m, for which the follower is at the position `start` when s = 0.
    pub(super) fn base_radius_at(&self, start: f64) -> f64 {
        let radius = self.roller_radius();
        match (self.pivot(), self.arm()) {
            (Some([c, _]), Some(Arm { length, .. })) => {
                (length * length + c * c - 2.0 * length * c.abs() * libm::cos(start)).sqrt()
                    - radius
            }
            (Some([c, _]), None) => self.face_offset() + c.abs() * libm::sin(start),
            (None, _) => libm::hypot(start, self.offset()) - radius,
        }
    }

    /// Copy of the follower with the base radius for which its position is `start` when s = 0. `None` if no such base radius exists.
    pub(super) fn with_start_place(&self, start: f64) -> Option<Follower> {
        let flat_arm = self.pivot().is_some() && self.arm().is_none();
        let base = self.base_radius_at(start);
        ((start > 0.0 || flat_arm) && base > 0.0).then(|| self.with_base_radius(base))
    }

    /// Angle ξ₀ of the arm at s = 0, rad; `None` for followers without an arm. NaN if the arm cannot reach the prime circle;
    /// [`Cam::check`](super::Cam::check) rejects such an arm.
    pub fn start_angle(&self) -> Option<f64> {
        let (c, prime) = (self.pivot()?[0].abs(), self.prime_radius());
        Some(match self.arm() {
            Some(Arm { length, .. }) => {
                let cos = (length * length + c * c - prime * prime) / (2.0 * length * c);
                libm::acos(cos)
            }
            None => libm::asin((prime - self.face_offset()) / c),
        })
    }

    /// Converts a lift to a quantity with its unit: a length, or the angle of an arm.
    pub(super) fn lift_quantity(&self, lift: f64) -> Quantity {
        if self.is_oscillating() {
            Quantity::angle(lift)
        } else {
            Quantity::length(lift)
        }
    }

    /// Minimum and maximum lift of a law, m (or rad for an arm).
    pub(super) fn lift_range(law: &Law) -> (f64, f64) {
        let (low, high) = law.extremes(0);
        (low.value, high.value)
    }
}

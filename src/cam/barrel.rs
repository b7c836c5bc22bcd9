//! Barrel cams: a groove around a cylinder, with both walls computed in space at any depth.
//!
//! The z axis is the barrel's axis. A roller with a radial axis is at z = s(θ). The barrel turns counter-clockwise. In the barrel's frame,
//! the roller moves around the z axis by −θ. The groove is unrolled at a distance R from the z axis, where its slope is tan φ = v/R, with
//! the derivative v of the lift s (Bautista Morelos 2018, eq. 30). The contact points with the walls are at ±R_f (roller radius) from the
//! roller's centre, along the normal of the unrolled groove.

use super::Follower;
use super::geometry::{Geometry, finished_radius};
use crate::error::{CamError, Result};
use crate::law::{Law, Svaj};
use crate::poly::Extreme;
use crate::units::Quantity;
use serde::Serialize;

/// Rollers on the stud that runs in the groove of a barrel cam.
///
/// ```
/// use gaitcam::cam::{BarrelGroove, Rollers};
/// use gaitcam::law::Law;
///
/// // A stud with two rollers of radius 5 mm and eccentricity ±0.2 mm. The groove is wide enough for both rollers.
/// let rollers = Rollers::TwoEccentric { radius: 0.005, eccentricity: 0.0002 };
/// let law = Law::harmonic(0.0, &[(0.01, 0.0)]);
/// let groove = BarrelGroove::new(law, 0.04, 0.05, rollers)?;
/// assert_eq!(groove.roller_radius(), 0.005);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rollers {
    /// One roller. It touches one wall at a time, and its sense of rotation is reversed when the wall changes.
    One {
        /// Radius of the roller, m.
        radius: f64,
    },
    /// Two equal rollers on one stud, one above the other along the stud, with axes at ±eccentricity along z. Each roller touches only one
    /// wall (desmodromic, Bautista Morelos 2018).
    TwoEccentric {
        /// Radius of both rollers, m.
        radius: f64,
        /// Offset between the axis of each roller and the axis of the stud, m.
        eccentricity: f64,
    },
}

impl Rollers {
    fn radius(self) -> f64 {
        match self {
            Rollers::One { radius } | Rollers::TwoEccentric { radius, .. } => radius,
        }
    }

    /// Distance between the axis of each roller and the middle of the groove, m; 0 for one roller.
    fn eccentricity(self) -> f64 {
        match self {
            Rollers::One { .. } => 0.0,
            Rollers::TwoEccentric { eccentricity, .. } => eccentricity,
        }
    }
}

/// Wall of the groove, on the side of +z or of −z.
///
/// ```
/// use gaitcam::cam::{BarrelGroove, Rollers, Wall};
/// use gaitcam::law::Law;
///
/// // For a constant lift, both walls are circles at the distance of one roller radius from the middle line of the groove.
/// let rest = Law::harmonic(0.0, &[]);
/// let groove = BarrelGroove::new(rest, 0.04, 0.05, Rollers::One { radius: 0.005 })?;
/// let [upper, lower] = [Wall::Upper, Wall::Lower].map(|wall| groove.wall_point(1.0, 0.05, wall));
/// assert!((upper[2] - lower[2] - 0.01).abs() < 1e-15);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wall {
    /// The wall on the side of +z, index 1 in Bautista Morelos (2018).
    Upper,
    /// The wall on the side of −z, index 2 in Bautista Morelos (2018).
    Lower,
}

impl Wall {
    fn sign(self) -> f64 {
        match self {
            Wall::Upper => 1.0,
            Wall::Lower => -1.0,
        }
    }
}

/// Groove of a barrel cam, defined by law of motion, inner and outer radius, and rollers.
///
/// ```
/// use gaitcam::cam::{BarrelGroove, Rollers};
/// use gaitcam::law::Law;
///
/// // tan φ = s′/R. For s = 20 mm cos θ and R = 50 mm, the maximum of |tan φ| is 0.4, at θ = 90°.
/// let law = Law::harmonic(0.0, &[(0.02, 0.0)]);
/// let groove = BarrelGroove::new(law, 0.045, 0.055, Rollers::One { radius: 0.005 })?;
/// let angle = groove.pressure_angle(std::f64::consts::FRAC_PI_2, 0.05);
/// assert!((angle.tan().abs() - 0.4).abs() < 1e-12);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BarrelGroove {
    law: Law,
    inner: f64,
    outer: f64,
    rollers: Rollers,
}

impl BarrelGroove {
    /// Creates a groove between the radii `inner` (floor of the groove) and `outer` (surface of the cylinder), m. The law may extend over
    /// several turns.
    ///
    /// # Errors
    ///
    /// The rollers do not fit the groove, or a barrel cam cannot execute the law.
    pub fn new(law: Law, inner: f64, outer: f64, rollers: Rollers) -> Result<BarrelGroove> {
        if !(inner > 0.0 && outer > inner && outer.is_finite()) {
            return Err(CamError::GrooveDepth {
                floor: Quantity::length(inner),
                surface: Quantity::length(outer),
            }
            .into());
        }
        let (radius, eccentricity) = (rollers.radius(), rollers.eccentricity());
        if !(radius > 0.0 && eccentricity >= 0.0 && eccentricity.is_finite()) {
            return Err(CamError::GrooveRollers {
                radius: Quantity::length(radius),
                eccentricity: Quantity::length(eccentricity),
            }
            .into());
        }
        if radius >= inner {
            return Err(CamError::GrooveFloor {
                radius: Quantity::length(radius),
                floor: Quantity::length(inner),
            }
            .into());
        }
        Ok(BarrelGroove {
            law,
            inner,
            outer,
            rollers,
        })
    }

    /// Law of motion of the roller along z, m.
    pub fn law(&self) -> &Law {
        &self.law
    }

    /// Radii of the floor of the groove and of the surface of the cylinder, m.
    pub fn depth(&self) -> (f64, f64) {
        (self.inner, self.outer)
    }

    /// Radius of the rollers, m.
    pub fn roller_radius(&self) -> f64 {
        self.rollers.radius()
    }

    /// Offset along z from the middle line of the groove to the axis of the roller on `wall`, m.
    pub fn axis_offset(&self, wall: Wall) -> f64 {
        wall.sign() * self.rollers.eccentricity()
    }

    /// Pressure angle φ, rad, at the distance `radius` from the cam axis. It is positive during a rise. tan φ = v/R, with the derivative v
    /// of the lift and R = `radius`.
    pub fn pressure_angle(&self, theta: f64, radius: f64) -> f64 {
        libm::atan(self.law.svaj(theta).v / radius)
    }

    /// Minimum and maximum pressure angle, rad, at the distance `radius` from the cam axis. The absolute angles are largest at the floor of
    /// the groove.
    pub fn pressure_angle_extremes(&self, radius: f64) -> (Extreme, Extreme) {
        let (low, high) = self.law.extremes(1);
        let angle = |e: Extreme| e.map(|v| libm::atan(v / radius));
        (angle(low), angle(high))
    }

    /// Maximum absolute pressure angles, rad, during the rise and during the fall of the follower. They apply to the point on the roller
    /// axis at the distance `radius` from the cam axis.
    pub fn pressure_angles_by_motion(&self, radius: f64) -> [Extreme; 2] {
        let (low, high) = self.pressure_angle_extremes(radius);
        [high, low.map(|angle| -angle)].map(|side| side.map(|angle| angle.max(0.0)))
    }

    /// Radius of curvature of the middle line of the groove, unrolled at `radius`, m. It is positive where the line bends towards −z, and
    /// infinite where the line is straight.
    pub fn rho_pitch(&self, theta: f64, radius: f64) -> f64 {
        1.0 / self.pitch_curvature(self.law.svaj(theta), radius)
    }

    /// Signed radius of curvature of a wall, unrolled at `radius`, m. It is positive where the wall is convex towards the groove. A convex
    /// wall is undercut where the radius of curvature of the middle line is below the radius of the roller.
    pub fn rho_wall(&self, theta: f64, radius: f64, wall: Wall) -> f64 {
        // The material of the lower wall is below the groove and the material of the upper wall is above it. Their curvatures have opposite
        // signs.
        -wall.sign() * self.rho_pitch(theta, radius) - self.roller_radius()
    }

    /// Minimum convex radius of curvature of a wall, unrolled at `radius`, m. A negative value means undercut. The value is infinite for a
    /// wall without a convex part.
    pub fn smallest_bulge(&self, radius: f64, wall: Wall) -> Extreme {
        let side = -wall.sign();
        let bulge = |at| side * self.pitch_curvature(at, radius);
        let (_, high) = self.law.extremes_by(bulge);
        finished_radius(high, self.roller_radius())
    }

    /// Contact point of a wall and its roller in the barrel's frame, m. `radius` is the distance from the cam axis along the roller axis.
    /// The wall is the exact envelope of a cylindrical roller with a radial axis.
    pub fn wall_point(&self, theta: f64, radius: f64, wall: Wall) -> [f64; 3] {
        let at = self.law.svaj(theta);
        let [across, up] = self.wall_offset(at, radius, wall);
        // Before the rotation, the roller axis is along +x, and the groove extends along −y.
        let (sin, cos) = libm::sincos(theta);
        let (x, y) = (radius, -across);
        [
            cos * x + sin * y,
            cos * y - sin * x,
            at.s + self.axis_offset(wall) + up,
        ]
    }

    /// Curvature of the middle line of the groove, unrolled at `radius`, 1/m; positive if the line bends towards −z.
    fn pitch_curvature(&self, at: Svaj, radius: f64) -> f64 {
        let roller_radius = self.roller_radius();
        let unrolled = Follower::Barrel {
            radius,
            roller_radius,
        };
        Geometry::new(&unrolled).pitch_curvature(at)
    }

    /// Vector from the axis of the roller to the contact point on the groove unrolled at `radius`, m: component along the circumference
    /// (towards increasing θ) and component along z.
    fn wall_offset(&self, at: Svaj, radius: f64, wall: Wall) -> [f64; 2] {
        let slope = at.v / radius;
        let unit = wall.sign() * self.roller_radius() / (1.0 + slope * slope).sqrt();
        [-slope * unit, unit]
    }
}

//! Barrel cams: a groove around a cylinder with both walls in space, at any depth.
//!
//! The barrel's axis is z; a roller with a radial axis is at z = s(θ). Seen from the barrel, which
//! turns counter-clockwise, the roller goes round by −θ. On its axis at radius R the roller slides along
//! the unrolled groove at the angle tan φ = v/R (Bautista Morelos 2018, eq. 30), and touches the walls at ±R_f along
//! the groove's normal.

use super::Follower;
use super::geometry::{Geometry, finished_radius};
use crate::error::{CamError, Result};
use crate::law::{Law, Svaj};
use crate::poly::Extreme;
use crate::units::Quantity;
use serde::Serialize;

/// The rollers in the groove.
///
/// ```
/// use gaitcam::cam::{BarrelGroove, Rollers};
/// use gaitcam::law::Law;
///
/// // A stud with two rollers of 5 mm, set off by ±0.2 mm: the groove is wide enough for both.
/// let rollers = Rollers::TwoEccentric { radius: 0.005, eccentricity: 0.0002 };
/// let law = Law::harmonic(0.0, &[(0.01, 0.0)]);
/// let groove = BarrelGroove::new(law, 0.04, 0.05, rollers)?;
/// assert_eq!(groove.roller_radius(), 0.005);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rollers {
    /// One roller: it touches one wall at a time, and its sense of rotation changes with the wall.
    One {
        /// Radius of the roller, m.
        radius: f64,
    },
    /// Two equal rollers on one stud, one above the other along the stud, set off by ±eccentricity along
    /// z: each keeps to its own wall (desmodromic, Bautista Morelos 2018).
    TwoEccentric {
        /// Radius of both rollers, m.
        radius: f64,
        /// Offset of each roller's axis from the stud's, m.
        eccentricity: f64,
    },
}

impl Rollers {
    fn radius(self) -> f64 {
        match self {
            Rollers::One { radius } | Rollers::TwoEccentric { radius, .. } => radius,
        }
    }

    /// Distance of each roller's axis from the groove's middle, m.
    fn eccentricity(self) -> f64 {
        match self {
            Rollers::One { .. } => 0.0,
            Rollers::TwoEccentric { eccentricity, .. } => eccentricity,
        }
    }
}

/// One side of the groove.
///
/// ```
/// use gaitcam::cam::{BarrelGroove, Rollers, Wall};
/// use gaitcam::law::Law;
///
/// // At rest both walls are parallels, one roller radius from the axis of the groove.
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

/// A groove: law, depth and rollers.
///
/// ```
/// use gaitcam::cam::{BarrelGroove, Rollers};
/// use gaitcam::law::Law;
///
/// // tan φ = s′/R: 20 mm cos θ on a radius of 50 mm is steepest at θ = 90°, where tan φ = 0.4.
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
    /// A groove between the radii `inner` (its floor) and `outer` (the cylinder's surface), m; the law
    /// may run over several turns.
    ///
    /// # Errors
    /// Rollers that do not fit the groove, or a law that a barrel does not allow.
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

    /// The law of motion along z.
    pub fn law(&self) -> &Law {
        &self.law
    }

    /// Radii of floor and surface, m.
    pub fn depth(&self) -> (f64, f64) {
        (self.inner, self.outer)
    }

    /// Radius of the rollers, m.
    pub fn roller_radius(&self) -> f64 {
        self.rollers.radius()
    }

    /// Offset along z of the axis of the roller that touches a wall, m.
    pub fn axis_offset(&self, wall: Wall) -> f64 {
        wall.sign() * self.rollers.eccentricity()
    }

    /// Pressure angle on a roller's axis at `radius`, rad, positive when rising: tan φ = v/R.
    pub fn pressure_angle(&self, theta: f64, radius: f64) -> f64 {
        (self.law.svaj(theta).v / radius).atan()
    }

    /// Smallest and largest pressure angle on the axis at `radius`, rad: steepest at the floor.
    pub fn pressure_angle_extremes(&self, radius: f64) -> (Extreme, Extreme) {
        let (low, high) = self.law.extremes(1);
        let angle = |e: Extreme| e.map(|v| (v / radius).atan());
        (angle(low), angle(high))
    }

    /// Largest |pressure angle| on the axis at `radius`, rad, where the follower rises and where it falls.
    pub fn pressure_angles_by_motion(&self, radius: f64) -> [Extreme; 2] {
        let (low, high) = self.pressure_angle_extremes(radius);
        [high, low.map(|angle| -angle)].map(|side| side.map(|angle| angle.max(0.0)))
    }

    /// Radius of curvature of the unrolled groove's middle line at `radius`, m: positive where it bends
    /// towards −z (convex seen from below), infinite where straight.
    pub fn rho_pitch(&self, theta: f64, radius: f64) -> f64 {
        1.0 / self.pitch_curvature(self.law.svaj(theta), radius)
    }

    /// Signed radius of curvature of a wall, unrolled at `radius`, m: positive where the wall bulges into
    /// the groove. Undercut where positive pitch radii fall below the roller's.
    pub fn rho_wall(&self, theta: f64, radius: f64, wall: Wall) -> f64 {
        // The lower wall's body lies below, the upper one's above: their curvatures have opposite signs.
        -wall.sign() * self.rho_pitch(theta, radius) - self.roller_radius()
    }

    /// Smallest radius with which a wall bulges into the groove at `radius`, m; negative: undercut.
    /// Infinite for a wall without a convex part.
    pub fn smallest_bulge(&self, radius: f64, wall: Wall) -> Extreme {
        let side = -wall.sign();
        let bulge = |at| side * self.pitch_curvature(at, radius);
        let (_, high) = self.law.extremes_by(bulge);
        finished_radius(high, self.roller_radius())
    }

    /// The point of a wall in space that touches its roller where the roller's axis is at `radius`,
    /// barrel frame, m: the exact envelope of a cylindrical roller with a radial axis.
    pub fn wall_point(&self, theta: f64, radius: f64, wall: Wall) -> [f64; 3] {
        let at = self.law.svaj(theta);
        let [across, up] = self.wall_offset(at, radius, wall);
        // Before turning: axis along +x, the groove's length along −y.
        let (sin, cos) = theta.sin_cos();
        let (x, y) = (radius, -across);
        [
            cos * x + sin * y,
            cos * y - sin * x,
            at.s + self.axis_offset(wall) + up,
        ]
    }

    /// Curvature of the unrolled middle line, positive if it bends towards −z.
    fn pitch_curvature(&self, at: Svaj, radius: f64) -> f64 {
        let roller_radius = self.roller_radius();
        let unrolled = Follower::Barrel {
            radius,
            roller_radius,
        };
        Geometry::new(&unrolled).pitch_curvature(at)
    }

    /// Vector from the roller's axis to the contact: along the groove (increasing θ) and along z.
    fn wall_offset(&self, at: Svaj, radius: f64, wall: Wall) -> [f64; 2] {
        let slope = at.v / radius;
        let unit = wall.sign() * self.roller_radius() / (1.0 + slope * slope).sqrt();
        [-slope * unit, unit]
    }
}

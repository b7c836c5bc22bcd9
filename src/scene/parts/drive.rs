//! `[drive]`: relation between lift and force.

use super::CamSpec;
use crate::drive::DriveKind;
use crate::units::G;

/// Relation between lift and force in the machine.
///
/// ```
/// use gaitcam::drive::DriveKind;
/// use gaitcam::scene::DriveSpec;
///
/// let drive = DriveSpec { preload: 30.0, speed: Some(10.0), ..DriveSpec::fixed_axis(0.5, 2000.0) };
/// assert_eq!((drive.kind, drive.preload, drive.speed), (DriveKind::FixedAxis, 30.0, Some(10.0)));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct DriveSpec {
    /// Kind of the drive: moving axis, fixed axis or hydraulic.
    pub kind: DriveKind,
    /// Moved mass, kg (moment of inertia, kg·m², for an arm); `None`: mean force divided by g.
    pub mass: Option<f64>,
    /// Speed of the cam, rad/s; `None`: one turn per cycle of the force.
    pub speed: Option<f64>,
    /// Gravitational acceleration g, m/s².
    pub gravity: f64,
    /// Pressure per displaced volume of a hydraulic drive, Pa/m³.
    pub pressure_per_volume: f64,
    /// Radius of the piston of a hydraulic drive, m.
    pub piston_radius: f64,
    /// Spring rate on a fixed axis, N/m (N·m/rad for an arm).
    pub spring_rate: f64,
    /// Preload of the spring on a fixed axis, with the follower on the base circle, N (N·m for an arm).
    pub preload: f64,
    /// Damping coefficient on a fixed axis, N·s/m; not available for an arm.
    pub damping: f64,
    /// Distance from the pivot at which the target force and the piston act on an arm, m. The default `None` selects the length of the arm,
    /// or the pivot distance for a flat face.
    pub lever: Option<f64>,
}

impl Default for DriveSpec {
    fn default() -> DriveSpec {
        DriveSpec {
            kind: DriveKind::MovingAxis,
            mass: None,
            speed: None,
            gravity: G,
            pressure_per_volume: 0.0,
            piston_radius: 0.0,
            spring_rate: 0.0,
            preload: 0.0,
            damping: 0.0,
            lever: None,
        }
    }
}

impl DriveSpec {
    /// Drive with a moving axis: the block that carries the camshaft has the mass `mass`, kg, and moves with the cam.
    #[must_use]
    pub fn moving_axis(mass: f64) -> DriveSpec {
        DriveSpec {
            mass: Some(mass),
            ..DriveSpec::default()
        }
    }

    /// Drive with a fixed axis: the cam moves the mass `mass`, kg, against a spring of `spring_rate`, N/m.
    #[must_use]
    pub fn fixed_axis(mass: f64, spring_rate: f64) -> DriveSpec {
        DriveSpec {
            kind: DriveKind::FixedAxis,
            mass: Some(mass),
            spring_rate,
            ..DriveSpec::default()
        }
    }

    /// Hydraulic drive with a pressure per displaced volume, Pa/m³, and a piston radius, m.
    #[must_use]
    pub fn hydraulic(pressure_per_volume: f64, piston_radius: f64) -> DriveSpec {
        DriveSpec {
            kind: DriveKind::Hydraulic,
            pressure_per_volume,
            piston_radius,
            ..DriveSpec::default()
        }
    }

    /// Default kind of drive for a cam. It is a moving axis for a disc cam with a translating follower, otherwise a fixed axis.
    pub fn usual_kind(cam: &CamSpec) -> DriveKind {
        if cam.follower.is_translating() {
            DriveKind::MovingAxis
        } else {
            DriveKind::FixedAxis
        }
    }
}

//! `[drive]`: relation of lift and force.

use super::CamSpec;
use crate::drive::DriveKind;
use crate::units::G;

/// Relation of lift and force.
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
    /// Kind of drive.
    pub kind: DriveKind,
    /// Moved mass, kg (for an arm the moment of inertia, kg·m²); `None`: mean force / g.
    pub mass: Option<f64>,
    /// Cam speed, rad/s; `None`: one turn per cycle.
    pub speed: Option<f64>,
    /// Gravitational acceleration g, m/s².
    pub gravity: f64,
    /// For a hydraulic drive: pressure per displaced volume, Pa/m³.
    pub pressure_per_volume: f64,
    /// For a hydraulic drive: radius of the piston, m.
    pub piston_radius: f64,
    /// For a fixed axis: spring rate, N/m (for an arm N·m/rad).
    pub spring_rate: f64,
    /// For a fixed axis: preload on the base circle, N (for an arm N·m).
    pub preload: f64,
    /// For a fixed axis: damping, N·s/m.
    pub damping: f64,
    /// For oscillating followers: distance from the pivot at which the target force and the piston act, m; `None`: the length of the arm, or the
    /// pivot distance for a flat face.
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
    /// Drive with a moving axis: the shaft block of mass `mass`, kg, moves with the cam.
    #[must_use]
    pub fn moving_axis(mass: f64) -> DriveSpec {
        DriveSpec {
            mass: Some(mass),
            ..DriveSpec::default()
        }
    }

    /// Drive with a fixed axis: the cam lifts `mass`, kg, against a spring of `spring_rate`, N/m.
    #[must_use]
    pub fn fixed_axis(mass: f64, spring_rate: f64) -> DriveSpec {
        DriveSpec {
            kind: DriveKind::FixedAxis,
            mass: Some(mass),
            spring_rate,
            ..DriveSpec::default()
        }
    }

    /// Hydraulic drive with the given pressure per displaced volume, Pa/m³, and piston radius, m.
    #[must_use]
    pub fn hydraulic(pressure_per_volume: f64, piston_radius: f64) -> DriveSpec {
        DriveSpec {
            kind: DriveKind::Hydraulic,
            pressure_per_volume,
            piston_radius,
            ..DriveSpec::default()
        }
    }

    /// Default drive for a cam. A moving axis is only possible for a disc cam with a translating follower.
    pub fn usual_kind(cam: &CamSpec) -> DriveKind {
        if cam.follower.is_translating() {
            DriveKind::MovingAxis
        } else {
            DriveKind::FixedAxis
        }
    }
}

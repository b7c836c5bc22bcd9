//! The figures of a design: what a row of a table says of it.

use std::convert::Infallible;

use super::{Design, ForceReport, MachineReport};
use crate::cam::Cam;
use crate::drive::Drive;
use crate::problem::Memo;

/// Figures of one design, SI.
///
/// ```
/// use gaitcam::synth::Figures;
/// use gaitcam::{scene, synthesise};
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let figures = Figures::of(&design);
/// assert_eq!(figures.stroke, design.cam.law.stroke());
/// assert!((figures.mass - 700.0 / 9.81).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figures {
    /// Force against target.
    pub force: ForceReport,
    /// Moved mass, kg.
    pub mass: f64,
    /// Speed of the shaft, rad/s.
    pub speed: f64,
    /// Largest lift less smallest.
    pub stroke: f64,
    /// Largest |velocity|, |acceleration| and |jerk| by time.
    pub peaks: [f64; 3],
    /// Radius of the base circle.
    pub base_radius: f64,
    /// Radius of the prime circle.
    pub prime_radius: f64,
    /// Offset of the follower.
    pub offset: f64,
    /// Smallest radius of curvature of the profile where it is convex.
    pub smallest_convex_radius: f64,
    /// Largest |pressure angle|, rad.
    pub largest_pressure_angle: f64,
    /// Width of the face that the contact needs; `None` without a flat face.
    pub face_width: Option<f64>,
    /// What the design asks of the machine.
    pub machine: MachineReport,
}

/// Figures that take roots to find.
#[derive(Clone, Copy)]
struct Extremes {
    stroke: f64,
    peaks: [f64; 3],
    smallest_convex_radius: f64,
    largest_pressure_angle: f64,
    face_width: Option<f64>,
    machine: MachineReport,
}

/// What they depend on, of one cam that is cut for its own law.
#[derive(PartialEq)]
struct ExtremesKey {
    cam: Cam,
    drive: Drive,
    thickness: f64,
}

impl Extremes {
    fn of(design: &Design) -> Extremes {
        let (cam, speed) = (&design.cam, design.drive.speed);
        let (low, high) = design.pressure_angle_extremes();
        Extremes {
            stroke: cam.law.stroke(),
            peaks: [1, 2, 3].map(|order| {
                let (low, high) = cam.derivative_extremes(order);
                high.value.max(-low.value) * speed.powi(order as i32)
            }),
            smallest_convex_radius: cam.curvature().convex.value,
            largest_pressure_angle: high.value.max(-low.value),
            face_width: cam.face_width(),
            machine: design.machine(),
        }
    }

    /// As they were found for the same cam on the same machine, where `memo` has them.
    fn known(design: &Design, memo: &Memo) -> Extremes {
        if design.end.is_some() || design.conjugate.is_some() || design.groove.is_some() {
            return Extremes::of(design);
        }
        let key = ExtremesKey {
            cam: design.cam.clone(),
            drive: design.drive,
            thickness: design.thickness,
        };
        let known = memo.found(key, || Ok::<_, Infallible>(Extremes::of(design)));
        known.unwrap_or_else(|never| match never {})
    }
}

impl Figures {
    /// Of a finished design.
    pub fn of(design: &Design) -> Figures {
        Figures::with(design, Extremes::of(design))
    }

    /// Of a finished design; what designs with the same memo have found is not sought again.
    pub(crate) fn known(design: &Design, memo: &Memo) -> Figures {
        Figures::with(design, Extremes::known(design, memo))
    }

    fn with(design: &Design, extremes: Extremes) -> Figures {
        let follower = &design.cam.follower;
        Figures {
            force: design.force,
            mass: design.drive.mass,
            speed: design.drive.speed,
            stroke: extremes.stroke,
            peaks: extremes.peaks,
            base_radius: follower.base_radius(),
            prime_radius: follower.prime_radius(),
            offset: follower.offset(),
            smallest_convex_radius: extremes.smallest_convex_radius,
            largest_pressure_angle: extremes.largest_pressure_angle,
            face_width: extremes.face_width,
            machine: extremes.machine,
        }
    }
}

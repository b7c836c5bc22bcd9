//! The figures of a design: what a row of a table says of it.

use super::{Design, ForceReport, MachineReport};

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

impl Figures {
    /// Of a finished design.
    pub fn of(design: &Design) -> Figures {
        let (cam, speed) = (&design.cam, design.drive.speed);
        let (follower, (low, high)) = (&cam.follower, design.pressure_angle_extremes());
        Figures {
            force: design.force,
            mass: design.drive.mass,
            speed,
            stroke: cam.law.stroke(),
            peaks: [1, 2, 3].map(|order| {
                let (low, high) = cam.derivative_extremes(order);
                high.value.max(-low.value) * speed.powi(order as i32)
            }),
            base_radius: follower.base_radius(),
            prime_radius: follower.prime_radius(),
            offset: follower.offset(),
            smallest_convex_radius: cam.curvature().convex.value,
            largest_pressure_angle: high.value.max(-low.value),
            face_width: cam.face_width(),
            machine: design.machine(),
        }
    }
}

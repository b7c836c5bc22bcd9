//! Report on the end of a compliant follower with a polydyne cam.

use serde::Serialize;

use crate::dynamics::flexible::polydyne::Miss;
use crate::law::Law;
use crate::problem::Note;
use crate::units::{Dimension, Quantity};

/// Motion of the end of a compliant follower with a polydyne cam (`law.polydyne`).
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // The stiffness k = M (2π f)² follows from the moved mass M and the natural frequency f.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let scene = scene.with("machine.natural_frequency", "12 Hz")?.with("law.degree", "7")?.with("law.polydyne", "true")?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let end = design.end.as_ref().unwrap();
/// let stiffness = design.problem.drive.mass * (std::f64::consts::TAU * 12.0).powi(2);
/// assert!((end.stiffness / stiffness - 1.0).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct End {
    /// Law of the end. The law of the cam differs by the deflection of the follower.
    pub law: Law,
    /// Stiffness of the follower train, N/m (for an arm N·m/rad).
    pub stiffness: f64,
    /// Damping at the end of the follower, N·s/m (for an arm N·m·s/rad).
    pub damping: f64,
    /// Deviation of the end from its law, with this cam; `None` without a steady state.
    pub miss: Option<Miss>,
    /// Deviation of the end from its law, with a cam that has the law of the end instead of the polydyne law; `None` without a steady state.
    pub plain_miss: Option<Miss>,
}

impl End {
    /// Notes that state the speed (argument in rad/s), the stiffness and the deviation of the end.
    pub fn notes(&self, speed: f64) -> Vec<Note> {
        let mut out = vec![Note::Polydyne {
            speed: Quantity::new(speed, Dimension::AngularSpeed),
            stiffness: Quantity::new(self.stiffness, Dimension::SpringRate),
        }];
        if let (Some(own), Some(plain)) = (self.miss, self.plain_miss) {
            out.push(Note::PolydyneMiss {
                own: Quantity::force(own.force_rms),
                plain: Quantity::force(plain.force_rms),
            });
        }
        out
    }
}

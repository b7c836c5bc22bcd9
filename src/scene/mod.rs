//! A scene: the input of the user, which describes the whole problem.
//!
//! Every key of a scene file is one row of the table in [`keys`]. This table is used for reading, writing, changing, sweeping and relaxing scenes.

mod builtin;
mod files;
pub mod keys;
mod motion_file;
mod notes;
mod parts;
mod read;
mod rules;
mod set;
mod walkers;
mod write;

pub(crate) use crate::criterion::LimitKind;
pub use builtin::{DEFAULT, EXAMPLE_RECORDING, SCENES, built_in, built_in_file};
pub use files::{BETWEEN_PLATES, Files, content, plates};
pub use motion_file::{LARGEST_MOTION, motion_files, with_motions};
pub(crate) use parts::{Adjust, Band, ForceScale, Phase, PhaseWeight, StepFrequencies};
pub use parts::{
    CamSpec, DriveSpec, Dwell, ErrorMeasure, Family, Gait, Harmonic, KeywaySpec, LawPoint, LawSpec,
    Limits, MachineSpec, Minimise, MotorSpec, Robust, SegmentSpec, ShaftSpeed, Source,
};
pub use read::{parse, read, read_keys, table};
pub(crate) use rules::check;
pub use set::{set, set_value, unset};

use crate::error::Result;
use crate::force::ForceCurve;

/// Description of the whole problem, as read from a scene file. Depending on the field, `None` means `"auto"` or that the key is absent.
///
/// ```
/// use gaitcam::scene::{CamSpec, Gait, LawSpec};
/// use gaitcam::{LimitKind, Scene, scene};
/// use gaitcam::scene::Limits;
///
/// // The footbridge scene without its file.
/// let made = Scene {
///     name: "footbridge".to_string(),
///     gait: Some(Gait { step_frequency: Some(1.85), body_weight: Some(700.0), ..Gait::model("young") }),
///     law: LawSpec { degree: Some(5), ..LawSpec::default() },
///     cam: CamSpec { bore: Some(0.012), ..CamSpec::default() },
///     limits: Limits::default().with(LimitKind::Stroke, 0.06).with(LimitKind::Curvature, 0.005),
///     rms: Some(0.005),
///     ..Scene::default()
/// };
/// assert_eq!(made, scene::built_in("footbridge")?.scene()?);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Name of the scene and of its output folder.
    pub name: String,
    /// Target force; `None` if only points, dwells or segments determine the law.
    pub gait: Option<Gait>,
    /// Drive: relation between lift and force.
    pub drive: DriveSpec,
    /// Family, resolution and exact conditions of the law.
    pub law: LawSpec,
    /// Dimensions and material of the cam and its follower.
    pub cam: CamSpec,
    /// Limits of the design, in SI units.
    pub limits: Limits,
    /// Properties of the machine in addition to its drive.
    pub machine: MachineSpec,
    /// Permitted RMS force error, relative to the mean force; `None`: the default.
    pub rms: Option<f64>,
}

impl Default for Scene {
    /// Scene of a disc cam with a flat face on a moving axis, without a target force and without limits.
    fn default() -> Scene {
        Scene {
            name: "cam".to_string(),
            gait: None,
            drive: DriveSpec::default(),
            law: LawSpec::default(),
            cam: CamSpec::default(),
            limits: Limits::default(),
            machine: MachineSpec::default(),
            rms: None,
        }
    }
}

impl Scene {
    /// Force of the load model in the scene; `None` if the scene has no load model.
    ///
    /// # Errors
    ///
    /// The errors of [`Gait::model_force`].
    pub fn model_force(&self) -> Result<Option<ForceCurve>> {
        let force = self.gait.as_ref().map(Gait::model_force);
        Ok(force.transpose()?.flatten())
    }
}

//! Built-in scenes of the library.

use std::path::Path;

use super::{Scene, parse};
use crate::error::{Error, Result, SceneError, nearest};

/// A built-in scene of the library, with its name and text.
///
/// ```
/// use gaitcam::{LimitKind, scene};
///
/// let footbridge = scene::built_in("footbridge")?;
/// assert_eq!(footbridge.scene()?.limits[LimitKind::Stroke], Some(0.06));
/// assert!(scene::built_in("foot-bridge").is_err());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BuiltIn {
    /// Name of the built-in scene.
    pub name: &'static str,
    /// Text of the scene in TOML.
    pub toml: &'static str,
}

impl BuiltIn {
    /// Reads the scene from its text.
    ///
    /// # Errors
    ///
    /// None in practice, because tests read every built-in scene.
    pub fn scene(&self) -> Result<Scene> {
        parse(self.toml)
    }
}

macro_rules! scenes {
    ($($name:literal),+ $(,)?) => {
        [$(BuiltIn {
            name: $name,
            toml: include_str!(concat!("../../scenes/", $name, ".toml")),
        }),+]
    };
}

/// All built-in scenes, in the order in which they are listed.
pub const SCENES: [BuiltIn; 25] = scenes![
    "footbridge",
    "footbridge_double_harmonic",
    "footbridge_thesis_scale",
    "heel_tester",
    "heel_tester_fitted",
    "measured_walk",
    "mushroom",
    "translating_cam",
    "thesis_barrel",
    "thesis_iteration_1",
    "thesis_iteration_2",
    "thesis_iteration_3",
    "thesis_iteration_4",
    "camdas_01_roller",
    "camdas_02_oscillating_roller",
    "camdas_03_flat",
    "camdas_04_oscillating_flat",
    "camdas_05_constant_diameter",
    "camdas_06_constant_breadth",
    "camdas_07_conjugate_roller",
    "camdas_08_conjugate_flat",
    "camdas_09_eight_motions",
    "camdas_10_eccentric",
    "camdas_11_oscillating_roller",
    "camdas_12_oscillating_flat",
];

/// Default scene: a walker of 700 N on a footbridge, with 1.85 steps per second.
pub const DEFAULT: &str = SCENES[0].toml;

/// Contents of the input files of the built-in scenes, with the paths that the scenes use.
const FILES: [(&str, &[u8]); 2] = [
    (
        "../data/gait_curves/heel_tester_critical_points.csv",
        include_bytes!("../../data/gait_curves/heel_tester_critical_points.csv"),
    ),
    (
        EXAMPLE_RECORDING,
        include_bytes!("../../data/recordings/made_walk.csv"),
    ),
];

/// Path of the built-in recording for the scene `measured_walk`, which does not name a recording.
pub const EXAMPLE_RECORDING: &str = "../data/recordings/made_walk.csv";

/// Content of a built-in file, by its path in a scene; `None` if no built-in file has this path.
pub fn built_in_file(path: &Path) -> Option<&'static [u8]> {
    let found = FILES.iter().find(|f| Path::new(f.0) == path);
    found.map(|f| f.1)
}

/// The built-in scene with the given name.
///
/// # Errors
///
/// The name is unknown. The error contains the nearest known name.
pub fn built_in(name: &str) -> Result<&'static BuiltIn> {
    let found = SCENES.iter().find(|s| s.name == name);
    found.ok_or_else(|| {
        Error::from(SceneError::NoSuchScene {
            typed: name.to_string(),
            nearest: nearest(name, SCENES.iter().map(|s| s.name)).map(str::to_string),
            known: SCENES.map(|s| s.name).join(", "),
        })
    })
}

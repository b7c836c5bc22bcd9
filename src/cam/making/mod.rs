//! Manufacturing data of a cam: material, surface, tolerance and bore.

use serde::Serialize;

mod bore;
mod hardness;
mod material;

pub use bore::{Bore, Keyway};
pub use hardness::Hardness;
pub use material::{Material, STEEL, StatedMaterial, Stock};

/// Material, surface and tolerance; lengths in m.
///
/// ```
/// use gaitcam::cam::Making;
///
/// assert_eq!(Making::default().tolerance, None);
/// ```
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Making {
    /// Designation of the material; `None` for steel.
    pub material: Option<String>,
    /// Stated constants of the material. Missing elastic constants are those of a built-in material or of steel.
    pub stated: StatedMaterial,
    /// Hardness of the cam's surface.
    pub hardness: Option<Hardness>,
    /// Arithmetical mean roughness Ra of the profile, m.
    pub roughness: Option<f64>,
    /// Half width of the tolerance on the profile, m.
    pub tolerance: Option<f64>,
}

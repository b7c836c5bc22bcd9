//! Feet to which a force curve belongs.

use serde::Serialize;
use strum::{EnumString, IntoStaticStr};

use crate::error::{Error, ForceError};

/// Side of the body to which a foot belongs.
///
/// ```
/// use gaitcam_gait::Foot;
///
/// assert_eq!(Foot::Left.other(), Foot::Right);
/// assert_eq!(Foot::Left.name(), "left");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Foot {
    /// Left foot of the walker.
    Left,
    /// Right foot of the walker.
    Right,
}

impl Foot {
    /// Name of the foot in files and options: `left` or `right`.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// The foot on the other side of the body.
    #[must_use]
    pub fn other(self) -> Foot {
        match self {
            Foot::Left => Foot::Right,
            Foot::Right => Foot::Left,
        }
    }
}

/// Feet to which a force curve belongs.
///
/// ```
/// use gaitcam_gait::{Feet, model};
///
/// // Both feet carry the whole weight, one foot half of it.
/// assert_eq!((Feet::Both.share(), Feet::One.share()), (1.0, 0.5));
/// let one = model("li-2010", Some(1.9), 700.0, Feet::One)?;
/// assert!((one.mean_n() / 350.0 - 1.0).abs() < 0.05);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, EnumString, IntoStaticStr)]
#[strum(serialize_all = "kebab-case", parse_err_ty = Error, parse_err_fn = unknown_feet)]
pub enum Feet {
    /// Sum of both feet, as applied to a floor or footbridge.
    #[default]
    Both,
    /// One foot, left or right. If the recording contains both feet, it is the mean of all stances.
    One,
    /// Only the left foot.
    Left,
    /// Only the right foot.
    Right,
    /// Sum of both feet, from a column that contains the total force.
    Total,
}

impl Feet {
    /// All values, in the order in which the help text lists them.
    pub const ALL: [Feet; 5] = [Feet::Both, Feet::One, Feet::Left, Feet::Right, Feet::Total];

    /// Mean fraction of the weight that these feet carry over a stride.
    pub fn share(self) -> f64 {
        match self {
            Feet::Both | Feet::Total => 1.0,
            Feet::One | Feet::Left | Feet::Right => 0.5,
        }
    }

    /// The foot, if the force belongs to a known side; otherwise `None`.
    pub fn foot(self) -> Option<Foot> {
        match self {
            Feet::Left => Some(Foot::Left),
            Feet::Right => Some(Foot::Right),
            Feet::Both | Feet::One | Feet::Total => None,
        }
    }

    /// Name used in scenes: `both`, `one`, `left`, `right`, `total`.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

fn unknown_feet(word: &str) -> Error {
    let word = word.to_string();
    ForceError::UnknownFeet { word }.into()
}

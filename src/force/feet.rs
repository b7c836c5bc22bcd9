//! Whose force a curve is.

use crate::error::{Error, ForceError, Result};

/// Whose force a curve is.
///
/// ```
/// use gaitcam::force::{Feet, model};
///
/// // Both feet carry the whole weight, one foot half of it.
/// assert_eq!((Feet::Both.share(), Feet::One.share()), (1.0, 0.5));
/// let one = model("li-2010", Some(1.9), 700.0, Feet::One)?;
/// assert!((one.mean_n() / 350.0 - 1.0).abs() < 0.05);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feet {
    /// The sum of both feet, as a floor or footbridge feels it.
    Both,
    /// One foot, whichever the source offers (the mean of both where it offers both).
    One,
    /// The left foot.
    Left,
    /// The right foot.
    Right,
    /// The sum of both feet, which the recording holds in one column.
    Total,
}

impl Feet {
    /// Every choice.
    pub const ALL: [Feet; 5] = [Feet::Both, Feet::One, Feet::Left, Feet::Right, Feet::Total];

    /// Part of the weight that the feet carry on the mean over a stride.
    pub fn share(self) -> f64 {
        match self {
            Feet::Both | Feet::Total => 1.0,
            Feet::One | Feet::Left | Feet::Right => 0.5,
        }
    }

    /// The name used in scenes: `both`, `one`, `left`, `right`, `total`.
    pub fn name(self) -> &'static str {
        match self {
            Feet::Both => "both",
            Feet::One => "one",
            Feet::Left => "left",
            Feet::Right => "right",
            Feet::Total => "total",
        }
    }
}

impl std::str::FromStr for Feet {
    type Err = Error;

    fn from_str(word: &str) -> Result<Self> {
        Feet::ALL
            .into_iter()
            .find(|f| f.name() == word)
            .ok_or_else(|| {
                let word = word.to_string();
                ForceError::UnknownFeet { word }.into()
            })
    }
}

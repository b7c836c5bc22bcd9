//! Whose force a curve is.

use crate::error::{Error, ForceError, Result};

/// Whose force a curve is.
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
}

impl Feet {
    /// The name used in scenes: `both`, `one`, `left`, `right`.
    pub fn name(self) -> &'static str {
        match self {
            Feet::Both => "both",
            Feet::One => "one",
            Feet::Left => "left",
            Feet::Right => "right",
        }
    }
}

impl std::str::FromStr for Feet {
    type Err = Error;

    fn from_str(word: &str) -> Result<Self> {
        let all = [Feet::Both, Feet::One, Feet::Left, Feet::Right];
        all.into_iter().find(|f| f.name() == word).ok_or_else(|| {
            let word = word.to_string();
            ForceError::UnknownFeet { word }.into()
        })
    }
}

//! Units of force in files.

use serde::Serialize;

use crate::error::{Error, ForceError, Result};
use crate::units::{G, LBF};

/// Unit of the force columns of a file.
///
/// ```
/// use gaitcam_gait::ForceUnit;
///
/// let unit: ForceUnit = "kN".parse()?;
/// assert_eq!(unit.newtons(None), Some(1000.0));
/// // A body weight is as many newtons as the walker weighs.
/// assert_eq!(ForceUnit::BodyWeight.newtons(Some(70.0)), Some(70.0 * 9.81));
/// assert_eq!(ForceUnit::BodyWeight.newtons(None), None);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum ForceUnit {
    /// Newtons.
    #[serde(rename = "N")]
    Newton,
    /// Kilonewtons.
    #[serde(rename = "kN")]
    Kilonewton,
    /// Pounds-force.
    #[serde(rename = "lbf")]
    PoundForce,
    /// Kilograms-force.
    #[serde(rename = "kgf")]
    KilogramForce,
    /// Newtons per kilogram of body mass.
    #[serde(rename = "N/kg")]
    NewtonPerKilogram,
    /// Body weights.
    #[serde(rename = "BW")]
    BodyWeight,
    /// Hundredths of body weight.
    #[serde(rename = "%BW")]
    PercentBodyWeight,
}

impl ForceUnit {
    /// The name used in scenes and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            ForceUnit::Newton => "N",
            ForceUnit::Kilonewton => "kN",
            ForceUnit::PoundForce => "lbf",
            ForceUnit::KilogramForce => "kgf",
            ForceUnit::NewtonPerKilogram => "N/kg",
            ForceUnit::BodyWeight => "BW",
            ForceUnit::PercentBodyWeight => "%BW",
        }
    }

    /// Newtons per unit; `None` where that needs a body mass and none is known.
    pub fn newtons(self, mass_kg: Option<f64>) -> Option<f64> {
        match self {
            ForceUnit::Newton => Some(1.0),
            ForceUnit::Kilonewton => Some(1e3),
            ForceUnit::PoundForce => Some(LBF),
            ForceUnit::KilogramForce => Some(9.806_65),
            ForceUnit::NewtonPerKilogram => mass_kg,
            ForceUnit::BodyWeight => mass_kg.map(|m| m * G),
            ForceUnit::PercentBodyWeight => mass_kg.map(|m| m * G / 100.0),
        }
    }
}

impl std::str::FromStr for ForceUnit {
    type Err = Error;

    fn from_str(word: &str) -> Result<Self> {
        let plain: String = word.chars().filter(|c| !c.is_whitespace()).collect();
        Ok(match plain.to_lowercase().as_str() {
            "n" | "newton" | "newtons" => ForceUnit::Newton,
            "kn" => ForceUnit::Kilonewton,
            "lbf" | "lb" | "lbs" => ForceUnit::PoundForce,
            "kgf" | "kp" | "kg" => ForceUnit::KilogramForce,
            "n/kg" => ForceUnit::NewtonPerKilogram,
            "bw" | "n/bw" | "xbw" | "n/n" => ForceUnit::BodyWeight,
            "%bw" | "bw%" | "percentbw" => ForceUnit::PercentBodyWeight,
            _ => {
                return Err(ForceError::UnknownUnit {
                    word: word.to_string(),
                }
                .into());
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_force_are_read_and_others_refused() {
        let unit = |w: &str| w.parse::<ForceUnit>();
        assert_eq!(unit("% BW"), Ok(ForceUnit::PercentBodyWeight));
        assert_eq!(unit("lb"), Ok(ForceUnit::PoundForce));
        assert!(unit("furlong").is_err());
        assert_eq!(ForceUnit::BodyWeight.newtons(Some(10.0)), Some(10.0 * G));
        assert_eq!(ForceUnit::BodyWeight.newtons(None), None);
    }
}

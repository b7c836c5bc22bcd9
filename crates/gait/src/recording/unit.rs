//! Units of force in the columns of files.

use serde::Serialize;
use strum::{EnumString, IntoStaticStr};

use crate::error::{Error, ForceError};
use crate::units::{G, LBF};

/// Unit of the force columns of a file.
///
/// ```
/// use gaitcam_gait::ForceUnit;
///
/// let unit: ForceUnit = "kN".parse()?;
/// assert_eq!(unit.newtons(None), Some(1000.0));
/// // One body weight is the weight of the walker in newtons.
/// assert_eq!(ForceUnit::BodyWeight.newtons(Some(70.0)), Some(70.0 * 9.81));
/// assert_eq!(ForceUnit::BodyWeight.newtons(None), None);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, EnumString, IntoStaticStr)]
#[serde(into = "&'static str")]
#[strum(ascii_case_insensitive, parse_err_ty = Error, parse_err_fn = unknown_unit)]
pub enum ForceUnit {
    /// Newtons, the usual unit of force plates.
    #[strum(to_string = "N", serialize = "newton", serialize = "newtons")]
    Newton,
    /// Kilonewtons: 1000 N each.
    #[strum(to_string = "kN", serialize = "kilonewton", serialize = "kilonewtons")]
    Kilonewton,
    /// Decanewtons: 10 N each.
    #[strum(to_string = "daN", serialize = "decanewton")]
    Decanewton,
    /// Pounds-force: 4.448 N each.
    #[strum(to_string = "lbf", serialize = "lb", serialize = "lbs")]
    PoundForce,
    /// Kilograms-force: 9.807 N each.
    #[strum(to_string = "kgf", serialize = "kp", serialize = "kg")]
    KilogramForce,
    /// Newtons per kilogram of body mass.
    #[strum(to_string = "N/kg", serialize = "N / kg")]
    NewtonPerKilogram,
    /// Multiples of the body weight.
    #[strum(
        to_string = "BW",
        serialize = "N/BW",
        serialize = "xBW",
        serialize = "x BW",
        serialize = "body weight",
        serialize = "body weights",
        serialize = "N/N"
    )]
    BodyWeight,
    /// Percent of the body weight.
    #[strum(
        to_string = "%BW",
        serialize = "% BW",
        serialize = "BW%",
        serialize = "BW %",
        serialize = "% body weight",
        serialize = "percentBW"
    )]
    PercentBodyWeight,
}

fn unknown_unit(word: &str) -> Error {
    let word = word.to_string();
    ForceError::UnknownUnit { word }.into()
}

impl ForceUnit {
    /// Name of the unit in scenes and on the command line.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// Newtons per unit; `None` if the body mass is necessary but unknown.
    pub fn newtons(self, mass_kg: Option<f64>) -> Option<f64> {
        match self {
            ForceUnit::Newton => Some(1.0),
            ForceUnit::Kilonewton => Some(1e3),
            ForceUnit::Decanewton => Some(10.0),
            ForceUnit::PoundForce => Some(LBF),
            ForceUnit::KilogramForce => Some(9.806_65),
            ForceUnit::NewtonPerKilogram => mass_kg,
            ForceUnit::BodyWeight => mass_kg.map(|m| m * G),
            ForceUnit::PercentBodyWeight => mass_kg.map(|m| m * G / 100.0),
        }
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

//! Errors in the text of a quantity with a unit.

use serde::Serialize;
use strum::VariantNames;

use super::Fault;
use crate::wording::{Catalogue, WORDS};

/// Error in the text of a quantity. The field `example` is a valid text for the dimension.
///
/// ```
/// use gaitcam_base::error::UnitsError;
/// use gaitcam_base::units::{Dimension, parse};
///
/// let error = parse("2 parsec", Dimension::Length).unwrap_err();
/// assert!(matches!(error.fault(), Some(UnitsError::UnknownUnit { unit, .. }) if unit == "parsec"));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum UnitsError {
    /// The text does not start with a number.
    NoNumber { text: String, example: String },
    /// The number has thousands separators. `plain` is the number without these separators.
    Grouped { text: String, plain: String },
    /// The number has no unit, but its dimension requires one.
    NoUnit { text: String, example: String },
    /// The number has no percent sign, so it may be a fraction or a percentage.
    BareShare { text: String, percent: f64 },
    /// The unit belongs to another dimension.
    WrongDimension {
        text: String,
        unit: String,
        dimension: String,
        example: String,
    },
    /// The magnitude of the quantity exceeds 1e30 in SI units, so products with it may overflow.
    OutOfRange { text: String },
    /// The exponent of a unit is not an integer from −6 to 6.
    Exponent { factor: String },
    /// The name of the unit is unknown.
    UnknownUnit {
        unit: String,
        nearest: Option<String>,
    },
}

impl Fault for UnitsError {
    const AREA: &'static str = "units";
    const WORDS: &'static Catalogue = &WORDS;
}

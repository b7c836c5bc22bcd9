//! Faults in a quantity with a unit.

use serde::Serialize;
use strum::VariantNames;

use super::Fault;
use crate::wording::{Catalogue, WORDS};

/// Fault in the text of a quantity. `example` is a valid one.
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
    /// No number at the start.
    NoNumber { text: String, example: String },
    /// A number with separated thousands; `plain` is the number without separators.
    Grouped { text: String, plain: String },
    /// A number without its unit.
    NoUnit { text: String, example: String },
    /// A fraction that may be meant as a percentage.
    BareShare { text: String, percent: f64 },
    /// A unit of another dimension.
    WrongDimension {
        text: String,
        unit: String,
        dimension: String,
        example: String,
    },
    /// The quantity is so large that products of it overflow.
    OutOfRange { text: String },
    /// An exponent that is not a small integer.
    Exponent { factor: String },
    /// A unit that no dimension has.
    UnknownUnit {
        unit: String,
        nearest: Option<String>,
    },
}

impl Fault for UnitsError {
    const AREA: &'static str = "units";
    const WORDS: &'static Catalogue = &WORDS;
}

//! Faults in a quantity with a unit.

use serde::Serialize;
use strum::VariantNames;

use super::Fault;
use crate::wording::{Catalogue, WORDS};

/// What is wrong with the text of a quantity. `example` is a valid one.
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
#[allow(missing_docs)] // the messages of wording/en/units.ftl say what each field is
pub enum UnitsError {
    NoNumber {
        text: String,
        example: String,
    },
    NoUnit {
        text: String,
        example: String,
    },
    BareShare {
        text: String,
        percent: f64,
    },
    WrongDimension {
        text: String,
        unit: String,
        dimension: String,
        example: String,
    },
    NotFinite {
        text: String,
    },
    Exponent {
        factor: String,
    },
    UnknownUnit {
        unit: String,
        nearest: Option<String>,
    },
}

impl Fault for UnitsError {
    const AREA: &'static str = "units";
    const WORDS: &'static Catalogue = &WORDS;
}

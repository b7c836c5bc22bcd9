//! Errors in the input: description, location and suggested change.
//!
//! Each area (subject) has an enum of its errors, which implements [`Fault`]. An [`Error`] contains a value of any of these enums, and its
//! location in the input. The messages are in the catalogue of the crate that defines the enum.

mod fault;
mod place;
mod units;

use std::fmt;
use std::sync::Arc;

use serde::ser::{Serialize, SerializeStruct, Serializer};

use crate::wording::Language;

pub use fault::Fault;
use fault::{AnyFault, Own};
pub use place::{Place, Placed};
pub use units::UnitsError;

/// An error in the input, with its location, code, message and suggested change.
///
/// It is displayed as one English line: `walk.csv line 41: time goes backwards (0.312 s after 0.318 s); …`.
///
/// ```
/// use gaitcam_base::error::{Error, Place, UnitsError};
/// use gaitcam_base::units::{Dimension, parse};
/// use gaitcam_base::wording::Language;
///
/// let error = parse("2 parsec", Dimension::Length).unwrap_err();
/// assert_eq!((&error.place, error.code().as_str()), (&Place::Unplaced, "units-unknown-unit"));
/// let Some(UnitsError::UnknownUnit { unit, .. }) = error.fault() else { panic!("{error}") };
/// assert_eq!(unit, "parsec");
/// // Callers may create errors with codes of their own.
/// assert_eq!(Error::own("no-cam", "there is no cam").what(Language::En), "there is no cam");
/// ```
#[derive(Debug, Clone)]
pub struct Error {
    /// Location of the error in the input; `Unplaced` without a location.
    pub place: Place,
    fault: Arc<dyn AnyFault>,
}

/// Result type of all functions that read input.
///
/// ```
/// use gaitcam_base::error::Result;
/// use gaitcam_base::units::{Dimension, parse};
///
/// fn diameter(text: &str) -> Result<f64> {
///     Ok(2.0 * parse(text, Dimension::Length)?)
/// }
/// assert_eq!(diameter("20 mm")?, 0.04);
/// # Ok::<(), gaitcam_base::error::Error>(())
/// ```
pub type Result<T> = std::result::Result<T, Error>;

impl<F: Fault> From<F> for Error {
    fn from(fault: F) -> Error {
        Error {
            place: Place::Unplaced,
            fault: Arc::new(fault),
        }
    }
}

impl Error {
    /// Creates an error with the caller's own code and English text.
    pub fn own(code: &str, what: impl Into<String>) -> Self {
        let (code, what) = (code.to_string(), what.into());
        Error {
            place: Place::Unplaced,
            fault: Arc::new(Own { code, what }),
        }
    }

    /// Sets the location of the error. An error that already has a location keeps it.
    #[must_use]
    pub fn at(mut self, place: Place) -> Self {
        if self.place == Place::Unplaced {
            self.place = place;
        }
        self
    }

    /// Replaces the location of the error.
    #[must_use]
    pub fn placed(mut self, place: Place) -> Self {
        self.place = place;
        self
    }

    /// The error as a value of the enum `F`; `None` if it belongs to another area.
    pub fn fault<F: Fault>(&self) -> Option<&F> {
        self.fault.as_any().downcast_ref()
    }

    /// Code of the error, for scripts and tests: area and variant in kebab-case. Messages may change, but codes do not.
    pub fn code(&self) -> String {
        self.fault.code()
    }

    /// Whether the error means that valid input has no solution, rather than that the input is invalid.
    pub fn is_answer(&self) -> bool {
        self.fault.is_answer()
    }

    /// Message in a language, without the location and the suggested change.
    pub fn what(&self, language: Language) -> String {
        self.fault.what(language)
    }

    /// Suggested change in a language, if the error has one.
    pub fn help(&self, language: Language) -> Option<String> {
        self.fault.help(language)
    }

    /// Location, message and suggested change in a language, in one line.
    pub fn sentence(&self, language: Language) -> String {
        let (place, what) = (self.place.before(language), self.what(language));
        match self.help(language) {
            None => format!("{place}{what}"),
            Some(help) => format!("{place}{what}; {help}"),
        }
    }
}

impl PartialEq for Error {
    fn eq(&self, other: &Error) -> bool {
        self.place == other.place && self.fault.equals(other.fault.as_any())
    }
}

/// Serialises location, code and English message.
impl Serialize for Error {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_struct("Error", 3)?;
        out.serialize_field("place", &self.place)?;
        out.serialize_field("code", &self.code())?;
        out.serialize_field("message", &self.what(Language::En))?;
        out.end()
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence(Language::En))
    }
}

impl std::error::Error for Error {}

/// The candidate that a misspelt `word` probably means; `None` if no candidate is similar.
///
/// A candidate with `word` as a part (between hyphens or underscores) has priority. Otherwise the candidate with the minimum edit distance
/// is returned. This distance must be at most 1 + a third of the length of the longer word.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let candidates: Vec<&str> = candidates.into_iter().collect();
    let is_part = |c: &&&str| c.split(['-', '_']).any(|part| part == word);
    if let Some(part) = candidates.iter().find(is_part) {
        return Some(part);
    }
    candidates
        .into_iter()
        .map(|c| (strsim::damerau_levenshtein(word, c), c))
        .filter(|(d, c)| *d <= 1 + c.len().max(word.len()) / 3)
        .min_by_key(|(d, _)| *d)
        .map(|(_, c)| c)
}

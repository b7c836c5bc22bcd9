//! Kinds of errors, and an error that contains a fault of any area.

use std::any::Any;
use std::fmt::Debug;

use serde::Serialize;

use crate::wording::{Catalogue, Language, code};

/// Errors of one area: an enum whose variants contain data. Their messages are in a catalogue as `AREA-variant`, with the suggested change as the
/// attribute `.help`.
///
/// ```
/// use gaitcam_base::error::{Error, Fault};
/// use gaitcam_base::wording::{Catalogue, Language, Sentences};
/// use serde::Serialize;
///
/// #[derive(Debug, PartialEq, Serialize)]
/// #[serde(rename_all = "kebab-case")]
/// enum TableError {
///     TooShort { rows: usize },
/// }
///
/// const ENGLISH: &str = "table-too-short = only { $rows } rows\n    .help = give 16 or more";
/// static WORDS: Catalogue = Catalogue::new(&[Sentences {
///     files: &[[ENGLISH, ""]],
///     ..Sentences::NONE
/// }]);
///
/// impl Fault for TableError {
///     const AREA: &'static str = "table";
///     const WORDS: &'static Catalogue = &WORDS;
/// }
///
/// let error = Error::from(TableError::TooShort { rows: 3 });
/// assert_eq!(error.code(), "table-too-short");
/// assert_eq!(error.to_string(), "only 3 rows; give 16 or more");
/// assert_eq!(error.fault(), Some(&TableError::TooShort { rows: 3 }));
/// ```
pub trait Fault: Serialize + PartialEq + Debug + Send + Sync + 'static {
    /// Prefix of the message keys of the area.
    const AREA: &'static str;
    /// Prefix of the codes of the area.
    const CODES: &'static str = Self::AREA;
    /// Catalogue with the messages of these errors.
    const WORDS: &'static Catalogue;
    /// Whether the errors are results: the input is valid, but no result satisfies it.
    const IS_ANSWER: bool = false;
}

/// An error of any area, or one with a separate text.
pub trait AnyFault: Debug + Send + Sync {
    fn code(&self) -> String;
    fn what(&self, language: Language) -> String;
    fn help(&self, _: Language) -> Option<String> {
        None
    }
    fn is_answer(&self) -> bool {
        false
    }
    fn as_any(&self) -> &dyn Any;
    fn equals(&self, other: &dyn Any) -> bool;
}

impl<F: Fault> AnyFault for F {
    fn code(&self) -> String {
        code(F::CODES, self)
    }

    fn what(&self, language: Language) -> String {
        F::WORDS.of(language).sentence(F::AREA, self)
    }

    fn help(&self, language: Language) -> Option<String> {
        F::WORDS.of(language).help(F::AREA, self)
    }

    fn is_answer(&self) -> bool {
        F::IS_ANSWER
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn equals(&self, other: &dyn Any) -> bool {
        other.downcast_ref() == Some(self)
    }
}

/// An error without a message in a catalogue.
#[derive(Debug, PartialEq)]
pub struct Own {
    pub code: String,
    pub what: String,
}

impl AnyFault for Own {
    fn code(&self) -> String {
        self.code.clone()
    }

    fn what(&self, _: Language) -> String {
        self.what.clone()
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn equals(&self, other: &dyn Any) -> bool {
        other.downcast_ref() == Some(self)
    }
}

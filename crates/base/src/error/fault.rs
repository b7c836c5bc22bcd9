//! Trait `Fault` for the error enum of one area (subject), such as tables. The trait `AnyFault` is the common interface of these enums, so
//! that an error can contain any of them.

use std::any::Any;
use std::fmt::Debug;

use serde::Serialize;

use crate::wording::{Catalogue, Language, code};

/// Trait for the error enum of one area (subject), such as tables. The fields of a variant are the data of its message.
///
/// The message has the key `AREA-variant` in a catalogue. Its attribute `.help` is the suggested change.
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
    /// Name of the area, which is the prefix of its message keys.
    const AREA: &'static str;
    /// Prefix of the error codes of the area; by default the name of the area.
    const CODES: &'static str = Self::AREA;
    /// Catalogue with the messages of these errors.
    const WORDS: &'static Catalogue;
    /// Whether the errors mean that valid input has no solution, rather than that the input is invalid.
    const IS_ANSWER: bool = false;
}

/// Common interface of the error enums of all areas and of `Own`.
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

/// An error with the caller's own code and English text, without a message in a catalogue.
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

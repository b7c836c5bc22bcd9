//! Messages of a crate in English and Spanish.

use std::sync::OnceLock;

use super::{Language, Messages};

/// Content of a Fluent file, in English and in Spanish.
///
/// ```
/// use gaitcam_base::wording::SENTENCES;
///
/// assert!(SENTENCES.files.iter().all(|[english, spanish]| english != spanish));
/// ```
pub type File = [&'static str; 2];

/// Messages of one crate, with the fields and areas that need special formatting.
///
/// ```
/// use gaitcam_base::wording::{Catalogue, Language, Sentences};
/// use serde_json::json;
///
/// const ENGLISH: &str = "name-arm = the arm\nfile-missing = { $file } without { $part }";
/// const OWN: Sentences = Sentences {
///     files: &[[ENGLISH, ""]],
///     as_typed: &["file"],
///     ..Sentences::NONE
/// };
/// static WORDS: Catalogue = Catalogue::new(&[OWN]);
/// let message = json!({"missing": {"file": "arm", "part": "arm"}});
/// assert_eq!(WORDS.of(Language::En).sentence("file", &message), "arm without the arm");
/// ```
pub struct Sentences {
    /// Fluent files with all messages of the crate, in English and in Spanish.
    pub files: &'static [File],
    /// Names of fields whose values are texts of the user, or select a variant of a message. These values are not translated.
    pub as_typed: &'static [&'static str],
    /// Areas with messages that may be inserted in messages of other areas.
    pub shared: &'static [&'static str],
    /// Areas whose messages are notes on a result, or reasons why something was chosen or rejected. Quantities in these messages have four
    /// significant digits. Quantities in errors have six significant digits, because users enter them again.
    pub notes: &'static [&'static str],
    /// Keys of notes and reasons whose quantities have six significant digits, because users enter them again.
    pub typed_back: &'static [&'static str],
}

impl Sentences {
    /// Entry without messages or special formatting, for the default values of the fields.
    pub const NONE: Sentences = Sentences {
        files: &[],
        as_typed: &[],
        shared: &[],
        notes: &[],
        typed_back: &[],
    };
}

/// Messages of a crate and of the crates on which it depends. The messages of a language are indexed at first use.
///
/// ```
/// use gaitcam_base::wording::{Catalogue, Language, Sentences};
///
/// static WORDS: Catalogue = Catalogue::new(&[Sentences {
///     files: &[["name-arm = arm", "name-arm = brazo"]],
///     ..Sentences::NONE
/// }]);
/// assert_eq!(WORDS.of(Language::Es).name("arm"), "brazo");
/// ```
pub struct Catalogue {
    crates: &'static [Sentences],
    /// Parsed messages, one entry per language.
    messages: [OnceLock<Messages>; 2],
}

impl Catalogue {
    /// Creates a catalogue of the messages of one or more crates.
    pub const fn new(crates: &'static [Sentences]) -> Catalogue {
        Catalogue {
            crates,
            messages: [const { OnceLock::new() }; 2],
        }
    }

    /// Messages of the catalogue in a language.
    pub fn of(&self, language: Language) -> &Messages {
        let place = language as usize;
        self.messages[place].get_or_init(|| Messages::new(language, self.crates))
    }
}

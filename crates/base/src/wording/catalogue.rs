//! The messages of a crate in both languages.

use std::sync::OnceLock;

use super::{Language, Messages};

/// A Fluent file in English and in Spanish.
///
/// ```
/// use gaitcam_base::wording::FILES;
///
/// assert!(FILES.iter().all(|[english, spanish]| english != spanish));
/// ```
pub type File = [&'static str; 2];

/// The messages of a crate and of the crates below it; a language is indexed when it is first needed.
///
/// ```
/// use gaitcam_base::wording::{Catalogue, Language};
///
/// static WORDS: Catalogue = Catalogue::new(&[&[["name-arm = arm", "name-arm = brazo"]]]);
/// assert_eq!(WORDS.of(Language::Es).name("arm"), "brazo");
/// ```
pub struct Catalogue {
    files: &'static [&'static [File]],
    /// By language.
    messages: [OnceLock<Messages>; 2],
}

impl Catalogue {
    /// A catalogue of the files of one or more crates.
    pub const fn new(files: &'static [&'static [File]]) -> Catalogue {
        Catalogue {
            files,
            messages: [const { OnceLock::new() }; 2],
        }
    }

    /// The messages in a language.
    pub fn of(&self, language: Language) -> &Messages {
        let place = language as usize;
        self.messages[place].get_or_init(|| {
            let files = self.files.iter().copied().flatten();
            let texts: Vec<&'static str> = files.map(|file| file[place]).collect();
            Messages::new(language, &texts)
        })
    }
}

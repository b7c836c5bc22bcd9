//! Language of messages. It is the first available value of `--lang`, `LC_ALL` and `LANG`. Without these values, it is English.

use std::ffi::OsString;
use std::sync::OnceLock;

use gaitcam::wording::Language;

/// Language of all output. It is set once, from `--lang` or the environment.
static LANGUAGE: OnceLock<Language> = OnceLock::new();
/// Language selected by `--lang`; `None` without this option.
static GIVEN: OnceLock<Option<Language>> = OnceLock::new();

/// Sets the language of all output from the arguments or the environment. This must precede the parsing of the arguments, because help
/// texts and errors use the language.
pub fn set(arguments: &[OsString]) {
    let given = GIVEN.get_or_init(|| of_arguments(arguments));
    let _ = LANGUAGE.set(given.unwrap_or_else(of_environment));
}

/// Language selected by `--lang`; `None` without this option.
pub fn given() -> Option<Language> {
    GIVEN.get().copied().flatten()
}

/// Value of `--lang` in the arguments, written as `--lang es` or `--lang=es`.
fn of_arguments(arguments: &[OsString]) -> Option<Language> {
    let mut words = arguments.iter().map(|a| a.to_string_lossy());
    while let Some(word) = words.next() {
        if word == "--lang" {
            return Language::of_tag(&words.next()?);
        }
        if let Some(tag) = word.strip_prefix("--lang=") {
            return Language::of_tag(tag);
        }
    }
    None
}

/// Language of all output.
pub fn current() -> Language {
    *LANGUAGE.get_or_init(of_environment)
}

fn of_environment() -> Language {
    ["LC_ALL", "LANG"]
        .iter()
        .find_map(|name| std::env::var(name).ok().filter(|tag| !tag.is_empty()))
        .and_then(|tag| Language::of_tag(&tag))
        .unwrap_or_default()
}

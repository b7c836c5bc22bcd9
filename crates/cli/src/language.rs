//! The language of messages: `--lang`, else `LC_ALL`, else `LANG`, else English.

use std::sync::OnceLock;

use gaitcam::wording::Language;

/// Set once, when the arguments are known.
static LANGUAGE: OnceLock<Language> = OnceLock::new();

/// Settles the language for the rest of the run.
pub fn settle(flag: Option<&str>) {
    let _ = LANGUAGE.set(
        flag.and_then(Language::of_tag)
            .unwrap_or_else(of_environment),
    );
}

/// The language of everything that is printed.
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

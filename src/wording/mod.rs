//! Words: code + data + language → sentence.
//!
//! The library answers with data: an error, a note, a reason is an enum variant with fields. Its sentence
//! stands in a Fluent file under the key `area-variant`, both in kebab-case, the fields being its arguments;
//! the cure of a fault is the attribute `.help` of the same message:
//!
//! ```text
//! law-uncovered = the segments cover { $covered } of { $wanted }
//!     .help = lengthen or add segments until they cover the turn
//! ```
//!
//! Arguments: a [`Quantity`](crate::units::Quantity) is shown in the unit that people use, a plain number with
//! six significant digits, a list joined by commas; a unit variant (a follower, a limit, a law) by the
//! message `name-…` of that variant, where there is one, otherwise as it is typed in scenes. `None` is the
//! word `none`, for selectors. Nothing here knows a type of the library: other crates make a [`Catalogue`]
//! of their own files.

mod catalogue;
mod number;

use std::fmt;
use std::sync::OnceLock;

use serde::Serialize;

pub use catalogue::Catalogue;
pub use number::{fixed, number, people, quantity};

/// A language of messages, reports and pictures.
///
/// ```
/// use gaitcam::wording::Language;
///
/// assert_eq!(Language::of_tag("es"), Some(Language::Es));
/// assert_eq!(Language::En.tag(), "en");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Language {
    /// English.
    #[default]
    En,
    /// Spanish.
    Es,
}

impl Language {
    /// The language of a tag such as `es`, `es_MX.UTF-8` or `en-GB`; `None` for others.
    ///
    /// ```
    /// use gaitcam::wording::Language;
    /// assert_eq!(Language::of_tag("es_ES.UTF-8"), Some(Language::Es));
    /// assert_eq!(Language::of_tag("fr"), None);
    /// ```
    pub fn of_tag(tag: &str) -> Option<Language> {
        match tag.split(['_', '-', '.', '@']).next()? {
            "en" | "C" | "POSIX" => Some(Language::En),
            "es" => Some(Language::Es),
            _ => None,
        }
    }

    /// The tag: `en`, `es`.
    pub fn tag(self) -> &'static str {
        match self {
            Language::En => "en",
            Language::Es => "es",
        }
    }
}

impl fmt::Display for Language {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.tag())
    }
}

/// The library's own messages, one file an area.
const ENGLISH: &[&str] = &[
    include_str!("en/names.ftl"),
    include_str!("en/units.ftl"),
    include_str!("en/cam.ftl"),
    include_str!("en/dynamics.ftl"),
    include_str!("en/file.ftl"),
    include_str!("en/force.ftl"),
    include_str!("en/law.ftl"),
    include_str!("en/read.ftl"),
    include_str!("en/synth.ftl"),
    include_str!("en/infeasible.ftl"),
    include_str!("en/solver.ftl"),
    include_str!("en/keys.ftl"),
    include_str!("en/scene.ftl"),
    include_str!("en/sweep.ftl"),
    include_str!("en/write.ftl"),
];

/// The same in Spanish.
const SPANISH: &[&str] = &[
    include_str!("es/names.ftl"),
    include_str!("es/units.ftl"),
    include_str!("es/cam.ftl"),
    include_str!("es/dynamics.ftl"),
    include_str!("es/file.ftl"),
    include_str!("es/force.ftl"),
    include_str!("es/law.ftl"),
    include_str!("es/read.ftl"),
    include_str!("es/synth.ftl"),
    include_str!("es/infeasible.ftl"),
    include_str!("es/solver.ftl"),
    include_str!("es/keys.ftl"),
    include_str!("es/scene.ftl"),
    include_str!("es/sweep.ftl"),
    include_str!("es/write.ftl"),
];

/// The library's messages in a language.
pub fn catalogue(language: Language) -> &'static Catalogue {
    static EN: OnceLock<Catalogue> = OnceLock::new();
    static ES: OnceLock<Catalogue> = OnceLock::new();
    match language {
        Language::En => EN.get_or_init(|| Catalogue::new(Language::En, ENGLISH)),
        Language::Es => ES.get_or_init(|| Catalogue::new(Language::Es, SPANISH)),
    }
}

/// What a key of the scene file means; `path` as the key table has it.
pub fn key_doc(language: Language, path: &str) -> String {
    catalogue(language).text(&format!("key-{}", path.replace('.', "-")))
}

/// What a built-in scene is.
pub fn scene_doc(language: Language, name: &str) -> String {
    catalogue(language).text(&format!("built-in-{name}"))
}

/// The sentence of a message of the library.
pub fn sentence(language: Language, area: &str, message: &impl Serialize) -> String {
    catalogue(language).sentence(area, message)
}

/// What would be right, for a message that has a cure.
pub fn help(language: Language, area: &str, message: &impl Serialize) -> Option<String> {
    catalogue(language).help(area, message)
}

/// The code of a message: area and variant in kebab-case.
pub fn code(area: &str, message: &impl Serialize) -> String {
    catalogue::code(area, message)
}

//! Languages of messages, and selection of a language by a locale.

use serde::Serialize;
use strum::{Display, IntoStaticStr};

/// Language of messages, reports and figures.
///
/// ```
/// use gaitcam_base::wording::Language;
///
/// assert_eq!(Language::of_tag("es"), Some(Language::Es));
/// assert_eq!(Language::En.tag(), "en");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Display, IntoStaticStr)]
#[serde(rename_all = "lowercase")]
#[strum(serialize_all = "lowercase")]
pub enum Language {
    /// English, the default.
    #[default]
    En,
    /// Spanish, with a decimal comma.
    Es,
}

impl Language {
    /// Language of a tag such as `es`, `es_MX.UTF-8` or `en-GB`; `None` for other tags.
    ///
    /// ```
    /// use gaitcam_base::wording::Language;
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

    /// Language tag: `en` or `es`.
    pub fn tag(self) -> &'static str {
        self.into()
    }
}

/// A text in every language, as a field of a message.
///
/// ```
/// use gaitcam_base::wording::{InLanguages, Language};
///
/// let text = InLanguages::of(|language| format!("in {language}"));
/// assert_eq!((text.en.as_str(), text.es.as_str()), ("in en", "in es"));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct InLanguages {
    /// Text in English.
    pub en: String,
    /// Text in Spanish.
    pub es: String,
}

impl InLanguages {
    /// Calls a function once per language to create the texts.
    pub fn of(text: impl Fn(Language) -> String) -> InLanguages {
        InLanguages {
            en: text(Language::En),
            es: text(Language::Es),
        }
    }
}

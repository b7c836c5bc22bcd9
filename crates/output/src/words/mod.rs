//! Headings, labels and captions of reports and figures. Each language has a Fluent file.

use gaitcam::cam::{Measures, Unit};
pub use gaitcam::wording::Words;
use gaitcam::wording::{Catalogue, Language, Sentences};

static WORDS: Catalogue = Catalogue::new(&[Sentences {
    files: &[[include_str!("en.ftl"), include_str!("es.ftl")]],
    as_typed: &["fault", "file", "key", "model", "name", "walker"],
    ..Sentences::NONE
}]);

/// Texts and number format in a language.
pub fn words(language: Language) -> Words {
    Words::new(WORDS.of(language))
}

/// Label of the horizontal axis in the diagrams of a design: cam angle, or travel of a translating cam.
pub fn across(words: &Words, measures: Measures) -> String {
    match measures {
        Measures::Straight => with_length_unit(words, "figure-travel"),
        _ => words.text("figure-angle"),
    }
}

/// Label with the message key `label`, in which the placeholder is replaced by the displayed unit of length.
pub fn with_length_unit(words: &Words, label: &str) -> String {
    words.fill(label, &[("unit", Unit::length().name)])
}

//! Headings, labels and captions of reports and figures, with one Fluent file per language.

use gaitcam::cam::Measures;
pub use gaitcam::wording::Words;
use gaitcam::wording::{Catalogue, Language, Sentences};

static WORDS: Catalogue = Catalogue::new(&[Sentences {
    files: &[[include_str!("en.ftl"), include_str!("es.ftl")]],
    as_typed: &["fault", "file", "key", "model", "name", "walker"],
    ..Sentences::NONE
}]);

/// Texts and number format of a language.
pub fn words(language: Language) -> Words {
    Words::new(WORDS.of(language))
}

/// Label of the horizontal axis in the diagrams of a design: cam angle or travel.
pub fn across(words: &Words, measures: Measures) -> String {
    words.text(match measures {
        Measures::Straight => "figure-travel",
        _ => "figure-angle",
    })
}

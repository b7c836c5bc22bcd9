//! Messages of this crate in English and Spanish.

use serde::Serialize;

pub use gaitcam_base::wording::{Catalogue, Language, Sentences, code};

/// Fluent files with the names, errors and notes of curves and recordings, and with the errors of files.
pub const SENTENCES: Sentences = Sentences {
    files: &[
        [include_str!("en/force.ftl"), include_str!("es/force.ftl")],
        [include_str!("en/read.ftl"), include_str!("es/read.ftl")],
    ],
    as_typed: &[
        "array", "arrays", "channel", "channels", "column", "columns", "from", "known", "model",
        "movement", "name", "near", "of", "typed", "walker", "word",
    ],
    shared: &["note"],
    ..Sentences::NONE
};

/// Messages of this crate and of the crates on which it depends.
pub static WORDS: Catalogue = Catalogue::new(&[gaitcam_base::wording::SENTENCES, SENTENCES]);

/// Text of a note, of a format, or of a reason for a rejection, in a language.
pub(crate) fn sentence(language: Language, area: &str, message: &impl Serialize) -> String {
    WORDS.of(language).sentence(area, message)
}

//! The messages of this crate in English and Spanish.

use serde::Serialize;

pub use gaitcam_base::wording::{Catalogue, Language, Sentences, code};

/// The Fluent files: names, faults and notes of curves and recordings, faults of files.
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

/// The messages of this crate and of those below it.
pub static WORDS: Catalogue = Catalogue::new(&[gaitcam_base::wording::SENTENCES, SENTENCES]);

/// The message of a note, of a format or of a rejected contact.
pub(crate) fn sentence(language: Language, area: &str, message: &impl Serialize) -> String {
    WORDS.of(language).sentence(area, message)
}

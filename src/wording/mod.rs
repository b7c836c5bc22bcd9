//! The library's messages in English and Spanish, one Fluent file an area ([`gaitcam_base::wording`] says how they are made).

#[cfg(test)]
mod tests;
mod words;

use serde::Serialize;

pub use gaitcam_base::wording::{
    Catalogue, DIGITS, Language, Messages, Sentences, exact, fixed, number, people, quantity,
    range, rounded,
};
pub(crate) use gaitcam_base::wording::{InLanguages, code, degrees};
pub use words::Words;

/// The messages of the library, one file an area.
const SENTENCES: Sentences = Sentences {
    files: &[
        [include_str!("en/names.ftl"), include_str!("es/names.ftl")],
        [include_str!("en/cam.ftl"), include_str!("es/cam.ftl")],
        [
            include_str!("en/dynamics.ftl"),
            include_str!("es/dynamics.ftl"),
        ],
        [
            include_str!("en/figures.ftl"),
            include_str!("es/figures.ftl"),
        ],
        [include_str!("en/file.ftl"), include_str!("es/file.ftl")],
        [include_str!("en/law.ftl"), include_str!("es/law.ftl")],
        [include_str!("en/limits.ftl"), include_str!("es/limits.ftl")],
        [include_str!("en/log.ftl"), include_str!("es/log.ftl")],
        [include_str!("en/synth.ftl"), include_str!("es/synth.ftl")],
        [
            include_str!("en/infeasible.ftl"),
            include_str!("es/infeasible.ftl"),
        ],
        [include_str!("en/solver.ftl"), include_str!("es/solver.ftl")],
        [include_str!("en/keys.ftl"), include_str!("es/keys.ftl")],
        [include_str!("en/scene.ftl"), include_str!("es/scene.ftl")],
        [include_str!("en/sweep.ftl"), include_str!("es/sweep.ftl")],
        [include_str!("en/write.ftl"), include_str!("es/write.ftl")],
    ],
    as_typed: &[
        "catalogue",
        "derivative",
        "fault",
        "file",
        "key",
        "length",
        "list",
        "motion",
        "new",
        "old",
        "pair",
        "path",
    ],
    shared: &["demand", "reason", "scene"],
    notes: &["design", "model", "run"],
};

/// The messages of the library and of the crates below it.
pub(crate) static WORDS: Catalogue = Catalogue::new(&[
    gaitcam_base::wording::SENTENCES,
    gaitcam_gait::wording::SENTENCES,
    SENTENCES,
]);

/// The library's messages in a language.
pub fn catalogue(language: Language) -> &'static Messages {
    WORDS.of(language)
}

/// What a key of the scene file means; `path` as the key table has it.
pub fn key_doc(language: Language, path: &str) -> String {
    catalogue(language).text(&format!("key-{}", path.replace('.', "-")))
}

/// Label of the field that sets a limit; `path` as the key table has it.
pub fn limit_label(language: Language, path: &str) -> String {
    catalogue(language).text(&format!("label-{}", path.replace('.', "-")))
}

/// What a built-in scene is.
pub fn scene_doc(language: Language, name: &str) -> String {
    catalogue(language).text(&format!("built-in-{name}"))
}

/// The sentence of a message of the library.
pub fn sentence(language: Language, area: &str, message: &impl Serialize) -> String {
    catalogue(language).sentence(area, message)
}

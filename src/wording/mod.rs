//! The library's messages in English and Spanish, one Fluent file per area (see [`gaitcam_base::wording`]).

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
    notes: &["design", "model", "reason", "run"],
    typed_back: &[
        "reason-base-radius-works",
        "reason-change",
        "reason-preload-above-target",
    ],
};

/// The messages of the library and of the crates below it.
pub(crate) static WORDS: Catalogue = Catalogue::new(&[
    gaitcam_base::wording::SENTENCES,
    gaitcam_gait::wording::SENTENCES,
    SENTENCES,
]);

/// Spanish words for values of a scene beside their names in the messages.
const SPANISH: [(&str, &str); 5] = [
    ("reposo", "dwell"),
    ("rodillo", "roller-translating"),
    ("cara plana", "flat-translating"),
    ("puntual", "knife-translating"),
    ("hongo", "mushroom-translating"),
];

/// The one of some words that Spanish calls so, whatever its accents and capitals.
pub(crate) fn called_in_spanish(typed: &str, known: &[&'static str]) -> Option<&'static str> {
    let typed = without_accents(typed);
    let other = SPANISH.iter().find(|(spanish, _)| *spanish == typed);
    let is_meant = |word: &&'static str| {
        let name = catalogue(Language::Es).name(word);
        without_accents(&name) == typed || other.is_some_and(|(_, own)| own == word)
    };
    known.iter().copied().find(|word| is_meant(word))
}

/// Small letters without accents.
fn without_accents(text: &str) -> String {
    let plain = |c: char| match c {
        'á' => 'a',
        'é' => 'e',
        'í' => 'i',
        'ó' => 'o',
        'ú' | 'ü' => 'u',
        'ñ' => 'n',
        _ => c,
    };
    text.trim().to_lowercase().chars().map(plain).collect()
}

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

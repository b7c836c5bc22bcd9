//! Messages of the library in English and Spanish, one Fluent file per area (see [`gaitcam_base::wording`]).

#[cfg(test)]
mod tests;
mod words;

use serde::Serialize;

use gaitcam_base::error::nearest;

pub use gaitcam_base::wording::{
    Catalogue, DIGITS, Language, Messages, Sentences, exact, fixed, number, people, quantity,
    range, rounded, walker,
};
pub(crate) use gaitcam_base::wording::{InLanguages, code, degrees};
pub use words::Words;

/// Messages of the library, one file per area.
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

/// Messages of the library, and of the crates on which it depends.
pub(crate) static WORDS: Catalogue = Catalogue::new(&[
    gaitcam_base::wording::SENTENCES,
    gaitcam_gait::wording::SENTENCES,
    SENTENCES,
]);

/// Additional Spanish words for values of a scene. All other Spanish names are in the messages.
const SPANISH: [(&str, &str); 6] = [
    ("reposo", "dwell"),
    ("rodillo", "roller-translating"),
    ("cara plana", "flat-translating"),
    ("puntual", "knife-translating"),
    ("hongo", "mushroom-translating"),
    ("trapecio modificado", "modified-trapezoid"),
];

/// The word of the scene with this Spanish name, without regard to accents and capitals; `None` for an unknown name.
pub(crate) fn called_in_spanish(typed: &str, known: &[&'static str]) -> Option<&'static str> {
    let typed = without_accents(typed);
    let mut names = spanish_names(known).into_iter();
    names.find_map(|(name, word)| (name == typed).then_some(word))
}

/// Pairs of a Spanish name, in lower case without accents, and its word in the scene, for the given words.
fn spanish_names(known: &[&'static str]) -> Vec<(String, &'static str)> {
    let name = |word: &&'static str| (without_accents(&catalogue(Language::Es).name(word)), *word);
    let others = SPANISH.iter().filter(|(_, word)| known.contains(word));
    let others = others.map(|(spanish, word)| ((*spanish).to_string(), *word));
    known.iter().map(name).chain(others).collect()
}

/// The known word with the name that is most similar to a typed name. `None` if no name is similar. The typed name is compared first with
/// the words, then with the parts of their names in both languages. Finally, it is compared with the complete names.
pub(crate) fn nearest_in_languages(typed: &str, known: &[&'static str]) -> Option<&'static str> {
    if let Some(word) = nearest(typed, known.iter().copied()) {
        return Some(word);
    }
    let typed = without_accents(typed);
    let spanish = spanish_names(known);
    let own = known.iter().map(|word| (*word, *word));
    let names: Vec<(&str, &'static str)> = own
        .chain(spanish.iter().map(|(name, word)| (&**name, *word)))
        .collect();
    let every = || names.iter().flat_map(|(name, _)| parts(name));
    let meant: Vec<&str> = parts(&typed)
        .filter_map(|part| nearest(part, every()))
        .collect();
    // Number of matching parts of a name, divided by the number of its parts, in thousandths.
    let alike = |name: &str| {
        let found = parts(name).filter(|part| meant.contains(part)).count();
        1000 * found / parts(name).count().max(1)
    };
    let counted = names.iter().rev().map(|(name, word)| (alike(name), *word));
    let most = counted
        .max_by_key(|(count, _)| *count)
        .filter(|(count, _)| *count > 0);
    let whole = || {
        let found = nearest(&typed, names.iter().map(|(name, _)| *name))?;
        names.iter().find(|(name, _)| *name == found)
    };
    most.or_else(|| whole().map(|(_, word)| (0, *word)))
        .map(|(_, word)| word)
}

/// Parts of a name, separated by spaces, hyphens or underscores, that are long enough to distinguish it.
fn parts(name: &str) -> impl Iterator<Item = &str> {
    let apart = name.split([' ', '-', '_']);
    apart.filter(|part| part.chars().count() > 4)
}

/// The text in lower case without accents.
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

/// Messages of the library in a language.
pub fn catalogue(language: Language) -> &'static Messages {
    WORDS.of(language)
}

/// Description of a key of the scene file. `path` is the path of the key in the key table.
pub fn key_doc(language: Language, path: &str) -> String {
    catalogue(language).text(&format!("key-{}", path.replace('.', "-")))
}

/// Label of the input field for a limit. `path` is the path of the key in the key table.
pub fn limit_label(language: Language, path: &str) -> String {
    catalogue(language).text(&format!("label-{}", path.replace('.', "-")))
}

/// Description of the built-in scene with this name.
pub fn scene_doc(language: Language, name: &str) -> String {
    catalogue(language).text(&format!("built-in-{name}"))
}

/// Text of a message of the library. `area` is its Fluent file, and `message` contains its key and arguments.
pub fn sentence(language: Language, area: &str, message: &impl Serialize) -> String {
    catalogue(language).sentence(area, message)
}

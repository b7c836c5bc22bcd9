//! Texts of the page, with one Fluent file per language.

use std::cell::Cell;

use gaitcam::criterion::LimitKind;
use gaitcam::scene::keys;
use gaitcam::synth::{FIGURES, Figure};
use gaitcam::wording::{Catalogue, Language, Sentences, limit_label};
use serde_json::{Map, Value};

/// Catalogue of the messages of the page and its server.
pub static WORDS: Catalogue = Catalogue::new(&[Sentences {
    files: &[[include_str!("en.ftl"), include_str!("es.ftl")]],
    as_typed: &["fault", "file", "folder", "list", "name"],
    ..Sentences::NONE
}]);

thread_local! {
    static LANGUAGE: Cell<Language> = const { Cell::new(Language::En) };
}

/// Sets the language of messages for the request that this thread processes.
pub fn settle(language: Language) {
    LANGUAGE.set(language);
}

/// Language of messages for the request that this thread processes.
pub fn current() -> Language {
    LANGUAGE.get()
}

/// Texts of the page by their keys. The names of key figures have the keys `figure-COLUMN`. The page replaces `{name}` in a text by a value.
pub fn page(language: Language) -> Map<String, Value> {
    let words = WORDS.of(language);
    let arguments = include_str!("en.ftl").split("{ $").skip(1);
    let arguments = arguments.filter_map(|rest| rest.split(' ').next());
    let holes: Map<String, Value> = arguments
        .map(|a| (a.to_string(), format!("{{{a}}}").into()))
        .collect();
    let holes = Value::from(holes);
    let keys = words.keys();
    let keys = keys
        .iter()
        .filter_map(|k| Some((k, k.strip_prefix("studio-")?)));
    let text = |variant: &str| {
        let message = Map::from_iter([(variant.to_string(), holes.clone())]);
        words.sentence("studio", &Value::from(message))
    };
    let own = keys.map(|(key, variant)| (key.clone(), text(variant).into()));
    let figure = |f: &Figure| (format!("figure-{}", f.column), f.label(language).into());
    let figures = FIGURES.iter().map(figure);
    own.chain(limits(language)).chain(figures).collect()
}

/// Keys and labels of the form fields for limits.
fn limits(language: Language) -> impl Iterator<Item = (String, Value)> {
    LimitKind::ALL.iter().filter_map(move |kind| {
        let key = keys::of_limit(*kind)?.path;
        let label = limit_label(language, key);
        Some((
            format!("studio-key-{}", key.replace('.', "-")),
            label.into(),
        ))
    })
}

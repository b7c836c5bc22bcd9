//! Words of the page, by language: one Fluent file each.

use std::cell::Cell;
use std::sync::OnceLock;

use gaitcam::wording::{Catalogue, Language};
use serde_json::{Map, Value};

const ENGLISH: &str = include_str!("en.ftl");
const SPANISH: &str = include_str!("es.ftl");

/// Arguments of the page's texts.
const ARGUMENTS: [&str; 11] = [
    "name", "low", "high", "seconds", "share", "folder", "files", "count", "number", "time",
    "force",
];

thread_local! {
    static LANGUAGE: Cell<Language> = const { Cell::new(Language::En) };
}

/// Settles the language of the messages of the request that this thread answers.
pub fn settle(language: Language) {
    LANGUAGE.set(language);
}

/// The language of the request that this thread answers.
pub fn current() -> Language {
    LANGUAGE.get()
}

/// The words of one language.
pub struct Words(Catalogue);

impl Words {
    /// The words of `language`.
    pub fn of(language: Language) -> &'static Words {
        static EN: OnceLock<Words> = OnceLock::new();
        static ES: OnceLock<Words> = OnceLock::new();
        let read = |text| Words(Catalogue::new(language, &[text]));
        match language {
            Language::En => EN.get_or_init(|| read(ENGLISH)),
            Language::Es => ES.get_or_init(|| read(SPANISH)),
        }
    }

    /// The messages themselves.
    pub fn catalogue(&self) -> &Catalogue {
        &self.0
    }

    /// Every text of the page by its key; `{name}` stands where the page puts a value.
    pub fn page(&self) -> Map<String, Value> {
        let holes: Map<String, Value> = ARGUMENTS
            .map(|a| (a.to_string(), format!("{{{a}}}").into()))
            .into_iter()
            .collect();
        let holes = Value::from(holes);
        let keys = self.0.keys();
        let keys = keys
            .iter()
            .filter_map(|k| Some((k, k.strip_prefix("studio-")?)));
        let text = |variant: &str| {
            let message = Map::from_iter([(variant.to_string(), holes.clone())]);
            self.0.sentence("studio", &Value::from(message))
        };
        keys.map(|(key, variant)| (key.clone(), text(variant).into()))
            .collect()
    }
}

//! A set of Fluent messages of one language.

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use fluent_syntax::ast::Pattern;
use serde::Serialize;
use serde_json::Value;
use unic_langid::LanguageIdentifier;

use super::Language;
use super::number::{fixed, number, quantity};

/// Areas whose messages stand inside those of others.
const SHARED: &[&str] = &["demand", "note", "reason", "scene"];

/// Arguments that repeat what users type, or choose a variant of a sentence: they are never translated.
const AS_TYPED: &[&str] = &[
    "catalogue",
    "channel",
    "channels",
    "column",
    "columns",
    "derivative",
    "example",
    "fault",
    "from",
    "key",
    "known",
    "length",
    "list",
    "model",
    "most",
    "motion",
    "movement",
    "name",
    "pair",
    "near",
    "nearest",
    "new",
    "old",
    "path",
    "text",
    "typed",
    "word",
];

/// Messages of one language.
///
/// ```
/// use gaitcam::wording::{Catalogue, Language};
/// use serde::Serialize;
///
/// #[derive(Serialize)]
/// #[serde(rename_all = "kebab-case")]
/// enum Fault {
///     TooShort { rows: usize },
/// }
/// let words = Catalogue::new(Language::En, &["table-too-short = only { $rows } rows\n    .help = give 16 or more"]);
/// let fault = Fault::TooShort { rows: 3 };
/// assert_eq!(words.sentence("table", &fault), "only 3 rows");
/// assert_eq!(words.help("table", &fault).as_deref(), Some("give 16 or more"));
/// ```
pub struct Catalogue {
    language: Language,
    bundle: FluentBundle<FluentResource>,
    keys: Vec<String>,
}

impl Catalogue {
    /// Reads the texts of Fluent files.
    ///
    /// # Panics
    ///
    /// On a text that is no Fluent, or a key that stands twice: a mistake of the program, not of its user,
    /// which every test of the catalogue meets.
    pub fn new(language: Language, files: &[&str]) -> Catalogue {
        let tag: LanguageIdentifier = language.tag().parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![tag]);
        // Sentences are of one direction: marks that isolate arguments would only disturb terminals.
        bundle.set_use_isolating(false);
        let mut keys = Vec::new();
        for text in files {
            let resource = match FluentResource::try_new((*text).to_string()) {
                Ok(resource) => resource,
                Err((_, faults)) => panic!("a file of messages is no Fluent: {faults:?}"),
            };
            // A message's key stands at the start of its line.
            let lines = text
                .lines()
                .filter(|l| l.starts_with(|c: char| c.is_ascii_lowercase()));
            keys.extend(lines.filter_map(|l| Some(l.split_once(" =")?.0.to_string())));
            if let Err(faults) = bundle.add_resource(resource) {
                panic!("a message stands twice: {faults:?}");
            }
        }
        Catalogue {
            language,
            bundle,
            keys,
        }
    }

    /// Keys of all messages, in the order of the files.
    pub fn keys(&self) -> &[String] {
        &self.keys
    }

    /// The sentence of a message: its key is `area-variant`. A key that is missing shows as itself with the
    /// message's data, so that nothing is ever lost.
    pub fn sentence(&self, area: &str, message: &impl Serialize) -> String {
        let data = serde_json::to_value(message).unwrap_or_default();
        self.of_value(area, &data)
    }

    /// What would be right: the attribute `.help` of the same message.
    pub fn help(&self, area: &str, message: &impl Serialize) -> Option<String> {
        let data = serde_json::to_value(message).unwrap_or_default();
        let (variant, fields) = parts(&data)?;
        let found = self.bundle.get_message(&format!("{area}-{variant}"))?;
        let pattern = found.get_attribute("help")?.value();
        Some(self.format(pattern, area, fields))
    }

    /// Its language.
    pub fn language(&self) -> Language {
        self.language
    }

    /// A number with a fixed count of decimals, with the decimal sign of the language.
    pub fn fixed(&self, value: f64, decimals: usize) -> String {
        fixed(self.language, value, decimals)
    }

    /// The text of a key without arguments: headings, labels.
    pub fn text(&self, key: &str) -> String {
        let nothing = Value::Null;
        match self.bundle.get_message(key).and_then(|m| m.value()) {
            Some(pattern) => self.format(pattern, "", &nothing),
            None => key.to_string(),
        }
    }

    /// The name of a unit variant (`flat-translating`, `force_min`) in this language, or as it is typed.
    pub fn name(&self, typed: &str) -> String {
        let key = format!("name-{}", typed.replace(['_', '.', ' '], "-"));
        match self.bundle.get_message(&key).and_then(|m| m.value()) {
            Some(pattern) => self.format(pattern, "", &Value::Null),
            None => typed.to_string(),
        }
    }

    fn of_value(&self, area: &str, data: &Value) -> String {
        let missing = || format!("{area}: {data}");
        let Some((variant, fields)) = parts(data) else {
            return missing();
        };
        let message = |area: &str| self.bundle.get_message(&format!("{area}-{variant}"));
        let found = message(area).or_else(|| SHARED.iter().find_map(|area| message(area)));
        match found.and_then(|m| m.value()) {
            Some(pattern) => self.format(pattern, area, fields),
            None => missing(),
        }
    }

    fn format(&self, pattern: &Pattern<&str>, area: &str, fields: &Value) -> String {
        let mut arguments = FluentArgs::new();
        if let Value::Object(fields) = fields {
            for (name, value) in fields {
                let argument = match value {
                    Value::String(text) if AS_TYPED.contains(&name.as_str()) => text.clone().into(),
                    _ => self.argument(area, value),
                };
                arguments.set(name.replace('_', "-"), argument);
            }
        }
        let mut faults = Vec::new();
        let text = self
            .bundle
            .format_pattern(pattern, Some(&arguments), &mut faults);
        debug_assert!(faults.is_empty(), "{text}: {faults:?}");
        text.into_owned()
    }

    fn argument(&self, area: &str, value: &Value) -> FluentValue<'static> {
        match value {
            // Whole numbers choose plural forms.
            Value::Number(n) => match n.as_i64() {
                Some(whole) if whole.abs() < 10_000 => FluentValue::from(whole),
                _ => number(self.language, n.as_f64().unwrap_or(f64::NAN)).into(),
            },
            other => self.shown(area, other).into(),
        }
    }

    fn shown(&self, area: &str, value: &Value) -> String {
        match value {
            Value::Null => "none".to_string(),
            Value::Bool(b) => b.to_string(),
            Value::Number(n) => number(self.language, n.as_f64().unwrap_or(f64::NAN)),
            // A message without fields inside another, otherwise a name.
            Value::String(text) if self.keys.contains(&format!("{area}-{text}")) => {
                self.of_value(area, value)
            }
            Value::String(text) => self.name(text),
            Value::Array(items) => {
                let items: Vec<String> = items.iter().map(|i| self.shown(area, i)).collect();
                items.join(", ")
            }
            Value::Object(fields) => match (fields.get("value"), fields.get("unit")) {
                (Some(value), Some(Value::String(unit))) => {
                    quantity(self.language, finite(value), unit)
                }
                _ => self.of_value(area, value),
            },
        }
    }
}

/// Variant and fields of a message as serde writes enums.
fn parts(data: &Value) -> Option<(&str, &Value)> {
    match data {
        Value::String(variant) => Some((variant, &Value::Null)),
        Value::Object(map) if map.len() == 1 => map.iter().next().map(|(k, v)| (k.as_str(), v)),
        _ => None,
    }
}

/// A number as quantities write it.
fn finite(value: &Value) -> f64 {
    match value.as_str() {
        Some("inf") => f64::INFINITY,
        Some("-inf") => f64::NEG_INFINITY,
        _ => value.as_f64().unwrap_or(f64::NAN),
    }
}

/// The key under which a message stands.
pub fn code(area: &str, message: &impl Serialize) -> String {
    let data = serde_json::to_value(message).unwrap_or_default();
    let variant = parts(&data).map_or("", |p| p.0);
    format!("{area}-{variant}")
}

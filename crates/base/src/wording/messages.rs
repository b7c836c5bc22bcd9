//! Fluent messages of one language.

use std::collections::BTreeMap;
use std::sync::{RwLock, RwLockReadGuard};

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentMessage, FluentResource, FluentValue};
use fluent_syntax::ast::Pattern;
use serde::Serialize;
use serde_json::Value;
use unic_langid::LanguageIdentifier;

use super::number::{EXACT, exact, fixed, quantity_to_digits};
use super::{Language, Sentences};

/// Significant digits of a quantity in a note or reason.
const NOTE_DIGITS: usize = 4;

/// Messages of one language.
///
/// ```
/// use gaitcam_base::wording::{Catalogue, Language, Sentences};
/// use serde::Serialize;
///
/// #[derive(Serialize)]
/// #[serde(rename_all = "kebab-case")]
/// enum Fault {
///     TooShort { rows: usize },
/// }
/// const ENGLISH: &str = "table-too-short = only { $rows } rows\n    .help = give 16 or more";
/// static WORDS: Catalogue = Catalogue::new(&[Sentences {
///     files: &[[ENGLISH, ""]],
///     ..Sentences::NONE
/// }]);
/// let words = WORDS.of(Language::En);
/// let fault = Fault::TooShort { rows: 3 };
/// assert_eq!(words.sentence("table", &fault), "only 3 rows");
/// assert_eq!(words.help("table", &fault).as_deref(), Some("give 16 or more"));
/// ```
pub struct Messages {
    language: Language,
    /// Messages of the crates of the catalogue.
    crates: &'static [Sentences],
    /// Messages parsed so far. Parsing all messages would take longer than computing most designs.
    bundle: RwLock<FluentBundle<FluentResource>>,
    /// Fluent texts of all messages, by key.
    texts: BTreeMap<&'static str, &'static str>,
}

type Bundle<'a> = RwLockReadGuard<'a, FluentBundle<FluentResource>>;

impl Messages {
    /// Indexes the texts of Fluent files. Each message is parsed at its first use.
    ///
    /// # Panics
    ///
    /// If a line does not begin a message, or if a key occurs twice. Both are programming errors.
    pub(super) fn new(language: Language, crates: &'static [Sentences]) -> Messages {
        let tag: LanguageIdentifier = language.tag().parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![tag]);
        // English and Spanish are written from left to right, so isolation marks around arguments are unnecessary. Some terminals display
        // them.
        bundle.set_use_isolating(false);
        let mut texts = BTreeMap::new();
        let files = crates.iter().flat_map(|own| own.files);
        for (key, text) in files.flat_map(|file| messages(file[language as usize])) {
            let earlier = texts.insert(key, text);
            assert!(earlier.is_none(), "duplicate message: {key}");
        }
        Messages {
            language,
            crates,
            bundle: RwLock::new(bundle),
            texts,
        }
    }

    /// Fluent text of a message; `None` if there is no such key.
    fn text_of(&self, key: &str) -> Option<&'static str> {
        self.texts.get(key).copied()
    }

    /// Bundle of parsed messages that includes the message with this key and the messages that it references. `None` if there is no such
    /// key.
    fn messages(&self, key: &str) -> Option<Bundle<'_>> {
        let text = self.text_of(key)?;
        let parsed = self.read();
        if parsed.has_message(key) {
            return Some(parsed);
        }
        drop(parsed);
        self.add(key, text);
        Some(self.read())
    }

    fn read(&self) -> Bundle<'_> {
        // A panic while a message is added does not invalidate the other messages.
        (self.bundle.read()).unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    /// Parses a message and the messages that it references.
    ///
    /// # Panics
    ///
    /// If the Fluent text is invalid, which is a programming error.
    fn add(&self, key: &str, text: &str) {
        let resource = match FluentResource::try_new(text.to_string()) {
            Ok(resource) => resource,
            Err((_, faults)) => panic!("the message {key} is no Fluent: {faults:?}"),
        };
        let mut bundle = (self.bundle.write()).unwrap_or_else(std::sync::PoisonError::into_inner);
        // Another thread may have added the message in the meantime.
        if bundle.has_message(key) || bundle.add_resource(resource).is_err() {
            return;
        }
        drop(bundle);
        for other in references(text).filter(|other| *other != key) {
            self.messages(other);
        }
    }

    /// Keys of all messages, in alphabetical order.
    pub fn keys(&self) -> Vec<String> {
        self.texts.keys().map(|key| (*key).to_string()).collect()
    }

    /// Text of the message with the key `area-variant`. If there is no such message, the text consists of the area and the data.
    pub fn sentence(&self, area: &str, message: &impl Serialize) -> String {
        let data = serde_json::to_value(message).unwrap_or_default();
        self.of_value(area, &data)
    }

    /// Suggested change, from the attribute `.help` of the message; `None` if there is no suggestion.
    pub fn help(&self, area: &str, message: &impl Serialize) -> Option<String> {
        let data = serde_json::to_value(message).unwrap_or_default();
        let (variant, fields) = parts(&data)?;
        self.pattern_of(&format!("{area}-{variant}"), area, fields, |message| {
            Some(message.get_attribute("help")?.value())
        })
    }

    /// Language of the messages.
    pub fn language(&self) -> Language {
        self.language
    }

    /// A number with a fixed number of decimals and the decimal separator of the language.
    pub fn fixed(&self, value: f64, decimals: usize) -> String {
        fixed(self.language, value, decimals)
    }

    /// Text of a message without arguments, such as a heading or label.
    pub fn text(&self, key: &str) -> String {
        let text = self.value_of(key, "", &Value::Null);
        text.unwrap_or_else(|| key.to_string())
    }

    /// Name, in this language, of an enum variant without data (`flat-translating`, `force_min`). The input is returned if there is no such
    /// name.
    pub fn name(&self, typed: &str) -> String {
        let key = format!("name-{}", typed.replace(['_', '.', ' '], "-"));
        let name = self.value_of(&key, "", &Value::Null);
        name.unwrap_or_else(|| typed.to_string())
    }

    fn of_value(&self, area: &str, data: &Value) -> String {
        let missing = || format!("{area}: {data}");
        let Some((variant, fields)) = parts(data) else {
            return missing();
        };
        let of = |own: &str| self.value_of(&format!("{own}-{variant}"), area, fields);
        let mut shared = self.crates.iter().flat_map(|own| own.shared);
        let sentence = of(area).or_else(|| shared.find_map(|area| of(area)));
        sentence.unwrap_or_else(missing)
    }

    /// Text of a message, with its fields inserted; `None` if there is no such key.
    fn value_of(&self, key: &str, area: &str, fields: &Value) -> Option<String> {
        self.pattern_of(key, area, fields, |message| message.value())
    }

    /// Text of the pattern that `part` selects from a message; `None` if there is no such key or pattern.
    fn pattern_of(
        &self,
        key: &str,
        area: &str,
        fields: &Value,
        part: impl for<'m> FnOnce(&FluentMessage<'m>) -> Option<&'m Pattern<&'m str>>,
    ) -> Option<String> {
        self.text_of(key)?;
        let arguments = self.arguments(key, area, fields);
        let all = self.messages(key)?;
        let message = all.get_message(key)?;
        let mut faults = Vec::new();
        let text = all.format_pattern(part(&message)?, Some(&arguments), &mut faults);
        debug_assert!(faults.is_empty(), "{text}: {faults:?}");
        Some(text.into_owned())
    }

    /// Fields of a message as Fluent arguments. The value of a field may be a message.
    fn arguments(&self, key: &str, area: &str, fields: &Value) -> FluentArgs<'static> {
        let mut arguments = FluentArgs::new();
        if let Value::Object(fields) = fields {
            let is_of = |area: &&str| key.strip_prefix(area).is_some_and(|k| k.starts_with('-'));
            let is_short =
                |own: &Sentences| own.notes.iter().any(is_of) && !own.typed_back.contains(&key);
            let digits = match self.crates.iter().any(is_short) {
                true => note_digits(fields.values()),
                false => EXACT,
            };
            for (name, value) in fields {
                let argument =
                    if (self.crates.iter()).any(|own| own.as_typed.contains(&name.as_str())) {
                        self.typed(area, value, digits)
                    } else {
                        self.argument(area, value, digits)
                    };
                arguments.set(name.replace('_', "-"), argument);
            }
        }
        arguments
    }

    /// One or several texts of the user as an argument, without translation.
    fn typed(&self, area: &str, value: &Value, digits: usize) -> FluentValue<'static> {
        let texts = match value {
            Value::String(_) => std::slice::from_ref(value),
            Value::Array(items) if items.iter().all(Value::is_string) => items,
            _ => return self.argument(area, value, digits),
        };
        let texts: Vec<&str> = texts.iter().filter_map(Value::as_str).collect();
        texts.join(", ").into()
    }

    fn argument(&self, area: &str, value: &Value, digits: usize) -> FluentValue<'static> {
        match value {
            // Whole numbers remain numbers, because they select plural forms.
            Value::Number(n) => match n.as_i64() {
                Some(whole) if whole.abs() < 10_000 => FluentValue::from(whole),
                _ => exact(self.language, n.as_f64().unwrap_or(f64::NAN)).into(),
            },
            other => self.shown(area, other, digits).into(),
        }
    }

    fn shown(&self, area: &str, value: &Value, digits: usize) -> String {
        match value {
            Value::Null => "none".to_string(),
            Value::Bool(b) => b.to_string(),
            Value::Number(n) => exact(self.language, n.as_f64().unwrap_or(f64::NAN)),
            // The text is the key of a message without fields, or otherwise a name.
            Value::String(text) if self.text_of(&format!("{area}-{text}")).is_some() => {
                self.of_value(area, value)
            }
            Value::String(text) => self.name(text),
            Value::Array(items) => {
                let items: Vec<String> =
                    items.iter().map(|i| self.shown(area, i, digits)).collect();
                items.join(", ")
            }
            Value::Object(fields) if fields.contains_key(self.language.tag()) => {
                let text = fields[self.language.tag()].as_str();
                text.unwrap_or_default().to_string()
            }
            Value::Object(fields) => match (fields.get("value"), fields.get("unit")) {
                (Some(value), Some(Value::String(unit))) => {
                    quantity_to_digits(self.language, finite(value), unit, digits)
                }
                _ => self.of_value(area, value),
            },
        }
    }
}

/// Number of significant digits for the quantities of a note: six if two different values might be equal at four digits, otherwise four.
fn note_digits<'a>(fields: impl Iterator<Item = &'a Value>) -> usize {
    let mut values: Vec<f64> = fields
        .filter_map(|f| f.get("value")?.as_f64())
        .filter(|x| *x != 0.0)
        .collect();
    values.sort_by(f64::total_cmp);
    let near = 10f64.powi(1 - NOTE_DIGITS as i32);
    let alike = |w: &[f64]| w[0] != w[1] && (w[1] - w[0]).abs() < near * w[1].abs();
    match values.windows(2).any(alike) {
        true => EXACT,
        false => NOTE_DIGITS,
    }
}

/// Keys and texts of the messages of a Fluent file. A key is at the start of a line.
fn messages(file: &'static str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let begins = |text: &str| text.starts_with(|c: char| c.is_ascii_lowercase());
    let ends =
        |text: &str| text.starts_with(|c: char| c.is_ascii_lowercase() || c == '#' || c == '-');
    let mut rest = file;
    std::iter::from_fn(move || {
        while !begins(rest) {
            rest = after_line(rest)?;
        }
        let whole = rest;
        rest = after_line(rest).unwrap_or("");
        while !rest.is_empty() && !ends(rest) {
            rest = after_line(rest).unwrap_or("");
        }
        let text = &whole[..whole.len() - rest.len()];
        let key = &text[..memchr::memchr(b' ', text.as_bytes()).unwrap_or(text.len())];
        assert!(
            text[key.len()..].starts_with(" ="),
            "no Fluent message: {text}"
        );
        Some((key, text))
    })
}

/// Text after the first line; `None` if the text is a single line.
fn after_line(text: &'static str) -> Option<&'static str> {
    memchr::memchr(b'\n', text.as_bytes()).map(|end| &text[end + 1..])
}

/// Keys of the messages that a Fluent text may reference.
fn references(text: &str) -> impl Iterator<Item = &str> {
    text.split('{').skip(1).map(|part| {
        let part = part.trim_start();
        let end = part.find(|c: char| !(c.is_ascii_alphanumeric() || c == '-'));
        &part[..end.unwrap_or(part.len())]
    })
}

/// Variant and fields of a serialised enum; `None` for other data.
fn parts(data: &Value) -> Option<(&str, &Value)> {
    match data {
        Value::String(variant) => Some((variant, &Value::Null)),
        Value::Object(map) if map.len() == 1 => map.iter().next().map(|(k, v)| (k.as_str(), v)),
        _ => None,
    }
}

/// Value of a serialised quantity, including `"inf"` and `"-inf"`; NaN for other texts.
fn finite(value: &Value) -> f64 {
    match value.as_str() {
        Some("inf") => f64::INFINITY,
        Some("-inf") => f64::NEG_INFINITY,
        _ => value.as_f64().unwrap_or(f64::NAN),
    }
}

/// Key of a message: area and variant in kebab-case.
pub fn code(area: &str, message: &impl Serialize) -> String {
    let data = serde_json::to_value(message).unwrap_or_default();
    let variant = parts(&data).map_or("", |p| p.0);
    format!("{area}-{variant}")
}

//! The key table as JSON data and as text.

use serde_json::{Value, json};

use super::{KEYS, Key, Kind, Range};
use crate::wording::{Language, catalogue, key_doc, range};

/// All keys as JSON data. Each key is an object `{key, section, kind, unit, units, default, range, choices, limit, relax, doc}`.
pub fn json() -> Value {
    KEYS.iter().map(row).collect()
}

fn row(key: &Key) -> Value {
    let kind: &str = key.kind.into();
    let range = match (key.kind, key.range) {
        (Kind::Count(low, high), _) => json!({"from": low, "to": high}),
        (_, Range::Any) => Value::Null,
        (_, Range::Positive) => json!({"above": 0.0}),
        (_, Range::NotNegative) => json!({"from": 0.0}),
        (_, Range::Between(low, high)) => json!({"from": low, "to": high}),
        (_, Range::Acute) => json!({"above": 0.0, "below": std::f64::consts::FRAC_PI_2}),
    };
    let measure = key.measure();
    json!({
        "key": key.path,
        "section": key.section(),
        "kind": kind,
        "unit": measure.map(|m| m.translating.si()),
        "units": measure.map(|m| json!({
            "translating": m.translating.si(),
            "oscillating": m.oscillating.si(),
            "straight": m.straight.si(),
        })),
        "default": (!key.default.is_empty()).then_some(key.default),
        "range": range,
        "choices": key.choices(),
        "limit": key.limit,
        "relax": key.relax,
        "doc": {"en": key_doc(Language::En, key.path), "es": key_doc(Language::Es, key.path)},
    })
}

/// Short text for the values that a key accepts, such as `length > 0`, `3 … 9` or `true | false`.
pub fn takes(key: &Key, language: Language) -> String {
    let name = |typed: &str| catalogue(language).name(typed);
    let or = format!(" {} ", name("or"));
    let number = |word: Option<&str>| {
        let units: Vec<&str> = key
            .measure()
            .map(|m| m.each().iter().map(|d| d.si()).collect())
            .unwrap_or_default();
        let unit = match units.join(&or) {
            unit if unit.is_empty() => name("number"),
            unit => unit.replace("ratio", "%"),
        };
        let range = match key.range {
            Range::Any => String::new(),
            Range::Positive => " > 0".to_string(),
            Range::NotNegative => " ≥ 0".to_string(),
            Range::Between(low, high) => format!(" {}", range(language, low, high)),
            Range::Acute => " < 90 deg".to_string(),
        };
        let word = word.map_or(String::new(), |w| format!("{or}{w}"));
        format!("{unit}{range}{word}")
    };
    match key.kind {
        Kind::Number(_) => number(None),
        Kind::NumberOrSeveral(_) => {
            let one = number(None);
            format!("{one}{or}1.4 Hz:2.4 Hz:11{or}normal 1.87 Hz 0.19 Hz")
        }
        Kind::NumberOr(_, word) => number(Some(word)),
        Kind::Count(low, high) => format!("{low} … {high}"),
        Kind::Choice(words) => words().join(" | "),
        Kind::Flag => "true | false".to_string(),
        Kind::Text => name("text"),
        Kind::Texts => name("text_or_list"),
    }
}

/// Reference page of all keys in Markdown.
pub fn markdown() -> String {
    let mut out = String::from(
        "# Keys of a scene file\n\n\
         The tables list all keys with their values, defaults and meanings. Write numbers with their unit in quotes (`\"40 mm\"`,\n\
         `\"111 rpm\"`, `\"0.5 %\"`); any unit of the same kind is accepted. `N` is the number of a list entry, which is written as\n\
         `[[law.segment]]` in a file. `gaitcam keys --markdown` prints this page.\n",
    );
    let mut section = None;
    for key in KEYS.iter() {
        if section != Some(key.section()) {
            section = Some(key.section());
            match key.section() {
                "" => out.push('\n'),
                name => out.push_str(&format!("\n## [{name}]\n\n")),
            }
            out.push_str("| key | values | default | meaning |\n|---|---|---|---|\n");
        }
        let default = match key.default {
            "" => String::new(),
            text => format!("`{text}`"),
        };
        out.push_str(&format!(
            "| `{}` | {} | {default} | {} |\n",
            key.path,
            takes(key, Language::En).replace('|', "\\|"),
            key_doc(Language::En, key.path),
        ));
    }
    out
}

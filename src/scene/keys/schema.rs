//! JSON Schema of the scene file, with which editors complete and check keys.

use serde_json::{Map, Value, json};

use super::{KEYS, Key, Kind, Range};
use crate::units::Dimension;
use crate::wording::{Language, key_doc};

/// JSON Schema (draft 2020-12) of a scene file, with descriptions in a language.
pub fn schema(language: Language) -> Value {
    let mut root = object();
    for key in KEYS.iter() {
        let mut value = of_key(key);
        value["description"] = json!(key_doc(language, key.path));
        if !key.default.is_empty() {
            value["default"] = json!(key.default);
        }
        place(&mut root, key.path, value);
    }
    root["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    root["title"] = json!("gaitcam scene");
    root
}

fn object() -> Value {
    json!({"type": "object", "additionalProperties": false, "properties": {}})
}

/// Inserts the schema of a key at its dotted path.
fn place(at: &mut Value, path: &str, value: Value) {
    let Some((part, rest)) = path.split_once('.') else {
        at["properties"][path] = value;
        return;
    };
    let list = rest.strip_prefix("N.");
    let properties = at["properties"].as_object_mut();
    let inner = properties.map(|p: &mut Map<String, Value>| {
        p.entry(part.to_string()).or_insert_with(|| match list {
            Some(_) => json!({"type": "array", "items": object()}),
            None => object(),
        })
    });
    match (inner, list) {
        (Some(inner), Some(rest)) => place(&mut inner["items"], rest, value),
        (Some(inner), None) => place(table(inner), rest, value),
        (None, _) => {}
    }
}

/// The schema of the table that contains the inner keys of a key. A key such as `cam.material` accepts a text or such a table.
fn table(schema: &mut Value) -> &mut Value {
    if schema["type"] == "object" {
        return schema;
    }
    if schema["anyOf"][1]["type"] != "object" {
        let words = schema.as_object_mut();
        let description = words.and_then(|s| s.remove("description"));
        *schema = json!({"anyOf": [schema.take(), object()], "description": description});
    }
    &mut schema["anyOf"][1]
}

fn of_key(key: &Key) -> Value {
    match key.kind {
        Kind::Number(measure) => number(key, &measure.each(), None),
        Kind::NumberOrSeveral(measure) => {
            number(key, &measure.each(), Some("[^:]+:[^:]+:[^:]+|normal .*"))
        }
        Kind::NumberOr(measure, word) => number(key, &measure.each(), Some(word)),
        Kind::Count(low, high) => json!({"anyOf": [
            {"type": "integer", "minimum": low, "maximum": high},
            {"type": "string", "pattern": "^(auto|\\s*[0-9]+\\s*)$"},
        ]}),
        Kind::Choice(words) => json!({"enum": words()}),
        Kind::Flag => json!({"type": "boolean"}),
        Kind::Text => json!({"type": "string"}),
        Kind::Texts => json!({"anyOf": [
            {"type": ["string", "number"]},
            {"type": "array", "items": {"type": ["string", "number"]}},
        ]}),
    }
}

fn number(key: &Key, dimensions: &[Dimension], word: Option<&str>) -> Value {
    let sign = match key.range {
        Range::Positive | Range::NotNegative | Range::Acute => "\\+?",
        _ => "[+-]?",
    };
    let digits = "(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?";
    // A number with a unit. Zero and dimensionless ratios do not need a unit.
    let unit = if dimensions.contains(&Dimension::Ratio) {
        "(\\s*\\S.*)?"
    } else {
        "\\s*[^\\s\\d.].*"
    };
    let words = word.map_or(String::new(), |w| format!("|{w}"));
    let text = json!({
        "type": "string",
        "pattern": format!("^(auto{words}|[+-]?0+(\\.0*)?|\\s*{sign}{digits}{unit})$"),
    });
    let bare = match dimensions.first() {
        Some(Dimension::Ratio) => json!({"type": "number"}),
        _ => json!({"const": 0}),
    };
    let examples: Vec<&str> = dimensions
        .iter()
        .map(|d| d.example().split('"').nth(1).unwrap_or(""))
        .collect();
    json!({"anyOf": [text, bare], "examples": examples})
}

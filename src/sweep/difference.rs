//! Differences between two sweeps. An interrupted sweep can only be continued if it is equal to the sweep that was started.

use std::path::Path;

use serde::Serialize;
use serde_json::Value;
use strum::VariantNames;

use crate::error::{FileError, Placed, Result};
use crate::wording::{self, Language};

/// A difference between the descriptions of two sweeps. `path` is the key path of the differing value, such as `vary limits.stroke`.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Difference {
    /// Two different values with the same key path.
    Value {
        /// Key path of the changed value.
        path: String,
        /// Value in the first description; `None` if missing.
        old: Option<String>,
        /// Value in the second description; `None` if missing.
        new: Option<String>,
    },
    /// Two different values, of which at least one is too long for a message.
    Long {
        /// Key path of the changed value.
        path: String,
    },
    /// A line that exists only in the first scene.
    OnlyOld {
        /// Key path of the scene.
        path: String,
        /// Text of the line.
        text: String,
    },
    /// A line that exists only in the second scene.
    OnlyNew {
        /// Key path of the scene.
        path: String,
        /// Text of the line.
        text: String,
    },
}

impl Difference {
    /// Sentence that describes the difference, in a language.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "differs", self)
    }
}

/// Checks that a sweep equals the sweep that was started in the folder `place`. `begun` describes the started sweep, and `now` the sweep to
/// be continued.
///
/// # Errors
///
/// The sweeps differ. The error contains all differences as sentences in `language`.
pub fn agree(place: &Path, begun: &Value, now: &Value, language: Language) -> Result<()> {
    let all = differences(begun, now);
    if all.is_empty() {
        return Ok(());
    }
    let said: Vec<String> = all.iter().map(|d| d.sentence(language)).collect();
    let differences = said.join("; ");
    Err(FileError::AnotherSweep { differences }.in_file(place))
}

/// All differences between two descriptions of sweeps.
pub fn differences(old: &Value, new: &Value) -> Vec<Difference> {
    let mut out = Vec::new();
    compare("", old, new, &mut out);
    out
}

/// Maximum length of a quoted value, in characters.
const QUOTED: usize = 80;

fn compare(path: &str, old: &Value, new: &Value, out: &mut Vec<Difference>) {
    let join = |key: &str| format!("{path} {key}").trim_start().to_string();
    match (old, new) {
        (Value::Object(a), Value::Object(b)) => {
            for (key, x) in a {
                compare(&join(key), x, b.get(key).unwrap_or(&Value::Null), out);
            }
            for (key, y) in b.iter().filter(|(k, _)| !a.contains_key(*k)) {
                compare(&join(key), &Value::Null, y, out);
            }
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            for (i, (x, y)) in a.iter().zip(b).enumerate() {
                compare(&join(&format!("{}", i + 1)), x, y, out);
            }
        }
        (Value::String(a), Value::String(b))
            if a != b && (a.contains('\n') || b.contains('\n')) =>
        {
            differing_lines(path, a, b, out);
        }
        _ if old != new => out.push(differing_values(path.to_string(), old, new)),
        _ => {}
    }
}

fn differing_values(path: String, old: &Value, new: &Value) -> Difference {
    let shown = |v: &Value| match v {
        Value::Null => None,
        Value::String(text) => Some(text.clone()),
        other => Some(other.to_string()),
    };
    let (old, new) = (shown(old), shown(new));
    let mut texts = old.iter().chain(&new);
    if texts.any(|text| text.chars().count() > QUOTED) {
        return Difference::Long { path };
    }
    Difference::Value { path, old, new }
}

/// Adds the lines that occur in only one of the texts `old` and `new` to `out`.
fn differing_lines(path: &str, old: &str, new: &str, out: &mut Vec<Difference>) {
    let only = |a: &str, b: &str| -> Vec<String> {
        let there: Vec<&str> = b.lines().collect();
        a.lines()
            .filter(|l| !l.trim().is_empty() && !there.contains(l))
            .map(str::to_string)
            .collect()
    };
    let path = || path.to_string();
    out.extend((only(old, new).into_iter()).map(|text| Difference::OnlyOld { path: path(), text }));
    out.extend((only(new, old).into_iter()).map(|text| Difference::OnlyNew { path: path(), text }));
}

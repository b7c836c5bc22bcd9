//! Conversion of TOML values to values of keys.

use toml::Value as Toml;

use super::field::unknown_word;
use super::kind::{Kind, Range};
use super::row::Key;
use super::value::Value;
use crate::error::{Placed, Result, SceneError};
use crate::scene::{Scene, StepFrequencies};
use crate::units::{Dimension, Quantity, in_range, parse};
use crate::wording::called_in_spanish;

/// Reads the value of a key from its TOML value; `None` for `"auto"`.
///
/// # Errors
///
/// The value has the wrong type or unit, or is outside the range of the key.
pub fn read(key: &Key, typed: &Toml, scene: &Scene, path: &str) -> Result<Option<Value>> {
    match key.kind {
        Kind::NumberOr(_, word) if typed.as_str() == Some(word) => {
            Ok(Some(Value::Text(word.to_string())))
        }
        Kind::NumberOrSeveral(_) if typed.as_str().is_some_and(StepFrequencies::is_meant) => {
            Ok(typed.as_str().map(|text| Value::Text(text.to_string())))
        }
        Kind::Number(measure) | Kind::NumberOrSeveral(measure) | Kind::NumberOr(measure, _) => {
            number(key, typed, measure.of(scene.cam.measures()), scene, path)
        }
        Kind::Count(..) if typed.as_str() == Some("auto") => Ok(None),
        _ => plain(key, typed).map(Some).map_err(|e| e.at_key(path)),
    }
}

/// Reads a value that has no unit.
fn plain(key: &Key, typed: &Toml) -> std::result::Result<Value, SceneError> {
    let written = || typed.to_string();
    match key.kind {
        Kind::Count(low, high) => count(typed, low, high).ok_or_else(|| {
            let typed = written();
            match key.path {
                "law.spans" => SceneError::NotSpans { typed, low, high },
                _ => SceneError::NotCount { typed, low, high },
            }
        }),
        Kind::Flag => {
            let flag = typed.as_bool().map(Value::Flag);
            flag.ok_or_else(|| SceneError::NotFlag { typed: written() })
        }
        Kind::Texts => texts(typed).ok_or_else(|| SceneError::NotTexts { typed: written() }),
        _ => {
            let word = typed.as_str();
            let word = word.ok_or_else(|| SceneError::NotText { typed: written() })?;
            let known = key.choices();
            if known.is_empty() || known.contains(&word) {
                return Ok(Value::Text(word.to_string()));
            }
            let spanish = called_in_spanish(word, &known);
            let spanish = spanish.map(|own| Value::Text(own.to_string()));
            spanish.ok_or_else(|| unknown_word(word, &known))
        }
    }
}

fn count(typed: &Toml, low: usize, high: usize) -> Option<Value> {
    let count = match typed {
        Toml::Integer(i) => usize::try_from(*i).ok(),
        Toml::String(s) => s.trim().parse().ok(),
        _ => None,
    };
    let count = count.filter(|n| (low..=high).contains(n));
    count.map(Value::Count)
}

fn texts(typed: &Toml) -> Option<Value> {
    // A bare number is treated as text: a load factor, or the number of a column.
    let one = |v: &Toml| match v {
        Toml::String(text) => Some(text.clone()),
        Toml::Integer(_) | Toml::Float(_) => Some(v.to_string()),
        _ => None,
    };
    let all: Option<Vec<String>> = match typed {
        Toml::Array(list) => list.iter().map(one).collect(),
        typed => one(typed).map(|text| vec![text]),
    };
    all.map(Value::Texts)
}

fn number(
    key: &Key,
    typed: &Toml,
    dimension: Dimension,
    scene: &Scene,
    path: &str,
) -> Result<Option<Value>> {
    let value = match typed {
        // `"auto"` is a missing value, except for limits, which the program never selects.
        Toml::String(s) if s == "auto" && key.limit.is_none() => return Ok(None),
        Toml::String(s) => parse(s, dimension).map_err(|e| e.at_key(path))?,
        Toml::Integer(0) => 0.0,
        Toml::Float(x) if *x == 0.0 => 0.0,
        Toml::Integer(_) | Toml::Float(_) if dimension == Dimension::Percent => {
            parse(&typed.to_string(), dimension).map_err(|e| e.at_key(path))?
        }
        Toml::Integer(i) if dimension == Dimension::Ratio => *i as f64,
        Toml::Float(x) if dimension == Dimension::Ratio && x.is_finite() => {
            in_range(*x, x).map_err(|e| e.at_key(path))?
        }
        _ => {
            return Err(SceneError::NotQuantity {
                typed: typed.to_string(),
                example: key.example(scene),
            }
            .at_key(path));
        }
    };
    if key.range.contains(value) {
        return Ok(Some(Value::Number(value)));
    }
    let typed = typed.to_string().trim_matches('"').to_string();
    let example = key.example(scene);
    Err(match key.range {
        Range::Positive => SceneError::NotPositive { typed, example },
        Range::NotNegative => SceneError::Negative { typed, example },
        Range::Acute if value > 0.0 => SceneError::NotAcute { typed },
        Range::Acute => SceneError::NotPositive { typed, example },
        Range::Between(low, high) => SceneError::Outside {
            typed,
            low: Quantity::new(low, dimension),
            high: Quantity::new(high, dimension),
        },
        Range::Any => SceneError::NotQuantity { typed, example },
    }
    .at_key(path))
}

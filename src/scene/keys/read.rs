//! Values of keys from TOML.

use toml::Value as Toml;

use super::field::unknown_word;
use super::kind::{Kind, Range};
use super::row::Key;
use super::value::Value;
use crate::error::{Place, Placed, Result, SceneError};
use crate::scene::Scene;
use crate::units::{Dimension, Quantity, parse};

/// Reads what a scene file gives for a key; `None` for `"auto"`.
///
/// # Errors
/// A value of another type or unit, or outside the range of the key.
pub fn read(key: &Key, typed: &Toml, scene: &Scene, path: &str) -> Result<Option<Value>> {
    let fault = |e: SceneError| e.at_key(path);
    let auto = typed.as_str() == Some("auto");
    match key.kind {
        Kind::Number(measure) => number(key, typed, measure.of(scene.cam.measures()), scene, path),
        Kind::NumberOr(_, word) if typed.as_str() == Some(word) => {
            Ok(Some(Value::Text(word.to_string())))
        }
        Kind::NumberOr(measure, _) => {
            number(key, typed, measure.of(scene.cam.measures()), scene, path)
        }
        Kind::Count(..) if auto => Ok(None),
        Kind::Count(low, high) => {
            let count = match typed {
                Toml::Integer(i) => usize::try_from(*i).ok(),
                Toml::String(s) => s.trim().parse().ok(),
                _ => None,
            };
            count
                .filter(|n| (low..=high).contains(n))
                .map(|n| Some(Value::Count(n)))
                .ok_or_else(|| {
                    let typed = typed.to_string();
                    fault(if key.path == "law.spans" {
                        SceneError::NotSpans { typed, low, high }
                    } else {
                        SceneError::NotCount { typed, low, high }
                    })
                })
        }
        Kind::Flag => match typed {
            Toml::Boolean(b) => Ok(Some(Value::Flag(*b))),
            _ => Err(fault(SceneError::NotFlag {
                typed: typed.to_string(),
            })),
        },
        Kind::Choice(words) => choice(typed, &words()).map(Some).map_err(fault),
        Kind::Text => match typed {
            Toml::String(s) => Ok(Some(Value::Text(s.clone()))),
            _ => Err(fault(SceneError::NotText {
                typed: typed.to_string(),
            })),
        },
        Kind::Texts => texts(typed).map(Some).map_err(fault),
    }
}

fn texts(typed: &Toml) -> std::result::Result<Value, SceneError> {
    let one = |v: &Toml| v.as_str().map(str::to_string);
    let all: Option<Vec<String>> = match typed {
        Toml::String(s) => Some(vec![s.clone()]),
        Toml::Array(list) => list.iter().map(one).collect(),
        _ => None,
    };
    all.map(Value::Texts).ok_or_else(|| SceneError::NotTexts {
        typed: typed.to_string(),
    })
}

fn choice(typed: &Toml, known: &[&'static str]) -> std::result::Result<Value, SceneError> {
    let Toml::String(word) = typed else {
        return Err(SceneError::NotText {
            typed: typed.to_string(),
        });
    };
    if known.contains(&word.as_str()) {
        return Ok(Value::Text(word.clone()));
    }
    Err(unknown_word(word, known))
}

fn number(
    key: &Key,
    typed: &Toml,
    dimension: Dimension,
    scene: &Scene,
    path: &str,
) -> Result<Option<Value>> {
    let place = || Place::Key(path.to_string());
    let value = match typed {
        Toml::String(s) if s == "auto" => return Ok(None),
        Toml::String(s) => parse(s, dimension).map_err(|e| e.at(place()))?,
        Toml::Integer(0) => 0.0,
        Toml::Float(x) if *x == 0.0 => 0.0,
        Toml::Integer(_) | Toml::Float(_) if dimension == Dimension::Percent => {
            parse(&typed.to_string(), dimension).map_err(|e| e.at(place()))?
        }
        Toml::Integer(i) if dimension == Dimension::Ratio => *i as f64,
        Toml::Float(x) if dimension == Dimension::Ratio && x.is_finite() => *x,
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

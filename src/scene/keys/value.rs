//! Values of keys: from TOML and to TOML.

use toml::Value as Toml;

use super::field::unknown_word;
use super::kind::{Kind, Range};
use super::row::Key;
use crate::error::{Place, Placed, Result, SceneError};
use crate::scene::Scene;
use crate::units::{Dimension, Quantity, parse};

/// The value of a key, typed.
///
/// ```
/// use gaitcam::Scene;
/// use gaitcam::scene::keys::{self, Value};
///
/// let follower = keys::find("cam.follower").unwrap().get(&Scene::default(), 0);
/// assert_eq!(follower, Some(Value::Text("flat-translating".to_string())));
/// assert_eq!(Value::Number(0.04).number(), Some(0.04));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number in SI.
    Number(f64),
    /// A whole number.
    Count(usize),
    /// A truth value.
    Flag(bool),
    /// A word or a text.
    Text(String),
    /// A list of texts.
    Texts(Vec<String>),
}

impl Value {
    /// The number, if it is one.
    pub fn number(self) -> Option<f64> {
        match self {
            Value::Number(x) => Some(x),
            _ => None,
        }
    }

    /// The whole number, if it is one.
    pub fn count(self) -> Option<usize> {
        match self {
            Value::Count(n) => Some(n),
            _ => None,
        }
    }

    /// The text; empty if it is none.
    pub fn text(self) -> String {
        match self {
            Value::Text(text) => text,
            _ => String::new(),
        }
    }

    /// The texts; empty if it is none.
    pub fn texts(self) -> Vec<String> {
        match self {
            Value::Texts(list) => list,
            _ => Vec::new(),
        }
    }

    /// As a scene file has it; numbers in `dimension` with a unit, so that they read back exactly.
    pub fn to_toml(&self, dimension: Option<Dimension>) -> Toml {
        match (self, dimension) {
            (Value::Number(x), None | Some(Dimension::Ratio)) => Toml::Float(*x),
            (Value::Number(x), Some(dimension)) => Toml::String(written(*x, dimension)),
            (Value::Count(n), _) => Toml::Integer(i64::try_from(*n).unwrap_or(i64::MAX)),
            (Value::Flag(b), _) => Toml::Boolean(*b),
            (Value::Text(text), _) => Toml::String(text.clone()),
            (Value::Texts(list), _) => match list.as_slice() {
                [one] => Toml::String(one.clone()),
                list => Toml::Array(list.iter().cloned().map(Toml::String).collect()),
            },
        }
    }
}

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
                    let typed = shown(typed);
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
                typed: shown(typed),
            })),
        },
        Kind::Choice(words) => choice(typed, &words()).map(Some).map_err(fault),
        Kind::Text => match typed {
            Toml::String(s) => Ok(Some(Value::Text(s.clone()))),
            _ => Err(fault(SceneError::NotText {
                typed: shown(typed),
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
        typed: shown(typed),
    })
}

fn choice(typed: &Toml, known: &[&'static str]) -> std::result::Result<Value, SceneError> {
    let Toml::String(word) = typed else {
        return Err(SceneError::NotText {
            typed: shown(typed),
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
                typed: shown(typed),
                example: key.example(scene),
            }
            .at_key(path));
        }
    };
    if key.range.contains(value) {
        return Ok(Some(Value::Number(value)));
    }
    let typed = shown(typed).trim_matches('"').to_string();
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

/// A number as a scene file has it: a text that reads back as exactly this number, in a common unit where that
/// is exact.
fn written(value: f64, dimension: Dimension) -> String {
    let si = format!("{value} {}", dimension.si());
    let common: &[(&str, f64)] = match dimension {
        Dimension::Length => &[("mm", 1e-3)],
        Dimension::Angle => &[("deg", std::f64::consts::PI / 180.0)],
        Dimension::Percent => &[("%", 1e-2)],
        Dimension::Pressure => &[("MPa", 1e6)],
        Dimension::AngularSpeed => &[("rpm", std::f64::consts::PI / 30.0)],
        _ => &[],
    };
    // Twelve digits hide the rounding of the quotient.
    let short = |x: f64| format!("{x:.11e}").parse().unwrap_or(x);
    common
        .iter()
        .map(|(unit, factor)| format!("{} {unit}", short(value / factor)))
        .find(|text| text.len() <= si.len() && parse(text, dimension) == Ok(value))
        .unwrap_or(si)
}

/// A value as a user typed it.
pub fn shown(typed: &Toml) -> String {
    typed.to_string()
}

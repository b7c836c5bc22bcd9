//! Values of keys, and their text in a scene file.

use toml::Value as Toml;

use crate::units::{Dimension, parse};

/// Value of a key, with its type.
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
    /// A number in SI units, for a key with a dimension.
    Number(f64),
    /// A whole number, such as a number of spans.
    Count(usize),
    /// A Boolean value.
    Flag(bool),
    /// A word or a text.
    Text(String),
    /// A list of texts.
    Texts(Vec<String>),
}

impl Value {
    /// The number; `None` if the value is not a number.
    pub fn number(self) -> Option<f64> {
        match self {
            Value::Number(x) => Some(x),
            _ => None,
        }
    }

    /// The whole number; `None` if the value is not a whole number.
    pub fn count(self) -> Option<usize> {
        match self {
            Value::Count(n) => Some(n),
            _ => None,
        }
    }

    /// The text; empty if the value is not a text.
    pub fn text(self) -> String {
        match self {
            Value::Text(text) => text,
            _ => String::new(),
        }
    }

    /// The list of texts; empty if the value is not a list of texts.
    pub fn texts(self) -> Vec<String> {
        match self {
            Value::Texts(list) => list,
            _ => Vec::new(),
        }
    }

    /// TOML value for a scene file. A number has a unit of `dimension`. Reading the TOML value again gives exactly the same value.
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

/// Text of a number for a scene file, with its unit. Reading the text again gives exactly the same number. A common unit such as mm is used
/// if the text is then exact and not longer than in SI units.
pub(super) fn written(value: f64, dimension: Dimension) -> String {
    let si = format!("{value} {}", dimension.si());
    let common: &[(&str, f64)] = match dimension {
        Dimension::Length => &[("mm", 1e-3)],
        Dimension::Angle => &[("deg", std::f64::consts::PI / 180.0)],
        Dimension::Percent => &[("%", 1e-2)],
        Dimension::Pressure => &[("MPa", 1e6)],
        Dimension::AngularSpeed => &[("rpm", std::f64::consts::PI / 30.0)],
        _ => &[],
    };
    common
        .iter()
        .map(|(unit, factor)| format!("{} {unit}", short(value / factor)))
        .find(|text| text.len() <= si.len() && parse(text, dimension) == Ok(value))
        .unwrap_or(si)
}

/// The number, rounded to twelve significant digits. This removes the rounding error of a quotient.
pub fn short(x: f64) -> f64 {
    format!("{x:.11e}").parse().unwrap_or(x)
}

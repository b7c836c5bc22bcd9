//! Keys that a sweep varies, and their values as text in a scene.

use toml::{Table, Value};

use crate::error::{Place, Result};
use crate::scene::keys::{self, KEYS, Kind};
use crate::scene::{self, Scene};
use crate::units::Dimension;

/// A varied key, whose values are numbers in SI units or words.
///
/// ```
/// use gaitcam::sweep::Key;
///
/// let (stroke, values) = Key::quantity("limits.stroke", &["40 mm", "2 in"])?.unwrap();
/// assert_eq!((stroke.column().as_str(), values), ("limits.stroke_m", vec![0.04, 0.0508]));
/// assert_eq!(Key::of_column("limits.stroke_m"), stroke);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Key {
    name: String,
    number: Option<Number>,
}

/// A varied key with numeric values.
#[derive(Debug, Clone, Copy)]
struct Number {
    row: &'static keys::Key,
    /// Index of the element in the list that is the value of the key, from 0. It is 0 if the value is not a list.
    index: usize,
    /// Dimension of the numbers. It can depend on the follower. For example, the stroke of an arm is an angle, and other strokes are
    /// lengths.
    dimension: Dimension,
}

/// Whether a text begins like a number: with a digit, a sign or a decimal point.
pub fn starts_a_number(text: &str) -> bool {
    let text = text.trim();
    text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
}

impl PartialEq for Key {
    fn eq(&self, other: &Key) -> bool {
        self.column() == other.column()
    }
}

impl Key {
    /// A key whose values are words, whole numbers or paths.
    pub fn words(name: &str) -> Key {
        Key {
            name: name.trim().to_string(),
            number: None,
        }
    }

    /// The key with this name and the values in SI units. If the key can have several dimensions, the units of `values` determine the
    /// dimension. `None` if the key has no unit, or if a value is a word such as `auto`.
    ///
    /// # Errors
    ///
    /// A value does not have the unit of the key.
    pub fn quantity(name: &str, values: &[&str]) -> Result<Option<(Key, Vec<f64>)>> {
        let name = name.trim();
        let mut fault = None;
        for key in Key::of_each_dimension(name) {
            let Some(number) = key.number else { continue };
            let parsed: Result<Vec<f64>> = values
                .iter()
                .map(|v| crate::units::parse(v, number.dimension))
                .collect();
            match parsed {
                Ok(numbers) => return Ok(Some((key, numbers))),
                Err(e) => fault = fault.or(Some(e)),
            }
        }
        // Words such as "auto", "free" and "spread" are parsed when the scene is read.
        let words = values.iter().any(|v| !starts_a_number(v));
        match fault {
            Some(e) if !words => Err(e.placed(Place::Key(name.to_string()))),
            _ => Ok(None),
        }
    }

    /// Numeric keys with this name, one for each possible dimension of the key. Empty if the key has no unit.
    fn of_each_dimension(name: &str) -> Vec<Key> {
        let row = keys::find(name).and_then(|row| Some((row, row.index_in(name)?, row.measure()?)));
        let Some((row, index, measure)) = row else {
            return Vec::new();
        };
        let of = |dimension| Key {
            name: name.to_string(),
            number: Some(Number {
                row,
                index,
                dimension,
            }),
        };
        measure.each().into_iter().map(of).collect()
    }

    /// Names of all keys that can be varied, in alphabetical order.
    pub fn names() -> Vec<&'static str> {
        let mut names: Vec<&str> = KEYS
            .iter()
            .filter(|k| k.list().is_none() && k.path != "name")
            .map(|k| k.path)
            .collect();
        names.sort_unstable();
        names
    }

    /// The key to which a column of a table belongs. `column` is the name of the column.
    pub fn of_column(column: &str) -> Key {
        let names = (0..=column.len()).filter(|&end| column.is_char_boundary(end));
        names
            .flat_map(|end| Key::of_each_dimension(&column[..end]))
            .find(|key| key.column() == column)
            .unwrap_or_else(|| Key::words(column))
    }

    /// Dotted name of the key, such as `limits.stroke`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether the values of the key are numbers in SI units.
    pub fn is_number(&self) -> bool {
        self.number.is_some()
    }

    /// SI unit of the values, as written in scenes; empty for words and ratios.
    pub fn unit(&self) -> &'static str {
        self.number.map_or("", |n| n.dimension.si())
    }

    /// Name of the column of the key, such as `limits.stroke_m` or `law.family`.
    pub fn column(&self) -> String {
        let unit = match self.unit() {
            "" | "ratio" => return self.name.clone(),
            unit => unit.to_lowercase(),
        };
        let unit = unit.replace('/', "_per_").replace('^', "");
        format!("{}_{}", self.name, unit.replace(' ', "_"))
    }

    /// Sets the key to a number in SI units in a scene. Returns `false` if the scene must be read again with this number.
    pub(in crate::sweep) fn set(&self, scene: &mut Scene, value: f64) -> bool {
        self.number.is_some_and(|n| {
            n.row.dimension(scene) == Some(n.dimension) && n.row.set_number(scene, n.index, value)
        })
    }

    /// Sets the key to a number in SI units in the table of a scene.
    ///
    /// # Errors
    ///
    /// The errors of [`set`](crate::scene::set).
    pub fn write_number(&self, table: &mut Table, value: f64) -> Result<()> {
        scene::set(table, &format!("{}={value} {}", self.name, self.unit()))
    }

    /// Sets the key to a word, whole number or path in the table of a scene.
    ///
    /// # Errors
    ///
    /// The errors of [`set`](crate::scene::set).
    pub fn write_words(&self, table: &mut Table, words: &str) -> Result<()> {
        let text = keys::find(&self.name).is_some_and(|k| matches!(k.kind, Kind::Text));
        let words = if text {
            Value::from(words).to_string()
        } else {
            words.to_string()
        };
        scene::set(table, &format!("{}={words}", self.name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_quantity_reads_back_from_its_column_and_its_si_unit() {
        for row in KEYS.iter() {
            let name = row.path_at(1);
            for key in Key::of_each_dimension(&name) {
                let text = format!("0.25 {}", key.unit());
                let (read, values) = Key::quantity(&name, &[&text]).unwrap().unwrap();
                assert_eq!((read, values), (key.clone(), vec![0.25]), "{name}");
                assert_eq!(Key::of_column(&key.column()), key);
            }
        }
    }
}

//! Scene keys that a sweep varies: which have a unit, and how a number reaches the scene without text.

use std::f64::consts::FRAC_PI_2;

use toml::{Table, Value};

use super::quantities::Allowed::{Acute, Any, NotNegative, Positive};
use super::quantities::{QUANTITIES, Quantity, WORDS};
use crate::error::{Error, Place, Result};
use crate::scene::{self, Scene};

/// A scene key that varies: a quantity in SI, or words.
#[derive(Debug, Clone)]
pub struct Key {
    name: String,
    quantity: Option<&'static Quantity>,
}

/// Whether a value is meant as a number.
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
    /// A key whose values are words, counts or paths.
    pub fn words(name: &str) -> Key {
        Key {
            name: name.trim().to_string(),
            quantity: None,
        }
    }

    /// The quantity of that name in which `values` make sense, with the values in SI; `None` when the key
    /// has no unit or a value is a word such as `auto`.
    pub fn quantity(name: &str, values: &[&str]) -> Result<Option<(Key, Vec<f64>)>> {
        let name = name.trim();
        let mut fault = None;
        for quantity in QUANTITIES.iter().filter(|q| q.name == name) {
            let parsed: Result<Vec<f64>> = values
                .iter()
                .map(|v| crate::units::parse(v, quantity.dimension))
                .collect();
            match parsed {
                Ok(numbers) => {
                    let key = Key {
                        name: name.to_string(),
                        quantity: Some(quantity),
                    };
                    return Ok(Some((key, numbers)));
                }
                Err(e) => fault = fault.or(Some(e)),
            }
        }
        // Words such as "auto", "free" and "spread" are for the scene's reader.
        let words = values.iter().any(|v| !starts_a_number(v));
        match fault {
            Some(e) if !words => Err(e.placed(Place::Key(name.to_string()))),
            _ => Ok(None),
        }
    }

    /// Names of all keys that vary, each once.
    pub fn names() -> Vec<&'static str> {
        let mut names: Vec<&str> = QUANTITIES.iter().map(|q| q.name).collect();
        names.extend(WORDS);
        names.sort_unstable();
        names.dedup();
        names
    }

    /// The key whose column has this name, for readers of tables.
    pub fn of_column(column: &str) -> Key {
        let quantity = QUANTITIES
            .iter()
            .find(|q| column.strip_suffix(q.suffix) == Some(q.name));
        match quantity {
            Some(q) => Key {
                name: q.name.to_string(),
                quantity: Some(q),
            },
            None => Key::words(column),
        }
    }

    /// The dotted name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether its values are numbers in SI.
    pub fn is_number(&self) -> bool {
        self.quantity.is_some()
    }

    /// SI unit as scenes write it; empty for words and ratios.
    pub fn unit(&self) -> &'static str {
        self.quantity.map_or("", |q| q.unit)
    }

    /// Name of its column: `limits.stroke_m`, `law.family`.
    pub fn column(&self) -> String {
        format!("{}{}", self.name, self.quantity.map_or("", |q| q.suffix))
    }

    /// Whether a number may go straight into a scene; otherwise the scene's reader decides.
    pub(super) fn takes(&self, value: f64) -> bool {
        let Some(q) = self.quantity.filter(|q| q.set.is_some()) else {
            return false;
        };
        value.is_finite()
            && match q.allowed {
                Any => true,
                Positive => value > 0.0,
                NotNegative => value >= 0.0,
                Acute => value > 0.0 && value < FRAC_PI_2,
            }
    }

    /// Sets the number in a scene that is already read.
    pub(super) fn set(&self, scene: &mut Scene, value: f64) {
        if let Some(set) = self.quantity.and_then(|q| q.set) {
            set(scene, value);
        }
    }

    /// Writes the number into a scene's table, in SI.
    pub fn write_number(&self, table: &mut Table, value: f64) -> Result<()> {
        scene::set(table, &format!("{}={value} {}", self.name, self.unit()))
    }

    /// Writes words into a scene's table. A recording takes the place of a model and the other way round.
    pub fn write_words(&self, table: &mut Table, words: &str) -> Result<()> {
        let replaced: &[&str] = match self.name.as_str() {
            "gait.file" => &["model", "step_frequency", "body_weight"],
            "gait.model" => &["file", "time", "force", "unit", "rate", "mass"],
            _ => return scene::set(table, &format!("{}={words}", self.name)),
        };
        let gait = table
            .entry("gait")
            .or_insert_with(|| Value::Table(Table::new()));
        let Some(gait) = gait.as_table_mut() else {
            return Err(Error::key("gait", "is a value, not a table"));
        };
        for key in replaced {
            gait.remove(*key);
        }
        let key = self.name.trim_start_matches("gait.");
        gait.insert(key.to_string(), Value::String(words.to_string()));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Dimension as D;

    #[test]
    fn every_quantity_reads_back_from_its_column_and_its_si_unit() {
        for q in QUANTITIES {
            let text = format!("0.25 {}", q.unit);
            let (key, values) = Key::quantity(q.name, &[&text]).unwrap().unwrap();
            assert_eq!(values, [0.25], "{}", q.name);
            assert_eq!(Key::of_column(&key.column()), key);
        }
    }

    #[test]
    fn setters_do_what_the_reader_does() {
        let mut base: Table = scene::DEFAULT.parse().unwrap();
        for q in QUANTITIES
            .iter()
            .filter(|q| q.dimension != D::Angle || q.name != "limits.stroke")
        {
            let Some(set) = q.set else { continue };
            let mut table = base.clone();
            if q.name.contains("spring_rate")
                || q.name.contains("preload")
                || q.name.contains("damping")
            {
                scene::set(&mut table, "drive.kind=fixed-axis").unwrap();
            }
            if q.name.contains("pressure_per") || q.name.contains("piston") {
                for change in [
                    "drive.kind=hydraulic",
                    "drive.pressure_per_volume=30 psi/in^3",
                    "drive.piston_radius=2 cm",
                ] {
                    scene::set(&mut table, change).unwrap();
                }
            }
            if q.name == "cam.roller_radius" {
                scene::set(&mut table, "cam.follower=roller-translating").unwrap();
                scene::set(&mut table, "cam.roller_radius=1 cm").unwrap();
            }
            let mut direct = scene::read(&table).unwrap();
            set(&mut direct, 0.3);
            let key = Key {
                name: q.name.to_string(),
                quantity: Some(q),
            };
            key.write_number(&mut table, 0.3).unwrap();
            assert_eq!(scene::read(&table).unwrap(), direct, "{}", q.name);
        }
        Key::words("gait.file")
            .write_words(&mut base, "walk.mot")
            .unwrap();
        assert!(scene::read(&base).is_ok());
    }
}

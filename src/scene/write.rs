//! Writing a [`Scene`] as TOML or in any format of serde. Reading the result with [`read`](super::read()) gives exactly the same scene.

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use toml::{Table, Value as Toml};

use super::keys::{KEYS, Key, Value, read_value};
use super::{Scene, read, set};
use crate::error::Result;

impl Scene {
    /// Table of the scene in the form of a scene file. It contains every key that differs from its default.
    pub fn to_table(&self) -> Table {
        let mut table = Table::new();
        if self.gait.is_some() {
            table.insert("gait".to_string(), Toml::Table(Table::new()));
        }
        for key in KEYS.iter().filter(|k| k.exists(self)) {
            if key.list().is_some() {
                for index in 0.. {
                    let Some(value) = key.get(self, index) else {
                        if index >= entries(self, key) {
                            break;
                        }
                        continue;
                    };
                    put(&mut table, key, index, self.written(key, &value));
                }
            } else if let Some(value) = key.get(self, 0).filter(|v| !self.is_default(key, v)) {
                put(&mut table, key, 0, self.written(key, &value));
            }
        }
        table
    }

    /// Copy of the scene with another value of one key, written as in a scene file: `scene.with("limits.stroke", "40 mm")`.
    ///
    /// # Errors
    ///
    /// The errors of [`read`](super::read()).
    pub fn with(&self, key: &str, value: &str) -> Result<Scene> {
        let mut table = self.to_table();
        set(&mut table, &format!("{key}={value}"))?;
        read(&table)
    }

    fn written(&self, key: &Key, value: &Value) -> Toml {
        value.to_toml(key.dimension(self))
    }

    /// Whether a value equals the default value of the key.
    pub(super) fn is_default(&self, key: &Key, value: &Value) -> bool {
        if key.default.is_empty() || key.default == "auto" {
            return false;
        }
        let plain = match value {
            Value::Flag(_) => Toml::Boolean(key.default == "true"),
            Value::Number(x) if let Ok(default) = key.default.parse::<f64>() => {
                return default == *x;
            }
            _ => Toml::String(key.default.to_string()),
        };
        let default = read_value(key, &plain, self, key.path);
        default.is_ok_and(|d| d.as_ref() == Some(value))
    }
}

/// Number of entries in the list that contains the key. Every entry has the required keys of the list, so the values of one of them are
/// counted.
fn entries(scene: &Scene, key: &Key) -> usize {
    let list = key.list();
    let sibling = |k: &&Key| k.list() == list && k.is_required(scene);
    KEYS.iter().find(sibling).map_or(0, |k| {
        (0..).take_while(|&i| k.get(scene, i).is_some()).count()
    })
}

fn put(table: &mut Table, key: &Key, index: usize, value: Toml) {
    let mut at = table;
    let mut parts: Vec<&str> = key.path.split('.').collect();
    let Some(last) = parts.pop() else { return };
    let mut parts = parts.into_iter().peekable();
    while let Some(part) = parts.next() {
        let list = parts.next_if_eq(&"N").is_some();
        let empty = if list {
            Toml::Array(Vec::new())
        } else {
            Toml::Table(Table::new())
        };
        let inner = at.entry(part.to_string()).or_insert(empty);
        if let Toml::Array(entries) = inner {
            while entries.len() <= index {
                entries.push(Toml::Table(Table::new()));
            }
        }
        at = match inner {
            Toml::Table(inner) => inner,
            Toml::Array(entries) => match &mut entries[index] {
                Toml::Table(inner) => inner,
                _ => return,
            },
            _ => return,
        };
    }
    at.insert(last.to_string(), value);
}

impl Serialize for Scene {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        self.to_table().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Scene {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Scene, D::Error> {
        let table = Table::deserialize(deserializer)?;
        read(&table).map_err(serde::de::Error::custom)
    }
}

//! Changes of a scene's table: values by their keys, entries of its lists.

use serde::Deserialize;
use toml::{Table, Value};

use crate::page::fault::StudioError;
use gaitcam::error::{Error, Place, Placed, Result, SceneError};
use gaitcam::scene::keys::{self, Key, Kind};
use gaitcam::scene::{self, Scene, unset};
use gaitcam::units::{Dimension, parse};

/// One change of a scene.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Edit {
    /// Sets a value as written in a scene file; an empty value removes the key.
    Set {
        /// Dotted key of the value.
        key: String,
        /// New value of the key.
        value: String,
    },
    /// Adds an entry to a list, as a copy of the one before or as the first entry.
    Insert {
        /// Dotted name of the list.
        list: String,
        /// Number of the entry inserted, counted from 1.
        number: usize,
    },
    /// Removes an entry from a list.
    Remove {
        /// Dotted name of the list.
        list: String,
        /// Number of the entry removed, counted from 1.
        number: usize,
    },
    /// Moves an entry of a list.
    Move {
        /// Dotted name of the list.
        list: String,
        /// Number of the entry moved, counted from 1.
        from: usize,
        /// Number of the entry after the move.
        to: usize,
    },
    /// Scales the angles of all segments but one so that they cover the turn.
    Rebalance {
        /// The segment that keeps its angle; 0 for none.
        keep: usize,
    },
}

/// Attempts to complete a scene after a choice.
const MENDINGS: usize = 12;
/// Decimals of the angles in degrees that rebalancing writes.
const PLACES: f64 = 1e6;

/// Reads a scene with the files of its motions.
pub type Read<'a> = dyn Fn(&Table) -> Result<Scene> + 'a;

/// Applies a change.
///
/// # Errors
/// Paths through values, entries that are not there.
pub fn apply(table: &mut Table, edit: &Edit, read: &Read) -> Result<()> {
    match edit {
        Edit::Set { key, value } if value.trim().is_empty() => {
            unset(table, key);
            Ok(())
        }
        Edit::Set { key, value } => {
            set(table, key, value)?;
            let chooses = keys::find(key).is_some_and(|k| matches!(k.kind, Kind::Choice(_)));
            if chooses {
                mend(table, read);
            }
            Ok(())
        }
        Edit::Insert { list, number } => insert(table, list, *number),
        Edit::Remove { list, number } => {
            let entries = entries(table, list)?;
            if *number == 0 || *number > entries.len() {
                return Err(no_entry(list, *number));
            }
            entries.remove(number - 1);
            if entries.is_empty() {
                unset(table, list);
            }
            Ok(())
        }
        Edit::Move { list, from, to } => {
            let entries = entries(table, list)?;
            for number in [from, to] {
                if *number == 0 || *number > entries.len() {
                    return Err(no_entry(list, *number));
                }
            }
            let entry = entries.remove(from - 1);
            entries.insert(to - 1, entry);
            Ok(())
        }
        Edit::Rebalance { keep } => rebalance(table, *keep),
    }
}

fn set(table: &mut Table, key: &str, value: &str) -> Result<()> {
    let text = keys::find(key).is_some_and(|k| matches!(k.kind, Kind::Text));
    let value = if text {
        Value::from(value).to_string()
    } else {
        value.to_string()
    };
    scene::set(table, &format!("{key}={value}"))
}

fn no_entry(list: &str, number: usize) -> Error {
    let list = list.to_string();
    StudioError::NoEntry { list, number }.into()
}

/// The entries of a list.
fn entries<'t>(table: &'t mut Table, list: &str) -> Result<&'t mut Vec<Value>> {
    let (section, name) = list.split_once('.').unwrap_or(("", list));
    let inside = match section {
        "" => Some(table),
        _ => table.get_mut(section).and_then(Value::as_table_mut),
    };
    let found = inside
        .and_then(|t| t.get_mut(name))
        .and_then(Value::as_array_mut);
    found.ok_or_else(|| no_entry(list, 1))
}

fn insert(table: &mut Table, list: &str, number: usize) -> Result<()> {
    if let Ok(entries) = entries(table, list) {
        let at = number.clamp(1, entries.len() + 1) - 1;
        let like = entries
            .get(at.saturating_sub(1))
            .or(entries.last())
            .cloned();
        let mut entry = like.unwrap_or_else(|| first(list));
        if list == "law.segment"
            && let Value::Table(entry) = &mut entry
        {
            // A rest between its neighbours leaves the lifts closed.
            entry.insert("motion".to_string(), "dwell".into());
            entry.remove("lift");
        }
        entries.insert(at, entry);
        return Ok(());
    }
    let known = keys::KEYS.iter().any(|k| k.list() == Some(list));
    let (section, name) = list.split_once('.').ok_or_else(|| no_entry(list, number))?;
    if !known {
        return Err(no_entry(list, number));
    }
    let below = table
        .entry(section)
        .or_insert_with(|| Value::Table(Table::new()));
    let below = below.as_table_mut().ok_or_else(|| no_entry(list, number))?;
    below.insert(name.to_string(), Value::Array(vec![first(list)]));
    Ok(())
}

/// The first entry of a list.
fn first(list: &str) -> Value {
    let pairs: &[(&str, &str)] = match list {
        "law.segment" => &[("motion", "dwell"), ("angle", "360 deg")],
        "law.point" => &[("angle", "0"), ("lift", "0")],
        "law.dwell" => &[("from", "0"), ("to", "30 deg")],
        _ => &[("from", "0"), ("to", "90 deg"), ("weight", "2")],
    };
    let entry = pairs
        .iter()
        .map(|(k, v)| ((*k).to_string(), Value::from(*v)));
    Value::Table(entry.collect())
}

/// Adds the keys that a choice needs and removes those that it does not have.
fn mend(table: &mut Table, read: &Read) {
    for _ in 0..MENDINGS {
        let Err(fault) = read(table) else {
            return;
        };
        let (Place::Key(path), Some(kind)) = (&fault.place, fault.fault()) else {
            return;
        };
        match kind {
            SceneError::NeededByFollower { .. } | SceneError::NeededByDrive { .. } => {
                let Some(key) = keys::find(path) else { return };
                if set(table, path, &example(key)).is_err() {
                    return;
                }
            }
            SceneError::NotOfFollower { .. }
            | SceneError::NotOfDrive { .. }
            | SceneError::MassOfArm => {
                unset(table, path);
            }
            SceneError::ArmOnMovingAxis => {
                unset(table, "drive.kind");
            }
            _ => return,
        }
    }
}

/// A valid value for a key.
fn example(key: &Key) -> String {
    let example = key.example(&Scene::default());
    example.split('"').nth(1).unwrap_or("0").to_string()
}

fn rebalance(table: &mut Table, keep: usize) -> Result<()> {
    let entries = entries(table, "law.segment")?;
    let mut angles = Vec::new();
    for (i, entry) in entries.iter().enumerate() {
        let text = entry.get("angle").and_then(Value::as_str).unwrap_or("0");
        let place = |e: Error| e.at_key(&format!("law.segment.{}.angle", i + 1));
        angles.push(parse(text, Dimension::Angle).map_err(place)?);
    }
    let turn = std::f64::consts::TAU;
    let kept = keep
        .checked_sub(1)
        .and_then(|i| angles.get(i).copied())
        .unwrap_or(0.0);
    let others: f64 = angles.iter().sum::<f64>() - kept;
    if others <= 0.0 || kept >= turn {
        return Ok(());
    }
    // Degrees are written to a millionth; the last free segment takes what rounding leaves.
    let degrees = |x: f64| (x.to_degrees() * PLACES).round() / PLACES;
    let mut left = 360.0 - degrees(kept);
    let last = (0..angles.len()).rev().find(|i| i + 1 != keep);
    for (i, entry) in entries
        .iter_mut()
        .enumerate()
        .filter(|(i, _)| i + 1 != keep)
    {
        let scaled = degrees(angles[i] * (turn - kept) / others);
        let written = if Some(i) == last {
            (left * PLACES).round() / PLACES
        } else {
            scaled
        };
        left -= scaled;
        if let Value::Table(entry) = entry {
            entry.insert("angle".to_string(), format!("{written} deg").into());
        }
    }
    if kept > 0.0
        && let Some(Value::Table(entry)) = entries.get_mut(keep - 1)
    {
        entry.insert("angle".to_string(), format!("{} deg", degrees(kept)).into());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str) -> Table {
        text.parse().unwrap()
    }

    fn changed(text: &str, edits: &[Edit]) -> Table {
        let mut table = table(text);
        for edit in edits {
            apply(&mut table, edit, &scene::read).unwrap();
        }
        table
    }

    fn to(key: &str, value: &str) -> Edit {
        let (key, value) = (key.to_string(), value.to_string());
        Edit::Set { key, value }
    }

    #[test]
    fn an_empty_value_takes_the_key_out_and_its_empty_table_with_it() {
        let after = changed("[limits]\nstroke = \"4 mm\"\n", &[to("limits.stroke", " ")]);
        assert_eq!(after, Table::new());
    }

    #[test]
    fn every_follower_can_be_chosen_from_the_default_scene() {
        let choices = keys::find("cam.follower").unwrap().choices();
        let straight = ["translating-cam", "barrel"];
        for follower in choices
            .into_iter()
            .filter(|f| !straight.contains(f) && !f.contains("oscillating"))
        {
            let after = changed(scene::DEFAULT, &[to("cam.follower", follower)]);
            assert!(scene::read(&after).is_ok(), "{follower}: {after}");
        }
    }

    #[test]
    fn angles_are_rebalanced_to_the_turn_and_the_kept_one_stays() {
        let toml = scene::built_in("camdas_09_eight_motions").unwrap().toml;
        let after = changed(
            toml,
            &[
                to("law.segment.2.angle", "70 deg"),
                Edit::Rebalance { keep: 2 },
            ],
        );
        let angles: Vec<f64> = after["law"]["segment"]
            .as_array()
            .unwrap()
            .iter()
            .map(|s| {
                parse(s["angle"].as_str().unwrap(), Dimension::Angle)
                    .unwrap()
                    .to_degrees()
            })
            .collect();
        assert!(
            (angles.iter().sum::<f64>() - 360.0).abs() < 1e-9,
            "{angles:?}"
        );
        assert!((angles[1] - 70.0).abs() < 1e-12);
        assert!((angles[0] / angles[2] - 1.0).abs() < 1e-9);
        assert!(scene::read(&after).is_ok());
    }

    #[test]
    fn entries_are_added_moved_and_taken_out() {
        let toml = scene::built_in("camdas_09_eight_motions").unwrap().toml;
        let list = || "law.segment".to_string();
        let count = |table: &Table| table["law"]["segment"].as_array().unwrap().len();
        let added = changed(
            toml,
            &[Edit::Insert {
                list: list(),
                number: 2,
            }],
        );
        assert_eq!(count(&added), 9);
        assert_eq!(added["law"]["segment"][1]["motion"].as_str(), Some("dwell"));
        let back = changed(
            toml,
            &[
                Edit::Insert {
                    list: list(),
                    number: 2,
                },
                Edit::Remove {
                    list: list(),
                    number: 2,
                },
            ],
        );
        assert_eq!(back, table(toml));
        let mut none = table(toml);
        assert!(
            apply(
                &mut none,
                &Edit::Remove {
                    list: list(),
                    number: 99
                },
                &scene::read
            )
            .is_err()
        );
        assert!(
            apply(
                &mut none,
                &Edit::Insert {
                    list: "law.nothing".to_string(),
                    number: 1
                },
                &scene::read
            )
            .is_err()
        );
    }
}

//! Changes of the table of a scene: values of keys, and entries of lists.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::{Table, Value};

use crate::page::fault::StudioError;
use crate::page::form::typed;
use gaitcam::error::{Error, Place, Result, SceneError};
use gaitcam::scene::keys::{self, Key, Kind};
use gaitcam::scene::{self, Scene, unset};

/// One change of a scene.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Edit {
    /// Sets a key to a value as written in a scene file. An empty value removes the key.
    Set {
        /// Dotted key of the value, such as `limits.stroke`.
        key: String,
        /// New value as text, in the form of a scene file.
        value: String,
    },
    /// Inserts an entry in a list. The new entry is a copy of the preceding entry, or a valid default if the list is empty.
    Insert {
        /// Dotted name of the list, such as `law.segment`.
        list: String,
        /// Number of the inserted entry, counted from 1.
        number: usize,
    },
    /// Removes an entry from a list.
    Remove {
        /// Dotted name of the list, such as `law.segment`.
        list: String,
        /// Number of the removed entry, counted from 1.
        number: usize,
    },
    /// Moves an entry of a list.
    Move {
        /// Dotted name of the list, such as `law.segment`.
        list: String,
        /// Number of the moved entry, counted from 1.
        from: usize,
        /// Number of the entry after the move.
        to: usize,
    },
    /// Replaces all segments of the motion programme. The law family is set to `program`, and keys that contradict a programme are removed.
    /// Without segments, the law family is removed.
    Programme {
        /// Texts of each segment by column name. Empty texts are omitted.
        segments: Vec<BTreeMap<String, String>>,
    },
}

/// Maximum number of corrections by which a scene is completed after the user has changed a key with fixed choices.
const MENDINGS: usize = 12;
/// Keys that do not apply to a motion programme: the target force, the keys that depend on it, and keys of other families.
const SET_ASIDE: [&str; 15] = [
    "gait",
    "accuracy",
    "limits.force_min",
    "limits.force_max",
    "machine.floor",
    "law.degree",
    "law.spans",
    "law.harmonics",
    "law.minimise",
    "law.robust",
    "law.error",
    "law.monotone",
    "law.polydyne",
    "law.point",
    "law.dwell",
];
/// Shaft speed of a scene that becomes a motion programme, if its speed was computed from the force.
const SPEED: &str = "60 rpm";

/// Function that parses the table of a scene and reads the files of its motions.
pub type Read<'a> = dyn Fn(&Table) -> Result<Scene> + 'a;

/// Applies a change to the table of a scene.
///
/// # Errors
///
/// The path of a key contains a value that is not a table, or a list entry does not exist.
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
        Edit::Programme { segments } => programme(table, segments, read),
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

/// Entries of a list in the table of a scene. A list that does not exist is an error.
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
        entries.insert(at, like.unwrap_or_else(|| first(list)));
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

/// Valid default for the first entry of a list.
fn first(list: &str) -> Value {
    let pairs: &[(&str, &str)] = match list {
        "law.point" => &[("angle", "0"), ("lift", "0")],
        "law.dwell" => &[("from", "0"), ("to", "30 deg")],
        _ => &[("from", "0"), ("to", "90 deg"), ("weight", "2")],
    };
    let entry = pairs
        .iter()
        .map(|(k, v)| ((*k).to_string(), Value::from(*v)));
    Value::Table(entry.collect())
}

/// Adds the keys that a new choice (such as a follower) requires, and removes the keys that do not exist with this choice.
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

/// Valid value of a key, as text.
fn example(key: &Key) -> String {
    let example = key.example(&Scene::default());
    example.split('"').nth(1).unwrap_or("0").to_string()
}

/// Replaces the law of the scene by the segments of a motion programme.
fn programme(table: &mut Table, segments: &[BTreeMap<String, String>], read: &Read) -> Result<()> {
    if segments.is_empty() {
        unset(table, "law.segment");
        unset(table, "law.family");
        return Ok(());
    }
    let family = typed(table, "law.family");
    let has_segments = !typed(table, "law.segment").is_empty();
    let is_programme = family == "program" || family.is_empty() && has_segments;
    if !is_programme {
        set_aside(table)?;
    }
    let law = table
        .entry("law")
        .or_insert_with(|| Value::Table(Table::new()));
    let no_law = || no_entry("law.segment", 1);
    let law = law.as_table_mut().ok_or_else(no_law)?;
    let entry = |texts: &BTreeMap<String, String>| {
        let filled = texts.iter().filter(|(_, text)| !text.trim().is_empty());
        Value::Table(
            filled
                .map(|(key, text)| (key.clone(), Value::from(text.as_str())))
                .collect(),
        )
    };
    law.insert("family".to_string(), "program".into());
    law.insert(
        "segment".to_string(),
        segments.iter().map(entry).collect::<Vec<_>>().into(),
    );
    if !is_programme {
        mend(table, read);
    }
    Ok(())
}

/// Removes keys that contradict a motion programme. A speed that was computed from the force is replaced by the constant `SPEED`. A moving
/// axis without a given mass is replaced by a fixed axis.
fn set_aside(table: &mut Table) -> Result<()> {
    for key in SET_ASIDE {
        unset(table, key);
    }
    let is_open = |text: String| text.is_empty() || text == "auto";
    if typed(table, "drive.kind") == "moving-axis" && is_open(typed(table, "drive.mass")) {
        set(table, "drive.kind", "fixed-axis")?;
        unset(table, "drive.mass");
    }
    if is_open(typed(table, "drive.speed")) {
        set(table, "drive.speed", SPEED)?;
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

    fn segments(rows: &[(&str, &str, &str)]) -> Edit {
        let segment = |(motion, lift, angle): &(&str, &str, &str)| {
            let pairs = [("motion", *motion), ("lift", *lift), ("angle", *angle)];
            pairs.map(|(k, v)| (k.to_string(), v.to_string())).into()
        };
        let segments = rows.iter().map(segment).collect();
        Edit::Programme { segments }
    }

    const DOUBLE_DWELL: [(&str, &str, &str); 4] = [
        ("cycloidal", "20 mm", "60 deg"),
        ("dwell", "", "120 deg"),
        ("cycloidal", "-20 mm", "60 deg"),
        ("dwell", "", "120 deg"),
    ];

    #[test]
    fn a_programme_can_take_the_place_of_every_law() {
        for built_in in scene::SCENES {
            let before = table(built_in.toml);
            let follower = typed(&before, "cam.follower");
            if follower.contains("oscillating") || follower == "translating-cam" {
                continue;
            }
            let after = changed(built_in.toml, &[segments(&DOUBLE_DWELL)]);
            let read = scene::read(&after).unwrap_or_else(|e| panic!("{}: {e}", built_in.name));
            assert_eq!(read.law.family, scene::Family::Program, "{}", built_in.name);
            assert_eq!(read.law.segments.len(), 4);
            let was = typed(&before, "law.family") == "program";
            assert_eq!(
                after.get("gait").is_some(),
                was && before.contains_key("gait")
            );
        }
    }

    #[test]
    fn a_programme_on_the_default_scene_is_acceptable() {
        let after = changed(scene::DEFAULT, &[segments(&DOUBLE_DWELL)]);
        let design = scene::read(&after).unwrap().design().unwrap();
        assert_eq!(design.verdict.name(), "acceptable");
        assert!((design.cam.law.stroke() - 0.02).abs() < 1e-9);
    }

    #[test]
    fn a_programme_without_segments_has_no_family() {
        let toml = scene::built_in("camdas_09_eight_motions").unwrap().toml;
        let after = changed(toml, &[segments(&[])]);
        assert!(after.get("law").is_none(), "{after}");
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

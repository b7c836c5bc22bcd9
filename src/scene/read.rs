//! Reading a [`Scene`] from TOML, with the key table.

use toml::{Table, Value as Toml};

use super::keys::{KEYS, Key, read_value};
use super::rules::{self, Typed};
use super::{DriveSpec, Gait, Scene};
use crate::error::{Placed, Result, SceneError, nearest};

/// Reads a scene from the text of a scene file.
///
/// ```
/// let scene = gaitcam::scene::parse("gait.model = \"young\"\nlimits.stroke = \"40 mm\"")?;
/// assert_eq!(scene.limits[gaitcam::LimitKind::Stroke], Some(0.04));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
///
/// # Errors
/// The text is not TOML; errors of [`read`].
pub fn parse(text: &str) -> Result<Scene> {
    read(&table(text)?)
}

/// Parses the text of a scene file to a TOML table. Single values can be changed in the table before [`read`].
///
/// # Errors
///
/// The text is not TOML. The error contains the line.
pub fn table(text: &str) -> Result<Table> {
    text.parse().map_err(|e: toml::de::Error| {
        let start = e.span().map_or(0, |s| s.start.min(text.len()));
        let line = text[..start].matches('\n').count() + 1;
        let fault = e.message().replace('\n', ", ");
        SceneError::NotToml { line, fault }.into()
    })
}

/// Reads a scene from its TOML table.
///
/// # Errors
///
/// Unknown keys, invalid values, and inconsistent keys. Each error contains the dotted key and a valid value.
pub fn read(table: &Table) -> Result<Scene> {
    let scene = read_keys(table)?;
    rules::check_typed(&scene, Typed(Some(table)))?;
    Ok(scene)
}

/// Reads every key of a scene separately, without checking combinations of keys.
///
/// # Errors
/// Unknown keys and invalid values.
pub fn read_keys(table: &Table) -> Result<Scene> {
    let leaves = leaves(table)?;
    let mut scene = Scene {
        gait: table.contains_key("gait").then(Gait::default),
        ..Scene::default()
    };
    for key in KEYS.iter() {
        let mine = leaves.iter().filter(|l| l.pattern == key.path);
        for leaf in mine.filter(|_| key.exists(&scene)).collect::<Vec<_>>() {
            if let Some(value) = read_value(key, leaf.value, &scene, &leaf.path)? {
                key.set(&mut scene, leaf.index, value)
                    .map_err(|e| e.at_key(&leaf.path))?;
            }
        }
        if key.path == "cam.follower" {
            scene.drive.kind = DriveSpec::usual_kind(&scene.cam);
        }
    }
    if !leaves.iter().any(|l| l.pattern == "law.family") {
        scene.law.family = scene.law.usual_family(scene.gait.as_ref());
    }
    unknown(&leaves, &scene)?;
    missing(&leaves, table, &scene)?;
    Ok(scene)
}

/// A value in a scene file, with its key.
struct Leaf<'a> {
    /// Path of the key, with the letter N in place of the number of a list entry.
    pattern: String,
    /// Path of the key as written by users.
    path: String,
    /// Index of the list entry, from 0.
    index: usize,
    value: &'a Toml,
}

fn leaves(table: &Table) -> Result<Vec<Leaf<'_>>> {
    let mut out = Vec::new();
    collect(table, "", "", 0, &mut out)?;
    Ok(out)
}

fn collect<'a>(
    table: &'a Table,
    pattern: &str,
    path: &str,
    index: usize,
    out: &mut Vec<Leaf<'a>>,
) -> Result<()> {
    for (name, value) in table {
        let join = |prefix: &str| match prefix {
            "" => name.clone(),
            prefix => format!("{prefix}.{name}"),
        };
        let (pattern, path) = (join(pattern), join(path));
        let typed = || value.to_string();
        match (node(&pattern), value) {
            (Node::Section, Toml::Table(inner)) => collect(inner, &pattern, &path, index, out)?,
            // A material is a name or a table of constants.
            (Node::Section, value) if KEYS.iter().any(|k| k.path == pattern) => out.push(Leaf {
                pattern,
                path,
                index,
                value,
            }),
            (Node::Section, _) => {
                return Err(SceneError::NotTable {
                    typed: typed(),
                    section: path.clone(),
                }
                .at_key(&path));
            }
            (Node::List, Toml::Array(entries)) if entries.iter().all(Toml::is_table) => {
                for (i, entry) in entries.iter().filter_map(Toml::as_table).enumerate() {
                    let (inner, numbered) = (format!("{pattern}.N"), format!("{path}.{}", i + 1));
                    collect(entry, &inner, &numbered, i, out)?;
                }
            }
            (Node::List, _) => {
                return Err(SceneError::NotList {
                    typed: typed(),
                    list: path.clone(),
                }
                .at_key(&path));
            }
            (Node::Leaf, value) => out.push(Leaf {
                pattern,
                path,
                index,
                value,
            }),
        }
    }
    Ok(())
}

/// Meaning of a path in a scene file: a section, a list or a key.
enum Node {
    Section,
    List,
    Leaf,
}

fn node(pattern: &str) -> Node {
    let below = |k: &Key| k.path.strip_prefix(pattern)?.strip_prefix('.');
    match KEYS.iter().find_map(below) {
        Some(rest) if rest.starts_with("N.") => Node::List,
        Some(_) => Node::Section,
        None => Node::Leaf,
    }
}

/// Rejects unknown keys, and keys that the follower or the drive of the scene does not permit.
fn unknown(leaves: &[Leaf], scene: &Scene) -> Result<()> {
    let row = |leaf: &&Leaf| KEYS.iter().find(|k| k.path == leaf.pattern);
    if let Some(leaf) = leaves.iter().find(|l| row(l).is_none()) {
        return Err(no_such_key(leaf, scene).at_key(&leaf.path));
    }
    let strange = leaves
        .iter()
        .find(|l| row(l).is_some_and(|k| !k.exists(scene)));
    match strange {
        None => Ok(()),
        Some(leaf) => Err(not_here(&leaf.pattern, scene).at_key(&leaf.path)),
    }
}

fn no_such_key(leaf: &Leaf, scene: &Scene) -> SceneError {
    if leaf.pattern.starts_with("law.weigh") {
        return SceneError::WeighRemoved;
    }
    let start = leaf.pattern.rfind('.').map_or(0, |dot| dot + 1);
    let (parent, name) = leaf.pattern.split_at(start);
    let mut known: Vec<&str> = Vec::new();
    for key in KEYS.iter().filter(|k| k.exists(scene)) {
        let rest = key.path.strip_prefix(parent);
        let child = rest.and_then(|r| r.split('.').next());
        known.extend(child.filter(|c| !known.contains(c)));
    }
    let elsewhere = || KEYS.iter().find(|k| k.name() == name && k.exists(scene));
    let nearest = nearest(name, known.iter().copied()).or_else(|| elsewhere().map(|k| k.path));
    SceneError::NoSuchKey {
        nearest: nearest.map(str::to_string),
        known: known.join(", "),
    }
}

fn not_here(path: &str, scene: &Scene) -> SceneError {
    match path {
        "drive.mass" => SceneError::MassOfArm,
        _ if path.starts_with("drive.") => SceneError::NotOfDrive {
            drive: scene.drive.kind.name(),
        },
        _ => SceneError::NotOfFollower {
            follower: scene.cam.follower.name(),
        },
    }
}

/// Rejects a scene in which a required key is missing.
fn missing(leaves: &[Leaf], table: &Table, scene: &Scene) -> Result<()> {
    for key in KEYS.iter().filter(|k| k.is_required(scene)) {
        let example = key.example(scene);
        let entries = key.list().map(|list| entries(table, list));
        let mut given = vec![false; entries.unwrap_or(1)];
        for leaf in leaves.iter().filter(|l| l.pattern == key.path) {
            given[leaf.index] = leaf.value.as_str() != Some("auto");
        }
        if let Some(i) = given.iter().position(|given| !given) {
            let fault = match (entries, key.section()) {
                (Some(_), _) => SceneError::NeededInEntry { example },
                (None, "drive") => SceneError::NeededByDrive {
                    drive: scene.drive.kind.name(),
                    example,
                },
                (None, _) => SceneError::NeededByFollower {
                    follower: scene.cam.follower.name(),
                    example,
                },
            };
            return Err(fault.at_key(&key.path_at(i)));
        }
    }
    Ok(())
}

/// Number of entries in a list of the scene file.
fn entries(table: &Table, list: &str) -> usize {
    let list = Typed(Some(table)).value(list);
    list.and_then(Toml::as_array).map_or(0, Vec::len)
}

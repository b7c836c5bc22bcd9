//! Changes of single values in the table of a scene, by dotted key.

use toml::{Table, Value};

use crate::error::{Placed, Result, SceneError};

/// Changes one value, as in `set(table, "limits.stroke=40 mm")`. The entries of a list are numbered from 1: `law.segment.2.lift`. The value is parsed
/// as TOML if possible; otherwise it is plain text. A recording replaces a load model and vice versa.
///
/// # Errors
///
/// The text contains no `=`, or the path leads through a value or to a missing entry. Unknown keys are rejected later by [`read`](super::read()).
pub fn set(table: &mut Table, assignment: &str) -> Result<()> {
    let (key, value) = assignment
        .split_once('=')
        .filter(|(key, _)| !key.trim().is_empty())
        .ok_or_else(|| SceneError::NoAssignment {
            typed: assignment.to_string(),
        })?;
    let value = value.trim();
    let parsed = format!("x = {value}")
        .parse::<Table>()
        .ok()
        .and_then(|mut t| t.remove("x"));
    let value = parsed.unwrap_or_else(|| Value::String(value.to_string()));
    set_value(table, key.trim(), value)
}

/// Changes one value, which is given as a TOML value.
///
/// # Errors
///
/// The path leads through a value or to a missing entry.
pub fn set_value(table: &mut Table, key: &str, value: Value) -> Result<()> {
    let parts: Vec<&str> = key.split('.').collect();
    let Some((last, path)) = parts.split_last() else {
        return Ok(());
    };
    // A table of constants replaces the name of a material.
    if let ["cam", material @ ("material" | "follower_material")] = path
        && let Some(cam) = table.get_mut("cam").and_then(Value::as_table_mut)
        && cam.get(*material).is_some_and(Value::is_str)
    {
        cam.remove(*material);
    }
    let at = inside(table, path).map_err(|e| e.at_key(key))?;
    let replaced: &[&str] = match key {
        "gait.file" => &["model", "harmonics", "step_frequency", "body_weight"],
        "gait.model" | "gait.harmonics" => &[
            "file",
            "model",
            "harmonics",
            "time",
            "force",
            "unit",
            "rate",
            "mass",
            "leave_out",
        ],
        _ => &[],
    };
    for other in replaced.iter().filter(|other| *other != last) {
        at.remove(*other);
    }
    at.insert((*last).to_string(), value);
    Ok(())
}

/// Removes a key such as `limits.stroke` or `law.segment.2.angle`, and tables that become empty. Returns `false` if the key did not exist.
///
/// ```
/// use gaitcam::scene::unset;
///
/// let mut table = "name = \"a\"\n[limits]\nstroke = \"40 mm\"".parse().unwrap();
/// assert!(unset(&mut table, "limits.stroke") && !unset(&mut table, "limits.stroke"));
/// assert_eq!(table.to_string(), "name = \"a\"\n");
/// ```
pub fn unset(table: &mut Table, key: &str) -> bool {
    let Some((first, rest)) = key.split_once('.') else {
        return table.remove(key).is_some();
    };
    let Some(entry) = table.get_mut(first) else {
        return false;
    };
    let removed = match entry {
        Value::Table(below) => unset(below, rest),
        Value::Array(list) => {
            let (number, inner) = rest.split_once('.').unwrap_or((rest, ""));
            let index = number.parse::<usize>().ok().and_then(|n| n.checked_sub(1));
            let entry = index.and_then(|i| list.get_mut(i));
            let entry = entry.and_then(Value::as_table_mut);
            entry.is_some_and(|entry| unset(entry, inner))
        }
        _ => false,
    };
    if entry.as_table().is_some_and(Table::is_empty) {
        table.remove(first);
    }
    removed
}

/// The table at a path. Missing tables are created.
fn inside<'t>(
    table: &'t mut Table,
    path: &[&str],
) -> std::result::Result<&'t mut Table, SceneError> {
    let [part, rest @ ..] = path else {
        return Ok(table);
    };
    let no_entry = |number: &str, given: usize| SceneError::NoEntry {
        list: (*part).to_string(),
        number: number.to_string(),
        given,
    };
    if let Some(number) = rest.first().filter(|n| n.parse::<usize>().is_ok())
        && !table.contains_key(*part)
    {
        return Err(no_entry(number, 0));
    }
    let entry = table
        .entry((*part).to_string())
        .or_insert_with(|| Value::Table(Table::new()));
    match entry {
        Value::Table(inner) => inside(inner, rest),
        Value::Array(list) => {
            let given = list.len();
            let [number, rest @ ..] = rest else {
                return Err(SceneError::ListWithoutNumber {
                    list: (*part).to_string(),
                    given,
                });
            };
            let index = number.parse::<usize>().ok().and_then(|k| k.checked_sub(1));
            match index.and_then(|i| list.get_mut(i)) {
                Some(Value::Table(inner)) => inside(inner, rest),
                _ => Err(no_entry(number, given)),
            }
        }
        _ => Err(SceneError::ValueNotTable {
            part: (*part).to_string(),
        }),
    }
}

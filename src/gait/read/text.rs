//! Recordings in delimited text: one row per sample.

use std::path::Path;

use super::columns::{Axis, Role, bracketed, foot, role, words};
use super::format::format_name;
use super::layout::{Fields, Layout, Position, detect, plain, text};
use super::number::trim;
use super::table::{Numbers, Table, next_table, numbers, skip};
use super::times::{time_base, time_unit};
use super::{headerless, keys, rows, vertical};
use crate::error::{Error, Result, nearest};
use crate::gait::recording::{Foot, ForceUnit, ReadOptions, Recording};

/// A raw column of force with what its name says.
#[derive(Debug)]
pub(super) struct RawForce {
    pub name: String,
    pub axis: Axis,
    pub foot: Option<Foot>,
    pub unit: Option<ForceUnit>,
    pub values: Vec<f64>,
}

/// Which columns of a table to read, and how.
struct Plan {
    time: Option<usize>,
    /// Whether the time column counts samples instead of seconds.
    counts: bool,
    force: Vec<(usize, Axis, Option<Foot>)>,
}

/// Reads a delimited text; the first table with a force column counts.
pub(super) fn read(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Recording> {
    let bytes = &*plain(bytes);
    let layout = detect(bytes);
    let mut from = Position { offset: 0, line: 1 };
    let mut head: Vec<String> = Vec::new();
    let mut seen: Vec<String> = Vec::new();
    while let Some(table) = next_table(bytes, layout, from) {
        let room = 600usize.saturating_sub(head.len());
        head.extend(table.head.iter().take(room).cloned());
        if rows::is_stance_table(&table.names) {
            return rows::read(path, bytes, layout, &table, &head, options);
        }
        if table.names.is_empty() && options.force.iter().all(|f| f.parse::<usize>().is_ok()) {
            if let Some(raw) = headerless::read(path, bytes, layout, &table, options)? {
                return finish(path, layout, &table, &head, raw, options);
            }
        } else if let Some(plan) = plan(path, &table, options)? {
            let raw = extract(path, bytes, layout, &table, &plan)?;
            return finish(path, layout, &table, &head, raw, options);
        }
        seen.extend(
            table
                .names
                .iter()
                .take(200usize.saturating_sub(seen.len()))
                .cloned(),
        );
        from = skip(bytes, layout, &table);
    }
    Err(nothing_found(path, bytes, layout, &seen))
}

fn nothing_found(path: &Path, bytes: &[u8], layout: Layout, seen: &[String]) -> Error {
    if bytes.trim_ascii().is_empty() {
        return Error::file(path, "the file is empty").help("give a recording of vertical force");
    }
    // A table whose rows start with words has no numbers to go by; its first line may name its columns.
    let first = bytes.split(|&b| b == b'\n').next().unwrap_or(bytes);
    let head = Fields::new(first, layout).take(40).map(|f| text(trim(f)));
    let head: Vec<String> = head.filter(|f| f.len() < 60).collect();
    let names = if seen.is_empty() && head.len() > 1 {
        &head[..]
    } else {
        seen
    };
    if names.is_empty() {
        let start: String = text(&bytes[..bytes.len().min(60)])
            .chars()
            .take(40)
            .collect();
        return Error::file(path, "no table of numbers found")
            .help(format!("the file starts with {start:?}"));
    }
    let shown: Vec<&str> = names.iter().take(40).map(String::as_str).collect();
    let force = names.iter().find(|n| matches!(role(n), Role::Force { .. }));
    if let (true, Some(force)) = (seen.is_empty(), force) {
        return Error::file(
            path,
            format!(
                "the header names a column of force (\"{force}\"), but no row of numbers follows it"
            ),
        )
        .help("export the samples as well; each row should start with a time or a number");
    }
    Error::file(path, "no column of vertical force found").help(format!(
        "the columns are {}; name the force column with --force",
        shown.join(", ")
    ))
}

/// Decides which columns to read; `None` where the table holds no force.
fn plan(path: &Path, table: &Table, options: &ReadOptions) -> Result<Option<Plan>> {
    let roles: Vec<Role> = table.names.iter().map(|n| role(n)).collect();
    let mut force = Vec::new();
    for (i, r) in roles.iter().enumerate() {
        if let Role::Force { axis, foot } = r {
            force.push((i, *axis, *foot));
        }
    }
    if force.is_empty() {
        force = columns_in_newtons(table, &roles);
    }
    if force.is_empty() {
        force = named_by_side(table);
    }
    if !options.force.is_empty() {
        force.clear();
        for name in &options.force {
            let i = column(path, table, name)?;
            force.push((i, Axis::Vertical, foot(&words(&table.names[i]))));
        }
        force.sort_by_key(|f| f.0);
        force.dedup_by_key(|f| f.0);
    }
    if force.is_empty() {
        return Ok(None);
    }
    let place = |wanted: &Role| roles.iter().position(|r| r == wanted);
    let (time, counts) = match &options.time {
        Some(name) => (Some(column(path, table, name)?), false),
        None => match (place(&Role::Time), place(&Role::Frame)) {
            (Some(t), _) => (Some(t), false),
            (None, Some(f)) => (Some(f), true),
            (None, None) => (None, false),
        },
    };
    force.retain(|f| Some(f.0) != time);
    if force.is_empty() {
        return Err(force_is_time(path, table));
    }
    // Sub-frames repeat and frames stand still meanwhile: rows are counted instead.
    let sub = place(&Role::SubFrame).is_some();
    Ok(Some(Plan {
        time: time.filter(|_| !(counts && sub)),
        counts,
        force,
    }))
}

/// The user named one column as both time and force.
pub(super) fn force_is_time(path: &Path, table: &Table) -> Error {
    Error::line(
        path,
        table.start.line,
        "the column named as force is the one of the time",
    )
    .help("name another with --force, or the time column with --time")
}

/// Columns of unknown name whose unit says force.
fn columns_in_newtons(table: &Table, roles: &[Role]) -> Vec<(usize, Axis, Option<Foot>)> {
    let forces =
        (0..table.names.len()).filter(|&i| roles[i] == Role::Other && is_newtons(table, i));
    forces
        .map(|i| {
            let name = table.names[i].clone();
            let side = foot(&words(&name));
            (i, Axis::Vertical, side)
        })
        .collect()
}

/// Two columns called left and right and nothing else: the two insoles or belts.
fn named_by_side(table: &Table) -> Vec<(usize, Axis, Option<Foot>)> {
    let sides = [("left", Foot::Left), ("right", Foot::Right)];
    let places = sides.map(|(word, side)| {
        let place = table.names.iter().position(|n| words(n) == [word]);
        place.map(|i| (i, Axis::Vertical, Some(side)))
    });
    match places {
        [Some(left), Some(right)] => vec![left, right],
        _ => Vec::new(),
    }
}

fn is_newtons(table: &Table, i: usize) -> bool {
    let plain_name = !words(&table.names[i])
        .iter()
        .any(|w| w.starts_with("cop") || w.starts_with("moment"));
    plain_name
        && matches!(
            unit_label(table, i),
            Some(ForceUnit::Newton | ForceUnit::BodyWeight | ForceUnit::PercentBodyWeight)
        )
}

pub(super) fn unit_label(table: &Table, i: usize) -> Option<ForceUnit> {
    let name = table.names.get(i)?;
    let row = table
        .units
        .get(i)
        .map(|u| u.trim_matches(['[', ']', '(', ')']));
    let label = row.filter(|u| !u.is_empty()).or_else(|| bracketed(name));
    match label {
        Some(label) => label.parse().ok(),
        None => {
            let last = words(name).pop()?;
            // `force_n`, `fz_lbf`; a lone `n` or `lb` before that is part of a name.
            let known = ["n", "kn", "lbf", "lb", "bw"].contains(&last.as_str());
            (known && name.contains(['_', ' ']))
                .then(|| last.parse().ok())
                .flatten()
        }
    }
}

/// A column by name (case does not matter) or by number from 1.
pub(super) fn column(path: &Path, table: &Table, wanted: &str) -> Result<usize> {
    let plain = |s: &str| s.trim().to_lowercase();
    let names = &table.names;
    let found = names
        .iter()
        .position(|n| n == wanted)
        .or_else(|| names.iter().position(|n| plain(n) == plain(wanted)));
    let number = wanted
        .parse::<usize>()
        .ok()
        .filter(|n| (1..=names.len()).contains(n));
    found.or(number.map(|n| n - 1)).ok_or_else(|| {
        let error = Error::line(
            path,
            table.start.line.saturating_sub(1).max(1),
            format!("no column \"{wanted}\""),
        );
        let shown: Vec<&str> = names.iter().take(40).map(String::as_str).collect();
        match nearest(wanted, names.iter().take(200).map(String::as_str)) {
            Some(near) => error.help(format!(
                "did you mean \"{near}\"? The columns are {}",
                shown.join(", ")
            )),
            None => error.help(format!("the columns are {}", shown.join(", "))),
        }
    })
}

/// Raw columns with their time.
#[derive(Debug)]
pub(super) struct Raw {
    /// Times as written, where there is a time column.
    pub times: Option<Vec<f64>>,
    /// Scale of the times to seconds, where their column says it.
    pub time_unit: Option<f64>,
    /// Whether times count samples.
    pub counts: bool,
    pub forces: Vec<RawForce>,
    pub samples: usize,
    pub skipped: Vec<usize>,
    /// What a person should know about the choice of columns.
    pub notes: Vec<String>,
}

fn extract(path: &Path, bytes: &[u8], layout: Layout, table: &Table, plan: &Plan) -> Result<Raw> {
    let mut wanted: Vec<usize> = plan.force.iter().map(|f| f.0).chain(plan.time).collect();
    wanted.sort_unstable();
    wanted.dedup();
    let slot = |i: usize| wanted.iter().position(|&w| w == i);
    let time_slot = plan.time.and_then(slot);
    let Numbers {
        mut columns,
        skipped,
    } = numbers(path, bytes, layout, table, &wanted, time_slot)?;
    let samples = columns.first().map_or(0, Vec::len);
    let times = time_slot.map(|t| std::mem::take(&mut columns[t]));
    let mut forces = Vec::new();
    for (i, axis, side) in &plan.force {
        let Some(s) = slot(*i) else { continue };
        forces.push(RawForce {
            name: table.names[*i].trim().to_string(),
            axis: *axis,
            foot: *side,
            unit: unit_label(table, *i),
            values: std::mem::take(&mut columns[s]),
        });
    }
    Ok(Raw {
        times,
        time_unit: plan.time.and_then(|t| time_unit(table, t)),
        counts: plan.counts,
        forces,
        samples,
        skipped,
        notes: Vec::new(),
    })
}

/// Puts raw columns on a time base and makes channels of vertical force of them.
fn finish(
    path: &Path,
    layout: Layout,
    table: &Table,
    head: &[String],
    raw: Raw,
    options: &ReadOptions,
) -> Result<Recording> {
    let keys = keys::read(head, layout.comma);
    let mut notes = raw.notes.clone();
    if let Some(rows) = keys.rows.filter(|r| *r != raw.samples) {
        notes.push(format!(
            "the header announces {rows} rows, the file has {}",
            raw.samples
        ));
    }
    if let Some(line) = raw.skipped.first() {
        notes.push(format!(
            "lines that are not rows of numbers were passed over, first line {line}"
        ));
    }
    if raw.samples < 2 {
        return Err(Error::line(
            path,
            table.start.line,
            format!("{} sample is not a recording", raw.samples),
        )
        .help("give at least one whole stance"));
    }
    let place = |e: Error| e.at(crate::error::Place::File(path.to_path_buf()));
    let base = time_base(&raw, options, keys.rate_hz, &mut notes).map_err(place)?;
    let mass = options.mass_kg.or(keys.mass_kg);
    let mut recording =
        vertical::recording(raw.forces, base, raw.samples, mass, options, None, notes)
            .map_err(place)?;
    recording.mass_from = match (options.mass_kg, keys.mass_kg) {
        (Some(_), _) => "user".to_string(),
        (None, Some(_)) => "file".to_string(),
        (None, None) => String::new(),
    };
    recording.format = format_name(path, layout, table, head);
    Ok(recording)
}

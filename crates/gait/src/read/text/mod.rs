//! Recordings in delimited text: one row per sample.

mod choose;
mod clock_time;
mod converter;
mod format;
mod header;
mod headerless;
mod layout;
mod plain_row;
mod plate_file;
mod raw;
mod stance_table;
mod table;
mod times;

use std::path::Path;

use choose::{Plan, plan};
use format::format;
use raw::Raw;
use table::skip;
use times::time_base;

use super::columns::{Role, foot, role, words};
use super::keys::{self, Keys};
use super::number::trim;
use super::vertical::{self, Facts};
use crate::error::{Error, Placed, ReadError, Result};
use crate::recording::{ForceUnit, Format, Note, ReadOptions, Recording};

pub(super) use choose::{check_unit, column, unit_label};
pub(super) use header::Table;
use layout::Separator;
pub(super) use layout::{Fields, Layout, Lines, Position, TextFile, detect, plain, text};
pub use plate_file::{PlateFile, joined_plates, parts, plate_of};
pub use stance_table::metadata_name;
pub(super) use table::{next_table, numbers};
pub(super) use times::time_unit;

/// Reads a delimited text; the first table with a force column counts.
pub(super) fn read(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Recording> {
    let bytes = &*plain(bytes);
    let file = &TextFile::new(path, bytes, options);
    if let Some((table, rate)) = converter::table(bytes) {
        return converter_counts(file, &table, rate);
    }
    let mut from = Position::START;
    let mut head: Vec<String> = Vec::new();
    let mut seen: Vec<String> = Vec::new();
    while let Some(table) = next_table(bytes, file.layout, from) {
        let room = 600usize.saturating_sub(head.len());
        head.extend(table.head.iter().take(room).cloned());
        if let Some(fault) = commas_twice(file, &table) {
            return Err(fault.at_line(path, table.start.line));
        }
        if stance_table::is_stance_table(&table.names) {
            return stance_table::read(file, &table, &head);
        }
        if table.names.is_empty() && options.force.iter().all(|f| f.parse::<usize>().is_ok()) {
            if let Some(raw) = headerless::read(file, &table)? {
                return with_head(file, &table, &head, raw);
            }
        } else if let Some(plan) = plan(file, &table)? {
            return with_head(file, &table, &head, extract(file, &table, plan)?);
        }
        let room = 200usize.saturating_sub(seen.len());
        seen.extend(table.names.iter().take(room).cloned());
        from = skip(file, &table);
    }
    Err(nothing_found(file, &seen))
}

/// Twice as many fields as names, and no decimal point: commas that part the decimals as well as the columns.
fn commas_twice(file: &TextFile, table: &Table) -> Option<ReadError> {
    let (columns, fields) = (table.names.len(), table.width);
    let (_, row) = Lines::from(file.bytes, table.start).next()?;
    let commas = file.layout.separator == Separator::Byte(b',') && !file.layout.comma;
    let twice = commas && columns > 1 && fields == 2 * columns && !row.contains(&b'.');
    twice.then_some(ReadError::CommasTwice { columns, fields })
}

/// Reads the plates of a file of converter counts.
fn converter_counts(file: &TextFile, table: &Table, rate_hz: Option<f64>) -> Result<Recording> {
    let Some(plan) = converter::plates(file, table)? else {
        return Err(nothing_found(file, &table.names));
    };
    let mut raw = extract(file, table, plan)?;
    raw.notes.extend(converter::scale(file, &mut raw.forces)?);
    for force in &mut raw.forces {
        force.unit = Some(ForceUnit::Newton);
    }
    let keys = Keys {
        rate_hz,
        ..Keys::default()
    };
    finish(file, table, raw, keys, Format::ConverterCounts)
}

fn nothing_found(file: &TextFile, seen: &[String]) -> Error {
    let (path, bytes) = (file.path, file.bytes);
    // A table whose rows start with words has no numbers to go by; its first line may name its columns.
    let first = bytes.split(|&b| b == b'\n').next().unwrap_or(bytes);
    let head = Fields::new(first, file.layout)
        .take(40)
        .map(|f| text(trim(f)));
    let head: Vec<String> = head.filter(|f| f.len() < 60).collect();
    let names = if seen.is_empty() && head.len() > 1 {
        &head[..]
    } else {
        seen
    };
    if names.is_empty() {
        return no_table(bytes).in_file(path);
    }
    let force = names.iter().find(|n| matches!(role(n), Role::Force { .. }));
    if let (true, Some(column)) = (seen.is_empty(), force.cloned()) {
        return ReadError::HeaderWithoutRows { column }.in_file(path);
    }
    let columns = listed(names);
    ReadError::NoForceColumn { columns }.in_file(path)
}

/// A text without a table of numbers.
pub(super) fn no_table(bytes: &[u8]) -> ReadError {
    if bytes.trim_ascii().is_empty() {
        return ReadError::Empty;
    }
    let start = text(&bytes[..bytes.len().min(60)]);
    let start = start.lines().next().unwrap_or_default();
    let start = start.chars().take(40).collect();
    ReadError::NoTable { start }
}

/// The first names of columns, for a message.
fn listed(names: &[String]) -> Vec<String> {
    names.iter().take(40).cloned().collect()
}

fn extract(file: &TextFile, table: &Table, plan: Plan) -> Result<Raw> {
    let mut wanted: Vec<usize> = plan.force.iter().map(|f| f.0).chain(plan.time).collect();
    wanted.sort_unstable();
    wanted.dedup();
    let place = |i: usize| wanted.binary_search(&i).unwrap_or(0);
    let read = numbers(file, table, &wanted, plan.time.map(place))?;
    Ok(Raw::of(table, plan, read, place))
}

fn with_head(file: &TextFile, table: &Table, head: &[String], mut raw: Raw) -> Result<Recording> {
    let keys = keys::read(head, file.layout.comma);
    let format = format(file, table, head);
    let plate = plate_file::of_head(head);
    for force in &mut raw.forces {
        if format == Format::Qualisys {
            // Its exports of force are in newtons and do not say so.
            force.unit = force.unit.or(Some(ForceUnit::Newton));
        }
        if let Some(file) = &plate {
            force.foot = force.foot.or(foot(&words(&file.plate)));
            force.name = format!("{} {}", file.plate, force.name);
        }
    }
    finish(file, table, raw, keys, format)
}

/// Puts raw columns on a time base and makes channels of vertical force of them.
fn finish(
    file: &TextFile,
    table: &Table,
    raw: Raw,
    keys: Keys,
    format: Format,
) -> Result<Recording> {
    let (path, options) = (file.path, file.options);
    let samples = raw.samples;
    if samples < 2 {
        return Err(ReadError::FewSamples { samples }.at_line(path, table.start.line));
    }
    let mut notes = raw.notes.clone();
    if let Some(announced) = keys.rows.filter(|r| *r != samples) {
        notes.push(Note::RowsDiffer {
            announced,
            found: samples,
        });
    }
    if let Some(&first_line) = raw.skipped.first() {
        notes.push(Note::LinesSkipped { first_line });
    }
    let place = |e: Error| e.in_file(path);
    let base = time_base(&raw, options, keys.rate_hz, &mut notes).map_err(place)?;
    let facts = Facts {
        format,
        samples,
        mass_kg: keys.mass_kg,
        zero: None,
        notes,
    };
    vertical::recording(raw.forces, base, facts, options).map_err(place)
}

//! Recordings in delimited text, usually one row per sample.

mod by_numbers;
mod choose;
mod clock_time;
mod delimited;
mod header;
mod layouts;
mod long_table;
mod number_table;
mod plain_row;
mod samples;
mod table;
mod units;
mod vectors;

use std::path::Path;

use choose::listed;
use delimited::Fields;
use layouts::layout;
use table::skip;

use super::columns::{Role, role};
use super::number::trim;
use crate::error::{Error, Placed, ReadError, Result};
use crate::recording::{ReadOptions, Recording};

pub(super) use choose::{Columns, ForceColumn, choose, columns_by_numbers};
pub(super) use delimited::{Delimiters, Lines, Position, Separator, TextFile, plain, text};
pub(super) use header::Table;
pub use layouts::{PlateFile, joined_plates, metadata_name, parts, plate_of};
pub(super) use long_table::LongTable;
pub use number_table::{Cell, NumberTable};
pub(super) use samples::Samples;
pub(super) use table::next_table;
pub(super) use units::check_unit;

/// Reads a delimited text. The first table with a force column is the recording.
pub(super) fn read(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Recording> {
    let bytes = &*plain(bytes);
    if let Some(long) = LongTable::of(path, bytes, options) {
        return Err(long.refusal());
    }
    let file = &TextFile::new(path, bytes, options);
    let mut from = Position::START;
    let mut head: Vec<String> = Vec::new();
    let mut seen: Vec<String> = Vec::new();
    while let Some(mut table) = next_table(file.bytes, file.delimiters, from) {
        let room = 600usize.saturating_sub(head.len());
        head.extend(table.head.iter().take(room).cloned());
        if let Some(fault) = commas_twice(file, &table) {
            return Err(fault.at_line(path, table.start.line));
        }
        let layout = layout(file, &table, &head);
        if let Some(own) = layout.own_table(file) {
            head.clone_from(&own.head);
            table = own;
        }
        if let Some(recording) = layout.read(file, &table, &head)? {
            return Ok(recording);
        }
        let room = 200usize.saturating_sub(seen.len());
        seen.extend(table.names.iter().take(room).cloned());
        from = skip(file, &table);
    }
    Err(no_force(file, &seen))
}

/// Error if a table has twice as many fields as names and no decimal point, because commas then separate both decimals and columns.
fn commas_twice(file: &TextFile, table: &Table) -> Option<ReadError> {
    let (columns, fields) = (table.names.len(), table.width);
    let (_, row) = Lines::from(file.bytes, table.start).next()?;
    let commas = file.delimiters.separator == Separator::Byte(b',') && !file.delimiters.comma;
    let twice = commas && columns > 1 && fields == 2 * columns && !row.contains(&b'.');
    twice.then_some(ReadError::CommasTwice { columns, fields })
}

/// Error for a text without a force column. `seen` contains the column names of its tables.
pub(super) fn no_force(file: &TextFile, seen: &[String]) -> Error {
    let (path, bytes) = (file.path, file.bytes);
    // If the rows of a table start with words, its columns cannot be determined from numbers. The first line may contain their names.
    let first = bytes.split(|&b| b == b'\n').next().unwrap_or(bytes);
    let head = Fields::new(first, file.delimiters)
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

/// Error for a text without a table of numbers.
fn no_table(bytes: &[u8]) -> ReadError {
    if bytes.trim_ascii().is_empty() {
        return ReadError::Empty;
    }
    let start = text(&bytes[..bytes.len().min(60)]);
    let start = start.lines().next().unwrap_or_default();
    let start = start.chars().take(40).collect();
    ReadError::NoTable { start }
}

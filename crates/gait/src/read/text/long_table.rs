//! Long tables of standardised gait sets: a cycle for every subject, task and step, its rows told apart by their phase.

use std::collections::BTreeSet;
use std::path::Path;

use super::delimited::{Delimiters, Fields, Lines, Separator, text};
use crate::error::{Placed, ReadError, Result};
use crate::read::columns::{Role, role, words};
use crate::read::number::trim;

/// Words of columns that tell the cycles of a table apart.
const IDENTIFIERS: [&str; 7] = [
    "subject", "task", "step", "session", "trial", "cycle", "stride",
];

/// Refuses a long table: it has no clock, and most hold many cycles.
///
/// # Errors
/// [`ReadError::LongTable`] with its number of cycles.
pub(in crate::read) fn refuse(path: &Path, bytes: &[u8]) -> Result<()> {
    let mut lines = Lines::new(bytes);
    let Some((at, header)) = lines.find(|(_, line)| !line.trim_ascii().is_empty()) else {
        return Ok(());
    };
    // The rows are half words, so that the header tells the separator.
    let parts = |byte: u8| header.iter().filter(|b| **b == byte).count();
    let separator = [b',', b';', b'\t']
        .into_iter()
        .max_by_key(|byte| parts(*byte));
    let delimiters = Delimiters {
        separator: Separator::Byte(separator.unwrap_or(b',')),
        comma: false,
    };
    let names: Vec<String> = Fields::new(header, delimiters)
        .map(|f| text(trim(f)))
        .collect();
    let named = |part: &str| names.iter().any(|n| words(n).iter().any(|w| w == part));
    let roles: Vec<Role> = names.iter().map(|n| role(n)).collect();
    let has = |is: fn(&Role) -> bool| roles.iter().any(is);
    let timed = has(|r| *r == Role::Time);
    let forced = has(|r| matches!(r, Role::Force { .. }));
    if timed || !forced || !named("subject") || !named("phase") {
        return Ok(());
    }
    let is_identifier = |name: &String| {
        let words = words(name);
        let all = words
            .iter()
            .all(|w| IDENTIFIERS.contains(&w.as_str()) || w == "id");
        all && words.first().is_some_and(|w| w != "id")
    };
    let places: Vec<bool> = names.iter().map(is_identifier).collect();
    let identity = |line| -> Vec<u8> {
        let fields = Fields::new(line, delimiters).zip(&places);
        let chosen = fields.filter(|(_, is)| **is).map(|(f, _)| trim(f));
        chosen.collect::<Vec<_>>().join(&b'\n')
    };
    let rows = lines.filter(|(_, line)| !line.trim_ascii().is_empty());
    let cycles: BTreeSet<Vec<u8>> = rows.map(|(_, line)| identity(line)).collect();
    let cycles = cycles.len();
    Err(ReadError::LongTable { cycles }.at_line(path, at.line))
}

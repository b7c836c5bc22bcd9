//! Tables of numbers under a header, strict: every row is kept with its line, nothing is skipped but blank lines and
//! comments.

use std::borrow::Cow;
use std::path::Path;

use super::columns::bracketed;
use super::foreign;
use super::number::{trim, value};
use super::text::{
    Fields, Layout, Lines, Position, Table, detect, next_table, no_table, plain, text,
};
use crate::error::{Placed, ReadError, Result};

/// A table of a delimited text, its rows not yet read.
///
/// ```
/// use gaitcam_gait::NumberTable;
///
/// let table = NumberTable::find("lift.csv".as_ref(), b"angle_deg;lift_mm\n0;0\n90;2,5\n")?;
/// assert_eq!(table.name_and_unit(1), ("lift".to_string(), Some("mm".to_string())));
/// let lifts: Vec<Option<f64>> = table.rows().map(|(_, cells)| cells[1].number).collect();
/// assert_eq!(lifts, [Some(0.0), Some(2.5)]);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
pub struct NumberTable<'a> {
    bytes: Cow<'a, [u8]>,
    layout: Layout,
    table: Table,
}

/// One field of a row.
///
/// ```
/// use gaitcam_gait::NumberTable;
///
/// let table = NumberTable::find("a.csv".as_ref(), b"time_s,force_n\n0,700\n1,701\n2,?\n")?;
/// let (line, cells) = table.rows().nth(2).unwrap();
/// assert_eq!((line, cells[1].number, cells[1].text.as_str()), (4, None, "?"));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
pub struct Cell {
    /// Its finite number; `None` for anything else.
    pub number: Option<f64>,
    /// As it is written.
    pub text: String,
}

impl<'a> NumberTable<'a> {
    /// The first table of a text; `path` serves messages only.
    ///
    /// # Errors
    /// Files that are no text or hold no table of numbers.
    pub fn find(path: &Path, bytes: &'a [u8]) -> Result<NumberTable<'a>> {
        if let Some(kind) = foreign(bytes) {
            return Err(ReadError::Foreign { kind }.in_file(path));
        }
        let bytes = plain(bytes);
        let layout = detect(&bytes);
        let Some(table) = next_table(&bytes, layout, Position::START) else {
            return Err(no_table(&bytes).in_file(path));
        };
        Ok(NumberTable {
            bytes,
            layout,
            table,
        })
    }

    /// Names of the columns; none without a header.
    pub fn names(&self) -> &[String] {
        &self.table.names
    }

    /// Line of the header, from 1; the first row's where there is none.
    pub fn header_line(&self) -> usize {
        match self.table.names.is_empty() {
            true => self.table.start.line,
            false => self.table.header_line(),
        }
    }

    /// Name and unit of a column: `lift_mm`, `lift [mm]` and `lift (mm)` alike, or the unit of a row of units.
    pub fn name_and_unit(&self, column: usize) -> (String, Option<String>) {
        let whole = self.table.names[column].trim();
        if let Some(unit) = self.table.unit(column) {
            return (whole.to_lowercase(), Some(unit.to_string()));
        }
        let (name, unit) = match (bracketed(whole).last(), whole.find(['[', '('])) {
            (Some(unit), Some(open)) => (&whole[..open], Some(unit)),
            _ => match whole.split_once(['_', ' ']) {
                Some((name, unit)) => (name, Some(unit)),
                None => (whole, None),
            },
        };
        let name = name.trim().trim_end_matches('_').to_lowercase();
        (name, unit.map(str::to_string).filter(|u| !u.is_empty()))
    }

    /// The rows with their lines, to the end of the text.
    pub fn rows(&self) -> impl Iterator<Item = (usize, Vec<Cell>)> + '_ {
        let lines = Lines::from(&self.bytes, self.table.start);
        let is_row = |line: &[u8]| {
            let line = line.trim_ascii();
            !line.is_empty() && !line.starts_with(b"#")
        };
        lines
            .filter(move |(_, line)| is_row(line))
            .map(|(at, line)| (at.line, self.cells(line)))
    }

    fn cells(&self, line: &[u8]) -> Vec<Cell> {
        let cell = |f: &[u8]| Cell {
            number: Some(value(f, self.layout.comma)).filter(|x| x.is_finite()),
            text: text(trim(f)),
        };
        Fields::new(line, self.layout).map(cell).collect()
    }
}

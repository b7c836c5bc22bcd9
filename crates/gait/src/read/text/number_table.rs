//! Tables of numbers for the readers of other files, such as machine records and lift tables. Every row is returned with its line number.
//! Only blank lines and comments are skipped.

use std::borrow::Cow;
use std::path::Path;

use super::choose::column;
use super::delimited::{Delimiters, Fields, Lines, Position, detect, plain, text};
use super::header::Table;
use super::no_table;
use super::table::next_table;
use crate::error::{Placed, ReadError, Result};
use crate::read::columns::{Role, role, words};
use crate::read::foreign;
use crate::read::number::{trim, value};

/// Header and position of a table in a delimited text. The rows are read by `rows`.
///
/// ```
/// use gaitcam_gait::NumberTable;
///
/// let table = NumberTable::find("lift.csv".as_ref(), b"angle_deg;lift_mm\n0;0\n90;2,5\n")?;
/// assert_eq!(table.name_and_unit(1), ("lift".to_string(), Some("mm".to_string())));
/// assert_eq!(table.place("lift.csv".as_ref(), "2")?, 1);
/// let lifts: Vec<Option<f64>> = table.rows().map(|(_, cells)| cells[1].number).collect();
/// assert_eq!(lifts, [Some(0.0), Some(2.5)]);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
pub struct NumberTable<'a> {
    bytes: Cow<'a, [u8]>,
    delimiters: Delimiters,
    table: Table,
}

/// Field of a row in a table.
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
    /// Finite number in the field; `None` if the field contains anything else.
    pub number: Option<f64>,
    /// Text of the field, as written.
    pub text: String,
}

impl<'a> NumberTable<'a> {
    /// The first table of a text. `path` is used only in messages.
    ///
    /// # Errors
    ///
    /// The file is not text or contains no table of numbers.
    pub fn find(path: &Path, bytes: &'a [u8]) -> Result<NumberTable<'a>> {
        if let Some(kind) = foreign(bytes) {
            return Err(ReadError::Foreign { kind }.in_file(path));
        }
        let bytes = plain(bytes);
        let delimiters = detect(&bytes);
        let table = next_table(&bytes, delimiters, Position::START);
        Ok(NumberTable {
            table: table.ok_or_else(|| no_table(&bytes).in_file(path))?,
            bytes,
            delimiters,
        })
    }

    /// Names of the columns; empty without a header.
    pub fn names(&self) -> &[String] {
        &self.table.names
    }

    /// Number of the header line, counted from 1. Without a header, it is the line number of the first row.
    pub fn header_line(&self) -> usize {
        match self.table.names.is_empty() {
            true => self.table.start.line,
            false => self.table.header_line(),
        }
    }

    /// Index of the column with a given name, regardless of upper and lower case, or with a given number, counted from 1.
    ///
    /// # Errors
    ///
    /// There is no such column. The message lists the columns of the table.
    pub fn place(&self, path: &Path, stated: &str) -> Result<usize> {
        column(path, &self.table, stated)
    }

    /// Whether the name of a column denotes a time, in one of several languages.
    pub fn means_time(&self, column: usize) -> bool {
        let name = self.table.names.get(column);
        name.is_some_and(|n| role(n) == Role::Time)
    }

    /// Whether the name of a column denotes a force, in one of several languages.
    pub fn means_force(&self, column: usize) -> bool {
        let name = self.table.names.get(column);
        name.is_some_and(|n| matches!(role(n), Role::Force { .. }))
    }

    /// Words in the name of a column, in lower case and without a unit in brackets, for example `cam` and `angle` for `CamAngle [deg]`.
    pub fn words(&self, column: usize) -> Vec<String> {
        let name = self.table.names.get(column);
        name.map_or_else(Vec::new, |n| words(n))
    }

    /// Name and unit of a column. They are the same for `lift_mm`, `lift [mm]` and `lift (mm)`. The unit may also be in a row of units.
    pub fn name_and_unit(&self, column: usize) -> (String, Option<String>) {
        self.table.name_and_unit(column)
    }

    /// Rows with their line numbers, up to the end of the text.
    pub fn rows(&self) -> impl Iterator<Item = (usize, Vec<Cell>)> + '_ {
        let lines = Lines::from(&self.bytes, self.table.start);
        let is_row =
            |line: &[u8]| !line.trim_ascii().is_empty() && !line.trim_ascii().starts_with(b"#");
        let cell = |f: &[u8]| Cell {
            number: Some(value(f, self.delimiters.comma)).filter(|x| x.is_finite()),
            text: text(trim(f)),
        };
        lines
            .filter(move |(_, line)| is_row(line))
            .map(move |(at, line)| {
                (
                    at.line,
                    Fields::new(line, self.delimiters).map(cell).collect(),
                )
            })
    }
}

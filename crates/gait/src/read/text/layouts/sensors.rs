//! Tables of single sensors, such as pedar files of insole pressures: columns `1 2 3 …` after a time.

use crate::error::{Placed, ReadError, Result};
use crate::read::columns::{Role, role};
use crate::read::text::delimited::TextFile;
use crate::read::text::header::Table;
use crate::recording::Recording;

/// Minimum number of numbered sensor columns; two or four may be plates.
const FEWEST: usize = 6;

/// Whether the columns are sensors: their names are numbers after a time or a frame, and no column denotes a force.
///
/// A force column named by the user is read, unless the lines above (lower case) state that the values are pressures.
pub(super) fn are_in(file: &TextFile, names: &[String], head: &[String]) -> bool {
    let roles: Vec<Role> = names.iter().map(|n| role(n)).collect();
    let has = |is: fn(&Role) -> bool| roles.iter().any(is);
    let timed = has(|r| matches!(r, Role::Time | Role::Frame));
    let forced = has(|r| matches!(r, Role::Force { .. }));
    let says_pressure = |line: &String| ["pressure", "kpa"].iter().any(|w| line.contains(w));
    let options = file.options;
    let chosen =
        !options.force.is_empty() && (options.unit.is_some() || !head.iter().any(says_pressure));
    timed && !forced && !chosen && count(names) >= FEWEST
}

fn count(names: &[String]) -> usize {
    names.iter().filter(|n| n.parse::<u32>().is_ok()).count()
}

/// Rejects the table, because no force follows from the readings without the area of each sensor.
pub(super) fn read(file: &TextFile, table: &Table, _: &[String]) -> Result<Recording> {
    let sensors = count(&table.names);
    Err(ReadError::SingleSensors { sensors }.at_line(file.path, table.header_line()))
}

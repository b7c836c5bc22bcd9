//! Tables with the readings of single sensors, such as pedar files of insole pressures. The columns after the time are named `1 2 3 …`.

use crate::error::{Placed, ReadError, Result};
use crate::read::columns::{Role, role};
use crate::read::text::delimited::TextFile;
use crate::read::text::header::Table;
use crate::recording::Recording;

/// Minimum number of numbered columns that count as sensors. Two or four columns may be plates.
const FEWEST: usize = 6;

/// Whether the columns are sensors. There must be a column of times or frames and at least `FEWEST` columns whose names are numbers. No
/// name may denote a force.
///
/// The result is `false` if the user named a force column, unless no unit is given and a line above the table mentions a pressure. `head`
/// contains these lines in lower case.
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

/// Rejects the table, because a force cannot be computed from the readings without the area of each sensor.
pub(super) fn read(file: &TextFile, table: &Table, _: &[String]) -> Result<Recording> {
    let sensors = count(&table.names);
    Err(ReadError::SingleSensors { sensors }.at_line(file.path, table.header_line()))
}

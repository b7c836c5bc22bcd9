//! Selection of the time and force columns of a table. The options of the user have priority, then the names of the columns, then the
//! numbers in them.

use std::path::Path;

use super::by_numbers;
use super::delimited::TextFile;
use super::header::Table;
use super::table::{Numbers, numbers};
use super::units::check_unit;
use crate::error::{Placed, ReadError, Result, nearest};
use crate::read::columns::{Role, foot, role, says_vertical, words};
use crate::read::vocabulary::{INSOLE, is};
use crate::recording::{Axis, Foot, ForceUnit, Note};

/// Maximum number of force columns that are read: several hundred plates with three components. Each column becomes one channel.
const MOST_FORCES: usize = 1000;

/// Minimum number of rows of a recording without column names.
const FEWEST: usize = 10;

/// Maximum number of columns that are read from a table without names. Force recordings have fewer columns.
const WIDEST: usize = 400;

/// Selected columns of a table, and their interpretation.
#[derive(Default)]
pub(in crate::read) struct Columns {
    pub time: Option<usize>,
    /// Whether the time column contains sample numbers or phases instead of seconds.
    pub counts: bool,
    /// Whether the time column contains the phase of a stance (`true`) or of a cycle (`false`); `None` if it contains no phase.
    pub phase_of_stance: Option<bool>,
    pub force: Vec<ForceColumn>,
    /// Whether the forces are those of pressure insoles, if known.
    pub insole: Option<bool>,
    /// Assumptions made in the selection.
    pub notes: Vec<Note>,
    /// All columns of a table without names, if they were read for the selection.
    pub read: Option<Numbers>,
}

/// A force column, with the component and foot that its name denotes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::read) struct ForceColumn {
    pub place: usize,
    pub axis: Axis,
    pub foot: Option<Foot>,
}

/// Selects the columns to read; `None` if no column is a force.
pub(in crate::read) fn choose(file: &TextFile, table: &Table) -> Result<Option<Columns>> {
    let options = file.options;
    let time = (options.time.as_ref()).map(|name| column(file.path, table, name));
    let time = time.transpose()?;
    let mut columns = if table.names.is_empty() {
        nameless(file, table, time)?
    } else {
        by_names(table, time)
    };
    if !options.force.is_empty() {
        columns.force = stated(file, table)?;
        columns.notes.clear();
    }
    let force = &mut columns.force;
    if force.is_empty() {
        return Ok(None);
    }
    if options.force.is_empty() && force.len() > MOST_FORCES {
        let found = force.len();
        return Err(ReadError::ManyForces { found }.at_line(file.path, table.header_line()));
    }
    leave_zones(table, force);
    // A column of a plate has a component and no foot. A column of an insole has a foot and contains the total force.
    let is_plate = |f: &ForceColumn| f.axis != Axis::Vertical && f.foot.is_none();
    let has_plate = force.iter().any(is_plate);
    let of_insole = |f: &ForceColumn| {
        let name = table.names.get(f.place);
        let is_total = has_plate && f.axis == Axis::Vertical && f.foot.is_some();
        name.is_some_and(|n| is_insole(table, n) || is_total && says_vertical(n))
    };
    if options.force.is_empty() {
        let (mut insole, plate): (Vec<_>, Vec<_>) = force.iter().partition(|f| of_insole(f));
        let unnamed = (0..table.names.len()).filter(|i| force.iter().all(|f| f.place != *i));
        let unnamed = unnamed.filter(|&i| is_newtons(table, i));
        insole.extend(unnamed.map(|i| vertical(table, i)).filter(of_insole));
        if !insole.is_empty() && !plate.is_empty() {
            let name = |f: &ForceColumn| table.names[f.place].trim().to_string();
            columns.notes.push(Note::InsoleBesidePlate {
                plate: plate.iter().map(name).collect(),
                insole: insole.iter().map(name).collect(),
            });
            *force = plate;
        }
    }
    if table.names.iter().any(|n| is_insole(table, n)) {
        columns.insole = Some(force.iter().all(of_insole));
    }
    if options.unit.is_none() {
        leave_foreign_units(file, table, force)?;
    }
    force.retain(|f| Some(f.place) != columns.time);
    if force.is_empty() {
        return Err(ReadError::ForceIsTime.at_line(file.path, table.start.line));
    }
    Ok(Some(columns))
}

/// Force columns named by the user.
fn stated(file: &TextFile, table: &Table) -> Result<Vec<ForceColumn>> {
    let places = file.options.force.iter();
    let places = places.map(|name| column(file.path, table, name));
    let mut places: Vec<usize> = places.collect::<Result<_>>()?;
    places.sort_unstable();
    places.dedup();
    Ok(places.into_iter().map(|i| vertical(table, i)).collect())
}

/// Time and force columns, according to the names of the columns.
fn by_names(table: &Table, stated: Option<usize>) -> Columns {
    let roles: Vec<Role> = table.names.iter().map(|n| role(n)).collect();
    let place = |role: &Role| roles.iter().position(|r| r == role);
    let is_phase = |r: &Role| matches!(r, Role::Phase { .. });
    let clock = stated.or(place(&Role::Time));
    let phase = roles.iter().position(is_phase);
    let time = clock.or(phase).or(place(&Role::Frame));
    let role = time.map(|t| &roles[t]);
    Columns {
        time,
        counts: clock.is_none() || role.is_some_and(is_phase),
        phase_of_stance: match role {
            Some(Role::Phase { of_stance }) => Some(*of_stance),
            _ => None,
        },
        force: recognised(table, &roles),
        ..Columns::default()
    }
}

/// Time and force columns of a table without names, according to its numbers. There is no force if the table is too short for a recording.
/// `stated` is the index of the time column that the user named.
fn nameless(file: &TextFile, table: &Table, stated: Option<usize>) -> Result<Columns> {
    let all: Vec<usize> = (0..table.width.min(WIDEST)).collect();
    let read = numbers(file, table, &all, None)?;
    let columns = &read.columns;
    let time = stated.or_else(|| by_numbers::time_column(columns));
    let mut chosen = Columns {
        time,
        counts: time.is_some_and(|t| by_numbers::counts_samples(&columns[t])),
        ..Columns::default()
    };
    let is_short = columns.first().map_or(0, Vec::len) < FEWEST;
    if is_short || !file.options.force.is_empty() {
        chosen.read = Some(read);
        return Ok(chosen);
    }
    let mut chosen = columns_by_numbers(columns, time)
        .ok_or_else(|| no_force_among(table).at_line(file.path, table.start.line))?;
    chosen.read = Some(read);
    Ok(chosen)
}

/// Error for a table in which no column resembles a force.
fn no_force_among(table: &Table) -> ReadError {
    let columns = listed(&table.names);
    match columns.is_empty() {
        true => ReadError::NamelessColumns,
        false => ReadError::NoForceColumn { columns },
    }
}

/// Time and force columns of a table without names, according to its numbers; `None` if no column is a force. `stated` is the index of the
/// time column, if known.
pub(in crate::read) fn columns_by_numbers(
    columns: &[Vec<f64>],
    stated: Option<usize>,
) -> Option<Columns> {
    let time = stated.or_else(|| by_numbers::time_column(columns));
    let force = by_numbers::force_columns(columns, time);
    let [first, ..] = force[..] else {
        return None;
    };
    let sides = by_numbers::insole_sides(&force, columns.len(), time);
    let note = sides
        .zip(force.get(1))
        .map(|(_, second)| Note::InsoleColumns {
            left: first + 1,
            right: second + 1,
        });
    let column = |(k, place): (usize, usize)| ForceColumn {
        place,
        axis: Axis::Vertical,
        foot: sides.map(|s| s[k]),
    };
    Some(Columns {
        time,
        counts: time.is_some_and(|t| by_numbers::counts_samples(&columns[t])),
        insole: sides.map(|_| true),
        notes: note.into_iter().collect(),
        force: force.into_iter().enumerate().map(column).collect(),
        ..Columns::default()
    })
}

/// Columns whose names denote a force. If there are none, columns with a unit of force are used, and then two columns with the names left
/// and right.
fn recognised(table: &Table, roles: &[Role]) -> Vec<ForceColumn> {
    let named = roles.iter().enumerate().filter_map(|(place, r)| match *r {
        Role::Force { axis, foot } => Some(ForceColumn { place, axis, foot }),
        _ => None,
    });
    let mut force: Vec<ForceColumn> = named.collect();
    if force.is_empty() {
        force = columns_in_newtons(table, roles);
    }
    if force.is_empty() {
        force = named_by_side(table);
    }
    force
}

fn vertical(table: &Table, place: usize) -> ForceColumn {
    let axis = Axis::Vertical;
    let foot = (table.names.get(place)).and_then(|name| foot(&words(name)));
    ForceColumn { place, axis, foot }
}

/// Excludes the zones of an insole if their total is also a column: `L::heel, L::toes, L`, possibly below a header row `Force[N]`.
fn leave_zones(table: &Table, force: &mut Vec<ForceColumn>) {
    let name = |f: &ForceColumn| table.names.get(f.place).map_or("", |n| n.trim());
    let (zones, totals): (Vec<ForceColumn>, Vec<ForceColumn>) =
        force.iter().partition(|f| name(f).contains("::"));
    let has_total = |zone: &ForceColumn| {
        let owner = name(zone).split("::").next().unwrap_or_default();
        totals.iter().any(|total| name(total).starts_with(owner))
    };
    if zones.iter().all(has_total) {
        force.retain(|f| !name(f).contains("::"));
    }
}

/// Whether a column belongs to a pressure insole, because of its name or because zones of the insole are also columns.
fn is_insole(table: &Table, name: &str) -> bool {
    let is_zone = |zone: &String| {
        let owner = zone.split_once("::").map(|(owner, _)| owner.trim());
        owner.is_some_and(|owner| !owner.is_empty() && name.trim().starts_with(owner))
    };
    words(name).iter().any(|w| is(w, INSOLE)) || table.names.iter().any(is_zone)
}

/// Excludes columns whose unit is not a unit of force.
///
/// # Errors
///
/// No column remains.
fn leave_foreign_units(file: &TextFile, table: &Table, force: &mut Vec<ForceColumn>) -> Result<()> {
    let first = force[0].place;
    force.retain(|f| table.foreign_unit(f.place).is_none());
    if force.is_empty() {
        check_unit(file, table, first)?;
    }
    Ok(())
}

/// Columns in newtons, body weights or percent of the body weight whose names have no known meaning.
fn columns_in_newtons(table: &Table, roles: &[Role]) -> Vec<ForceColumn> {
    let unnamed = (0..table.names.len()).filter(|&i| roles[i] == Role::Other);
    let newtons = unnamed.filter(|&i| is_newtons(table, i));
    newtons.map(|i| vertical(table, i)).collect()
}

fn is_newtons(table: &Table, i: usize) -> bool {
    let is_other = |w: &String| w.starts_with("cop") || w.starts_with("moment");
    let unit = table.force_unit(i);
    let is_force = matches!(
        unit,
        Some(ForceUnit::Newton | ForceUnit::BodyWeight | ForceUnit::PercentBodyWeight)
    );
    is_force && !words(&table.names[i]).iter().any(is_other)
}

/// Two columns with exactly the names left and right, such as two insoles or belts; empty if one of them is missing.
fn named_by_side(table: &Table) -> Vec<ForceColumn> {
    let places = ["left", "right"].map(|side| {
        let place = table.names.iter().position(|n| words(n) == [side]);
        place.map(|i| vertical(table, i))
    });
    match places {
        [Some(left), Some(right)] => vec![left, right],
        _ => Vec::new(),
    }
}

/// Index of the column with a given name, regardless of upper and lower case, or with a given number, counted from 1. Without a header,
/// only a number is possible.
pub(super) fn column(path: &Path, table: &Table, stated: &str) -> Result<usize> {
    let plain = |s: &str| s.trim().to_lowercase();
    let names = &table.names;
    let count = match names.len() {
        0 => table.width.min(WIDEST),
        count => count,
    };
    let exact = names.iter().position(|n| n == stated);
    let place = exact.or_else(|| names.iter().position(|n| plain(n) == plain(stated)));
    let number = stated.parse::<usize>().ok();
    let number = number.filter(|n| (1..=count).contains(n));
    place.or(number.map(|n| n - 1)).ok_or_else(|| {
        if names.is_empty() {
            let column = stated.to_string();
            let fault = ReadError::NoColumnNumber { column, count };
            return fault.at_line(path, table.start.line);
        }
        no_column(stated, names).at_line(path, table.header_line())
    })
}

fn no_column(stated: &str, names: &[String]) -> ReadError {
    let (column, columns) = (stated.to_string(), listed(names));
    match nearest(stated, names.iter().take(200).map(String::as_str)) {
        Some(near) => ReadError::MisspeltColumn {
            column,
            near: near.to_string(),
            columns,
        },
        None => ReadError::NoColumn { column, columns },
    }
}

/// Names of the first 40 columns, for a message.
pub(in crate::read) fn listed(names: &[String]) -> Vec<String> {
    names.iter().take(40).cloned().collect()
}

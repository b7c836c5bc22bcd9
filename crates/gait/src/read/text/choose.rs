//! Which columns of a table to read.

use super::header::{Table, is_unit};
use super::headerless::WIDEST;
use super::layout::TextFile;
use super::listed;
use crate::error::{Error, Placed, ReadError, Result, nearest};
use crate::read::columns::{Role, bracketed, foot, is_of_channel, role, words};
use crate::recording::{Axis, Foot, ForceUnit};

/// Most columns of force: some hundred plates of three components. Each takes a channel of its own.
const MOST_FORCES: usize = 1000;

/// Which columns of a table to read, and how.
pub(super) struct Plan {
    pub time: Option<usize>,
    /// Whether the time column counts samples instead of seconds.
    pub counts: bool,
    pub force: Vec<ForceColumn>,
}

/// Place of a column of force with what its name says.
type ForceColumn = (usize, Axis, Option<Foot>);

/// Decides which columns to read; `None` where the table holds no force.
pub(super) fn plan(file: &TextFile, table: &Table) -> Result<Option<Plan>> {
    let options = file.options;
    let roles: Vec<Role> = table.names.iter().map(|n| role(n)).collect();
    let mut force = match &options.force[..] {
        [] => recognised(table, &roles),
        names => asked(file, table, names)?,
    };
    if force.is_empty() {
        return Ok(None);
    }
    if options.force.is_empty() && force.len() > MOST_FORCES {
        let found = force.len();
        return Err(ReadError::ManyForces { found }.at_line(file.path, table.header_line()));
    }
    // `L::heel, L::toes, L`: the zones of an insole beside their total.
    let name = |i: usize| table.names[i].trim();
    let totals: Vec<String> = force.iter().map(|f| format!("{}::", name(f.0))).collect();
    force.retain(|f| !totals.iter().any(|total| name(f.0).starts_with(total)));
    if options.unit.is_none() {
        leave_foreign_units(file, table, &mut force)?;
    }
    let place = |wanted: &Role| roles.iter().position(|r| r == wanted);
    let (time, counts) = match (&options.time, place(&Role::Time)) {
        (Some(name), _) => (Some(column(file, table, name)?), false),
        (None, Some(time)) => (Some(time), false),
        (None, None) => (place(&Role::Frame), true),
    };
    force.retain(|f| Some(f.0) != time);
    if force.is_empty() {
        return Err(force_is_time(file, table));
    }
    // Several sub-frames share a frame number, so rows are counted instead.
    let sub = place(&Role::SubFrame).is_some();
    Ok(Some(Plan {
        time: time.filter(|_| !(counts && sub)),
        counts,
        force,
    }))
}

/// The columns of force that the user named.
fn asked(file: &TextFile, table: &Table, names: &[String]) -> Result<Vec<ForceColumn>> {
    let mut places: Vec<usize> = names
        .iter()
        .map(|name| column(file, table, name))
        .collect::<Result<_>>()?;
    places.sort_unstable();
    places.dedup();
    Ok(places.into_iter().map(|i| vertical(table, i)).collect())
}

/// The columns that are known to be a force: by their names, else by their units, else by their sides.
fn recognised(table: &Table, roles: &[Role]) -> Vec<ForceColumn> {
    let named = roles.iter().enumerate().filter_map(|(i, r)| match r {
        Role::Force { axis, foot } => Some((i, *axis, *foot)),
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

fn vertical(table: &Table, i: usize) -> ForceColumn {
    (i, Axis::Vertical, foot(&words(&table.names[i])))
}

/// Leaves out columns whose unit is none of force; a fault if there is no other.
fn leave_foreign_units(file: &TextFile, table: &Table, force: &mut Vec<ForceColumn>) -> Result<()> {
    let first = force[0].0;
    force.retain(|f| foreign_unit(table, f.0).is_none());
    if force.is_empty() {
        check_unit(file, table, first)?;
    }
    Ok(())
}

/// The user named one column as both time and force.
pub(super) fn force_is_time(file: &TextFile, table: &Table) -> Error {
    ReadError::ForceIsTime.at_line(file.path, table.start.line)
}

/// Columns of unknown name with a unit of force.
fn columns_in_newtons(table: &Table, roles: &[Role]) -> Vec<ForceColumn> {
    let unnamed = (0..table.names.len()).filter(|&i| roles[i] == Role::Other);
    let newtons = unnamed.filter(|&i| is_newtons(table, i));
    newtons.map(|i| vertical(table, i)).collect()
}

/// Two columns called left and right and nothing else: the two insoles or belts.
fn named_by_side(table: &Table) -> Vec<ForceColumn> {
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

/// The unit of a column, where it is one and none of force: `mV`, `kPa`, `%`.
///
/// In square brackets stands a unit, unless it names a foot, a plate or a direction; in round ones perhaps a remark.
fn foreign_unit(table: &Table, i: usize) -> Option<&str> {
    let name = table.names.get(i)?;
    let is_named = |b: &str| words(b).iter().all(|w| is_of_channel(w));
    let is_bracketed = |b: &&str| {
        let square = name.contains(&format!("[{b}"));
        let letters = b
            .chars()
            .all(|c| c.is_alphanumeric() || " -_.:".contains(c));
        is_unit(b) || (square || !letters) && !is_named(b)
    };
    let brackets = bracketed(name).filter(is_bracketed);
    let mut units = table.unit(i).into_iter().chain(brackets);
    units.find(|unit| *unit != "-" && unit.parse::<ForceUnit>().is_err())
}

pub(crate) fn unit_label(table: &Table, i: usize) -> Option<ForceUnit> {
    let name = table.names.get(i)?;
    let label = |word: &str| word.parse().ok();
    if let Some(unit) = table.unit(i) {
        return label(unit);
    }
    if name.contains(['[', '(']) {
        return bracketed(name).find_map(label);
    }
    // `force_n`, `fz_lbf`, `Fz N/kg`; kilograms would rather be those of a mass.
    let (_, last) = name.trim().rsplit_once(['_', ' '])?;
    label(last).filter(|_| !last.eq_ignore_ascii_case("kg"))
}

/// The error for a column of force whose unit is none of force.
pub(crate) fn check_unit(file: &TextFile, table: &Table, i: usize) -> Result<()> {
    match foreign_unit(table, i) {
        Some(unit) if file.options.unit.is_none() => {
            let (column, unit) = (table.names[i].trim().to_string(), unit.to_string());
            let fault = ReadError::NoForceUnit { column, unit };
            Err(fault.at_line(file.path, table.header_line()))
        }
        _ => Ok(()),
    }
}

/// A column by name (case does not matter) or by number from 1; without a header by number.
pub(crate) fn column(file: &TextFile, table: &Table, wanted: &str) -> Result<usize> {
    let plain = |s: &str| s.trim().to_lowercase();
    let names = &table.names;
    let count = match names.len() {
        0 => table.width.min(WIDEST),
        count => count,
    };
    let found = names
        .iter()
        .position(|n| n == wanted)
        .or_else(|| names.iter().position(|n| plain(n) == plain(wanted)));
    let number = wanted
        .parse::<usize>()
        .ok()
        .filter(|n| (1..=count).contains(n));
    found.or(number.map(|n| n - 1)).ok_or_else(|| {
        let (column, columns) = (wanted.to_string(), listed(names));
        if names.is_empty() {
            return ReadError::NoColumnNumber { column, count }
                .at_line(file.path, table.start.line);
        }
        let error = match nearest(wanted, names.iter().take(200).map(String::as_str)) {
            Some(near) => ReadError::MisspeltColumn {
                column,
                near: near.to_string(),
                columns,
            },
            None => ReadError::NoColumn { column, columns },
        };
        error.at_line(file.path, table.header_line())
    })
}

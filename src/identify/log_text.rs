//! Reading of logs in delimited text. Columns are recognised by names and units and converted to SI units.

use std::f64::consts::TAU;
use std::path::Path;

use super::log::{LARGEST, Log, LogColumns, NAMES};
use crate::error::{LogError, Placed, Result};
use crate::force::NumberTable;
use crate::units::{Dimension, parse};

/// Option that selects each column, in the order of [`NAMES`], and the quantity of the column.
const OPTIONS: [(&str, Dimension); 5] = [
    ("time", Dimension::Time),
    ("angle", Dimension::Angle),
    ("force", Dimension::Force),
    ("speed", Dimension::AngularSpeed),
    ("torque", Dimension::Torque),
];
/// Accepted units of each quantity. Case, spaces and dots are ignored, and `per` is read as `/`.
const UNITS: [&str; 5] = [
    "s, ms, us, min, sec, secs, seconds",
    "rad, deg, °, rev, revs, turn, turns, degrees, revolutions",
    "N, kN, lbf, lb, lbs, kgf",
    "rad/s, deg/s, °/s, rpm, rev/s, rps, 1/min, min^-1, min⁻¹",
    "N m, N mm, kN m, lbf in, in lbf, lb in, in lb, lbf ft, ft lbf, lb ft, ft lb",
];
/// Words that identify the names of angle, speed and torque columns. Time and force columns have the same names as in recordings.
const WORDS: [&str; 5] = [
    "",
    "theta angle phi master position winkel angulo ángulo posicion posición",
    "",
    "speed omega velocity velocidad rpm drehzahl vitesse",
    "torque moment momento par drehmoment couple",
];
/// Words that denote an angle in counts of an encoder.
const COUNTS: &str = "counts ticks pulses encoder cuentas pulsos";
const ANGLE: usize = 1;
const FORCE: usize = 2;

/// Columns of a log, each selected by name or by number from 1. Columns that are not selected are recognised by names and units.
///
/// ```
/// use gaitcam::identify::{Log, LogOptions};
///
/// let rows: String = (0..99).map(|i| format!("{};{};{i},5\n", 4 * i, 20 * i)).collect();
/// let text = format!("t_ms;Encoder;Cell [kN]\n{rows}");
/// let options = LogOptions { counts_per_turn: Some(1000.0), ..LogOptions::default() };
/// let log = Log::read("plc.csv".as_ref(), text.as_bytes(), &options)?;
/// assert_eq!(log.columns().force[1], 1500.0);
/// assert!((log.columns().theta.as_ref().unwrap()[50] - std::f64::consts::TAU).abs() < 1e-12);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LogOptions {
    /// Name or number of the time column.
    pub time: Option<String>,
    /// Name or number of the column with the cam angle.
    pub angle: Option<String>,
    /// Name or number of the column with the force of the load cell.
    pub force: Option<String>,
    /// Name or number of the column with the speed of the cam.
    pub speed: Option<String>,
    /// Name or number of the column with the torque at the camshaft.
    pub torque: Option<String>,
    /// Counts of the encoder per turn of the cam, if the angle column contains counts.
    pub counts_per_turn: Option<f64>,
}

impl Log {
    /// Reads a delimited text with a column of force and a column of time or cam angle (or both). Columns of speed and torque are optional.
    /// Other columns are ignored.
    ///
    /// A column is recognised by its name or its unit (`t_ms`, `Angle [deg]`, `Force (kN)`, or a row of units). A column that is named in
    /// the options and has no unit is in SI units. The angle may restart after each turn. `path` is used in messages.
    ///
    /// # Errors
    ///
    /// - A column is missing or ambiguous, or its unit is missing or unknown.
    /// - A cell is not a number.
    /// - The errors of [`Log::new`].
    pub fn read(path: &Path, bytes: &[u8], options: &LogOptions) -> Result<Log> {
        let table = NumberTable::find(path, bytes)?;
        let names = Names {
            path,
            table: &table,
            options,
        };
        let counts = options.counts_per_turn;
        if let Some(counts) = counts.filter(|c| !(c.is_finite() && *c > 0.0)) {
            return Err(LogError::BadCounts { counts }.in_file(path));
        }
        let mut places = [None; 5];
        for (which, place) in places.iter_mut().enumerate() {
            *place = names.column(which)?;
        }
        let columns = names.listed();
        if places[FORCE].is_none() || (places[0].is_none() && places[ANGLE].is_none()) {
            return Err(names.refused(LogError::NoColumn { columns }));
        }
        if counts.is_some() && places[ANGLE].is_none() {
            return Err(names.refused(LogError::NoCounts { columns }));
        }
        let mut columns: [Vec<f64>; 5] = Default::default();
        let mut lines = Vec::new();
        for (line, row) in table.rows() {
            for (which, place) in places.iter().enumerate() {
                let Some((place, factor)) = place else {
                    continue;
                };
                let cell = row.get(*place);
                let number = cell.and_then(|c| c.number);
                let Some(x) = number.filter(|x| x.abs() * factor <= LARGEST) else {
                    let typed = cell.map_or(String::new(), |c| c.text.clone());
                    let column = names.name(*place);
                    return Err(LogError::Value { column, typed }.at_line(path, line));
                };
                columns[which].push(x * factor);
            }
            lines.push(line);
        }
        let [time, theta, force, speed, torque] = columns;
        let known = |column: Vec<f64>| (!column.is_empty()).then_some(column);
        let columns = LogColumns {
            time: known(time),
            theta: known(theta),
            force,
            speed: known(speed),
            torque: known(torque),
        };
        Log::checked(path, columns, &lines)
    }
}

/// Result of recognising the unit of a column.
enum Unit {
    /// Index of the quantity in [`NAMES`], and the conversion factor of the unit to SI.
    Known(usize, f64),
    /// Unit of a quantity that a log does not contain.
    Other(String),
    Unknown(String),
    None,
}

/// Recognition of the columns of a table by names, units and options.
struct Names<'a> {
    path: &'a Path,
    table: &'a NumberTable<'a>,
    options: &'a LogOptions,
}

impl Names<'_> {
    fn refused(&self, fault: LogError) -> crate::error::Error {
        fault.at_line(self.path, self.table.header_line())
    }

    fn name(&self, place: usize) -> String {
        let named = self.table.names().get(place);
        named.map_or_else(|| (place + 1).to_string(), |n| n.trim().to_string())
    }

    /// Number of columns of the table, including tables without names.
    fn width(&self) -> usize {
        match self.table.names().len() {
            0 => self.table.rows().next().map_or(0, |(_, row)| row.len()),
            count => count,
        }
    }

    /// List of the columns for a message: their names, or their numbers if there is no header.
    fn listed(&self) -> String {
        let all = (0..self.width().min(40)).map(|i| self.name(i));
        all.collect::<Vec<_>>().join(", ")
    }

    /// Index of the column with a quantity, and its conversion factor to SI. `None` if the table has no such column.
    fn column(&self, which: usize) -> Result<Option<(usize, f64)>> {
        let o = self.options;
        let stated = [&o.time, &o.angle, &o.force, &o.speed, &o.torque][which];
        if let Some(stated) = stated {
            let place = self.table.place(self.path, stated)?;
            return Ok(Some((place, self.factor(which, place, 1.0)?)));
        }
        let names = self.table.names();
        let in_counts = which == ANGLE && o.counts_per_turn.is_some();
        let is_si = |n: &String| !in_counts && n.trim().eq_ignore_ascii_case(NAMES[which]);
        if let Some(place) = names.iter().position(is_si) {
            return Ok(Some((place, self.factor(which, place, 1.0)?)));
        }
        let of_unit = |i: &usize| matches!(self.unit(*i), Unit::Known(q, _) if q == which);
        let of_name = |i: &usize| match self.unit(*i) {
            Unit::Known(quantity, _) if quantity != which => false,
            // A position in millimetres is not an angle. Its unit excludes the column.
            Unit::Other(_) if which != 0 && which != FORCE => false,
            _ => self.means(which, *i),
        };
        let both = |i: &usize| of_unit(i) && of_name(i);
        let counts = |i: &usize| which == ANGLE && self.is_in_counts(*i);
        let all = 0..self.width();
        let kinds: [&dyn Fn(&usize) -> bool; 4] = match o.counts_per_turn {
            Some(_) => [&counts, &both, &of_name, &of_unit],
            None => [&both, &of_name, &of_unit, &counts],
        };
        let found = kinds.into_iter().map(|kind| all.clone().filter(kind));
        let found = found.map(Iterator::collect::<Vec<usize>>);
        match found.into_iter().find(|f| !f.is_empty()).as_deref() {
            None => Ok(None),
            Some([place]) => Ok(Some((*place, self.factor(which, *place, f64::NAN)?))),
            Some(several) => {
                let columns: Vec<String> = several.iter().map(|i| self.name(*i)).collect();
                let (option, columns) = (OPTIONS[which].0.to_string(), columns.join(", "));
                Err(self.refused(LogError::ManyColumns { option, columns }))
            }
        }
    }

    /// Whether the name of a column denotes the quantity `which`.
    fn means(&self, which: usize, place: usize) -> bool {
        match which {
            0 => self.table.means_time(place),
            FORCE => self.table.means_force(place),
            _ => self.has_word(place, WORDS[which]),
        }
    }

    fn has_word(&self, place: usize, list: &str) -> bool {
        let words = self.table.words(place);
        words.iter().any(|w| list.split(' ').any(|l| l == w))
    }

    fn is_in_counts(&self, place: usize) -> bool {
        match self.unit(place) {
            Unit::Known(..) | Unit::Other(_) => false,
            Unit::Unknown(unit) => COUNTS.split(' ').any(|c| c == unit.to_lowercase()),
            Unit::None => self.has_word(place, COUNTS),
        }
    }

    /// Conversion factor of a column to SI. A column without unit has the factor `default`. If `default` is NaN, a unit is required.
    fn factor(&self, which: usize, place: usize, default: f64) -> Result<f64> {
        let (column, (option, dimension)) = (self.name(place), OPTIONS[which]);
        let counts = self.options.counts_per_turn.filter(|_| which == ANGLE);
        let unit = match (self.unit(place), counts) {
            (Unit::Known(ANGLE, _), Some(_)) => {
                let columns = self.listed();
                return Err(self.refused(LogError::NoCounts { columns }));
            }
            (_, Some(counts)) => return Ok(TAU / counts),
            (Unit::Known(quantity, factor), _) if quantity == which => return Ok(factor),
            _ if which == ANGLE && self.is_in_counts(place) => {
                return Err(self.refused(LogError::Counts { column }));
            }
            (Unit::None, _) if default.is_finite() => return Ok(default),
            (Unit::None, _) => {
                let (unit, option) = (dimension.si().to_string(), option.to_string());
                return Err(self.refused(LogError::NoUnit {
                    column,
                    unit,
                    option,
                }));
            }
            (Unit::Known(other, _), _) => OPTIONS[other].1.si().to_string(),
            (Unit::Other(unit) | Unit::Unknown(unit), _) => unit,
        };
        let units = UNITS[which].to_string();
        Err(self.refused(LogError::UnknownUnit {
            column,
            unit,
            units,
        }))
    }

    /// Unit of a column. It is read from the row of units, the brackets in the name of the column, or the last words of the name.
    fn unit(&self, place: usize) -> Unit {
        let whole = self.table.names().get(place).map_or("", |n| n.trim());
        let (name, stated) = self.table.name_and_unit(place);
        let is_apart = whole.contains(['[', '(']) || name == whole.to_lowercase();
        let stated = stated.filter(|_| is_apart);
        let words: Vec<&str> = whole.split(['_', ' ']).collect();
        let last = (1..=words.len().min(3)).rev();
        let last = last.map(|n| words[words.len() - n..].join(" "));
        if let Some((which, factor)) = stated.iter().cloned().chain(last).find_map(|u| known(&u)) {
            return Unit::Known(which, factor);
        }
        let is_other = |unit: &&str| {
            use Dimension::{Acceleration, Length, Mass, Power, Pressure, Speed};
            let others = [Acceleration, Length, Mass, Power, Pressure, Speed];
            let text = format!("1 {unit}");
            others.iter().any(|d| parse(&text, *d).is_ok())
        };
        let last = words.last().copied().filter(|_| words.len() > 1);
        let other = stated.as_deref().or(last).filter(is_other);
        match (other.map(str::to_string), stated) {
            (Some(unit), _) => Unit::Other(unit),
            (None, Some(unit)) => Unit::Unknown(unit),
            (None, None) => Unit::None,
        }
    }
}

/// Index of the quantity of a unit, and the conversion factor of the unit to SI.
fn known(typed: &str) -> Option<(usize, f64)> {
    let plain = |unit: &str| -> String {
        let lower = unit.to_lowercase().replace("per", "/");
        let kept = |c: &char| c.is_alphanumeric() || "°/".contains(*c);
        let letters = lower.chars().filter(kept);
        letters
            .map(|c| if "µμ".contains(c) { 'u' } else { c })
            .collect()
    };
    let typed = plain(typed);
    let find = |which: usize| {
        let unit = UNITS[which].split(", ").find(|u| plain(u) == typed)?;
        let factor = parse(&format!("1 {unit}"), OPTIONS[which].1).ok()?;
        Some((which, factor))
    };
    (0..UNITS.len()).find_map(find)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_unit_is_one_of_the_units_of_scenes_and_of_one_quantity() {
        for (which, units) in UNITS.iter().enumerate() {
            for unit in units.split(", ") {
                let factor = parse(&format!("1 {unit}"), OPTIONS[which].1).unwrap();
                assert_eq!(known(unit), Some((which, factor)), "{unit}");
            }
        }
        for (typed, unit) in [
            ("n_m", "N m"),
            ("N.mm", "N mm"),
            ("in·lb", "in lb"),
            ("RPM", "rpm"),
            ("rad per s", "rad/s"),
        ] {
            assert_eq!(known(typed), known(unit), "{typed}");
        }
        assert_eq!(known("V"), None);
    }
}

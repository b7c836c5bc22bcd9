//! Units of columns, from the row of units, from the brackets in a name, or from the last word of a name.

use super::delimited::TextFile;
use super::header::{Table, is_unit};
use crate::error::{Placed, ReadError, Result};
use crate::read::columns::{bracketed, is_of_channel, words};
use crate::recording::ForceUnit;

impl Table {
    /// Unit of force of a column; `None` if the file gives no unit of force for the column.
    pub fn force_unit(&self, i: usize) -> Option<ForceUnit> {
        let name = self.names.get(i)?;
        let label = |word: &str| word.parse().ok();
        if let Some(unit) = self.unit(i) {
            return label(unit);
        }
        if name.contains(['[', '(']) {
            return bracketed(name).find_map(label);
        }
        // For example `force_n`, `fz_lbf`, `Fz N/kg`. A last word `kg` is more likely the unit of a mass.
        let (_, last) = name.trim().rsplit_once(['_', ' '])?;
        label(last).filter(|_| !last.eq_ignore_ascii_case("kg"))
    }

    /// Seconds per unit of a time column, if the column gives a unit.
    pub fn time_unit(&self, i: usize) -> Option<f64> {
        let name = self.names.get(i)?;
        let label = self.unit(i).or_else(|| bracketed(name).last());
        let last = words(name).pop();
        match label.or(last.as_deref())?.to_lowercase().as_str() {
            "s" | "sec" | "secs" | "seconds" => Some(1.0),
            "ms" => Some(1e-3),
            "us" | "µs" => Some(1e-6),
            "min" => Some(60.0),
            _ => None,
        }
    }

    /// Unit of a column, if it is not a unit of force: `mV`, `kPa`, `%`.
    ///
    /// Square brackets contain a unit, unless they contain a foot, a plate or a direction. Round brackets may contain a remark instead of a
    /// unit.
    pub fn foreign_unit(&self, i: usize) -> Option<&str> {
        let name = self.names.get(i)?;
        let is_named = |b: &str| words(b).iter().all(|w| is_of_channel(w));
        let is_bracketed = |b: &&str| {
            let square = name.contains(&format!("[{b}"));
            let letters = b
                .chars()
                .all(|c| c.is_alphanumeric() || " -_.:".contains(c));
            is_unit(b) || (square || !letters) && !is_named(b)
        };
        let brackets = bracketed(name).filter(is_bracketed);
        let mut units = self.unit(i).into_iter().chain(brackets);
        units.find(|unit| *unit != "-" && unit.parse::<ForceUnit>().is_err())
    }

    /// Name and unit of a column. They are the same for `lift_mm`, `lift [mm]` and `lift (mm)`. The unit may also be in a row of units.
    pub fn name_and_unit(&self, i: usize) -> (String, Option<String>) {
        let whole = self.names.get(i).map_or("", |n| n.trim());
        if let Some(unit) = self.unit(i) {
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
}

/// Rejects a force column whose unit is not a unit of force, unless the user gives the unit.
pub(in crate::read) fn check_unit(file: &TextFile, table: &Table, i: usize) -> Result<()> {
    match table.foreign_unit(i) {
        Some(unit) if file.options.unit.is_none() => {
            let (column, unit) = (table.names[i].trim().to_string(), unit.to_string());
            let fault = ReadError::NoForceUnit { column, unit };
            Err(fault.at_line(file.path, table.header_line()))
        }
        _ => Ok(()),
    }
}

//! Samples of a file of one cycle: force, spread, and times or phases.

use std::f64::consts::TAU;

use super::columns::{Role, role, words};
use super::text::{ForceColumn, Samples, Table, TextFile, check_unit, choose};
use super::vertical::keep_vertical;
use crate::error::{CycleColumn, Placed, ReadError, Result};
use crate::recording::{ForceUnit, ReadOptions};

/// Maximum phase as a fraction of the cycle. If a phase exceeds this value, all phases are in percent.
pub(super) const LARGEST_PART: f64 = 1.5;

/// Samples of a cycle in the units of the file, and the seconds per unit of the times. The latter is `None` if the column may not be a
/// time. The first column is the force. A second column, if any, is the spread of the force. Every row must be complete.
pub(super) fn samples(file: &TextFile, table: &Table) -> Result<(Samples, Option<f64>)> {
    let options = file.options;
    let names = &table.names;
    if names.is_empty() && (options.time.is_none() || options.force.is_empty()) {
        return Err(ReadError::NamelessColumns.at_line(file.path, table.start.line));
    }
    let missing = |column: CycleColumn| {
        let columns = names.clone();
        let error = ReadError::CycleColumnMissing { column, columns };
        error.at_line(file.path, table.header_line())
    };
    let columns = choose(file, table)?;
    let mut columns = columns.ok_or_else(|| missing(CycleColumn::Force))?;
    let is_clock = !columns.counts || columns.phase_of_stance.is_some() || names.is_empty();
    let time = columns.time.filter(|_| is_clock);
    time.ok_or_else(|| missing(CycleColumn::Time))?;
    if let (Some(true), None, Some(phase)) =
        (columns.phase_of_stance, options.span_rad, columns.time)
    {
        let column = names[phase].clone();
        return Err(ReadError::PhaseOfStance { column }.at_line(file.path, table.header_line()));
    }
    check_unit(file, table, columns.force[0].place)?;
    let of_spread = names.iter().position(|name| is_spread(name));
    columns.force.retain(|f| Some(f.place) != of_spread);
    let spread = of_spread.zip(columns.force.first().copied());
    let spread = spread.map(|(place, force)| ForceColumn { place, ..force });
    columns.force.extend(spread);
    let samples = Samples::read(file, table, columns)?;
    if let Some(bad) = samples.skipped.first() {
        return Err(ReadError::CycleRow.at_line(file.path, *bad));
    }
    let forces = samples.forces.iter().map(|f| &f.values);
    for values in forces.chain(&samples.times) {
        if let Some(i) = values.iter().position(|x| !x.is_finite()) {
            return Err(ReadError::CycleValue.at_line(file.path, table.start.line + i));
        }
    }
    one_force(file, table, samples)
}

/// Whether a column is the standard deviation of the force.
fn is_spread(name: &str) -> bool {
    let word = |w: &String| w == "spread" || w == "sd";
    words(name).first().is_some_and(word)
}

/// Samples of the file with a single force, and the seconds per unit of the times. The latter is `None` if the column may not be a time.
///
/// # Errors
///
/// There is no force, or there are several forces.
pub(super) fn one_force(
    file: &TextFile,
    table: &Table,
    mut samples: Samples,
) -> Result<(Samples, Option<f64>)> {
    if file.options.force.is_empty() {
        keep_vertical(&mut samples.forces, &mut samples.notes);
    }
    if samples.forces.is_empty() {
        let (column, columns) = (CycleColumn::Force, table.names.clone());
        let fault = ReadError::CycleColumnMissing { column, columns };
        return Err(fault.at_line(file.path, table.header_line()));
    }
    let names = samples.forces.iter().map(|f| f.name.clone());
    let columns: Vec<String> = names.filter(|name| !is_spread(name)).collect();
    if columns.len() > 1 {
        let fault = ReadError::CycleForces { columns };
        return Err(fault.at_line(file.path, table.header_line()));
    }
    // A column with only the name `time` is in seconds. A column with another unit, such as a percentage, is not a time.
    let options = file.options;
    let is_time =
        |name: &&String| matches!(role(name), Role::Time) || options.time.as_ref() == Some(name);
    let name = table.names.iter().find(is_time);
    let is_bare = name.is_some_and(|name| words(name).len() == 1);
    let unit = samples.time_unit.or(is_bare.then_some(1.0));
    Ok((samples, unit))
}

/// Times, s, from phases in percent or in fractions of a cycle.
pub(super) fn of_phase(
    column: String,
    phases: Vec<f64>,
    period: Option<f64>,
    options: &ReadOptions,
) -> Result<Vec<f64>> {
    let period = period.ok_or(ReadError::PhaseWithoutPeriod { column })?;
    let largest = phases.iter().copied().fold(0.0, f64::max);
    let whole = if largest > LARGEST_PART { 100.0 } else { 1.0 };
    let covered = options.span_rad.map_or(1.0, |span| span / TAU);
    Ok(phases
        .iter()
        .map(|x| x / whole * covered * period)
        .collect())
}

/// Factor from the unit of the force column to newtons.
pub(super) fn newtons(
    file: &TextFile,
    table: &Table,
    samples: &Samples,
    mass_kg: Option<f64>,
) -> Result<f64> {
    let unit = file.options.unit.or(samples.forces[0].unit);
    let unit = unit.unwrap_or(ForceUnit::Newton);
    unit.newtons(mass_kg).ok_or_else(|| {
        let unit = unit.name();
        ReadError::MassMissing { unit }.at_line(file.path, table.start.line)
    })
}

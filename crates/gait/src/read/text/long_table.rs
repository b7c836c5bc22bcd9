//! Long tables of standardised gait data: one cycle for each subject, task and step, with a phase column instead of times.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::choose::{column, listed};
use super::delimited::{Delimiters, Fields, Lines, Position, Separator, TextFile, text};
use super::header::Table;
use super::samples::Samples;
use super::units::check_unit;
use crate::error::{Error, Placed, ReadError, Result};
use crate::read::columns::{Role, role, words};
use crate::read::cycle_samples::LARGEST_PART;
use crate::read::number::{trim, value};
use crate::read::timebase::polyline;
use crate::read::vertical::RawForce;
use crate::recording::{Axis, ReadOptions};
use crate::statistics::mean;

/// Names of columns that distinguish the cycles of a table.
const IDENTIFIERS: [&str; 7] = [
    "subject", "task", "step", "session", "trial", "cycle", "stride",
];
/// Words in a column name that show that the column contains the rate of the phase, not the phase.
const RATES: [&str; 3] = ["dot", "rate", "velocity"];

/// Minimum number of rows of a cycle.
const FEWEST: usize = 4;

/// A long table in a text, with the indices of the columns that distinguish its cycles.
pub(in crate::read) struct LongTable<'a> {
    file: TextFile<'a>,
    /// Header of the table, and position of its first row.
    table: Table,
    /// Indices of the columns that distinguish the cycles.
    identifiers: Vec<usize>,
}

/// Rows of one cycle: phases as written in the file, and forces.
#[derive(Default)]
struct Cycle {
    phases: Vec<f64>,
    forces: Vec<f64>,
}

impl<'a> LongTable<'a> {
    /// The long table in a text; `None` for other texts. A long table has columns for the subject, the phase and a force, but no times.
    pub fn of(path: &'a Path, bytes: &'a [u8], options: &'a ReadOptions) -> Option<Self> {
        let mut lines = Lines::new(bytes);
        let (_, header) = lines.find(|(_, line)| !line.trim_ascii().is_empty())?;
        // About half of the fields of a row are words, so the separator is determined from the header.
        let parts = |byte: &u8| header.iter().filter(|b| *b == byte).count();
        let separator = [b',', b';', b'\t'].into_iter().max_by_key(parts)?;
        let start = lines.at;
        let row = lines.next().map_or(&b""[..], |(_, row)| row);
        let delimiters = Delimiters {
            separator: Separator::Byte(separator),
            comma: separator != b',' && row.contains(&b','),
        };
        let names = Fields::new(header, delimiters).map(|f| text(trim(f)));
        let names: Vec<String> = names.collect();
        let named = |part: &str| names.iter().any(|n| words(n).iter().any(|w| w == part));
        let has = |is: fn(&Role) -> bool| names.iter().any(|n| is(&role(n)));
        let timed = has(|r| *r == Role::Time);
        let forced = has(|r| matches!(r, Role::Force { .. }));
        if timed || !forced || !named("subject") || !named("phase") {
            return None;
        }
        let is_identifier = |name: &String| {
            let words = words(name);
            let known = |w: &String| w == "id" || IDENTIFIERS.contains(&w.as_str());
            words.iter().all(known) && words.first().is_some_and(|w| w != "id")
        };
        let identifiers = names.iter().enumerate().filter(|n| is_identifier(n.1));
        let identifiers = identifiers.map(|(place, _)| place).collect();
        let table = Table {
            start,
            width: names.len(),
            names,
            units: Vec::new(),
            head: Vec::new(),
        };
        let file = TextFile {
            path,
            bytes,
            delimiters,
            options,
        };
        Some(LongTable {
            file,
            table,
            identifiers,
        })
    }

    /// Header of the table, with the position of its first row.
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// Fields of each row, with the position of the row.
    fn rows(&self) -> impl Iterator<Item = (Position, Vec<&'a [u8]>)> + '_ {
        let lines = Lines::from(self.file.bytes, self.table.start);
        let rows = lines.filter(|(_, line)| !line.trim_ascii().is_empty());
        rows.map(|(at, line)| {
            let fields = Fields::new(line, self.file.delimiters);
            (at, fields.map(trim).collect())
        })
    }

    /// Fields that identify the cycle of a row. If `first` is given, only the columns whose names begin with this word are used.
    fn identity(&self, fields: &[&'a [u8]], first: Option<&str>) -> Vec<&'a [u8]> {
        let is_meant = |place: &&usize| {
            let name = words(&self.table.names[**place]);
            first.is_none_or(|first| name.first().is_some_and(|w| w == first))
        };
        let chosen = self.identifiers.iter().filter(is_meant);
        chosen.filter_map(|&i| fields.get(i).copied()).collect()
    }

    /// Error if a long table is read as a recording, because it has no times.
    pub fn refusal(&self) -> Error {
        let cycles = self.rows().map(|(_, fields)| self.identity(&fields, None));
        let cycles = cycles.collect::<BTreeSet<_>>().len();
        ReadError::LongTable { cycles }.at_line(self.file.path, self.table.header_line())
    }

    /// Indices of the phase column and the force column. The user may name these columns. Otherwise, they are the first phase column and
    /// the only vertical force column, or the only one with the same side as the phase.
    fn columns(&self) -> Result<[usize; 2]> {
        let (names, options) = (&self.table.names, self.file.options);
        let asked = |name: &String| column(self.file.path, &self.table, name);
        let is_phase = |name: &&String| {
            let words = words(name);
            words.iter().any(|w| w == "phase") && !words.iter().any(|w| RATES.contains(&w.as_str()))
        };
        let first = names.iter().position(|name| is_phase(&name));
        let phase = options.time.as_ref().map(asked).transpose()?;
        let phase = phase.or(first).unwrap_or(0);
        match &options.force[..] {
            [] => (),
            [name] => return Ok([phase, asked(name)?]),
            several => {
                let columns = several.to_vec();
                let fault = ReadError::LongForces { columns };
                return Err(fault.at_line(self.file.path, self.table.header_line()));
            }
        }
        let is_force = |place: &usize| matches!(role(&names[*place]), Role::Force { axis, .. } if axis == Axis::Vertical);
        let mut forces: Vec<usize> = (0..names.len()).filter(is_force).collect();
        let side = words(&names[phase]).pop().unwrap_or_default();
        let of_side = |place: &usize| words(&names[*place]).contains(&side);
        if forces.iter().any(of_side) {
            forces.retain(of_side);
        }
        match forces[..] {
            [force] => Ok([phase, force]),
            [] => {
                let columns = listed(names);
                Err(ReadError::NoForceColumn { columns }.in_file(self.file.path))
            }
            _ => {
                let columns = forces.iter().map(|i| names[*i].clone()).collect();
                let fault = ReadError::LongForces { columns };
                Err(fault.at_line(self.file.path, self.table.header_line()))
            }
        }
    }

    /// Mean force of all cycles, and the number of cycles.
    ///
    /// The force is in the unit of its column, at the phases of the first cycle. The phases are converted to seconds with the period. If
    /// there are several cycles, the standard deviation follows as a second force column.
    ///
    /// # Errors
    ///
    /// Several tasks; forces of several sides; a value that is not a number; phases that do not increase; too few rows in a cycle.
    pub fn mean(&self) -> Result<(Samples, usize)> {
        let path = self.file.path;
        let [phase, force] = self.columns()?;
        check_unit(&self.file, &self.table, force)?;
        let mut cycles: BTreeMap<Vec<&[u8]>, Cycle> = BTreeMap::new();
        let mut tasks: BTreeSet<String> = BTreeSet::new();
        for (at, fields) in self.rows() {
            let number = |place: usize| {
                let x = fields
                    .get(place)
                    .map(|f| value(f, self.file.delimiters.comma));
                let x = x.filter(|x| x.is_finite());
                x.ok_or_else(|| ReadError::CycleValue.at_line(path, at.line))
            };
            let (time, force) = (number(phase)?, number(force)?);
            let task = self.identity(&fields, Some("task"));
            tasks.insert(text(&task.join(&b' ')));
            let cycle = cycles.entry(self.identity(&fields, None)).or_default();
            if let Some(&after) = cycle.phases.last().filter(|last| **last >= time) {
                return Err(ReadError::TimeBackwards { time, after }.at_line(path, at.line));
            }
            cycle.phases.push(time);
            cycle.forces.push(force);
        }
        if tasks.len() > 1 {
            let tasks = tasks.into_iter().take(12).collect();
            let fault = ReadError::LongTasks { tasks };
            return Err(fault.at_line(path, self.table.header_line()));
        }
        let count = cycles.len();
        let shortest = cycles.values().map(|c| c.phases.len()).min();
        if let Some(samples) = shortest.filter(|rows| *rows < FEWEST) {
            let fault = ReadError::FewSamples { samples };
            return Err(fault.at_line(path, self.table.start.line));
        }
        let phases = cycles.values().next().map(|c| c.phases.clone());
        let phases = phases.unwrap_or_default();
        let mut lines: Vec<_> = (cycles.values())
            .map(|c| polyline(&c.phases, &c.forces))
            .collect();
        let (mut means, mut spread) = (Vec::new(), Vec::new());
        for &phase in &phases {
            let all: Vec<f64> = lines.iter_mut().map(|line| line(phase)).collect();
            let middle = mean(&all);
            let squares: f64 = all.iter().map(|x| (x - middle).powi(2)).sum();
            means.push(middle);
            spread.push((squares / (count.max(2) - 1) as f64).sqrt());
        }
        let of = |values: Vec<f64>| RawForce {
            name: self.table.names[force].clone(),
            axis: Axis::Vertical,
            foot: None,
            unit: self.table.force_unit(force),
            values,
        };
        let spread = (count > 1).then_some(spread);
        let largest = phases.last().copied().unwrap_or_default();
        let whole = if largest > LARGEST_PART { 100.0 } else { 1.0 };
        let period = self.file.options.period_s.unwrap_or(1.0);
        let samples = Samples {
            times: Some(phases.iter().map(|phase| phase / whole * period).collect()),
            time_unit: None,
            counts: false,
            phase: None,
            forces: std::iter::once(means).chain(spread).map(of).collect(),
            insole: None,
            skipped: Vec::new(),
            notes: Vec::new(),
        };
        Ok((samples, count))
    }
}

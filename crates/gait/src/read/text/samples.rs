//! Samples of a recording: the selected columns of a table, their time base, and their conversion to a recording.

use super::choose::Columns;
use super::delimited::TextFile;
use super::header::Table;
use super::table::{Numbers, numbers};
use crate::error::{Error, Placed, ReadError, Result};
use crate::quantity::{self, hertz};
use crate::read::keys::Keys;
use crate::read::timebase::{TimeBase, usual_step};
use crate::read::vertical::{self, Facts, RawForce};
use crate::recording::{ClockSource, Format, Note, ReadOptions, Recording};

/// Raw values of the selected columns, before time and unit are determined.
pub(in crate::read) struct Samples {
    /// Times as written in the file, if there is a time column.
    pub times: Option<Vec<f64>>,
    /// Seconds per unit of the times, if the column gives a unit.
    pub time_unit: Option<f64>,
    /// Whether the times are sample numbers or phases.
    pub counts: bool,
    /// Name of the time column, if it contains the phase of a cycle.
    pub phase: Option<String>,
    pub forces: Vec<RawForce>,
    /// Whether the forces are those of pressure insoles, if known.
    pub insole: Option<bool>,
    /// Numbers of the first lines that are not rows of numbers.
    pub skipped: Vec<usize>,
    /// Notes on assumptions that were made.
    pub notes: Vec<Note>,
}

impl Samples {
    /// Reads the selected columns.
    ///
    /// # Errors
    ///
    /// The times decrease; rows lack most of their fields.
    pub fn read(file: &TextFile, table: &Table, columns: Columns) -> Result<Self> {
        let forces = columns.force.iter().map(|f| f.place);
        let mut places: Vec<usize> = forces.chain(columns.time).collect();
        places.sort_unstable();
        places.dedup();
        let mut read = match columns.read {
            Some(all) => part(file, table, all, &places, columns.time)?,
            None => {
                let slot = |place| places.binary_search(&place).unwrap_or(0);
                numbers(file, table, &places, columns.time.map(slot))?
            }
        };
        let slot = |place: usize| places.binary_search(&place).unwrap_or(0);
        let mut take = |place: usize| std::mem::take(&mut read.columns[slot(place)]);
        let times = columns.time.map(&mut take);
        let name = |i: usize| match table.names.get(i) {
            Some(name) => name.trim().to_string(),
            None => format!("column {}", i + 1),
        };
        let forces = columns.force.iter().map(|f| RawForce {
            name: name(f.place),
            axis: f.axis,
            foot: f.foot,
            unit: table.force_unit(f.place),
            values: take(f.place),
        });
        Ok(Samples {
            forces: forces.collect(),
            times,
            time_unit: columns.time.and_then(|t| table.time_unit(t)),
            counts: columns.counts,
            phase: columns.phase_of_stance.and(columns.time).map(&name),
            insole: columns.insole,
            skipped: read.skipped,
            notes: columns.notes,
        })
    }

    /// Applies a time base to the samples and converts them to channels of vertical force.
    pub fn recording(
        mut self,
        file: &TextFile,
        table: &Table,
        keys: &Keys,
        format: Format,
    ) -> Result<Recording> {
        let path = file.path;
        let samples = self.forces.first().map_or(0, |f| f.values.len());
        if samples < 2 {
            return Err(ReadError::FewSamples { samples }.at_line(path, table.start.line));
        }
        if let Some(announced) = keys.rows.filter(|r| *r != samples) {
            let found = samples;
            self.notes.push(Note::RowsDiffer { announced, found });
        }
        if let Some(&first_line) = self.skipped.first() {
            self.notes.push(Note::LinesSkipped { first_line });
        }
        let place = |e: Error| e.in_file(path);
        let base = self.time_base(file.options, keys.rate_hz).map_err(place)?;
        let facts = Facts {
            format,
            insole: self.insole.unwrap_or(false),
            samples,
            mass_kg: keys.mass_kg,
            zero: None,
            notes: self.notes,
        };
        vertical::recording(self.forces, base, facts, file.options).map_err(place)
    }

    /// Time base. The sources, in order of preference, are the rate given by the user, the time column, and the rate in the header.
    fn time_base(&mut self, options: &ReadOptions, key_rate: Option<f64>) -> Result<TimeBase> {
        let times = self.times.as_deref().filter(|_| !self.counts);
        if let Some(rate) = options.rate_hz {
            let note = times.and_then(|times| overridden(times, self.time_unit, rate));
            self.notes.extend(note);
            return Ok(TimeBase::even(rate, ClockSource::User));
        }
        let Some(times) = times else {
            let without = || match self.phase.clone() {
                Some(column) => ReadError::PhaseWithoutPeriod { column },
                None => ReadError::NoRate,
            };
            let rate = key_rate.ok_or_else(without)?;
            return Ok(TimeBase::even(rate, ClockSource::Header));
        };
        if times.len() < 2 {
            let samples = times.len();
            return Err(ReadError::FewSamples { samples }.into());
        }
        let mut guess = None;
        let scale = match self.time_unit {
            Some(unit) => unit,
            None => guessed_unit(times, key_rate, &mut guess),
        };
        let seconds: Vec<f64>;
        let times = if scale == 1.0 {
            times
        } else {
            seconds = times.iter().map(|t| t * scale).collect();
            &seconds
        };
        let mut base = TimeBase::from_times(times)?;
        if guess.is_some() {
            base.source = ClockSource::GuessedTimes;
        }
        self.notes.extend(guess);
        if let Some((count, at)) = base.missed {
            let first = quantity::seconds(at);
            self.notes.push(Note::SamplesMissing { count, first });
        }
        let Some(rate) = key_rate else {
            return Ok(base);
        };
        let off = (rate / base.rate_hz - 1.0).abs();
        // Times are rounded. If the rate in the header agrees with them, it is more accurate.
        if !base.is_uneven() && off < 2e-3 {
            return Ok(TimeBase::even(rate, ClockSource::Header).starting_at(base.start_s));
        }
        if off > 0.01 {
            self.notes.push(Note::RatesDiffer {
                header: hertz(rate),
                column: hertz(base.rate_hz),
            });
        }
        Ok(base)
    }
}

/// Keeps only the columns in `places` of a table without names. Rows without a time are skipped. A decreasing time is an error.
fn part(
    file: &TextFile,
    table: &Table,
    mut all: Numbers,
    places: &[usize],
    time: Option<usize>,
) -> Result<Numbers> {
    if let Some(t) = time {
        let mut times = std::mem::take(&mut all.columns[t]);
        if let Some(row) = times.windows(2).position(|w| w[1] < w[0]) {
            // The rows of a table without names are assumed to be consecutive lines, so the line number follows from the row.
            let (after, time) = (times[row], times[row + 1]);
            let fault = ReadError::TimeBackwards { time, after };
            return Err(fault.at_line(file.path, table.start.line + row + 1));
        }
        if let Some(row) = times.iter().position(|t| t.is_nan()) {
            all.skipped.push(table.start.line + row);
            for column in &mut all.columns {
                let mut times = times.iter();
                column.retain(|_| times.next().is_some_and(|t| t.is_finite()));
            }
            times.retain(|t| t.is_finite());
        }
        all.columns[t] = times;
    }
    let columns = places.iter().map(|&i| std::mem::take(&mut all.columns[i]));
    all.columns = columns.collect();
    Ok(all)
}

/// Note that the rate given by the user replaces the rate of the time column, if the two rates differ.
fn overridden(times: &[f64], unit: Option<f64>, rate: f64) -> Option<Note> {
    let seconds: Vec<f64> = times.iter().map(|t| t * unit.unwrap_or(1.0)).collect();
    let own = TimeBase::from_times(&seconds).ok()?.rate_hz;
    ((own / rate - 1.0).abs() > 0.01).then_some(Note::RateOverridesTimes {
        rate: hertz(rate),
        column: hertz(own),
    })
}

/// Possible units of a time column without a unit: name and seconds per unit. The range contains the time steps, in this unit, for which
/// the unit is assumed.
const SMALL_UNITS: [(&str, f64, std::ops::RangeInclusive<f64>); 3] = [
    ("ms", 1e-3, 0.4..=60.0),
    ("us", 1e-6, 200.0..=60e3),
    ("ns", 1e-9, 200e3..=60e6),
];

/// Seconds per unit of a time column that gives no unit. A note describes the assumption.
fn guessed_unit(times: &[f64], key_rate: Option<f64>, note: &mut Option<Note>) -> f64 {
    let step = usual_step(times);
    if let Some(rate) = key_rate {
        // If the steps do not agree with the rate in the header, the unit of the times follows from this rate.
        let agrees = (step * rate - 1.0).abs() <= 0.5;
        return if agrees { 1.0 } else { 1.0 / (rate * step) };
    }
    let mut units = SMALL_UNITS.iter().filter(|_| times.len() > 20);
    let Some((unit, scale, _)) = units.find(|(.., steps)| steps.contains(&step)) else {
        return 1.0;
    };
    *note = Some(Note::TimeUnitGuessed { step, unit });
    *scale
}

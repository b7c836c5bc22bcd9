//! What a time column means: its unit, whether it counts samples, and the rate it gives.

use super::header::Table;
use super::raw::Raw;
use crate::error::{ReadError, Result};
use crate::quantity::{self, hertz};
use crate::read::columns::{bracketed, words};
use crate::read::timebase::{TimeBase, usual_step};
use crate::recording::{ClockSource, Note, ReadOptions};

/// Seconds per unit of a time column, if its name or the row of units gives it.
pub(in crate::read) fn time_unit(table: &Table, i: usize) -> Option<f64> {
    let name = table.names.get(i)?;
    let label = table.unit(i).or_else(|| bracketed(name).last());
    let last = words(name).pop();
    match label.or(last.as_deref())?.to_lowercase().as_str() {
        "s" | "sec" | "secs" | "seconds" => Some(1.0),
        "ms" => Some(1e-3),
        "us" | "µs" => Some(1e-6),
        "min" => Some(60.0),
        _ => None,
    }
}

/// The note that the user's rate takes the place of a time column that gives another.
fn overridden(raw: &Raw, rate: f64) -> Option<Note> {
    let times = raw.times.as_ref().filter(|_| !raw.counts)?;
    let scale = raw.time_unit.unwrap_or(1.0);
    let seconds: Vec<f64> = times.iter().map(|t| t * scale).collect();
    let own = TimeBase::from_times(&seconds).ok()?.rate_hz;
    ((own / rate - 1.0).abs() > 0.01).then_some(Note::RateOverridesTimes {
        rate: hertz(rate),
        column: hertz(own),
    })
}

/// The time base of raw columns: the user's rate, the time column, or the header's rate, in this order.
pub(super) fn time_base(
    raw: &Raw,
    options: &ReadOptions,
    key_rate: Option<f64>,
    notes: &mut Vec<Note>,
) -> Result<TimeBase> {
    if let Some(rate) = options.rate_hz {
        notes.extend(overridden(raw, rate));
        return Ok(TimeBase::even(rate, ClockSource::User));
    }
    let times = match &raw.times {
        Some(times) if !raw.counts => times,
        _ => {
            let rate = key_rate.ok_or(ReadError::NoRate)?;
            return Ok(TimeBase::even(rate, ClockSource::Header));
        }
    };
    if times.len() < 2 {
        let samples = times.len();
        return Err(ReadError::FewSamples { samples }.into());
    }
    let before = notes.len();
    let scale = match raw.time_unit {
        Some(unit) => unit,
        None => guessed_unit(times, key_rate, notes),
    };
    let seconds: Vec<f64>;
    let times = if scale == 1.0 {
        times
    } else {
        seconds = times.iter().map(|t| t * scale).collect();
        &seconds
    };
    let mut base = TimeBase::from_times(times)?;
    if notes.len() > before {
        base.source = ClockSource::GuessedTimes;
    }
    if let Some((count, at)) = base.missed {
        let first = quantity::seconds(at);
        notes.push(Note::SamplesMissing { count, first });
    }
    match key_rate {
        // Times are rounded; a stated rate that agrees is the exact one.
        Some(rate) if !base.is_uneven() && (rate / base.rate_hz - 1.0).abs() < 2e-3 => {
            Ok(TimeBase::even(rate, ClockSource::Header).starting_at(base.start_s))
        }
        Some(rate) if (rate / base.rate_hz - 1.0).abs() > 0.01 => {
            notes.push(Note::RatesDiffer {
                header: hertz(rate),
                column: hertz(base.rate_hz),
            });
            Ok(base)
        }
        _ => Ok(base),
    }
}

/// Seconds per unit of a time column without a unit.
fn guessed_unit(times: &[f64], key_rate: Option<f64>, notes: &mut Vec<Note>) -> f64 {
    let step = usual_step(times);
    match key_rate {
        // The column does not count seconds; the rate gives its unit.
        Some(rate) if (step * rate - 1.0).abs() > 0.5 => 1.0 / (rate * step),
        None if (0.4..=60.0).contains(&step) && times.len() > 20 => {
            notes.push(Note::MillisecondsGuessed { step });
            1e-3
        }
        _ => 1.0,
    }
}

//! What a time column means: its unit, whether it counts samples, and the rate it gives.

use super::raw::Raw;
use super::table::Table;
use crate::error::{Error, Result};
use crate::force::read::columns::{bracketed, words};
use crate::force::read::timebase::{TimeBase, usual_step};
use crate::force::recording::ReadOptions;

/// Seconds per unit of a time column, where its name or the row of units says it.
pub(super) fn time_unit(table: &Table, i: usize) -> Option<f64> {
    let row = table
        .units
        .get(i)
        .map(|u| u.trim_matches(['[', ']', '(', ')']));
    let label = row
        .filter(|u| !u.is_empty())
        .or_else(|| bracketed(&table.names[i]));
    let last = words(&table.names[i]).pop();
    match label.or(last.as_deref())?.to_lowercase().as_str() {
        "s" | "sec" | "secs" | "seconds" => Some(1.0),
        "ms" => Some(1e-3),
        "us" | "µs" => Some(1e-6),
        "min" => Some(60.0),
        _ => None,
    }
}

/// What to say where the user's rate takes the place of a time column that gives another.
fn overridden(raw: &Raw, rate: f64) -> Option<String> {
    let times = raw.times.as_ref().filter(|_| !raw.counts)?;
    let scale = raw.time_unit.unwrap_or(1.0);
    let seconds: Vec<f64> = times.iter().map(|t| t * scale).collect();
    let own = TimeBase::from_times(&seconds).ok()?.rate_hz;
    ((own / rate - 1.0).abs() > 0.01).then(|| {
        format!(
            "the rate given, {rate} Hz, takes the place of the time column, which gives {own:.2} Hz"
        )
    })
}

/// The time base of raw columns: the user's rate, the time column, or the header's rate, in this order.
pub(super) fn time_base(
    raw: &Raw,
    options: &ReadOptions,
    key_rate: Option<f64>,
    notes: &mut Vec<String>,
) -> Result<TimeBase> {
    if let Some(rate) = options.rate_hz {
        notes.extend(overridden(raw, rate));
        return Ok(TimeBase::even(rate));
    }
    let need_rate = || {
        Error::new("the file gives no time and no sampling rate")
            .help("give the rate with --rate, for example --rate \"1000 Hz\"")
    };
    let Some(times) = &raw.times else {
        return key_rate.map(TimeBase::even).ok_or_else(need_rate);
    };
    if raw.counts {
        return key_rate.map(TimeBase::even).ok_or_else(need_rate);
    }
    if times.len() < 2 {
        return Err(
            Error::new("one sample is not a recording").help("give at least one whole stance")
        );
    }
    let mut scale = raw.time_unit.unwrap_or(1.0);
    if raw.time_unit.is_none() {
        let step = usual_step(times);
        if let Some(rate) = key_rate.filter(|r| (step * r - 1.0).abs() > 0.5) {
            // The column counts something else than seconds; the rate says what.
            scale = 1.0 / (rate * step);
        } else if key_rate.is_none() && (0.4..=60.0).contains(&step) && times.len() > 20 {
            scale = 1e-3;
            notes.push(format!(
                "steps of {step} in the time column are taken for milliseconds"
            ));
        }
    }
    let seconds: Vec<f64>;
    let times = if scale == 1.0 {
        times
    } else {
        seconds = times.iter().map(|t| t * scale).collect();
        &seconds
    };
    let base = TimeBase::from_times(times)?;
    if let Some((count, at)) = base.missed {
        let (samples, are) = if count == 1 {
            ("sample", "is")
        } else {
            ("samples", "are")
        };
        notes.push(format!(
            "{count} {samples} {are} missing, the first near {at:.3} s; the rate counts the samples there are"
        ));
    }
    match key_rate {
        // Times are rounded; a stated rate that agrees is the exact one.
        Some(rate) if !base.is_uneven() && (rate / base.rate_hz - 1.0).abs() < 2e-3 => {
            Ok(TimeBase::even(rate))
        }
        Some(rate) if (rate / base.rate_hz - 1.0).abs() > 0.01 => {
            notes.push(format!(
                "the header says {rate} Hz, the time column {:.2} Hz; the times count",
                base.rate_hz
            ));
            Ok(base)
        }
        _ => Ok(base),
    }
}

//! Period of a log without cam angle, from the autocorrelation of its force.

use std::f64::consts::TAU;

use super::log::Log;
use crate::error::{LogError, Result};
use crate::units::{Dimension, Quantity};

/// Minimum number of whole cycles. It is required to separate noise and repeatable force.
pub(super) const LEAST_CYCLES: usize = 3;
/// Maximum change of the speed over the log, relative to the mean. With a larger change, the phase of harmonic 5 is undetermined, and the log is
/// rejected.
pub(super) const DRIFT: f64 = 0.01;
/// Number of equal time intervals per expected cycle in the search for the period.
const CELLS: usize = 64;
const RANGE: [f64; 2] = [0.55, 1.8];
/// Minimum autocorrelation for which a force counts as periodic.
const REPEATS: f64 = 0.5;
/// Length of a time step, divided by the mean of the other steps, above which the step is a pause of the recorder.
const PAUSE: f64 = 20.0;

/// Error for a log without a periodic force near this speed, rad/s.
pub(super) fn no_cycle(speed: f64) -> LogError {
    let speed = Quantity::new(speed, Dimension::AngularSpeed);
    LogError::NoCycle { speed }
}

/// Error for a speed that drifts. `parts` are the speeds of the first and the last part of the log, relative to `speed`, rad/s.
pub(super) fn drift(speed: f64, parts: [f64; 2]) -> LogError {
    let [first, last] = parts.map(|p| Quantity::new(p * speed, Dimension::AngularSpeed));
    LogError::Drift { first, last }
}

/// Period of the force of a log, s, near the expected period.
pub(super) fn period(log: &Log, time: &[f64], expected: f64) -> Result<f64> {
    let length = time[time.len() - 1] - time[0];
    if length < LEAST_CYCLES as f64 * RANGE[0] * expected {
        let (cycles, least) = (length / expected, LEAST_CYCLES);
        return Err(log.refused(LogError::Short { cycles, least }));
    }
    check_gaps(log, time, expected)?;
    let none = || log.refused(no_cycle(TAU / expected));
    // With fewer than two samples per cycle, no cycle is detectable, and the number of time intervals would be unlimited.
    if length / expected > 0.5 * time.len() as f64 {
        return Err(none());
    }
    let step = expected / CELLS as f64;
    let cells = cells(time, &log.columns.force, step);
    let near = |cells: &[f64]| {
        let [least, most] = RANGE.map(|r| (r * CELLS as f64) as usize);
        repeats(cells, least..=most.min(cells.len() * 2 / 3))
    };
    let whole = near(&cells).filter(|r| r.1 > REPEATS);
    let thirds = [0, 2].map(|k| near(&cells[k * cells.len() / 3..(k + 1) * cells.len() / 3]));
    if let [Some((early, a)), Some((late, b))] = thirds
        && a > REPEATS
        && b > REPEATS
        && (late - early).abs() > 2.0 * DRIFT * early
        && cells.len() / 3 > 2 * CELLS
    {
        let speeds = [early, late].map(|lag| TAU / (lag * step));
        return Err(log.refused(drift(1.0, speeds)));
    }
    let (mut lag, strength) = whole.ok_or_else(none)?;
    // The lag is determined more accurately over an increasing number of cycles.
    let mut cycles = 1.0;
    while 2.0 * cycles * lag < 0.8 * cells.len() as f64 {
        let middle = (2.0 * cycles * lag).round() as usize;
        match repeats(&cells, middle - 4..=middle + 4) {
            Some((next, r)) if r > 0.5 * strength => lag = next / (2.0 * cycles),
            _ => break,
        }
        cycles *= 2.0;
    }
    Ok(lag * step)
}

/// Rejects a log in which the recorder paused for more than one cycle.
fn check_gaps(log: &Log, time: &[f64], cycle: f64) -> Result<()> {
    let length = time[time.len() - 1] - time[0];
    let steps = time.windows(2).map(|t| t[1] - t[0]);
    let longest = (steps.enumerate()).max_by(|a, b| a.1.total_cmp(&b.1));
    let pause = longest.filter(|(_, step)| *step > cycle);
    let Some((at, step)) = pause else {
        return Ok(());
    };
    let others = (length - step) / (time.len() - 2) as f64;
    if step < PAUSE * others {
        return Ok(());
    }
    let cycle = 1 + ((time[at] - time[0]) / cycle) as usize;
    Err(log.refused(LogError::Gap {
        cycle,
        samples: 0.0,
    }))
}

/// Mean force in time intervals of equal length `step`, s. An interval without a sample has the value of the previous interval.
fn cells(time: &[f64], force: &[f64], step: f64) -> Vec<f64> {
    let count = ((time[time.len() - 1] - time[0]) / step) as usize + 1;
    let mut sums = vec![(0.0, 0.0); count];
    for (t, f) in time.iter().zip(force) {
        let cell = &mut sums[((t - time[0]) / step) as usize];
        (cell.0, cell.1) = (cell.0 + f, cell.1 + 1.0);
    }
    let mut last = force[0];
    let mut fill = |(sum, n): (f64, f64)| {
        last = if n > 0.0 { sum / n } else { last };
        last
    };
    sums.into_iter().map(&mut fill).collect()
}

/// Lag with the maximum autocorrelation of a force, in time intervals, and this autocorrelation. Of several lags with nearly the same
/// autocorrelation, the shortest is selected.
fn repeats(cells: &[f64], lags: std::ops::RangeInclusive<usize>) -> Option<(f64, f64)> {
    let mean = cells.iter().sum::<f64>() / cells.len() as f64;
    let correlation = |lag: usize| {
        let pairs = cells.iter().zip(cells.get(lag..).unwrap_or_default());
        let (mut ab, mut aa, mut bb) = (0.0, 0.0, 0.0);
        for (a, b) in pairs {
            let (a, b) = (a - mean, b - mean);
            (ab, aa, bb) = (ab + a * b, aa + a * a, bb + b * b);
        }
        ab / (aa * bb).sqrt().max(f64::MIN_POSITIVE)
    };
    let (from, to) = (*lags.start(), *lags.end());
    let all: Vec<f64> = (from..=to.max(from)).map(correlation).collect();
    let peak = |i: &usize| all[*i] >= all[*i - 1] && all[*i] >= all[*i + 1];
    let peaks: Vec<usize> = (1..all.len().saturating_sub(1)).filter(peak).collect();
    let most = peaks
        .iter()
        .map(|i| all[*i])
        .fold(f64::NEG_INFINITY, f64::max);
    let i = *peaks.iter().find(|i| all[**i] > most - 0.05 * most.abs())?;
    let [a, b, c] = [all[i - 1], all[i], all[i + 1]];
    let curve = a - 2.0 * b + c;
    let shift = if curve < 0.0 {
        0.5 * (a - c) / curve
    } else {
        0.0
    };
    Some(((from + i) as f64 + shift, b))
}

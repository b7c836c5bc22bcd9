//! Cycles of a log: their phases, and the harmonics of every cycle.
//!
//! A mean and harmonics are fitted to each cycle separately, by least squares at the times of its samples. The scatter of the fits over the cycles
//! measures the noise, whether or not it is correlated.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::log::Log;
use super::period::{DRIFT, LEAST_CYCLES, drift, no_cycle, period};
use crate::error::{LogError, Result};

/// Maximum number of harmonics that are fitted to a cycle.
pub(super) const MOST: usize = 24;
/// Minimum number of samples per cycle and harmonic. With fewer samples, the fit follows the noise.
const PER_HARMONIC: f64 = 2.5;
/// Range of the ratio of measured to expected speed. A ratio outside this range indicates that the angle column has another unit.
const SPEEDS: [f64; 2] = [1e-3, 1e3];
/// Change of the mean cycle within the log, relative to the alternating force, above which the log is rejected.
pub(super) const CHANGE: f64 = 0.05;
pub(super) const SURPRISE: f64 = 8.0;
/// Minimum diagonal entry of the Cholesky factor of a cycle's normal equations. Equal time steps give 0.7. An entry below the minimum
/// indicates a gap in the cycle.
const UNSEEN: f64 = 0.2;
/// Number of iterations in which the period is corrected by the phases of the cycles.
const ROUNDS: usize = 4;

/// Harmonics of one quantity in every cycle, and their mean: `[a₀, a₁, b₁, a₂, b₂ …]` of a₀ + Σ aₙ cos nφ + bₙ sin nφ.
#[derive(Debug, Clone, PartialEq)]
pub struct Averaged {
    /// Coefficients of every cycle, one list per cycle.
    pub each: Vec<Vec<f64>>,
    /// Mean of the coefficients over the cycles.
    pub mean: Vec<f64>,
}

/// Cycles of a log: mean speed, and harmonics of the measured quantities over each cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct Cycles {
    /// Mean speed of the cam, rad/s.
    pub speed: f64,
    /// Whether the phase φ is the cam angle. Otherwise φ is 2π times the fraction of the period since the first sample.
    pub by_angle: bool,
    /// Force over a cycle, N, as harmonics.
    pub force: Averaged,
    /// Speed of the cam over a cycle, rad/s, as harmonics.
    pub shaft: Option<Averaged>,
    /// Torque at the camshaft over a cycle, N·m, as harmonics.
    pub torque: Option<Averaged>,
    /// Phase lead, rad, as harmonics of the cam angle. The phase lead is 2π times the elapsed fraction of the period, minus the cam angle.
    pub lead: Option<Averaged>,
    /// Root mean square of the samples about the mean cycle, N.
    pub noise_rms: f64,
}

impl Averaged {
    /// Mean of cycles with equal numbers of harmonics.
    pub fn of(each: Vec<Vec<f64>>) -> Averaged {
        let count = each.len() as f64;
        let mean = (0..each[0].len())
            .map(|j| each.iter().map(|c| c[j]).sum::<f64>() / count)
            .collect();
        Averaged { each, mean }
    }

    /// The result of a linear map of every cycle, with the mean of the results.
    pub fn map(&self, map: impl Fn(&[f64]) -> Vec<f64>) -> Averaged {
        Averaged::of(self.each.iter().map(|cycle| map(cycle)).collect())
    }

    /// Variance of the mean of each coefficient, from the scatter over the cycles.
    pub fn variance(&self) -> Vec<f64> {
        let count = self.each.len() as f64;
        let of = |j: usize| {
            let square = |c: &Vec<f64>| (c[j] - self.mean[j]).powi(2);
            self.each.iter().map(square).sum::<f64>() / ((count - 1.0) * count)
        };
        (0..self.mean.len()).map(of).collect()
    }
}

impl Cycles {
    /// Determines the cycles of a log for a machine whose cam turns at about `speed`, rad/s. The force of the machine has `harmonics` harmonics.
    ///
    /// # Errors
    ///
    /// - The log is too short, has too few samples, or is not periodic.
    /// - The speed or the mean cycle changes within the log.
    pub fn of(log: &Log, speed: f64, harmonics: usize) -> Result<Cycles> {
        let (phases, speed) = phases(log, speed)?;
        let turns = span(&phases);
        let cycles = turns.floor() as usize;
        if cycles < LEAST_CYCLES {
            let least = LEAST_CYCLES;
            return Err(log.refused(LogError::Short {
                cycles: turns,
                least,
            }));
        }
        let samples = phases.len() as f64 / turns;
        let carried = (samples / PER_HARMONIC) as usize;
        if carried < harmonics {
            let needed = (PER_HARMONIC * harmonics as f64).ceil() as usize;
            return Err(log.refused(LogError::Aliased { samples, needed }));
        }
        let order = carried.min(MOST);
        let mut out = Fitted::of(log, &phases, cycles, order)?.cycles(speed, log);
        if log.columns.theta.is_none() {
            let mut phases = phases;
            for _ in 0..ROUNDS {
                let slope = out.slope();
                phases.iter_mut().for_each(|p| *p *= 1.0 + slope);
                let cycles = span(&phases).floor() as usize;
                let speed = out.speed * (1.0 + slope);
                out = Fitted::of(log, &phases, cycles, order)?.cycles(speed, log);
            }
            out.check_drift(log)?;
        }
        out.check_change(log)?;
        Ok(out)
    }

    /// Phase lead of every cycle relative to the mean cycle, rad.
    fn leads(&self) -> Vec<f64> {
        let mean = &self.force.mean;
        let slope = derivative(mean);
        let size: f64 = slope.iter().map(|x| x * x).sum();
        let lead = |c: &Vec<f64>| {
            let along = c
                .iter()
                .zip(mean)
                .zip(&slope)
                .map(|((c, m), d)| (c - m) * d);
            along.sum::<f64>() / size
        };
        self.force.each.iter().map(lead).collect()
    }

    /// Increase of the phase lead from cycle to cycle, in turns, by linear regression. It equals the relative error of the period.
    fn slope(&self) -> f64 {
        let leads = self.leads();
        let line = polynomial(&leads, 1);
        line[1] / TAU / leads.len() as f64
    }

    /// Rejects a log whose speed changes by more than the fraction `DRIFT`.
    fn check_drift(&self, log: &Log) -> Result<()> {
        let leads = self.leads();
        if leads.len() < 6 {
            return Ok(());
        }
        // φ = … + c x² with x = 0 … 1 over the log: the relative change of the speed is 2c/(2πK).
        let change = 2.0 * polynomial(&leads, 2)[2] / (TAU * leads.len() as f64);
        match change.abs() > DRIFT {
            true => Err(log.refused(drift(self.speed, [1.0 - 0.5 * change, 1.0 + 0.5 * change]))),
            false => Ok(()),
        }
    }

    /// Rejects a log whose mean cycle changes by more than the fraction `CHANGE` and more than the scatter explains.
    fn check_change(&self, log: &Log) -> Result<()> {
        let each = &self.force.each;
        let count = each.len();
        let mean = |of: &[Vec<f64>]| Averaged::of(of.to_vec()).mean;
        let distance = |a: &[f64], b: &[f64]| -> f64 {
            a.iter().zip(b).skip(1).map(|(a, b)| (a - b).powi(2)).sum()
        };
        let alternating: f64 = self.force.mean[1..].iter().map(|x| x * x).sum();
        for at in 2..count.saturating_sub(1) {
            let [before, after] = [mean(&each[..at]), mean(&each[at..])];
            let between = distance(&before, &after);
            let within: f64 = (each[..at].iter().map(|c| distance(c, &before)))
                .chain(each[at..].iter().map(|c| distance(c, &after)))
                .sum();
            let [a, b] = [at as f64, (count - at) as f64];
            let scatter = within / (count - 2) as f64 * (1.0 / a + 1.0 / b);
            if between > CHANGE * CHANGE * alternating && between > SURPRISE * scatter {
                let percent = 100.0 * (between / alternating).sqrt();
                return Err(log.refused(LogError::Changes { cycle: at, percent }));
            }
        }
        Ok(())
    }
}

/// Number of turns from the first sample to one time step after the last sample.
fn span(phases: &[f64]) -> f64 {
    let n = phases.len();
    let step = (phases[n - 1] - phases[0]) / (n - 1) as f64;
    (phases[n - 1] - phases[0] + step) / TAU
}

/// Phase of every sample, rad, and mean speed of the cam, rad/s.
fn phases(log: &Log, expected: f64) -> Result<(Vec<f64>, f64)> {
    let Some(theta) = &log.columns.theta else {
        let time = log.columns.time.as_deref().unwrap_or_default();
        let period = period(log, time, TAU / expected)?;
        let phase = |t: &f64| TAU * (t - time[0]) / period;
        return Ok((time.iter().map(phase).collect(), TAU / period));
    };
    let n = theta.len();
    let third = |part: [usize; 2]| {
        let [a, b] = part.map(|k| k * (n - 1) / 3);
        let mean = |s: &Vec<f64>| s[a..b].iter().sum::<f64>() / (b - a) as f64;
        let of_time = |t: &Vec<f64>| (theta[b] - theta[a]) / (t[b] - t[a]);
        log.columns
            .time
            .as_ref()
            .map(of_time)
            .or_else(|| log.columns.speed.as_ref().map(mean))
    };
    let speed = third([0, 3]).unwrap_or(expected);
    if !(SPEEDS[0]..=SPEEDS[1]).contains(&(speed / expected)) {
        return Err(log.refused(no_cycle(expected)));
    }
    if let (Some(early), Some(late)) = (third([0, 1]), third([2, 3]))
        && (late - early).abs() > DRIFT * speed
        && span(theta) >= 3.0 * LEAST_CYCLES as f64
    {
        return Err(log.refused(drift(1.0, [early, late])));
    }
    Ok((theta.clone(), speed))
}

/// Coefficients of the polynomial fitted by least squares to values at equal steps of [0, 1], in ascending powers.
fn polynomial(values: &[f64], degree: usize) -> Vec<f64> {
    let n = values.len();
    let a = DMatrix::from_fn(n, degree + 1, |i, k| (i as f64 / n as f64).powi(k as i32));
    let b = DVector::from_column_slice(values);
    let svd = a.svd(true, true);
    svd.solve(&b, 1e-12)
        .map_or_else(|_| vec![0.0; degree + 1], |x| x.as_slice().to_vec())
}

/// Derivative of a harmonic series with respect to the phase.
pub(super) fn derivative(harmonics: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; harmonics.len()];
    for n in 1..=harmonics.len() / 2 {
        let [a, b] = [harmonics[2 * n - 1], harmonics[2 * n]];
        (out[2 * n - 1], out[2 * n]) = (n as f64 * b, -(n as f64) * a);
    }
    out
}

/// Harmonic series whose value at φ is the value of the given series at φ + `shift`, rad.
pub(super) fn shifted(harmonics: &[f64], shift: f64) -> Vec<f64> {
    let mut out = harmonics.to_vec();
    for n in 1..=harmonics.len() / 2 {
        let (sin, cos) = libm::sincos(n as f64 * shift);
        let [a, b] = [harmonics[2 * n - 1], harmonics[2 * n]];
        (out[2 * n - 1], out[2 * n]) = (a * cos + b * sin, b * cos - a * sin);
    }
    out
}

/// Value of a harmonic series at a phase.
pub(super) fn value(harmonics: &[f64], phase: f64) -> f64 {
    let basis = basis(phase, harmonics.len());
    basis.iter().zip(harmonics).map(|(a, b)| a * b).sum()
}

/// Basis functions 1, cos φ, sin φ, cos 2φ … at a phase.
fn basis(phase: f64, count: usize) -> Vec<f64> {
    let mut out = Vec::with_capacity(count);
    out.push(1.0);
    let (s1, c1) = libm::sincos(phase);
    let (mut s, mut c) = (s1, c1);
    while out.len() < count {
        out.extend([c, s]);
        (c, s) = (c * c1 - s * s1, s * c1 + c * s1);
    }
    out
}

/// Phase lead at each sample, rad: 2π times the elapsed time in periods, minus the change of the cam angle. `None` unless the log contains
/// time and angle.
fn lead(log: &Log, phases: &[f64]) -> Option<Vec<f64>> {
    let (time, _) = log.columns.time.as_ref().zip(log.columns.theta.as_ref())?;
    let last = phases.len() - 1;
    let speed = (phases[last] - phases[0]) / (time[last] - time[0]);
    let of = |(t, x): (&f64, &f64)| speed * (t - time[0]) - (x - phases[0]);
    Some(time.iter().zip(phases).map(of).collect())
}

/// Harmonics of force, speed, torque and phase lead, fitted to every cycle.
struct Fitted {
    by_column: [Vec<Vec<f64>>; 4],
    noise_rms: f64,
}

impl Fitted {
    fn of(log: &Log, phases: &[f64], cycles: usize, order: usize) -> Result<Fitted> {
        let count = 2 * order + 1;
        let lead = lead(log, phases);
        let columns = [
            Some(&log.columns.force),
            log.columns.speed.as_ref(),
            log.columns.torque.as_ref(),
            lead.as_ref(),
        ];
        let mut by_column: [Vec<Vec<f64>>; 4] = Default::default();
        let mut from = 0;
        for cycle in 1..=cycles {
            let end = phases[0] + TAU * cycle as f64;
            let own = from..phases.partition_point(|p| *p < end);
            from = own.end;
            let samples = own.len() as f64;
            let mut normal = DMatrix::zeros(count, count);
            let mut right = DMatrix::zeros(count, 4);
            for i in own {
                let row = DVector::from_vec(basis(phases[i], count));
                normal.syger(1.0, &row, &row, 1.0);
                for (c, column) in columns.iter().enumerate() {
                    let Some(column) = column else { continue };
                    right.column_mut(c).axpy(column[i], &row, 1.0);
                }
            }
            let factor = (normal / samples.max(1.0)).cholesky();
            // If a cycle has a gap, its samples do not determine all unknowns.
            let sound = factor.filter(|f| f.l_dirty().diagonal().min() > UNSEEN);
            let factor = sound.ok_or_else(|| log.refused(LogError::Gap { cycle, samples }))?;
            let solved = factor.solve(&(right / samples));
            for (c, list) in by_column.iter_mut().enumerate() {
                list.push(solved.column(c).as_slice().to_vec());
            }
        }
        let force = Averaged::of(by_column[0].clone()).mean;
        let square = |(p, f): (&f64, &f64)| (f - value(&force, *p)).powi(2);
        let sum: f64 = phases[..from]
            .iter()
            .zip(&log.columns.force)
            .map(square)
            .sum();
        let noise_rms = (sum / from.saturating_sub(count).max(1) as f64).sqrt();
        Ok(Fitted {
            by_column,
            noise_rms,
        })
    }

    fn cycles(self, speed: f64, log: &Log) -> Cycles {
        let [force, shaft, torque, lead] = self.by_column.map(Averaged::of);
        Cycles {
            speed,
            by_angle: log.columns.theta.is_some(),
            force,
            shaft: log.columns.speed.as_ref().map(|_| shaft),
            torque: log.columns.torque.as_ref().map(|_| torque),
            lead: log
                .columns
                .theta
                .as_ref()
                .and(log.columns.time.as_ref())
                .map(|_| lead),
            noise_rms: self.noise_rms,
        }
    }
}

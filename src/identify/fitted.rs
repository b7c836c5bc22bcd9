//! Joint fit of several logs with the machine of a design. The logs share the parameters. Each log has its own phase.

use std::f64::consts::TAU;
use std::path::Path;

use super::cycles::Averaged;
use super::fit::{Fit, Shift, fit};
use super::least_squares::{Column, difference};
use super::log::Log;
use super::model::{Clock, Term, terms};
use super::period::DRIFT;
use super::run::{LONGEST_DELAY, Run};
use super::same_machine;
use crate::error::{LogError, Placed, Result};
use crate::scene::Scene;
use crate::synth::Design;

/// Relative difference below which two logs contain the same samples.
const SAME: f64 = 1e-9;

/// Several logs, and the parameters of the machine fitted to them.
pub(super) struct Fitted {
    pub runs: Vec<Run>,
    pub terms: Vec<Term>,
    /// Unknown phase shifts: first the common delay of the logs with an angle, s, then the phase of each log without an angle, rad.
    pub shifts: Vec<Shift>,
    pub fit: Fit,
}

impl Fitted {
    pub fn of(design: &Design, scene: &Scene, logs: &[Log]) -> Result<Fitted> {
        let runs = logs.iter().map(|log| Run::of(design, scene, log));
        let runs = runs.collect::<Result<Vec<Run>>>()?;
        if runs.is_empty() {
            let (rows, least) = (0, 1);
            return Err(LogError::FewRows { rows, least }.in_file(Path::new("log")));
        }
        check_copies(logs, &runs)?;
        let terms = terms(design, scene);
        let alone: Vec<Fit> = match runs.len() {
            1 => Vec::new(),
            _ => runs
                .iter()
                .map(|run| fitted(std::slice::from_ref(run), &[]).1)
                .collect(),
        };
        let (shifts, fit) = fitted(&runs, &alone);
        same_machine::check((design, scene), (logs, &runs), &terms, &fit, &alone)?;
        Ok(Fitted {
            runs,
            terms,
            shifts,
            fit,
        })
    }

    /// Whether the fit has a common delay of the logs as an unknown.
    pub fn has_delay(&self) -> bool {
        self.runs.iter().any(|run| run.cycles.by_angle)
    }

    /// Modelled force of the log `run` with the fitted parameters, as harmonics.
    pub fn modelled(&self, run: usize) -> Vec<f64> {
        let mut out = vec![0.0; self.fit.measured[run].mean.len()];
        for (column, found) in self.runs[run].columns.iter().zip(&self.fit.each) {
            (out.iter_mut().zip(&column.values)).for_each(|(x, c)| *x += found.value * c);
        }
        out
    }

    /// Index of the log whose speed is nearest to the speed of the design.
    pub fn nearest(&self, design: &Design) -> usize {
        let off = |i: &usize| (self.runs[*i].cycles.speed / design.problem.drive.speed - 1.0).abs();
        let all = 0..self.runs.len();
        all.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(0)
    }

    /// Measured cycles of all logs whose speed nearly equals the speed of the log `place`, as harmonics of the phase of this log.
    pub fn measured_at(&self, place: usize) -> Averaged {
        let near = |i: &usize| {
            let speed = |run: &Run| run.cycles.speed;
            (speed(&self.runs[*i]) / speed(&self.runs[place]) - 1.0).abs() <= DRIFT
        };
        let all: Vec<usize> = (0..self.runs.len()).filter(near).collect();
        if let [one] = all[..] {
            return self.fit.measured[one].clone();
        }
        let counts = all.iter().map(|i| self.fit.measured[*i].mean.len());
        let count = counts.min().unwrap_or(1);
        let clock = &self.runs[place].clock;
        let moved = |own: &Clock, c: &[f64]| clock.harmonics(&own.at_angles(c), count);
        let of_run = |i: usize| {
            let cycles = self.fit.measured[i].each.iter();
            cycles.map(move |c| moved(&self.runs[i].clock, c))
        };
        Averaged::of(all.into_iter().flat_map(of_run).collect())
    }
}

/// Unknown phase shifts of the logs, and the fit. `alone` contains the separate fit of each log if there are several logs.
fn fitted(runs: &[Run], alone: &[Fit]) -> (Vec<Shift>, Fit) {
    let column = |term: usize| Column {
        values: runs
            .iter()
            .flat_map(|run| run.columns[term].values.clone())
            .collect(),
        is_positive: runs[0].columns[term].is_positive,
    };
    let columns: Vec<Column> = (0..runs[0].columns.len()).map(column).collect();
    let delayed = |run: &Run| f64::from(u8::from(run.cycles.by_angle)) * run.cycles.speed;
    let rates: Vec<f64> = runs.iter().map(delayed).collect();
    let fastest = rates.iter().fold(0.0_f64, |m, r| m.max(*r));
    let delay = (fastest > 0.0).then(|| Shift {
        range: [0.0, LONGEST_DELAY.min(TAU / fastest)],
        rates,
    });
    let others = (0..runs.len()).filter(|i| !runs[*i].cycles.by_angle);
    let phase = |own: usize| Shift {
        range: runs[own].phases,
        rates: (0..runs.len())
            .map(|i| f64::from(u8::from(i == own)))
            .collect(),
    };
    let phases: Vec<Shift> = others.clone().map(phase).collect();
    let first = |own: usize| alone.get(own).map_or(0.0, |fit| fit.shifts[0].value);
    let start: Vec<f64> = (delay.iter().map(|_| 0.0))
        .chain(others.map(first))
        .collect();
    let shifts: Vec<Shift> = delay.into_iter().chain(phases).collect();
    let cycles: Vec<Averaged> = runs.iter().map(|run| run.cycles.force.clone()).collect();
    let fit = fit(&columns, &cycles, &shifts, &start);
    (shifts, fit)
}

/// Rejects a log that is given twice, even in different units.
fn check_copies(logs: &[Log], runs: &[Run]) -> Result<()> {
    let size = |x: &[f64]| x.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (i, (log, run)) in logs.iter().zip(runs).enumerate() {
        let own = &run.cycles.force.mean;
        let is_copy = |other: &&Run| {
            let mean = &other.cycles.force.mean;
            mean.len() == own.len()
                && size(&difference(mean, own)) <= SAME * size(own)
                && (other.cycles.speed / run.cycles.speed - 1.0).abs() <= SAME
        };
        if let Some(other) = runs[..i].iter().find(is_copy) {
            let other = other.name.clone();
            return Err(log.refused(LogError::Copy { other }));
        }
    }
    Ok(())
}

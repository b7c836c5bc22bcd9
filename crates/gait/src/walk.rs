//! Consecutive strides of a recording as one force over time, and the statistics of their variability.

use std::f64::consts::TAU;
use std::sync::Arc;

use serde::Serialize;

use crate::cycle::{BLEND, periodic};
use crate::interpretation::Interpretation;
use crate::statistics::{mean, sample_deviation};

/// Minimum number of consecutive strides of a walk.
pub const FEWEST_STRIDES: usize = 8;
/// Number of force samples per stride.
const OF_STRIDE: usize = 128;
/// Number of equally spaced times in a stride at which the force is evaluated to compute its harmonics.
const PHASES: usize = 64;
/// Number of harmonics of the step frequency that are computed.
const HARMONICS: usize = 4;
/// Maximum difference, s, between the end of a stride and the start of another stride, for which the strides count as consecutive.
const SAME_S: f64 = 1e-6;
/// The pace is considered to change if the mean stride times of the first and the last quarter of the strides differ by more than this
/// fraction.
const STEADY: f64 = 0.05;

/// Consecutive strides of a recording as one force over time, repeated periodically.
///
/// A run is an unbroken sequence of eight or more used strides. It begins and ends with a heel strike of the same foot. All runs of the
/// recording are joined. The parts between the runs (turns, standing, rejected strides) and shorter sequences are omitted.
///
/// ```
/// use gaitcam_gait::{Feet, ReadOptions, force_curve};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let walk = curve.walk.unwrap();
/// assert_eq!((walk.strides(), walk.runs.len()), (9, 1));
/// assert!((walk.step_frequency_hz() - 1.9).abs() < 0.005);
/// // The generated strides differ only by the noise of the plates.
/// assert!(walk.variability().step_time_cv < 0.02);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Walk {
    /// Recorded force of both feet, N, at equal steps of time from the first heel strike; 128 samples per stride.
    samples: Arc<[f64]>,
    /// Factor by which the recorded force is multiplied.
    factor: f64,
    /// Total duration of all strides, s.
    pub duration_s: f64,
    /// Number of strides of each unbroken run.
    pub runs: Vec<usize>,
    /// Times of the heel strikes, s. The first time is 0. The feet alternate, with two heel strikes per stride.
    pub steps_s: Vec<f64>,
    /// Whether only one foot was recorded. The other foot is then assumed to repeat its force half a stride later.
    pub is_one_foot: bool,
}

/// Statistics of the variability of consecutive strides.
///
/// ```
/// use gaitcam_gait::Walk;
///
/// // Ten strides of 1 s. The amplitude of the force is 100 N and 120 N in alternate strides.
/// let swing = |k: usize| if k % 2 == 0 { 100.0 } else { 120.0 };
/// let wave = |k: usize, t: f64| 700.0 + swing(k) * (2.0 * std::f64::consts::TAU * t).cos();
/// let strikes: Vec<[f64; 3]> = (0..10).map(|k| [0.0, 0.5, 1.0].map(|t| t + k as f64)).collect();
/// let varied = Walk::of(&strikes, false, wave).unwrap().variability();
/// assert!(varied.step_time_cv < 1e-12);
/// assert!((varied.amplitude_cv - 0.0958).abs() < 2e-3);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Variability {
    /// Total number of strides in all runs.
    pub strides: usize,
    /// Number of unbroken runs of strides.
    pub runs: usize,
    /// Mean duration of a step, s.
    pub step_time_s: f64,
    /// Standard deviation of the step time, relative to the mean step time. Deviations are from the mean step time of the same foot. If
    /// only one foot was recorded, stride times are used instead of step times.
    pub step_time_cv: f64,
    /// Coefficient of variation of the amplitude of the force at the step frequency. The amplitude is computed for each stride.
    pub amplitude_cv: f64,
    /// Coefficients of variation of the first four harmonic amplitudes. The first harmonic is at the step frequency.
    pub harmonics_cv: [f64; HARMONICS],
    /// Correlation coefficient of consecutive step times, computed from their deviations from the mean.
    pub autocorrelation: f64,
    /// Relative change of the stride time: mean of the last quarter of the strides minus mean of the first quarter, divided by the overall
    /// mean.
    pub drift: f64,
}

impl Interpretation {
    /// Number of strides in the longest unbroken run of strides that the mean cycle contains.
    pub fn longest_run(&self) -> usize {
        let used: Vec<_> = self
            .strides
            .iter()
            .filter(|s| s.rejected.is_none())
            .collect();
        let runs = used.chunk_by(|a, b| meets(a.to_s, b.from_s));
        runs.map(<[_]>::len).max().unwrap_or(0)
    }
}

/// Whether a stride that starts at `start`, s, immediately follows a stride that ends at `end`, s.
fn meets(end: f64, start: f64) -> bool {
    (start - end).abs() < SAME_S
}

impl Walk {
    /// Creates a walk from strides in order of time. Each stride has three times, s: its first heel strike, the heel strike of the other
    /// foot, and its end.
    ///
    /// `force` returns the force, N, for the index of a stride and a time, s. `None` without eight consecutive strides.
    pub fn of(
        strikes: &[[f64; 3]],
        is_one_foot: bool,
        force: impl Fn(usize, f64) -> f64,
    ) -> Option<Walk> {
        let all: Vec<(usize, [f64; 3])> = strikes.iter().copied().enumerate().collect();
        let follows = |a: &(usize, [f64; 3]), b: &(usize, [f64; 3])| meets(a.1[2], b.1[0]);
        let runs: Vec<_> = all
            .chunk_by(follows)
            .filter(|run| run.len() >= FEWEST_STRIDES)
            .collect();
        let used: Vec<&(usize, [f64; 3])> = runs.iter().copied().flatten().collect();
        let duration_s: f64 = used.iter().map(|(_, [from, _, to])| to - from).sum();
        let count = OF_STRIDE * used.len();
        let (mut force_n, mut steps_s) = (Vec::with_capacity(count), Vec::new());
        let mut since = 0.0;
        for (k, (index, [from, middle, to])) in used.iter().enumerate() {
            let last = k + 1 == used.len();
            steps_s.extend([since, since + middle - from]);
            while force_n.len() < count {
                let time = duration_s * force_n.len() as f64 / count as f64 - since;
                if time >= to - from && !last {
                    break;
                }
                force_n.push(force(*index, from + time));
            }
            since += to - from;
        }
        (!used.is_empty()).then(|| Walk {
            samples: force_n.into(),
            factor: 1.0,
            duration_s,
            runs: runs.iter().map(|run| run.len()).collect(),
            steps_s,
            is_one_foot,
        })
    }

    /// Number of strides in all runs.
    pub fn strides(&self) -> usize {
        self.runs.iter().sum()
    }

    /// Mean step frequency, Hz.
    pub fn step_frequency_hz(&self) -> f64 {
        2.0 * self.strides() as f64 / self.duration_s
    }

    /// The walk with its force multiplied by a factor.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Walk {
        Walk {
            factor: factor * self.factor,
            ..self
        }
    }

    /// Part of the walk with a given number of consecutive strides. Of all such parts, the part whose mean stride time is nearest to the
    /// mean of the whole walk is returned.
    ///
    /// The force is blended where the last stride is joined to the first one. `None` if the walk has fewer strides or `strides` is 0.
    pub fn typical(&self, strides: usize) -> Option<Walk> {
        let starts = self.strides_s();
        let usual = self.duration_s / self.strides() as f64;
        let off = |k: usize| ((starts[k + strides] - starts[k]) / strides as f64 - usual).abs();
        let last = self
            .strides()
            .checked_sub(strides)
            .filter(|_| strides > 0)?;
        let from = (0..=last).min_by(|a, b| off(*a).total_cmp(&off(*b)))?;
        let (start, end) = (starts[from], starts[from + strides]);
        let count = OF_STRIDE * strides;
        let length = end - start;
        let half = BLEND * length / strides as f64;
        let mut samples = vec![0.0; count];
        periodic(&mut samples, start, length, half, |t| self.at(t));
        let steps = &self.steps_s[2 * from..2 * (from + strides)];
        Some(Walk {
            samples: samples.into(),
            factor: 1.0,
            duration_s: length,
            runs: vec![strides],
            steps_s: steps.iter().map(|t| t - start).collect(),
            is_one_foot: self.is_one_foot,
        })
    }

    /// The walk with another force, N, at the same times.
    #[must_use]
    pub fn with_force(&self, force_n: &[f64]) -> Walk {
        Walk {
            samples: force_n.into(),
            factor: 1.0,
            ..self.clone()
        }
    }

    /// Number of samples of the force.
    pub fn samples(&self) -> usize {
        self.samples.len()
    }

    /// Force of both feet, N, at equal steps of time from the first heel strike; 128 samples per stride.
    pub fn force_n(&self) -> Vec<f64> {
        self.samples.iter().map(|f| self.factor * f).collect()
    }

    /// Times of the heel strikes at which the strides begin, and the end of the last stride, s.
    fn strides_s(&self) -> Vec<f64> {
        let starts = self.steps_s.iter().step_by(2).copied();
        starts.chain([self.duration_s]).collect()
    }

    /// Mean time from the start of a stride to the heel strike of the other foot, as a fraction of the stride.
    pub fn middle(&self) -> f64 {
        let strides = self.strides_s();
        let middles = self.steps_s.iter().skip(1).step_by(2);
        let parts = strides.windows(2).zip(middles);
        let parts: Vec<f64> = parts.map(|(s, m)| (m - s[0]) / (s[1] - s[0])).collect();
        mean(&parts)
    }

    /// Whether the stride time changes by more than 5 % from the first to the last quarter of the strides.
    pub fn changes_pace(&self) -> bool {
        self.variability().drift.abs() > STEADY
    }

    /// Statistics of the variability of the strides.
    pub fn variability(&self) -> Variability {
        let strides = self.strides_s();
        let times: Vec<f64> = strides.windows(2).map(|s| s[1] - s[0]).collect();
        let step_time_s = 0.5 * mean(&times);
        let steps = self.step_times();
        let feet = if self.is_one_foot { 1 } else { 2 };
        let off: Vec<Vec<f64>> = self
            .runs_of(&steps)
            .map(|run| about(run, &steps, feet))
            .collect();
        let (mut square, mut product, mut pairs) = (0.0, 0.0, 0);
        for run in &off {
            square += run.iter().map(|x| x * x).sum::<f64>();
            product += run.windows(2).map(|w| w[0] * w[1]).sum::<f64>();
            pairs += run.len() - 1;
        }
        let degrees = steps.len() - feet;
        let variance = square / steps.len() as f64;
        let step_time_cv = (square / degrees as f64).sqrt() / mean(&steps);
        let rows: Vec<[f64; HARMONICS]> = strides.windows(2).map(|s| self.harmonics(s)).collect();
        let cv = |h: usize| {
            let of: Vec<f64> = rows.iter().map(|row| row[h]).collect();
            sample_deviation(&of).unwrap_or(0.0) / mean(&of)
        };
        let harmonics_cv: [f64; HARMONICS] = std::array::from_fn(cv);
        let quarter = times.len() / 4;
        Variability {
            strides: times.len(),
            runs: self.runs.len(),
            step_time_s,
            step_time_cv,
            amplitude_cv: harmonics_cv[0],
            harmonics_cv,
            autocorrelation: if variance > 0.0 {
                product / pairs as f64 / variance
            } else {
                0.0
            },
            drift: (mean(&times[times.len() - quarter..]) - mean(&times[..quarter])) / mean(&times),
        }
    }

    /// Step times, s, alternating between the feet. If only one foot was recorded, they are stride times.
    fn step_times(&self) -> Vec<f64> {
        let every = if self.is_one_foot { 2 } else { 1 };
        let strikes = self.steps_s.iter().step_by(every).copied();
        let strikes: Vec<f64> = strikes.chain([self.duration_s]).collect();
        strikes.windows(2).map(|w| w[1] - w[0]).collect()
    }

    /// Ranges of indices in `steps`, one for each run.
    fn runs_of<'a>(
        &'a self,
        steps: &'a [f64],
    ) -> impl Iterator<Item = std::ops::Range<usize>> + 'a {
        let each = steps.len() / self.strides();
        self.runs.iter().scan(0, move |from, strides| {
            let start = *from;
            *from += each * strides;
            Some(start..*from)
        })
    }

    /// Amplitudes, N, of the first harmonics of the step frequency within a stride. `stride` contains the start and the end, s.
    fn harmonics(&self, stride: &[f64]) -> [f64; HARMONICS] {
        let (mut cosine, mut sine) = ([0.0; HARMONICS], [0.0; HARMONICS]);
        for i in 0..PHASES {
            let part = i as f64 / PHASES as f64;
            let force = self.at(stride[0] + part * (stride[1] - stride[0]));
            for (h, (a, b)) in (1..).zip(cosine.iter_mut().zip(&mut sine)) {
                let (s, c) = libm::sincos(2.0 * f64::from(h) * TAU * part);
                *a += force * c;
                *b += force * s;
            }
        }
        std::array::from_fn(|h| 2.0 * libm::hypot(cosine[h], sine[h]) / PHASES as f64)
    }

    /// Force, N, at a time of the walk, s, by linear interpolation between samples.
    fn at(&self, time: f64) -> f64 {
        let n = self.samples.len();
        let x = (time / self.duration_s).rem_euclid(1.0) * n as f64;
        let (i, u) = (x as usize, x.fract());
        let (a, b) = (self.samples[i % n], self.samples[(i + 1) % n]);
        self.factor * (a + u * (b - a))
    }
}

/// Deviations, s, of the step times in a range from the mean step time of the same foot. The feet alternate.
fn about(range: std::ops::Range<usize>, steps: &[f64], feet: usize) -> Vec<f64> {
    let of_foot = |foot: usize| {
        let own: Vec<f64> = steps.iter().skip(foot).step_by(feet).copied().collect();
        mean(&own)
    };
    let means: Vec<f64> = (0..feet).map(of_foot).collect();
    range.map(|i| steps[i] - means[i % feet]).collect()
}

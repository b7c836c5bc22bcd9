//! Mean cycle of several recordings of one movement: trials of one walker, or recordings of several walkers.

use std::f64::consts::SQRT_2;

use serde::Serialize;
use strum::VariantNames;

use crate::curve::ForceCurve;
use crate::cycle::Cycle;
use crate::error::{ForceError, Result};
use crate::quantity::{kilograms, seconds};
use crate::recording::{CycleSource, Foot, Kind, MassSource, Note, OpenQuestion};
use crate::stance::largest_group;
use crate::statistics::ends;
use crate::units::Quantity;

/// All recordings belong to one walker if their masses differ by less than this fraction.
const ONE_WALKER: f64 = 0.1;
/// Maximum deviation of the second heel strike of a stride from the middle of the stride, as a fraction of the stride.
const LIMP: f64 = 0.1;

/// Mean cycle of one recording, with its open questions, as input of a joint mean.
///
/// ```
/// use gaitcam_gait::{Feet, ReadOptions, Trial, cycle, joint_mean, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let mean = cycle(&recording, &stances(&recording), Feet::Both)?;
/// let trial = Trial { cycle: &mean, open: &[] };
/// // The same recording twice: the joint mean is the mean of the recording.
/// let joint = joint_mean(&[trial, Trial { cycle: &mean, open: &[] }])?;
/// assert!((joint.curve.mean_n() / mean.curve.mean_n() - 1.0).abs() < 1e-9);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Trial<'a> {
    /// Mean cycle of the trial.
    pub cycle: &'a Cycle,
    /// Open questions about the recording.
    pub open: &'a [OpenQuestion],
}

/// Reason why a recording is excluded from a joint mean.
///
/// ```
/// use gaitcam_gait::{Feet, LeftOut, OpenQuestion, ReadOptions, Trial, cycle, joint_mean, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let mean = cycle(&recording, &stances(&recording), Feet::Both)?;
/// let sure = Trial { cycle: &mean, open: &[] };
/// let unsure = Trial { cycle: &mean, open: &[OpenQuestion::Mass] };
/// let joint = joint_mean(&[sure, unsure])?;
/// assert_eq!(joint.left_out[0], None);
/// assert!(matches!(&joint.left_out[1], Some(LeftOut::Open { questions }) if questions == &[OpenQuestion::Mass]));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum LeftOut {
    /// A question about the kind of movement, the time base or the mass is open.
    Open {
        /// Open questions about the recording of the trial.
        questions: Vec<OpenQuestion>,
    },
    /// The movement differs from the movement of most recordings.
    OtherKind {
        /// Kind of movement in this recording.
        movement: Kind,
        /// Kind of movement in most recordings.
        most: Kind,
    },
    /// The stride duration differs from that of most recordings, so the speed differs as well.
    OtherSpeed {
        /// Duration of the stride in this recording.
        period: Quantity,
        /// Minimum stride duration in the mean.
        low: Quantity,
        /// Maximum stride duration in the mean.
        high: Quantity,
    },
    /// The recording is already a mean cycle, but other recordings are not.
    MeanAlready,
    /// The recording contains no cycle.
    NoCycle,
}

/// Mean cycle of several recordings.
///
/// ```
/// use gaitcam_gait::{Feet, ReadOptions, Trial, cycle, joint_mean, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let mean = cycle(&recording, &stances(&recording), Feet::Both)?;
/// let joint = joint_mean(&[Trial { cycle: &mean, open: &[] }, Trial { cycle: &mean, open: &[] }])?;
/// assert_eq!((joint.trials(), joint.cycles), (2, 2 * mean.averaged));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct JointMean {
    /// Mean cycle. Its spread is the standard deviation of all cycles, within and between recordings.
    pub curve: ForceCurve,
    /// Reason for the exclusion of each trial, in the order of the trials; `None` if the trial is included.
    pub left_out: Vec<Option<LeftOut>>,
    /// Force of each included trial, N, at the phases of the mean cycle, with the same scaling as the mean cycle.
    pub trials_n: Vec<Vec<f64>>,
    /// Number of cycles in the mean.
    pub cycles: usize,
    /// Kind of movement (walking, running, …) of the averaged recordings.
    pub kind: Kind,
    /// Standard deviation of the duration of a cycle, s, if there are several cycles.
    pub period_spread_s: Option<f64>,
    /// Coefficient of repeatability, N, defined as in [`Cycle`]; `None` for a single cycle.
    pub repeatability_n: Option<f64>,
    /// Mean mass over the cycles, kg.
    pub mass_kg: f64,
    /// Source of the masses; `None` if the source differs between recordings.
    pub mass_from: Option<MassSource>,
    /// Notes on the joint mean.
    pub notes: Vec<Note>,
}

impl JointMean {
    /// Number of recordings included in the mean.
    pub fn trials(&self) -> usize {
        self.left_out.iter().filter(|l| l.is_none()).count()
    }
}

/// Mean over the cycles of all trials with the most frequent movement, the most frequent stride duration, and no open questions.
///
/// The statistical weight of a trial is its number of cycles. If the masses belong to several walkers, the forces are averaged in body
/// weights and scaled to the mean mass.
///
/// # Errors
///
/// All trials are excluded.
pub fn joint_mean(trials: &[Trial]) -> Result<JointMean> {
    let open = |trial: &Trial| {
        let questions = trial.open.to_vec();
        (!questions.is_empty()).then_some(LeftOut::Open { questions })
    };
    let mut left_out: Vec<Option<LeftOut>> = trials.iter().map(open).collect();
    let kinds: Vec<Kind> = (kept(trials, &left_out).iter().map(|c| c.kind)).collect();
    let count = |kind: &Kind| kinds.iter().filter(|k| *k == kind).count();
    let Some(&most) = kinds.iter().max_by_key(|k| count(k)) else {
        let trials = trials.len();
        return Err(ForceError::NoJointMean { trials }.into());
    };
    leave_out(trials, &mut left_out, |cycle| {
        let movement = cycle.kind;
        (movement != most).then_some(LeftOut::OtherKind { movement, most })
    });
    let cycles = kept(trials, &left_out);
    let mut periods: Vec<f64> = cycles.iter().map(|c| c.curve.period_s).collect();
    periods.sort_by(f64::total_cmp);
    let (low, high, _) = largest_group(&periods);
    leave_out(trials, &mut left_out, |cycle| {
        let period = cycle.curve.period_s;
        let other = !(low..=high).contains(&period);
        let [period, low, high] = [period, low, high].map(seconds);
        other.then_some(LeftOut::OtherSpeed { period, low, high })
    });
    average(&kept(trials, &left_out), most, left_out)
}

/// Mean cycles of the trials that are not excluded so far.
fn kept<'a>(trials: &[Trial<'a>], left_out: &[Option<LeftOut>]) -> Vec<&'a Cycle> {
    let all = trials.iter().zip(left_out);
    all.filter(|(_, out)| out.is_none())
        .map(|(trial, _)| trial.cycle)
        .collect()
}

/// Excludes each remaining trial for whose cycle `reason` returns a reason.
fn leave_out(
    trials: &[Trial],
    left_out: &mut [Option<LeftOut>],
    reason: impl Fn(&Cycle) -> Option<LeftOut>,
) {
    for (trial, out) in trials.iter().zip(left_out) {
        *out = out.take().or_else(|| reason(trial.cycle));
    }
}

fn average(used: &[&Cycle], kind: Kind, left_out: Vec<Option<LeftOut>>) -> Result<JointMean> {
    let counts: Vec<f64> = used.iter().map(|c| cycles(c) as f64).collect();
    let weighted = |of: &dyn Fn(usize) -> f64| {
        let sum: f64 = counts.iter().enumerate().map(|(i, n)| n * of(i)).sum();
        sum / counts.iter().sum::<f64>()
    };
    let mass_kg = weighted(&|i| used[i].mass_kg);
    let period_s = weighted(&|i| used[i].curve.period_s);
    let mut notes = Vec::new();
    let masses: Vec<f64> = used.iter().map(|c| c.mass_kg).collect();
    let (low, high) = ends(&masses).unwrap_or_default();
    let several = high > (1.0 + ONE_WALKER) * low;
    if several {
        let (low, high, mean) = (kilograms(low), kilograms(high), kilograms(mass_kg));
        notes.push(Note::SeveralMasses { low, high, mean });
    }
    let (mut trials_n, mut spreads) = on_one_phase(used);
    if several {
        for (i, cycle) in used.iter().enumerate() {
            let scale = mass_kg / cycle.mass_kg;
            for x in trials_n[i].iter_mut().chain(&mut spreads[i]) {
                *x *= scale;
            }
        }
    }
    let samples = trials_n.first().map_or(0, Vec::len);
    let force: Vec<f64> = (0..samples)
        .map(|k| weighted(&|i| trials_n[i][k]))
        .collect();
    let spread = |k: usize| pooled(&counts, &|i| spreads[i][k], &|i| trials_n[i][k], force[k]);
    let spread_n: Option<Vec<f64>> = (0..samples).map(spread).collect();
    let mut curve = ForceCurve::from_samples("", period_s, force)?;
    curve.spread_n = spread_n;
    curve.mass_kg = Some(mass_kg);
    let period_spread_s = pooled(
        &counts,
        &|i| used[i].period.spread_s.unwrap_or(0.0),
        &|i| used[i].curve.period_s,
        period_s,
    );
    let from = used.first().map(|c| c.mass_from);
    Ok(JointMean {
        repeatability_n: curve.spread_rms_n().map(|s| 1.96 * SQRT_2 * s),
        curve,
        left_out,
        trials_n,
        cycles: counts.iter().sum::<f64>() as usize,
        kind,
        period_spread_s,
        mass_kg,
        mass_from: from.filter(|f| used.iter().all(|c| c.mass_from == *f)),
        notes,
    })
}

/// Standard deviation of all values in several groups, computed from the count, deviation and mean of each group; `None` for a single
/// value.
fn pooled(
    counts: &[f64],
    deviation: &dyn Fn(usize) -> f64,
    mean: &dyn Fn(usize) -> f64,
    all: f64,
) -> Option<f64> {
    let degrees = counts.iter().sum::<f64>() - 1.0;
    let squares = counts.iter().enumerate().map(|(i, n)| {
        let within = (n - 1.0) * deviation(i).powi(2);
        within + n * (mean(i) - all).powi(2)
    });
    (degrees > 0.0).then(|| (squares.sum::<f64>() / degrees).sqrt())
}

/// Number of cycles in a mean cycle. If a stride was built from single stances, this is the smaller number of stances of the two feet.
fn cycles(cycle: &Cycle) -> usize {
    match cycle.source {
        CycleSource::WholeStrides { strides, .. } | CycleSource::TotalForce { strides } => strides,
        CycleSource::RightAndLeft { right, left, .. } => right.min(left),
        CycleSource::TwoFeet { one, other, .. } => one.min(other),
        CycleSource::AnyFoot { stances, .. } | CycleSource::OneFoot { stances, .. } => stances,
    }
    .max(1)
}

/// Forces, N, and standard deviations, N (0 if unknown), of the cycles. All cycles are shifted to start at the same moment of the stride.
///
/// The reference is the first cycle that is not a total force. A cycle that begins with the other foot is shifted by about half a stride. A
/// total force has no heel strikes, so any shift is possible. Each shift is chosen so that the cycle is most similar to the reference.
fn on_one_phase(used: &[&Cycle]) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    let total = |c: &&&Cycle| matches!(c.source, CycleSource::TotalForce { .. });
    let first = used.iter().find(|c| !total(c)).or(used.first());
    let Some(reference) = first else {
        return (Vec::new(), Vec::new());
    };
    let start = foot(reference);
    let shifted = |cycle: &Cycle| {
        let force = &cycle.curve.force_n;
        let n = force.len();
        let zeros = || vec![0.0; n];
        let spread = cycle.curve.spread_n.clone().unwrap_or_else(zeros);
        let other_foot = start.zip(foot(cycle)).is_some_and(|(a, b)| a != b);
        let places = match (cycle.source, other_foot) {
            (CycleSource::TotalForce { .. }, _) => 0..n,
            (_, true) => {
                let most = (LIMP * n as f64) as usize;
                n / 2 - most..n / 2 + most
            }
            (_, false) => 0..1,
        };
        let shift = most_alike(&reference.curve.force_n, force, places);
        (rotated(force, shift), rotated(&spread, shift))
    };
    used.iter().map(|c| shifted(c)).unzip()
}

/// Foot whose heel strike starts a cycle of both feet; `None` if unknown.
fn foot(cycle: &Cycle) -> Option<Foot> {
    match cycle.source {
        CycleSource::WholeStrides { from, .. } => from,
        CycleSource::RightAndLeft { .. } => Some(Foot::Right),
        _ => None,
    }
}

/// Shift, in samples, within `shifts`, for which the periodic force `row` is most similar to `reference`.
fn most_alike(reference: &[f64], row: &[f64], shifts: std::ops::Range<usize>) -> usize {
    let likeness = |shift: usize| -> f64 {
        let later = row.iter().cycle().skip(shift);
        reference.iter().zip(later).map(|(a, b)| a * b).sum()
    };
    let first = shifts.start;
    let all = shifts.map(|s| (s, likeness(s)));
    all.max_by(|a, b| a.1.total_cmp(&b.1))
        .map_or(first, |best| best.0)
}

fn rotated(row: &[f64], shift: usize) -> Vec<f64> {
    let mut out = row.to_vec();
    let count = out.len().max(1);
    out.rotate_left(shift % count);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_pool_to_the_deviation_of_all_their_values() {
        let groups: [&[f64]; 3] = [&[1.0, 2.0, 4.0], &[3.0], &[5.0, 6.0]];
        let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
        let deviation = |v: &[f64]| {
            let m = mean(v);
            let square: f64 = v.iter().map(|x| (x - m).powi(2)).sum();
            (square / (v.len() as f64 - 1.0).max(1.0)).sqrt()
        };
        let all = groups.concat();
        let counts = groups.map(|g| g.len() as f64);
        let found = pooled(
            &counts,
            &|i| deviation(groups[i]),
            &|i| mean(groups[i]),
            mean(&all),
        );
        assert!((found.unwrap() - deviation(&all)).abs() < 1e-12);
        assert_eq!(pooled(&[1.0], &|_| 0.0, &|_| 7.0, 7.0), None);
    }

    #[test]
    fn a_row_that_starts_later_is_turned_back() {
        let row: Vec<f64> = (0..64)
            .map(|i| (std::f64::consts::TAU * f64::from(i) / 64.0).sin())
            .collect();
        let later = rotated(&row, 50);
        assert_eq!(most_alike(&row, &later, 0..64), 14);
        assert_eq!(rotated(&later, 14), row);
    }
}

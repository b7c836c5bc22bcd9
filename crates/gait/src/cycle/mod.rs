//! Mean cycle of a recording, with its step-to-step spread at each phase.
//!
//! If plates or insoles record whole strides, the forces of both feet are added and the strides are averaged. Otherwise, a stride is built
//! from single stances: the mean left stance and the mean right stance, half a stride apart.

mod average;
mod balance;
mod in_span;
mod interpret;
mod joint;
mod mass_interval;
mod overlay;
mod plausibility;
mod refusal;
mod single;
mod stride;
mod stride_time;
mod total;
mod warnings;

use std::f64::consts::SQRT_2;

pub(crate) use average::{BLEND, periodic};
use average::{Mean, MeanStance, place};
use balance::mean_total;
use mass_interval::mass_interval;
use refusal::no_stance;
use single::{both_feet, one_foot};
use stride::{averaged, recorded_strides, whole_strides};
use total::{total_of_plates, total_stride};
use warnings::{confirm_clock, warnings};

use crate::curve::{ForceCurve, SAMPLES};
use crate::error::Result;
use crate::interpretation::{Period, RecordedStride};
use crate::recording::{CycleSource, Feet, Foot, Kind, MassSource, Note, PeriodSource, Recording};
use crate::stance::{RejectReason, Rejected, Stance, Stances};
use crate::statistics::{mean, sample_deviation};
use crate::units::G;
use crate::walk::Walk;
use plausibility::{ADULT_KG, mean_of_weight, ranges};

pub use in_span::stance_in_span;
pub use joint::{JointMean, LeftOut, Trial, joint_mean};
pub use overlay::overlay;
pub use plausibility::implausible;

/// Mean cycle of a recording, and the method of its computation.
///
/// ```
/// use gaitcam_gait::{Feet, ReadOptions, cycle, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let mean = cycle(&recording, &stances(&recording), Feet::Both)?;
/// // No mass is given: it follows from the mean force.
/// assert!((mean.mean_of_weight - 1.0).abs() < 1e-9 && mean.mass_fits);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Cycle {
    /// Mean cycle. Its period is one stride, and its spread is the standard deviation from step to step.
    pub curve: ForceCurve,
    /// Number of averaged cycles. If a stride was built from single stances, it is the number of stances.
    pub averaged: usize,
    /// Method by which the cycle was computed.
    pub source: CycleSource,
    /// Duration of the cycle, and its source.
    pub period: Period,
    /// Coefficient of repeatability, N: in 95 of 100 cases, two cycles of this walker differ by less than this value. It is 1.96 √2 times
    /// the standard deviation (root mean square over the phases). `None` for a single cycle.
    pub repeatability_n: Option<f64>,
    /// Mass, kg: the given mass, or the mean force over the stride divided by g.
    pub mass_kg: f64,
    /// Source of the mass: the user, the file, the table of subjects, or the mean force.
    pub mass_from: MassSource,
    /// Interval that contains the mass in 95 of 100 recordings, kg, if the mass is computed from the mean force of calibrated plates.
    pub mass_interval_kg: Option<(f64, f64)>,
    /// All whole strides of both feet, used or not, in order of time.
    pub strides: Vec<RecordedStride>,
    /// Kind of movement (walking, running, …) in the cycle.
    pub kind: Kind,
    /// Mean force over the cycle, divided by the weight that the feet of the cycle carry; 1 for a correct mass.
    pub mean_of_weight: f64,
    /// Whether mean force and mass are consistent with a single walker.
    pub mass_fits: bool,
    /// Notes on values that are implausible for the movement.
    pub notes: Vec<Note>,
}

/// A mean cycle before its mass and plausibility are determined.
struct Average {
    period: Period,
    force_n: Vec<f64>,
    spread_n: Option<Vec<f64>>,
    averaged: usize,
    source: CycleSource,
    /// Note on contacts or steps that are excluded from the mean.
    note: Option<Note>,
    /// Consecutive strides of both feet; `None` for fewer than eight consecutive strides.
    walk: Option<Walk>,
}

impl Average {
    /// Mean of whole cycles with the given durations, s.
    fn of_cycles(cycles: Mean, durations: &[f64], from: PeriodSource, source: CycleSource) -> Self {
        let (force_n, spread_n) = cycles.finish();
        Average {
            period: Period {
                seconds: mean(durations),
                from,
                spread_s: sample_deviation(durations),
            },
            force_n,
            spread_n,
            averaged: durations.len(),
            source,
            note: None,
            walk: None,
        }
    }

    /// A stride that is the sum of mean stances, each of which starts at a given phase.
    fn of_stances(
        period: Period,
        stances: &[(&MeanStance, f64)],
        averaged: usize,
        source: CycleSource,
    ) -> Self {
        let (mut force_n, mut variance) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
        for (stance, phase) in stances {
            place(stance, period.seconds, *phase, &mut force_n, &mut variance);
        }
        let known = stances.iter().all(|(stance, _)| stance.spread.is_some());
        let deviations = || variance.iter().map(|v| v.sqrt()).collect();
        Average {
            period,
            force_n,
            spread_n: known.then(deviations),
            averaged,
            source,
            note: None,
            walk: None,
        }
    }
}

/// Averages the stances of a recording to one cycle.
///
/// `feet` selects the sum of both feet, the mean of all stances as one foot, only the left or right foot, or a column with the total force.
///
/// # Errors
///
/// There is no whole stance, or no whole stance of the requested side.
pub fn cycle(recording: &Recording, stances: &Stances, feet: Feet) -> Result<Cycle> {
    let kind = stances.kind.unwrap_or(Kind::Walking);
    let slow = recording.kind == Some(Kind::Walking);
    let ranges = ranges(kind, recording.mass_kg.unwrap_or(ADULT_KG.start), slow);
    let average = match feet {
        Feet::Both if stances.used.is_empty() => both_in_one(recording, stances, false)
            .or_else(|| crossed(recording, stances, 0))
            .ok_or_else(|| no_stance(recording, stances, feet))?,
        Feet::Total => both_in_one(recording, stances, true)
            .ok_or_else(|| no_stance(recording, stances, feet))?,
        _ if stances.used.is_empty() => return Err(no_stance(recording, stances, feet).into()),
        Feet::Both => {
            let strides = whole_strides(recording, stances);
            if let Some(total) = crossed(recording, stances, strides.len()) {
                total
            } else if strides.is_empty() {
                both_feet(recording, stances, &ranges)
            } else {
                averaged(recording, &strides)
            }
        }
        Feet::One => one_foot(recording, stances, None, &ranges)?,
        Feet::Left => one_foot(recording, stances, Some(Foot::Left), &ranges)?,
        Feet::Right => one_foot(recording, stances, Some(Foot::Right), &ranges)?,
    };
    finish(recording, stances, average, feet)
}

/// Cycle from a column that contains the total of both feet. `None` if jumping was recognised and the user stated no movement, or if
/// running was recognised and not requested.
fn both_in_one(recording: &Recording, stances: &Stances, stated: bool) -> Option<Average> {
    let jumps = stances.recognised == Some(Kind::Jumping) && recording.kind.is_none();
    let runs = stances.recognised == Some(Kind::Running) && !recording.runs();
    if jumps || runs {
        return None;
    }
    total_stride(recording, stances, stated)
}

/// Cycle from the sum of all plates, if feet cross between plates and less than half of the strides are whole.
fn crossed(recording: &Recording, stances: &Stances, whole: usize) -> Option<Average> {
    let both = |r: &Rejected| {
        matches!(
            r.reason,
            RejectReason::TwoPlates
                | RejectReason::CrossOver
                | RejectReason::Standing
                | RejectReason::Unlike
        )
    };
    if recording.insole || !stances.rejected.iter().any(both) {
        return None;
    }
    total_of_plates(recording, stances).filter(|total| total.averaged > 2 * whole)
}

/// Root mean square noise, N, of a mean over a number of cycles. A foot contributes noise only while it is on the ground.
fn noise(recording: &Recording, stances: &Stances, cycles: usize, feet: Feet) -> f64 {
    let squares: Vec<f64> = recording.live().map(|(_, c)| c.noise_n.powi(2)).collect();
    let durations: Vec<f64> = stances.used.iter().map(Stance::duration_s).collect();
    let on_ground = match durations.is_empty() {
        true => 1.0,
        false => ranges(stances.kind.unwrap_or(Kind::Walking), ADULT_KG.start, false).usual_duty,
    };
    let feet = 2.0 * feet.share() * on_ground;
    let mean = if squares.is_empty() {
        0.0
    } else {
        mean(&squares)
    };
    (feet * mean / cycles.max(1) as f64).sqrt()
}

/// Determines mass and repeatability of a mean cycle, and compares its mean force with the weight.
fn finish(recording: &Recording, stances: &Stances, average: Average, feet: Feet) -> Result<Cycle> {
    let period = average.period;
    let force_n = average.force_n.clone();
    let mut curve = ForceCurve::from_samples("", period.seconds, force_n)?;
    curve.spread_n.clone_from(&average.spread_n);
    curve.noise_n = Some(noise(recording, stances, average.averaged, feet));
    curve.walk.clone_from(&average.walk);
    let repeatability_n = curve.spread_rms_n().map(|s| 1.96 * SQRT_2 * s);
    let total = matches!(average.source, CycleSource::TotalForce { .. });
    let (mass_kg, mass_from) = match (recording.mass_kg, recording.mass_from) {
        (Some(m), from) => (m, from.unwrap_or(MassSource::File)),
        (None, _) => {
            let strides = matches!(average.source, CycleSource::WholeStrides { .. });
            let both = (!strides && !total).then(|| mean_total(recording, stances, period.seconds));
            let alone = curve.mean_n() / feet.share();
            (both.flatten().unwrap_or(alone) / G, MassSource::MeanForce)
        }
    };
    let counts = |n: &Note| matches!(n, Note::CountsScaled { .. });
    if recording.notes.iter().any(counts) && curve.mean_n() > 0.0 {
        curve = curve.scaled(feet.share() * mass_kg * G / curve.mean_n());
    }
    curve.mass_kg = Some(mass_kg);
    let warning = implausible(&curve, feet);
    let computed = mass_from == MassSource::MeanForce;
    let averages_strides = matches!(average.source, CycleSource::WholeStrides { .. });
    let strides = recorded_strides(recording, stances, averages_strides);
    let interval = || mass_interval(recording, stances, &average, &strides, mass_kg);
    let mass_interval_kg = computed.then(interval).flatten();
    let mut cycle = Cycle {
        averaged: average.averaged,
        source: average.source,
        period,
        repeatability_n,
        mass_kg,
        mass_from,
        mass_interval_kg,
        strides,
        kind: match stances.kind {
            Some(Kind::Running) => Kind::Running,
            _ => Kind::Walking,
        },
        mean_of_weight: mean_of_weight(&curve, feet).unwrap_or(1.0),
        mass_fits: warning.is_none(),
        notes: warning.into_iter().chain(average.note).collect(),
        curve,
    };
    let more = warnings(recording, stances, &cycle, total);
    cycle.notes.extend(more);
    confirm_clock(recording, &mut cycle)?;
    Ok(cycle)
}

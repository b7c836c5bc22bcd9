//! The mean cycle of a recording, on phase, with its step-to-step spread.
//!
//! Where the plates (or insoles) cover whole strides, both feet are summed and the strides averaged.
//! Elsewhere a stride is built from single stances: the mean left and the mean right one, half a stride apart.

mod average;
mod overlay;
mod refusal;
mod stride;
mod stride_time;
mod total;

use std::f64::consts::SQRT_2;

use average::{Mean, mean_stance, place};
use refusal::no_stance;
use stride::{Stride, alternate, sample_stride, whole_strides};
use stride_time::{median, stride_time};
use total::{TotalStride, total_stride};

use super::curve::{ForceCurve, SAMPLES};
use super::feet::Feet;
use super::kind::Kind;
use super::note::{CycleSource, MassSource, Note, PeriodSource, UnitSource};
use super::plausibility::{ADULT_KG, Ranges, implausible, mean_of_weight, out_of_range, ranges};
use super::quantity::{kilograms, seconds};
use super::recording::{Foot, Recording};
use super::stance::{Stance, Stances, same_foot};
use crate::error::{ForceError, Result};
use crate::units::{G, Quantity};

pub use overlay::{MeanStanceCurve, Overlay, overlay};
pub use stride_time::Period;

/// A stride whose duration is further than this from the middle one is not averaged.
const ODD_STRIDE: f64 = 0.25;

/// One mean cycle of a recording and how it was computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Cycle {
    /// The mean cycle; its period is a stride, its spread the standard deviation from step to step.
    pub curve: ForceCurve,
    /// Cycles that were averaged: whole strides, or stances where the stride was built from them.
    pub averaged: usize,
    /// How the cycle was computed.
    pub source: CycleSource,
    /// What its period was taken from.
    pub period_from: PeriodSource,
    /// Coefficient of repeatability, N: two cycles of this walker differ by less in 95 of 100 cases
    /// (1.96 √2 times the standard deviation, root mean square over the phases). `None` for one cycle.
    pub repeatability_n: Option<f64>,
    /// Mass, kg: given, or the mean force over the stride divided by g.
    pub mass_kg: f64,
    /// Where the mass is from.
    pub mass_from: MassSource,
    /// What the cycle is of.
    pub kind: Kind,
    /// Standard deviation of the strides that the period was taken from, s.
    pub period_spread_s: Option<f64>,
    /// Mean force over the cycle as a part of the weight that the feet of the cycle carry: 1 for a walker
    /// whose mass is right.
    pub mean_of_weight: f64,
    /// Whether mean force and mass can be of one walker.
    pub mass_fits: bool,
    /// What does not look right.
    pub notes: Vec<Note>,
}

/// A mean cycle before mass and plausibility are settled.
struct Average {
    period: Period,
    force_n: Vec<f64>,
    spread_n: Option<Vec<f64>>,
    averaged: usize,
    source: CycleSource,
}

/// Averages the stances of a recording into one cycle.
///
/// `feet`: both feet summed, one foot (all stances taken alike), or one side.
///
/// # Errors
///
/// Where there is no whole stance, or none of the wanted side.
pub fn cycle(recording: &Recording, stances: &Stances, feet: Feet) -> Result<Cycle> {
    let kind = stances.kind.unwrap_or(Kind::Walking);
    let slow = recording.kind == Some(Kind::Walking);
    let ranges = ranges(kind, recording.mass_kg.unwrap_or(ADULT_KG.start), slow);
    let average = match feet {
        Feet::Both if stances.used.is_empty() => both_in_one(recording, stances, false)
            .ok_or_else(|| no_stance(recording, stances, feet))?,
        Feet::Total => both_in_one(recording, stances, true)
            .ok_or_else(|| no_stance(recording, stances, feet))?,
        _ if stances.used.is_empty() => return Err(no_stance(recording, stances, feet).into()),
        Feet::Both => {
            let strides = whole_strides(stances);
            if strides.is_empty() {
                built(recording, stances, &ranges)
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

/// The total of both feet in one column, unless what stands there is another movement.
fn both_in_one(recording: &Recording, stances: &Stances, stated: bool) -> Option<Average> {
    let jumps = stances.recognised == Some(Kind::Jumping) && recording.kind.is_none();
    let runs = stances.recognised == Some(Kind::Running) && !recording.runs();
    if jumps || runs {
        return None;
    }
    total_stride(recording, stances, stated).map(of_total)
}

fn of_total(total: TotalStride) -> Average {
    Average {
        period: Period {
            seconds: total.period_s,
            from: PeriodSource::TotalForce,
            spread_s: total.period_spread_s,
        },
        force_n: total.force_n,
        spread_n: total.spread_n,
        averaged: total.strides,
        source: CycleSource::TotalForce {
            strides: total.strides,
        },
    }
}

/// Mean of whole strides that begin with the same foot.
fn averaged(recording: &Recording, strides: &[Stride]) -> Average {
    let (kept, from) = like_strides(strides);
    let mut mean = Mean::new();
    let mut row = vec![0.0; SAMPLES];
    for stride in &kept {
        sample_stride(recording, stride, &mut row);
        mean.add(&row);
    }
    let n = kept.len();
    let durations: Vec<f64> = kept.iter().map(|s| s.end_s - s.start_s).collect();
    let (force_n, spread_n) = mean.finish();
    Average {
        period: Period {
            seconds: durations.iter().sum::<f64>() / n as f64,
            from: PeriodSource::HeelStrikes,
            spread_s: stride_time::deviation_of(&durations),
        },
        force_n,
        spread_n,
        averaged: n,
        source: CycleSource::WholeStrides { strides: n, from },
    }
}

/// Strides of usual duration that begin with the same foot, and that foot.
///
/// Strides from left to left and from right to right share their samples; one kind is averaged.
fn like_strides(strides: &[Stride]) -> (Vec<&Stride>, Option<Foot>) {
    let durations = strides.iter().map(|s| s.end_s - s.start_s).collect();
    let usual = median(durations).unwrap_or(0.0);
    let usual_length = |s: &&Stride| ((s.end_s - s.start_s) / usual - 1.0).abs() < ODD_STRIDE;
    let of = |foot: Option<Foot>| -> Vec<&Stride> {
        let usual = strides.iter().filter(usual_length);
        usual.filter(|s| s.foot == foot).collect()
    };
    let best = [Some(Foot::Right), Some(Foot::Left), None]
        .into_iter()
        .max_by_key(|f| of(*f).len())
        .unwrap_or(None);
    let kept = of(best);
    match best {
        Some(_) => (kept, best),
        // Sides unknown: neighbours in the list alternate, every other one starts with the same foot.
        None => (alternate(&kept), None),
    }
}

/// A stride of both feet built from single stances half a stride apart.
fn built(recording: &Recording, stances: &Stances, ranges: &Ranges) -> Average {
    let all: Vec<&Stance> = stances.used.iter().collect();
    let (left, right) = by_side(&all, recording);
    let (left, right) = (fellows(left), fellows(right));
    let sides = !left.is_empty() && !right.is_empty();
    let (first, second) = if sides {
        (
            mean_stance(recording, &right),
            mean_stance(recording, &left),
        )
    } else {
        (mean_stance(recording, &all), mean_stance(recording, &all))
    };
    let impulse = first.impulse_ns + second.impulse_ns;
    let period = stride_time(recording, stances, impulse, &first, ranges);
    let (period_s, from) = (period.seconds, period.from);
    let (mut force_n, mut variance) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
    place(&first, period_s, 0.0, &mut force_n, &mut variance);
    place(&second, period_s, 0.5, &mut force_n, &mut variance);
    let known = first.spread.is_some() && second.spread.is_some();
    let named = all.iter().any(|s| s.foot.is_some());
    let source = match (sides, named) {
        (true, true) => CycleSource::RightAndLeft {
            right: first.count,
            left: second.count,
            period: from,
        },
        (true, false) => CycleSource::TwoFeet {
            one: first.count,
            other: second.count,
            period: from,
        },
        (false, _) => CycleSource::AnyFoot {
            stances: all.len(),
            period: from,
        },
    };
    Average {
        period,
        force_n,
        spread_n: known.then(|| roots(&variance)),
        averaged: all.len(),
        source,
    }
}

fn roots(variance: &[f64]) -> Vec<f64> {
    variance.iter().map(|v| v.sqrt()).collect()
}

/// The stances that are like their fellows; all, where none is.
fn fellows(stances: Vec<&Stance>) -> Vec<&Stance> {
    let alike: Vec<&Stance> = stances.iter().copied().filter(|s| !s.unlike).collect();
    if alike.is_empty() { stances } else { alike }
}

/// Stances of the left and of the right foot; where no side is known, of the one and of the other.
///
/// Without sides the feet are told apart by turns, as far as the stances follow each other; the rows of a
/// table of stances do not.
fn by_side<'a>(
    stances: &[&'a Stance],
    recording: &Recording,
) -> (Vec<&'a Stance>, Vec<&'a Stance>) {
    let of = |foot| {
        stances
            .iter()
            .copied()
            .filter(|s| s.foot == Some(foot))
            .collect()
    };
    if stances.iter().any(|s| s.foot.is_some()) {
        return (of(Foot::Left), of(Foot::Right));
    }
    let mut sides = (Vec::new(), Vec::new());
    if recording.has_rows() {
        return sides;
    }
    let mut first = true;
    for (i, s) in stances.iter().enumerate() {
        let same = i.checked_sub(1).map_or(Some(true), |j| {
            same_foot(&stances[j].into(), &(*s).into(), recording.runs())
        });
        match same {
            Some(same) => first = first == same,
            None => return (Vec::new(), Vec::new()),
        }
        if first { &mut sides.1 } else { &mut sides.0 }.push(*s);
    }
    sides
}

/// One foot over a stride, zero in swing.
fn one_foot(
    recording: &Recording,
    stances: &Stances,
    foot: Option<Foot>,
    ranges: &Ranges,
) -> Result<Average> {
    let wanted: Vec<&Stance> = stances
        .used
        .iter()
        .filter(|s| foot.is_none() || s.foot == foot)
        .collect();
    if let (Some(foot), true) = (foot, wanted.is_empty()) {
        let named = stances.used.iter().any(|s| s.foot.is_some());
        let foot = foot.name();
        return Err(if named {
            ForceError::NoStanceOfFoot { foot }.into()
        } else {
            ForceError::FeetNotNamed { foot }.into()
        });
    }
    let wanted = fellows(wanted);
    let mean = mean_stance(recording, &wanted);
    let period = stride_time(recording, stances, 2.0 * mean.impulse_ns, &mean, ranges);
    let (period_s, from) = (period.seconds, period.from);
    let (mut force_n, mut variance) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
    place(&mean, period_s, 0.0, &mut force_n, &mut variance);
    Ok(Average {
        period,
        force_n,
        spread_n: mean.spread.is_some().then(|| roots(&variance)),
        averaged: wanted.len(),
        source: CycleSource::OneFoot {
            stances: wanted.len(),
            period: from,
        },
    })
}

/// Settles mass and repeatability of a mean cycle and compares its mean force with the weight.
fn finish(recording: &Recording, stances: &Stances, average: Average, feet: Feet) -> Result<Cycle> {
    let Average {
        period,
        force_n,
        spread_n,
        averaged,
        source,
    } = average;
    let mut curve = ForceCurve::from_samples("", period.seconds, force_n)?;
    let repeatability_n = spread_n.as_ref().map(|s: &Vec<f64>| {
        let square = s.iter().map(|x| x * x).sum::<f64>() / s.len() as f64;
        1.96 * SQRT_2 * square.sqrt()
    });
    let (mass_kg, mass_from) = match (recording.mass_kg, recording.mass_from) {
        (Some(m), from) => (m, from.unwrap_or(MassSource::File)),
        (None, _) => (curve.mean_n() / (feet.share() * G), MassSource::MeanForce),
    };
    curve.spread_n = spread_n;
    let counts = |n: &Note| matches!(n, Note::CountsScaled { .. });
    if recording.notes.iter().any(counts) && curve.mean_n() > 0.0 {
        curve = curve.scaled(feet.share() * mass_kg * G / curve.mean_n());
    }
    curve.mass_kg = Some(mass_kg);
    let warning = implausible(&curve, feet);
    let total = matches!(source, CycleSource::TotalForce { .. });
    let mut cycle = Cycle {
        averaged,
        source,
        period_from: period.from,
        period_spread_s: period.spread_s,
        repeatability_n,
        mass_kg,
        mass_from,
        kind: match stances.kind {
            Some(Kind::Running) => Kind::Running,
            _ => Kind::Walking,
        },
        mean_of_weight: mean_of_weight(&curve, feet).unwrap_or(1.0),
        mass_fits: warning.is_none(),
        notes: warning.into_iter().collect(),
        curve,
    };
    let more = warnings(recording, stances, &cycle, total);
    cycle.notes.extend(more);
    confirm_clock(recording, &mut cycle)?;
    Ok(cycle)
}

/// What a person should know of a mean cycle beside its mass.
fn warnings(recording: &Recording, stances: &Stances, cycle: &Cycle, total: bool) -> Vec<Note> {
    let mut notes = Vec::new();
    if let CycleSource::AnyFoot { stances, .. } = cycle.source {
        // What changes the whole curve comes before what was guessed.
        notes.push(Note::OneFootForBoth { stances });
    }
    notes.extend(stances.notes.iter().cloned());
    let period_s = cycle.curve.period_s;
    if cycle.period_from == PeriodSource::UsualDuty {
        let period = seconds(period_s);
        notes.push(Note::StrideAssumed { period });
    }
    let used: Vec<&Stance> = stances.used.iter().filter(|s| !s.unlike).collect();
    let mean = |of: fn(&Stance) -> f64| {
        let sum = used.iter().map(|s| of(s)).sum::<f64>();
        (!used.is_empty() && !total).then(|| sum / used.len() as f64)
    };
    // Subjects of a table differ in mass; each has its own peak.
    let peak_n = mean(Stance::peak_n).filter(|_| !recording.has_rows());
    let slow = recording.kind == Some(Kind::Walking);
    let ranges = ranges(cycle.kind, cycle.mass_kg, slow);
    let stance_s = mean(Stance::duration_s);
    notes.extend(out_of_range(
        &ranges,
        period_s,
        cycle.mass_kg,
        stance_s,
        peak_n,
    ));
    if total {
        notes.push(Note::TotalColumn);
    }
    notes.extend(differ(recording, &used, cycle));
    notes.extend(mass_is_guessed(recording, cycle));
    notes
}

/// What a mass that follows from the mean force depends on.
fn mass_is_guessed(recording: &Recording, cycle: &Cycle) -> Vec<Note> {
    let mut notes = Vec::new();
    let mass = kilograms(cycle.mass_kg);
    if recording.mass_kg.is_some() {
        return notes;
    }
    if recording.is_insole() {
        notes.push(Note::InsoleMass { mass });
    }
    if recording.unit_from == UnitSource::Guessed && !ADULT_KG.contains(&cycle.mass_kg) {
        let unit = recording.unit;
        notes.push(Note::UnitUnconfirmed { unit, mass });
    }
    notes
}

/// Part of the weight by which stances may differ, and part of the mean impulse by which the feet may.
const DIFFERENCE: f64 = 0.2;

/// Part by which impulse or peak of one of a few stances may be off the middle ones.
const OFF: f64 = 0.1;
/// Stances that are few.
const FEW: usize = 6;

/// How far the impulse or the highest force of a stance is from the middle one, as a part of it.
fn off_fellows(used: &[&Stance]) -> f64 {
    let worst = |of: fn(&Stance) -> f64| {
        let all: Vec<f64> = used.iter().map(|s| of(s)).collect();
        let usual = median(all.clone()).unwrap_or(1.0);
        all.iter()
            .map(|x| (x / usual - 1.0).abs())
            .fold(0.0, f64::max)
    };
    worst(|s| s.impulse_ns).max(worst(Stance::peak_n))
}

/// Stances, or the impulses of the two feet, that differ more than those of a walker on whole plates.
fn differ(recording: &Recording, used: &[&Stance], cycle: &Cycle) -> Option<Note> {
    if recording.has_rows() || recording.is_insole() {
        return None;
    }
    let spread = cycle.curve.spread_n.as_ref().map_or(0.0, |s| {
        let square = s.iter().map(|x| x * x).sum::<f64>() / s.len() as f64;
        square.sqrt() / (cycle.mass_kg * G)
    });
    let (left, right) = by_side(used, recording);
    let impulse = |side: &[&Stance]| {
        let sum = side.iter().map(|s| s.impulse_ns).sum::<f64>();
        sum / side.len() as f64
    };
    let feet = if left.is_empty() || right.is_empty() {
        0.0
    } else {
        let (l, r) = (impulse(&left), impulse(&right));
        2.0 * (l - r).abs() / (l + r)
    };
    // Few stances have no average to hide in: one that is off its fellows is a partial contact.
    let few = (3..=FEW).contains(&used.len());
    let off = if few { off_fellows(used) } else { 0.0 };
    let share = spread.max(feet).max(if off > OFF {
        off.max(DIFFERENCE + 1e-9)
    } else {
        0.0
    });
    (share > DIFFERENCE).then(|| Note::StancesDiffer {
        share: Quantity::share(share),
    })
}

/// Whether the stride confirms a clock that was guessed.
///
/// # Errors
///
/// Where it shows that the guess is wrong.
fn confirm_clock(recording: &Recording, cycle: &mut Cycle) -> Result<()> {
    let guessed = recording.notes.iter().find_map(|n| match n {
        Note::MillisecondsGuessed { step } => Some(*step),
        _ => None,
    });
    let Some(step) = guessed else {
        return Ok(());
    };
    let clock = |n: &Note| {
        matches!(
            n,
            Note::StrideImplausible { .. } | Note::DutyImplausible { .. }
        )
    };
    let period = seconds(cycle.curve.period_s);
    if cycle.notes.iter().any(clock) {
        return Err(ForceError::ClockImplausible { period }.into());
    }
    // Samples are counted in ones; so are milliseconds at 1000 Hz.
    if (step - 1.0).abs() < 1e-6 {
        let stride = period;
        cycle.notes.push(Note::CountOrMilliseconds { stride });
    }
    Ok(())
}

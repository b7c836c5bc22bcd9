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
use std::path::Path;

use average::{Mean, mean_stance, place};
use refusal::no_stance;
use stride::{Stride, alternate, sample_stride, whole_strides};
use stride_time::{has_rows, median, stride_time};
use total::{TotalStride, total_stride};

use super::curve::{ForceCurve, SAMPLES};
use super::feet::Feet;
use super::note::{CycleSource, MassSource, Note, PeriodSource};
use super::plausibility::{implausible, mean_of_weight, unlike_walking};
use super::quantity::{kilograms, seconds};
use super::read::{one_cycle, read};
use super::recording::{Foot, ReadOptions, Recording};
use super::stance::{Stance, Stances, same_foot, stances};
use crate::error::{ForceError, Place, Result};
use crate::units::G;

pub use overlay::{Overlay, overlay};

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
    period_s: f64,
    period_from: PeriodSource,
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
    let average = match feet {
        Feet::Both if stances.used.is_empty() => total_stride(recording, stances)
            .map(of_total)
            .ok_or_else(|| no_stance(recording, stances, feet))?,
        _ if stances.used.is_empty() => return Err(no_stance(recording, stances, feet).into()),
        Feet::Both => {
            let strides = whole_strides(stances);
            if strides.is_empty() {
                built(recording, stances)
            } else {
                averaged(recording, &strides)
            }
        }
        Feet::One => one_foot(recording, stances, None)?,
        Feet::Left => one_foot(recording, stances, Some(Foot::Left))?,
        Feet::Right => one_foot(recording, stances, Some(Foot::Right))?,
    };
    finish(recording, stances, average, feet)
}

/// Reads one cycle of force from any file that [`read`](super::read) takes.
///
/// A text whose comment says `# cycle` or `# critical points` is one cycle as it stands, whatever `feet` says;
/// in every other file stances are found and averaged into a stride.
///
/// # Errors
/// No stance or no whole stride in the recording, or a cycle without force.
pub fn force_curve(
    path: &Path,
    bytes: &[u8],
    options: &ReadOptions,
    feet: Feet,
) -> Result<ForceCurve> {
    if let Some(curve) = one_cycle(path, bytes, options)? {
        return Ok(curve);
    }
    let recording = read(path, bytes, options)?;
    let mean = cycle(&recording, &stances(&recording), feet)
        .map_err(|e| e.at(Place::File(path.to_path_buf())))?;
    let file = path
        .file_name()
        .and_then(|n| n.to_str())
        .unwrap_or("recording");
    let mut curve = mean.curve;
    curve.name = format!("{file}, {}", mean.source);
    if let CycleSource::AnyFoot { stances, .. } = mean.source {
        // What changes the whole curve comes before what was guessed.
        curve.notes.insert(0, Note::OneFootForBoth { stances });
    }
    Ok(curve)
}

fn of_total(total: TotalStride) -> Average {
    Average {
        period_s: total.period_s,
        period_from: PeriodSource::TotalForce,
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
    let mut period = 0.0;
    let mut row = vec![0.0; SAMPLES];
    for stride in &kept {
        sample_stride(recording, stride, &mut row);
        mean.add(&row);
        period += stride.end_s - stride.start_s;
    }
    let n = kept.len();
    let (force_n, spread_n) = mean.finish();
    Average {
        period_s: period / n as f64,
        period_from: PeriodSource::HeelStrikes,
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
fn built(recording: &Recording, stances: &Stances) -> Average {
    let all: Vec<&Stance> = stances.used.iter().collect();
    let (left, right) = by_side(&all, has_rows(recording));
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
    let (period_s, period) = stride_time(recording, stances, impulse, &first);
    let (mut force_n, mut variance) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
    place(&first, period_s, 0.0, &mut force_n, &mut variance);
    place(&second, period_s, 0.5, &mut force_n, &mut variance);
    let known = first.spread.is_some() && second.spread.is_some();
    let named = all.iter().any(|s| s.foot.is_some());
    let source = match (sides, named) {
        (true, true) => CycleSource::RightAndLeft {
            right: first.count,
            left: second.count,
            period,
        },
        (true, false) => CycleSource::TwoFeet {
            one: first.count,
            other: second.count,
            period,
        },
        (false, _) => CycleSource::AnyFoot {
            stances: all.len(),
            period,
        },
    };
    Average {
        period_s,
        period_from: period,
        force_n,
        spread_n: known.then(|| roots(&variance)),
        averaged: all.len(),
        source,
    }
}

fn roots(variance: &[f64]) -> Vec<f64> {
    variance.iter().map(|v| v.sqrt()).collect()
}

/// Stances of the left and of the right foot; where no side is known, of the one and of the other.
///
/// Without sides the feet are told apart by turns, as far as the stances follow each other; the `rows` of a
/// table of stances do not.
fn by_side<'a>(stances: &[&'a Stance], rows: bool) -> (Vec<&'a Stance>, Vec<&'a Stance>) {
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
    if rows {
        return sides;
    }
    let mut first = true;
    for (i, s) in stances.iter().enumerate() {
        let same = i
            .checked_sub(1)
            .map_or(Some(true), |j| same_foot(&stances[j].into(), &(*s).into()));
        match same {
            Some(same) => first = first == same,
            None => return (Vec::new(), Vec::new()),
        }
        if first { &mut sides.1 } else { &mut sides.0 }.push(*s);
    }
    sides
}

/// One foot over a stride, zero in swing.
fn one_foot(recording: &Recording, stances: &Stances, foot: Option<Foot>) -> Result<Average> {
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
    let mean = mean_stance(recording, &wanted);
    let (period_s, period) = stride_time(recording, stances, 2.0 * mean.impulse_ns, &mean);
    let (mut force_n, mut variance) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
    place(&mean, period_s, 0.0, &mut force_n, &mut variance);
    Ok(Average {
        period_s,
        period_from: period,
        force_n,
        spread_n: mean.spread.is_some().then(|| roots(&variance)),
        averaged: wanted.len(),
        source: CycleSource::OneFoot {
            stances: wanted.len(),
            period,
        },
    })
}

/// Settles mass and repeatability of a mean cycle and compares its mean force with the weight.
fn finish(recording: &Recording, stances: &Stances, average: Average, feet: Feet) -> Result<Cycle> {
    let Average {
        period_s,
        period_from,
        force_n,
        spread_n,
        averaged,
        source,
    } = average;
    let mut curve = ForceCurve::from_samples("", period_s, force_n)?;
    let repeatability_n = spread_n.as_ref().map(|s: &Vec<f64>| {
        let square = s.iter().map(|x| x * x).sum::<f64>() / s.len() as f64;
        1.96 * SQRT_2 * square.sqrt()
    });
    // One foot carries half of the body over a stride.
    let share = if feet == Feet::Both { 1.0 } else { 2.0 };
    let (mass_kg, mass_from) = match (recording.mass_kg, recording.mass_from) {
        (Some(m), from) => (m, from.unwrap_or(MassSource::File)),
        (None, _) => (share * (curve.mean_n() / G), MassSource::MeanForce),
    };
    curve.spread_n = spread_n;
    curve.mass_kg = Some(mass_kg);
    let warning = implausible(&curve, feet);
    let mass_fits = warning.is_none();
    let mut notes: Vec<Note> = warning.into_iter().collect();
    if period_from == PeriodSource::UsualDuty {
        let period = seconds(period_s);
        notes.push(Note::StrideAssumed { period });
    }
    notes.extend(not_walking(recording, stances, &curve)?);
    if recording.mass_kg.is_none() && recording.is_insole() {
        notes.push(Note::InsoleMass {
            mass: kilograms(mass_kg),
        });
    }
    curve.notes = recording.notes.iter().chain(&notes).cloned().collect();
    Ok(Cycle {
        averaged,
        source,
        period_from,
        repeatability_n,
        mass_kg,
        mass_from,
        mean_of_weight: mean_of_weight(&curve, feet).unwrap_or(1.0),
        mass_fits,
        notes,
        curve,
    })
}

/// What walking does not have, in a cycle.
///
/// # Errors
///
/// Where the clock of the recording was guessed and its strides cannot be walking.
fn not_walking(recording: &Recording, stances: &Stances, curve: &ForceCurve) -> Result<Vec<Note>> {
    let used = &stances.used;
    let mean = |of: fn(&Stance) -> f64| {
        (!used.is_empty()).then(|| used.iter().map(of).sum::<f64>() / used.len() as f64)
    };
    let stance_s = mean(|s| s.end_s - s.start_s);
    let peak_n = mean(|s| s.p2.map_or(s.p1.force_n, |p| p.force_n.max(s.p1.force_n)));
    let mass_kg = curve.mass_kg.unwrap_or(0.0);
    // Subjects of a table differ in mass; each has its own peak.
    let peak_n = peak_n.filter(|_| !has_rows(recording));
    let notes = unlike_walking(curve.period_s, mass_kg, stance_s, peak_n);
    let clock = |n: &Note| {
        matches!(
            n,
            Note::StrideImplausible { .. } | Note::DutyImplausible { .. }
        )
    };
    let guessed = (recording.notes.iter()).any(|n| matches!(n, Note::MillisecondsGuessed { .. }));
    if guessed && notes.iter().any(clock) {
        let period = seconds(curve.period_s);
        return Err(ForceError::ClockImplausible { period }.into());
    }
    Ok(notes)
}

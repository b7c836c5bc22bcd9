//! Warnings about a mean cycle: assumptions, inconsistencies and open questions.

use super::Cycle;
use super::single::by_side;
use crate::cycle::plausibility::{ADULT_KG, out_of_range, ranges};
use crate::error::{ForceError, Result};
use crate::quantity::{kilograms, seconds, share};
use crate::recording::{CycleSource, Kind, Note, PeriodSource, Recording, UnitSource};
use crate::stance::{RejectReason, Rejected, Stance, Stances};
use crate::statistics::median;
use crate::units::G;

/// Warnings about a mean cycle, except the warning of `implausible` about its mean force and mass.
pub(super) fn warnings(
    recording: &Recording,
    stances: &Stances,
    cycle: &Cycle,
    total: bool,
) -> Vec<Note> {
    let mut notes = Vec::new();
    if let CycleSource::AnyFoot { stances, .. } = cycle.source {
        // Notes on the whole curve precede notes on assumptions.
        notes.push(Note::OneFootForBoth { stances });
    }
    notes.extend(stances.notes.iter().cloned());
    let period_s = cycle.curve.period_s;
    if cycle.period.from == PeriodSource::UsualDuty {
        let period = seconds(period_s);
        let duty = share(ranges(cycle.kind, cycle.mass_kg, false).usual_duty);
        notes.push(Note::StrideAssumed { period, duty });
    }
    notes.extend(varies(cycle));
    let from_one = |error: f64| Note::StrideFromOne {
        period: seconds(period_s),
        error: share(error / period_s),
        stroke: share(2.0 * error / period_s),
    };
    notes.extend(cycle.period.uncertainty_s().map(from_one));
    let used: Vec<&Stance> = stances.used.iter().filter(|s| !s.unlike).collect();
    let mean = |of: fn(&Stance) -> f64| {
        let sum = used.iter().map(|s| of(s)).sum::<f64>();
        (!used.is_empty() && !total).then(|| sum / used.len() as f64)
    };
    // The subjects of a table have different masses and therefore different peak forces.
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
        notes.push(match recording.live().count() {
            0 | 1 => Note::TotalColumn,
            plates => Note::PlatesSummed { plates },
        });
    }
    notes.extend(few_alike(stances).filter(|_| !total));
    notes.extend(differ(recording, &used, cycle));
    notes.extend(mass_is_guessed(recording, cycle));
    notes
}

/// Note if less than two thirds of the stances of a steady walk are similar. The used stances may then be partial contacts.
fn few_alike(stances: &Stances) -> Option<Note> {
    let unlike = |r: &&Rejected| r.reason == RejectReason::Unlike;
    let used = stances.used.len();
    let stances = used + stances.rejected.iter().filter(unlike).count();
    (3 * used < 2 * stances).then_some(Note::FewAlike { used, stances })
}

/// Maximum coefficient of variation of strides at a constant speed. It is 0.01 to 0.03 for steady walkers.
const ONE_SPEED: f64 = 0.05;

/// Warning if the strides vary more than at a constant speed.
fn varies(cycle: &Cycle) -> Option<Note> {
    let (period, spread) = (cycle.period.seconds, cycle.period.spread_s?);
    // The steps of a limping walker differ, but the strides do not. Doubled steps are therefore not examined.
    let strides = cycle.period.from != PeriodSource::DoubledSteps;
    (strides && spread > ONE_SPEED * period).then(|| Note::StrideVaries {
        period: seconds(period),
        spread: seconds(spread),
    })
}

/// Warnings about a mass that was computed from the mean force of insoles, or with an assumed unit of force.
fn mass_is_guessed(recording: &Recording, cycle: &Cycle) -> Vec<Note> {
    let mut notes = Vec::new();
    let mass = kilograms(cycle.mass_kg);
    if recording.mass_kg.is_some() {
        return notes;
    }
    if recording.insole {
        notes.push(Note::InsoleMass { mass });
    }
    if recording.unit_from == UnitSource::Guessed && !ADULT_KG.contains(&cycle.mass_kg) {
        let unit = recording.unit;
        notes.push(Note::UnitUnconfirmed { unit, mass });
    }
    notes
}

/// Maximum step-to-step spread of whole contacts, as a fraction of the weight. It is also the maximum relative difference between the mean
/// impulses of the feet.
const DIFFERENCE: f64 = 0.2;

/// Maximum relative deviation of the impulse or the peak force of a stance from the median, if there are only a few stances.
const OFF: f64 = 0.1;
/// Maximum number of stances that counts as few.
const FEW: usize = 6;

/// Maximum relative deviation of the impulse or the peak force of a stance from the median.
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

/// Warning if the stances, or the impulses of the two feet, differ more than for whole contacts on the plates.
fn differ(recording: &Recording, used: &[&Stance], cycle: &Cycle) -> Option<Note> {
    if recording.has_rows() || recording.insole {
        return None;
    }
    let spread = cycle.curve.spread_rms_n().unwrap_or(0.0) / (cycle.mass_kg * G);
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
    // A stance that differs from a few others is a partial contact, because the mean of a few stances does not reduce its error.
    let few = (3..=FEW).contains(&used.len());
    let off = if few { off_fellows(used) } else { 0.0 };
    let differs = [(spread.max(feet), DIFFERENCE), (off, OFF)];
    let (found, most) = differs.into_iter().find(|(found, most)| found > most)?;
    Some(Note::StancesDiffer {
        share: share(found),
        most: share(most),
    })
}

/// Checks that the stride is plausible for an assumed time base.
///
/// # Errors
///
/// The stride is not plausible.
pub(super) fn confirm_clock(recording: &Recording, cycle: &mut Cycle) -> Result<()> {
    let guessed = recording.notes.iter().find_map(|n| match n {
        Note::TimeUnitGuessed { step, .. } => Some(*step),
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
    // Sample numbers increase in steps of one. Milliseconds at 1000 Hz also do.
    if (step - 1.0).abs() < 1e-6 {
        let stride = period;
        cycle.notes.push(Note::CountOrMilliseconds { stride });
    }
    Ok(())
}

//! Reasons why a recording without a whole stance contains no cycle.

use super::plausibility::{ADULT_KG, ranges};
use super::total::total_stride;
use crate::error::ForceError;
use crate::quantity::seconds;
use crate::recording::{Feet, Kind, Note, Recording};
use crate::stance::{RejectReason, Stances};
use crate::statistics::mean;
use crate::units::Quantity;

/// Range of maximum readings that suggest the unit newtons per kilogram, although the readings were interpreted as newtons.
const PER_KILOGRAM: std::ops::Range<f64> = 5.0..40.0;

/// Reason why the recording contains no cycle. It follows from the rejected contacts, the recognised movement and the notes.
pub(super) fn no_stance(recording: &Recording, stances: &Stances, feet: Feet) -> ForceError {
    let duration = seconds(recording.duration_s);
    let Some(first) = stances.rejected.first() else {
        if let Some(refusal) = another_movement(stances, duration) {
            return refusal;
        }
        let per_mass = recording.notes.iter().find_map(|note| match note {
            Note::LowForce { peak } if PER_KILOGRAM.contains(&peak.value) => Some(*peak),
            _ => None,
        });
        if let Some(peak) = per_mass {
            return ForceError::ForceTooLow { duration, peak };
        }
        return if recording.channels.iter().all(|c| c.idle.is_some()) {
            ForceError::NoLiveChannel { duration }
        } else {
            ForceError::NoContact { duration }
        };
    };
    if matches!(feet, Feet::One | Feet::Left | Feet::Right)
        && total_stride(recording, stances, false).is_some()
    {
        return ForceError::TotalOfBothFeet { duration };
    }
    let guessed = |n: &Note| matches!(n, Note::TimeUnitGuessed { .. });
    if recording.notes.iter().any(guessed) {
        // With a wrong time base, walking resembles running or standing.
        let rejected = stances.rejected.iter();
        let durations: Vec<f64> = rejected.map(|r| r.to_s - r.from_s).collect();
        let usual = ranges(Kind::Walking, ADULT_KG.start, false).usual_duty;
        let period = seconds(mean(&durations) / usual);
        return ForceError::ClockImplausible { period };
    }
    if let Some(refusal) = another_movement(stances, duration) {
        return refusal;
    }
    let reason = usual_reason(stances).into();
    let cut = recording.notes.iter().find_map(|n| match n {
        Note::RowsDiffer { announced, found } if found < announced => Some((*announced, *found)),
        Note::FramesMissing { announced, found } => Some((*announced, *found)),
        _ => None,
    });
    match cut {
        Some((announced, found)) => ForceError::NoStanceFileCut {
            duration,
            announced,
            found,
            reason,
        },
        None => ForceError::NoStance {
            duration,
            contacts: stances.rejected.len(),
            from: seconds(recording.start_s + first.from_s),
            to: seconds(recording.start_s + first.to_s),
            reason,
        },
    }
}

/// Error if the recognised movement is running, jumping, standing or sit-to-stand; otherwise `None`.
fn another_movement(stances: &Stances, duration: Quantity) -> Option<ForceError> {
    let kind = stances.recognised?;
    match kind {
        Kind::Running => Some(ForceError::Running { duration }),
        Kind::Jumping | Kind::Standing | Kind::SitToStand => {
            let movement = kind.name();
            Some(ForceError::NotWalking { movement, duration })
        }
        Kind::Walking | Kind::Other => None,
    }
}

/// The most frequent reason for the rejection of contacts.
fn usual_reason(stances: &Stances) -> RejectReason {
    let mut reasons: Vec<RejectReason> = stances.rejected.iter().map(|r| r.reason).collect();
    reasons.sort_unstable();
    let runs = reasons.chunk_by(|a, b| a == b);
    let longest = runs.max_by_key(|run| run.len());
    longest.map_or(RejectReason::TooShort, |run| run[0])
}

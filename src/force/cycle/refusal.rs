//! Why a recording without a whole stance gives no cycle.

use super::total::total_stride;
use crate::error::ForceError;
use crate::force::feet::Feet;
use crate::force::note::Note;
use crate::force::quantity::seconds;
use crate::force::recording::Recording;
use crate::force::stance::{RejectReason, Stances};

/// The reason, from the contacts that were rejected and from what the header announces.
pub(super) fn no_stance(recording: &Recording, stances: &Stances, feet: Feet) -> ForceError {
    let duration = seconds(recording.duration_s);
    let Some(first) = stances.rejected.first() else {
        return if recording.channels.iter().all(|c| c.idle.is_some()) {
            ForceError::NoLiveChannel { duration }
        } else {
            ForceError::NoContact { duration }
        };
    };
    let all_running = (stances.rejected.iter()).all(|r| r.reason == RejectReason::Running);
    if all_running {
        return ForceError::Running { duration };
    }
    if feet != Feet::Both && total_stride(recording, stances).is_some() {
        return ForceError::TotalOfBothFeet { duration };
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
            from: seconds(first.from_s),
            to: seconds(first.to_s),
            reason,
        },
    }
}

/// The reason that rejects most contacts.
fn usual_reason(stances: &Stances) -> RejectReason {
    let mut reasons: Vec<RejectReason> = stances.rejected.iter().map(|r| r.reason).collect();
    reasons.sort_unstable();
    let runs = reasons.chunk_by(|a, b| a == b);
    let longest = runs.max_by_key(|run| run.len());
    longest.map_or(RejectReason::TooShort, |run| run[0])
}

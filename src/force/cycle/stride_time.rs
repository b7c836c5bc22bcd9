//! How long a stride lasts, where it was built from single stances.

use super::average::MeanStance;
use crate::force::note::PeriodSource;
use crate::force::recording::Recording;
use crate::force::stance::{Stances, same_foot};
use crate::units::G;

/// Part of a stride that a foot is on the ground, where nothing in the recording says it (normal walking).
const DUTY: f64 = 0.62;

/// Whether the recording is a table of single stances.
pub(super) fn has_rows(recording: &Recording) -> bool {
    recording.channels.iter().any(|c| !c.rows.is_empty())
}

/// Duration of a stride, s, and what it was taken from.
///
/// Heel strikes that follow each other say it; else a known mass does, since both feet together carry it
/// (impulse of both = M g T); else the usual part of a stride that a foot stands.
pub(super) fn stride_time(
    recording: &Recording,
    stances: &Stances,
    impulse_ns: f64,
    stance: &MeanStance,
) -> (f64, PeriodSource) {
    let mut strides: Vec<f64> = Vec::new();
    if !has_rows(recording) {
        for w in stances.used.windows(2) {
            let stance_s = w[0].end_s - w[0].start_s;
            let step = (w[1].start_s - w[0].start_s) / stance_s;
            match same_foot(&w[0], &w[1]) {
                // Feet that land together (a jump, standing) are not in step.
                Some(false) if (0.4..1.2).contains(&step) => strides.push(2.0 * step * stance_s),
                Some(true) if (1.0..2.5).contains(&step) => strides.push(step * stance_s),
                _ => (),
            }
        }
    }
    if !strides.is_empty() {
        strides.sort_by(f64::total_cmp);
        return (strides[strides.len() / 2], PeriodSource::HeelStrikes);
    }
    if let Some(mass) = recording.mass_kg {
        let period = impulse_ns / (mass * G);
        // A stride shorter than its stance or longer than a pause tells of a wrong mass.
        if (1.1..3.0).contains(&(period / stance.duration_s)) {
            return (period, PeriodSource::Impulse);
        }
    }
    (stance.duration_s / DUTY, PeriodSource::UsualDuty)
}

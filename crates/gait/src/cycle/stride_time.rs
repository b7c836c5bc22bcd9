//! Duration of a stride that was built from single stances.

use super::average::MeanStance;
use crate::cycle::plausibility::Ranges;
use crate::interpretation::Period;
use crate::recording::{Foot, Heels, PeriodSource, Recording};
use crate::stance::{RejectReason, Stances, footfalls, same_foot};
use crate::statistics::{mean, median, sample_deviation};
use crate::units::G;

/// Relative standard uncertainty of a stride time that is measured from only one stride or one doubled step. It is the RMS deviation of
/// such values from the stride time over all strides of the same walks.
const OF_ONE: f64 = 0.02;

impl Period {
    /// Standard uncertainty, s, of a duration that was measured from a single stride or step. `None` for several strides or steps, or for a
    /// duration with another source.
    pub fn uncertainty_s(&self) -> Option<f64> {
        use PeriodSource::{DoubledSteps, HeelMarkers, HeelStrikes, MarkedStrikes};
        let measured = matches!(
            self.from,
            HeelStrikes | MarkedStrikes | HeelMarkers | DoubledSteps
        );
        (measured && self.spread_s.is_none()).then_some(OF_ONE * self.seconds)
    }

    fn of(strides: &[f64], from: PeriodSource) -> Option<Self> {
        Some(Period {
            seconds: median(strides.to_vec())?,
            from,
            spread_s: sample_deviation(strides),
        })
    }

    fn alone(seconds: f64, from: PeriodSource) -> Self {
        Period {
            seconds,
            from,
            spread_s: None,
        }
    }
}

/// Duration of a stride, and its source. The first available source of this list is used:
///
/// - consecutive heel strikes of one foot;
/// - heel strikes marked in the file;
/// - heel markers;
/// - doubled steps (times between heel strikes of alternate feet);
/// - a known mass (impulse of both feet = M g T);
/// - a typical duty factor.
pub(super) fn stride_time(
    recording: &Recording,
    stances: &Stances,
    impulse_ns: f64,
    stance: &MeanStance,
    ranges: &Ranges,
) -> Period {
    if !recording.has_rows() {
        let strikes = strikes(recording, stances, stance.duration_s, ranges);
        if let Some(period) = strikes {
            return period;
        }
    }
    if let Some(mass) = recording.mass_kg {
        let period = impulse_ns / (mass * G);
        // A ratio outside this range indicates a wrong mass.
        let ratio = period / stance.duration_s;
        if ratio > 1.1 && ratio < ranges.stride_of_stance.end + 0.5 {
            return Period::alone(period, PeriodSource::Impulse);
        }
    }
    Period::alone(
        stance.duration_s / ranges.usual_duty,
        PeriodSource::UsualDuty,
    )
}

/// Duration of a stride from heel strikes, marked heel strikes, heel markers or doubled steps, in this order of preference. `None` if the
/// recording contains none of these.
fn strikes(
    recording: &Recording,
    stances: &Stances,
    stance_s: f64,
    ranges: &Ranges,
) -> Option<Period> {
    let mut falls = footfalls(recording, stances);
    falls.retain(|f| matches!(f.rejected, None | Some(RejectReason::CutAtEnd)));
    let is_stride = |s: f64| ranges.stride_of_stance.contains(&(s / stance_s));
    let is_step = |s: f64| ranges.step_of_stance.contains(&(s / stance_s));
    let mut own: Vec<f64> = Vec::new();
    let mut steps: Vec<f64> = Vec::new();
    // Duration of the previous step, s; `None` if the foot did not change.
    let mut before = None;
    for w in falls.windows(2) {
        let time = w[1].start_s - w[0].start_s;
        let step = match same_foot(&w[0], &w[1], recording.runs()) {
            Some(true) if is_stride(time) => {
                own.push(time);
                None
            }
            Some(false) if is_step(time) => Some(time),
            _ => None,
        };
        if let (Some(a), Some(b)) = (before, step) {
            own.push(a + b);
        }
        steps.extend(step);
        before = step;
    }
    if let Some(stride) = Period::of(&own, PeriodSource::HeelStrikes) {
        return Some(stride);
    }
    let heels = recording.heels.as_ref();
    for (mut strides, from) in [
        (marked_strides(recording), PeriodSource::MarkedStrikes),
        (
            heels.map_or(Vec::new(), Heels::strides_s),
            PeriodSource::HeelMarkers,
        ),
    ] {
        strides.retain(|s| is_stride(*s));
        if let Some(stride) = Period::of(&strides, from) {
            return Some(stride);
        }
    }
    let doubled = (!steps.is_empty()).then(|| 2.0 * mean(&steps))?;
    Some(Period {
        seconds: doubled,
        from: PeriodSource::DoubledSteps,
        spread_s: sample_deviation(&steps).map(|d| 2.0 * d),
    })
}

/// Times between consecutive marked heel strikes of the same foot, s.
fn marked_strides(recording: &Recording) -> Vec<f64> {
    let of = |foot: Foot| -> Vec<f64> {
        let own = recording.strikes.iter().filter(|s| s.foot == foot);
        own.map(|s| s.at_s).collect()
    };
    let pairs = [of(Foot::Left), of(Foot::Right)];
    let times = pairs.iter().flat_map(|at| at.windows(2));
    times.map(|w| w[1] - w[0]).collect()
}

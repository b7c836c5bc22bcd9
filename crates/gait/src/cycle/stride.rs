//! Whole strides of both feet in a recording.

use super::Average;
use super::average::{BLEND, Mean, at, periodic, whole_span};
use crate::curve::SAMPLES;
use crate::interpretation::{RecordedStride, StrideReject};
use crate::recording::{CycleSource, Foot, PeriodSource, Recording};
use crate::stance::{Footfall, RejectReason, Stance, Stances, footfalls};
use crate::statistics::{mean, median};
use crate::walk::Walk;

/// Stride from a heel strike to the next heel strike of the same foot, with all contacts that overlap the stride.
#[derive(Debug, Clone)]
pub(super) struct Stride {
    pub start_s: f64,
    pub end_s: f64,
    pub foot: Option<Foot>,
    /// Time from the previous heel strike to `start_s`, s. The blend at the ends of the stride is not wider than this time, because the
    /// total force may be unknown before it.
    before_s: f64,
    /// Contacts that overlap the stride.
    contacts: Vec<Footfall>,
}

/// A stride is not averaged if its duration differs from the median by this fraction or more.
pub(super) const ODD_STRIDE: f64 = 0.25;

/// Strides for which every footfall is recorded.
///
/// A stride requires four consecutive footfalls, each of which overlaps the next one. The stride lasts from the second to the fourth heel
/// strike. The first footfall contributes to the first double support of the stride. Its earlier part may be missing. The fourth footfall
/// starts the next stride.
pub(super) fn whole_strides(recording: &Recording, stances: &Stances) -> Vec<Stride> {
    use RejectReason::{CrossTalk, CutAtEnd, CutAtStart, TooShort};
    let mut falls = footfalls(recording, stances);
    falls.retain(|f| !matches!(f.rejected, Some(TooShort | CrossTalk)));
    falls.sort_by(|a, b| (a.start_s.total_cmp(&b.start_s)).then(a.end_s.total_cmp(&b.end_s)));
    let overlap = |a: &Footfall, b: &Footfall| b.start_s < a.end_s && b.end_s > a.end_s;
    let found = falls.windows(4).filter(|w| {
        let whole = w[1].rejected.is_none() && w[2].rejected.is_none();
        let ends = matches!(w[0].rejected, None | Some(CutAtStart))
            && matches!(w[3].rejected, None | Some(CutAtEnd));
        let in_turn = w.windows(2).all(|p| overlap(&p[0], &p[1]));
        whole && ends && in_turn && w[0].end_s < w[2].start_s && w[1].end_s < w[3].end_s
    });
    found
        .map(|w| Stride {
            start_s: w[1].start_s,
            end_s: w[3].start_s,
            foot: w[1].foot,
            before_s: w[1].start_s - w[0].start_s,
            contacts: w.to_vec(),
        })
        .collect()
}

/// Mean of whole strides that begin with the same foot.
pub(super) fn averaged(recording: &Recording, strides: &[Stride]) -> Average {
    let (kept, from) = like_strides(strides);
    let mut average = Mean::new();
    let mut row = vec![0.0; SAMPLES];
    for stride in &kept {
        sample_stride(recording, stride, &mut row);
        average.add(&row);
    }
    let durations: Vec<f64> = kept.iter().map(|s| s.end_s - s.start_s).collect();
    let strides = kept.len();
    let source = CycleSource::WholeStrides { strides, from };
    let strikes: Vec<[f64; 3]> = kept
        .iter()
        .map(|s| [s.start_s, s.contacts[2].start_s, s.end_s])
        .collect();
    let spans: Vec<_> = kept.iter().map(|s| loaded_spans(recording, s)).collect();
    let walk = Walk::of(&strikes, false, |k, t| {
        force_of(&spans[k], recording.rate_hz, t)
    });
    Average {
        walk,
        ..Average::of_cycles(average, &durations, PeriodSource::HeelStrikes, source)
    }
}

/// Strides of typical duration that begin with the same foot, and the foot with which they begin.
fn like_strides(strides: &[Stride]) -> (Vec<&Stride>, Option<Foot>) {
    let (foot, reasons) = judged(strides);
    let all = strides.iter().zip(reasons);
    let kept = all.filter(|(_, reason)| reason.is_none());
    (kept.map(|(stride, _)| stride).collect(), foot)
}

/// Foot with which the averaged strides begin. For each stride, the reason for its exclusion; `None` if it is averaged.
///
/// Strides from left to left and from right to right share samples, so only strides of one foot are averaged.
fn judged(strides: &[Stride]) -> (Option<Foot>, Vec<Option<StrideReject>>) {
    let durations = strides.iter().map(|s| s.end_s - s.start_s).collect();
    let usual = median(durations).unwrap_or(0.0);
    let is_usual = |s: &Stride| ((s.end_s - s.start_s) / usual - 1.0).abs() < ODD_STRIDE;
    let count = |foot: Option<Foot>| {
        let own = |s: &&Stride| is_usual(s) && s.foot == foot;
        strides.iter().filter(own).count()
    };
    let best = [Some(Foot::Right), Some(Foot::Left), None]
        .into_iter()
        .max_by_key(|f| count(*f))
        .unwrap_or(None);
    // If the sides are unknown, consecutive strides begin with alternate feet. Strides that overlap the last averaged stride are excluded.
    let mut end_s = f64::NEG_INFINITY;
    let reasons = strides.iter().map(|s| {
        let shared = || best.is_none() && s.start_s < end_s - 0.05 * (s.end_s - s.start_s);
        if !is_usual(s) {
            return Some(StrideReject::OddDuration);
        }
        if s.foot != best || shared() {
            return Some(StrideReject::OtherFoot);
        }
        end_s = s.end_s;
        None
    });
    (best, reasons.collect())
}

/// All whole strides, with times as in the file. `averaged` is true if the mean cycle is built from whole strides.
pub(super) fn recorded_strides(
    recording: &Recording,
    stances: &Stances,
    averaged: bool,
) -> Vec<RecordedStride> {
    let strides = whole_strides(recording, stances);
    let (_, reasons) = judged(&strides);
    let mut row = vec![0.0; SAMPLES];
    let all = strides.iter().zip(reasons);
    all.map(|(stride, reason)| {
        sample_stride(recording, stride, &mut row);
        RecordedStride {
            foot: stride.foot,
            from_s: recording.start_s + stride.start_s,
            to_s: recording.start_s + stride.end_s,
            landmarks: stances
                .at(&stride.contacts[1])
                .map_or([None; 3], Stance::landmarks),
            impulse_ns: mean(&row) * (stride.end_s - stride.start_s),
            rejected: if averaged {
                reason
            } else {
                Some(StrideReject::StancesAveraged)
            },
        }
    })
    .collect()
}

/// Force of a channel, N, with the start and the end of a contact, s.
type Span<'a> = (&'a [f64], f64, f64);

/// Forces and time spans of all contacts that overlap a stride.
fn loaded_spans<'a>(recording: &'a Recording, stride: &Stride) -> Vec<Span<'a>> {
    let span = |f: &Footfall| {
        let channel = &recording.channels[f.channel];
        let (from, to) = whole_span(channel, recording.rate_hz, f.start_s, f.end_s);
        (&channel.force_n[..], from, to)
    };
    stride.contacts.iter().map(span).collect()
}

/// Sum of the forces of contacts, N, at a time, s.
fn force_of(spans: &[Span], rate_hz: f64, t: f64) -> f64 {
    let loaded = spans.iter().filter(|s| t >= s.1 && t <= s.2);
    loaded.map(|s| at(s.0, t * rate_hz)).sum()
}

/// Fills `row` with the total force of a stride, N, at equal phases. The values at both ends are equal.
fn sample_stride(recording: &Recording, stride: &Stride, row: &mut [f64]) {
    let spans = loaded_spans(recording, stride);
    let total = |t: f64| force_of(&spans, recording.rate_hz, t);
    let length = stride.end_s - stride.start_s;
    let half = (BLEND * length).min(stride.before_s);
    periodic(row, stride.start_s, length, half, total);
}

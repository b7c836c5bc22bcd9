//! Whole strides of both feet in a recording.

use super::Average;
use super::average::{BLEND, Mean, at, periodic, whole_span};
use crate::curve::SAMPLES;
use crate::recording::{CycleSource, Foot, PeriodSource, Recording};
use crate::stance::{Footfall, RejectReason, Stances, footfalls};
use crate::statistics::median;

/// Time from a heel strike to the next of the same foot, with every contact that carries force in it.
#[derive(Debug, Clone)]
pub(super) struct Stride {
    pub start_s: f64,
    pub end_s: f64,
    pub foot: Option<Foot>,
    /// Recorded time before the start in which all standing feet are known, s. After the end at least a quarter of a stance is required; less of a
    /// last contact is a fragment.
    before_s: f64,
    /// The contacts that overlap the stride.
    contacts: Vec<Footfall>,
}

/// Relative deviation from the median duration above which a stride is not averaged.
const ODD_STRIDE: f64 = 0.25;

/// Strides in which every footfall is on record.
///
/// In four consecutive footfalls, each overlapping the next: the second to the fourth heel strike is a stride, the first gives its first double
/// support and may be cut before, the fourth starts the next stride.
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
    Average::of_cycles(average, &durations, PeriodSource::HeelStrikes, source)
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

/// Every second stride of each run of overlapping strides.
fn alternate<'a>(strides: &[&'a Stride]) -> Vec<&'a Stride> {
    let mut kept: Vec<&Stride> = Vec::new();
    for s in strides {
        let clash = kept
            .last()
            .is_some_and(|k: &&Stride| s.start_s < k.end_s - 0.05 * (k.end_s - k.start_s));
        if !clash {
            kept.push(s);
        }
    }
    kept
}

/// Sum of the contacts of a stride at equal phases, with matching ends.
fn sample_stride(recording: &Recording, stride: &Stride, row: &mut [f64]) {
    let rate = recording.rate_hz;
    let spans: Vec<(&[f64], f64, f64)> = stride
        .contacts
        .iter()
        .map(|f| {
            let channel = &recording.channels[f.channel];
            let (from, to) = whole_span(channel, rate, f.start_s, f.end_s);
            (&channel.force_n[..], from, to)
        })
        .collect();
    let total = |t: f64| -> f64 {
        let loaded = spans.iter().filter(|s| t >= s.1 && t <= s.2);
        loaded.map(|s| at(s.0, t * rate)).sum()
    };
    let length = stride.end_s - stride.start_s;
    let half = (BLEND * length).min(stride.before_s);
    periodic(row, stride.start_s, length, half, total);
}

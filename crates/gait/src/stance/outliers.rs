//! Comparison of whole stances, to select the stances of one speed and to detect outliers.

use super::types::{RejectReason, Rejected, Stance, Stances};
use crate::quantity::seconds;
use crate::recording::{Note, Recording};
use crate::statistics::median;

/// Maximum relative difference of durations at a constant speed: three standard deviations of steady walking.
const ONE_SPEED: f64 = 0.1;
/// The speed is considered to change if more than this fraction of the stances is outside the most frequent range of durations.
const OUTSIDE: f64 = 0.15;
/// Minimum number of stances from which a change of speed is detected.
const FEWEST: usize = 8;
/// Function that computes a quantity of a stance from which outliers are detected.
type Measure = fn(&Stance) -> f64;
/// Quantities, each with its maximum relative deviation from the median. A stance with a larger deviation is excluded from the mean of one
/// foot.
const MEASURES: [(Measure, f64); 3] = [
    (Stance::duration_s, 0.1),
    (|s| s.p1.force_n, 0.15),
    (|s| s.impulse_ns, 0.15),
];
/// Minimum number of stances of a channel from which outliers are detected, so that at least three stances agree.
const COMPARABLE: usize = 4;

/// The local stride time is the median of this number of consecutive intervals between heel strikes. A foot that crosses plates affects two
/// intervals.
const IN_A_ROW: usize = 5;

/// Keeps the stances in the most frequent range of durations, and rejects the other stances. If the stride time is constant, the rejected
/// contacts are partial or include both feet. Otherwise, the rejected stances have another speed, and a note is added.
pub(super) fn of_one_speed(out: &mut Stances, recording: &Recording) {
    let count = out.used.len();
    if recording.has_rows() || count < FEWEST {
        return;
    }
    let mut sorted: Vec<f64> = out.used.iter().map(Stance::duration_s).collect();
    sorted.sort_by(f64::total_cmp);
    let (low, high, inside) = largest_group(&sorted);
    if (count - inside) as f64 <= OUTSIDE * count as f64 {
        return;
    }
    let steady = keeps_rhythm(out, recording.channels.len());
    let reason = if steady {
        RejectReason::Unlike
    } else {
        RejectReason::OtherSpeed
    };
    let of_group = |s: &Stance| (low..=high).contains(&s.duration_s());
    let (kept, others): (Vec<Stance>, Vec<Stance>) = std::mem::take(&mut out.used)
        .into_iter()
        .partition(of_group);
    out.used = kept;
    out.rejected.extend(others.iter().map(|s| Rejected {
        channel: s.channel,
        from_s: s.start_s,
        to_s: s.end_s,
        reason,
    }));
    out.rejected.sort_by(|a, b| a.from_s.total_cmp(&b.from_s));
    let changes = || Note::SpeedChanges {
        used: inside,
        stances: count,
        low: seconds(low),
        high: seconds(high),
    };
    out.notes.extend((!steady).then(changes));
}

/// Whether nearly all strides have the same speed, according to the stride times instead of the durations of the contacts.
fn keeps_rhythm(out: &Stances, channels: usize) -> bool {
    let mut strides: Vec<f64> = (0..channels).flat_map(|k| usual_strides(out, k)).collect();
    strides.sort_by(f64::total_cmp);
    let (.., inside) = largest_group(&strides);
    2 * strides.len() > out.used.len()
        && (strides.len() - inside) as f64 <= OUTSIDE * strides.len() as f64
}

/// Moving medians of the times, s, between consecutive heel strikes on a channel.
fn usual_strides(out: &Stances, channel: usize) -> Vec<f64> {
    let used = out.used.iter().map(|s| (s.channel, s.start_s));
    let other = out.rejected.iter().map(|r| (r.channel, r.from_s));
    let own = used.chain(other).filter(|(k, _)| *k == channel);
    let mut strikes: Vec<f64> = own.map(|(_, start_s)| start_s).collect();
    strikes.sort_by(f64::total_cmp);
    let times: Vec<f64> = strikes.windows(2).map(|w| w[1] - w[0]).collect();
    let in_a_row = times.windows(IN_A_ROW);
    in_a_row.filter_map(|w| median(w.to_vec())).collect()
}

/// Range of a fixed relative width that contains the maximum number of the sorted values. Returns the minimum and maximum value in this
/// range, and the number of values.
pub(crate) fn largest_group(sorted: &[f64]) -> (f64, f64, usize) {
    let mut best = (0.0, 0.0, 0);
    let mut end = 0;
    for (start, low) in sorted.iter().enumerate() {
        let top = low * (1.0 + ONE_SPEED) / (1.0 - ONE_SPEED);
        end = end.max(start + 1);
        while end < sorted.len() && sorted[end] <= top {
            end += 1;
        }
        if end - start > best.2 {
            best = (*low, sorted[end - 1], end - start);
        }
    }
    best
}

/// Marks the stances of each channel whose duration, loading peak or impulse is an outlier. Such stances are partial contacts, or include
/// the other foot.
pub(super) fn mark_unlike(used: &mut [Stance], channels: usize) {
    for channel in 0..channels {
        let own: Vec<usize> = (0..used.len())
            .filter(|&i| used[i].channel == channel && used[i].mass_kg.is_none())
            .collect();
        if own.len() < COMPARABLE {
            continue;
        }
        let middle = |of: Measure| median(own.iter().map(|&i| of(&used[i])).collect());
        let bounds = MEASURES.map(|(of, most)| (of, most, middle(of).unwrap_or(f64::NAN)));
        let is_unlike = |i: &usize| {
            let off = |of: Measure, usual: f64| (of(&used[*i]) / usual - 1.0).abs();
            bounds
                .iter()
                .any(|&(of, most, usual)| off(of, usual) > most)
        };
        let unlike: Vec<usize> = own.iter().copied().filter(is_unlike).collect();
        // If most stances differ, there is no typical stance.
        if 2 * unlike.len() <= own.len() {
            for i in unlike {
                used[i].unlike = true;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fullest_window_wins() {
        let sorted = [0.6, 0.61, 0.62, 0.63, 0.9, 0.91];
        assert_eq!(largest_group(&sorted), (0.6, 0.63, 4));
    }
}

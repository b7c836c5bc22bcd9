//! A stride built from single stances: the stances of both feet half a stride apart, or the stance of one foot with its swing phase.

use super::Average;
use super::average::{MARGIN, at, mean_stance, whole_span};
use super::stride::ODD_STRIDE;
use super::stride_time::stride_time;
use crate::cycle::plausibility::Ranges;
use crate::error::{ForceError, Result};
use crate::recording::{CycleSource, Foot, Recording};
use crate::stance::{Stance, Stances, same_foot};
use crate::walk::Walk;

/// A stride of both feet, built from single stances half a stride apart.
pub(super) fn both_feet(recording: &Recording, stances: &Stances, ranges: &Ranges) -> Average {
    let all: Vec<&Stance> = stances.used.iter().collect();
    let (left, right) = by_side(&all, recording);
    let (left, right) = (fellows(left), fellows(right));
    let sides = !left.is_empty() && !right.is_empty();
    let pair = if sides { [&right, &left] } else { [&all; 2] };
    let [first, second] = pair.map(|stances| mean_stance(recording, stances, MARGIN));
    let impulse = first.impulse_ns + second.impulse_ns;
    let period = stride_time(recording, stances, impulse, &first, ranges);
    let from = period.from;
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
    let walk = match source {
        CycleSource::AnyFoot { .. } => one_foot_walk(recording, &all, period.seconds),
        _ => None,
    };
    let stances = [(&first, 0.0), (&second, 0.5)];
    Average {
        walk,
        ..Average::of_stances(period, &stances, all.len(), source)
    }
}

/// Strides of both feet from one recorded foot, on the assumption that the other foot repeats each stance half a stride later. `None` for
/// several channels, or for a table of stances, whose rows are not consecutive.
fn one_foot_walk(recording: &Recording, stances: &[&Stance], usual_s: f64) -> Option<Walk> {
    if recording.has_rows() || recording.live().count() != 1 {
        return None;
    }
    let rate = recording.rate_hz;
    let channel = |s: &Stance| &recording.channels[s.channel];
    let strides: Vec<(&Stance, f64)> = stances
        .windows(2)
        .map(|w| (w[0], w[1].start_s - w[0].start_s))
        .filter(|(_, length)| (length / usual_s - 1.0).abs() < ODD_STRIDE)
        .collect();
    let strikes: Vec<[f64; 3]> = strides
        .iter()
        .map(|(s, length)| [0.0, 0.5, 1.0].map(|part| s.start_s + part * length))
        .collect();
    let own = |stance: &Stance, t: f64| {
        let (from, to) = whole_span(channel(stance), rate, stance.start_s, stance.end_s);
        match t >= from && t <= to {
            true => at(&channel(stance).force_n, t * rate),
            false => 0.0,
        }
    };
    Walk::of(&strikes, true, |k, t| {
        let (stance, length) = strides[k];
        let before = k.checked_sub(1).map(|k| strides[k]);
        let before = before.filter(|(b, l)| (b.start_s + l - stance.start_s).abs() < 1e-9);
        // Before the first stride of a sequence, an equal stride is assumed.
        let (last, last_s, since) = match before {
            Some((last, last_s)) => (last, last_s, t),
            None => (stance, length, t + length),
        };
        own(stance, t) + own(stance, t - 0.5 * length) + own(last, since - 0.5 * last_s)
    })
}

/// Stances that are not outliers. If every stance is an outlier, all stances are returned.
fn fellows(stances: Vec<&Stance>) -> Vec<&Stance> {
    let alike: Vec<&Stance> = stances.iter().copied().filter(|s| !s.unlike).collect();
    if alike.is_empty() { stances } else { alike }
}

/// Stances of the left and of the right foot. If no side is known, the stances are assigned to two unnamed feet by their times.
///
/// Both lists are empty if the times are not conclusive. They are also empty for a table of stances without sides, whose rows are not
/// consecutive.
pub(super) fn by_side<'a>(
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

/// Stances of one foot, or of both feet, without outliers.
///
/// # Errors
///
/// There is no stance of this foot.
pub(super) fn stances_of(stances: &Stances, foot: Option<Foot>) -> Result<Vec<&Stance>> {
    let of_foot = |s: &&Stance| foot.is_none() || s.foot == foot;
    let wanted: Vec<&Stance> = stances.used.iter().filter(of_foot).collect();
    match foot {
        Some(foot) if wanted.is_empty() => {
            let named = stances.used.iter().any(|s| s.foot.is_some());
            let foot = foot.name();
            Err(match named {
                true => ForceError::NoStanceOfFoot { foot }.into(),
                false => ForceError::FeetNotNamed { foot }.into(),
            })
        }
        _ => Ok(fellows(wanted)),
    }
}

/// Mean force of one foot over a stride; zero in the swing phase.
pub(super) fn one_foot(
    recording: &Recording,
    stances: &Stances,
    foot: Option<Foot>,
    ranges: &Ranges,
) -> Result<Average> {
    let wanted = stances_of(stances, foot)?;
    let mean = mean_stance(recording, &wanted, MARGIN);
    let period = stride_time(recording, stances, 2.0 * mean.impulse_ns, &mean, ranges);
    let source = CycleSource::OneFoot {
        stances: mean.count,
        period: period.from,
    };
    Ok(Average::of_stances(
        period,
        &[(&mean, 0.0)],
        mean.count,
        source,
    ))
}

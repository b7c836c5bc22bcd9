//! A stride built from single stances: both feet half a stride apart, or one foot with its swing phase.

use super::Average;
use super::average::{MARGIN, mean_stance};
use super::stride_time::stride_time;
use crate::cycle::plausibility::Ranges;
use crate::error::{ForceError, Result};
use crate::recording::{CycleSource, Foot, Recording};
use crate::stance::{Stance, Stances, same_foot};

/// A stride of both feet built from single stances half a stride apart.
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
    Average::of_stances(period, &[(&first, 0.0), (&second, 0.5)], all.len(), source)
}

/// Stances without outliers; all stances if every one is an outlier.
fn fellows(stances: Vec<&Stance>) -> Vec<&Stance> {
    let alike: Vec<&Stance> = stances.iter().copied().filter(|s| !s.unlike).collect();
    if alike.is_empty() { stances } else { alike }
}

/// Stances of the left and of the right foot; of two unnamed feet if no side is known. Without sides, consecutive stances are assigned to alternating
/// feet. The rows of a table of stances are not consecutive.
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

/// Stances of one foot, or of both, without outliers.
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

/// Force of one foot over a stride; zero in the swing phase.
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

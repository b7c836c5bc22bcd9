//! Which foot a stance is of.

use super::types::Stance;
use crate::force::recording::Recording;

/// Names the feet of plates: by marked strikes, then by turns from a stance whose foot is known.
pub(super) fn name_feet(stances: &mut [Stance], recording: &Recording) {
    for s in stances.iter_mut().filter(|s| s.foot.is_none()) {
        let near = |at: f64| (at - s.start_s).abs();
        let strike = recording
            .strikes
            .iter()
            .min_by(|a, b| near(a.at_s).total_cmp(&near(b.at_s)));
        s.foot = strike.filter(|k| near(k.at_s) < 0.15).map(|k| k.foot);
    }
    let n = stances.len();
    let turns: Vec<usize> = (1..n).chain((1..n).rev()).collect();
    for (k, &i) in turns.iter().enumerate() {
        let (known, open) = if k < n.saturating_sub(1) {
            (i - 1, i)
        } else {
            (i, i - 1)
        };
        if stances[open].foot.is_none()
            && let Some(foot) = stances[known].foot
            && let Some(same) = same_foot(&stances[i - 1], &stances[i])
        {
            stances[open].foot = Some(if same { foot } else { foot.other() });
        }
    }
}

/// Whether two stances that follow each other are of one foot; `None` where that cannot be told.
///
/// In walking the next foot lands before this one has left; the same foot only after its swing.
pub(crate) fn same_foot(a: &Stance, b: &Stance) -> Option<bool> {
    if let (Some(a), Some(b)) = (a.foot, b.foot) {
        return Some(a == b);
    }
    let duration = a.end_s - a.start_s;
    let pause = b.start_s - a.end_s;
    if pause < 0.15 * duration {
        return Some(false);
    }
    (a.channel == b.channel && (0.3..1.2).contains(&(pause / duration))).then_some(true)
}

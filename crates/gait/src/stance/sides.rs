//! Assignment of stances to the left and the right foot.

use super::types::{RejectReason, Stance, Stances};
use crate::recording::{Foot, Recording};

/// Assigns a foot to each stance. The sources, in order of preference, are marked strikes, heel markers, and the alternation of the feet
/// from a stance whose foot is known.
pub(super) fn name_feet(stances: &mut [Stance], recording: &Recording) {
    for s in stances.iter_mut().filter(|s| s.foot.is_none()) {
        let near = |at: f64| (at - s.start_s).abs();
        let strike = recording
            .strikes
            .iter()
            .min_by(|a, b| near(a.at_s).total_cmp(&near(b.at_s)));
        let marked = strike.filter(|k| near(k.at_s) < 0.15).map(|k| k.foot);
        let heels = recording.heels.as_ref();
        s.foot = marked.or_else(|| heels?.standing(s.start_s, s.end_s));
    }
    let n = stances.len();
    let onwards = (1..n).map(|i| (i - 1, i));
    let back = (1..n).rev().map(|i| (i, i - 1));
    for (known, open) in onwards.chain(back) {
        let [a, b] = [known.min(open), known.max(open)].map(|i| Footfall::from(&stances[i]));
        if stances[open].foot.is_none()
            && let Some(foot) = stances[known].foot
            && let Some(same) = same_foot(&a, &b, recording.runs())
        {
            stances[open].foot = Some(if same { foot } else { foot.other() });
        }
    }
}

/// Contact of a foot with a plate or insole, used or rejected.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Footfall {
    pub channel: usize,
    pub foot: Option<Foot>,
    pub start_s: f64,
    pub end_s: f64,
    pub rejected: Option<RejectReason>,
    /// Whether the stance is an outlier of its channel. An outlier is used only in the sum of both feet.
    pub unlike: bool,
}

impl From<&Stance> for Footfall {
    fn from(s: &Stance) -> Self {
        Footfall {
            channel: s.channel,
            foot: s.foot,
            start_s: s.start_s,
            end_s: s.end_s,
            rejected: None,
            unlike: s.unlike,
        }
    }
}

impl Stances {
    /// Whole stance that belongs to a footfall; `None` if the contact was rejected.
    pub(crate) fn at(&self, fall: &Footfall) -> Option<&Stance> {
        // A rejected contact may start at the same time as a stance of its channel.
        let accepted = fall.rejected.is_none();
        let after = self.used.partition_point(|s| s.start_s < fall.start_s);
        let same = |s: &&Stance| s.start_s == fall.start_s;
        let mut here = self.used[after..].iter().take_while(same);
        here.find(|s| accepted && s.channel == fall.channel)
    }
}

/// All contacts of the recording, in order of their start.
pub(crate) fn footfalls(recording: &Recording, stances: &Stances) -> Vec<Footfall> {
    let mut falls: Vec<Footfall> = stances.used.iter().map(Footfall::from).collect();
    falls.extend(stances.rejected.iter().map(|r| Footfall {
        channel: r.channel,
        foot: recording.channels.get(r.channel).and_then(|c| c.foot),
        start_s: r.from_s,
        end_s: r.to_s,
        rejected: Some(r.reason),
        unlike: false,
    }));
    falls.sort_by(|a, b| a.start_s.total_cmp(&b.start_s));
    falls
}

/// In running, the next contact in a column belongs to the other foot if the pause is shorter than this fraction of the stance.
const ALTERNATE: f64 = 0.9;

/// Whether two consecutive stances belong to the same foot; `None` if this is unknown.
///
/// In walking, the other foot lands before the first foot leaves the ground. The same foot lands again only after its swing phase. In
/// running (`runs`), a flight phase precedes the contact of the other foot. The pause before the next contact of the same foot is more than
/// twice as long.
pub(crate) fn same_foot(a: &Footfall, b: &Footfall, runs: bool) -> Option<bool> {
    if let (Some(a), Some(b)) = (a.foot, b.foot) {
        return Some(a == b);
    }
    let duration = a.end_s - a.start_s;
    let pause = b.start_s - a.end_s;
    let (next, same) = if runs {
        (1.2, 1.2..5.5)
    } else {
        (0.15, 0.3..1.2)
    };
    // Both feet of a runner in one column: the same foot does not land again within the duration of a stance.
    let alternate = pause < ALTERNATE * duration;
    if pause < next * duration && (alternate || !(runs && a.channel == b.channel)) {
        return Some(false);
    }
    (a.channel == b.channel && same.contains(&(pause / duration))).then_some(true)
}

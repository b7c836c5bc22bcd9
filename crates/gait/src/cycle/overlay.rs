//! Single stances over the phase of the stance, with mean and standard deviation of each foot, for a figure.

use super::average::{mean_mass, mean_stance, stance_row};
use crate::interpretation::{MeanStanceCurve, Overlay};
use crate::recording::{Foot, Recording};
use crate::stance::{Point, Stance, Stances};
use crate::statistics::mean as average;

/// Overlay of the used stances; `None` if no stances are used. It contains at most `most` stances, evenly distributed over the recording.
/// The means exclude outliers. If the stances have different masses, forces are scaled to the mean mass.
pub fn overlay(recording: &Recording, stances: &Stances, most: usize) -> Option<Overlay> {
    let all: Vec<&Stance> = stances.used.iter().filter(|s| !s.unlike).collect();
    if all.is_empty() {
        return None;
    }
    let usual = mean_mass(&all);
    let shown = all.iter().step_by(all.len().div_ceil(most.max(1)));
    let curves = shown.map(|s| {
        let mut row = vec![0.0; ROW];
        stance_row(recording, s, usual, 0.0, &mut row);
        (s.foot, row)
    });
    let sides = [Some(Foot::Left), Some(Foot::Right), None];
    let of = |foot: Option<Foot>| -> Vec<&Stance> {
        all.iter().copied().filter(|s| s.foot == foot).collect()
    };
    let means = sides.map(of).into_iter().filter(|own| !own.is_empty());
    Some(Overlay {
        stances: curves.collect(),
        means: means.map(|own| mean_of(recording, &own)).collect(),
    })
}

/// Number of samples of a stance in the figure.
const ROW: usize = 256;

fn mean_of(recording: &Recording, own: &[&Stance]) -> MeanStanceCurve {
    let mean = mean_stance(recording, own, 0.0);
    let point = |of: fn(&Stance) -> Option<Point>| {
        let all: Vec<Point> = own.iter().filter_map(|s| of(s)).collect();
        // A landmark that at least half of the stances lack is omitted.
        let of = |of: fn(&Point) -> f64| average(&all.iter().map(of).collect::<Vec<f64>>());
        (2 * all.len() > own.len()).then(|| Point {
            force_n: of(|p| p.force_n),
            at: of(|p| p.at),
        })
    };
    // If most stances have two peaks, stances with one peak are excluded. Their peak is neither the loading peak nor the push-off peak.
    let single = |s: &Stance| s.valley.is_none();
    let humps = 2 * own.iter().filter(|s| !single(s)).count() > own.len();
    let landmarks = if humps {
        [
            point(|s| s.valley.map(|_| s.p1)),
            point(|s| s.valley),
            point(|s| s.p2),
        ]
    } else {
        [point(|s| Some(s.p1)), None, None]
    };
    MeanStanceCurve {
        foot: own.first().and_then(|s| s.foot),
        count: mean.count,
        duration_s: mean.duration_s,
        mean_n: mean.force,
        spread_n: mean.spread,
        landmarks,
    }
}

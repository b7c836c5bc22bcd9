//! Paths of the two heel markers of a motion-capture recording. The side of a stance and the stride time are determined from them.

use super::Foot;
use crate::statistics::median;

/// Ratio of the heel speeds above which the slower heel belongs to the standing foot.
const SLOWER: f64 = 1.2;
/// Range about the middle of a stance, as fractions of the stance, in which the heel is on the ground and the other foot swings.
const MIDDLE: (f64, f64) = (0.3, 0.6);
/// Minimum distance between the heels in a step, as a fraction of the typical maximum distance in the recording.
const REACH: f64 = 0.5;

/// Coordinates of a marker, in any unit of length.
type Position = [f64; 3];

/// Paths of both heel markers with a common time base.
///
/// ```
/// use gaitcam_gait::{Foot, Heels};
///
/// // The left heel is at rest, and the right heel moves at 1 m/s.
/// let right = (0..50).map(|i| [0.01 * f64::from(i), 0.1, 0.0]).collect();
/// let heels = Heels { rate_hz: 100.0, left: vec![[0.2, 0.0, 0.0]; 50], right };
/// assert_eq!(heels.standing(0.0, 0.4), Some(Foot::Left));
/// assert!(heels.strides_s().is_empty());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Heels {
    /// Number of positions per second, 1/s. The first position is at the time of the first force sample.
    pub rate_hz: f64,
    /// Positions of the left heel, in the axes and the unit of length of the file. They are NaN for frames in which the marker was not
    /// visible.
    pub left: Vec<[f64; 3]>,
    /// Positions of the right heel, with the same axes, unit and marking of invisible frames.
    pub right: Vec<[f64; 3]>,
}

impl Heels {
    /// Standing foot between two times, s: the foot whose heel moves more slowly about the middle of this interval. `None` if the markers
    /// are not visible, or if both heels move at similar speeds.
    pub fn standing(&self, start_s: f64, end_s: f64) -> Option<Foot> {
        let at = |x: f64| ((start_s + x * (end_s - start_s)) * self.rate_hz) as usize;
        let (from, to) = (at(MIDDLE.0), at(MIDDLE.1) + 1);
        let [left, right] = [&self.left, &self.right].map(|path| step(path.get(from..=to)?));
        let (left, right) = (left?, right?);
        if SLOWER * left < right {
            return Some(Foot::Left);
        }
        (SLOWER * right < left).then_some(Foot::Right)
    }

    /// Durations of strides, s. A stride is the time between two consecutive moments at which the same heel is farthest ahead of the other
    /// heel.
    ///
    /// The method follows Zeni, Richards and Higginson (2008), with the other heel instead of the pelvis. The distance between the heels is
    /// also valid on a treadmill. A systematic error of the moments has no effect, because it cancels in the difference of two moments.
    pub fn strides_s(&self) -> Vec<f64> {
        let pairs = self.left.iter().zip(&self.right);
        let apart: Vec<Position> = pairs.map(|(l, r)| [0, 1, 2].map(|k| l[k] - r[k])).collect();
        let along = principal_axis(&apart);
        let ahead: Vec<f64> = apart.iter().map(|d| dot(*d, along)).collect();
        let seen = ahead.split(|x| !x.is_finite());
        let lobes: Vec<Vec<(f64, f64)>> = seen.map(lobes).collect();
        let heights = lobes.iter().flatten().map(|lobe| lobe.1.abs()).collect();
        let least = REACH * median(heights).unwrap_or(0.0);
        let mut strides = Vec::new();
        for lobes in lobes {
            let steps: Vec<(f64, f64)> = lobes.into_iter().filter(|l| l.1.abs() > least).collect();
            let turns = |w: &&[(f64, f64)]| w[0].1 * w[1].1 < 0.0 && w[1].1 * w[2].1 < 0.0;
            let whole = steps.windows(3).filter(turns);
            strides.extend(whole.map(|w| (w[2].0 - w[0].0) / self.rate_hz));
        }
        strides
    }
}

fn dot(a: Position, b: Position) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Mean distance between consecutive positions of a marker; `None` if the marker is visible for less than about half of the interval.
fn step(path: &[Position]) -> Option<f64> {
    let steps = path.windows(2).map(|w| {
        let way = [0, 1, 2].map(|k| w[1][k] - w[0][k]);
        dot(way, way).sqrt()
    });
    let seen: Vec<f64> = steps.filter(|s| s.is_finite()).collect();
    let enough = !seen.is_empty() && 2 * seen.len() + 1 >= path.len();
    enough.then(|| seen.iter().sum::<f64>() / seen.len() as f64)
}

/// Direction in which the mean square of the vectors is a maximum: the first eigenvector of their second moments, by power iteration. For
/// the vectors between the heels, it is the walking direction, because the feet are close together sideways.
fn principal_axis(all: &[Position]) -> Position {
    let seen = || all.iter().filter(|d| dot(**d, **d).is_finite());
    let longest = seen().max_by(|a, b| dot(**a, **a).total_cmp(&dot(**b, **b)));
    let mut axis = longest.copied().unwrap_or([0.0; 3]);
    for _ in 0..30 {
        let mut sum = [0.0; 3];
        for d in seen() {
            let along = dot(*d, axis);
            for (s, x) in sum.iter_mut().zip(d) {
                *s += along * x;
            }
        }
        let length = dot(sum, sum).sqrt();
        if length > 0.0 {
            axis = sum.map(|x| x / length);
        }
    }
    axis
}

/// Position, in samples, and value of the extreme between each two consecutive changes of sign. Each extreme is the vertex of the parabola
/// through three samples. Extremes at an end of the recording are excluded.
fn lobes(ahead: &[f64]) -> Vec<(f64, f64)> {
    let mut found = Vec::new();
    let mut from = 0;
    for lobe in ahead.chunk_by(|a, b| (*a < 0.0) == (*b < 0.0)) {
        let highest = (0..lobe.len()).max_by(|&a, &b| lobe[a].abs().total_cmp(&lobe[b].abs()));
        let top = from + highest.unwrap_or(0);
        from += lobe.len();
        let before = top.checked_sub(1).and_then(|i| ahead.get(i));
        if let (Some(a), Some(c)) = (before, ahead.get(top + 1)) {
            let curvature = a - 2.0 * ahead[top] + c;
            let shift = if curvature == 0.0 {
                0.0
            } else {
                0.5 * (a - c) / curvature
            };
            found.push((top as f64 + shift.clamp(-0.5, 0.5), ahead[top]));
        }
    }
    found
}

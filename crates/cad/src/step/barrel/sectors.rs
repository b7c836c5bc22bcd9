//! How the groove divides a barrel: sectors between angles, in each of which the same walls lie above each other
//! at every radius.
//!
//! Angles count in the sense of growing θ. A groove of several turns may cross itself; where two of its walls meet a
//! sector ends.

use std::f64::consts::TAU;

use gaitcam::cam::{BarrelGroove, Wall};

/// Samples of a turn between which meetings of walls are looked for.
const SAMPLES: usize = 1440;
/// Cuts that are made in any case, so that no face goes more than a third of the way round.
const PLAIN: usize = 4;
/// Angles that are tried for each, how far they may lie from their place, and least distance to a meeting, rad.
const TRIED: usize = 61;
const STRAY: f64 = 0.3;
const CLEAR: f64 = 0.02;
/// Meetings at one angle, rad: what rounding leaves of the symmetry of a law.
const ONE: f64 = 1e-7;

/// One wall of one turn of the groove.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bound {
    pub wall: Wall,
    pub turn: usize,
}

/// Where sectors meet.
#[derive(Debug, Clone)]
pub struct Cut {
    /// Its angle at each radius, rad.
    pub angles: Vec<f64>,
    /// Walls that meet there.
    pub meeting: Vec<[Bound; 2]>,
}

/// The sectors; sector i lies between cut i and the next, the last one ends a turn after the first cut.
pub struct Sectors<'a> {
    groove: &'a BarrelGroove,
    /// Turns after which the law repeats.
    pub turns: usize,
    /// Radii at which the cuts are known, m.
    pub radii: Vec<f64>,
    pub cuts: Vec<Cut>,
    /// Lower and upper wall of each opening of a sector, from below.
    pub openings: Vec<Vec<[Bound; 2]>>,
}

impl<'a> Sectors<'a> {
    /// The sectors of a groove whose law closes and whose walls are not undercut; `None` where its walls meet in one way
    /// at one radius and in another way at another one.
    pub fn of(groove: &'a BarrelGroove, radii: Vec<f64>) -> Option<Self> {
        let (_, length) = groove.law().extent();
        let mut out = Sectors {
            groove,
            turns: (length / TAU).round().max(1.0) as usize,
            radii,
            cuts: Vec::new(),
            openings: Vec::new(),
        };
        let middle = out.radii[out.radii.len() / 2];
        let meetings: Vec<f64> = (out.meetings(0.0, &[middle])?.iter())
            .map(|cut| cut.angles[0])
            .collect();
        let start = out.free_angle(0.0, &meetings);
        let mut cuts = out.meetings(start, &out.radii)?;
        let all: Vec<f64> = cuts.iter().flat_map(|c| c.angles.clone()).collect();
        cuts.extend((0..PLAIN).map(|k| {
            let angle = match k {
                0 => start,
                _ => out.free_angle(start + TAU * k as f64 / PLAIN as f64, &all),
            };
            Cut {
                angles: vec![angle; out.radii.len()],
                meeting: Vec::new(),
            }
        }));
        out.cuts = in_one_order(cuts)?;
        out.openings = (0..out.cuts.len())
            .map(|k| out.openings_of(k))
            .collect::<Option<_>>()?;
        Some(out)
    }

    /// Every wall.
    fn bounds(&self) -> impl Iterator<Item = Bound> + '_ {
        (0..self.turns).flat_map(|turn| [Wall::Lower, Wall::Upper].map(|wall| Bound { wall, turn }))
    }

    /// θ with which a wall is touched at an angle on the cylinder of a radius.
    pub fn theta(&self, bound: Bound, angle: f64, radius: f64) -> f64 {
        let target = angle + TAU * bound.turn as f64;
        let difference = |theta: f64| self.groove.wall_at(theta, radius, bound.wall)[0] - target;
        // The contact is less than the roller's radius aside.
        let reach = (self.groove.roller_radius() / radius).min(1.0).asin();
        root(difference, target - reach, target + reach)
    }

    /// Height of a wall, m.
    pub fn height(&self, bound: Bound, angle: f64, radius: f64) -> f64 {
        let theta = self.theta(bound, angle, radius);
        self.groove.wall_at(theta, radius, bound.wall)[1]
    }

    /// Angle of cut `k` at the radius of index `r`; the cut after the last is the first, a turn later.
    pub fn angle(&self, k: usize, r: usize) -> f64 {
        let turns = k / self.cuts.len();
        self.cuts[k % self.cuts.len()].angles[r] + TAU * turns as f64
    }

    /// Index of cut `k`, which may be the cut after the last, and the wall in that cut's numbering.
    pub fn at_cut(&self, k: usize, bound: Bound) -> (usize, Bound) {
        let (n, passed) = (self.cuts.len(), k / self.cuts.len());
        let turn = (bound.turn + passed) % self.turns;
        let mut own = Bound { turn, ..bound };
        // Walls that meet are one there.
        while let Some(pair) = (self.cuts[k % n].meeting.iter()).find(|pair| pair[1] == own) {
            own = pair[0];
        }
        (k % n, own)
    }

    /// The angles from `start` on, for one turn, at which walls of different turns meet at the edge of the groove.
    fn meetings(&self, start: f64, radii: &[f64]) -> Option<Vec<Cut>> {
        let mut out: Vec<Cut> = Vec::new();
        if self.turns == 1 {
            return Some(out);
        }
        let angle = |i: usize| start + TAU * i as f64 / SAMPLES as f64;
        let bounds: Vec<Bound> = self.bounds().collect();
        let heights: Vec<Vec<Vec<f64>>> = (radii.iter())
            .map(|&radius| {
                let along = |b: &Bound| {
                    (0..=SAMPLES)
                        .map(|i| self.height(*b, angle(i), radius))
                        .collect()
                };
                bounds.iter().map(along).collect()
            })
            .collect();
        for (a, first) in bounds.iter().enumerate() {
            for (b, second) in bounds.iter().enumerate().skip(a + 1) {
                if first.turn == second.turn {
                    continue;
                }
                let at_radius = |r: usize| -> Vec<f64> {
                    let apart = |x: f64| {
                        self.height(*first, x, radii[r]) - self.height(*second, x, radii[r])
                    };
                    let sign = |i: usize| heights[r][a][i] > heights[r][b][i];
                    (0..SAMPLES)
                        .filter(|&i| sign(i) != sign(i + 1))
                        .map(|i| root(apart, angle(i), angle(i + 1)))
                        .filter(|&x| !self.is_covered(x, radii[r], [*first, *second]))
                        .collect()
                };
                let all: Vec<Vec<f64>> = (0..radii.len()).map(at_radius).collect();
                if all.iter().any(|roots| roots.len() != all[0].len()) {
                    return None;
                }
                out.extend((0..all[0].len()).map(|k| Cut {
                    angles: all.iter().map(|roots| roots[k]).collect(),
                    meeting: vec![[*first, *second]],
                }));
            }
        }
        Some(out)
    }

    /// Whether a meeting of two walls lies within the opening of a third turn.
    fn is_covered(&self, angle: f64, radius: f64, pair: [Bound; 2]) -> bool {
        let z = self.height(pair[0], angle, radius);
        (0..self.turns)
            .filter(|turn| pair.iter().all(|b| b.turn != *turn))
            .any(|turn| {
                let at = |wall| self.height(Bound { wall, turn }, angle, radius);
                at(Wall::Lower) < z && z < at(Wall::Upper)
            })
    }

    /// The angle near `place` that keeps clear of `taken` and farthest from the joints of the law.
    fn free_angle(&self, place: f64, taken: &[f64]) -> f64 {
        let joints: Vec<f64> = self.groove.law().joints().iter().map(|j| j.at).collect();
        let distance = |x: f64, all: &[f64]| {
            (all.iter())
                .map(|y| {
                    let d = (x - y).rem_euclid(TAU);
                    d.min(TAU - d)
                })
                .fold(f64::INFINITY, f64::min)
        };
        let tried = |i: usize| place + STRAY * (2.0 * i as f64 / (TRIED - 1) as f64 - 1.0);
        let clear = (0..TRIED)
            .map(tried)
            .filter(|&x| distance(x, taken) > CLEAR);
        let best = clear.max_by(|&x, &y| distance(x, &joints).total_cmp(&distance(y, &joints)));
        best.unwrap_or(place)
    }

    /// The openings of a sector, where they are the same at every radius.
    fn openings_of(&self, k: usize) -> Option<Vec<[Bound; 2]>> {
        let mut at_all = (0..self.radii.len()).map(|r| self.openings_at(k, r));
        let first = at_all.next()?;
        at_all.all(|other| other == first).then_some(first)
    }

    /// The same halfway through the sector at one radius.
    fn openings_at(&self, k: usize, r: usize) -> Vec<[Bound; 2]> {
        let angle = 0.5 * (self.angle(k, r) + self.angle(k + 1, r));
        let mut turns: Vec<[(f64, Bound); 2]> = (0..self.turns)
            .map(|turn| {
                [Wall::Lower, Wall::Upper].map(|wall| {
                    let bound = Bound { wall, turn };
                    (self.height(bound, angle, self.radii[r]), bound)
                })
            })
            .collect();
        turns.sort_by(|a, b| a[0].0.total_cmp(&b[0].0));
        let mut out: Vec<[(f64, Bound); 2]> = Vec::new();
        for next in turns {
            match out.last_mut() {
                Some(last) if next[0].0 <= last[1].0 => {
                    if next[1].0 > last[1].0 {
                        last[1] = next[1];
                    }
                }
                _ => out.push(next),
            }
        }
        out.iter().map(|pair| pair.map(|bound| bound.1)).collect()
    }
}

/// The cuts by their angles, those at one angle put together; `None` where their order depends on the radius.
fn in_one_order(mut cuts: Vec<Cut>) -> Option<Vec<Cut>> {
    cuts.sort_by(|a, b| a.angles[0].total_cmp(&b.angles[0]));
    let mut out: Vec<Cut> = Vec::new();
    for cut in cuts {
        let last = out.last_mut();
        let steps = |last: &Cut| -> Vec<f64> {
            (cut.angles.iter().zip(&last.angles))
                .map(|(x, y)| x - y)
                .collect()
        };
        match last {
            Some(last) if steps(last).iter().all(|d| d.abs() < ONE) => {
                last.meeting.extend(cut.meeting);
            }
            Some(last) if !steps(last).iter().all(|d| *d > ONE) => return None,
            _ => out.push(cut),
        }
    }
    Some(out)
}

/// The zero of a function that changes sign from `low` to `high`: false position with halved weights (Illinois).
fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let (mut below, mut above) = (f(low), f(high));
    for _ in 0..200 {
        if below == 0.0 {
            return low;
        }
        if above == 0.0 {
            return high;
        }
        let x = high - above * (high - low) / (above - below);
        let (at, step) = (f(x), (x - high).abs());
        if (at > 0.0) == (above > 0.0) {
            (high, above) = (x, at);
            below *= 0.5;
        } else {
            (low, below) = (high, above);
            (high, above) = (x, at);
        }
        if step <= f64::EPSILON * high.abs().max(1.0) || at == 0.0 {
            return x;
        }
    }
    high
}

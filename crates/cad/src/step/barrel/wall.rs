//! A wall of the groove between two cuts, as B-spline surfaces.
//!
//! Across the groove's depth all walls have the same spans, so that neighbours share their edges to the last digit;
//! along it the wall is divided where the law's acceleration or jerk jumps, and each part has the spans it needs.

use gaitcam::cam::BarrelGroove;

use super::sectors::{Bound, Sectors};
use crate::spline::{FEWEST, Interpolant};

const MM: f64 = 1000.0;
/// Largest distance of a surface from the true wall, m: what readers of STEP take for one point.
pub const FAITHFUL: f64 = 1e-8;
/// Most spans along a part.
const MOST: usize = 4096;
/// Most spans across the depth.
pub const MOST_ACROSS: usize = 32;
/// A joint nearer to a cut than this, rad, does not divide the wall.
const NEAR: f64 = 1e-4;
/// Jumps of acceleration and jerk, part of the stroke per rad² and rad³, that are rounding.
const ROUNDING: f64 = 1e-9;

/// A part of the wall: control points along the groove, then from floor to surface, mm.
pub struct Part {
    pub net: Vec<Vec<[f64; 3]>>,
    /// Its spline space along the groove.
    pub along: Interpolant,
}

/// The radii at which walls are interpolated, every second of `radii`, as their spline space.
pub fn across(radii: &[f64]) -> Interpolant {
    Interpolant::new(radii.len() / 2)
}

/// Radii from floor to surface, m: the sites of the coarsest spline across the depth that follows the walls, and the places
/// between them where it is held against them.
pub fn radii(groove: &BarrelGroove) -> Option<Vec<f64>> {
    let (start, length) = groove.law().extent();
    let mut spans = FEWEST;
    while spans <= MOST_ACROSS {
        let radii = between(groove.depth(), spans);
        let space = across(&radii);
        let angle = |i: usize| start + length * i as f64 / 360.0;
        let worst = (0..360)
            .flat_map(|i| {
                [gaitcam::cam::Wall::Lower, gaitcam::cam::Wall::Upper].map(|wall| (i, wall))
            })
            .map(|(i, wall)| {
                let column: Vec<[f64; 3]> = (radii.iter())
                    .map(|&r| point(groove, wall, angle(i), r))
                    .collect();
                astray_across(&column, &space)
            })
            .fold(0.0, f64::max);
        // Most of what is allowed is left for the spline along the groove, and for cuts that run across it aslant.
        if worst <= 0.05 * MM * FAITHFUL {
            return Some(radii);
        }
        spans *= 2;
    }
    None
}

fn between((inner, outer): (f64, f64), spans: usize) -> Vec<f64> {
    let at = |k: usize| inner + (outer - inner) * k as f64 / (2 * spans) as f64;
    (0..=2 * spans).map(at).collect()
}

/// Largest distance of the points between the sites of a column from the spline through it, mm.
fn astray_across(column: &[[f64; 3]], space: &Interpolant) -> f64 {
    let sites: Vec<[f64; 3]> = column.iter().step_by(2).copied().collect();
    let control = space.control(&sites);
    (1..column.len())
        .step_by(2)
        .map(|k| apart(space.at(&control, 0.5 * k as f64), column[k]))
        .fold(0.0, f64::max)
}

fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|d| (a[d] - b[d]).powi(2)).sum::<f64>().sqrt()
}

/// A point of a wall at a distance from the axis, mm; the groove runs clockwise seen from +z.
fn point(groove: &BarrelGroove, wall: gaitcam::cam::Wall, theta: f64, radius: f64) -> [f64; 3] {
    let [angle, z] = groove.wall_at(theta, radius, wall);
    let (sin, cos) = angle.sin_cos();
    [MM * radius * cos, -MM * radius * sin, MM * z]
}

/// The point of a wall at cut `k` and the radius of index `r`, mm.
pub fn at_cut(
    groove: &BarrelGroove,
    sectors: &Sectors,
    k: usize,
    bound: Bound,
    r: usize,
) -> [f64; 3] {
    let radius = sectors.radii[r];
    let theta = sectors.theta(bound, sectors.angle(k, r), radius);
    point(groove, bound.wall, theta, radius)
}

/// The parts of a wall between cut `k` and the next, along growing θ; `None` where no spline of so many spans
/// follows it.
pub fn parts(
    groove: &BarrelGroove,
    sectors: &Sectors,
    k: usize,
    bound: Bound,
) -> Option<Vec<Part>> {
    let count = sectors.radii.len();
    let end = |k: usize| -> Vec<f64> {
        (0..count)
            .map(|r| sectors.theta(bound, sectors.angle(k, r), sectors.radii[r]))
            .collect()
    };
    let (from, to) = (end(k), end(k + 1));
    let mut lines = vec![from.clone()];
    lines.extend(
        joints(groove, &from, &to)
            .into_iter()
            .map(|theta| vec![theta; count]),
    );
    lines.push(to);
    lines
        .windows(2)
        .map(|pair| part(groove, sectors, bound.wall, [&pair[0], &pair[1]]))
        .collect()
}

/// Angles between two cuts at which the law's acceleration or jerk jumps.
fn joints(groove: &BarrelGroove, from: &[f64], to: &[f64]) -> Vec<f64> {
    let law = groove.law();
    let (start, length) = law.extent();
    let low = from.iter().copied().fold(f64::MIN, f64::max) + NEAR;
    let high = to.iter().copied().fold(f64::MAX, f64::min) - NEAR;
    let least = ROUNDING * law.stroke();
    let mut out: Vec<f64> = (law.joints().iter())
        .filter(|joint| joint.jump.a.abs().max(joint.jump.j.abs()) > least)
        .flat_map(|joint| {
            // Every turn of the law that lies between the cuts.
            let first = ((low - joint.at) / length).ceil() as i64;
            let last = ((high - joint.at) / length).floor() as i64;
            (first..=last).map(move |n| joint.at + length * n as f64)
        })
        .filter(|theta| theta.is_finite() && *theta > start - 2.0 * length)
        .collect();
    out.sort_by(f64::total_cmp);
    out.dedup_by(|a, b| (*a - *b).abs() < NEAR);
    out
}

/// The wall between two lines of θ, one for each radius.
fn part(
    groove: &BarrelGroove,
    sectors: &Sectors,
    wall: gaitcam::cam::Wall,
    [from, to]: [&[f64]; 2],
) -> Option<Part> {
    let at = |u: f64, r: usize| {
        let theta = from[r] + u * (to[r] - from[r]);
        point(groove, wall, theta, sectors.radii[r])
    };
    let across = across(&sectors.radii);
    let mut spans = FEWEST;
    while spans <= MOST {
        let along = Interpolant::new(spans);
        let mut worst = 0.0_f64;
        let columns: Vec<Vec<[f64; 3]>> = (0..sectors.radii.len())
            .step_by(2)
            .map(|r| {
                let place = |i: f64| at(i / spans as f64, r);
                let points: Vec<[f64; 3]> = (0..=spans).map(|i| place(i as f64)).collect();
                let control = along.control(&points);
                for i in 0..spans {
                    for part in [0.25, 0.5, 0.75] {
                        let x = i as f64 + part;
                        worst = worst.max(apart(along.at(&control, x), place(x)));
                    }
                }
                control
            })
            .collect();
        if worst <= 0.5 * MM * FAITHFUL {
            let slanted = (0..=4)
                .map(|i| {
                    let column: Vec<[f64; 3]> = (0..sectors.radii.len())
                        .map(|r| at(0.25 * f64::from(i), r))
                        .collect();
                    astray_across(&column, &across)
                })
                .fold(0.0, f64::max);
            if slanted > 0.5 * MM * FAITHFUL {
                return None;
            }
            let net = (0..=spans)
                .map(|i| {
                    let row: Vec<[f64; 3]> = columns.iter().map(|column| column[i]).collect();
                    across.control(&row)
                })
                .collect();
            return Some(Part { net, along });
        }
        spans *= 2;
    }
    None
}

//! Path around the outside of a profile, as arcs and lines.
//!
//! Each arc of the profile has a parallel arc about the same centre, so the path is as accurate as the arcs. The path is clockwise, with the cutter
//! on the left of the profile. With a spindle that turns clockwise, this is climb milling.

use super::{Move, Path, feed_on};
use crate::biarc::{self, circle};
use gaitcam::synth::Edge;

/// Maximum distance between the arcs and the profile, m. The sum of this distance and the rounding of the program is below one micrometre.
const ARCS: f64 = 5e-7;
/// Radius of the lead-in and lead-out arcs, as a multiple of the cutter radius.
const LEAD: f64 = 1.0;
const LEAST_LEAD: f64 = 0.002;
/// Length of the line from the start hole of a wire to the profile, m.
const WAY_IN: f64 = 0.003;

/// Kind of lead-in and lead-out: arcs for a milling cutter, lines for a wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lead {
    /// Tangential quarter circles, with which a milling cutter leaves no mark.
    Arcs,
    /// Straight lines along the normal, for a wire that starts outside the blank or in a start hole.
    Lines,
}

/// Path around the outside of an edge for a cutter of radius `tool` m, with lead-in and lead-out of the kind `lead`.
///
/// `None` if arcs cannot approximate the edge (undercut, jumps of the velocity), or if the cutter does not fit into a concave part.
pub fn path(edge: &Edge, tool: f64, lead: Lead) -> Option<Path> {
    let arcs = biarc::along(edge, ARCS)?;
    let mut ends = arcs.vertices;
    if arcs.closed {
        // The path starts at the farthest point. The whole cam is on one side of the tangent at this point, so the leads do not touch the
        // cam.
        let far = |v: &[f64; 3]| libm::hypot(v[0], v[1]);
        let start = (0..ends.len()).max_by(|&a, &b| far(&ends[a]).total_cmp(&far(&ends[b])))?;
        ends.rotate_left(start);
        ends.push(ends[0]);
    }
    let mut moves = Vec::with_capacity(ends.len() + 1);
    let mut sides = Vec::with_capacity(2 * ends.len());
    for pair in ends.windows(2) {
        let (step, normals) = parallel(pair[0], pair[1], tool)?;
        moves.push(step);
        sides.extend(normals);
    }
    let (first, last) = (*sides.first()?, *sides.last()?);
    let begin = [ends[0][0] + tool * first[0], ends[0][1] + tool * first[1]];
    let end = moves.last()?.to;
    Some(match lead {
        Lead::Arcs => with_arcs(moves, [begin, end], [first, last], tool),
        Lead::Lines => with_lines(moves, [begin, end], [first, last], tool),
    })
}

/// Path with a quarter circle as lead-in and another one as lead-out.
fn with_arcs(
    mut moves: Vec<Move>,
    [begin, end]: [[f64; 2]; 2],
    [first, last]: [[f64; 2]; 2],
    tool: f64,
) -> Path {
    let lead = (LEAD * tool).max(LEAST_LEAD);
    // The tangent is the outward normal rotated clockwise: t = (1, 0) for n = (0, 1).
    let along = |n: [f64; 2], by: f64| [by * n[1], -by * n[0]];
    let centre = |p: [f64; 2], n: [f64; 2]| [p[0] + lead * n[0], p[1] + lead * n[1]];
    let from = centre(begin, first);
    let back = along(first, -lead);
    let away = centre(end, last);
    let on = along(last, lead);
    moves.insert(0, Move::arc(begin, from, true));
    moves.push(Move::arc([away[0] + on[0], away[1] + on[1]], away, true));
    Path {
        start: [from[0] + back[0], from[1] + back[1]],
        moves,
    }
}

/// Path with straight lines along the normals as lead-in and lead-out.
fn with_lines(
    mut moves: Vec<Move>,
    [begin, end]: [[f64; 2]; 2],
    [first, last]: [[f64; 2]; 2],
    tool: f64,
) -> Path {
    let lead = WAY_IN + tool;
    let out = |p: [f64; 2], n: [f64; 2]| [p[0] + lead * n[0], p[1] + lead * n[1]];
    moves.insert(0, Move::line(begin));
    moves.push(Move::line(out(end, last)));
    Path {
        start: out(begin, first),
        moves,
    }
}

/// Parallel of an arc of the profile at the distance `tool` (m) on its left, and the outward normals at both ends of the arc. `None` if the cutter
/// does not fit into the arc.
fn parallel(a: [f64; 3], b: [f64; 3], tool: f64) -> Option<(Move, [[f64; 2]; 2])> {
    let (from, to) = ([a[0], a[1]], [b[0], b[1]]);
    let Some((centre, radius)) = circle(from, to, a[2]) else {
        let c = [to[0] - from[0], to[1] - from[1]];
        let long = libm::hypot(c[0], c[1]);
        let n = [-c[1] / long, c[0] / long];
        let step = Move::line([to[0] + tool * n[0], to[1] + tool * n[1]]);
        return Some((step, [n, n]));
    };
    // A concave part turns counter-clockwise, so its centre is outside the cam.
    let hollow = a[2] > 0.0;
    let outward = if hollow { -1.0 } else { 1.0 };
    let path = radius + outward * tool;
    if path <= 0.0 {
        return None;
    }
    let normal = |p: [f64; 2]| [0, 1].map(|k| outward * (p[k] - centre[k]) / radius);
    let (first, last) = (normal(from), normal(to));
    let step = Move {
        to: [to[0] + tool * last[0], to[1] + tool * last[1]],
        arc: Some((centre, hollow)),
        feed: feed_on(path, radius),
    };
    Some((step, [first, last]))
}

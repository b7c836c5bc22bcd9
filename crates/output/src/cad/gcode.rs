//! `cutter.nc`: the path of the cutter's centre as a program for the machine (ISO 6983), in arcs and lines.
//!
//! The arcs that follow the profile have parallels that are arcs about the same centres, so the path is as
//! true as they are. The cam is passed clockwise, the cutter on its left: climb milling with a spindle that
//! turns clockwise. The same path serves a wire, whose radius then is half the wire plus the spark gap.

use std::fmt::Write;

use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::units::Quantity;

use super::biarc::{self, circle};
use super::outline::Edge;

const MM: f64 = 1000.0;
/// Largest distance of the arcs from the profile, m: with the rounding of the program below one micrometre.
const ARCS: f64 = 5e-7;
/// Feed of the point of contact along the profile, mm/min: 0.05 mm per tooth, two teeth, 2000 rpm. Operators
/// turn it with the override.
const FEED: f64 = 200.0;
/// Acceleration that the machine's table keeps to on an arc, mm/s².
const ACCELERATION: f64 = 500.0;
/// Radius of the arcs that lead to the profile and away, in radii of the cutter; at least so much, m.
const LEAD: f64 = 1.0;
const LEAST_LEAD: f64 = 0.002;
/// A feed is written anew when it differs by this part.
const NEW_FEED: f64 = 0.01;

/// A piece of the path; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Move {
    to: [f64; 2],
    /// Centre of an arc and whether it is counter-clockwise; `None` for a line.
    arc: Option<([f64; 2], bool)>,
    /// Feed of the cutter's centre, mm/min.
    feed: f64,
}

/// The program for the outside of the cam with a cutter (or wire with its gap) of radius `tool` m.
///
/// `None` where no chain of arcs follows the profile (undercut, jumps of the velocity), where the cutter does
/// not fit a hollow, and for a barrel, whose groove is milled on a rotary axis.
///
/// # Errors
/// Fails on a radius that is not positive.
pub fn program(design: &Design, tool: f64) -> Result<Option<String>> {
    if !(tool.is_finite() && tool > 0.0) {
        return Err(WriteError::CutterRadius {
            radius: Quantity::length(tool),
        }
        .into());
    }
    if design.groove.is_some() {
        return Ok(None);
    }
    let edge = Edge::of(&design.cam);
    Ok(path(&edge, tool).map(|(start, moves)| text(design, tool, start, &moves)))
}

/// Start and moves, leading arcs included.
fn path(edge: &Edge, tool: f64) -> Option<([f64; 2], Vec<Move>)> {
    let arcs = biarc::along(edge, ARCS)?;
    let mut ends = arcs.vertices;
    if arcs.closed {
        // From the farthest point on: nothing of the cam lies beyond its tangent, so the leads are free.
        let far = |v: &[f64; 3]| v[0].hypot(v[1]);
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
    let lead = (LEAD * tool).max(LEAST_LEAD);
    let begin = [ends[0][0] + tool * first[0], ends[0][1] + tool * first[1]];
    let end = moves.last()?.to;
    // The tangent is the outward normal turned to the right: n = (0, 1) goes with t = (1, 0).
    let along = |n: [f64; 2], by: f64| [by * n[1], -by * n[0]];
    let centre = |p: [f64; 2], n: [f64; 2]| [p[0] + lead * n[0], p[1] + lead * n[1]];
    let from = centre(begin, first);
    let back = along(first, -lead);
    let start = [from[0] + back[0], from[1] + back[1]];
    let away = centre(end, last);
    let on = along(last, lead);
    let leading = |to, about| Move {
        to,
        arc: Some((about, true)),
        feed: FEED,
    };
    moves.insert(0, leading(begin, from));
    moves.push(leading([away[0] + on[0], away[1] + on[1]], away));
    Some((start, moves))
}

/// The parallel of one arc of the profile at the distance `tool` on its left, with the outward normals at its
/// ends; `None` where the cutter does not fit into it.
fn parallel(a: [f64; 3], b: [f64; 3], tool: f64) -> Option<(Move, [[f64; 2]; 2])> {
    let (from, to) = ([a[0], a[1]], [b[0], b[1]]);
    let Some((centre, radius)) = circle(from, to, a[2]) else {
        let c = [to[0] - from[0], to[1] - from[1]];
        let long = c[0].hypot(c[1]);
        let n = [-c[1] / long, c[0] / long];
        let step = Move {
            to: [to[0] + tool * n[0], to[1] + tool * n[1]],
            arc: None,
            feed: FEED,
        };
        return Some((step, [n, n]));
    };
    // A hollow turns counter-clockwise: its centre lies outside the cam.
    let hollow = a[2] > 0.0;
    let outward = if hollow { -1.0 } else { 1.0 };
    let path = radius + outward * tool;
    if path <= 0.0 {
        return None;
    }
    let normal = |p: [f64; 2]| [0, 1].map(|k| outward * (p[k] - centre[k]) / radius);
    let (first, last) = (normal(from), normal(to));
    let most = 60.0 * (ACCELERATION * MM * path).sqrt();
    let step = Move {
        to: [to[0] + tool * last[0], to[1] + tool * last[1]],
        arc: Some((centre, hollow)),
        feed: (FEED * path / radius).min(most),
    };
    Some((step, [first, last]))
}

fn text(design: &Design, tool: f64, start: [f64; 2], moves: &[Move]) -> String {
    let mut out = String::from("%\n");
    let thickness = MM * design.thickness;
    // Writing to a String cannot fail.
    let _ = write!(
        out,
        "({})\n(CENTRE PATH, RADIUS OF CUTTER OR OF WIRE AND GAP {:.4} MM, NO COMPENSATION)\n\
         (ZERO AT THE CENTRE OF THE CAM, +Y ALONG THE FOLLOWER AT THETA = 0)\n\
         (FEED {FEED:.0} MM/MIN AT THE PROFILE)\n\
         G90 G21 G17 G40 G94\nG0 X{:.4} Y{:.4}\nM0 (TOOL TO DEPTH, PLATE {thickness:.3} MM)\n",
        comment(&design.name),
        MM * tool,
        MM * start[0],
        MM * start[1],
    );
    let mut at = start;
    let mut feed: f64 = 0.0;
    for step in moves {
        let [x, y] = step.to.map(|v| MM * v);
        let _ = match step.arc {
            None => write!(out, "G1 X{x:.4} Y{y:.4}"),
            Some((centre, counter_clockwise)) => {
                let code = if counter_clockwise { "G3" } else { "G2" };
                let [i, j] = [0, 1].map(|k| MM * (centre[k] - rounded(at[k])));
                write!(out, "{code} X{x:.4} Y{y:.4} I{i:.4} J{j:.4}")
            }
        };
        if (step.feed - feed).abs() > NEW_FEED * feed {
            feed = step.feed;
            let _ = write!(out, " F{feed:.0}");
        }
        out.push('\n');
        at = step.to;
    }
    out.push_str("M0 (TOOL CLEAR)\nM30\n%\n");
    // −0.0000 is 0 to people and an error to some machines.
    out.replace("-0.0000", "0.0000")
}

/// A coordinate as the program writes it, m.
fn rounded(x: f64) -> f64 {
    (x * 1e7).round() / 1e7
}

/// Letters that every control reads within a comment.
fn comment(name: &str) -> String {
    let plain = |c: char| match c.to_ascii_uppercase() {
        c @ ('A'..='Z' | '0'..='9' | ' ' | '.' | '-' | '_') => c,
        _ => '_',
    };
    name.chars().map(plain).take(40).collect()
}

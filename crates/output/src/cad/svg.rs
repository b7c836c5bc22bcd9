//! `profile.svg`: the cam's outline at true scale, one user unit per millimetre.

use std::fmt::Write;

use crate::cad::outline::{Edge, EdgePoint, marks};
use crate::escape::escaped;
use gaitcam::synth::Synthesis;

const MM: f64 = 1000.0;
/// Blank edge around the drawing, mm.
const MARGIN: f64 = 5.0;

/// The edges that are cut with pitch curve, base and prime circle and centre mark; printed at 100 % it is
/// the cam.
///
/// `points` vertices at equal steps of the cam angle; width and height are in mm, the cam's y points up.
pub fn profile(synthesis: &Synthesis, points: usize) -> String {
    let follower = &synthesis.cam.follower;
    let edges: Vec<(Edge, Vec<EdgePoint>)> = Edge::all(synthesis)
        .into_iter()
        .map(|edge| (edge, edge.points(points)))
        .collect();
    let marks = marks(synthesis);
    let (base, prime) = (MM * follower.base_radius(), MM * follower.prime_radius());
    let (mut low, mut high) = if follower.is_unrolled() {
        ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2])
    } else {
        ([-prime; 2], [prime; 2])
    };
    let drawn = edges.iter().flat_map(|(_, p)| p);
    let ends = marks.iter().flat_map(|(_, ends)| *ends);
    for p in drawn.flat_map(|e| [e.p, e.pitch]).chain(ends) {
        for (k, x) in p.into_iter().enumerate() {
            low[k] = low[k].min(MM * x);
            high[k] = high[k].max(MM * x);
        }
    }
    let (left, top) = (low[0] - MARGIN, -high[1] - MARGIN);
    let (width, height) = (
        high[0] - low[0] + 2.0 * MARGIN,
        high[1] - low[1] + 2.0 * MARGIN,
    );
    let mut out = String::with_capacity(64 * points * edges.len() + 1024);
    // Writing to a String cannot fail.
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.3}mm\" height=\"{height:.3}mm\" \
         viewBox=\"{left:.3} {top:.3} {width:.3} {height:.3}\" fill=\"none\" stroke-width=\"0.2\">\n\
         <title>{}: cam profile, true scale, mm</title>",
        escaped(&synthesis.name)
    );
    if !follower.is_unrolled() {
        circles(&mut out, synthesis, base, prime);
    }
    for edge in Edge::pitch_curves(synthesis) {
        let curve = edge.points(points);
        let pitch = path(curve.iter().map(|e| e.pitch), edge.is_closed());
        let _ = writeln!(
            out,
            "<path id=\"{}\" d=\"{pitch}\" stroke=\"#E69F00\" stroke-dasharray=\"2 1\"/>",
            edge.id()
        );
    }
    for (edge, points) in &edges {
        let outline = path(points.iter().map(|e| e.p), edge.is_closed());
        let _ = writeln!(
            out,
            "<path id=\"{}\" d=\"{outline}\" stroke=\"#000000\" stroke-width=\"0.25\"/>",
            edge.id()
        );
    }
    let mut d = String::new();
    for (_, ends) in &marks {
        d += &path(ends.iter().copied(), false);
    }
    let id = marks.first().map_or("", |m| m.0).to_lowercase();
    let _ = writeln!(
        out,
        "<path id=\"{id}\" d=\"{d}\" stroke=\"#000000\"/>\n</svg>"
    );
    out
}

/// Base and prime circle and bore of a cam that turns; radii in mm.
fn circles(out: &mut String, synthesis: &Synthesis, base: f64, prime: f64) {
    let _ = writeln!(
        out,
        "<circle id=\"base-circle\" r=\"{base:.6}\" stroke=\"#009E73\" stroke-dasharray=\"2 1\"/>"
    );
    if prime != base {
        let _ = writeln!(
            out,
            "<circle id=\"prime-circle\" r=\"{prime:.6}\" stroke=\"#CC79A7\" stroke-dasharray=\"3 1 0.6 1\"/>"
        );
    }
    if let Some(bore) = synthesis.bore {
        let _ = writeln!(
            out,
            "<circle id=\"bore\" r=\"{:.6}\" stroke=\"#000000\"/>",
            0.5 * MM * bore
        );
    }
}

/// Path data in mm with y down, to a nanometre.
fn path(points: impl Iterator<Item = [f64; 2]>, closed: bool) -> String {
    let mut d = String::new();
    for (i, [x, y]) in points.enumerate() {
        let letter = if i == 0 { 'M' } else { 'L' };
        let _ = write!(d, "{letter}{:.6} {:.6}", MM * x, -MM * y);
    }
    if closed {
        d.push('Z');
    }
    d
}

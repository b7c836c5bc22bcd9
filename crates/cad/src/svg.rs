//! `profile.svg`: outline of the cam at true scale, with one user unit per millimetre.

use std::fmt::Write;

use crate::outline::{Arrow, id, marks, zero_mark};
use gaitcam::cam::Bore;
use gaitcam::synth::Design;
use gaitcam::synth::{Edge, EdgePoint};
use gaitcam_base::text::append;
use gaitcam_base::text::escaped;

const MM: f64 = 1000.0;
/// Width of the empty margin around the drawing, mm.
const MARGIN: f64 = 5.0;

/// Drawing of the edges to be cut, the pitch curve, the base and prime circles, and the centre mark. Printed at 100 %, the drawing has the size of
/// the cam.
///
/// The edges have `points` vertices at equal steps of the cam angle. Width and height are in mm. The cam's y axis points up.
pub fn profile(synthesis: &Design, points: usize) -> String {
    let follower = &synthesis.cam.follower;
    let edges = Edge::all(synthesis).into_iter();
    let edges: Vec<(Edge, Vec<EdgePoint>)> = edges.map(|e| (e, e.points(points))).collect();
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
    let [width, height] = [0, 1].map(|k| high[k] - low[k] + 2.0 * MARGIN);
    let mut out = String::with_capacity(64 * points * edges.len() + 1024);
    // Writing to a String cannot fail.
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.3}mm\" height=\"{height:.3}mm\" \
         viewBox=\"{left:.3} {top:.3} {width:.3} {height:.3}\" fill=\"none\" stroke-width=\"0.2\">\n\
         <title>{}: cam profile, true scale, mm</title>",
        escaped(&synthesis.problem.name)
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
            id(edge.layer)
        );
    }
    for (edge, points) in &edges {
        let outline = path(points.iter().map(|e| e.p), edge.is_closed());
        let _ = writeln!(
            out,
            "<path id=\"{}\" d=\"{outline}\" stroke=\"#000000\" stroke-width=\"0.25\"/>",
            id(edge.layer)
        );
    }
    let lines = marks.iter().map(|m| path(m.1.iter().copied(), false));
    let d: String = lines.collect();
    let id = marks.first().map_or(String::new(), |m| id(m.0));
    let _ = writeln!(
        out,
        "<path id=\"{id}\" d=\"{d}\" stroke=\"#000000\"/>\n</svg>"
    );
    out
}

/// Adds the base circle, prime circle and bore of a rotating cam, the mark of θ = 0 and the arrow of rotation. The radii `base` and `prime` are in
/// mm.
fn circles(out: &mut String, synthesis: &Design, base: f64, prime: f64) {
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
    if let Some(bore) = synthesis.problem.cam.hole() {
        let _ = writeln!(
            out,
            "<path id=\"bore\" d=\"{}\" stroke=\"#000000\"/>",
            hole(&bore)
        );
    }
    let bore = synthesis.problem.cam.hole().map_or(0.0, |b| MM * b.reach());
    let [from, to] = zero_mark(base, bore);
    let _ = writeln!(
        out,
        "<path id=\"theta-zero\" d=\"M{:.3} {:.3}V{:.3}\" stroke=\"#000000\"/>",
        from[0], -from[1], -to[1]
    );
    rotation(
        out,
        &Arrow::new(base, bore, synthesis.problem.drive.speed < 0.0),
    );
}

/// Edge of the bore as path data in mm with y downwards.
pub(crate) fn hole(bore: &Bore) -> String {
    let edge = bore.outline();
    let place = |[x, y, _]: [f64; 3]| format!("{:.6} {:.6}", MM * x, -MM * y);
    let mut d = format!("M{}", place(edge[0]));
    for (i, from) in edge.iter().enumerate() {
        let to = place(edge[(i + 1) % edge.len()]);
        // A counter-clockwise arc in the cam's frame has the sweep flag 0 if y points downwards.
        d += &match from[2] {
            0.0 => format!("L{to}"),
            _ => format!("A{r:.6} {r:.6} 0 0 0 {to}", r = MM * bore.radius()),
        };
    }
    d + "Z"
}

fn rotation(out: &mut String, arrow: &Arrow) {
    let ([from, tip], [a, b]) = (arrow.ends, arrow.head);
    let _ = writeln!(
        out,
        "<path id=\"rotation\" d=\"M{:.3} {:.3}A{r:.3} {r:.3} 0 0 {} {:.3} {:.3}M{:.3} {:.3}L{:.3} {:.3} {:.3} {:.3}\" \
         stroke=\"#000000\"/>",
        from[0],
        -from[1],
        u8::from(arrow.clockwise),
        tip[0],
        -tip[1],
        a[0],
        -a[1],
        tip[0],
        -tip[1],
        b[0],
        -b[1],
        r = arrow.radius,
    );
}

/// Path data in mm with y downwards, rounded to a nanometre.
fn path(points: impl Iterator<Item = [f64; 2]>, closed: bool) -> String {
    let mut d = String::new();
    for (i, [x, y]) in points.enumerate() {
        d.push(if i == 0 { 'M' } else { 'L' });
        append(&mut d, MM * x, 6);
        d.push(' ');
        append(&mut d, -MM * y, 6);
    }
    if closed {
        d.push('Z');
    }
    d
}

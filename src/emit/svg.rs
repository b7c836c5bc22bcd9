//! `profile.svg`: the cam's outline at true scale, one user unit per millimetre.

use std::fmt::Write;

use crate::synth::Synthesis;

const MM: f64 = 1000.0;
/// Blank edge around the drawing, mm.
const MARGIN: f64 = 5.0;

/// The outline with pitch curve, base and prime circle and centre mark; printed at 100 % it is the cam.
///
/// `points` vertices at equal steps of the cam angle; width and height are in mm, the cam's y points up.
pub fn profile(synthesis: &Synthesis, points: usize) -> String {
    let cam = &synthesis.cam;
    let rows = cam.profile(points);
    let closed = cam.law.is_closed();
    let (base, prime) = (
        MM * cam.follower.base_radius(),
        MM * cam.follower.prime_radius(),
    );
    let mut low = [-prime, -prime];
    let mut high = [prime, prime];
    for p in &rows {
        for (k, value) in [(0, p.x), (1, p.y), (0, p.pitch_x), (1, p.pitch_y)] {
            low[k] = low[k].min(MM * value);
            high[k] = high[k].max(MM * value);
        }
    }
    let (left, top) = (low[0] - MARGIN, -high[1] - MARGIN);
    let (width, height) = (
        high[0] - low[0] + 2.0 * MARGIN,
        high[1] - low[1] + 2.0 * MARGIN,
    );
    let outline = path(rows.iter().map(|p| [p.x, p.y]), closed);
    let mut out = String::with_capacity(2 * outline.len() + 1024);
    // Writing to a String cannot fail.
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.3}mm\" height=\"{height:.3}mm\" \
         viewBox=\"{left:.3} {top:.3} {width:.3} {height:.3}\" fill=\"none\" stroke-width=\"0.2\">\n\
         <title>{}: cam profile, true scale, mm</title>",
        escaped(&synthesis.name)
    );
    let _ = writeln!(
        out,
        "<circle id=\"base-circle\" r=\"{base:.6}\" stroke=\"#009E73\" stroke-dasharray=\"2 1\"/>"
    );
    if prime != base {
        let _ = writeln!(
            out,
            "<circle id=\"prime-circle\" r=\"{prime:.6}\" stroke=\"#CC79A7\" stroke-dasharray=\"3 1 0.6 1\"/>"
        );
        let pitch = path(rows.iter().map(|p| [p.pitch_x, p.pitch_y]), closed);
        let _ = writeln!(
            out,
            "<path id=\"pitch-curve\" d=\"{pitch}\" stroke=\"#E69F00\" stroke-dasharray=\"2 1\"/>"
        );
    }
    if let Some(bore) = synthesis.bore {
        let _ = writeln!(
            out,
            "<circle id=\"bore\" r=\"{:.6}\" stroke=\"#000000\"/>",
            0.5 * MM * bore
        );
    }
    let _ = writeln!(
        out,
        "<path id=\"profile\" d=\"{outline}\" stroke=\"#000000\" stroke-width=\"0.25\"/>\n\
         <path id=\"centre\" d=\"M-3 0H3M0 -3V3\" stroke=\"#000000\"/>\n</svg>"
    );
    out
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

/// Text made safe for element content and attributes.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // Control characters have no place in XML, even escaped.
            c if c.is_control() && !matches!(c, '\n' | '\t') => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

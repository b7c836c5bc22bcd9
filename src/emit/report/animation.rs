//! The cam in motion: a drawing whose parts the page's script turns and lifts.

use std::fmt::Write;

use serde::Serialize;

use crate::emit::geometry::{Pose, angles, face_reach, pose, turned};
use crate::emit::samples::lift_unit;
use crate::synth::Synthesis;

const MM: f64 = 1000.0;
/// Steps of the motion; the script goes straight from one to the next.
const STEPS: usize = 480;
/// Vertices of the outline.
const POINTS: usize = 720;

/// What the script knows, one value per step and the last again at the end; mm, N, degrees.
#[derive(Serialize)]
struct Motion {
    start: f64,
    length: f64,
    /// Time of one cycle, s.
    period: f64,
    unit: &'static str,
    s: Vec<Option<f64>>,
    f: Vec<Option<f64>>,
    rho: Vec<Option<f64>>,
    phi: Vec<Option<f64>>,
    cx: Vec<Option<f64>>,
    cy: Vec<Option<f64>>,
    px: Vec<Option<f64>>,
    py: Vec<Option<f64>>,
    pa: Vec<Option<f64>>,
}

/// Four decimals are a tenth of a micrometre; what is not finite becomes null.
fn rounded(x: f64) -> Option<f64> {
    x.is_finite().then(|| (x * 1e4).round() / 1e4)
}

fn motion(synthesis: &Synthesis) -> Motion {
    let cam = &synthesis.cam;
    let (start, length) = cam.law.extent();
    let (factor, unit) = lift_unit(synthesis);
    let mut out = Motion {
        start: start.to_degrees(),
        length: length.to_degrees(),
        period: length / synthesis.drive.speed,
        unit,
        s: Vec::new(),
        f: Vec::new(),
        rho: Vec::new(),
        phi: Vec::new(),
        cx: Vec::new(),
        cy: Vec::new(),
        px: Vec::new(),
        py: Vec::new(),
        pa: Vec::new(),
    };
    for i in 0..=STEPS {
        let theta = start + length * i as f64 / STEPS as f64;
        let at = cam.law.svaj(theta);
        let p = cam.point(theta);
        let [cx, cy] = turned([MM * p.x, MM * p.y], theta);
        let (foot, angle) = match pose(cam, theta) {
            Pose::Face { at, angle } => (at, angle),
            Pose::Roller { centre, .. } => (centre, 0.0),
        };
        // Beyond a hundred prime radii a flank is straight to the eye.
        let straight = p.rho.abs() > 100.0 * cam.follower.prime_radius();
        out.s.push(rounded(factor * at.s));
        out.f.push(rounded(synthesis.drive.force(at)));
        out.rho
            .push(if straight { None } else { rounded(MM * p.rho) });
        out.phi.push(rounded(p.pressure_angle.to_degrees()));
        out.cx.push(rounded(cx));
        out.cy.push(rounded(cy));
        out.px.push(rounded(MM * foot[0]));
        out.py.push(rounded(MM * foot[1]));
        out.pa.push(rounded(angle.to_degrees()));
    }
    out
}

/// The drawing, its controls and the live values.
pub fn stage(out: &mut String, synthesis: &Synthesis) {
    let cam = &synthesis.cam;
    let rows = cam.profile(POINTS);
    let closed = cam.law.is_closed();
    let (base, prime) = (
        MM * cam.follower.base_radius(),
        MM * cam.follower.prime_radius(),
    );
    let pitch_reach = rows
        .iter()
        .map(|p| p.pitch_x.hypot(p.pitch_y))
        .fold(0.0, f64::max);
    let reach = MM * rows.iter().map(|p| p.x.hypot(p.y)).fold(0.0, f64::max);
    let rim = prime.max(MM * pitch_reach);
    let stem = 0.34 * reach;
    let poses: Vec<Pose> = angles(&cam.law, STEPS).map(|t| pose(cam, t)).collect();
    let top = poses.iter().fold(rim, |m, p| {
        m.max(match p {
            Pose::Face { at, .. } => MM * at[1],
            Pose::Roller { centre, radius } => MM * (centre[1] + radius),
        })
    }) + stem;
    let side = face_reach(cam).map_or(rim, |(low, high)| rim.max(MM * high).max(-MM * low));
    let blank = 0.06 * side;
    let (left, width, height) = (-side - blank, 2.0 * (side + blank), top + rim + 1.5 * blank);
    let _ = write!(
        out,
        "<div class=\"stage\">\n<svg viewBox=\"{left:.3} {:.3} {width:.3} {height:.3}\" role=\"img\" \
         aria-label=\"The turning cam lifts its follower\" fill=\"none\"><g transform=\"scale(1 -1)\">\n\
         <g id=\"cam-turning\">",
        -top - 0.5 * blank
    );
    let outline = path(rows.iter().map(|p| [p.x, p.y]), closed);
    let _ = write!(
        out,
        "<path d=\"{outline}\" style=\"fill:var(--blue);stroke:var(--blue)\" fill-opacity=\".16\" stroke-width=\"2.2\"/>\
         <circle r=\"{base:.4}\" style=\"stroke:var(--green)\" stroke-dasharray=\"6 4\" stroke-width=\"1.3\"/>\
         <path d=\"M0 0V{:.4}\" style=\"stroke:var(--quiet)\" stroke-width=\"1.2\"/>",
        0.8 * base
    );
    if prime != base {
        let pitch = path(rows.iter().map(|p| [p.pitch_x, p.pitch_y]), closed);
        let _ = write!(
            out,
            "<path d=\"{pitch}\" style=\"stroke:var(--orange)\" stroke-dasharray=\"3 3\" stroke-width=\"1.3\"/>"
        );
    }
    let mark = 0.06 * reach;
    let _ = write!(
        out,
        "</g>\n<path d=\"M{:.3} 0H{mark:.3}M0 {:.3}V{mark:.3}\" style=\"stroke:var(--ink)\" stroke-width=\"1.4\"/>\n",
        -mark, -mark
    );
    follower(out, synthesis, poses.first(), reach, stem);
    let _ = write!(
        out,
        "<circle id=\"cam-contact\" r=\"{:.3}\" style=\"fill:var(--red)\"/>\n</g></svg>\n",
        0.008 * width.max(height)
    );
    controls(out, synthesis);
    out.push_str("</div>\n");
    // Only numbers and a unit: nothing here can end the script element.
    let data = serde_json::to_string(&motion(synthesis)).unwrap_or_default();
    let _ = writeln!(
        out,
        "<script type=\"application/json\" id=\"motion\">{data}</script>"
    );
}

/// The follower about its own origin: the foot of the stem, or the roller's centre.
fn follower(out: &mut String, synthesis: &Synthesis, pose: Option<&Pose>, reach: f64, stem: f64) {
    let half = 0.04 * reach;
    let look = "style=\"fill:var(--grid);stroke:var(--ink)\" stroke-width=\"1.6\"";
    out.push_str("<g id=\"cam-follower\">");
    let _ = match pose {
        Some(Pose::Roller { radius: 0.0, .. }) => {
            let shoulder = 2.5 * half;
            write!(
                out,
                "<path d=\"M0 0L{:.3} {shoulder:.3}V{stem:.3}H{half:.3}V{shoulder:.3}Z\" {look}/>",
                -half
            )
        }
        Some(Pose::Roller { radius, .. }) => {
            let r = MM * radius;
            let top = r + stem;
            write!(
                out,
                "<path d=\"M{:.3} 0V{top:.3}H{half:.3}V0\" {look}/><circle r=\"{r:.4}\" {look}/>\
                 <circle r=\"{:.3}\" style=\"fill:var(--ink)\"/>",
                -half,
                0.2 * half
            )
        }
        _ => {
            let (low, high) = face_reach(&synthesis.cam).unwrap_or((0.0, 0.0));
            let more = 0.08 * reach;
            let thick = 0.035 * reach;
            write!(
                out,
                "<path d=\"M{:.3} {thick:.3}V{stem:.3}H{half:.3}V{thick:.3}\" {look}/>\
                 <path d=\"M{:.3} 0H{:.3}V{thick:.3}H{:.3}Z\" {look}/>",
                -half,
                MM * low - more,
                MM * high + more,
                MM * low - more
            )
        }
    };
    out.push_str("</g>\n");
}

fn controls(out: &mut String, synthesis: &Synthesis) {
    let (start, length) = synthesis.cam.law.extent();
    let _ = write!(
        out,
        "<div class=\"live\">\n<div><button id=\"play\" type=\"button\">Play</button></div>\n\
         <label>cam angle<input id=\"angle\" type=\"range\" min=\"{:.3}\" max=\"{:.3}\" step=\"any\" value=\"{:.3}\"></label>\n\
         <label><span>speed: <span id=\"pace\"></span></span>\
         <input id=\"speed\" type=\"range\" min=\"-2.3\" max=\"0\" step=\"0.05\" value=\"-1\"></label>\n<table>",
        start.to_degrees(),
        (start + length).to_degrees(),
        start.to_degrees()
    );
    let mut rows = vec![
        ("now-angle", "cam angle θ"),
        ("now-lift", "lift s"),
        ("now-force", "force F"),
        ("now-rho", "radius ρ there"),
    ];
    if synthesis.cam.face_width().is_none() {
        rows.push(("now-phi", "pressure angle φ"));
    }
    for (id, name) in rows {
        let _ = write!(out, "<tr><td>{name}</td><td id=\"{id}\">—</td></tr>");
    }
    out.push_str("</table>\n");
    if synthesis.drive.kind == crate::drive::DriveKind::MovingAxis {
        out.push_str(
            "<p class=\"note\">Seen from the shaft: in the machine the plate stands still and the shaft rises.</p>\n",
        );
    }
    out.push_str("</div>\n");
}

/// Path data in mm, y up as in the cam's frame.
fn path(points: impl Iterator<Item = [f64; 2]>, closed: bool) -> String {
    let mut d = String::new();
    for (i, [x, y]) in points.enumerate() {
        let letter = if i == 0 { 'M' } else { 'L' };
        let _ = write!(d, "{letter}{:.4} {:.4}", MM * x, MM * y);
    }
    if closed {
        d.push('Z');
    }
    d
}

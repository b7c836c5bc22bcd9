//! Animation of the cam: a drawing whose parts are moved by the script of the page.

use std::fmt::Write;

use super::Running;
use super::motion::{STEPS, angle_unit, motion, placed, slide};
use crate::pose::{Bounds, Pose, angles, face_reach, pose};
use crate::words::Words;
use gaitcam::cam::{Cam, Follower, ProfilePoint};
use gaitcam::synth::Design;
use gaitcam_base::text::append;
use gaitcam_base::text::escaped;

const MM: f64 = 1000.0;
/// Number of vertices of the profile.
const POINTS: usize = 720;

/// Style attributes of the first cam in the SVG.
const BODY: &str =
    "style=\"fill:var(--blue);stroke:var(--blue)\" fill-opacity=\".16\" stroke-width=\"2.2\"";
const SECOND: &str =
    "style=\"fill:var(--purple);stroke:var(--purple)\" fill-opacity=\".12\" stroke-width=\"1.8\"";
const PITCH: &str = "data-part=\"pitch\" style=\"stroke:var(--orange)\" stroke-dasharray=\"3 3\" stroke-width=\"1.3\"";
const BASE: &str = "style=\"stroke:var(--green)\" stroke-dasharray=\"6 4\" stroke-width=\"1.3\"";
const PRIME: &str = "style=\"stroke:var(--quiet)\" stroke-dasharray=\"2 3\" stroke-width=\"1.2\"";
const BORE: &str =
    "style=\"fill:var(--paper);stroke:var(--ink)\" fill-opacity=\".6\" stroke-width=\"1.2\"";
const FOLLOWER: &str = "style=\"fill:var(--grid);stroke:var(--ink)\" stroke-width=\"1.6\"";

/// Adds an SVG path with a style to the drawing.
fn shape(out: &mut String, d: &str, style: &str) {
    // Writing to a String cannot fail, here and below.
    let _ = write!(out, "<path d=\"{d}\" {style}/>");
}

/// Writes the drawing, its controls and the live values. If `running` is given, motion and values are those of the simulation.
pub fn stage(out: &mut String, synthesis: &Design, running: Option<&Running>, words: &Words) {
    out.push_str("<div class=\"stage\">\n");
    drawing(out, synthesis, running, words);
    controls(out, synthesis, running, words);
    out.push_str("</div>\n");
    // The data contain only numbers and units, so they cannot close the script element.
    let data = serde_json::to_string(&motion(synthesis, running)).unwrap_or_default();
    let _ = writeln!(
        out,
        "<script type=\"application/json\" id=\"motion\">{data}</script>"
    );
}

/// Writes the drawing as SVG in mm, y upwards. Its moving parts have the ids `cam-turning`, `cam-follower`, `cam-second`, `cam-push` and
/// `cam-contact`.
pub fn drawing(out: &mut String, synthesis: &Design, running: Option<&Running>, words: &Words) {
    let cam = &synthesis.cam;
    let rows = cam.profile(POINTS);
    let slides = slide(cam) > 0.0;
    let reach = reach(cam, &rows);
    let stem = 0.34 * reach;
    let room = room(synthesis, running, reach, stem);
    let [wide, high] = [0, 1].map(|k| room.high[k] - room.low[k]);
    let blank = 0.04 * wide;
    let (width, height) = (wide + 2.0 * blank, high + 2.0 * blank);
    let _ = write!(
        out,
        "<svg viewBox=\"{:.3} {:.3} {width:.3} {height:.3}\" role=\"img\" \
         aria-label=\"{}\" fill=\"none\"><g transform=\"scale(1 -1)\">\n\
         <g id=\"cam-turning\">",
        room.low[0] - blank,
        -room.high[1] - blank,
        escaped(&words.text("report-alt-animation"))
    );
    if slides {
        sliding_body(out, cam, &rows, room.low[1] - blank);
    } else {
        turning_body(out, synthesis, running, &rows);
    }
    out.push_str("</g>\n");
    let mark = 0.06 * reach;
    if !slides {
        let d = format!("M{0:.3} 0H{mark:.3}M0 {0:.3}V{mark:.3}", -mark);
        shape(out, &d, "style=\"stroke:var(--ink)\" stroke-width=\"1.4\"");
        out.push('\n');
    }
    for follower in followers(synthesis) {
        draw_follower(out, &follower, reach, stem);
    }
    let dot = 0.008 * width.max(height);
    let _ = write!(
        out,
        "<g id=\"cam-push\" data-reach=\"{:.3}\"><path d=\"M0 0H1M.82 .09L1 0L.82 -.09\" style=\"stroke:var(--red)\" stroke-width=\"2.4\"/></g>\
         <circle id=\"cam-contact\" r=\"{dot:.3}\" style=\"fill:var(--red)\"/>\n</g></svg>\n",
        1.2 * stem
    );
}

/// Bounds of all parts of the drawing over a whole turn, mm.
fn room(synthesis: &Design, running: Option<&Running>, reach: f64, stem: f64) -> Bounds {
    let mut room = Bounds::default();
    let cam = &synthesis.cam;
    if slide(cam) > 0.0 {
        let travel = slide(cam) * cam.law.extent().1;
        let half = (0.5 * travel).min(4.0 * reach);
        room.hold([-half, -0.15 * reach], 0.0);
        room.hold([half, reach], 0.0);
    } else {
        room.hold([0.0, 0.0], reach);
    }
    for follower in followers(synthesis) {
        for theta in angles(&follower.cam.law, STEPS) {
            let (at, _) = placed(follower.cam, theta);
            let [x, y] = at.map(|q| follower.sign * MM * q);
            let r = MM * follower.cam.follower.roller_radius();
            room.hold([x, y], r);
            if follower.cam.follower.pivot().is_none() {
                room.hold([x, y + follower.sign * (stem + r)], 0.0);
            }
        }
        if let Some(pivot) = follower.cam.follower.pivot() {
            room.hold(pivot.map(|q| follower.sign * MM * q), 0.1 * reach);
        }
        if let (Some((low, high)), None) = (face_reach(follower.cam), follower.cam.follower.pivot())
        {
            room.hold([MM * low, 0.0], 0.1 * reach);
            room.hold([MM * high, 0.0], 0.1 * reach);
        }
    }
    if let Some(r) = running {
        let gap = r.outcome.rows.iter().fold(0.0_f64, |m, row| m.max(row.gap));
        if !cam.follower.is_oscillating() {
            room.high[1] += MM * gap;
        }
    }
    room
}

/// A follower in the drawing. The second follower of a conjugate pair is rotated by half a turn.
struct Drawn<'a> {
    cam: &'a Cam,
    sign: f64,
    id: &'static str,
}

fn followers(synthesis: &Design) -> Vec<Drawn<'_>> {
    let mut all = vec![Drawn {
        cam: &synthesis.cam,
        sign: 1.0,
        id: "cam-follower",
    }];
    if let Some(pair) = &synthesis.conjugate {
        all.push(Drawn {
            cam: &pair.second,
            sign: -1.0,
            id: "cam-second",
        });
    }
    all
}

/// Size of the cam in the drawing, mm. For a rotating cam, it is the maximum distance of profile and pitch curve from the cam centre. For
/// an unrolled cam, it is the maximum height of the upper edge of the roller.
fn reach(cam: &Cam, rows: &[ProfilePoint]) -> f64 {
    let up = |p: &ProfilePoint| {
        if slide(cam) > 0.0 {
            (p.pitch_y + cam.follower.roller_radius()).abs()
        } else {
            libm::hypot(p.x, p.y).max(libm::hypot(p.pitch_x, p.pitch_y))
        }
    };
    MM * rows.iter().map(up).fold(0.0, f64::max)
}

fn turning_body(
    out: &mut String,
    synthesis: &Design,
    running: Option<&Running>,
    rows: &[ProfilePoint],
) {
    let cam = &synthesis.cam;
    let closed = cam.law.is_closed();
    let mut others: Vec<Vec<ProfilePoint>> = Vec::new();
    if let Some(pair) = &synthesis.conjugate {
        others.push(pair.second_profile(POINTS));
    }
    if let Some(angle) = running.and_then(|r| r.second_cam) {
        let law = cam.law.ahead(-angle);
        let follower = cam.follower;
        others.push(Cam { law, follower }.profile(POINTS));
    }
    for other in &others {
        let outline = path(other.iter().map(|p| [p.x, p.y]), closed);
        shape(out, &outline, SECOND);
    }
    let outline = path(rows.iter().map(|p| [p.x, p.y]), closed);
    shape(out, &outline, BODY);
    let base = MM * cam.follower.base_radius();
    circle(out, "base", base, BASE);
    let mark = format!("M0 0V{:.4}", 0.8 * base);
    shape(
        out,
        &mark,
        "style=\"stroke:var(--quiet)\" stroke-width=\"1.2\"",
    );
    let roller = MM * cam.follower.roller_radius();
    if roller > 0.0 {
        circle(out, "prime", base + roller, PRIME);
        let pitch = path(rows.iter().map(|p| [p.pitch_x, p.pitch_y]), closed);
        shape(out, &pitch, PITCH);
    }
    if let Some(bore) = synthesis.problem.cam.bore {
        circle(out, "bore", 0.5 * MM * bore, BORE);
    }
}

/// Draws a circle about the axis of the cam. `part` is the name of the part.
fn circle(out: &mut String, part: &str, r: f64, style: &str) {
    let _ = write!(out, "<circle data-part=\"{part}\" r=\"{r:.4}\" {style}/>");
}

/// Draws a translating cam with its foot, or the unrolled groove of a barrel cam with both walls. For a closed law, the profile is drawn
/// three times: at its position, and one travel to the left and to the right.
fn sliding_body(out: &mut String, cam: &Cam, rows: &[ProfilePoint], foot: f64) {
    let travel = slide(cam) * cam.law.extent().1 / MM;
    let rounds: &[f64] = if cam.law.is_closed() {
        &[-1.0, 0.0, 1.0]
    } else {
        &[0.0]
    };
    let along = |f: fn(&ProfilePoint) -> [f64; 2]| -> Vec<[f64; 2]> {
        rounds
            .iter()
            .flat_map(|k| rows.iter().map(move |p| (k, f(p))))
            .map(|(k, [x, y])| [x + k * travel, y])
            .collect()
    };
    let lower = along(|p| [p.x, p.y]);
    let body = match cam.follower {
        Follower::Barrel { .. } => {
            let upper = along(|p| [2.0 * p.pitch_x - p.x, 2.0 * p.pitch_y - p.y]);
            path(lower.into_iter().chain(upper.into_iter().rev()), true)
        }
        _ => {
            let (first, last) = (lower[0][0], lower[lower.len() - 1][0]);
            let ground = [[last, foot / MM], [first, foot / MM]];
            path(lower.into_iter().chain(ground), true)
        }
    };
    shape(out, &body, BODY);
    let pitch = along(|p| [p.pitch_x, p.pitch_y]);
    shape(out, &path(pitch.into_iter(), false), PITCH);
}

/// Draws the follower relative to its origin: the foot of the stem, or the centre of the roller. An arm extends along +x towards the
/// pivot.
fn draw_follower(out: &mut String, drawn: &Drawn, reach: f64, stem: f64) {
    let (cam, id) = (drawn.cam, drawn.id);
    let half = 0.04 * reach;
    let _ = write!(out, "<g id=\"{id}\">");
    let start = cam.law.extent().0;
    match (pose(cam, start), cam.follower.pivot()) {
        (Pose::Roller { radius, .. }, Some(_)) => {
            let arm = arm(&cam.follower);
            let side = 0.7 * half;
            let bar = format!("M0.000 {:.3}H{arm:.3}V{side:.3}H0.000Z", -side);
            shape(out, &bar, FOLLOWER);
            // A knife edge at the end of an arm is drawn as its tip.
            let tip = if radius > 0.0 {
                MM * radius
            } else {
                0.4 * half
            };
            let _ = write!(out, "<circle r=\"{tip:.4}\" {FOLLOWER}/>");
            bearing(out, [0.0, 0.0], 0.2 * half);
            bearing(out, [arm, 0.0], 0.5 * half);
        }
        (Pose::Roller { radius: 0.0, .. }, None) => {
            let shoulder = 2.5 * half;
            let left = -half;
            let d = format!("M0 0L{left:.3} {shoulder:.3}V{stem:.3}H{half:.3}V{shoulder:.3}Z");
            shape(out, &d, FOLLOWER);
        }
        (Pose::Roller { radius, .. }, None) => {
            let r = MM * radius;
            let top = r + stem;
            shape(
                out,
                &format!("M{:.3} 0V{top:.3}H{half:.3}V0", -half),
                FOLLOWER,
            );
            let _ = write!(out, "<circle r=\"{r:.4}\" {FOLLOWER}/>");
            bearing(out, [0.0, 0.0], 0.2 * half);
        }
        (Pose::Face { .. }, _) => draw_face(out, cam, reach, stem),
    }
    out.push_str("</g>\n");
}

/// Draws a flat face with its stem, or a flat face with the arm to its pivot.
fn draw_face(out: &mut String, cam: &Cam, reach: f64, stem: f64) {
    let pivot = cam.follower.pivot();
    let half = 0.04 * reach;
    let (low, high) = face_reach(cam).unwrap_or((0.0, 0.0));
    let (more, thick) = (0.08 * reach, 0.035 * reach);
    let (low, high) = (MM * low - more, MM * high + more);
    // If the pivot is on +x, the normal of the face away from the cam is −y.
    let up = pivot.map_or(1.0, |p| -p[0].signum());
    if pivot.is_none() {
        let d = format!("M{:.3} {thick:.3}V{stem:.3}H{half:.3}V{thick:.3}", -half);
        shape(out, &d, FOLLOWER);
    }
    let d = format!("M{low:.3} 0H{high:.3}V{:.3}H{low:.3}Z", up * thick);
    shape(out, &d, FOLLOWER);
    if let Follower::FlatOscillating { face_offset, .. } = cam.follower {
        let pivot = -up * MM * face_offset;
        let far = if low + high < 0.0 { low } else { high };
        let d = format!("M0 {pivot:.3}V0H{far:.3}");
        shape(out, &d, "style=\"stroke:var(--ink)\" stroke-width=\"2.4\"");
        bearing(out, [0.0, pivot], 0.5 * half);
    }
}

fn bearing(out: &mut String, [x, y]: [f64; 2], radius: f64) {
    let _ = write!(
        out,
        "<circle cx=\"{x:.3}\" cy=\"{y:.3}\" r=\"{radius:.3}\" style=\"fill:var(--ink)\"/>"
    );
}

/// Length of the arm, mm; 0 without an arm.
fn arm(follower: &Follower) -> f64 {
    match *follower {
        Follower::RollerOscillating { arm, .. } | Follower::MushroomOscillating { arm, .. } => {
            MM * arm
        }
        _ => 0.0,
    }
}

fn controls(out: &mut String, synthesis: &Design, running: Option<&Running>, words: &Words) {
    let cam = &synthesis.cam;
    let (start, length) = cam.law.extent();
    let (per, _) = angle_unit(cam);
    let turns = running.map_or(1, |r| r.outcome.period_turns.clamp(1, 4));
    let text = |key: &str| escaped(&words.text(key));
    let what = match cam.follower {
        Follower::TranslatingCam { .. } => "report-travel",
        _ => "report-angle",
    };
    let _ = write!(
        out,
        "<div class=\"live\">\n<div><button id=\"play\" type=\"button\" data-play=\"{play}\" data-pause=\"{}\">{play}</button></div>\n\
         <label>{}<input id=\"angle\" type=\"range\" min=\"{:.3}\" max=\"{:.3}\" step=\"any\" value=\"{:.3}\"></label>\n\
         <label><span>{}: <span id=\"pace\" data-full=\"{}\" data-of=\"{}\"></span></span>\
         <input id=\"speed\" type=\"range\" min=\"-2.3\" max=\"0\" step=\"0.05\" value=\"-1\"></label>\n<table>",
        text("report-pause"),
        text(what),
        per * start,
        per * (start + turns as f64 * length),
        per * start,
        text("report-pace"),
        text("report-full-speed"),
        text("report-of-full-speed"),
        play = text("report-play"),
    );
    for (id, key) in live_values(cam, running, what) {
        let name = text(key);
        let _ = write!(
            out,
            "<tr><th scope=\"row\">{name}</th><td id=\"{id}\">—</td></tr>"
        );
    }
    out.push_str("</table>\n");
    if synthesis.problem.drive.kind == gaitcam::drive::DriveKind::MovingAxis {
        let _ = writeln!(out, "<p class=\"note\">{}</p>", text("report-inverted"));
    }
    out.push_str("</div>\n");
}

/// Displayed values of the animation. Each value has the id of its table cell and the message key of its name.
fn live_values(
    cam: &Cam,
    running: Option<&Running>,
    what: &'static str,
) -> Vec<(&'static str, &'static str)> {
    let slides = slide(cam) > 0.0 && !matches!(cam.follower, Follower::Barrel { .. });
    let force = match cam.follower.is_oscillating() {
        true => "report-now-moment",
        false => "report-now-force",
    };
    let torque = match slides {
        true => "report-push",
        false => "report-torque",
    };
    let mut rows = vec![
        ("now-angle", what),
        ("now-lift", "report-lift"),
        ("now-force", force),
        ("now-torque", torque),
    ];
    if running.is_some_and(|r| r.outcome.contact_lost) {
        rows.push(("now-gap", "report-gap"));
    }
    rows.push(("now-rho", "report-radius-at-contact"));
    if !cam.follower.is_flat() {
        rows.push(("now-phi", "report-phi"));
    }
    rows
}

/// SVG path data, mm, from points in m; y is upwards as in the coordinates of the cam.
fn path(points: impl Iterator<Item = [f64; 2]>, closed: bool) -> String {
    let mut d = String::new();
    for (i, [x, y]) in points.enumerate() {
        d.push(if i == 0 { 'M' } else { 'L' });
        append(&mut d, MM * x, 4);
        d.push(' ');
        append(&mut d, MM * y, 4);
    }
    if closed {
        d.push('Z');
    }
    d
}

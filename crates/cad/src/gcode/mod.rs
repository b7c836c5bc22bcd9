//! Programs for machines (ISO 6983): a milling cutter around the outside of a cam, a cutter in the groove of a barrel on
//! a rotary axis, a wire with its way in.

mod groove;
mod outside;
mod wire;

use std::fmt::Write;

use gaitcam::cam::Bore;
use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::units::Quantity;

use self::outside::Lead;
use super::cutter;
use super::outline::Edge;

const MM: f64 = 1000.0;
/// Feed of the point of contact along the profile, mm/min: 0.05 mm per tooth, two teeth, 2000 rpm. Operators
/// adjust it with the override.
const FEED: f64 = 200.0;
/// Acceleration that the machine's table keeps to on an arc, mm/s².
const ACCELERATION: f64 = 500.0;
/// Relative change from which a feed is written again.
const NEW_FEED: f64 = 0.01;

/// A piece of a path; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Move {
    to: [f64; 2],
    /// Centre of an arc and whether it is counter-clockwise; `None` for a line.
    arc: Option<([f64; 2], bool)>,
    /// Feed of the cutter's centre, mm/min.
    feed: f64,
}

impl Move {
    fn line(to: [f64; 2]) -> Move {
        Move {
            to,
            arc: None,
            feed: FEED,
        }
    }

    fn arc(to: [f64; 2], centre: [f64; 2], counter_clockwise: bool) -> Move {
        Move {
            to,
            arc: Some((centre, counter_clockwise)),
            feed: FEED,
        }
    }
}

/// Feed of the cutter's centre on an arc of radius `path` m, mm/min: the contact, on the radius `profile` m, moves with one
/// feed where the table's acceleration allows it.
fn feed_on(path: f64, profile: f64) -> f64 {
    let most = 60.0 * (ACCELERATION * MM * path).sqrt();
    (FEED * path / profile).min(most)
}

/// A path of the cutter's centre, m.
struct Path {
    start: [f64; 2],
    moves: Vec<Move>,
}

/// The programs for a cutter of radius `tool` m: the bore and around the outside of each cam, or through the groove of a
/// barrel, whose cutter has the roller's radius.
///
/// # Errors
/// A radius that is not positive; a profile that no chain of arcs follows (undercut, jumps of the velocity), a cutter
/// that does not fit a hollow or is not the groove's.
pub fn milling(design: &Design, tool: f64) -> Result<Vec<String>> {
    let tool = cutter::positive(tool)?;
    if let Some(groove) = &design.groove {
        return Ok(vec![groove::program(groove, &design.name, tool)?]);
    }
    let program = |edge: &Edge| {
        let path = outside::path(edge, tool, Lead::Arcs).ok_or(WriteError::NoCutterPath)?;
        let mut text = head(
            design,
            &[
                &format!(
                    "CENTRE PATH, RADIUS OF CUTTER {:.4} MM, NO COMPENSATION",
                    MM * tool
                ),
                &format!("FEED {FEED:.0} MM/MIN AT THE PROFILE"),
            ],
        );
        if let Some(bore) = design.bore {
            if bore.keyway.is_some() {
                text.push_str("(THE KEYWAY IS NOT MILLED)\n");
            }
            // The round part; a cutter too wide for it leaves the bore to a drill.
            if let Some(mut hole) = wire::hole(&Bore::plain(bore.diameter), tool) {
                let feed = feed_on(bore.radius() - tool, bore.radius());
                hole.moves.iter_mut().for_each(|step| step.feed = feed);
                begin(
                    &mut text,
                    hole.start,
                    "BORE, TOOL TO DEPTH",
                    design.thickness,
                );
                moves(&mut text, &hole);
                text.push_str("M0 (TOOL CLEAR)\n");
            } else {
                text.push_str("(THE BORE IS NOT MILLED, CUTTER TOO WIDE)\n");
            }
        }
        begin(&mut text, path.start, "TOOL TO DEPTH", design.thickness);
        moves(&mut text, &path);
        end(&mut text, "TOOL CLEAR");
        Ok(finished(text))
    };
    Edge::all(design).iter().map(program).collect()
}

/// The program for a wire that cuts at `radius` m from its centre (half its diameter and the spark gap): hole for the shaft with
/// its keyway, then the outside. Of a pair the first cam.
///
/// # Errors
/// As [`milling`]; a barrel, and a wire that the keyway has no room for.
pub fn wire(design: &Design, radius: f64) -> Result<String> {
    let radius = cutter::positive(radius)?;
    if design.groove.is_some() {
        return Err(WriteError::NoCutterPath.into());
    }
    let outside = outside::path(&Edge::of(&design.cam), radius, Lead::Lines);
    let outside = outside.ok_or(WriteError::NoCutterPath)?;
    let mut text = head(
        design,
        &[&format!(
            "WIRE AND GAP {:.4} MM, NO COMPENSATION, FEED BY THE GENERATOR",
            MM * radius
        )],
    );
    if let Some(bore) = &design.bore {
        let hole = wire::hole(bore, radius).ok_or(WriteError::WireTooThick {
            radius: Quantity::length(radius),
        })?;
        if bore.keyway.is_some() {
            let _ = writeln!(
                text,
                "(CORNERS OF THE KEYWAY KEEP A RADIUS OF {:.4} MM)",
                MM * radius
            );
        }
        begin(
            &mut text,
            hole.start,
            "THREAD THE WIRE, START HOLE",
            design.thickness,
        );
        moves(&mut text, &hole);
        text.push_str("M0 (CUT THE WIRE)\n");
    }
    begin(
        &mut text,
        outside.start,
        "THREAD THE WIRE, START HOLE OR EDGE",
        design.thickness,
    );
    moves(&mut text, &outside);
    end(&mut text, "CUT THE WIRE");
    Ok(finished(text))
}

/// The program's first lines, for paths in the plane of the cam.
fn head(design: &Design, notes: &[&str]) -> String {
    let mut out = format!("%\n({})\n", comment(&design.name));
    for note in notes {
        // Writing to a String cannot fail.
        let _ = writeln!(out, "({note})");
    }
    let zero = if design.cam.follower.is_unrolled() {
        "ZERO AT THE FOOT BELOW THE START, +Y ALONG THE FOLLOWER"
    } else {
        "ZERO AT THE CENTRE OF THE CAM, +Y ALONG THE FOLLOWER AT THETA = 0"
    };
    let _ = writeln!(out, "({zero})\nG90 G21 G17 G40 G94");
    out
}

/// Move to the start of a path, with an instruction for the operator.
fn begin(out: &mut String, start: [f64; 2], task: &str, thickness: f64) {
    let [x, y] = start.map(|v| MM * v);
    let _ = writeln!(
        out,
        "G0 X{x:.4} Y{y:.4}\nM0 ({task}, PLATE {:.3} MM)",
        MM * thickness
    );
}

fn moves(out: &mut String, path: &Path) {
    let mut at = path.start;
    let mut feed: f64 = 0.0;
    for step in &path.moves {
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
}

fn end(out: &mut String, task: &str) {
    let _ = write!(out, "M0 ({task})\nM30\n%\n");
}

/// Some machines refuse −0.0000.
fn finished(text: String) -> String {
    text.replace("-0.00000", "0.00000")
        .replace("-0.0000 ", "0.0000 ")
        .replace("-0.0000\n", "0.0000\n")
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

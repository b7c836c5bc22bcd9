//! Program that mills the groove of a barrel on a rotary axis. The axis of the cutter intersects the axis of the barrel, as the axis of the roller
//! does.
//!
//! The cutter has the radius of the roller and moves on the path of the roller. It therefore cuts the exact envelope of the roller at any
//! depth, without ridges or gouges. A thinner cutter would leave errors in an oblique part of the groove, because its contact with the wall
//! changes with the depth.

use std::fmt::Write;

use gaitcam::cam::{BarrelGroove, Wall};
use gaitcam::error::{Result, WriteError};
use gaitcam::units::Quantity;

use super::{ACCELERATION, DECIMALS, FEED, Milling, code, comment, finished, named};

const MM: f64 = 1000.0;
/// Maximum distance between the line segments of the program and the path of the roller, m.
const LINES: f64 = 2e-7;
/// Maximum rotation of the barrel during one line segment, rad.
const LONGEST: f64 = std::f64::consts::TAU / 72.0;
/// Maximum number of times that a line segment is halved.
const DEEPEST: usize = 16;
/// Relative difference below which two radii count as equal.
const ONE: f64 = 1e-6;

/// Program for a groove. It contains two passes if each wall has its own roller, offset along the barrel.
///
/// # Errors
///
/// The radius of the cutter differs from the radius of the roller, or the groove is undercut.
pub fn program(groove: &BarrelGroove, name: &str, cut: &Milling) -> Result<String> {
    let (tool, units) = (cut.tool, cut.units);
    let roller = groove.roller_radius();
    if (tool - roller).abs() > ONE * roller {
        return Err(WriteError::GrooveCutter {
            radius: Quantity::length(tool),
            roller: Quantity::length(roller),
        }
        .into());
    }
    let (floor, surface) = groove.depth();
    let undercut = |wall: &Wall| groove.smallest_bulge(floor, *wall).value <= 0.0;
    let walls = [Wall::Lower, Wall::Upper];
    if walls.iter().any(undercut) {
        return Err(WriteError::NoCutterPath.into());
    }
    let mut out = format!("%\n({})\n", comment(name));
    let (start, length) = groove.law().extent();
    let stations = stations(groove);
    let mut offsets = walls.map(|wall| groove.axis_offset(wall)).to_vec();
    offsets.dedup();
    let place = |theta: f64, offset: f64| groove.law().svaj(theta).s + offset;
    let long = |x: f64| units.number(x, DECIMALS);
    // Writing to a String cannot fail.
    let _ = write!(
        out,
        "(GROOVE, CUTTER AND ROLLER OF RADIUS {}, BOTH AXES MEET)\n\
         (X ALONG THE BARREL FROM LIFT 0, A = THETA: ANGLE OF THE BARREL)\n\
         (FLOOR AT RADIUS {}, SURFACE AT RADIUS {})\n\
         (FEED {FEED:.0} MM/MIN AT THE SURFACE, WRITTEN AS 1/MIN)\n",
        named(units, tool),
        named(units, floor),
        named(units, surface),
    );
    if cut.pass.is_some() {
        out.push_str("(ONE PASS, DEPTH BY THE OPERATOR)\n");
    }
    let _ = write!(
        out,
        "G90 {} G40 G94\nG0 X{} A{:.5}\nM0 (TOOL TO THE FLOOR)\nG93\n",
        code(units),
        long(place(start, offsets[0])),
        start.to_degrees(),
    );
    for (pass, offset) in offsets.iter().enumerate() {
        let gone = length * pass as f64;
        if pass > 0 {
            let across = MM * (offset - offsets[pass - 1]).abs();
            let x = place(start, *offset);
            let _ = writeln!(out, "G1 X{} F{:.3}", long(x), FEED / across);
        }
        for pair in stations.windows(2) {
            let rise = MM * (place(pair[1], 0.0) - place(pair[0], 0.0));
            let way = libm::hypot(MM * surface * (pair[1] - pair[0]), rise);
            let _ = writeln!(
                out,
                "G1 X{} A{:.5} F{:.3}",
                long(place(pair[1], *offset)),
                (pair[1] + gone).to_degrees(),
                feed(groove, 0.5 * (pair[0] + pair[1])) / way
            );
        }
    }
    out.push_str("G94\nM0 (TOOL CLEAR)\nM30\n%\n");
    Ok(finished(out))
}

/// Feed at the surface of the barrel, mm/min. It is reduced where the acceleration across the groove would exceed [`ACCELERATION`].
fn feed(groove: &BarrelGroove, theta: f64) -> f64 {
    let (_, surface) = groove.depth();
    let bend = MM * groove.rho_pitch(theta, surface).abs();
    FEED.min(60.0 * (ACCELERATION * bend).sqrt())
}

/// Angles of the barrel, rad, between which straight lines approximate the law.
fn stations(groove: &BarrelGroove) -> Vec<f64> {
    let breaks = groove.law().breaks();
    let mut out = vec![breaks[0]];
    for pair in breaks.windows(2) {
        let count = ((pair[1] - pair[0]) / LONGEST).ceil().max(1.0);
        let at = |k: f64| pair[0] + (pair[1] - pair[0]) * k / count;
        for k in 0..count as usize {
            divide(groove, at(k as f64), at((k + 1) as f64), DEEPEST, &mut out);
        }
    }
    out
}

fn divide(groove: &BarrelGroove, from: f64, to: f64, depth: usize, out: &mut Vec<f64>) {
    let s = |theta: f64| groove.law().svaj(theta).s;
    let (low, high) = (s(from), s(to));
    let astray = |part: f64| (s(from + part * (to - from)) - low - part * (high - low)).abs();
    let worst = [0.25, 0.5, 0.75]
        .into_iter()
        .map(astray)
        .fold(0.0, f64::max);
    if worst <= LINES || depth == 0 {
        out.push(to);
        return;
    }
    let middle = 0.5 * (from + to);
    divide(groove, from, middle, depth - 1, out);
    divide(groove, middle, to, depth - 1, out);
}

//! Solid of a translating cam: the extruded area between the profile and the straight base of the plate.

use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;

use super::file::{File, Piece};
use super::{FAITHFUL, positive};
use crate::spline;
use gaitcam::synth::Edge;

const MM: f64 = 1000.0;

/// Adds the solid of a translating cam to a file. Returns the number of its entity.
pub fn add(file: &mut File, design: &Design) -> Result<usize> {
    let z = [0.0, MM * positive(design.problem.cam.thickness)?];
    let edge = Edge::of(&design.cam);
    if edge.is_undercut() {
        return Err(WriteError::UndercutProfile.into());
    }
    let outline = outline(&edge)?;
    let mut faces = Vec::new();
    let rims = file.wall(&outline, z, false, &mut faces);
    file.cap(z[0], false, &rims.low, &[], &mut faces);
    file.cap(z[1], true, &rims.high, &[], &mut faces);
    Ok(file.solid("slide", &faces))
}

/// Outline, mm, counter-clockwise from the left end of the foot: foot, right side, profile in reverse direction, left side.
fn outline(edge: &Edge) -> Result<Vec<Piece>> {
    let breaks = edge.breaks();
    let [first, last] = [breaks[0], breaks[breaks.len() - 1]].map(|x| edge.at(x).p.map(|x| MM * x));
    let foot = [[first[0], 0.0], [last[0], 0.0]];
    let mut out = vec![Piece::Line(foot), Piece::Line([foot[1], last])];
    for pair in breaks.windows(2).rev() {
        let piece = spline::piece(edge, [pair[1], pair[0]], FAITHFUL);
        out.push(Piece::Spline(piece.ok_or(WriteError::TooSharp)?));
    }
    out.push(Piece::Line([first, foot[0]]));
    Ok(out)
}

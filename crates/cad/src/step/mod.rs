//! `cam.step`: the cam as an exact solid for CAD (ISO 10303-21, AP214). Lengths in mm.
//!
//! A disc's profile is a periodic cubic B-spline through points at equal steps of the cam angle, C², refined until it stays within [`FAITHFUL`] of
//! the true one; the plate is its extrusion with the hole for the shaft. A conjugate pair gives both cams in their positions on the shaft, one plate
//! thickness apart. A slide has its foot under the profile. A barrel has no solid.

mod file;
mod freeform;
mod slide;

use self::file::{File, Piece, Rims, circle};
use super::spline;
use gaitcam::cam::Bore;
use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::synth::Edge;
use gaitcam::units::Quantity;

const MM: f64 = 1000.0;
/// Largest distance of a spline from the true profile at the points compared, m; less than 0.1 µm between them.
pub const FAITHFUL: f64 = 5e-8;
/// Half the width of the space for the mark of θ = 0, mm.
const LEAST_ROOM: f64 = 0.25;
/// Number of edges of the profile.
const EDGES: usize = 4;

/// The cam as a solid; both cams of a pair.
///
/// # Errors
///
/// On a barrel, a law that does not close, an undercut profile, a thickness that is not positive, and a profile that no
/// spline of so many spans follows.
pub fn solid(design: &Design) -> Result<Vec<u8>> {
    if design.groove.is_some() {
        return Err(WriteError::BarrelSolid.into());
    }
    let mut file = File::default();
    let solids = if design.cam.follower.is_unrolled() {
        vec![slide::add(&mut file, design)?]
    } else {
        plates(&mut file, design)?
    };
    Ok(file.finish(&solids, &design.problem.name))
}

fn plates(file: &mut File, synthesis: &Design) -> Result<Vec<usize>> {
    let thickness = positive(synthesis.problem.cam.thickness)?;
    if !synthesis.cam.law.is_closed() {
        return Err(WriteError::OpenProfile.into());
    }
    let edges = Edge::all(synthesis);
    let mut solids = Vec::new();
    for (k, edge) in edges.iter().enumerate() {
        if edge.is_undercut() {
            return Err(WriteError::UndercutProfile.into());
        }
        let outline = spline::along(edge, FAITHFUL, EDGES).ok_or(WriteError::TooSharp)?;
        let foot = 2.0 * MM * thickness * k as f64;
        let body = Body {
            outline: outline.into_iter().map(Piece::Spline).collect(),
            hole: synthesis.problem.cam.hole(),
            dot: Dot::of(synthesis).filter(|_| k == 0 && synthesis.problem.cam.mark),
            z: [foot, foot + MM * thickness],
        };
        solids.push(body.add_to(file));
    }
    Ok(solids)
}

/// A valid thickness of a plate.
pub(crate) fn positive(thickness: f64) -> Result<f64> {
    if thickness.is_finite() && thickness > 0.0 {
        return Ok(thickness);
    }
    Err(WriteError::PlateThickness {
        thickness: Quantity::length(thickness),
    }
    .into())
}

/// The engraved mark of θ = 0: a shallow round hole in the upper face, mm.
#[derive(Debug, Clone, Copy)]
struct Dot {
    centre: [f64; 2],
    radius: f64,
    depth: f64,
}

impl Dot {
    /// Radius halfway between the hole for the shaft and the base circle; `None` without room.
    fn of(design: &Design) -> Option<Dot> {
        let base = MM * design.cam.follower.base_radius();
        let reach = design.problem.cam.hole().map_or(0.0, |b| MM * b.reach());
        let room = 0.5 * (base - reach);
        (room > LEAST_ROOM).then_some(Dot {
            centre: [0.0, reach + room],
            radius: (0.4 * room).min(1.0),
            depth: (0.1 * MM * design.problem.cam.thickness).min(0.3),
        })
    }

    /// Adds wall and floor of the mark below a face at height z; returns its rims.
    fn add_to(self, file: &mut File, z: f64, faces: &mut Vec<usize>) -> Rims {
        let floor = z - self.depth;
        let outline = circle(self.centre, self.radius);
        let rims = file.wall(&outline, [floor, z], true, faces);
        file.cap(floor, true, &rims.low, &[], faces);
        rims
    }
}

/// A plate between two heights, mm.
struct Body {
    outline: Vec<Piece>,
    hole: Option<Bore>,
    dot: Option<Dot>,
    z: [f64; 2],
}

impl Body {
    fn add_to(&self, file: &mut File) -> usize {
        let mut faces = Vec::new();
        let [low, high] = self.z;
        let outer = file.wall(&self.outline, self.z, false, &mut faces);
        let shaft =
            (self.hole).map(|bore| file.wall(&hole_pieces(&bore), self.z, true, &mut faces));
        let dot = self.dot.map(|dot| dot.add_to(file, high, &mut faces));
        let below: Vec<&[usize]> = shaft.iter().map(|r| r.low.as_slice()).collect();
        let above: Vec<&[usize]> = (dot.iter().chain(&shaft))
            .map(|r| r.high.as_slice())
            .collect();
        file.cap(low, false, &outer.low, &below, &mut faces);
        file.cap(high, true, &outer.high, &above, &mut faces);
        file.solid("cam", &faces)
    }
}

/// The hole's edge in straight pieces and arcs, mm.
fn hole_pieces(bore: &Bore) -> Vec<Piece> {
    let edge = bore.outline();
    let at = |i: usize| {
        let [x, y, _] = edge[i % edge.len()];
        [MM * x, MM * y]
    };
    (0..edge.len())
        .map(|i| match edge[i][2] {
            0.0 => Piece::Line([at(i), at(i + 1)]),
            _ => Piece::Arc {
                ends: [at(i), at(i + 1)],
                centre: [0.0; 2],
                radius: MM * bore.radius(),
            },
        })
        .collect()
}

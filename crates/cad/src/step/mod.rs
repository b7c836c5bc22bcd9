//! `cam.step`: the cam as an exact solid for CAD (ISO 10303-21, AP214), with lengths in mm.
//!
//! The profile of a disc is a periodic C² cubic B-spline through points at equal steps of the cam angle. The number of points is increased until the
//! spline is within [`FAITHFUL`] of the exact profile. The solid is the extruded profile with the bore.
//!
//! For a conjugate pair, the file contains two solids in their positions on the shaft. The axial gap between the two cams is the thickness of one
//! plate. A translating cam has its foot below the profile. Barrels have no solid.

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
/// Maximum distance between a spline and the exact profile, m, at the points where the distance is measured. Between these points it is below 0.1
/// µm.
pub const FAITHFUL: f64 = 5e-8;
/// Minimum space for the mark of θ = 0, mm. The space is half the radial distance between bore and base circle.
const LEAST_ROOM: f64 = 0.25;
/// Number of edges into which the profile is divided.
const EDGES: usize = 4;

/// STEP file of the cam, or of both cams of a pair.
///
/// # Errors
///
/// - The cam is a barrel.
/// - The law of a rotating cam is not closed.
/// - The profile is undercut.
/// - The thickness is not positive.
/// - No spline with the permitted number of spans approximates the profile.
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

/// Checks that the thickness of a plate is positive.
pub(crate) fn positive(thickness: f64) -> Result<f64> {
    if thickness.is_finite() && thickness > 0.0 {
        return Ok(thickness);
    }
    Err(WriteError::PlateThickness {
        thickness: Quantity::length(thickness),
    }
    .into())
}

/// Engraved mark of θ = 0, a shallow cylindrical recess in the upper face, mm.
#[derive(Debug, Clone, Copy)]
struct Dot {
    centre: [f64; 2],
    radius: f64,
    depth: f64,
}

impl Dot {
    /// Mark in the middle between the bore and the base circle; `None` if the space is too small.
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

    /// Adds the wall and the floor of the mark below a face at the height z. Returns the edges of the mark.
    fn add_to(self, file: &mut File, z: f64, faces: &mut Vec<usize>) -> Rims {
        let floor = z - self.depth;
        let outline = circle(self.centre, self.radius);
        let rims = file.wall(&outline, [floor, z], true, faces);
        file.cap(floor, true, &rims.low, &[], faces);
        rims
    }
}

/// Plate between two heights z, mm, with its bore and the engraved mark.
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

/// Edge of the bore, as straight lines and arcs, mm.
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

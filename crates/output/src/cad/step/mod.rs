//! `cam.step`: the cam as an exact solid for CAD (ISO 10303-21, AP214).
//!
//! The profile is a periodic cubic B-spline through points at equal steps of the cam angle, C², refined until
//! it stays within [`FAITHFUL`] of the true one; the plate is its extrusion with the hole for the shaft. Lengths in mm.
//! Of a conjugate pair both cams are there as they stand on the shaft, one plate's thickness apart.

mod file;
mod spline;

use self::file::{File, Piece, circle};
use self::spline::Spline;
use super::outline::Edge;
use gaitcam::cam::Bore;
use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::units::Quantity;

const MM: f64 = 1000.0;
/// Largest distance of the spline from the true profile, m.
pub const FAITHFUL: f64 = 1e-7;
/// Edges into which the profile is divided.
const EDGES: usize = 4;

/// The plate of `thickness` m with its bore, of a pair both plates.
///
/// # Errors
///
/// On a law that does not close, an undercut profile, a thickness that is not positive, and a profile that no
/// spline of so many spans follows.
pub fn plate(synthesis: &Design, thickness: f64) -> Result<Vec<u8>> {
    let cam = &synthesis.cam;
    if !(thickness.is_finite() && thickness > 0.0) {
        return Err(WriteError::PlateThickness {
            thickness: Quantity::length(thickness),
        }
        .into());
    }
    if !cam.law.is_closed() || cam.follower.is_unrolled() {
        return Err(WriteError::OpenProfile.into());
    }
    let mut file = File::default();
    let mut solids = Vec::new();
    for (k, edge) in Edge::all(synthesis).iter().enumerate() {
        if edge.is_undercut() {
            return Err(WriteError::UndercutProfile.into());
        }
        let spline = Spline::within(edge, FAITHFUL).ok_or(WriteError::TooSharp)?;
        let foot = 2.0 * MM * thickness * k as f64;
        let body = Body {
            outline: pieces(&spline),
            hole: synthesis.bore,
            dot: synthesis
                .mark
                .then(|| Dot::of(synthesis))
                .filter(|_| k == 0),
            z: [foot, foot + MM * thickness],
        };
        solids.push(body.add_to(&mut file));
    }
    Ok(file.finish(&solids, &synthesis.name))
}

fn pieces(spline: &Spline) -> Vec<Piece> {
    let n = spline.control.len();
    let part = |k: usize| spline.part(k * n / EDGES, (k + 1) * n / EDGES);
    (0..EDGES).map(|k| Piece::Spline(part(k))).collect()
}

/// The engraved mark of θ = 0: a shallow round hole in the upper face, mm.
#[derive(Debug, Clone, Copy)]
struct Dot {
    centre: [f64; 2],
    radius: f64,
    depth: f64,
}

impl Dot {
    /// Halfway between the hole for the shaft and the base circle.
    fn of(synthesis: &Design) -> Dot {
        let base = MM * synthesis.cam.follower.base_radius();
        let reach = synthesis.bore.map_or(0.0, |b| MM * b.reach());
        Dot {
            centre: [0.0, 0.5 * (base + reach)],
            radius: (0.2 * (base - reach)).min(1.0),
            depth: (0.1 * MM * synthesis.thickness).min(0.3),
        }
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
        let hole = self
            .hole
            .map(|bore| file.wall(&hole_pieces(&bore), self.z, true, &mut faces));
        let dot = self.dot.map(|dot| {
            let floor = high - dot.depth;
            let rims = file.wall(
                &circle(dot.centre, dot.radius),
                [floor, high],
                true,
                &mut faces,
            );
            file.cap(floor, true, &rims.low, &[], &mut faces);
            rims
        });
        let below: Vec<&[usize]> = hole.iter().map(|r| r.low.as_slice()).collect();
        let above: Vec<&[usize]> = hole.iter().chain(&dot).map(|r| r.high.as_slice()).collect();
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

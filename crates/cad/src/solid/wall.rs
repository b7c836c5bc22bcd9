//! Surfaces of the walls of a barrel's groove.

use super::Mesh;
use gaitcam::cam::{BarrelGroove, Wall};

const MM: f64 = 1000.0;

/// Mesh of one wall of a groove, mm, from the floor of the groove to the surface of the cylinder. The mesh is an open surface whose front faces the
/// groove.
///
/// The mesh has `along` strips over the whole law and `through` strips over the depth. The vertices lie exactly on the envelope of the roller
/// ([`BarrelGroove::wall_point`]).
pub fn wall(groove: &BarrelGroove, wall: Wall, along: usize, through: usize) -> Mesh {
    let (start, length) = groove.law().extent();
    let (inner, outer) = groove.depth();
    let (along, through) = (along.max(3), through.max(1));
    let rings = if groove.law().is_closed() {
        along
    } else {
        along + 1
    };
    let mut vertices = Vec::with_capacity(rings * (through + 1));
    for i in 0..rings {
        let theta = start + length * i as f64 / along as f64;
        for k in 0..=through {
            let radius = inner + (outer - inner) * k as f64 / through as f64;
            vertices.push(groove.wall_point(theta, radius, wall).map(|x| MM * x));
        }
    }
    let mut triangles = Vec::with_capacity(2 * along * through);
    let column = through + 1;
    for i in 0..along {
        for k in 0..through {
            let a = i * column + k;
            let b = (i + 1) % rings * column + k;
            // In the barrel's frame the groove is traversed clockwise. The outward direction × the direction along the groove points to −z, from the
            // upper wall into the groove.
            let [p, q] = match wall {
                Wall::Upper => [[a, a + 1, b], [a + 1, b + 1, b]],
                Wall::Lower => [[a, b, a + 1], [a + 1, b, b + 1]],
            };
            triangles.extend([p, q]);
        }
    }
    Mesh {
        vertices,
        triangles,
    }
}

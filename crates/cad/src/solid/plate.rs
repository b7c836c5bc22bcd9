//! The cam as a plate: a closed surface for printing and milling.

use earcut::Earcut;

use super::Mesh;
use crate::step::positive;
use gaitcam::cam::{Bore, Hole};
use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::units::Quantity;

const MM: f64 = 1000.0;

/// Points of a round hole.
const ROUND: usize = 240;

/// A plate of one thickness, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate {
    /// Thickness; the plate lies on z = 0.
    pub thickness: f64,
    /// The hole for the shaft; none where absent.
    pub bore: Option<Bore>,
    /// Vertices of the profile.
    pub points: usize,
}

/// The plate's surface.
///
/// Every profile vertex gets a bore vertex on its own ray from the centre (without a bore: the centre),
/// so the faces fall into wedges that cannot overlap. That needs a profile which every ray from the
/// centre meets once; fails otherwise, and on a bore that does not fit, a thickness or number of points
/// that makes no plate, an undercut profile, an open law.
pub fn plate(synthesis: &Design, plate: Plate) -> Result<Mesh> {
    let cam = &synthesis.cam;
    let thickness = MM * positive(plate.thickness)?;
    if plate.points < 8 {
        return Err(WriteError::TooFewPoints {
            points: plate.points,
            least: 8,
        }
        .into());
    }
    if !cam.law.is_closed() {
        return Err(WriteError::OpenProfile.into());
    }
    if cam.curvature().undercut {
        return Err(WriteError::UndercutProfile.into());
    }
    // Counter-clockwise: the profile itself runs clockwise.
    let outline: Vec<[f64; 2]> = cam
        .profile(plate.points)
        .iter()
        .rev()
        .map(|p| [MM * p.x, MM * p.y])
        .collect();
    let n = outline.len();
    let turning = |i: usize| {
        let (p, q) = (outline[i], outline[(i + 1) % n]);
        p[0] * q[1] - p[1] * q[0] > 0.0
    };
    if !(0..n).all(turning) {
        return Err(WriteError::ProfileFolds.into());
    }
    if let Some(bore) = plate.bore {
        let free = clearance(&outline);
        if !(bore.diameter > 0.0 && MM * bore.reach() < free) {
            return Err(WriteError::BoreTooLarge {
                bore: Quantity::length(bore.diameter),
                free: Quantity::length(free / MM),
            }
            .into());
        }
    }
    let balance = synthesis.problem.cam.making().balance_hole(cam, plate.bore);
    match (balance, plate.bore) {
        (Some(hole), bore) => pierced(outline, bore, hole, thickness),
        (None, None) => Ok(full(&outline, thickness)),
        (None, Some(bore)) => Ok(bored(&with_corners(outline, &bore), &bore, thickness)),
    }
}

/// The plate with a hole off the centre: a ray from the centre may meet its edges more than twice, so the faces are
/// triangulated as polygons with holes.
fn pierced(outline: Vec<[f64; 2]>, bore: Option<Bore>, hole: Hole, thickness: f64) -> Result<Mesh> {
    let balance = (0..ROUND).map(|i| {
        let (sin, cos) = direction(i).sin_cos();
        let r = 0.5 * hole.diameter;
        [hole.centre[0] + r * cos, hole.centre[1] + r * sin].map(|x| MM * x)
    });
    let mut rings = vec![outline, balance.collect()];
    rings.extend(bore.as_ref().map(edge));
    let mut triangles = Vec::new();
    for [a, b, c] in face(&rings).ok_or(WriteError::ProfileFolds)? {
        triangles.push([2 * a + 1, 2 * b + 1, 2 * c + 1]);
        triangles.push([2 * a, 2 * c, 2 * b]);
    }
    let mut first = 0;
    for ring in &rings {
        let n = ring.len();
        for i in 0..n {
            let (a, b) = (2 * (first + i), 2 * (first + (i + 1) % n));
            triangles.push([a, b, b + 1]);
            triangles.push([a, b + 1, a + 1]);
        }
        first += n;
    }
    Ok(Mesh {
        vertices: self::ring(&rings.concat(), thickness),
        triangles,
    })
}

/// Direction of point i of a round hole, clockwise, rad.
fn direction(i: usize) -> f64 {
    -std::f64::consts::TAU * i as f64 / ROUND as f64
}

/// The edge of the shaft's hole clockwise, mm; straight parts have no vertices between their corners.
fn edge(bore: &Bore) -> Vec<[f64; 2]> {
    let round = (0..ROUND)
        .map(direction)
        .filter(|a| bore.edge(*a) == bore.radius());
    let corners = bore.corners().into_iter();
    let corners = corners.map(|a| -(-a).rem_euclid(std::f64::consts::TAU));
    let mut angles: Vec<f64> = round.chain(corners).collect();
    angles.sort_by(|a, b| b.total_cmp(a));
    angles.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    let at = |a: f64| [a.cos(), a.sin()].map(|x| MM * bore.edge(a) * x);
    angles.into_iter().map(at).collect()
}

/// The triangles, counter-clockwise, of a face within `rings[0]`, counter-clockwise, around the other rings, clockwise;
/// vertices count through all rings. `None` where the rings cross or have vertices on a straight line: the triangles
/// then do not have all their edges.
fn face(rings: &[Vec<[f64; 2]>]) -> Option<Vec<[usize; 3]>> {
    let mut holes = Vec::new();
    let mut count = 0;
    for ring in rings {
        holes.push(count);
        count += ring.len();
    }
    holes.remove(0);
    let mut corners: Vec<usize> = Vec::new();
    let points = rings.concat();
    Earcut::new().earcut(points.iter().copied(), &holes, &mut corners);
    let triangles: Vec<[usize; 3]> = corners
        .chunks_exact(3)
        .map(|t| [t[0], t[1], t[2]])
        .collect();
    let is_filled = earcut::deviation(points, &holes, &corners) < 1e-9;
    (is_filled && triangles.len() == count + 2 * holes.len() - 2).then_some(triangles)
}

/// Smallest distance of the polygon from the centre.
fn clearance(outline: &[[f64; 2]]) -> f64 {
    let n = outline.len();
    (0..n)
        .map(|i| {
            let (p, q) = (outline[i], outline[(i + 1) % n]);
            let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
            let u = -(p[0] * dx + p[1] * dy) / (dx * dx + dy * dy);
            let u = u.clamp(0.0, 1.0);
            (p[0] + u * dx).hypot(p[1] + u * dy)
        })
        .fold(f64::INFINITY, f64::min)
}

/// Ring vertices at both heights: index 2i below, 2i + 1 above.
fn ring(points: &[[f64; 2]], thickness: f64) -> Vec<[f64; 3]> {
    points
        .iter()
        .flat_map(|p| [[p[0], p[1], 0.0], [p[0], p[1], thickness]])
        .collect()
}

fn full(outline: &[[f64; 2]], thickness: f64) -> Mesh {
    let n = outline.len();
    let mut vertices = ring(outline, thickness);
    vertices.extend([[0.0, 0.0, 0.0], [0.0, 0.0, thickness]]);
    let (low, high) = (2 * n, 2 * n + 1);
    let mut triangles = Vec::with_capacity(4 * n);
    for i in 0..n {
        let (a, b) = (2 * i, 2 * ((i + 1) % n));
        triangles.push([a, b, b + 1]);
        triangles.push([a, b + 1, a + 1]);
        triangles.push([low, b, a]);
        triangles.push([high, a + 1, b + 1]);
    }
    Mesh {
        vertices,
        triangles,
    }
}

/// The polygon with a vertex more on each ray from the centre through a corner of the hole.
fn with_corners(outline: Vec<[f64; 2]>, bore: &Bore) -> Vec<[f64; 2]> {
    let corners = bore.corners();
    let n = outline.len();
    let mut out = Vec::with_capacity(n + corners.len());
    for (i, &p) in outline.iter().enumerate() {
        out.push(p);
        let q = outline[(i + 1) % n];
        let mut between: Vec<f64> = (corners.iter())
            .filter_map(|angle| crossing(p, q, *angle))
            .filter(|u| *u > 0.0 && *u < 1.0)
            .collect();
        between.sort_by(f64::total_cmp);
        let along = |u: f64| [p[0] + u * (q[0] - p[0]), p[1] + u * (q[1] - p[1])];
        out.extend(between.into_iter().map(along));
    }
    out
}

/// Where the ray in a direction crosses the chord from p to q, as a part of the chord.
fn crossing(p: [f64; 2], q: [f64; 2], angle: f64) -> Option<f64> {
    let (sin, cos) = angle.sin_cos();
    let side = |v: [f64; 2]| cos * v[1] - sin * v[0];
    let (a, b) = (side(p), side(q));
    let ahead = cos * (p[0] + q[0]) + sin * (p[1] + q[1]) > 0.0;
    (ahead && a < 0.0 && b > 0.0).then(|| a / (a - b))
}

fn bored(outline: &[[f64; 2]], bore: &Bore, thickness: f64) -> Mesh {
    let n = outline.len();
    let bore: Vec<[f64; 2]> = outline
        .iter()
        .map(|p| {
            let scale = MM * bore.edge(p[1].atan2(p[0])) / p[0].hypot(p[1]);
            [scale * p[0], scale * p[1]]
        })
        .collect();
    let mut vertices = ring(outline, thickness);
    vertices.extend(ring(&bore, thickness));
    let mut triangles = Vec::with_capacity(8 * n);
    for i in 0..n {
        let (a, b) = (2 * i, 2 * ((i + 1) % n));
        let (c, d) = (2 * n + a, 2 * n + b);
        // Outer wall, bore wall, upper face, lower face.
        triangles.push([a, b, b + 1]);
        triangles.push([a, b + 1, a + 1]);
        triangles.push([d, c, c + 1]);
        triangles.push([d, c + 1, d + 1]);
        triangles.push([c + 1, a + 1, b + 1]);
        triangles.push([c + 1, b + 1, d + 1]);
        triangles.push([c, b, a]);
        triangles.push([c, d, b]);
    }
    Mesh {
        vertices,
        triangles,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn round(centre: [f64; 2], radius: f64, count: usize, sense: f64) -> Vec<[f64; 2]> {
        (0..count)
            .map(|i| {
                let a = sense * std::f64::consts::TAU * i as f64 / count as f64;
                [centre[0] + radius * a.cos(), centre[1] + radius * a.sin()]
            })
            .collect()
    }

    fn area(ring: &[[f64; 2]]) -> f64 {
        let n = ring.len();
        let cross = |i: usize| {
            let (a, b) = (ring[i], ring[(i + 1) % n]);
            a[0] * b[1] - a[1] * b[0]
        };
        0.5 * (0..n).map(cross).sum::<f64>()
    }

    #[test]
    fn triangles_fill_a_disc_between_its_holes() {
        let rings = [
            round([0.0, 0.0], 30.0, 361, 1.0),
            round([0.0, 0.0], 8.0, 60, -1.0),
            round([15.0, 3.0], 5.0, 47, -1.0),
            round([-17.0, -4.0], 6.0, 48, -1.0),
        ];
        let triangles = face(&rings).unwrap();
        let points = rings.concat();
        let filled: f64 = triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|i| points[i]);
                let twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
                assert!(twice > 0.0);
                0.5 * twice
            })
            .sum();
        let exact: f64 = rings.iter().map(|ring| area(ring)).sum();
        assert!((filled / exact - 1.0).abs() < 1e-12, "{filled} {exact}");
        // Every edge of a ring once, every other edge twice in opposite senses.
        let mut count = std::collections::HashMap::new();
        for t in &triangles {
            for k in 0..3 {
                *count.entry((t[k], t[(k + 1) % 3])).or_insert(0) += 1;
            }
        }
        assert!(count.values().all(|n| *n == 1));
        let open = count
            .keys()
            .filter(|(a, b)| !count.contains_key(&(*b, *a)))
            .count();
        assert_eq!(open, points.len());
    }

    #[test]
    fn rings_that_cross_have_no_face() {
        let rings = [
            round([0.0, 0.0], 30.0, 361, 1.0),
            round([28.0, 0.0], 8.0, 60, -1.0),
        ];
        assert!(face(&rings).is_none());
    }
}

//! Closed surface of the cam as a plate, for printing and milling.

use super::Mesh;
use crate::step::positive;
use gaitcam::cam::Bore;
use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::units::Quantity;

const MM: f64 = 1000.0;

/// Plate of constant thickness; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate {
    /// Thickness of the plate, m. The lower face is at z = 0.
    pub thickness: f64,
    /// Bore for the shaft; `None` for a plate without a bore.
    pub bore: Option<Bore>,
    /// Number of vertices of the profile.
    pub points: usize,
}

/// Surface of the plate.
///
/// Every vertex of the profile is connected with the point of the bore on the same ray from the centre. Without a bore, it is connected
/// with the centre. The faces are therefore wedges that cannot overlap.
///
/// # Errors
///
/// - A ray from the centre meets the profile more than once.
/// - The bore does not fit.
/// - The thickness or the number of points is invalid.
/// - The profile is undercut, or the law is open.
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
    // The outline is counter-clockwise, whereas the profile is clockwise.
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
    Ok(match plate.bore {
        None => full(&outline, thickness),
        Some(bore) => bored(&with_corners(outline, &bore), &bore, thickness),
    })
}

/// Minimum distance of the polygon from the origin, the centre of the cam.
fn clearance(outline: &[[f64; 2]]) -> f64 {
    let n = outline.len();
    (0..n)
        .map(|i| {
            let (p, q) = (outline[i], outline[(i + 1) % n]);
            let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
            let u = -(p[0] * dx + p[1] * dy) / (dx * dx + dy * dy);
            let u = u.clamp(0.0, 1.0);
            libm::hypot(p[0] + u * dx, p[1] + u * dy)
        })
        .fold(f64::INFINITY, f64::min)
}

/// Vertices of a closed curve at both heights of the plate. The index 2i is at the bottom, and 2i + 1 at the top.
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

/// Copy of the polygon with additional vertices. They are the intersections of the polygon with the rays from the centre through the
/// corners of the bore.
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

/// Position at which a ray from the centre intersects the chord from `p` to `q`, as a fraction of the chord; `None` without an intersection.
fn crossing(p: [f64; 2], q: [f64; 2], angle: f64) -> Option<f64> {
    let (sin, cos) = libm::sincos(angle);
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
            let scale = MM * bore.edge(libm::atan2(p[1], p[0])) / libm::hypot(p[0], p[1]);
            [scale * p[0], scale * p[1]]
        })
        .collect();
    let mut vertices = ring(outline, thickness);
    vertices.extend(ring(&bore, thickness));
    let mut triangles = Vec::with_capacity(8 * n);
    for i in 0..n {
        let (a, b) = (2 * i, 2 * ((i + 1) % n));
        let (c, d) = (2 * n + a, 2 * n + b);
        // Order of the triangles: outer wall, bore wall, upper face, lower face.
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

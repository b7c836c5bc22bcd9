//! Interference: roller, face or arm against another part of the cam than the one it touches.
//!
//! Undercut is local; this looks at the whole profile, which CAM-DAS leaves to the eye. It samples: the
//! profile is taken at n points, so depths below its sagitta (about step²/8ρ) are not seen.

use super::geometry::Geometry;
use super::{Cam, Follower, ProfilePoint};

/// What touches the cam where it should not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {
    /// The roller or the mushroom's arc.
    Roller,
    /// The flat face.
    Face,
    /// The arm from pivot to roller centre, or the stem above a translating roller.
    Arm,
}

/// The worst interference of one body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interference {
    /// What touches.
    pub body: Body,
    /// Cam angle at which it is worst, rad.
    pub at: f64,
    /// Cam angle whose profile point is in the way, rad.
    pub point: f64,
    /// How deep that point lies inside the body, m.
    pub depth: f64,
}

impl Cam {
    /// The worst interference of every body, for a cam sampled at `n` points (720 is plenty); the arm or
    /// stem is a bar of the given width, m, in the plane of the cam (0: it runs beside the cam, and is
    /// left out). Depths below `tolerance`, m, are not reported. Empty: none found.
    ///
    /// An arm that rests on a small roller must be narrower than the roller, or it is reported.
    pub fn interference(&self, n: usize, arm_width: f64, tolerance: f64) -> Vec<Interference> {
        let geometry = Geometry::new(&self.follower);
        let profile = self.profile(n);
        let mut worst: Vec<Interference> = Vec::new();
        for here in &profile {
            let frame = Frame::new(here, &geometry);
            for other in &profile {
                let point = frame.fixed(other);
                for (body, depth) in depths(&self.follower, &frame, point, arm_width) {
                    if depth <= tolerance {
                        continue;
                    }
                    let found = Interference {
                        body,
                        at: here.theta,
                        point: other.theta,
                        depth,
                    };
                    match worst.iter_mut().find(|w| w.body == body) {
                        Some(w) if w.depth >= depth => {}
                        Some(w) => *w = found,
                        None => worst.push(found),
                    }
                }
            }
        }
        worst
    }
}

/// The frame fixed in space at one instant, with the follower in it.
struct Frame {
    theta: f64,
    straight: Option<f64>,
    sin: f64,
    cos: f64,
    contact: [f64; 2],
    centre: [f64; 2],
    normal: [f64; 2],
}

impl Frame {
    fn new(here: &ProfilePoint, geometry: &Geometry) -> Self {
        let (sin, cos) = here.theta.sin_cos();
        let mut frame = Frame {
            theta: here.theta,
            straight: geometry.straight(),
            sin,
            cos,
            contact: [0.0; 2],
            centre: [0.0; 2],
            normal: [0.0, 1.0],
        };
        frame.contact = frame.fixed(here);
        frame.centre = frame.place(here.pitch_x, here.pitch_y);
        frame
    }

    fn fixed(&self, p: &ProfilePoint) -> [f64; 2] {
        self.place(p.x, p.y)
    }

    fn place(&self, x: f64, y: f64) -> [f64; 2] {
        match self.straight {
            Some(scale) => [x - scale * self.theta, y],
            None => [self.cos * x - self.sin * y, self.sin * x + self.cos * y],
        }
    }
}

fn depths(follower: &Follower, frame: &Frame, point: [f64; 2], arm_width: f64) -> Vec<(Body, f64)> {
    let [x, y] = frame.centre;
    let radius = follower.roller_radius();
    let roller = || (Body::Roller, radius - (point[0] - x).hypot(point[1] - y));
    let half = 0.5 * arm_width;
    match *follower {
        Follower::FlatTranslating { .. } => {
            let [nx, ny] = frame.normal;
            let [cx, cy] = frame.contact;
            vec![(Body::Face, nx * (point[0] - cx) + ny * (point[1] - cy))]
        }
        Follower::FlatOscillating { pivot_distance, .. } => {
            vec![(
                Body::Face,
                beyond_face(follower, frame, pivot_distance, point),
            )]
        }
        Follower::RollerTranslating { .. } | Follower::TranslatingCam { .. } if half > 0.0 => {
            let stem = if point[1] > y {
                half - (point[0] - x).abs()
            } else {
                -1.0
            };
            vec![roller(), (Body::Arm, stem)]
        }
        Follower::RollerOscillating { pivot_distance, .. } if half > 0.0 => {
            let depth = half - distance_to_segment(point, [pivot_distance, 0.0], [x, y]);
            vec![roller(), (Body::Arm, depth)]
        }
        _ => vec![roller()],
    }
}

/// How far a point lies beyond an oscillating face. The face's line passes through the contact at a right
/// angle to the line from the pivot's foot, which the pivot distance and the contact fix.
fn beyond_face(follower: &Follower, frame: &Frame, pivot: f64, point: [f64; 2]) -> f64 {
    let Follower::FlatOscillating { face_offset, .. } = *follower else {
        return f64::NEG_INFINITY;
    };
    // From pivot to contact: L along the arm, f along the normal.
    let [dx, dy] = [frame.contact[0] - pivot, frame.contact[1]];
    let along = (dx * dx + dy * dy - face_offset * face_offset)
        .max(0.0)
        .sqrt();
    let square = along * along + face_offset * face_offset;
    let side = pivot.signum();
    // n = σ·J·arm up to sign: solve (dx, dy) = along·u + f·n with n = (−σ)·J u, J the quarter turn.
    let (ux, uy) = (
        (along * dx - side * face_offset * dy) / square,
        (along * dy + side * face_offset * dx) / square,
    );
    let (nx, ny) = (side * uy, -side * ux);
    nx * (point[0] - frame.contact[0]) + ny * (point[1] - frame.contact[1])
}

fn distance_to_segment(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy);
    let t = t.clamp(0.0, 1.0);
    (p[0] - a[0] - t * dx).hypot(p[1] - a[1] - t * dy)
}

//! Functions for all drawings of a cam: rotation, poses of the follower, samples of the motion.

use gaitcam::cam::{Cam, Follower};
use gaitcam::force::ForceCurve;
use gaitcam::law::{Law, Svaj};

/// Number of sampled points of a curve over the whole law, approximately one per two pixels of a wide figure.
const PER_LAW: f64 = 540.0;

/// Rotates the point `p` counter-clockwise by `theta`, rad. This converts coordinates of the cam to fixed coordinates.
pub fn turned(p: [f64; 2], theta: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(theta);
    [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1]]
}

/// `n` equally spaced angles over the range of the law, rad. For an open law, the last angle is the end of the range. For a closed law, the
/// end of the range is the same position as its start and is omitted.
pub fn angles(law: &Law, n: usize) -> impl Iterator<Item = f64> {
    let (start, length) = law.extent();
    let steps = if law.is_closed() {
        n
    } else {
        n.saturating_sub(1).max(1)
    };
    (0..n).map(move |i| start + length * i as f64 / steps as f64)
}

/// Target force at `theta`, N. One cycle of the target covers the whole range of the law.
pub fn target_at(target: &ForceCurve, law: &Law, theta: f64) -> f64 {
    let (start, length) = law.extent();
    target.at(std::f64::consts::TAU * ((theta - start) / length))
}

/// Bounds of a drawing: lower left corner and upper right corner. The unit is that of the points in the drawing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Bounds {
    pub low: [f64; 2],
    pub high: [f64; 2],
}

impl Bounds {
    /// Extends the bounds so that they contain a point with a margin around it.
    pub fn hold(&mut self, point: [f64; 2], margin: f64) {
        for (k, x) in point.into_iter().enumerate() {
            self.low[k] = self.low[k].min(x - margin);
            self.high[k] = self.high[k].max(x + margin);
        }
    }
}

/// Position of the part of the follower that touches the cam, in fixed coordinates, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pose {
    /// A flat face through the point `at` in the direction `angle`.
    Face {
        /// Point of the face at the foot of the stem, m. For an arm, it is the foot of the perpendicular from the pivot to the face.
        at: [f64; 2],
        /// Angle from +x to the face, rad.
        angle: f64,
    },
    /// A roller, or the tip of a knife edge (radius 0).
    Roller {
        /// Centre of the roller, m.
        centre: [f64; 2],
        /// Radius of the roller, m; 0 for a knife edge.
        radius: f64,
    },
}

/// Position of the follower at the cam angle `theta`.
///
/// The face of an oscillating follower starts at the foot of the perpendicular from its pivot and extends along the arm.
pub fn pose(cam: &Cam, theta: f64) -> Pose {
    let point = cam.point(theta);
    let [nx, ny] = cam.motion(theta);
    match cam.follower {
        Follower::FlatTranslating { .. } => Pose::Face {
            at: [0.0, cam.into_space(theta, [point.x, point.y])[1]],
            angle: 0.0,
        },
        Follower::FlatOscillating {
            pivot_distance,
            face_offset,
            ..
        } => Pose::Face {
            at: [pivot_distance + face_offset * nx, face_offset * ny],
            // The arm points from the pivot to (−σ cos ξ, sin ξ), perpendicular to the normal.
            angle: if pivot_distance > 0.0 {
                libm::atan2(nx, -ny)
            } else {
                libm::atan2(-nx, ny)
            },
        },
        _ => Pose::Roller {
            centre: cam.into_space(theta, [point.pitch_x, point.pitch_y]),
            radius: cam.follower.roller_radius(),
        },
    }
}

/// Ends of the face that a flat follower needs, m, computed from the range of the contact. For a translating follower, they are measured
/// from the cam centre along x. For an arm, they are measured along the face from the foot of the perpendicular from the pivot. `None`
/// for other followers.
pub fn face_reach(cam: &Cam) -> Option<(f64, f64)> {
    if !cam.follower.is_flat() {
        return None;
    }
    cam.contact_travel()
        .map(|(low, high)| (low.value, high.value))
}

/// Sampled motion of a law as (angle in rad, motion). Both sides of every break are sampled, so that jumps are visible.
pub fn motion(law: &Law) -> Vec<(f64, Svaj)> {
    let breaks = law.breaks();
    let (_, length) = law.extent();
    let mut out = Vec::new();
    for (i, w) in breaks.windows(2).enumerate() {
        let steps = ((w[1] - w[0]) / length * PER_LAW).ceil().max(2.0) as usize;
        for k in 0..=steps {
            let u = k as f64 / steps as f64;
            out.push((w[0] + u * (w[1] - w[0]), law.svaj_on(i, u)));
        }
    }
    out
}

/// Maximum radius of curvature that is drawn, m. It is `size` times the prime radius or the stroke, whichever is larger, because curves
/// with larger radii look straight. For an unrolled cam, it is at least the 75th percentile of `radii`.
pub fn largest_radius(cam: &Cam, size: f64, radii: impl Iterator<Item = f64>) -> f64 {
    let size = size * cam.follower.prime_radius().max(cam.law.stroke());
    if !cam.follower.is_unrolled() {
        return size;
    }
    let mut all: Vec<f64> = radii.filter(|r| r.is_finite()).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() * 3 / 4).map_or(size, |r| r.max(size))
}

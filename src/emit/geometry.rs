//! What every drawing of a cam needs besides its profile: directions, poses, angles of the rows.

use crate::cam::{Cam, Follower, ProfilePoint};
use crate::gait::ForceCurve;
use crate::law::Law;

/// Turns `p` by `theta` rad, counter-clockwise: from the cam's frame into the fixed one.
pub fn turned(p: [f64; 2], theta: f64) -> [f64; 2] {
    let (sin, cos) = theta.sin_cos();
    [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1]]
}

/// Outward unit normal of the profile at a point, cam frame, exact.
///
/// A translating follower moves along +y, and the contact normal leans from it by the pressure angle:
/// (−sin φ, cos φ) in the fixed frame.
pub fn normal(point: &ProfilePoint) -> [f64; 2] {
    let (sin, cos) = point.pressure_angle.sin_cos();
    turned([-sin, cos], -point.theta)
}

/// Angles of `n` rows at equal steps: a closed law does not repeat its first, an open one ends on its last.
pub fn angles(law: &Law, n: usize) -> impl Iterator<Item = f64> {
    let (start, length) = law.extent();
    let steps = if law.is_closed() {
        n
    } else {
        n.saturating_sub(1).max(1)
    };
    (0..n).map(move |i| start + length * i as f64 / steps as f64)
}

/// Force wanted at `theta`, N: the target's cycle spread over the law's extent.
pub fn target_at(target: &ForceCurve, law: &Law, theta: f64) -> f64 {
    let (start, length) = law.extent();
    target.at(std::f64::consts::TAU * ((theta - start) / length))
}

/// The part of the follower that touches the cam, in the fixed frame, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pose {
    /// A face through `at`, along the direction `angle` (rad) from +x.
    Face {
        /// The foot of the stem.
        at: [f64; 2],
        /// Direction of the face.
        angle: f64,
    },
    /// A roller, or the tip of a knife edge (radius 0).
    Roller {
        /// Centre of the roller.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
    },
}

/// Where the follower stands when the cam has turned to `theta`.
pub fn pose(cam: &Cam, theta: f64) -> Pose {
    let point = cam.point(theta);
    match cam.follower {
        Follower::FlatTranslating { .. } => Pose::Face {
            at: [0.0, turned([point.x, point.y], theta)[1]],
            angle: 0.0,
        },
        Follower::RollerTranslating { roller_radius, .. } => Pose::Roller {
            centre: turned([point.pitch_x, point.pitch_y], theta),
            radius: roller_radius,
        },
    }
}

/// The face a flat follower needs: how far the contact wanders to −x and to +x, m; `None` for rollers.
pub fn face_reach(cam: &Cam) -> Option<(f64, f64)> {
    match cam.follower {
        Follower::FlatTranslating { .. } => {
            let (low, high) = cam.law.extremes(1);
            Some((low.value, high.value))
        }
        Follower::RollerTranslating { .. } => None,
    }
}

/// Whether lift is an angle: its columns then read rad in place of m.
pub fn oscillates(follower: &Follower) -> bool {
    match follower {
        Follower::FlatTranslating { .. } | Follower::RollerTranslating { .. } => false,
    }
}

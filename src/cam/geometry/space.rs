//! From the cam's frame into space and back to directions: what drawings and dynamics ask of a follower.

use crate::cam::{Cam, Follower, ProfilePoint};

impl Cam {
    /// A point of the cam as it lies in the fixed frame when the cam has turned (or slid) to `theta`.
    pub fn into_space(&self, theta: f64, p: [f64; 2]) -> [f64; 2] {
        match self.follower {
            Follower::TranslatingCam { .. } => [p[0] - theta, p[1]],
            Follower::Barrel { radius, .. } => [p[0] - radius * theta, p[1]],
            _ => turned(p, theta),
        }
    }

    /// Unit direction in which the contact side of the follower moves as its lift grows, fixed frame: +y,
    /// or square to the arm (the outward normal of a flat face on an arm).
    pub fn motion(&self, theta: f64) -> [f64; 2] {
        let Some(start) = self.follower.start_angle() else {
            return [0.0, 1.0];
        };
        let side = self.follower.pivot().map_or(1.0, |p| p[0].signum());
        let (sin, cos) = (start + self.law.svaj(theta).s).sin_cos();
        [side * sin, cos]
    }

    /// Outward unit normal of the cam at one of its profile points, cam frame, exact: that of a flat face, or
    /// the motion leaned by the pressure angle.
    pub fn normal(&self, point: &ProfilePoint) -> [f64; 2] {
        let motion = self.motion(point.theta);
        let fixed = if self.follower.is_flat() {
            motion
        } else {
            turned(motion, point.pressure_angle)
        };
        match self.follower {
            Follower::TranslatingCam { .. } | Follower::Barrel { .. } => fixed,
            _ => turned(fixed, -point.theta),
        }
    }
}

impl Follower {
    /// Where the arm is pivoted, fixed frame, m; `None` without an arm.
    pub fn pivot(&self) -> Option<[f64; 2]> {
        match *self {
            Follower::RollerOscillating { pivot_distance, .. }
            | Follower::MushroomOscillating { pivot_distance, .. }
            | Follower::FlatOscillating { pivot_distance, .. } => Some([pivot_distance, 0.0]),
            _ => None,
        }
    }
}

/// Counter-clockwise by `angle`.
fn turned(p: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1]]
}

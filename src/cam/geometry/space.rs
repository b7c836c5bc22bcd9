//! Transformations between cam frame and fixed frame, for drawings and dynamics.

use super::Geometry;
use crate::cam::{Cam, Follower, ProfilePoint};
use crate::law::Svaj;

/// Number of consecutive profile points for which sine and cosine are evaluated once. The addition theorems give the values of the other
/// points.
const TURNS: usize = 32;

/// Position of the cam's frame in the fixed frame at one instant.
#[derive(Clone, Copy)]
pub(crate) enum Frame {
    Turned { sin: f64, cos: f64 },
    Moved(f64),
}

impl Frame {
    fn turned(angle: f64) -> Frame {
        let (sin, cos) = libm::sincos(angle);
        Frame::Turned { sin, cos }
    }

    /// The frame after a further rotation or translation.
    #[inline(always)]
    pub fn then(self, more: Frame) -> Frame {
        match (self, more) {
            (Frame::Turned { sin, cos }, Frame::Turned { sin: s, cos: c }) => Frame::Turned {
                sin: sin * c + cos * s,
                cos: cos * c - sin * s,
            },
            (Frame::Moved(by), Frame::Moved(more)) => Frame::Moved(by + more),
            _ => unreachable!("a cam either turns or slides"),
        }
    }

    /// Converts a point of the fixed frame to the cam's frame.
    #[inline(always)]
    pub fn seen(self, p: [f64; 2]) -> [f64; 2] {
        match self {
            Frame::Turned { sin, cos } => [cos * p[0] + sin * p[1], cos * p[1] - sin * p[0]],
            Frame::Moved(by) => [p[0] + by, p[1]],
        }
    }

    /// Converts a point of the cam's frame to the fixed frame.
    pub fn in_space(self, p: [f64; 2]) -> [f64; 2] {
        match self {
            Frame::Turned { sin, cos } => [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1]],
            Frame::Moved(by) => [p[0] - by, p[1]],
        }
    }
}

impl Geometry {
    /// Frame of the cam at an angle or travel.
    pub fn frame(&self, theta: f64) -> Frame {
        match self {
            Geometry::Unrolled(unrolled) => Frame::Moved(unrolled.scale * theta),
            _ => Frame::turned(theta),
        }
    }

    /// Point of the profile at the cam angle (or travel) `theta`. `at` is the motion of the follower at this angle.
    pub fn profile_point(&self, theta: f64, at: Svaj) -> ProfilePoint {
        self.seen_from(self.frame(theta), theta, at)
    }

    /// Profile points for the motions `motions` of the follower, at the cam angles (or travels) `angles`, which increase in steps of
    /// `step`.
    pub fn profile_points(&self, step: f64, angles: &[f64], motions: &[Svaj]) -> Vec<ProfilePoint> {
        let turns: [Frame; TURNS] = std::array::from_fn(|k| self.frame(step * k as f64));
        let mut out = Vec::with_capacity(angles.len());
        for (angles, motions) in angles.chunks(TURNS).zip(motions.chunks(TURNS)) {
            let first = self.frame(angles[0]);
            for ((theta, at), turn) in angles.iter().zip(motions).zip(&turns) {
                out.push(self.seen_from(first.then(*turn), *theta, *at));
            }
        }
        out
    }

    fn seen_from(&self, frame: Frame, theta: f64, at: Svaj) -> ProfilePoint {
        let contact = self.contact(at);
        let [x, y] = frame.seen(contact.point);
        let [pitch_x, pitch_y] = frame.seen(contact.pitch);
        ProfilePoint {
            theta,
            x,
            y,
            pitch_x,
            pitch_y,
            rho: contact.rho,
            pressure_angle: libm::atan(contact.tan_pressure),
        }
    }
}

impl Cam {
    /// Converts a point of the cam to the fixed frame, with the cam at the angle (or travel) `theta`.
    pub fn into_space(&self, theta: f64, p: [f64; 2]) -> [f64; 2] {
        Geometry::new(&self.follower).frame(theta).in_space(p)
    }

    /// Unit vector of the motion of the follower's contact side with increasing lift, fixed frame: +y, or perpendicular to the arm. For an
    /// oscillating flat face it is the outward normal.
    pub fn motion(&self, theta: f64) -> [f64; 2] {
        let Some(start) = self.follower.start_angle() else {
            return [0.0, 1.0];
        };
        let side = self.follower.pivot().map_or(1.0, |p| p[0].signum());
        let (sin, cos) = libm::sincos(start + self.law.svaj(theta).s);
        [side * sin, cos]
    }

    /// Exact outward unit normal of the cam at a profile point, in the cam frame. For a flat face it is the normal of the face; otherwise
    /// the direction of motion, rotated by the pressure angle.
    pub fn normal(&self, point: &ProfilePoint) -> [f64; 2] {
        let motion = self.motion(point.theta);
        let fixed = if self.follower.is_flat() {
            motion
        } else {
            Frame::turned(point.pressure_angle).in_space(motion)
        };
        if self.follower.is_unrolled() {
            return fixed;
        }
        Frame::turned(point.theta).seen(fixed)
    }
}

impl Follower {
    /// Position of the pivot of the arm, fixed frame, m; `None` without an arm.
    pub fn pivot(&self) -> Option<[f64; 2]> {
        match *self {
            Follower::RollerOscillating { pivot_distance, .. }
            | Follower::MushroomOscillating { pivot_distance, .. }
            | Follower::FlatOscillating { pivot_distance, .. } => Some([pivot_distance, 0.0]),
            _ => None,
        }
    }
}

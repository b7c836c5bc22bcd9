//! Profile of a cam: contact points in the cam's frame.

use super::Cam;
use super::geometry::Geometry;
use crate::law::Joint;

/// Fraction of the maximum of a derivative below which its jumps are treated as rounding errors.
const NO_JUMP: f64 = 1e-9;

/// Point of the profile; lengths in m, angles in rad.
///
/// For a translating cam and an unrolled barrel, x is the travel and y points up.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::law::Law;
///
/// // For a roller of radius 10 mm at rest on a prime circle of 40 mm, the cam is a disc of radius 30 mm.
/// let rest = Law::harmonic(0.0, &[]);
/// let follower = Follower::RollerTranslating { prime_radius: 0.04, offset: 0.0, roller_radius: 0.01 };
/// let point = Cam::new(rest, follower)?.point(1.0);
/// assert!((point.x.hypot(point.y) - 0.03).abs() < 1e-15);
/// assert!((point.pitch_x.hypot(point.pitch_y) - 0.04).abs() < 1e-15);
/// assert!((point.rho - 0.03).abs() < 1e-15 && point.pressure_angle.abs() < 1e-15);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ProfilePoint {
    /// Cam angle at which the follower touches this point (m of travel for a translating cam).
    pub theta: f64,
    /// x coordinate of the contact point on the finished cam, cam frame.
    pub x: f64,
    /// y coordinate of the contact point on the finished cam, cam frame.
    pub y: f64,
    /// x coordinate of the centre of the roller or arc, cam frame. For a flat face, it equals `x`.
    pub pitch_x: f64,
    /// y coordinate of the centre of the roller or arc, cam frame. For a flat face, it equals `y`.
    pub pitch_y: f64,
    /// Signed radius of curvature of the finished cam: positive where convex, negative where concave.
    pub rho: f64,
    /// Pressure angle, rad; positive if the force is rotated counter-clockwise from the motion, as during a rise.
    pub pressure_angle: f64,
}

impl Cam {
    /// Profile point that touches the follower at `theta`.
    pub fn point(&self, theta: f64) -> ProfilePoint {
        let geometry = Geometry::new(&self.follower);
        geometry.profile_point(theta, self.law.svaj(theta))
    }

    /// Profile points at the discontinuities of the law, sorted by angle, with one point on each side of a jump. Derivatives up to `order`
    /// are considered (2: acceleration, 3: jerk). An exported profile contains these points and is smooth between them.
    pub fn breakpoints(&self, order: usize) -> Vec<[ProfilePoint; 2]> {
        let none = [0, 1, 2, 3].map(|k| NO_JUMP * self.law.bound(k));
        let jumps = |joint: &Joint| {
            let jump = joint.jump;
            let apart = [jump.s, jump.v, jump.a, jump.j];
            (0..=order.min(3)).any(|k| apart[k].abs() > none[k])
        };
        let geometry = Geometry::new(&self.follower);
        let joints = self.law.joints().into_iter().filter(jumps);
        joints
            .map(|joint| joint.sides.map(|at| geometry.profile_point(joint.at, at)))
            .collect()
    }

    /// `n` profile points at equal steps of the cam angle, from the first angle of the law. For a closed law, the first point is not
    /// repeated at the end. For an open law, the last point is at the end of the law.
    pub fn profile(&self, n: usize) -> Vec<ProfilePoint> {
        let (start, length) = self.law.extent();
        let steps = if self.law.is_closed() {
            n
        } else {
            n.saturating_sub(1).max(1)
        };
        let step = length / steps as f64;
        let angles: Vec<f64> = (0..n).map(|i| start + step * i as f64).collect();
        let motions = self.law.svaj_along(&angles);
        Geometry::new(&self.follower).profile_points(step, &angles, &motions)
    }
}

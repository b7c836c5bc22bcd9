//! Continuity of the derivatives of a law, and the class of its cam in CAM-DAS.

use serde::Serialize;

use super::{Cam, Verdict};
use crate::law::Joint;
use crate::poly::Extreme;

/// Fraction of the peak-to-peak value of a derivative below which its jumps are rounding errors.
const JUMP: f64 = 1e-7;
/// Lower bound of the range to which [`JUMP`] is related, m/radᵏ, where k is the order of the derivative. A derivative that varies less
/// counts as constant.
const STILL: f64 = 1e-9;
/// Size below which a jump is a rounding error on any cam, m/radᵏ, where k is the order of the derivative.
const ROUNDING: f64 = 1e-13;
/// Second lower bound of the range to which [`JUMP`] is related, as a fraction of the prime radius.
const HARDLY_MOVES: f64 = 1e-6;
/// Variation of the cam's breadth over a turn below which the breadth counts as constant, as a fraction of the stroke.
const BREADTH: f64 = 1e-9;

/// Continuity of lift, velocity, acceleration and jerk.
///
/// ```
/// use gaitcam::cam::{Cam, Continuity, Follower, Verdict};
/// use gaitcam::law::{Extent, Rise, Segment, program};
///
/// let segment = |motion, lift| Segment { motion, lift, angle: std::f64::consts::PI };
/// let law = program(&[segment(Rise::Poly345, 0.02), segment(Rise::Poly345, -0.02)], Extent::TURN)?;
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.1 })?;
/// let all = Continuity::of(&cam);
/// assert!(all.s && all.v && all.a && !all.j);
/// assert_eq!(cam.cam_das_class(), Verdict::NotForHighSpeed);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Continuity {
    /// Whether the lift is continuous.
    pub s: bool,
    /// Whether the velocity is continuous.
    pub v: bool,
    /// Whether the acceleration is continuous.
    pub a: bool,
    /// Whether the jerk is continuous.
    pub j: bool,
}

impl Continuity {
    /// Determines the continuity of the law of a cam.
    pub fn of(cam: &Cam) -> Self {
        let [s, v, a, j] = [0, 1, 2, 3].map(|order| cam.first_jump(order).is_none());
        Continuity { s, v, a, j }
    }
}

impl Cam {
    /// Angle of the first jump that is larger than rounding errors, in the derivative of the given order (0 = lift … 3 = jerk).
    pub fn first_jump(&self, order: usize) -> Option<f64> {
        self.jumps(order).first().map(|jump| jump.at)
    }

    /// Minimum and maximum of the derivative of order `order` of the lift with respect to the cam angle. With a positive jump of the
    /// derivative of the next lower order, the maximum is +∞. With a negative jump, the minimum is −∞. With a jump of a derivative of still
    /// lower order, both extremes are infinite.
    pub fn derivative_extremes(&self, order: usize) -> (Extreme, Extreme) {
        let (mut low, mut high) = self.law.extremes(order);
        let joints = self.law.joints();
        for below in 0..order {
            for jump in self.jumps_at(&joints, below) {
                let both = below + 1 < order;
                if low.value.is_finite() && (both || jump.value < 0.0) {
                    low = jump.map(|_| f64::NEG_INFINITY);
                }
                if high.value.is_finite() && (both || jump.value > 0.0) {
                    high = jump.map(|_| f64::INFINITY);
                }
            }
        }
        (low, high)
    }

    /// Jumps of the derivative of the given order (0 = lift … 3 = jerk) that exceed rounding errors. Each has its cam angle and its size.
    pub fn jumps(&self, order: usize) -> Vec<Extreme> {
        self.jumps_at(&self.law.joints(), order)
    }

    fn jumps_at(&self, joints: &[Joint], order: usize) -> Vec<Extreme> {
        let jump = joints.iter().map(|x| Extreme {
            at: x.at,
            value: [x.jump.s, x.jump.v, x.jump.a, x.jump.j][order],
        });
        // The threshold also scales with the size of the cam. A derivative that is zero up to rounding errors therefore has no jumps.
        let size = (HARDLY_MOVES * self.follower.prime_radius()).max(STILL);
        let above = |range: f64| move |x: &Extreme| x.value.abs() > (JUMP * range).max(ROUNDING);
        let mut jumps: Vec<Extreme> = jump.filter(above(size)).collect();
        if !jumps.is_empty() {
            let (low, high) = self.law.extremes(order);
            jumps.retain(above((high.value - low.value).max(size)));
        }
        jumps
    }

    /// CAM-DAS class of a law (Serrano Muñoz 2010, §7.3.5). CAM-DAS requires one more continuous derivative than the verdict of this
    /// program. A jump of the jerk excludes high speed. A jump of the acceleration is unacceptable unless the breadth is constant.
    pub fn cam_das_class(&self) -> Verdict {
        let Continuity { s, v, a, j } = Continuity::of(self);
        if !(s && v && (a || self.has_constant_breadth())) {
            Verdict::Unacceptable
        } else if a && !j {
            Verdict::NotForHighSpeed
        } else {
            Verdict::Acceptable
        }
    }

    /// Whether the cam has constant breadth, that is, whether s(θ) + s(θ + π) is the same at all cam angles.
    fn has_constant_breadth(&self) -> bool {
        let (start, length) = self.law.extent();
        let half = 0.5 * length;
        let slack = BREADTH * self.law.stroke();
        let sum = |x: f64| self.law.svaj(x).s + self.law.svaj(x + half).s;
        let first = sum(start);
        (1..32).all(|i| (sum(start + half * f64::from(i) / 32.0) - first).abs() <= slack)
    }
}

//! Nonconvex limit at one point of the law: h(s, v, a, j, D, e) ≥ 0 with its derivatives, and the size.

use crate::cam::Criterion;

/// Size parameters of a cam, and its minimum radius of curvature; all 0 if the size is not part of the limits.
#[derive(Debug, Clone, Copy, Default)]
pub struct ProfileSize {
    /// Height D of a translating roller.
    pub rise: f64,
    /// Offset e of a translating roller.
    pub offset: f64,
    /// Radius of the prime circle of an oscillating follower.
    pub radius: f64,
    /// Minimum radius of curvature; for a roller that of the pitch curve, which is the sum of the cam's and the roller's radius.
    pub rho: f64,
}

impl ProfileSize {
    /// Radius of the prime circle.
    pub fn prime_radius(&self) -> f64 {
        libm::hypot(self.rise, self.offset) + self.radius
    }
}

/// Value h of a nonconvex limit and its derivatives with respect to s, v, a, j, D, e, Rp.
pub struct Slack {
    /// Name of the limit.
    pub name: Criterion,
    pub h: f64,
    /// Scale of h, in which the clearance is expressed.
    pub w: f64,
    /// Largest term of h.
    pub largest: f64,
    pub by_lift: f64,
    pub by_velocity: f64,
    pub by_acceleration: f64,
    pub by_jerk: f64,
    pub by_rise: f64,
    pub by_offset: f64,
    pub by_radius: f64,
}

impl Slack {
    /// Limit with zero derivatives, to be completed.
    pub fn none(name: impl Into<Criterion>) -> Self {
        Slack {
            name: name.into(),
            h: 0.0,
            w: 1.0,
            largest: 1.0,
            by_lift: 0.0,
            by_velocity: 0.0,
            by_acceleration: 0.0,
            by_jerk: 0.0,
            by_rise: 0.0,
            by_offset: 0.0,
            by_radius: 0.0,
        }
    }
}

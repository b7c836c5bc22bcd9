//! Clearance of a nonconvex limit at one point of the law: h(s, v, a, j, D, e, Rp) ≥ 0, with the partial derivatives of h. Here s is the
//! lift. Its derivatives with respect to the cam angle are v, a and j. D is the height of the roller centre at s = 0, e the offset, and Rp
//! the prime radius.

use crate::cam::Criterion;

/// Size parameters of a cam, and its minimum radius of curvature, m. All values are 0 if the size is not part of the limits.
#[derive(Debug, Clone, Copy, Default)]
pub struct ProfileSize {
    /// Height D of a translating roller.
    pub rise: f64,
    /// Offset e of a translating roller.
    pub offset: f64,
    /// Radius of the prime circle of an oscillating follower.
    pub radius: f64,
    /// Minimum permitted radius of curvature. For a roller it applies to the pitch curve and is the sum of the permitted radius of the
    /// profile and the roller radius.
    pub rho: f64,
}

impl ProfileSize {
    /// Radius of the prime circle, m.
    pub fn prime_radius(&self) -> f64 {
        libm::hypot(self.rise, self.offset) + self.radius
    }
}

/// Value h of a nonconvex limit and its derivatives with respect to s, v, a, j, D, e, Rp.
pub struct Slack {
    /// Name of the limit.
    pub name: Criterion,
    pub h: f64,
    /// Scale w of h, for the relative clearance h/w.
    pub w: f64,
    /// Magnitude of the largest term of h.
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
    /// Clearance with h = 0 and zero derivatives. The caller sets the actual values.
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

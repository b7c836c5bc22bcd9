//! A nonconvex limit at one place of the law: h(s, v, a, j, D, e) ≥ 0 with its derivatives, and the size that enters it.

use crate::cam::Criterion;

/// What fixes the size of a cam, and the smallest radius allowed on it; all 0 where the size is no part of the limits.
#[derive(Debug, Clone, Copy, Default)]
pub struct ProfileSize {
    /// D of a roller that slides.
    pub rise: f64,
    /// e of the same.
    pub offset: f64,
    /// Radius of the prime circle under a follower that swings.
    pub radius: f64,
    /// Smallest radius allowed; under a roller that of the pitch curve: the cam's plus the roller's.
    pub rho: f64,
}

impl ProfileSize {
    /// Radius of the prime circle.
    pub fn prime_radius(&self) -> f64 {
        self.rise.hypot(self.offset) + self.radius
    }
}

/// h and its derivatives by s, v, a, j, D, e, Rp.
pub struct Slack {
    /// Name of the limit.
    pub name: Criterion,
    pub h: f64,
    /// ProfileSize of which h is a part: what the clearance is counted in.
    pub w: f64,
    /// Largest term in h.
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
    /// A limit that nothing enters, to be filled in.
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

//! One contact of cam and follower.

/// One contact in the fixed frame; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Contact {
    /// Contact point of cam and follower.
    pub point: [f64; 2],
    /// Centre of the circle; the contact point itself for a flat face.
    pub pitch: [f64; 2],
    /// Unit normal, from the cam towards the follower.
    pub normal: [f64; 2],
    /// Signed radius of curvature of the cam.
    pub rho: f64,
    /// tan of the signed pressure angle: angle from the motion of the follower's point to the contact normal,
    /// counter-clockwise positive.
    pub tan_pressure: f64,
}

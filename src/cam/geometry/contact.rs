//! Contact of cam and follower, with normal and curvature.

/// Contact of cam and follower in the fixed frame; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Contact {
    /// Contact point of cam and follower.
    pub point: [f64; 2],
    /// Centre of the roller or arc. For a flat face, it is the contact point.
    pub pitch: [f64; 2],
    /// Unit normal, from the cam towards the follower.
    pub normal: [f64; 2],
    /// Radius of curvature of the cam; positive where the cam is convex.
    pub rho: f64,
    /// Tangent of the pressure angle. This angle extends from the motion of the follower to the contact normal and is positive
    /// counter-clockwise.
    pub tan_pressure: f64,
}

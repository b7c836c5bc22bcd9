//! Lift and derivatives at one angle.

/// Lift and its first three derivatives with respect to the cam angle. Their units are m, m/rad, m/rad² and m/rad³. For an oscillating
/// follower, rad replaces m.
///
/// ```
/// use gaitcam::law::Law;
///
/// // s = 3 mm sin 2θ at θ = 0: v = 6 mm, a = 0, j = −24 mm.
/// let at = Law::harmonic(0.0, &[(0.0, 0.0), (0.0, 0.003)]).svaj(0.0);
/// assert!((at.v - 0.006).abs() < 1e-15 && at.a.abs() < 1e-15 && (at.j + 0.024).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Svaj {
    /// Lift s(θ), m (oscillating follower: rad).
    pub s: f64,
    /// Velocity v = ds/dθ, m/rad.
    pub v: f64,
    /// Acceleration a = d²s/dθ², m/rad².
    pub a: f64,
    /// Jerk j = d³s/dθ³, m/rad³.
    pub j: f64,
}

//! Minimum size of the cam for a law: closed forms of theory §6.

use super::{Cam, Follower};
use crate::error::{CamError, CamInputError, Result};
use crate::law::Law;

/// Radius of the prime circle and offset of the follower's line of motion, m.
///
/// ```
/// use gaitcam::cam::smallest_prime_circle;
/// use gaitcam::law::Law;
///
/// // For s = h (1 − cos θ)/2 and no offset, v/tan φ − s has its maximum where tan θ = −1/tan φ.
/// let (h, tan) = (0.02, 30f64.to_radians().tan());
/// let law = Law::harmonic(0.5 * h, &[(-0.5 * h, 0.0)]);
/// let circle = smallest_prime_circle(&law, 30f64.to_radians(), 30f64.to_radians(), Some(0.0));
/// assert!((circle.radius - 0.5 * h * ((1.0 / (tan * tan) + 1.0).sqrt() - 1.0)).abs() < 1e-9);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrimeCircle {
    /// Radius Rp = √(D² + e²) of the prime circle, with the height D of the follower at s = 0.
    pub radius: f64,
    /// Offset e of the line of motion.
    pub offset: f64,
}

/// Minimum base radius of a flat-faced cam whose radius of curvature is at least `rho_min`, m. It is ρ_min − min(s + a), but not below
/// zero, with the lift s and its second derivative a.
pub fn smallest_base_radius(law: &Law, rho_min: f64) -> f64 {
    let (low, _) = law.extremes_of([1.0, 0.0, 1.0, 0.0], 0.0);
    (rho_min - low.value).max(0.0)
}

/// Minimum prime circle for limits on the absolute pressure angle. The limit is `rise` while the follower rises and `fall` while it falls,
/// rad, both in (0, π/2).
///
/// Let s be the lift, v its derivative, e the offset, D the height of the follower at s = 0, φ₁ = `rise` and φ₂ = `fall`. The pressure
/// angle φ is given by tan φ = (v − e)/(s + D). The limits are v − e ≤ tan φ₁·(s + D) and −(v − e) ≤ tan φ₂·(s + D). At a reversal of the
/// follower, the limit with the smaller tangent is |e| ≤ tan φ·(s + D). All limits are half planes in (D, e). The result is the point
/// nearest to the origin that lies in all half planes. It is on one boundary line, or at the intersection of two boundary lines. If
/// `offset` is given, only D is unknown.
pub fn smallest_prime_circle(law: &Law, rise: f64, fall: f64, offset: Option<f64>) -> PrimeCircle {
    let (t1, t2) = (libm::tan(rise), libm::tan(fall));
    let p1 = law.extremes_of([-t1, 1.0, 0.0, 0.0], 0.0).1.value;
    let p2 = law.extremes_of([-t2, -1.0, 0.0, 0.0], 0.0).1.value;
    let turning = t1.min(t2);
    let at_rest = -turning * law.extremes(0).0.value;
    // Each half plane is t·D ± e ≥ p. The entries are the tangent t, the sign of e, and the bound p.
    let planes = [
        (t1, 1.0, p1),
        (t2, -1.0, p2),
        (turning, 1.0, at_rest),
        (turning, -1.0, at_rest),
    ];
    let circle = |(d, e): (f64, f64)| PrimeCircle {
        radius: libm::hypot(d, e),
        offset: e,
    };
    if let Some(e) = offset {
        let least = planes.iter().map(|(t, side, p)| (p - side * e) / t);
        return circle((least.fold(0.0, f64::max), e));
    }
    let slack = 1e-12 * (p1.abs() + p2.abs());
    let allowed = |(d, e): (f64, f64)| {
        d >= 0.0
            && planes
                .iter()
                .all(|(t, side, p)| t * d + side * e >= p - slack)
    };
    let foot = |(t, side, p): (f64, f64, f64)| (t * p / (1.0 + t * t), side * p / (1.0 + t * t));
    let corner = |(t, side, p): (f64, f64, f64), (u, other, q): (f64, f64, f64)| {
        let d = (q - other * side * p) / (u - other * side * t);
        (d, side * (p - t * d))
    };
    let corners = (0..planes.len()).flat_map(|i| (0..i).map(move |k| corner(planes[k], planes[i])));
    let candidates = [(0.0, 0.0)]
        .into_iter()
        .chain(planes.map(foot))
        .chain(corners);
    let nearest = candidates
        .filter(|at| allowed(*at))
        .min_by(|a, b| libm::hypot(a.0, a.1).total_cmp(&libm::hypot(b.0, b.1)));
    circle(nearest.unwrap_or_else(|| corner(planes[0], planes[1])))
}

/// Limits that the minimum size must satisfy.
///
/// ```
/// use gaitcam::cam::{Cam, Follower, SizeLimits, smallest_for};
/// use gaitcam::law::Law;
///
/// // For s = 20 mm + 20 mm cos 2θ, ρ = Rb + s + s″ has its minimum Rb + 40 mm − 80 mm at θ = 0.
/// let law = Law::harmonic(0.02, &[(0.0, 0.0), (0.02, 0.0)]);
/// let cam = Cam { law, follower: Follower::FlatTranslating { base_radius: 0.1 } };
/// let limits = SizeLimits { rho_min: 0.005, ..SizeLimits::no_undercut() };
/// assert!((smallest_for(&cam, &limits)? - 0.045).abs() < 1e-6);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizeLimits {
    /// Minimum convex radius of curvature of the finished cam, m; with 0, a cusp is permitted.
    pub rho_min: f64,
    /// Maximum |pressure angle| where the follower rises, rad; π/2 for no limit.
    pub pressure_rise: f64,
    /// Maximum |pressure angle| where the follower falls, rad; π/2 for no limit.
    pub pressure_fall: f64,
    /// Whether the arm is in another plane, so that its pivot may lie within the profile.
    pub pivot_beside: bool,
}

impl SizeLimits {
    /// Limits that exclude undercut and permit any pressure angle.
    pub fn no_undercut() -> Self {
        SizeLimits {
            rho_min: 0.0,
            pressure_rise: std::f64::consts::FRAC_PI_2,
            pressure_fall: std::f64::consts::FRAC_PI_2,
            pivot_beside: false,
        }
    }

    fn hold(&self, cam: &Cam) -> bool {
        let fits = if self.pivot_beside {
            cam.check_beside()
        } else {
            cam.check()
        };
        if fits.is_err() {
            return false;
        }
        let [rise, fall] = cam.pressure_angles_by_motion();
        // Tolerance for rounding errors of a pressure angle at its limit, rad.
        let slack = 1e-12;
        cam.curvature().convex.value >= self.rho_min
            && rise.value <= self.pressure_rise + slack
            && fall.value <= self.pressure_fall + slack
    }
}

/// Factor by which the size increases per step in the search for a feasible cam. The next constant is the maximum number of steps.
const GROWTH: f64 = 1.25;
const GROWTHS: i32 = 90;

/// Minimum base radius, m, for which `cam` can execute its law and satisfies the limits, with its other dimensions unchanged. For a barrel,
/// it is the minimum radius of the cylinder. The relative accuracy is 1e-10. The result is 0 if every size is feasible. The base radius of
/// `cam` is ignored.
///
/// For a translating flat face the result is a closed form. Otherwise the size is increased by 25 % per step until the cam is feasible.
/// Bisection then refines the size.
///
/// # Errors
///
/// No size satisfies the limits.
pub fn smallest_for(cam: &Cam, limits: &SizeLimits) -> Result<f64> {
    if matches!(cam.follower, Follower::FlatTranslating { .. }) {
        return Ok(smallest_base_radius(&cam.law, limits.rho_min));
    }
    if matches!(cam.follower, Follower::TranslatingCam { .. }) {
        return Err(CamInputError::TranslatingHeight.into());
    }
    let at = |base: f64| Cam {
        law: cam.law.clone(),
        follower: cam.follower.with_base_radius(base),
    };
    let unit = match cam.follower.pivot() {
        Some([x, _]) => x.abs(),
        None => cam.law.stroke().max(cam.follower.roller_radius()),
    };
    let mut bad = 0.0;
    let found = (-40..GROWTHS - 40).find_map(|k| {
        let base = unit * GROWTH.powi(k);
        if limits.hold(&at(base)) {
            return Some(base);
        }
        bad = base;
        None
    });
    if bad == 0.0 && found.is_some() {
        return Ok(0.0);
    }
    let good = found.ok_or(CamError::NoSize {
        follower: cam.follower.kind().name(),
    })?;
    let holds = |base: f64| limits.hold(&at(base));
    Ok(least_between(bad, good, 1e-10, holds))
}

/// Minimum size that satisfies a limit, to a relative accuracy. It is computed by bisection between the infeasible size `bad` and the
/// feasible size `good`.
pub(crate) fn least_between(
    mut bad: f64,
    mut good: f64,
    accuracy: f64,
    holds: impl Fn(f64) -> bool,
) -> f64 {
    while good - bad > accuracy * good {
        let middle = 0.5 * (good + bad);
        if holds(middle) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    good
}

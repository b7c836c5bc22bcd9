//! The smallest cam for a law: closed forms of FACTS §6.

use crate::law::Law;

/// A prime circle and the offset of the follower's line of motion, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrimeCircle {
    /// Radius Rp = √(D² + e²).
    pub radius: f64,
    /// Offset e.
    pub offset: f64,
}

/// Smallest base radius of a flat-faced cam whose radius of curvature is nowhere below `rho_min`, m:
/// Rb = ρ_min − min(s + a), not below zero.
pub fn smallest_base_radius(law: &Law, rho_min: f64) -> f64 {
    let (low, _) = law.combination([1.0, 0.0, 1.0, 0.0], 0.0).extremes();
    (rho_min - low.value).max(0.0)
}

/// Smallest prime circle on which the pressure angle stays within `rise` (positive side) and −`fall`
/// (negative side), rad, both in (0, π/2).
///
/// The limits v − e ≤ tan φ₁·(s + D) and −(v − e) ≤ tan φ₂·(s + D) are half planes of (D, e); the answer
/// is their point nearest to the origin: a foot of a perpendicular or the corner. With a given `offset`
/// only D is free.
pub fn smallest_prime_circle(law: &Law, rise: f64, fall: f64, offset: Option<f64>) -> PrimeCircle {
    let (t1, t2) = (rise.tan(), fall.tan());
    let p1 = law
        .combination([-t1, 1.0, 0.0, 0.0], 0.0)
        .extremes()
        .1
        .value;
    let p2 = law
        .combination([-t2, -1.0, 0.0, 0.0], 0.0)
        .extremes()
        .1
        .value;
    if let Some(e) = offset {
        let d = ((p1 - e) / t1).max((p2 + e) / t2).max(0.0);
        return PrimeCircle {
            radius: d.hypot(e),
            offset: e,
        };
    }
    // Candidates (D, e): feet of the perpendiculars on t1·D + e = p1 and t2·D − e = p2, then the corner.
    let foot1 = (t1 * p1 / (1.0 + t1 * t1), p1 / (1.0 + t1 * t1));
    let foot2 = (t2 * p2 / (1.0 + t2 * t2), -p2 / (1.0 + t2 * t2));
    let d = (p1 + p2) / (t1 + t2);
    let corner = (d, p1 - t1 * d);
    let slack = 1e-12 * (p1.abs() + p2.abs());
    let allowed =
        |&(d, e): &(f64, f64)| d >= 0.0 && t1 * d + e >= p1 - slack && t2 * d - e >= p2 - slack;
    let best = [(0.0, 0.0), foot1, foot2]
        .into_iter()
        .find(allowed)
        .unwrap_or(corner);
    PrimeCircle {
        radius: best.0.hypot(best.1),
        offset: best.1,
    }
}

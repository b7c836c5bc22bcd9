//! Flat translating follower: contact (v, Rb + s), ρ = Rb + s + a (FACTS §6).

use super::Curvature;
use crate::law::{Law, Svaj};
use crate::poly::Extreme;

/// Contact point in the fixed frame.
pub(super) fn contact(at: Svaj, base_radius: f64) -> [f64; 2] {
    [at.v, base_radius + at.s]
}

/// Signed radius of curvature.
pub(super) fn rho(at: Svaj, base_radius: f64) -> f64 {
    base_radius + at.s + at.a
}

/// The flat face pushes along its own normal: the pressure angle is zero everywhere.
pub(super) fn no_pressure_angle(law: &Law) -> (Extreme, Extreme) {
    let zero = Extreme {
        at: law.extent().0,
        value: 0.0,
    };
    (zero, zero)
}

/// Curvature from the exact extremes of Rb + s + a; a flat face cannot touch a concave flank, so the
/// smallest radius is signed and there is no concave side.
pub(super) fn curvature(law: &Law, base_radius: f64) -> Curvature {
    let (low, _) = law
        .combination([1.0, 0.0, 1.0, 0.0], base_radius)
        .extremes();
    Curvature {
        convex: low,
        concave: None,
        undercut: low.value < 0.0,
    }
}

/// Face width max v − min v: the contact wanders by v across the face.
pub(super) fn face_width(law: &Law) -> f64 {
    let (low, high) = law.extremes(1);
    high.value - low.value
}

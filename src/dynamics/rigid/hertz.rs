//! Hertz contact of cam and follower: pressure, half-width, and depth of the maximum shear stress.
//!
//! Curvatures are 1/radius, positive for convex bodies. The contact modulus is E* = 1/((1 − ν₁²)/E₁ + (1 − ν₂²)/E₂), with Young's moduli
//! E₁, E₂ and Poisson's ratios ν₁, ν₂.

pub use crate::cam::{Material, STEEL};
use crate::drive::Drive;
use serde::Serialize;
use std::f64::consts::PI;

/// Depth of the maximum shear stress below a line contact, relative to the half-width (Johnson 1985, Contact Mechanics, §4.2).
const LINE_DEPTH: f64 = 0.786;
const LINE_SHEAR: f64 = 0.300;

/// Stresses and dimensions of a line contact under load.
///
/// ```
/// use gaitcam::dynamics::hertz::{STEEL, line, modulus};
///
/// // 1 kN on rollers of 10 and 50 mm radius, 10 mm long.
/// let contact = line(1000.0, 0.01, 100.0 + 20.0, modulus(STEEL, STEEL));
/// assert!((contact.pressure / 658.8e6 - 1.0).abs() < 1e-4);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct LineContact {
    /// Maximum contact pressure p₀, Pa.
    pub pressure: f64,
    /// Half-width of the contact, m.
    pub half_width: f64,
    /// Depth of the maximum shear stress, m, where pitting starts.
    pub shear_depth: f64,
    /// Maximum shear stress below the surface, Pa.
    pub shear: f64,
}

/// Contact modulus E* of two bodies, Pa.
pub fn modulus(a: Material, b: Material) -> f64 {
    1.0 / (a.compliance() + b.compliance())
}

/// Line contact with p₀ = √(F E*/(π L R)) for the force F and the length L. The curvature 1/R is the sum of the curvatures of both bodies,
/// `curvature` in 1/m.
///
/// `force` is in N, `length` in m. The pressure is 0 if force or curvature is 0 or negative. A flat face on a concave flank, for example,
/// is not a Hertz contact.
pub fn line(force: f64, length: f64, curvature: f64, modulus: f64) -> LineContact {
    if force <= 0.0 || curvature <= 0.0 {
        return LineContact::default();
    }
    let pressure = (force * modulus * curvature / (PI * length)).sqrt();
    let half_width = (4.0 * force / (PI * length * modulus * curvature)).sqrt();
    LineContact {
        pressure,
        half_width,
        shear_depth: LINE_DEPTH * half_width,
        shear: LINE_SHEAR * pressure,
    }
}

/// Limits the line pressure below a translating flat face to `pressure`, Pa. The limit w·(s, v, a, j) ≤ bound is returned as (w, bound). It
/// is exact and linear in the law.
///
/// The limit is F ≤ π L p²/E*·(Rb + s + a), with the contact length L, the pressure p, the contact modulus E* and the base radius Rb. It is
/// linear because force and radius of curvature are linear in the law (theory §6).
pub fn flat_face_limit(
    drive: &Drive,
    base_radius: f64,
    length: f64,
    modulus: f64,
    pressure: f64,
) -> ([f64; 4], f64) {
    let per_radius = PI * length * pressure * pressure / modulus;
    let mut weights = drive.weights();
    weights[0] -= per_radius;
    weights[2] -= per_radius;
    (weights, -(drive.rest_force - per_radius * base_radius))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::thesis;

    #[test]
    fn steel_rollers_press_with_658_8_megapascals_over_0_0966_millimetres() {
        // theory §10: 1 kN, 10 mm, radii 10 and 50 mm.
        let contact = line(1000.0, 0.01, 100.0 + 20.0, modulus(STEEL, STEEL));
        assert!((contact.pressure / 658.8e6 - 1.0).abs() < 1e-4);
        assert!((contact.half_width / 0.0966e-3 - 1.0).abs() < 1e-3);
    }

    #[test]
    fn the_limit_under_a_flat_face_is_reached_exactly_at_its_pressure() {
        let cam = thesis::double_harmonic();
        let drive = thesis::real(20.0);
        let star = modulus(STEEL, STEEL);
        let at = cam.law.svaj(1.1);
        let contact = line(drive.force(at), 0.01, 1.0 / (0.03 + at.s + at.a), star);
        let (w, bound) = flat_face_limit(&drive, 0.03, 0.01, star, contact.pressure);
        let row = w[0] * at.s + w[1] * at.v + w[2] * at.a + w[3] * at.j;
        assert!((row - bound).abs() < 1e-9);
    }

    #[test]
    fn no_force_no_pressure() {
        assert_eq!(line(-3.0, 0.01, 120.0, 1e11).pressure, 0.0);
    }
}

//! Hertz contact of cam and follower: pressure, half-width, and the depth at which fatigue begins.
//!
//! Curvatures are 1/radius, positive for convex bodies; E* = 1/((1 − ν₁²)/E₁ + (1 − ν₂²)/E₂).

use std::f64::consts::PI;

/// Depth of the largest shear under a line contact over its half-width, and that shear over the pressure
/// (Johnson, Contact Mechanics, §4.2).
const LINE_DEPTH: f64 = 0.786;
const LINE_SHEAR: f64 = 0.300;
/// The same under a round contact at ν = 0.3, over its radius.
const ROUND_DEPTH: f64 = 0.481;
const ROUND_SHEAR: f64 = 0.310;

/// Elastic constants of one body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus, Pa.
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

/// Steel: 206.8 GPa, 0.3 (theory §10).
pub const STEEL: Material = Material {
    young: 206.8e9,
    poisson: 0.3,
};

/// A contact under load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Largest pressure p₀, Pa.
    pub pressure: f64,
    /// Half-widths, m, larger first; the larger is infinite for a line.
    pub half_widths: [f64; 2],
    /// Depth of the largest shear, m, and that shear, Pa: where pitting starts. `None` for an ellipse.
    pub shear: Option<(f64, f64)>,
}

/// E* of two bodies, Pa.
pub fn modulus(a: Material, b: Material) -> f64 {
    1.0 / ((1.0 - a.poisson * a.poisson) / a.young + (1.0 - b.poisson * b.poisson) / b.young)
}

/// Line contact: p₀ = √(F E*/(π L R)), 1/R the sum of `curvature` of both bodies.
///
/// `force` N, `length` m. A force or curvature of 0 or less presses with nothing (a face wider than its
/// hollow is no Hertz contact).
pub fn line(force: f64, length: f64, curvature: f64, modulus: f64) -> Contact {
    if force <= 0.0 || curvature <= 0.0 {
        return Contact {
            pressure: 0.0,
            half_widths: [f64::INFINITY, 0.0],
            shear: None,
        };
    }
    let pressure = (force * modulus * curvature / (PI * length)).sqrt();
    let half = (4.0 * force / (PI * length * modulus * curvature)).sqrt();
    Contact {
        pressure,
        half_widths: [f64::INFINITY, half],
        shear: Some((LINE_DEPTH * half, LINE_SHEAR * pressure)),
    }
}

/// Point contact with principal relative curvatures `along` and `across`, 1/m, both positive.
///
/// The axis ratio solves (larger/smaller curvature) = [(a/b)²E − K]/(K − E) (Johnson, §4.2).
pub fn point(force: f64, along: f64, across: f64, modulus: f64) -> Contact {
    let (small, large) = (along.min(across), along.max(across));
    if force <= 0.0 || small <= 0.0 {
        return Contact {
            pressure: 0.0,
            half_widths: [0.0, 0.0],
            shear: None,
        };
    }
    let target = large / small;
    let radius = 1.0 / (small * large).sqrt();
    let round = (0.75 * force * radius / modulus).cbrt();
    if target - 1.0 < 1e-9 {
        let pressure = 1.5 * force / (PI * round * round);
        return Contact {
            pressure,
            half_widths: [round, round],
            shear: Some((ROUND_DEPTH * round, ROUND_SHEAR * pressure)),
        };
    }
    // b/a between 1e-7 (a line, for every purpose) and 1, in the logarithm.
    let (mut low, mut high) = (-16.0_f64, -1e-12);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if curvature_ratio(middle.exp()) > target {
            low = middle;
        } else {
            high = middle;
        }
    }
    let ratio = (0.5 * (low + high)).exp();
    let e2 = 1.0 - ratio * ratio;
    let (k, e) = elliptic(ratio);
    let f1 =
        (4.0 / (PI * e2) * ratio.powf(1.5) * ((e / (ratio * ratio) - k) * (k - e)).sqrt()).cbrt();
    let mean = round * f1;
    let (a, b) = (mean / ratio.sqrt(), mean * ratio.sqrt());
    Contact {
        pressure: 1.5 * force / (PI * a * b),
        half_widths: [a, b],
        shear: None,
    }
}

fn curvature_ratio(ratio: f64) -> f64 {
    let (k, e) = elliptic(ratio);
    (e / (ratio * ratio) - k) / (k - e)
}

/// Complete elliptic integrals K and E of eccentricity √(1 − ratio²), by the arithmetic–geometric mean.
fn elliptic(ratio: f64) -> (f64, f64) {
    let (mut a, mut b) = (1.0, ratio);
    let mut sum = 0.5 * (1.0 - ratio * ratio);
    let mut power = 0.5;
    for _ in 0..40 {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        power *= 2.0;
        sum += power * c * c;
        if c.abs() <= 1e-17 * a {
            break;
        }
    }
    let k = PI / (2.0 * a);
    (k, k * (1.0 - sum))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steel_rollers_press_with_658_8_megapascals_over_0_0966_millimetres() {
        // theory §10: 1 kN, 10 mm, radii 10 and 50 mm.
        let contact = line(1000.0, 0.01, 100.0 + 20.0, modulus(STEEL, STEEL));
        assert!(
            (contact.pressure / 658.8e6 - 1.0).abs() < 1e-4,
            "{}",
            contact.pressure
        );
        assert!((contact.half_widths[1] / 0.0966e-3 - 1.0).abs() < 1e-3);
    }

    #[test]
    fn elliptic_integrals_match_their_table() {
        // Abramowitz & Stegun, table 17.1, m = 0.5.
        let (k, e) = elliptic(0.5_f64.sqrt());
        assert!(
            (k - 1.854_074_677_301_37).abs() < 1e-13 && (e - 1.350_643_881_047_68).abs() < 1e-13
        );
    }

    #[test]
    fn a_crowned_roller_passes_between_ball_and_line() {
        let star = modulus(STEEL, STEEL);
        let ball = point(100.0, 50.0, 50.0, star);
        let exact = (6.0 * 100.0 * star * star * 50.0 * 50.0 / PI.powi(3)).cbrt();
        assert!((ball.pressure / exact - 1.0).abs() < 1e-12);
        let nearly = point(100.0, 50.0, 50.0 * (1.0 + 1e-6), star);
        assert!((nearly.pressure / ball.pressure - 1.0).abs() < 1e-6);
        // Equilibrium and the semi-axes: p₀ = 3F/(2πab), a > b; the long axis lies along the flatter way.
        let crowned = point(100.0, 1.0, 120.0, star);
        let [a, b] = crowned.half_widths;
        assert!(a > 5.0 * b && (crowned.pressure * 2.0 * PI * a * b / 300.0 - 1.0).abs() < 1e-12);
        // A long ellipse presses like a line that carries its peak load per length, 3F/(4a).
        let slim = point(100.0, 1e-4, 120.0, star);
        let as_line = line(0.75 * 100.0 / slim.half_widths[0], 1.0, 120.0, star);
        assert!(
            (slim.pressure / as_line.pressure - 1.0).abs() < 2e-3,
            "{slim:?} {as_line:?}"
        );
    }

    #[test]
    fn no_force_no_pressure() {
        assert_eq!(line(-3.0, 0.01, 120.0, 1e11).pressure, 0.0);
        assert_eq!(point(0.0, 1.0, 1.0, 1e11).pressure, 0.0);
    }
}

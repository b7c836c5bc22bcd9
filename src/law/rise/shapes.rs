//! Normalised shapes: rises by 1 over x ∈ [0, 1].

use super::super::pieces::Pieces;
use super::super::{Law, Wave};
use crate::error::{LawError, Result};
use crate::poly::{bernstein, stand_in};
use std::f64::consts::{PI, TAU};

/// Polynomial law Σ pₖ xᵏ with the coefficients `p`.
pub(super) fn power(p: &[f64]) -> Law {
    single(bernstein::from_power(p), Vec::new())
}

/// Law constant + slope·x + Σ (c cos rx + s sin rx), with `waves` as (r, c, s).
pub(super) fn line_and_waves(constant: f64, slope: f64, waves: &[(f64, f64, f64)]) -> Law {
    let waves = waves
        .iter()
        .map(|&(rate, cos, sin)| Wave { rate, cos, sin })
        .collect();
    single(vec![constant, constant + slope], waves)
}

fn single(coef: Vec<f64>, waves: Vec<Wave>) -> Law {
    let mut pieces = Pieces::starting_at(0.0);
    pieces.push(1.0, coef, waves);
    pieces.finish(false)
}

/// Constant acceleration, then constant deceleration of equal magnitude.
pub(super) fn parabolic() -> Law {
    let mut pieces = Pieces::starting_at(0.0);
    pieces.push(0.5, vec![0.0, 0.0, 0.5], Vec::new());
    pieces.push(1.0, vec![0.5, 1.0, 1.0], Vec::new());
    pieces.finish(false)
}

/// x − Σ cₙ sin 2πnx, the form of the laws of Gutman and Freudenstein.
pub(super) fn sine_series(terms: &[(f64, f64)]) -> Law {
    let waves: Vec<_> = terms.iter().map(|&(n, c)| (TAU * n, 0.0, -c)).collect();
    line_and_waves(0.0, 1.0, &waves)
}

/// Width below which a zone is omitted, because short spans have large rounding errors.
const SLIVER: f64 = 1e-9;

/// Acceleration in one zone of an SCCA law.
#[derive(Clone, Copy)]
enum Zone {
    /// Constant acceleration with the given value.
    Constant(f64),
    /// Sinusoidal acceleration cos·cos(rate·x) + sin·sin(rate·x), where x is measured from the start of the zone.
    Wave { rate: f64, cos: f64, sin: f64 },
}

/// SCCA law (Norton). Its acceleration consists of sine, constant and cosine parts with the fractions b + c + d = 1 of the length. The
/// quarter sine at either end has the length b/2, each constant part has the length c/2, and the half cosine in the middle has the length
/// d.
///
/// Special cases are the modified sine (b = ¼, c = 0), the modified trapezoid (b = d = ¼), cycloidal (b = d = ½), simple harmonic (d = 1) and
/// parabolic (c = 1).
pub(super) fn scca(b: f64, c: f64, d: f64) -> Result<Law> {
    let shares = [b, c, d];
    if shares.iter().any(|x| !x.is_finite() || *x < 0.0) || (b + c + d - 1.0).abs() > 1e-9 {
        return Err(LawError::SccaShares { b, c, d }.into());
    }
    let quarter = |rate: f64, cos: f64, sin: f64| Zone::Wave { rate, cos, sin };
    let zones = [
        (0.5 * b, quarter(PI / b, 0.0, 1.0)),
        (0.5 * c, Zone::Constant(1.0)),
        (d, quarter(PI / d, 1.0, 0.0)),
        (0.5 * c, Zone::Constant(-1.0)),
        (0.5 * b, quarter(PI / b, -1.0, 0.0)),
    ];
    // The acceleration is integrated from rest with unit peak. The resulting lift determines the scale.
    let mut pieces = Pieces::starting_at(0.0);
    let (mut s, mut v) = (0.0, 0.0);
    for (width, zone) in zones.into_iter().filter(|z| z.0 > SLIVER) {
        let end = pieces.reached() + width;
        match zone {
            Zone::Constant(a) => {
                let last = s + v * width + 0.5 * a * width * width;
                pieces.push(end, vec![s, s + 0.5 * v * width, last], Vec::new());
                s = last;
                v += a * width;
            }
            Zone::Wave { rate, cos, sin } => {
                // a = cos·C + sin·S is integrated to v + (cos·S + sin·(1 − C))/rate, and integrated once more to the lift.
                let square = rate * rate;
                let wave = Wave {
                    rate,
                    cos: -cos / square,
                    sin: -sin / square,
                };
                let constant = s + cos / square;
                let slope = v + sin / rate;
                pieces.push(end, vec![constant, constant + slope * width], vec![wave]);
                let (sn, cs) = libm::sincos(rate * width);
                s = constant + slope * width + wave.cos * cs + wave.sin * sn;
                v = slope + rate * (wave.sin * cs - wave.cos * sn);
            }
        }
    }
    let reached = s;
    // The last break may differ from 1 by rounding errors, so the shape is stretched to exactly 1.
    let mut whole = Pieces::starting_at(0.0);
    whole.push_shape(&pieces.finish(false), 1.0, 0.0, 1.0 / reached, false);
    Ok(whole.finish(false))
}

/// Half a turn of an eccentric disc under a roller, with ratio = (disc radius + roller radius) / eccentricity. The ratio is infinite for a flat face,
/// which moves in simple harmonic motion. For a roller, a polynomial approximates the square root √(ratio² − sin²) up to rounding errors.
pub(super) fn eccentric(ratio: f64) -> Result<Law> {
    if ratio.is_infinite() && ratio > 0.0 {
        return Ok(simple_harmonic());
    }
    if ratio.is_nan() || ratio <= 1.0 {
        return Err(LawError::EccentricRatio { ratio }.into());
    }
    let quarter: Vec<f64> = (0..=8).map(|i| f64::from(i) / 8.0).collect();
    let poly = stand_in(&quarter, 1e-15, |_, x| {
        let sin = libm::sin(PI * x);
        // √(ratio² − sin²) − ratio without the difference of large numbers.
        let root = (ratio * ratio - sin * sin).sqrt();
        0.5 * (1.0 - libm::cos(PI * x) - sin * sin / (root + ratio))
    });
    Ok(Law::from_poly(poly, false))
}

/// Simple harmonic motion ½(1 − cos πx).
pub(super) fn simple_harmonic() -> Law {
    line_and_waves(0.5, 0.0, &[(PI, -0.5, 0.0)])
}

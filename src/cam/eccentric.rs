//! Eccentric discs: the one cam that is turned on a lathe.

use super::{Cam, Follower};
use crate::error::{Error, Result};
use crate::law::Law;
use crate::poly::stand_in;
use std::f64::consts::TAU;

/// Eccentric disc under a flat face: d = r + e sin θ (Campillo de Blas 2017), simple harmonic motion. m.
///
/// Fails when the eccentricity is not smaller than the radius: the shaft would lie outside the disc.
pub fn eccentric_disc(disc_radius: f64, eccentricity: f64) -> Result<Cam> {
    check(disc_radius, eccentricity)?;
    let law = Law::harmonic(eccentricity, &[(0.0, eccentricity)]);
    let follower = Follower::FlatTranslating {
        base_radius: disc_radius - eccentricity,
    };
    Cam::new(law, follower)
}

/// Eccentric disc under a roller on a line through the shaft: the roller's centre stands
/// e sin θ + √(L² − e² cos² θ) from the shaft, L = disc radius + roller radius. m.
///
/// The root enters the law by a polynomial stand-in, exact to rounding.
pub fn eccentric_roller_law(
    disc_radius: f64,
    eccentricity: f64,
    roller_radius: f64,
) -> Result<Cam> {
    check(disc_radius, eccentricity)?;
    let (e, reach) = (eccentricity, disc_radius + roller_radius);
    let breaks: Vec<f64> = (0..=16).map(|i| TAU * f64::from(i) / 16.0).collect();
    let poly = stand_in(&breaks, 1e-14, |_, theta| {
        let (sin, cos) = theta.sin_cos();
        // √(L² − e²cos²) − L without the difference of large numbers.
        let square = e * e * cos * cos;
        e + e * sin - square / ((reach * reach - square).sqrt() + reach)
    });
    let follower = Follower::RollerTranslating {
        prime_radius: reach - e,
        offset: 0.0,
        roller_radius,
    };
    Cam::new(Law::from_poly(poly, true), follower)
}

fn check(disc_radius: f64, eccentricity: f64) -> Result<()> {
    if disc_radius.is_finite() && eccentricity > 0.0 && eccentricity < disc_radius {
        return Ok(());
    }
    Err(Error::new(format!(
        "a disc of radius {disc_radius} m with eccentricity {eccentricity} m does not hold its shaft"
    ))
    .help("the eccentricity must be more than 0 and less than the radius"))
}

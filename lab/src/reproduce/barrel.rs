//! Bautista Morelos (2018): the desmodromic barrel cam (theory §4).

use super::Value;
use gaitcam::cam::{BarrelGroove, Rollers, Wall};
use gaitcam::error::Result;
use gaitcam::law::{Extent, Rise, Segment, program};
use gaitcam::poly::bernstein;
use std::f64::consts::TAU;

const SPEED: f64 = TAU;
/// Radii of the groove's bottom and of the cylinder, m.
const FLOOR: f64 = 0.021;
const SURFACE: f64 = 0.030;

pub(super) fn values() -> Result<Vec<Value>> {
    let segments = [0.04, -0.04].map(|lift| Segment {
        motion: Rise::BerzakD,
        lift,
        angle: TAU,
    });
    let law = program(&segments, Extent::Turns(2))?;
    // The roller radius is 5 mm in the table and 5.25 mm in the text.
    let groove = BarrelGroove::new(law.clone(), FLOOR, SURFACE, Rollers::One { radius: 0.005 })?;
    let mut values = Vec::new();
    for degrees in [90.0, 180.0, 270.0] {
        let theta = f64::to_radians(degrees);
        let at = law.svaj(theta);
        values.extend([1e3 * at.s, 1e3 * at.v * SPEED, 1e3 * at.a * SPEED * SPEED]);
        values.extend([FLOOR, SURFACE].map(|r| groove.pressure_angle(theta, r).to_degrees()));
        // The curvature of the centre line is zero where the acceleration changes sign.
        if degrees != 180.0 {
            let wall = groove.rho_wall(theta, FLOOR, Wall::Lower).abs();
            let middle = groove.rho_pitch(theta, SURFACE).abs();
            values.extend([1e3 * wall, 1e3 * middle]);
        }
    }
    let rise = Rise::BerzakD.law()?;
    let jerk = rise.poly().derivative().derivative().derivative();
    let last = bernstein::to_power(jerk.piece(0)).last().copied();
    values.push(last.unwrap_or(f64::NAN));
    values.push(Rise::Cycloidal.factors()?.cj);
    let seven = Rise::Poly4567.factors()?;
    values.extend([seven.cv, seven.ca, seven.cj]);
    Ok(values.into_iter().map(Value::from).collect())
}

//! Bautista Morelos (2018): the desmodromic barrel cam (theory §4).

use super::{Class, Row, Rows};
use gaitcam::cam::{BarrelGroove, Rollers, Wall};
use gaitcam::error::Result;
use gaitcam::law::{Extent, Rise, Segment, program};
use gaitcam::poly::bernstein;
use std::f64::consts::TAU;

const SPEED: f64 = TAU;
/// Radii of the groove's floor and of the cylinder, m.
const FLOOR: f64 = 0.021;
const SURFACE: f64 = 0.030;

pub(super) fn rows() -> Result<Vec<Row>> {
    let mut rows = Rows::of("Bautista Morelos (2018), desmodromic barrel cam");
    let segments = [0.04, -0.04].map(|lift| Segment {
        motion: Rise::BerzakD,
        lift,
        angle: TAU,
    });
    let law = program(&segments, Extent::Turns(2))?;
    // The table's roller is 5 mm, the text's 5.25 mm.
    let groove = BarrelGroove::new(law.clone(), FLOOR, SURFACE, Rollers::One { radius: 0.005 })?;
    let table = [
        (
            90.0,
            "4.417",
            "43.294",
            "210.222",
            "18.166",
            "101.54",
            Wall::Lower,
        ),
        (
            180.0,
            "20.000",
            "72.373",
            "0.000",
            "28.745",
            "",
            Wall::Lower,
        ),
        (
            270.0,
            "35.583",
            "43.294",
            "-210.222",
            "18.166",
            "91.54002",
            Wall::Lower,
        ),
    ];
    for (degrees, s, v, a, phi, rho, wall) in table {
        let theta = f64::to_radians(degrees);
        let at = law.svaj(theta);
        let here = |what: &str| format!("{what} at {degrees}°");
        rows.stated(&here("lift"), "mm", s, 1e3 * at.s);
        rows.stated(&here("velocity"), "mm/s", v, 1e3 * at.v * SPEED);
        rows.add(
            &here("acceleration"),
            "mm/s²",
            a,
            1e3 * at.a * SPEED * SPEED,
            (Class::Rounding, "differences of rounded values"),
        );
        let angle = |radius: f64| groove.pressure_angle(theta, radius).to_degrees();
        let reason = "at 21 mm, the floor of the groove; the text says 30 mm";
        rows.stated(&here("pressure angle, R = 21 mm"), "°", phi, angle(FLOOR));
        rows.misprint(
            &here("pressure angle, R = 30 mm as the text says"),
            "°",
            phi,
            angle(SURFACE),
            reason,
        );
        if !rho.is_empty() {
            let value = groove.rho_wall(theta, FLOOR, wall).abs();
            rows.stated(
                &here("radius of the groove's wall, R = 21 mm, roller 5 mm"),
                "mm",
                rho,
                1e3 * value,
            );
            let text = groove.rho_pitch(theta, SURFACE).abs();
            rows.misprint(
                &here("radius of the middle line, R = 30 mm as the text says"),
                "mm",
                rho,
                1e3 * text,
                "the table is for 21 mm and a roller of 5 mm, the text says 30 mm and 5.25 mm",
            );
        }
    }
    let jerk = Rise::BerzakD
        .law()?
        .poly()
        .derivative()
        .derivative()
        .derivative();
    let last = bernstein::to_power(jerk.piece(0))
        .last()
        .copied()
        .unwrap_or(f64::NAN);
    rows.misprint(
        "Berzak D: factor of x⁴ in the jerk",
        "",
        "-882",
        last,
        "the sign: the third derivative of 4.2x⁷ is +882x⁴",
    );
    let cycloidal = Rise::Cycloidal.factors()?.cj;
    let printed = format!("{:.3}", 4.0 * std::f64::consts::PI.powi(4));
    rows.misprint(
        "cycloidal: jerk factor, printed 4π⁴",
        "",
        &printed,
        cycloidal,
        "it must be 4π²",
    );
    let seven = Rise::Poly4567.factors()?;
    let missing = "v, a, j are printed without 1/β, 1/β², 1/β³: right for β = 1 only";
    rows.silent("4-5-6-7: Cv", "", seven.cv, missing);
    rows.silent("4-5-6-7: Ca", "", seven.ca, missing);
    rows.silent("4-5-6-7: Cj", "", seven.cj, missing);
    Ok(rows.list)
}

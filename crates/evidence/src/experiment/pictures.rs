//! Curves for the pictures of reports/dynamics.md.

use super::{cams, scene, worst_force_error};
use gaitcam::cam::Cam;
use gaitcam::dynamics::{Model, Outcome, Row, simulate, thesis};
use gaitcam::error::Result;

/// One curve of a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Name in the legend.
    pub name: String,
    /// Points (abscissa, ordinate).
    pub points: Vec<(f64, f64)>,
}

/// One picture of the report.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// File name without extension.
    pub name: &'static str,
    /// Title.
    pub title: &'static str,
    /// What runs to the right, with its unit.
    pub x: &'static str,
    /// What runs upwards, with its unit.
    pub y: &'static str,
    /// Whether both axes are logarithmic.
    pub logarithmic: bool,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// The pictures that go with [`report`](super::report).
pub fn pictures() -> Result<Vec<Picture>> {
    let mut forces = Vec::new();
    let mut torques = Vec::new();
    let mut lifted = Vec::new();
    for (name, cam, fast) in cams() {
        for (machine, drive) in [
            ("real", thesis::real(thesis::SPEED)),
            ("ideal", thesis::ideal(thesis::SPEED)),
        ] {
            let out = simulate(&scene(&cam, drive), Model::Rigid)?;
            let name = format!("{name}, {machine}");
            torques.push(over_the_turn(name.clone(), &out, |r| r.torque));
            forces.push(over_the_turn(name, &out, |r| r.contact_force));
        }
        for e in [0.0, 0.5] {
            let out = bouncing(&cam, fast, e)?;
            let name = format!("{name}, {fast} rad/s, e = {e}");
            lifted.push(over_the_turn(name, &out, |r| 1e3 * r.gap));
        }
    }
    let errors = cams()
        .into_iter()
        .map(|(name, cam, _)| {
            let points = [90, 180, 360, 720, 1440, 2880]
                .into_iter()
                .map(|n| Ok((n as f64, worst_force_error(&cam, n, 20.0)?)))
                .collect::<Result<_>>()?;
            Ok(Curve {
                name: name.to_string(),
                points,
            })
        })
        .collect::<Result<_>>()?;
    let picture = |name, title, x, y, logarithmic, curves| Picture {
        name,
        title,
        x,
        y,
        logarithmic,
        curves,
    };
    Ok(vec![
        picture(
            "dynamics_force",
            "Contact force at 11.624 rad/s",
            "cam angle (degrees)",
            "force, N",
            false,
            forces,
        ),
        picture(
            "dynamics_torque",
            "Shaft torque at 11.624 rad/s",
            "cam angle (degrees)",
            "torque, N·m",
            false,
            torques,
        ),
        picture(
            "dynamics_gap",
            "Gap above the lift-off speed",
            "cam angle (degrees)",
            "gap, mm",
            false,
            lifted,
        ),
        picture(
            "dynamics_convergence",
            "Largest force error against points per turn, 20 rad/s",
            "points",
            "error (N)",
            true,
            errors,
        ),
    ])
}

fn over_the_turn(name: String, out: &Outcome, value: fn(&Row) -> f64) -> Curve {
    let points = out.rows.iter().map(|r| (r.theta.to_degrees(), value(r)));
    Curve {
        name,
        points: points.collect(),
    }
}

fn bouncing(cam: &Cam, speed: f64, e: f64) -> Result<Outcome> {
    let mut run = scene(cam, thesis::real(speed));
    run.machine.restitution = e;
    simulate(&run, Model::Contact)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_picture_has_curves_with_finite_points() {
        for picture in pictures().unwrap() {
            assert!(!picture.curves.is_empty());
            let points = picture.curves.iter().flat_map(|c| &c.points);
            assert!(points.clone().count() > 5);
            assert!(points.clone().all(|p| p.0.is_finite() && p.1.is_finite()));
        }
    }
}

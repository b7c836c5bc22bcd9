//! Pictures of reports/dynamics.md.

use super::peers::rapier;
use super::{cams, scene, worst_force_error};
use crate::chart::{self, Across, Chart, Row};
use gaitcam::dynamics::{self, Model, Outcome, simulate};
use gaitcam::error::Result;
use gaitcam_output::Picture;
use gaitcam_output::overlay::{Look, Strip, diagrams_with};
use gaitcam_test_support::thesis;

/// A curve with its name in the legend.
type Curve = (String, Vec<(f64, f64)>);

/// Every picture of [`report`](super::report) with its file name.
///
/// # Errors
///
/// As for the report.
pub fn pictures() -> Result<Vec<(&'static str, Picture)>> {
    let (mut forces, mut torques, mut gaps) = (Vec::new(), Vec::new(), Vec::new());
    for (name, cam, fast) in cams() {
        for (machine, drive) in [
            ("real", thesis::real(thesis::SPEED)),
            ("ideal", thesis::ideal(thesis::SPEED)),
        ] {
            let out = simulate(&scene(&cam, drive), Model::Rigid)?;
            let name = format!("{name}, {machine}");
            torques.push((name.clone(), over_the_turn(&out, |r| r.torque)));
            forces.push((name, over_the_turn(&out, |r| r.contact_force)));
        }
        for e in [0.0, 0.5] {
            let mut run = scene(&cam, thesis::real(fast));
            run.machine.restitution = e;
            let out = simulate(&run, Model::Contact)?;
            let name = format!("{name}, {fast} rad/s, e = {e}");
            gaps.push((name, over_the_turn(&out, |r| 1e3 * r.gap)));
        }
    }
    let force = diagram("Contact force at 11.624 rad/s", "force, N", forces, &[]);
    let torque = diagram("Shaft torque at 11.624 rad/s", "torque, N·m", torques, &[]);
    // Up to the first landing, the gaps for both values of e are equal.
    let looks = [Look::Wide, Look::Line, Look::Wide, Look::Line];
    let gap = diagram("Gap above the lift-off speed", "gap, mm", gaps, &looks);
    Ok(vec![
        ("dynamics_force", force),
        ("dynamics_torque", torque),
        ("dynamics_gap", gap),
        ("dynamics_convergence", convergence()?),
        ("dynamics_rapier", against_time()),
    ])
}

fn over_the_turn(out: &Outcome, value: fn(&dynamics::Row) -> f64) -> Vec<(f64, f64)> {
    let points = out.rows.iter().map(|r| (r.theta.to_degrees(), value(r)));
    points.collect()
}

fn diagram(title: &str, quantity: &str, curves: Vec<Curve>, looks: &[Look]) -> Picture {
    let (names, curves): (Vec<String>, Vec<_>) = curves.into_iter().unzip();
    let quantity = quantity.to_string();
    diagrams_with(looks, title, "", &names, &[Strip { quantity, curves }])
}

/// Picture of the force error of the emitted points against their number.
fn convergence() -> Result<Picture> {
    let mut rows = Vec::new();
    for (name, cam, _) in cams() {
        for n in [90, 180, 360, 720, 1440, 2880] {
            rows.push(Row {
                method: name.to_string(),
                error: worst_force_error(&cam, n, 20.0)?,
                points: Some(n),
                ..Row::default()
            });
        }
    }
    Ok(chart::picture(&Chart {
        title: "Maximum force error and points per turn, 20 rad/s".to_string(),
        error: "error (N)".to_string(),
        across: Across::Points,
        rows,
        ..Chart::default()
    }))
}

/// Picture of the height error of events and time steps against the wall time of a turn.
fn against_time() -> Picture {
    let row = |p: super::peers::Peer| Row {
        method: p.method,
        size: p.size,
        error: p.rms,
        seconds: p.seconds,
        quartiles: (p.seconds, p.seconds),
        ..Row::default()
    };
    chart::picture(&Chart {
        title: "Eccentric at 35 rad/s: height error of one turn".to_string(),
        error: "RMS error of the height, m".to_string(),
        rows: rapier().into_iter().map(row).collect(),
        ..Chart::default()
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_picture_the_report_names_is_drawn() {
        let text = crate::experiment::report().unwrap();
        let pictures = super::pictures().unwrap();
        for (name, picture) in &pictures {
            assert!(text.contains(&format!("({name}.png)")), "{name}");
            assert!(!picture.svg().contains("NaN"), "{name}");
        }
        assert_eq!(text.matches(".png)").count(), pictures.len());
    }
}

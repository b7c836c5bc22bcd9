//! The thesis's experiment run again: ideal and real machine, lift-off, bounces, and what spoiled its
//! simulation. The text of reports/dynamics.md; everything in it is computed here.

use super::contact::{self, ContactRun, Limits, Phase};
use super::flexible::{self, Train};
use super::impact::{Restitution, exact_chi, returned_restitution};
use super::profile_curve::{recover, recover_outline};
use super::simulate::{Machine, Run, simulate};
use super::surface::Surface;
use super::{Model, motor, rigid, thesis};
use crate::cam::Cam;
use crate::drive::Drive;
use crate::error::Result;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

/// Rows of an emitted profile in this report.
const POINTS: usize = 1440;

/// The text of reports/dynamics.md. Fails only if one of the thesis's cams could not be run.
pub fn report() -> Result<String> {
    let mut out = String::from(
        "# The thesis's experiment, run again\n\n\
         Two cams (an eccentric of 30 mm about a centre 10 mm off; a double harmonic of 10 mm in 135°, back in 135°, dwell 90°), \
         a mass of 1 kg, 111 rpm (11.624 rad/s). Every number below comes from the emitted profile points, not from the law; \
         the law serves as the independent answer.\n\n",
    );
    steady_running(&mut out)?;
    convergence(&mut out)?;
    hand_drawn(&mut out)?;
    lift_off(&mut out)?;
    bounces(&mut out)?;
    restitution(&mut out);
    vibration(&mut out)?;
    two_cams(&mut out)?;
    motors(&mut out)?;
    Ok(out)
}

pub(super) fn cams() -> [(&'static str, Cam, f64); 2] {
    [
        ("eccentric", thesis::eccentric(), 35.0),
        ("double harmonic", thesis::double_harmonic(), 27.0),
    ]
}

pub(super) fn scene(cam: &Cam, drive: Drive) -> Run {
    Run {
        cam: cam.clone(),
        drive,
        profile: cam.profile(POINTS),
        target: None,
        machine: Machine::default(),
    }
}

fn run_points(cam: &Cam, n: usize, speed: f64, e: f64) -> Result<ContactRun> {
    let drive = thesis::real(speed);
    let law = recover(&cam.follower, &cam.profile(n), 0.0)?.law;
    Ok(contact::run(
        &[Surface::new(law, &drive)],
        &drive,
        &Restitution::Prescribed(e),
        &Limits::default(),
    ))
}

/// Largest difference of force, N, between the emitted points and the law, over a grid that is no
/// multiple of the points.
pub(super) fn worst_force_error(cam: &Cam, n: usize, speed: f64) -> Result<f64> {
    let drive = thesis::real(speed);
    let law = recover(&cam.follower, &cam.profile(n), 0.0)?.law;
    let angles = (0..7201).map(|i| TAU * f64::from(i) / 7201.0);
    Ok(angles
        .map(|t| (drive.force(law.svaj(t)) - drive.force(cam.law.svaj(t))).abs())
        .fold(0.0, f64::max))
}

/// Appends one line; writing to a String cannot fail.
fn line(out: &mut String, text: &str) {
    let _ = writeln!(out, "{text}");
}

fn steady_running(out: &mut String) -> Result<()> {
    line(out, "## Steady running at 11.624 rad/s\n");
    line(
        out,
        "| cam | machine | smallest force N | largest N | largest error against the law N | torque N·m | RMS N·m |",
    );
    line(out, "|---|---|---|---|---|---|---|");
    for (name, cam, _) in cams() {
        for (machine, drive) in [
            ("real (axis moves)", thesis::real(thesis::SPEED)),
            (
                "ideal (axis fixed, no spring)",
                thesis::ideal(thesis::SPEED),
            ),
        ] {
            let rigid = simulate(&scene(&cam, drive), Model::Rigid)?;
            let error = rigid
                .rows
                .iter()
                .map(|r| (r.contact_force - drive.force(cam.law.svaj(r.theta))).abs())
                .fold(0.0, f64::max);
            line(
                out,
                &format!(
                    "| {name} | {machine} | {:.5} | {:.5} | {error:.1e} | {:+.5} … {:+.5} | {:.5} |",
                    rigid.force.min,
                    rigid.force.max,
                    rigid.torque.min,
                    rigid.torque.max,
                    rigid.torque.rms
                ),
            );
        }
    }
    line(out, "");
    for (name, cam, _) in cams() {
        let run = scene(&cam, thesis::real(thesis::SPEED));
        let (rigid, contact) = (
            simulate(&run, Model::Rigid)?,
            simulate(&run, Model::Contact)?,
        );
        let difference = rigid
            .rows
            .iter()
            .zip(&contact.rows)
            .map(|(a, b)| (a.contact_force - b.contact_force).abs())
            .fold(0.0, f64::max);
        let preload = rigid::least_preload(&cam.law, &thesis::ideal(thesis::SPEED), 0.0);
        line(
            out,
            &format!(
                "- {name}: rigid and contact model of the real machine differ by at most {difference:.1e} N. The ideal machine pulls where its force is negative: it needs a preload of {preload:.4} N to stay on the cam."
            ),
        );
    }
    line(out, "");
    Ok(())
}

fn convergence(out: &mut String) -> Result<()> {
    line(out, "## Points per turn\n");
    line(
        out,
        "Largest force error at 20 rad/s between the points, and the order from one row to the next.\n",
    );
    line(
        out,
        "| points | eccentric N | order | double harmonic N | order |",
    );
    line(out, "|---|---|---|---|---|");
    let mut before: Option<[f64; 2]> = None;
    for n in [360, 720, 1440, 2880, 5760] {
        let now = [
            worst_force_error(&thesis::eccentric(), n, 20.0)?,
            worst_force_error(&thesis::double_harmonic(), n, 20.0)?,
        ];
        let order =
            |k: usize| before.map_or("".to_string(), |b| format!("{:.2}", (b[k] / now[k]).log2()));
        line(
            out,
            &format!(
                "| {n} | {:.2e} | {} | {:.2e} | {} |",
                now[0],
                order(0),
                now[1],
                order(1)
            ),
        );
        before = Some(now);
    }
    line(
        out,
        "\nBeyond about 1000 points rounding of the coordinates, not interpolation, sets the error.\n",
    );
    Ok(())
}

fn hand_drawn(out: &mut String) -> Result<()> {
    line(out, "## A contour drawn by hand\n");
    line(
        out,
        "Forty points of the double harmonic rounded to 0.1 mm, as a mouse would place them.\n",
    );
    let cam = thesis::double_harmonic();
    let outline: Vec<[f64; 2]> = cam
        .profile(40)
        .iter()
        .map(|p| [(p.x * 1e4).round() / 1e4, (p.y * 1e4).round() / 1e4])
        .collect();
    let drive = thesis::real(thesis::SPEED);
    line(out, "| smoothing tolerance mm | answer |");
    line(out, "|---|---|");
    for tolerance in [1e-6, 1e-4, 2e-4, 4e-4] {
        let answer = match recover_outline(&outline, thesis::BASE_RADIUS, tolerance) {
            Err(error) => format!("refused: {error}"),
            Ok(smooth) => {
                let errors = (0..360).map(|i| {
                    let t = f64::from(i).to_radians();
                    (drive.force(smooth.law.svaj(t)) - drive.force(cam.law.svaj(t))).powi(2)
                });
                let rms = (errors.sum::<f64>() / 360.0).sqrt();
                format!(
                    "{} harmonics kept, force within {rms:.3} N RMS of the law",
                    smooth.harmonics.unwrap_or(0)
                )
            }
        };
        line(out, &format!("| {} | {answer} |", 1e3 * tolerance));
    }
    let hop = (crate::units::G / (thesis::BASE_RADIUS + thesis::LIFT)).sqrt();
    line(
        out,
        &format!(
            "\nUnsmoothed, a polyline rocks from facet to facet: on a corner at height d the force is M(g − ω²d) and every facet of length L strikes with MωL. It hops above √(g/d) = {hop:.2} rad/s however fine it is; this is where the spikes of the thesis's figures 67 and 70 come from.\n"
        ),
    );
    Ok(())
}

fn lift_off(out: &mut String) -> Result<()> {
    line(out, "## Lift-off\n");
    line(
        out,
        "| cam | emitted points rad/s | law rad/s | relative difference | lost at 1 − 1e-9 | lost at 1 + 1e-9 |",
    );
    line(out, "|---|---|---|---|---|---|");
    for (name, cam, _) in cams() {
        let drive = thesis::real(thesis::SPEED);
        let emitted = recover(&cam.follower, &cam.profile(POINTS), 0.0)?.law;
        let (Some(own), Some(law)) = (
            rigid::liftoff_speed(&emitted, &drive),
            rigid::liftoff_speed(&cam.law, &drive),
        ) else {
            continue;
        };
        let lost =
            |factor: f64| run_points(&cam, POINTS, own * factor, 0.0).map(|r| r.lost_fraction());
        line(
            out,
            &format!(
                "| {name} | {own:.6} | {law:.6} | {:.1e} | {:.1e} | {:.1e} |",
                (own / law - 1.0).abs(),
                lost(1.0 - 1e-9)?,
                lost(1.0 + 1e-9)?
            ),
        );
    }
    line(out, "\nThe eccentric's closed form is √(g/e).\n");
    Ok(())
}

fn bounces(out: &mut String) -> Result<()> {
    line(out, "## Above lift-off\n");
    line(
        out,
        "| cam | speed rad/s | e | leaves ° | lands ° | flight s | landing m/s | largest gap mm | lost % |",
    );
    line(out, "|---|---|---|---|---|---|---|---|---|");
    for (name, cam, speed) in cams() {
        for e in [0.0, 0.5] {
            let run = run_points(&cam, POINTS, speed, e)?;
            if let Some(hit) = run.impacts.first() {
                line(
                    out,
                    &format!(
                        "| {name} | {speed} | {e} | {:.6} | {:.6} | {:.9} | {:.7} | {:.6} | {:.4} |",
                        hit.since.to_degrees(),
                        hit.at.to_degrees(),
                        (hit.at - hit.since) / speed,
                        hit.speed,
                        1e3 * hit.height,
                        100.0 * run.lost_fraction()
                    ),
                );
            }
        }
    }
    line(out, "");
    for (name, cam, speed) in cams() {
        let run = run_points(&cam, POINTS, speed, 0.5)?;
        let landings: Vec<String> = run
            .impacts
            .iter()
            .take(5)
            .map(|i| format!("{:.6}°", i.at.to_degrees()))
            .collect();
        let rest = run
            .stretches
            .windows(2)
            .find_map(|w| match (w[0].phase, w[1].phase) {
                (Phase::Flight(_), Phase::Contact { .. }) => Some(w[1].from.to_degrees()),
                _ => None,
            });
        line(
            out,
            &format!(
                "- {name}, e = 0.5: lands at {} …, rests at {:.3}°; {} landings, then the same again every turn.",
                landings.join(", "),
                rest.unwrap_or(f64::NAN),
                run.impacts.len()
            ),
        );
    }
    line(out, "");
    Ok(())
}

fn restitution(out: &mut String) {
    line(out, "## Restitution of a compliant contact\n");
    line(
        out,
        "f = Kδⁿ(1 + χ δ̇/v₀), K = 1e10 N/m^1.5, n = 1.5, 1 kg at 0.2 m/s.\n",
    );
    line(
        out,
        "| e asked | Hunt–Crossley 3(1 − e)/2 | Lankarani–Nikravesh 3(1 − e²)/4 | Flores 8(1 − e)/(5e) | exact χ | integrated with exact χ |",
    );
    line(out, "|---|---|---|---|---|---|");
    for e in [0.1, 0.3, 0.5, 0.7, 0.9] {
        let contact = Restitution::Compliant {
            stiffness: 1e10,
            exponent: 1.5,
            restitution: e,
        };
        let back = contact.pulse(1.0, 0.2, 0.0).rebound / 0.2;
        line(
            out,
            &format!(
                "| {e} | {:.3} | {:.3} | {:.3} | {:.6} | {back:.8} |",
                returned_restitution(1.5 * (1.0 - e)),
                returned_restitution(0.75 * (1.0 - e * e)),
                returned_restitution(1.6 * (1.0 - e) / e),
                exact_chi(e)
            ),
        );
    }
    line(out, "");
}

fn vibration(out: &mut String) -> Result<()> {
    line(out, "## A follower that gives\n");
    line(
        out,
        "Real machine, double harmonic, 11.624 rad/s, damping ratio 0.05: how far vibration moves the force.\n",
    );
    line(
        out,
        "| natural frequency Hz | RMS % of M g | smallest force N | largest force N |",
    );
    line(out, "|---|---|---|---|");
    let cam = thesis::double_harmonic();
    let drive = thesis::real(thesis::SPEED);
    let law = recover(&cam.follower, &cam.profile(POINTS), 0.0)?.law;
    for hertz in [10.0, 20.0, 30.0, 50.0, 100.0] {
        let steady = flexible::steady(&law, &drive, &Train::from_frequency(&drive, hertz, 0.05)?)?;
        let sum: f64 = steady
            .theta
            .iter()
            .zip(&steady.contact)
            .map(|(t, f)| (f - drive.force(law.svaj(*t))).powi(2))
            .sum();
        let rms = (sum / steady.theta.len() as f64).sqrt() / drive.rest_force;
        let (low, high) = steady.contact_extremes();
        line(
            out,
            &format!(
                "| {hertz} | {:.3} | {:.4} | {:.4} |",
                100.0 * rms,
                low.value,
                high.value
            ),
        );
    }
    line(out, "");
    Ok(())
}

fn two_cams(out: &mut String) -> Result<()> {
    line(out, "## Two cams on the shaft, half a turn apart\n");
    let mut run = scene(&thesis::double_harmonic(), thesis::real(thesis::SPEED));
    run.machine.second_cam = Some(PI);
    let both = simulate(&run, Model::Contact)?;
    let hits: Vec<String> = both
        .impacts
        .iter()
        .take(2)
        .map(|i| format!("{:.3}° at {:.4} m/s", i.at.to_degrees(), i.speed))
        .collect();
    line(
        out,
        &format!(
            "The block rides on whichever cam stands higher. Where one falls and the other rises they meet with a step of slope, a blow: {}. Between the blows the force is {:.4} … {:.4} N.\n",
            hits.join(", "),
            both.force.min,
            both.force.max
        ),
    );
    Ok(())
}

fn motors(out: &mut String) -> Result<()> {
    line(out, "## The motor\n");
    let (c, p) = motor::power_law(&thesis::MOTOR_TABLE)?;
    let power = motor::power_for(&thesis::MOTOR_TABLE, 6.0)?;
    line(
        out,
        &format!(
            "Least squares on the logarithms of the thesis's table: t = {c:.1}·x^{p:.4}, so 6 s for 11.1 turns takes {power:.1} % (the thesis: 347.9·x^−0.967, 66.6 %)."
        ),
    );
    for (name, cam, _) in cams() {
        let drive = thesis::real(thesis::SPEED);
        if let Some(torque) = rigid::torque_curve(&cam.law, &drive, 0.1, thesis::BASE_RADIUS) {
            let demand = motor::demand(&torque, drive.speed);
            line(
                out,
                &format!(
                    "- {name}, μ = 0.1: mean {:.5} N·m, RMS {:.5}, peak {:.5}, mean power {:.4} W.",
                    demand.mean, demand.rms, demand.peak, demand.power
                ),
            );
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_report_states_the_lift_off_speeds_and_landings() {
        let text = report().unwrap();
        for number in [
            "31.320920",
            "23.490690",
            "53.208127",
            "204.980906",
            "0.075683849",
            "198.033742",
            "1.432751",
            "68.4 %",
        ] {
            assert!(text.contains(number), "{number}\n{text}");
        }
        assert!(!text.contains("NaN"));
    }
}

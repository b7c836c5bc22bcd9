//! Steady running: force and torque, the points' error, and a contour drawn by hand.

use super::outline::recover_outline;
use super::{Page, cams, scene, worst_force_error};
use crate::thesis;
use gaitcam::dynamics::simulate;
use gaitcam::dynamics::{Model, rigid};
use gaitcam::error::Result;

pub(super) fn steady_running(out: &mut Page) -> Result<()> {
    out.line("## Steady running at 11.624 rad/s\n");
    out.table("cam | machine | smallest force N | largest N | largest error against the law N | torque N·m | RMS N·m");
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
            out.line(format_args!(
                "| {name} | {machine} | {:.5} | {:.5} | {error:.1e} | {:+.5} … {:+.5} | {:.5} |",
                rigid.force.min,
                rigid.force.max,
                rigid.torque.min,
                rigid.torque.max,
                rigid.torque.rms
            ));
        }
    }
    out.line("");
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
        out.line(format_args!(
                "- {name}: rigid and contact model of the real machine differ by at most {difference:.1e} N. The ideal machine pulls where its force is negative: it needs a preload of {preload:.4} N to stay on the cam."));
    }
    out.line("");
    out.picture(
        "dynamics_force",
        "Contact force of both cams in both machines over the cam angle",
    );
    out.picture(
        "dynamics_torque",
        "Shaft torque of both cams in both machines over the cam angle",
    );
    Ok(())
}

pub(super) fn convergence(out: &mut Page) -> Result<()> {
    out.line("## Points per turn\n");
    out.line("Largest force error at 20 rad/s between the points, and the order from one row to the next.\n");
    out.table("points | eccentric N | order | double harmonic N | order");
    let mut before: Option<[f64; 2]> = None;
    for n in [360, 720, 1440, 2880, 5760] {
        let now = [
            worst_force_error(&thesis::eccentric(), n, 20.0)?,
            worst_force_error(&thesis::double_harmonic(), n, 20.0)?,
        ];
        let order =
            |k: usize| before.map_or("".to_string(), |b| format!("{:.2}", (b[k] / now[k]).log2()));
        out.line(format_args!(
            "| {n} | {:.2e} | {} | {:.2e} | {} |",
            now[0],
            order(0),
            now[1],
            order(1)
        ));
        before = Some(now);
    }
    out.line("\n![Largest force error against points per turn](dynamics_convergence.png)\n\nBeyond about 1000 points rounding of the coordinates, not interpolation, sets the error.\n");
    Ok(())
}

pub(super) fn hand_drawn(out: &mut Page) -> Result<()> {
    out.line("## A contour drawn by hand\n");
    out.line(
        "Forty points of the double harmonic rounded to 0.1 mm, as a mouse would place them.\n",
    );
    let cam = thesis::double_harmonic();
    let outline: Vec<[f64; 2]> = cam
        .profile(40)
        .iter()
        .map(|p| [(p.x * 1e4).round() / 1e4, (p.y * 1e4).round() / 1e4])
        .collect();
    let drive = thesis::real(thesis::SPEED);
    out.table("smoothing tolerance mm | answer");
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
                    smooth.harmonics
                )
            }
        };
        out.line(format_args!("| {} | {answer} |", 1e3 * tolerance));
    }
    let hop = (gaitcam::units::G / (thesis::BASE_RADIUS + thesis::LIFT)).sqrt();
    out.line(format_args!(
            "\nUnsmoothed, a polyline rocks from facet to facet: on a corner at height d the force is M(g − ω²d) and every facet of length L strikes with MωL. It hops above √(g/d) = {hop:.2} rad/s however fine it is; this is where the spikes of the thesis's figures 67 and 70 come from.\n"));
    Ok(())
}

//! Steady operation: force, torque, and error of the emitted points.

use super::{Page, cams, scene, worst_force_error};
use gaitcam::dynamics::simulate;
use gaitcam::dynamics::{Model, least_preload};
use gaitcam::error::Result;
use gaitcam_test_support::thesis;

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
        let preload = least_preload(&cam.law, &thesis::ideal(thesis::SPEED), 0.0);
        out.line(format_args!(
                "- {name}: rigid and contact model of the real machine differ by at most {difference:.1e} N. The ideal machine pulls where its force is negative. To keep contact, it would need a preload of {preload:.4} N."));
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
    out.line("The table gives the maximum force error at 20 rad/s between the points, and the order of convergence from row to row.\n");
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
    out.line("\n![Maximum force error and points per turn](dynamics_convergence.png)\n\nAbove about 1000 points, the error is caused by rounding of the coordinates, not by interpolation.\n");
    Ok(())
}

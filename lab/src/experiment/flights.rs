//! Lift-off, flights and landings.

use super::{POINTS, Page, cams, run_points, scene};
use gaitcam::dynamics::contact::Phase;
use gaitcam::dynamics::recover;
use gaitcam::dynamics::simulate;
use gaitcam::dynamics::{Model, liftoff_speed};
use gaitcam::error::Result;
use gaitcam_test_support::thesis;
use std::f64::consts::PI;

pub(super) fn lift_off(out: &mut Page) -> Result<()> {
    out.line("## Lift-off\n");
    out.table("cam | emitted points rad/s | law rad/s | relative difference | lost at 1 − 1e-9 | lost at 1 + 1e-9");
    for (name, cam, _) in cams() {
        let drive = thesis::real(thesis::SPEED);
        let emitted = recover(&cam.follower, &cam.profile(POINTS))?.law;
        let (Some(own), Some(law)) = (
            liftoff_speed(&emitted, &drive),
            liftoff_speed(&cam.law, &drive),
        ) else {
            continue;
        };
        let lost =
            |factor: f64| run_points(&cam, POINTS, own * factor, 0.0).map(|r| r.lost_fraction());
        out.line(format_args!(
            "| {name} | {own:.6} | {law:.6} | {:.1e} | {:.1e} | {:.1e} |",
            (own / law - 1.0).abs(),
            lost(1.0 - 1e-9)?,
            lost(1.0 + 1e-9)?
        ));
    }
    out.line("\nThe closed form for the eccentric is √(g/e).\n");
    Ok(())
}

pub(super) fn bounces(out: &mut Page) -> Result<()> {
    out.line("## Above lift-off\n");
    out.table("cam | speed rad/s | e | leaves ° | lands ° | flight s | landing m/s | largest gap mm | lost %");
    for (name, cam, speed) in cams() {
        for e in [0.0, 0.5] {
            let run = run_points(&cam, POINTS, speed, e)?;
            if let Some(hit) = run.impacts.first() {
                out.line(format_args!(
                    "| {name} | {speed} | {e} | {:.6} | {:.6} | {:.9} | {:.7} | {:.6} | {:.4} |",
                    hit.since.to_degrees(),
                    hit.at.to_degrees(),
                    (hit.at - hit.since) / speed,
                    hit.speed,
                    1e3 * hit.height,
                    100.0 * run.lost_fraction()
                ));
            }
        }
    }
    out.line("");
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
        out.line(format_args!(
            "- {name}, e = 0.5: lands at {} …, rests at {:.3}°; {} landings in every turn.",
            landings.join(", "),
            rest.unwrap_or(f64::NAN),
            run.impacts.len()
        ));
    }
    out.line("");
    out.picture(
        "dynamics_gap",
        "Gap between plate and cam above lift-off, plastic and bouncing",
    );
    Ok(())
}

pub(super) fn two_cams(out: &mut Page) -> Result<()> {
    out.line("## Two cams on the shaft, half a turn apart\n");
    let mut run = scene(&thesis::double_harmonic(), thesis::real(thesis::SPEED));
    run.machine.second_cam = Some(PI);
    let both = simulate(&run, Model::Contact)?;
    let hits: Vec<String> = both
        .impacts
        .iter()
        .take(2)
        .map(|i| format!("{:.3}° at {:.4} m/s", i.at.to_degrees(), i.speed))
        .collect();
    out.line(format_args!(
            "The block rests on the higher cam. Where one cam falls and the other rises, the slope jumps and an impact occurs: {}. Between the impacts the force is {:.4} … {:.4} N.\n",
            hits.join(", "),
            both.force.min,
            both.force.max));
    Ok(())
}

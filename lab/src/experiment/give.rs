//! Compliant follower, and the motor.

use super::{POINTS, Page, cams, motor};
use gaitcam::dynamics::flexible::{self, Train};
use gaitcam::dynamics::recover;
use gaitcam::dynamics::torque_curve;
use gaitcam::error::Result;
use gaitcam_test_support::thesis;

pub(super) fn vibration(out: &mut Page) -> Result<()> {
    out.line("## Compliant follower\n");
    out.line("The table gives the change of force by vibration (real machine, double harmonic, 11.624 rad/s, damping ratio 0.05).\n");
    out.table("natural frequency Hz | RMS % of M g | smallest force N | largest force N");
    let cam = thesis::double_harmonic();
    let drive = thesis::real(thesis::SPEED);
    let law = recover(&cam.follower, &cam.profile(POINTS))?.law;
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
        out.line(format_args!(
            "| {hertz} | {:.3} | {:.4} | {:.4} |",
            100.0 * rms,
            low.value,
            high.value
        ));
    }
    out.line("");
    Ok(())
}

pub(super) fn motors(out: &mut Page) -> Result<()> {
    out.line("## The motor\n");
    let (c, p) = motor::power_law(&motor::MOTOR_TABLE)?;
    let power = motor::power_for(&motor::MOTOR_TABLE, 6.0)?;
    out.line(format_args!(
            "A least-squares fit to the logarithms of the table in Campillo de Blas (2017) gives t = {c:.1}·x^{p:.4}, so 11.1 turns in 6 s require {power:.1} % of the power (thesis: 347.9·x^−0.967, 66.6 %)."));
    for (name, cam, _) in cams() {
        let drive = thesis::real(thesis::SPEED);
        if let Some(torque) = torque_curve(&cam.law, &drive, 0.1, thesis::BASE_RADIUS) {
            let demand = motor::demand(&torque, drive.speed);
            out.line(format_args!(
                "- {name}, μ = 0.1: mean {:.5} N·m, RMS {:.5}, peak {:.5}, mean power {:.4} W.",
                demand.mean, demand.rms, demand.peak, demand.power
            ));
        }
    }
    Ok(())
}

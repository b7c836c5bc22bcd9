//! Campillo de Blas (2017): eccentric and double-harmonic cams, motor table (theory §3).

use super::{Class, Row, Rows};
use crate::experiment::motor;
use crate::thesis;
use gaitcam::error::Result;

pub(super) fn rows() -> Result<Vec<Row>> {
    let mut rows = Rows::of("Campillo de Blas (2017), walking simulator");
    let drive = thesis::real(thesis::SPEED);
    let eccentric = thesis::eccentric();
    let reach = |cam: &gaitcam::cam::Cam| cam.law.extremes(0).1.value + thesis::BASE_RADIUS;
    rows.stated(
        "eccentric: largest sliding speed",
        "m/s",
        "0.465",
        reach(&eccentric) * thesis::SPEED,
    );
    let (low, high) = drive.force_curve(&eccentric.law).extremes();
    rows.stated("eccentric: smallest force", "N", "8.4588", low.value);
    rows.stated("eccentric: largest force", "N", "11.1612", high.value);
    // The force reaches zero when the steepest downward acceleration reaches g.
    let lift_off = |cam: &gaitcam::cam::Cam| {
        (drive.rest_force / drive.mass / -cam.law.extremes(2).0.value).sqrt()
    };
    rows.stated(
        "eccentric: speed of lift-off",
        "rad/s",
        "31.32",
        lift_off(&eccentric),
    );
    let double = thesis::double_harmonic();
    let (low, high) = double.law.extremes(2);
    let square = thesis::SPEED * thesis::SPEED;
    rows.stated(
        "double harmonic: largest acceleration",
        "m/s²",
        "1.35117",
        high.value * square,
    );
    rows.stated(
        "double harmonic: smallest acceleration",
        "m/s²",
        "-2.40209",
        low.value * square,
    );
    let (low, high) = drive.force_curve(&double.law).extremes();
    rows.stated("double harmonic: smallest force", "N", "7.40791", low.value);
    rows.stated(
        "double harmonic: largest force",
        "N",
        "11.16117",
        high.value,
    );
    rows.silent(
        "double harmonic: speed of lift-off",
        "rad/s",
        lift_off(&double),
        "",
    );
    let rho = double.curvature().convex;
    rows.misprint(
        "smallest radius of curvature, at 135°",
        "m",
        "0.02408",
        rho.value,
        "Rb + s + a at the thesis's own parameters gives the recomputed value",
    );
    let (low, high) = double.law.extremes(1);
    let own = "3√3πh/(8β) at the thesis's own h and β gives the recomputed value";
    rows.misprint("largest d′", "m", "0.0081728", high.value, own);
    rows.misprint("smallest d′", "m", "-0.0081728", low.value, own);
    let width = double.face_width().unwrap_or(f64::NAN);
    rows.misprint(
        "face width",
        "cm",
        "1.63456",
        100.0 * width,
        "follows from d′",
    );
    rows.stated(
        "double harmonic: largest sliding speed",
        "m/s",
        "0.465",
        reach(&double) * thesis::SPEED,
    );
    motor_rows(&mut rows)?;
    Ok(rows.list)
}

/// The table of motor power against the time for 11.1 turns, with the fit of Campillo de Blas (2017) and the better one.
fn motor_rows(rows: &mut Rows) -> Result<()> {
    let (factor, power) = motor::power_law(&motor::MOTOR_TABLE)?;
    let seconds_asked = 6.0;
    let fit = (
        Class::NotReproducible,
        "least squares on the logarithms of the table as printed gives the other value",
    );
    rows.add("motor: factor of t = c·xᵖ", "s", "347.9", factor, fit);
    rows.add("motor: exponent of t = c·xᵖ", "", "-0.967", power, fit);
    rows.add(
        "motor: power for 6 s",
        "%",
        "66.6",
        motor::power_for(&motor::MOTOR_TABLE, seconds_asked)?,
        fit,
    );
    let own = (seconds_asked / 347.9_f64).powf(1.0 / -0.967);
    rows.stated(
        "motor: power for 6 s by the thesis's own fit",
        "%",
        "66.6",
        own,
    );
    rows.silent(
        "motor: time for 11.1 turns at 11.624 rad/s",
        "s",
        motor::seconds_for(thesis::SPEED),
        "",
    );
    for (percent, seconds) in motor::MOTOR_TABLE {
        let by_fit = factor * percent.powf(power);
        let theirs = 347.9 * percent.powf(-0.967);
        let reason =
            format!("the thesis's fit gives {theirs:.2} s, least squares the recomputed value");
        rows.add(
            &format!("motor: time at {percent} %"),
            "s",
            &format!("{seconds}"),
            by_fit,
            (Class::Measured, &reason),
        );
    }
    Ok(())
}

//! Campillo de Blas (2017): eccentric and double-harmonic cams, motor table (theory §3).

use super::Value;
use crate::experiment::{motor, ripple};
use gaitcam::cam::Cam;
use gaitcam::error::Result;
use gaitcam_test_support::thesis;

pub(super) fn values() -> Result<Vec<Value>> {
    let drive = thesis::real(thesis::SPEED);
    let eccentric = thesis::eccentric();
    let double = thesis::double_harmonic();
    let sliding = |cam: &Cam| (cam.law.extremes(0).1.value + thesis::BASE_RADIUS) * thesis::SPEED;
    let forces = |cam: &Cam| drive.force_curve(&cam.law).extremes();
    // The force reaches zero when the steepest downward acceleration reaches g.
    let lift_off =
        |cam: &Cam| (drive.rest_force / drive.mass / -cam.law.extremes(2).0.value).sqrt();
    let square = thesis::SPEED * thesis::SPEED;
    let (low, high) = forces(&eccentric);
    let mut values = vec![
        sliding(&eccentric),
        low.value,
        high.value,
        lift_off(&eccentric),
    ];
    let (low, high) = double.law.extremes(2);
    values.extend([high.value * square, low.value * square]);
    let (low, high) = forces(&double);
    values.extend([low.value, high.value, lift_off(&double)]);
    values.push(double.curvature().convex.value);
    let (low, high) = double.law.extremes(1);
    let width = double.face_width().unwrap_or(f64::NAN);
    values.extend([high.value, low.value, 100.0 * width, sliding(&double)]);
    let mut values: Vec<Value> = values.into_iter().map(Value::from).collect();
    values.extend(motor_values()?);
    values.extend(ripple_values(&double)?);
    Ok(values)
}

/// Friction torque of a cam that slides on its block with μ = 0.1: μ M g (Rb + mean lift), N·m.
const SLIPPING: f64 = 0.034;

/// Values that show whether a motor with varying speed explains the unequal measured intervals.
fn ripple_values(cam: &Cam) -> Result<[Value; 7]> {
    let constant = ripple::turn(cam, 1e4)?;
    let soft = ripple::as_measured(cam)?;
    let drag = ripple::largest_drag();
    let allowed = ripple::turn(cam, SLIPPING / drag)?;
    let [begin, end] = soft.second.map(|angle| format!("{angle:.0}"));
    Ok([
        constant.first_end.into(),
        Value::with(constant.second[0], begin),
        Value::with(constant.second[1], end),
        Value::with(100.0 * soft.ripple, format!("{:.4}", soft.slope)),
        (soft.largest[1] / soft.largest[0]).into(),
        Value::with(soft.slope * drag, format!("{drag:.3}")),
        Value::with(100.0 * allowed.ripple, format!("{:.1}", allowed.first_end)),
    ])
}

/// Fits to the table of motor power against the time for 11.1 turns: the better fit, and that of Campillo de Blas (2017), t = 347.9 x^−0.967.
fn motor_values() -> Result<Vec<Value>> {
    let (factor, power) = motor::power_law(&motor::MOTOR_TABLE)?;
    let seconds_asked = 6.0;
    let fit = [
        factor,
        power,
        motor::power_for(&motor::MOTOR_TABLE, seconds_asked)?,
        (seconds_asked / 347.9_f64).powf(1.0 / -0.967),
        motor::seconds_for(thesis::SPEED),
    ];
    let table = motor::MOTOR_TABLE.map(|(percent, _)| {
        let theirs = 347.9 * percent.powf(-0.967);
        Value::with(factor * percent.powf(power), format!("{theirs:.2}"))
    });
    Ok(fit.map(Value::from).into_iter().chain(table).collect())
}

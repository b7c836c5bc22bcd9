//! `[limits]`, `[machine]` and `[accuracy]` of a scene.

use super::load::lift_dimension;
use super::table::Reader;
use super::{Limits, MachineSpec};
use crate::error::{Error, Result};
use crate::units::Dimension;

pub fn limits(reader: Option<Reader>, oscillating: bool) -> Result<Limits> {
    let mut limits = Limits::default();
    let Some(mut r) = reader else {
        return Ok(limits);
    };
    limits.stroke = r.positive("stroke", lift_dimension(oscillating, 0))?;
    let timed = if oscillating {
        [
            Dimension::AngularSpeed,
            Dimension::AngularAcceleration,
            Dimension::AngularJerk,
        ]
    } else {
        [Dimension::Speed, Dimension::Acceleration, Dimension::Jerk]
    };
    limits.velocity = r.positive("velocity", timed[0])?;
    limits.acceleration = r.positive("acceleration", timed[1])?;
    limits.jerk = r.positive("jerk", timed[2])?;
    let both = r.positive("pressure_angle", Dimension::Angle)?;
    limits.pressure_angle_rise = r
        .positive("pressure_angle_rise", Dimension::Angle)?
        .or(both);
    limits.pressure_angle_fall = r
        .positive("pressure_angle_fall", Dimension::Angle)?
        .or(both);
    for (key, angle) in [
        ("limits.pressure_angle_rise", limits.pressure_angle_rise),
        ("limits.pressure_angle_fall", limits.pressure_angle_fall),
    ] {
        if angle.is_some_and(|a| a >= std::f64::consts::FRAC_PI_2) {
            return Err(
                Error::key(key, "a pressure angle of 90° pushes sideways only")
                    .help("30° to 45° are usual"),
            );
        }
    }
    limits.curvature = r.not_negative("curvature", Dimension::Length)?;
    limits.prime_radius = r.positive("prime_radius", Dimension::Length)?;
    // What an arm's cam presses with is a moment.
    let pressing = if oscillating {
        Dimension::Torque
    } else {
        Dimension::Force
    };
    limits.force_min = r.quantity("force_min", pressing)?;
    limits.force_max = r.quantity("force_max", pressing)?;
    limits.face_width = r.positive("face_width", Dimension::Length)?;
    limits.torque = r.positive("torque", Dimension::Torque)?;
    limits.torque_rate = r.positive("torque_rate", Dimension::AngularRate)?;
    limits.hertz_pressure = r.positive("hertz_pressure", Dimension::Pressure)?;
    limits.residual = r.positive("residual", lift_dimension(oscillating, 0))?;
    r.finish()?;
    if let (Some(low), Some(high)) = (limits.force_min, limits.force_max)
        && low >= high
    {
        return Err(Error::key(
            "limits.force_min",
            format!("{low} N is not below force_max = {high} N"),
        )
        .help("lower force_min or raise force_max"));
    }
    Ok(limits)
}

/// Damping ratio of a follower train of which nothing is said: steel parts with oiled joints.
const DAMPING_RATIO: f64 = 0.05;

pub fn machine(reader: Option<Reader>, oscillating: bool) -> Result<MachineSpec> {
    let mut spec = MachineSpec {
        natural_frequency: None,
        stiffness: None,
        damping_ratio: DAMPING_RATIO,
        friction: 0.0,
        restitution: 0.0,
        second_cam: None,
    };
    let Some(mut r) = reader else { return Ok(spec) };
    spec.natural_frequency = r.positive("natural_frequency", Dimension::Frequency)?;
    let rate = if oscillating {
        Dimension::AngularRate
    } else {
        Dimension::SpringRate
    };
    spec.stiffness = r.positive("stiffness", rate)?;
    if spec.stiffness.is_some() && spec.natural_frequency.is_some() {
        return Err(Error::key(
            "machine.stiffness",
            "natural_frequency says the same of the follower train",
        )
        .help("keep one of the two"));
    }
    if let Some(ratio) = r.not_negative("damping_ratio", Dimension::Ratio)? {
        spec.damping_ratio = ratio;
    }
    spec.friction = r.not_negative("friction", Dimension::Ratio)?.unwrap_or(0.0);
    spec.restitution = r
        .not_negative("restitution", Dimension::Ratio)?
        .unwrap_or(0.0);
    if spec.restitution > 1.0 {
        return Err(Error::key(
            "machine.restitution",
            format!("{} is outside 0 … 1", spec.restitution),
        )
        .help("0 lands without a bounce, 1 loses nothing"));
    }
    spec.second_cam = r.quantity("second_cam", Dimension::Angle)?;
    r.finish()?;
    Ok(spec)
}

pub fn accuracy(reader: Option<Reader>) -> Result<Option<f64>> {
    let Some(mut r) = reader else { return Ok(None) };
    let rms = r.positive("rms", Dimension::Percent)?;
    r.finish()?;
    Ok(rms)
}

//! Shaft power |F·v·ω|: at constant speed a limit P on it is a limit P/ω on the torque (theory §10).

use super::Finished;
use super::loads::{SLACK, largest, torque_curve};
use crate::cam::{Check, LimitKind};
use crate::poly::Extreme;
use crate::problem::Problem;

/// The torque that the limit on the power leaves, N·m.
pub fn as_torque(problem: &Problem) -> Option<f64> {
    Some(problem.limits[LimitKind::Power]? / problem.drive.speed)
}

/// Largest power of the finished cam against the limit.
pub fn check(design: &Finished) -> Option<Check> {
    let limit = design.problem.limits[LimitKind::Power]?;
    let drive = &design.problem.drive;
    let torque = largest(&torque_curve(drive, design.pressing, &design.cam.law));
    let worst = Extreme {
        value: torque.value * drive.speed,
        ..torque
    };
    Some(Check::at_most(LimitKind::Power, worst, limit, SLACK))
}

//! Holding the finished design against the problem: every check on the cam, its second cam or its groove.

use super::design::ForceReport;
use super::limits::{Finished, curvature_checks, interference, pressure_angle_checks, wall_check};
use crate::cam::{BarrelGroove, Cam, Check, Criterion, Wall};
use crate::law::Law;
use crate::problem::Problem;

/// Every limit of the problem, and what no cam may lack, held against the design. The force is that of
/// the law that presses: a polydyne follower's end, the cam's own otherwise.
pub fn checks(design: &Finished) -> Vec<Check> {
    let mut out = design.checks();
    out.extend(second_cam(design.problem, design.second));
    out.extend(groove(design.problem, design.groove));
    out
}

/// The checks of one cam before it has its second cam or its groove.
pub fn checks_of_one(
    problem: &Problem,
    cam: &Cam,
    pressing: &Law,
    force: &ForceReport,
) -> Vec<Check> {
    checks(&Finished {
        problem,
        cam,
        second: None,
        groove: None,
        pressing,
        force,
    })
}

/// What the second cam of a conjugate pair must keep.
fn second_cam(problem: &Problem, second: Option<&Cam>) -> Vec<Check> {
    let Some(cam) = second else { return Vec::new() };
    let mut out = pressure_angle_checks(problem, cam.pressure_angle_extremes());
    out.extend(curvature_checks(problem, cam));
    out.extend(interference(cam));
    for check in &mut out {
        check.name = check.name.of_second_cam();
    }
    out
}

/// Pressure angle and convex walls at the floor of a barrel's groove, where both are worst.
fn groove(problem: &Problem, groove: Option<&BarrelGroove>) -> Vec<Check> {
    let Some(groove) = groove else {
        return Vec::new();
    };
    let floor = groove.depth().0;
    let mut out = pressure_angle_checks(problem, groove.pressure_angle_extremes(floor));
    for (name, wall) in [
        (Criterion::UpperWall, Wall::Upper),
        (Criterion::LowerWall, Wall::Lower),
    ] {
        let radius = groove.smallest_bulge(floor, wall);
        out.push(wall_check(problem, name, radius));
    }
    out
}

//! The class of a finished cam and the reasons for it.

use super::design::ForceReport;
use super::limits::GEOMETRY;
use super::reason::{Reason, place, quantity};
use super::sizing::smallest_without_undercut;
use crate::cam::{Cam, Check, Follower, Verdict};
use crate::drive::DriveKind;
use crate::problem::Problem;
use crate::units::{Dimension, Quantity};

/// The class of the cam and the reasons for it, the main one first.
pub fn verdict(
    problem: &Problem,
    cam: &Cam,
    checks: &[Check],
    force: &ForceReport,
) -> (Verdict, Vec<Reason>) {
    let jump = |order: usize| {
        let at = place(cam.follower.measures(), cam.first_jump(order)?);
        Some(match order {
            0 => Reason::LiftJumps { at },
            1 => Reason::VelocityJumps { at },
            _ => Reason::AccelerationJumps { at },
        })
    };
    if let Some(reason) = jump(0).or_else(|| jump(1)) {
        return (Verdict::Unacceptable, vec![reason]);
    }
    if let Some(failed) = checks.iter().find(|c| !c.pass) {
        return (Verdict::Unacceptable, broken(problem, cam, failed));
    }
    let slow = jump(2)
        .or_else(|| lifts_off(problem, cam, force))
        .or_else(|| cusp(problem, cam, checks));
    match slow {
        Some(reason) => (Verdict::NotForHighSpeed, vec![reason]),
        None => (Verdict::Acceptable, vec![Reason::AllHold]),
    }
}

/// A moved axis is held down by its weight alone: the cam cannot pull it (theory §1).
fn lifts_off(problem: &Problem, cam: &Cam, force: &ForceReport) -> Option<Reason> {
    let drive = &problem.drive;
    let slack = 1e-9 * force.max_n.abs().max(drive.rest_force.abs());
    if drive.kind != DriveKind::MovingAxis || force.min_n >= -slack {
        return None;
    }
    let low = drive.force_curve(&cam.law).extremes().0;
    // F = M(g + ω²a): it vanishes where ω² = g/(−a).
    let fastest = drive.speed * (drive.rest_force / (drive.rest_force - low.value)).sqrt();
    Some(Reason::LiftsOff {
        at: Quantity::angle(low.at),
        pull: Quantity::force(-low.value),
        speed: Quantity::new(fastest, Dimension::AngularSpeed),
    })
}

/// A profile without a limit on its curvature may end in an edge.
fn cusp(problem: &Problem, cam: &Cam, checks: &[Check]) -> Option<Reason> {
    let convex = checks.iter().find(|c| c.name == "curvature")?;
    let prime = cam.follower.prime_radius();
    let sharp = convex.worst.abs() <= GEOMETRY * prime;
    let round = problem.limits.curvature.is_some_and(|rho| rho > 0.0);
    let turns = !matches!(
        cam.follower,
        Follower::Barrel { .. } | Follower::TranslatingCam { .. }
    );
    (sharp && !round && turns && prime > 0.0).then(|| Reason::Cusp {
        at: Quantity::angle(convex.at),
    })
}

/// What would mend a radius that is too small.
fn larger(problem: &Problem, cam: &Cam) -> Reason {
    if matches!(cam.follower, Follower::TranslatingCam { .. }) {
        return Reason::LengthenTravel;
    }
    match smallest_without_undercut(problem, cam) {
        Some(base) if base > cam.follower.base_radius() => Reason::BaseRadiusWorks {
            radius: Quantity::length(base),
        },
        _ => Reason::EnlargeBaseCircle,
    }
}

/// A check that failed, and its cure where one is known.
fn broken(problem: &Problem, cam: &Cam, check: &Check) -> Vec<Reason> {
    let measures = cam.follower.measures();
    let at = place(measures, check.at);
    let value = quantity(measures, &check.name, check.worst);
    let allowed = quantity(measures, &check.name, check.limit);
    let reason = match check.name.as_str() {
        "curvature" => {
            let radius = value;
            let reason = if check.worst < 0.0 {
                Reason::Undercut { at, radius }
            } else {
                Reason::TooSharp {
                    at,
                    radius,
                    allowed,
                }
            };
            return vec![reason, larger(problem, cam)];
        }
        "second_curvature" => Reason::SecondTooSharp {
            at,
            radius: value,
            allowed,
        },
        "interference" | "second_interference" => Reason::Interference { at, depth: value },
        "upper_wall" | "lower_wall" => Reason::SharpWall {
            at,
            radius: value,
            allowed,
        },
        "concave" => Reason::RollerTooLarge {
            at,
            roller: allowed,
            hollow: value,
        },
        "pressure_angle_rise" | "pressure_angle_fall" => Reason::PressureAngle {
            at,
            angle: value,
            allowed,
        },
        "rms_error" => Reason::ForceError {
            error: value,
            allowed,
        },
        "base_circle" => Reason::BelowBaseCircle {
            at,
            depth: quantity(measures, &check.name, -check.worst),
        },
        "prime_radius" => Reason::PrimeRadius {
            needed: value,
            allowed,
        },
        "band" => Reason::OutsideBand { at, excess: value },
        name => Reason::LimitBroken {
            limit: name.to_string(),
            at,
            value,
            allowed,
        },
    };
    vec![reason]
}

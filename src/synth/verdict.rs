//! Verdict on a finished cam, with its reasons (docs/verdict.md).

use super::limits::{GEOMETRY, is_usual, usual_pressure_angle};
use super::sizing::smallest_without_undercut;
use crate::cam::{Cam, Check, Criterion, Follower, LimitKind, Verdict};
use crate::drive::DriveKind;
use crate::force::{Note, OpenQuestion};
use crate::problem::Problem;
use crate::scene::Family;
use crate::synth::report::force::ForceReport;
use crate::synth::report::reason::{Reason, place, quantity};
use crate::units::{Dimension, Quantity};

/// Relative difference below which two pressure angles count as equal.
const SAME_ANGLE: f64 = 1e-9;

/// Verdict on the cam and all reasons for it, the most serious first.
pub fn verdict(
    problem: &Problem,
    cam: &Cam,
    checks: &[Check],
    force: &ForceReport,
) -> (Verdict, Vec<Reason>) {
    let mut bad: Vec<Reason> = mean_force(problem, force).into_iter().collect();
    bad.extend(problem.open_questions.iter().cloned().map(open));
    bad.extend([0, 1].into_iter().filter_map(|k| jump(cam, k)));
    let mut failed: Vec<&Check> = checks.iter().filter(|c| !c.pass).collect();
    failed.sort_by_key(|c| c.name.severity());
    // If the mean target force differs from the weight on a moving axis, this difference is reported instead of the force error. Of two
    // pressure angles, only the larger one is reported.
    let has_gap = problem.mean_force_gap().is_some();
    failed.retain(|c| match c.name {
        Criterion::RmsError => !has_gap,
        name if name.is_pressure_angle() => is_largest_angle(c, checks),
        _ => true,
    });
    bad.extend(failed.iter().flat_map(|c| broken(problem, cam, force, c)));
    let mut slow: Vec<Reason> = jump(cam, 2).into_iter().collect();
    slow.extend(cusp(problem, cam, checks));
    slow.extend(steep(problem, cam, checks));
    let class = match (bad.is_empty(), slow.is_empty()) {
        (false, _) => Verdict::Unacceptable,
        (true, false) => Verdict::NotForHighSpeed,
        (true, true) => Verdict::Acceptable,
    };
    bad.extend(slow);
    if bad.is_empty() {
        bad.push(Reason::AllHold);
    }
    (class, bad)
}

/// Reason for the verdict: the mean target force differs from M·g. On a moving axis, every law has the mean force M·g (theory §1).
pub fn mean_force(problem: &Problem, force: &ForceReport) -> Option<Reason> {
    problem.mean_force_gap().map(|gap| Reason::MeanForce {
        mean: Quantity::force(force.target_mean_n),
        weight: Quantity::force(problem.drive.rest_force),
        error: Quantity::force(gap.abs()),
    })
}

/// Reason for the verdict: an uncertain property of the recording.
fn open((question, because): (OpenQuestion, Vec<Note>)) -> Reason {
    let mut keys: Vec<&'static str> = Vec::new();
    for key in because.iter().flat_map(|note| note.settled_by()) {
        if !keys.contains(key) {
            keys.push(key);
        }
    }
    match question {
        OpenQuestion::Kind => Reason::RecordingKind { because, keys },
        OpenQuestion::Clock => Reason::RecordingClock { because, keys },
        OpenQuestion::Mass => Reason::RecordingMass { because, keys },
        OpenQuestion::Clipped => Reason::RecordingClipped { because, keys },
    }
}

/// Reason for the verdict: the first jump of the lift derivative of this order; `None` without a jump.
fn jump(cam: &Cam, order: usize) -> Option<Reason> {
    let at = place(cam.follower.measures(), cam.first_jump(order)?);
    Some(match order {
        0 => Reason::LiftJumps { at },
        1 => Reason::VelocityJumps { at },
        _ => Reason::AccelerationJumps { at },
    })
}

/// Reason for the verdict: loss of contact where the contact force would have to be negative.
fn lifts_off(problem: &Problem, cam: &Cam, force: &ForceReport, low: &Check) -> Reason {
    let drive = &problem.drive;
    let measures = cam.follower.measures();
    let (at, pull) = (
        place(measures, low.at),
        quantity(measures, LimitKind::ForceMin.into(), -low.worst),
    );
    if drive.kind != DriveKind::MovingAxis || force.min_n >= drive.rest_force {
        return Reason::ContactLost { at, pull };
    }
    // F = M(g + ω²a) is zero for ω² = g/(−a).
    let fastest = drive.speed * (drive.rest_force / (drive.rest_force - low.worst)).sqrt();
    let speed = Quantity::new(fastest, Dimension::AngularSpeed);
    // Limits have no effect on a prescribed law.
    match problem.law.family {
        Family::Program | Family::Polynomial => Reason::LiftsOffAsPrescribed { at, pull, speed },
        Family::Spline | Family::Auto | Family::Harmonic | Family::DoubleHarmonic => {
            Reason::LiftsOff { at, pull, speed }
        }
    }
}

/// Preload of a spring and minimum target force, N, if the preload exceeds this minimum by more than the permitted force error; otherwise
/// `None`. The force of a spring cannot be less than its preload.
fn preload_above(problem: &Problem) -> Option<[f64; 2]> {
    let drive = &problem.drive;
    let [least, _] = problem.target.as_ref()?.range_n();
    let held = drive.kind == DriveKind::FixedAxis && problem.lift_of_force(least)? < 0.0;
    (held && drive.rest_force - least > problem.wanted_error()).then_some([drive.rest_force, least])
}

/// Reason for a pressure angle above the default bound for any machine, on a side without a limit in the scene.
fn steep(problem: &Problem, cam: &Cam, checks: &[Check]) -> Option<Reason> {
    let [usual, _] = usual_pressure_angle(problem)?;
    let angles = checks.iter().filter(|c| is_usual(problem, c.name));
    let worst = angles.max_by(|a, b| a.worst.total_cmp(&b.worst))?;
    (worst.pass && worst.worst > usual * (1.0 + GEOMETRY)).then(|| Reason::LargePressureAngle {
        at: place(cam.follower.measures(), worst.at),
        angle: Quantity::angle(worst.worst),
        usual: Quantity::angle(usual),
    })
}

/// Reason for a cusp of the profile, if the scene has no limit on its curvature.
fn cusp(problem: &Problem, cam: &Cam, checks: &[Check]) -> Option<Reason> {
    let convex = checks.iter().find(|c| c.name == LimitKind::Curvature)?;
    let prime = cam.follower.prime_radius();
    let sharp = convex.worst.abs() <= GEOMETRY * prime;
    let round = problem.limits[LimitKind::Curvature].is_some_and(|rho| rho > 0.0);
    let turns = !cam.follower.is_unrolled();
    (sharp && !round && turns && prime > 0.0).then(|| Reason::Cusp {
        at: Quantity::angle(convex.at),
    })
}

/// Suggested change of the base circle, or of the travel, if a radius of curvature of the profile is too small.
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

/// Reason for a convex radius of curvature that is too small, on the profile, the second cam or a wall of a groove.
fn too_sharp(check: &Check, at: Quantity, radius: Quantity, allowed: Quantity) -> Reason {
    match check.name {
        Criterion::SecondCurvature => Reason::SecondTooSharp {
            at,
            radius,
            allowed,
        },
        Criterion::UpperWall | Criterion::LowerWall => Reason::SharpWall {
            at,
            radius,
            allowed,
        },
        _ if check.worst < 0.0 => Reason::Undercut { at, radius },
        _ => Reason::TooSharp {
            at,
            radius,
            allowed,
        },
    }
}

/// Whether a pressure angle is the largest among the checks with the same limit. Of several equal angles, only the first counts as the
/// largest.
fn is_largest_angle(check: &Check, checks: &[Check]) -> bool {
    let angles = checks
        .iter()
        .filter(|o| o.name.is_pressure_angle() && o.limit == check.limit);
    let larger = |a: &Check, b: &Check| b.worst > a.worst * (1.0 + SAME_ANGLE);
    let largest = angles.reduce(|a, b| if larger(a, b) { b } else { a });
    largest.is_none_or(|o| o.name == check.name)
}

/// Reasons for the verdict that describe a failed check, with a suggested change if one is known.
fn broken(problem: &Problem, cam: &Cam, force: &ForceReport, check: &Check) -> Vec<Reason> {
    let measures = cam.follower.measures();
    let at = place(measures, check.at);
    let value = quantity(measures, check.name, check.worst);
    let allowed = quantity(measures, check.name, check.limit);
    let reason = match check.name {
        Criterion::Limit(LimitKind::Curvature) => {
            let sharp = too_sharp(check, at, value, allowed);
            return vec![sharp, larger(problem, cam)];
        }
        Criterion::SecondCurvature | Criterion::UpperWall | Criterion::LowerWall => {
            too_sharp(check, at, value, allowed)
        }
        Criterion::Interference | Criterion::SecondInterference => {
            Reason::Interference { at, depth: value }
        }
        Criterion::Concave | Criterion::SecondConcave => Reason::RollerTooLarge {
            at,
            roller: allowed,
            hollow: value,
        },
        angle if angle.is_pressure_angle() => Reason::PressureAngle {
            at,
            angle: value,
            allowed,
        },
        Criterion::Limit(LimitKind::ForceMin) if problem.limits[LimitKind::ForceMin].is_none() => {
            lifts_off(problem, cam, force, check)
        }
        Criterion::Limit(LimitKind::ForceMin) if problem.presses_too_little() => {
            Reason::NothingPresses
        }
        Criterion::RmsError => match preload_above(problem) {
            Some([preload, least]) => Reason::PreloadAboveTarget {
                error: value,
                allowed,
                preload: quantity(measures, check.name, preload),
                least: quantity(measures, check.name, least),
            },
            None => Reason::ForceError {
                error: value,
                allowed,
            },
        },
        Criterion::BaseCircle => Reason::BelowBaseCircle {
            at,
            depth: quantity(measures, check.name, -check.worst),
        },
        Criterion::Limit(LimitKind::PrimeRadius) => Reason::PrimeRadius {
            needed: value,
            allowed,
        },
        Criterion::Band => Reason::OutsideBand { at, excess: value },
        Criterion::Limit(LimitKind::HertzPressure) if check.worst.is_infinite() => {
            Reason::PressureUnbounded { at }
        }
        limit if check.worst.is_infinite() => Reason::LimitUnbounded { limit, at },
        limit => Reason::LimitBroken {
            limit,
            at,
            value,
            allowed,
        },
    };
    vec![reason]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_open_question_names_each_key_that_settles_it_once() {
        let note = Note::CountOrMilliseconds {
            stride: Quantity::new(1.0, Dimension::Time),
        };
        let keys = note.settled_by();
        assert!(!keys.is_empty());
        let reason = open((OpenQuestion::Clock, vec![note.clone(), note.clone()]));
        let expected = Reason::RecordingClock {
            because: vec![note.clone(), note],
            keys: keys.to_vec(),
        };
        assert_eq!(reason, expected);
    }

    #[test]
    fn a_radius_of_nothing_is_too_sharp_and_a_smaller_one_is_undercut() {
        let reason = |rho: f64| {
            let radius = crate::poly::Extreme {
                at: 1.0,
                value: rho,
            };
            let check = Check::of(LimitKind::Curvature, radius, 0.005, 0.0);
            let [at, radius, allowed] = [check.at, rho, check.limit].map(Quantity::length);
            too_sharp(&check, at, radius, allowed)
        };
        assert!(matches!(reason(0.0), Reason::TooSharp { .. }));
        assert!(matches!(reason(-1e-9), Reason::Undercut { .. }));
    }
}

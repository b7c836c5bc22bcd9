//! The class of a finished cam and the reason for it.

use super::design::ForceReport;
use super::infeasible::in_units;
use super::limits::GEOMETRY;
use crate::cam::{Cam, Check, Follower, Verdict};
use crate::drive::DriveKind;
use crate::problem::Problem;

/// Jumps below this part of the peak-to-peak value of the same derivative are rounding.
const JUMP: f64 = 1e-7;
/// A derivative that varies by less, m/radᵏ, is that of a law at rest.
const STILL: f64 = 1e-9;

/// The class of the cam and one sentence on it, for a student.
pub fn verdict(
    problem: &Problem,
    cam: &Cam,
    checks: &[Check],
    force: &ForceReport,
) -> (Verdict, String) {
    let range = |order: usize| {
        let (low, high) = cam.law.extremes(order);
        // A law that hardly moves is not made of jumps: rounding counts against the cam's size too.
        (high.value - low.value)
            .max(1e-6 * cam.follower.prime_radius())
            .max(STILL)
    };
    let ranges = [range(0), range(1), range(2)];
    let measures = cam.follower.measures();
    for joint in cam.law.joints() {
        for (order, jump, what) in [(0, joint.jump.s, "lift"), (1, joint.jump.v, "velocity")] {
            if jump.abs() > JUMP * ranges[order] {
                let at = measures.place(joint.at, 2);
                return (
                    Verdict::Unacceptable,
                    format!(
                        "The {what} jumps at {at}: the follower would have to be in two states at once, so no machine can follow."
                    ),
                );
            }
        }
    }
    if let Some(failed) = checks.iter().find(|c| !c.pass) {
        return (Verdict::Unacceptable, failed_words(problem, cam, failed));
    }
    let jumps = cam
        .law
        .joints()
        .into_iter()
        .find(|j| j.jump.a.abs() > JUMP * ranges[2]);
    if let Some(joint) = jumps {
        return (
            Verdict::NotForHighSpeed,
            format!(
                "Every limit holds, but the acceleration jumps at {}: the force jumps with it and shakes a fast machine.",
                measures.place(joint.at, 2)
            ),
        );
    }
    if let Some(words) =
        lifts_off(problem, cam, force).or_else(|| comes_to_a_point(problem, cam, checks))
    {
        return (Verdict::NotForHighSpeed, words);
    }
    (
        Verdict::Acceptable,
        "Every limit holds, and lift, velocity and acceleration are continuous all around."
            .to_string(),
    )
}

/// A moved axis is held down by its weight alone: the cam cannot pull it (theory §1).
fn lifts_off(problem: &Problem, cam: &Cam, force: &ForceReport) -> Option<String> {
    let drive = &problem.drive;
    let slack = 1e-9 * force.max_n.abs().max(drive.rest_force.abs());
    if drive.kind != DriveKind::MovingAxis || force.min_n >= -slack {
        return None;
    }
    let low = drive.force_curve(&cam.law).extremes().0;
    // F = M(g + ω²a): it vanishes where ω² = g/(−a).
    let fastest = drive.speed * (drive.rest_force / (drive.rest_force - low.value)).sqrt();
    Some(format!(
        "Every limit holds, but at {:.2}° the cam would have to pull with {:.3} N: above {fastest:.3} rad/s the follower lifts off. limits.force_min = \"0 N\" keeps it down.",
        low.at.to_degrees(),
        -low.value
    ))
}

/// A profile without a limit on its curvature may end in an edge.
fn comes_to_a_point(problem: &Problem, cam: &Cam, checks: &[Check]) -> Option<String> {
    let convex = checks.iter().find(|c| c.name == "curvature")?;
    let prime = cam.follower.prime_radius();
    let sharp = convex.worst.abs() <= GEOMETRY * prime;
    let round = problem.limits.curvature.is_some_and(|rho| rho > 0.0);
    let turns = !matches!(
        cam.follower,
        Follower::Barrel { .. } | Follower::TranslatingCam { .. }
    );
    (sharp && !round && turns && prime > 0.0).then(|| {
        format!(
            "Every limit holds, but the profile comes to a point at {:.2}°, an edge that wears at once: limits.curvature asks for a radius.",
            convex.at.to_degrees()
        )
    })
}

/// The size that would mend a radius that is too small, in words.
fn larger(problem: &Problem, cam: &Cam) -> String {
    if matches!(cam.follower, Follower::TranslatingCam { .. }) {
        return "Lengthen the travel, or use a smaller roller.".to_string();
    }
    match super::sizing::smallest_without_undercut(problem, cam) {
        Some(base) if base > cam.follower.base_radius() => format!(
            "A base radius of {:.3} mm is the smallest that works here.",
            1e3 * base
        ),
        _ => "Enlarge the base circle, or use a smaller roller.".to_string(),
    }
}

fn failed_words(problem: &Problem, cam: &Cam, check: &Check) -> String {
    let measures = cam.follower.measures();
    let at = measures.place(check.at, 1);
    let (worst, limit) = (check.worst, check.limit);
    match check.name.as_str() {
        "curvature" if worst < 0.0 => format!(
            "The profile is undercut at {at}: its convex radius would be {:.3} mm. {}",
            1e3 * worst,
            larger(problem, cam)
        ),
        "curvature" => format!(
            "The profile is sharper at {at} ({:.3} mm) than the {:.3} mm allowed. {}",
            1e3 * worst,
            1e3 * limit,
            larger(problem, cam)
        ),
        "second_curvature" => format!(
            "The second cam of the pair is sharper at {at} ({:.3} mm) than the {:.3} mm allowed. Move its follower farther out.",
            1e3 * worst,
            1e3 * limit
        ),
        "interference" | "second_interference" => format!(
            "At {at} the follower reaches {:.3} mm into another part of the cam than the one it touches. Use a smaller roller, or enlarge the base circle.",
            1e3 * worst
        ),
        "upper_wall" | "lower_wall" => format!(
            "A wall of the groove bulges with {:.3} mm at {at}, sharper than the {:.3} mm allowed. Use a smaller roller, or a larger barrel.",
            1e3 * worst,
            1e3 * limit
        ),
        "concave" => format!(
            "The roller of {:.3} mm does not fit the hollow of {:.3} mm at {at}. Use a smaller roller.",
            1e3 * limit,
            1e3 * worst
        ),
        "pressure_angle_rise" | "pressure_angle_fall" => format!(
            "The pressure angle reaches {:.2}° at {at}, more than the {:.2}° allowed: the follower would jam in its guide. Enlarge the prime circle.",
            worst.to_degrees(),
            limit.to_degrees()
        ),
        "rms_error" => format!(
            "The force misses the target by {worst:.4} N RMS, more than the {limit:.4} N asked for. Relax the limits that bind, or allow more spans."
        ),
        "base_circle" => format!(
            "The law dips {} below its base circle at {at}.",
            in_units(measures, "base_circle", -worst)
        ),
        "prime_radius" => format!(
            "The cam needs a prime radius of {:.3} mm, more than the {:.3} mm allowed. Allow a larger pressure angle or more force error.",
            1e3 * worst,
            1e3 * limit
        ),
        "band" => format!(
            "The force leaves the band by {worst:.4} N at {at}. Widen the band, or allow more spans."
        ),
        name => format!(
            "The limit \"{name}\" is broken at {at}: {} against {}.",
            in_units(measures, name, worst),
            in_units(measures, name, limit)
        ),
    }
}

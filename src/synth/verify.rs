//! Holding the finished design against the scene: exact extremes, checks, force report.

use super::answer::ForceReport;
use super::infeasible::in_units;
use super::qp::TOLERANCE;
use crate::cam::{BarrelGroove, Body, Cam, Check, Conjugate, Follower, Verdict, Wall};
use crate::drive::DriveKind;
use crate::law::Law;
use crate::poly::{Extreme, PiecewisePoly, distance};
use crate::problem::Problem;

/// A sized quantity (prime circle by bisection or root) may miss its limit by this part: rounding of the
/// geometry, not of the law.
const GEOMETRY: f64 = 1e-8;
/// Jumps below this part of the peak-to-peak value of the same derivative are rounding.
const JUMP: f64 = 1e-7;

/// A derivative that varies by less, m/radᵏ, is that of a law at rest.
const STILL: f64 = 1e-9;

/// Points of the profile among which interference is looked for.
const INTERFERENCE_POINTS: usize = 360;
/// Depth of interference below this share of the prime radius is rounding.
const TOUCH: f64 = 1e-6;

/// Distance of the force of a law from the target, exact on the pieces of both.
pub fn law_force(problem: &Problem, law: &Law) -> ForceReport {
    let own = problem.drive.force_curve(law);
    let (low, high) = own.extremes();
    let (start, length) = law.extent();
    let mut report = ForceReport {
        mean_n: own.integral() / length,
        min_n: low.value,
        max_n: high.value,
        ..ForceReport::default()
    };
    if let Some(target) = &problem.target {
        let apart = distance(&own, &target.curve.curve());
        report.target_mean_n = target.mean_n();
        report.rms_error_n = (apart.square / length).max(0.0).sqrt();
        report.max_error_n = apart.largest;
        report.rms_error_percent_of_mean = 100.0 * report.rms_error_n / report.target_mean_n.abs();
        debug_assert!(start == 0.0);
    }
    report
}

fn difference(own: &PiecewisePoly, target: &PiecewisePoly) -> PiecewisePoly {
    let own = own.cut_at(target.breaks());
    let target = target.cut_at(own.breaks());
    PiecewisePoly::combine(&[(1.0, &own), (-1.0, &target)], 0.0)
}

/// Every limit of the scene, and what no cam may lack, held against the design. The force is that of the
/// law that presses: a polydyne follower's end, the cam's own otherwise.
pub fn checks(problem: &Problem, cam: &Cam, pressing: &Law, force: &ForceReport) -> Vec<Check> {
    let limits = &problem.limits;
    let speed = problem.drive.speed;
    let mut out = Vec::new();
    let (bottom, top) = cam.law.extremes(0);
    if let Some(h) = limits.stroke {
        let stroke = Extreme {
            at: top.at,
            value: top.value - bottom.value,
        };
        out.push(Check::at_most("stroke", stroke, h, 2.0 * TOLERANCE));
    }
    let timed = [
        ("velocity", 1, limits.velocity),
        ("acceleration", 2, limits.acceleration),
        ("jerk", 3, limits.jerk),
    ];
    for (name, order, limit) in timed {
        if let Some(limit) = limit {
            let (low, high) = cam.law.extremes(order);
            let worst = if high.value >= -low.value {
                high
            } else {
                Extreme {
                    at: low.at,
                    value: -low.value,
                }
            };
            let timed = Extreme {
                at: worst.at,
                value: worst.value * speed.powi(order as i32),
            };
            out.push(Check::at_most(name, timed, limit, 2.0 * TOLERANCE));
        }
    }
    let curve = problem.drive.force_curve(pressing);
    let (low, high) = curve.extremes();
    let force_slack = 2.0
        * TOLERANCE
        * force
            .target_mean_n
            .abs()
            .max(problem.drive.rest_force.abs());
    if let Some(limit) = limits.force_min {
        let mut check = Check::at_least("force_min", low, limit, 2.0 * TOLERANCE);
        check.pass = low.value >= limit - force_slack;
        out.push(check);
    }
    if let Some(limit) = limits.force_max {
        out.push(Check::at_most("force_max", high, limit, 2.0 * TOLERANCE));
    }
    out.extend(profile_checks(problem, cam));
    if let Some([low, high]) = &problem.band {
        // The band is the accuracy then.
        let below = difference(&low.curve(), &curve).extremes().1;
        let above = difference(&curve, &high.curve()).extremes().1;
        let worst = if below.value > above.value {
            below
        } else {
            above
        };
        let mut check = Check::at_most("band", worst, 0.0, 0.0);
        check.pass = worst.value <= force_slack;
        out.push(check);
    } else if let (Some(rms), Some(_)) = (problem.accuracy, &problem.target) {
        let worst = Extreme {
            at: 0.0,
            value: force.rms_error_n,
        };
        out.push(Check::at_most(
            "rms_error",
            worst,
            rms * force.target_mean_n.abs(),
            TOLERANCE,
        ));
    }
    out
}

fn profile_checks(problem: &Problem, cam: &Cam) -> Vec<Check> {
    let limits = &problem.limits;
    let mut out = Vec::new();
    if !matches!(cam.follower, Follower::Barrel { .. }) {
        let (low, high) = cam.pressure_angle_extremes();
        out.extend(pressure(problem, low, high, ""));
    }
    out.extend(curvature(problem, cam, ""));
    if let (Some(limit), Some(width)) = (limits.face_width, cam.face_width()) {
        let at = cam.law.extremes(1).1.at;
        out.push(Check::at_most(
            "face_width",
            Extreme { at, value: width },
            limit,
            2.0 * TOLERANCE,
        ));
    }
    if let Some(limit) = limits.prime_radius {
        let worst = Extreme {
            at: 0.0,
            value: cam.follower.prime_radius(),
        };
        out.push(Check::at_most("prime_radius", worst, limit, GEOMETRY));
    }
    if let Some(bore) = problem.cam.bore {
        let worst = Extreme {
            at: 0.0,
            value: cam.follower.base_radius(),
        };
        out.push(Check::at_least("bore", worst, 0.5 * bore, GEOMETRY));
    }
    if let Some(check) = interference("interference", cam) {
        out.push(check);
    }
    let lowest = cam.law.extremes(0).0;
    if lowest.value < -1e-7 * cam.law.stroke() {
        out.push(Check::at_least("base_circle", lowest, 0.0, 0.0));
    }
    out
}

/// Both sides of the pressure angle against the scene's limits.
fn pressure(problem: &Problem, low: Extreme, high: Extreme, prefix: &str) -> Vec<Check> {
    let limits = &problem.limits;
    let falling = Extreme {
        at: low.at,
        value: -low.value,
    };
    [
        ("rise", high, limits.pressure_angle_rise),
        ("fall", falling, limits.pressure_angle_fall),
    ]
    .into_iter()
    .filter_map(|(side, worst, limit)| {
        let name = format!("{prefix}pressure_angle_{side}");
        Some(Check::at_most(&name, worst, limit?, GEOMETRY))
    })
    .collect()
}

/// Convex and concave radii of a profile. Asked for or not, a negative convex radius is a cam that cuts
/// itself.
fn curvature(problem: &Problem, cam: &Cam, prefix: &str) -> Vec<Check> {
    let curvature = cam.curvature();
    let wanted = problem.limits.curvature.unwrap_or(0.0);
    let name = format!("{prefix}curvature");
    let mut convex = Check::at_least(&name, curvature.convex, wanted, GEOMETRY);
    // The smallest cam that may come to a point does so to rounding of its own size.
    let rounding = GEOMETRY * cam.follower.prime_radius();
    convex.pass |= wanted == 0.0 && curvature.convex.value.abs() <= rounding;
    convex.pass &= !curvature.undercut || curvature.convex.value.abs() <= rounding;
    let mut out = vec![convex];
    let roller = cam.follower.roller_radius();
    if let Some(concave) = curvature.concave.filter(|_| roller > 0.0) {
        // The roller has to fit into the hollow: |ρ_cam| ≥ R_f.
        let worst = Extreme {
            at: concave.at,
            value: -concave.value,
        };
        let name = format!("{prefix}concave");
        out.push(Check::at_least(&name, worst, roller, GEOMETRY));
    }
    out
}

/// Roller or face against other parts of the profile; `None` where nothing can interfere: a flat
/// translating face on a convex cam touches it once.
fn interference(name: &str, cam: &Cam) -> Option<Check> {
    match cam.follower {
        Follower::FlatTranslating { .. } | Follower::Barrel { .. } => return None,
        _ if cam.curvature().undercut => return None,
        _ => {}
    }
    let tolerance = TOUCH * cam.follower.prime_radius();
    let deepest = cam
        .interference(INTERFERENCE_POINTS, 0.0, tolerance)
        .into_iter()
        .filter(|i| i.body != Body::Arm)
        .max_by(|a, b| a.depth.total_cmp(&b.depth));
    let worst = deepest.map_or(
        Extreme {
            at: cam.law.extent().0,
            value: 0.0,
        },
        |i| Extreme {
            at: i.at,
            value: i.depth,
        },
    );
    let mut check = Check::at_most(name, worst, tolerance, 0.0);
    check.pass = deepest.is_none();
    Some(check)
}

/// What the second cam of a conjugate pair must keep.
pub fn second_cam(problem: &Problem, pair: Option<&Conjugate>) -> Vec<Check> {
    let Some(pair) = pair else { return Vec::new() };
    let cam = &pair.second;
    let (low, high) = cam.pressure_angle_extremes();
    let mut out = pressure(problem, low, high, "second_");
    out.extend(curvature(problem, cam, "second_"));
    out.extend(interference("second_interference", cam));
    out
}

/// Pressure angle and bulging walls at the floor of a barrel's groove, where both are worst.
pub fn groove(problem: &Problem, groove: Option<&BarrelGroove>) -> Vec<Check> {
    let Some(groove) = groove else {
        return Vec::new();
    };
    let floor = groove.depth().0;
    let (low, high) = groove.pressure_angle_extremes(floor);
    let mut out = pressure(problem, low, high, "");
    for (name, wall) in [("upper_wall", Wall::Upper), ("lower_wall", Wall::Lower)] {
        let bulge = groove.smallest_bulge(floor, wall);
        let wanted = problem.limits.curvature.unwrap_or(0.0);
        out.push(Check::at_least(name, bulge, wanted, GEOMETRY));
    }
    out
}

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

//! A rejected scene states sufficient changes. Slightly smaller changes are not sufficient.

use gaitcam::force::ForceCurve;
use gaitcam::problem::Note;
use gaitcam::scene::{self};
use gaitcam::synth::{Design, Reason, synthesise};
use gaitcam_test_support::{scene_of, young};

/// Scene with a rise of 10 mm and a return over half a turn with minimum jerk.
pub const HUMP: &str = r#"
name = "hump"
[drive]
kind = "moving-axis"
mass = "1 kg"
speed = "60 rpm"
[law]
family = "spline"
spans = 24
minimise = "jerk"
[[law.point]]
angle = "0 deg"
lift = "0 mm"
[[law.point]]
angle = "90 deg"
lift = "10 mm"
[[law.point]]
angle = "180 deg"
lift = "0 mm"
[cam]
follower = "flat-translating"
base_radius = "20 mm"
"#;

pub fn good(design: &Design) -> bool {
    design.infeasible.is_none() && design.checks.iter().all(|c| c.pass)
}

/// Assignment of a limit by its scene key, with the unit of its name.
pub fn assignment(limit: &str, value: f64) -> String {
    let (key, number, unit) = match limit {
        "accuracy.rms" => ("accuracy.rms".to_string(), 100.0 * value, "%"),
        "force_min" | "force_max" => (format!("limits.{limit}"), value, "N"),
        "velocity" => ("limits.velocity".to_string(), value, "m/s"),
        "acceleration" => ("limits.acceleration".to_string(), value, "m/s^2"),
        "jerk" => ("limits.jerk".to_string(), value, "m/s^3"),
        name if name.starts_with("pressure_angle") => {
            (format!("limits.{name}"), value.to_degrees(), "deg")
        }
        name if name.starts_with("cam.") => (name.to_string(), 1e3 * value, "mm"),
        name => (format!("limits.{name}"), 1e3 * value, "mm"),
    };
    format!("{key}={number:.9} {unit}")
}

/// Asserts that every stated relaxation is sufficient, and that a change smaller by a hundredth is not. Returns their names.
pub fn proved(text: &str, target: Option<&ForceCurve>, changes: &[&str]) -> Vec<String> {
    let scene = scene_of(text, changes);
    let design = synthesise(&scene, target).unwrap();
    assert!(!good(&design), "{changes:?} was built");
    let design = design.relaxed();
    assert!(
        !design.relaxations.is_empty(),
        "{}",
        design.reason(gaitcam::wording::Language::En)
    );
    // What the law at hand would need is no second value for the size.
    let resized = design.relaxations.iter().any(|r| r.key.starts_with("cam."));
    let own = |r: &Reason| matches!(r, Reason::BaseRadiusWorks { .. });
    assert!(!(resized && design.reasons.iter().any(own)));
    assert!(
        matches!(
            design.reasons.last(),
            Some(Reason::Relaxation { .. } | Reason::Relaxations { .. })
        ),
        "{}",
        design.reason(gaitcam::wording::Language::En)
    );
    for r in &design.relaxations {
        let to = r.to.unwrap();
        let with = |value: f64| {
            let change = assignment(r.limit.name(), value);
            let all: Vec<&str> = changes.iter().copied().chain([change.as_str()]).collect();
            good(&synthesise(&scene_of(text, &all), target).unwrap())
        };
        assert!(
            with(to),
            "{} = {to} does not work: {}",
            r.limit,
            design.reason(gaitcam::wording::Language::En)
        );
        let less = to + 0.02 * to.abs() * (r.from - to).signum();
        let between = (less - r.from) * (to - less) > 0.0;
        assert!(!between || !with(less), "{} = {less} works too", r.limit);
    }
    design
        .relaxations
        .into_iter()
        .map(|r| r.limit.to_string())
        .collect()
}

#[test]
fn limits_against_the_accuracy_name_both() {
    let target = young();
    let names = proved(scene::DEFAULT, Some(&target), &["limits.stroke=40 mm"]);
    assert_eq!(names, ["stroke", "accuracy.rms"]);
    let names = proved(scene::DEFAULT, Some(&target), &["limits.force_max=690 N"]);
    assert_eq!(names, ["force_max"]);
}

#[test]
fn a_small_base_circle_under_a_large_radius_names_radius_and_circle() {
    let target = young();
    let changes = ["cam.base_radius=10 mm", "limits.curvature=40 mm"];
    let names = proved(scene::DEFAULT, Some(&target), &changes);
    assert_eq!(names, ["curvature", "cam.base_radius"]);
}

#[test]
fn speeds_and_faces_are_relaxed_as_far_as_the_whole_cam_needs() {
    for change in ["limits.velocity=0.04 m/s", "limits.face_width=10 mm"] {
        let names = proved(HUMP, None, &[change]);
        assert_eq!(names.len(), 1, "{change}");
    }
}

#[test]
fn a_steep_roller_cam_names_angle_and_circle() {
    let roller = [
        "cam.follower=roller-translating",
        "cam.roller_radius=10 mm",
        "cam.base_radius=20 mm",
        "cam.offset=0 mm",
        "limits.pressure_angle=8 deg",
    ];
    let names = proved(HUMP, None, &roller);
    assert!(names.contains(&"pressure_angle".to_string()), "{names:?}");
}

#[test]
fn a_programme_that_is_too_steep_says_what_would_do() {
    let text = r#"
        name = "programme"
        [drive]
        kind = "fixed-axis"
        speed = "60 rpm"
        [law]
        family = "program"
        [[law.segment]]
        motion = "3-4-5"
        lift = "20 mm"
        angle = "60 deg"
        [[law.segment]]
        motion = "3-4-5"
        lift = "-20 mm"
        angle = "60 deg"
        [[law.segment]]
        motion = "dwell"
        angle = "240 deg"
        [cam]
        follower = "roller-translating"
        roller_radius = "5 mm"
        prime_radius = "40 mm"
        [limits]
        pressure_angle = "20 deg"
    "#;
    let names = proved(text, None, &[]);
    assert_eq!(names, ["pressure_angle", "cam.prime_radius"]);
}

/// The stroke is the travel of the follower, independent of the start of the drive's lift.
#[test]
fn a_stroke_counts_from_the_lowest_lift() {
    let hydraulic = [
        "drive.kind=hydraulic",
        "drive.pressure_per_volume=30 psi/in^3",
        "drive.piston_radius=0.75 in",
        "law.family=spline",
        "law.spans=16",
        "accuracy.rms=5 %",
    ];
    let text = scene::DEFAULT
        .replace("mass = \"auto\"\n", "")
        .replace("bore = \"12 mm\"\n", "");
    let target = young();
    let free = synthesise(
        &scene_of(&text.replace("stroke = \"60 mm\"\n", ""), &hydraulic),
        Some(&target),
    )
    .unwrap();
    let stroke = free.cam.law.stroke();
    let lowest = free.cam.law.extremes(0).0.value;
    assert!(
        lowest > 0.2 * stroke,
        "the lift starts well above the base circle"
    );
    let with = |mm: f64| {
        let limit = format!("limits.stroke={mm:.9} mm");
        let all: Vec<&str> = hydraulic.iter().copied().chain([limit.as_str()]).collect();
        synthesise(&scene_of(&text, &all), Some(&target)).unwrap()
    };
    let wide = with(1e3 * stroke * 1.001);
    assert!(good(&wide) && wide.binding.is_empty());
    assert!((wide.force.rms_error_n - free.force.rms_error_n).abs() < 1e-9);
    let narrow = with(1e3 * stroke * 0.99);
    let travelled = narrow.cam.law.stroke();
    assert!(
        good(&narrow),
        "{}",
        narrow.reason(gaitcam::wording::Language::En)
    );
    assert!(
        (travelled / (0.99 * stroke) - 1.0).abs() < 1e-6,
        "{travelled} {stroke}"
    );
    assert!(narrow.binding.iter().any(|b| b.limit.name() == "stroke"));
    // A law cut at both ends of the range misses the force by half of what is cut, at most: the best one
    // misses it by less, and by more than nothing.
    let cut = 0.005 * stroke * narrow.problem.drive.weights()[0];
    let missed = narrow.force.rms_error_n;
    assert!(missed > 0.05 * cut && missed < cut, "{missed} N of {cut} N");
}

/// The width of a flat face limits the velocities of the law, which are the displacements of the contact.
#[test]
fn a_face_is_kept_within_its_width_by_the_law() {
    let free = synthesise(&scene_of(HUMP, &[]), None).unwrap();
    let width = free.cam.face_width().unwrap();
    let held = synthesise(&scene_of(HUMP, &["limits.face_width=19 mm"]), None).unwrap();
    assert!(
        width > 0.0195 && good(&held),
        "{}",
        held.reason(gaitcam::wording::Language::En)
    );
    assert!((held.cam.face_width().unwrap() - 0.019).abs() < 1e-9);
}

/// The curvature of a roller cam is reached for any radius that a law can have, not only for some.
#[test]
fn a_rollers_curvature_is_reached_whatever_it_is() {
    for rho in [15.8, 16.0, 17.0, 18.0, 19.0, 20.0, 20.5] {
        let limit = format!("limits.curvature={rho} mm");
        let changes = [
            "cam.follower=roller-translating",
            "cam.roller_radius=10 mm",
            "cam.base_radius=20 mm",
            "cam.offset=0 mm",
            "limits.pressure_angle=none",
            limit.as_str(),
        ];
        let design = synthesise(&scene_of(HUMP, &changes), None).unwrap();
        assert!(
            good(&design),
            "{rho}: {}",
            design.reason(gaitcam::wording::Language::En)
        );
        assert!(design.cam.curvature().convex.value >= 1e-3 * rho * (1.0 - 1e-8));
    }
}

/// A limit on one side leaves the other side free, as in the closed form of theory §6. The other side has its usual bound.
#[test]
fn a_pressure_angle_on_one_side_leaves_the_other_its_usual_bound() {
    let text = r#"
        name = "one side"
        [drive]
        kind = "fixed-axis"
        speed = "60 rpm"
        [law]
        family = "program"
        [[law.segment]]
        motion = "3-4-5"
        lift = "10 mm"
        angle = "60 deg"
        [[law.segment]]
        motion = "3-4-5"
        lift = "-10 mm"
        angle = "60 deg"
        [[law.segment]]
        motion = "dwell"
        angle = "240 deg"
        [cam]
        follower = "roller-translating"
        roller_radius = "0.1 mm"
        offset = "auto"
        [limits]
        pressure_angle_rise = "30 deg"
    "#;
    let design = synthesise(&scene_of(text, &[]), None).unwrap();
    // The smallest circle that keeps |φ| in the rise and the usual bound in the fall, by a dense scan.
    let law = &design.cam.law;
    let motion: Vec<_> = (0..20_000)
        .map(|i| law.svaj(std::f64::consts::TAU * f64::from(i) / 2e4))
        .filter(|at| at.v != 0.0)
        .collect();
    // Both are 30°: above its usual bound the fall would not be acceptable.
    let tangent = 30_f64.to_radians().tan();
    let radius = |offset: f64| {
        let depth = motion.iter().fold(0.0, |depth, at| {
            f64::max(depth, (at.v - offset).abs() / tangent - at.s)
        });
        depth.hypot(offset)
    };
    let least = (0..4_000)
        .map(|i| radius(-0.02 + 1e-5 * f64::from(i)))
        .fold(f64::INFINITY, f64::min);
    let own = design.cam.follower.prime_radius();
    assert!((own / least - 1.0).abs() < 1e-5, "{own} {least}");
    // Theory §6: 2.63648 h for 60° and 30° on both sides.
    assert!((own - 2.63648e-2).abs() < 1e-7, "{own}");
    // Neither side limited: the usual rule, and a word on it.
    let unsaid = text.replace("pressure_angle_rise = \"30 deg\"", "");
    let design = synthesise(&scene_of(&unsaid, &[]), None).unwrap();
    assert!(
        design
            .notes
            .iter()
            .any(|n| matches!(n, Note::UsualPressureAngle { .. })),
        "{:?}",
        design.remarks(gaitcam::wording::Language::En)
    );
}

#[test]
fn a_cam_that_would_have_to_pull_is_for_lower_speeds() {
    let text = r#"
        name = "eccentric"
        [drive]
        kind = "moving-axis"
        mass = "1 kg"
        speed = "35 rad/s"
        [law]
        family = "program"
        [[law.segment]]
        motion = "simple-harmonic"
        lift = "20 mm"
        angle = "180 deg"
        [[law.segment]]
        motion = "simple-harmonic"
        lift = "-20 mm"
        angle = "180 deg"
        [cam]
        follower = "flat-translating"
        base_radius = "20 mm"
    "#;
    let fast = synthesise(&scene_of(text, &[]), None).unwrap();
    assert_eq!(fast.verdict.name(), "unacceptable");
    // √(g/e) with e = 10 mm (theory §10).
    let Reason::LiftsOffAsPrescribed { speed, .. } = fast.reasons[0] else {
        panic!("{}", fast.reason(gaitcam::wording::Language::En));
    };
    assert!(
        (speed.value - 31.321).abs() < 1e-3,
        "{}",
        fast.reason(gaitcam::wording::Language::En)
    );
    let slow = synthesise(&scene_of(text, &["drive.speed=31.3 rad/s"]), None).unwrap();
    assert_eq!(
        slow.verdict.name(),
        "acceptable",
        "{}",
        slow.reason(gaitcam::wording::Language::En)
    );
}

#[test]
fn a_profile_that_comes_to_a_point_is_not_called_acceptable() {
    let design = synthesise(&scene_of(HUMP, &["cam.base_radius=auto"]), None).unwrap();
    assert!(design.cam.curvature().convex.value.abs() < 1e-12);
    assert!(
        matches!(design.reasons[..], [Reason::Cusp { .. }]),
        "{}",
        design.reason(gaitcam::wording::Language::En)
    );
    let round = ["cam.base_radius=auto", "limits.curvature=2 mm"];
    let design = synthesise(&scene_of(HUMP, &round), None).unwrap();
    assert_eq!(design.verdict.name(), "acceptable");
}

/// Two limits that are infeasible each by itself. No single change is sufficient, but a common relative change of both is.
#[test]
fn two_impossible_limits_are_relaxed_together() {
    let changes = ["limits.velocity=0.04 m/s", "limits.face_width=10 mm"];
    let scene = scene_of(HUMP, &changes);
    let design = synthesise(&scene, None).unwrap().relaxed();
    assert!(
        design.relaxations.is_empty(),
        "{}",
        design.reason(gaitcam::wording::Language::En)
    );
    assert!(
        matches!(design.reasons.last(), Some(Reason::AllTogether { .. })),
        "{}",
        design.reason(gaitcam::wording::Language::En)
    );
    let infeasible = design.infeasible.unwrap();
    assert!(infeasible.relaxations.iter().all(|r| r.to.is_none()));
    let settings: Vec<String> = design
        .together
        .iter()
        .filter(|r| !r.limit.name().starts_with("cam."))
        .map(|r| assignment(r.limit.name(), r.to.unwrap()))
        .collect();
    assert_eq!(settings.len(), 2);
    let size = design
        .together
        .iter()
        .find(|r| r.limit.name() == "cam.base_radius");
    let size = assignment("cam.base_radius", size.unwrap().to.unwrap());
    let all: Vec<&str> = settings
        .iter()
        .map(String::as_str)
        .chain([size.as_str()])
        .collect();
    assert!(good(&synthesise(&scene_of(HUMP, &all), None).unwrap()));
}

/// The limits are not convex, and the search for feasible designs ends at other laws than the optimum. The suggested changes are sufficient for the
/// optimum.
#[test]
fn suggestions_for_arms_are_sufficient_for_the_optimum() {
    const ARM: &str = r#"
name = "arm"
[gait]
model = "young"
step_frequency = "1.85 Hz"
body_weight = "700 N"
[drive]
kind = "hydraulic"
piston_radius = "13.2 mm"
pressure_per_volume = "2.68e10 Pa/m^3"
lever = "133.5 mm"
[cam]
follower = "flat-oscillating"
pivot_distance = "167.4 mm"
base_radius = "44.5 mm"
bore = "12 mm"
[limits]
curvature = "15 mm"
face_width = "65 mm"
torque = "44 N m"
[accuracy]
rms = "0.9 %"
"#;
    let cases: [&[(&str, &str)]; 3] = [
        &[],
        &[("gait.step_frequency", "1.7 Hz")],
        &[
            ("gait.step_frequency", "2 Hz"),
            ("limits.face_width", "70 mm"),
        ],
    ];
    let mut suggested = 0;
    for changes in cases {
        let start = gaitcam_test_support::scene::<&str>(ARM, &[]).unwrap();
        let scene = (changes.iter()).fold(start, |s, (key, value)| s.with(key, value).unwrap());
        let design = |scene: &scene::Scene| {
            synthesise(scene, scene.model_force().unwrap().as_ref()).unwrap()
        };
        let refused = design(&scene).relaxed();
        for relaxation in &refused.relaxations {
            let to = relaxation.to.unwrap();
            let text = assignment(relaxation.limit.name(), to);
            let (key, value) = text.split_once('=').unwrap();
            let eased = design(&scene.with(key, value).unwrap());
            assert!(good(&eased), "{changes:?} {text} {:?}", eased.reasons);
            suggested += 1;
        }
    }
    assert!(suggested >= 3, "{suggested}");
}

//! If a limit is set to the value of an accepted design, a feasible cam exists. The new design must be accepted, with the same objective or a smaller
//! one.

use gaitcam::cam::Verdict;
use gaitcam::synth::Design;

/// Relative distance of a limit from the value that is known to be feasible.
const ROOM: f64 = 1e-3;
/// Maximum relative increase of the optimum with such a limit: sequences end at local optima.
const WORSE: f64 = 2e-3;
/// Fractions of its free value to which a limit is tightened.
const TIGHT: [f64; 2] = [0.95, 0.8];

const WALK: &str = r#"
name = "walk"
[gait]
model = "young"
step_frequency = "2.1 Hz"
[accuracy]
rms = "none"
[limits]
force_min = "none"
curvature = "4 mm"
[law]
family = "spline"
degree = 5
"#;

const POINTS: &str = r#"
name = "points"
[drive]
kind = "fixed-axis"
speed = "14 rad/s"
mass = "1 kg"
spring_rate = "2 N/mm"
preload = "40 N"
[limits]
force_min = "none"
curvature = "4 mm"
[law]
family = "spline"
degree = 6
[[law.point]]
angle = "125 deg"
lift = "20 mm"
[[law.dwell]]
from = "250 deg"
to = "360 deg"
lift = "0 mm"
"#;

const ARM: &str = r#"
name = "arm"
[drive]
kind = "fixed-axis"
speed = "10 rad/s"
[limits]
force_min = "none"
curvature = "5 mm"
[law]
family = "spline"
degree = 5
[[law.point]]
angle = "130 deg"
lift = "13 deg"
[[law.dwell]]
from = "260 deg"
to = "360 deg"
lift = "0 deg"
[cam]
pivot_distance = "80 mm"
"#;

const FLAT: &[&str] = &["cam.follower=flat-translating"];
const MUSHROOM: &[&str] = &["cam.follower=mushroom-translating", "cam.arc_radius=60 mm"];
const ROLLER: &[&str] = &[
    "cam.follower=roller-translating",
    "cam.roller_radius=8 mm",
    "limits.pressure_angle=35 deg",
];
const ROLLER_ARM: &[&str] = &[
    "cam.follower=roller-oscillating",
    "cam.arm=65 mm",
    "cam.roller_radius=8 mm",
    "limits.pressure_angle=35 deg",
];
const FACE: &[&str] = &["cam.follower=flat-oscillating", "cam.face_offset=5 mm"];

/// Scene text, follower, number of spans and objective.
const SCENES: &[(&str, &[&str], u32, &str)] = &[
    (WALK, FLAT, 12, "force-error"),
    (WALK, MUSHROOM, 17, "force-error"),
    (WALK, ROLLER, 20, "force-error"),
    (POINTS, FLAT, 25, "jerk"),
    (POINTS, MUSHROOM, 17, "size"),
    (POINTS, ROLLER, 16, "acceleration"),
    (POINTS, ROLLER, 16, "size"),
    (ARM, ROLLER_ARM, 16, "size"),
    (ARM, FACE, 10, "size"),
    (ARM, FACE, 26, "jerk"),
];

/// Design of a scene with limits, each by its key and its value in SI.
fn design(scene: &(&str, &[&str], u32, &str), limits: &[(&str, f64)]) -> Design {
    let &(text, follower, spans, minimise) = scene;
    let mut changes: Vec<String> = follower.iter().map(|c| c.to_string()).collect();
    changes.push(format!("law.spans={spans}"));
    changes.push(format!("law.minimise={minimise}"));
    let swings = text == ARM;
    let unit = |key: &str| match key {
        "stroke" if swings => "rad",
        "velocity" if swings => "rad/s",
        "acceleration" if swings => "rad/s^2",
        "jerk" if swings => "rad/s^3",
        "velocity" => "m/s",
        "acceleration" => "m/s^2",
        "jerk" => "m/s^3",
        "torque" => "N m",
        _ => "m",
    };
    let of_limit = |&(key, value): &(&str, f64)| format!("limits.{key}={value:e} {}", unit(key));
    changes.extend(limits.iter().map(of_limit));
    gaitcam_test_support::design(text, &changes).unwrap()
}

/// Values of all limited quantities of a design.
fn values(design: &Design) -> Vec<(&'static str, f64)> {
    let law = &design.cam.law;
    let speed = design.problem.drive.speed;
    let peak = |order: usize| {
        let (low, high) = law.extremes(order);
        high.value.max(-low.value) * speed.powi(order as i32)
    };
    let torque = |at: f64| {
        let at = law.svaj(at);
        (design.problem.drive.force(at) * at.v).abs()
    };
    let angles = (0..36_000).map(|i| f64::from(i) * std::f64::consts::TAU / 36_000.0);
    let mut out = vec![
        ("stroke", law.stroke()),
        ("velocity", peak(1)),
        ("acceleration", peak(2)),
        ("jerk", peak(3)),
        ("torque", angles.map(torque).fold(0.0, f64::max)),
        ("prime_radius", design.cam.follower.prime_radius()),
    ];
    out.extend(design.cam.face_width().map(|width| ("face_width", width)));
    out.retain(|(_, value)| *value > 0.0);
    out
}

/// Value of the scene's objective, measured on the design.
fn minimised(design: &Design, minimise: &str) -> f64 {
    match minimise {
        "force-error" => design.force.rms_error_n,
        "size" => design.cam.follower.prime_radius(),
        _ => design.solver.certificate.as_ref().unwrap().size,
    }
}

#[test]
fn a_limit_that_a_known_cam_keeps_is_accepted_and_costs_nothing() {
    let (mut tried, mut tight) = (0, 0);
    for scene in SCENES {
        let minimise = scene.3;
        let free = design(scene, &[]);
        assert_eq!(free.verdict, Verdict::Acceptable, "{scene:?}");
        let mut known = vec![(Vec::new(), free)];
        for (key, value) in values(&known[0].1) {
            for share in TIGHT {
                let limits = vec![(key, share * value)];
                let found = design(scene, &limits);
                if found.verdict == Verdict::Acceptable {
                    known.push((limits, found));
                    tight += 1;
                    break;
                }
            }
        }
        for (limits, witness) in &known {
            for (key, value) in values(witness) {
                if limits.iter().any(|l| l.0 == key) {
                    continue;
                }
                let mut more = limits.clone();
                more.push((key, value * (1.0 + ROOM)));
                let told = format!("{} {minimise} {more:?}", scene.1[0]);
                let found = design(scene, &more);
                assert_eq!(
                    found.verdict,
                    Verdict::Acceptable,
                    "{told}: {:?}",
                    found.reasons
                );
                let (before, after) = (minimised(witness, minimise), minimised(&found, minimise));
                assert!(
                    after <= before * (1.0 + WORSE) + 1e-9,
                    "{told}: {before} {after}"
                );
                let own = found.checks.iter().find(|c| c.name.name() == key).unwrap();
                assert!(own.worst <= value * (1.0 + ROOM) * (1.0 + 1e-6), "{told}");
                tried += 1;
            }
        }
    }
    assert!(tight > 40 && tried > 280, "{tight} {tried}");
}

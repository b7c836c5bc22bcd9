//! Polydyne cams: with a compliant follower, the cam is designed so that the end of the follower moves by the law.

use gaitcam::dynamics::{Machine, Model, Run, simulate};
use gaitcam::scene;
use gaitcam::synth::{Design, synthesise};
use gaitcam_test_support::design_of;
use std::f64::consts::TAU;

const SOFT: [&str; 2] = ["machine.natural_frequency=12 Hz", "law.degree=7"];
const POINTS: usize = 1440;

/// RMS difference between the force at the end of the follower and the force in law.csv, N. Each harmonic of the emitted lift is multiplied by the
/// transfer function of the follower: y = s (k₁ + i c₁ nω)/(k₁ − m n²ω² + i c₁ nω) (moving axis).
fn miss(s: &Design, stiffness: f64, damping: f64) -> f64 {
    let (m, w) = (s.problem.drive.mass, s.problem.drive.speed);
    let lifts: Vec<f64> = (0..POINTS)
        .map(|i| s.cam.law.svaj(TAU * i as f64 / POINTS as f64).s)
        .collect();
    let mut acceleration = vec![0.0; POINTS];
    for n in 1..80 {
        let (mut re, mut im) = (0.0, 0.0);
        for (i, x) in lifts.iter().enumerate() {
            let (sin, cos) = (TAU * ((n * i) % POINTS) as f64 / POINTS as f64).sin_cos();
            re += 2.0 / POINTS as f64 * x * cos;
            im -= 2.0 / POINTS as f64 * x * sin;
        }
        let nw = n as f64 * w;
        let (top, bottom) = (
            (stiffness, damping * nw),
            (stiffness - m * nw * nw, damping * nw),
        );
        let square = bottom.0.powi(2) + bottom.1.powi(2);
        let gain = (
            (top.0 * bottom.0 + top.1 * bottom.1) / square,
            (top.1 * bottom.0 - top.0 * bottom.1) / square,
        );
        let end = (re * gain.0 - im * gain.1, re * gain.1 + im * gain.0);
        for (i, a) in acceleration.iter_mut().enumerate() {
            let (sin, cos) = (TAU * ((n * i) % POINTS) as f64 / POINTS as f64).sin_cos();
            *a -= nw * nw * (end.0 * cos - end.1 * sin);
        }
    }
    let square: f64 = (0..POINTS)
        .map(|i| {
            let stated = s
                .problem
                .drive
                .force(s.pressing().svaj(TAU * i as f64 / POINTS as f64));
            (m * (9.81 + acceleration[i]) - stated).powi(2)
        })
        .sum();
    (square / POINTS as f64).sqrt()
}

/// Force error of the emitted profile in the flexible model, N RMS.
fn run(s: &Design, scene: &scene::Scene) -> f64 {
    let target = s.target().unwrap();
    let run = Run {
        profile: s.cam.profile(POINTS),
        target: Some(
            (0..POINTS)
                .map(|i| target.at(TAU * i as f64 / POINTS as f64))
                .collect(),
        ),
        cam: s.cam.clone(),
        drive: s.problem.drive,
        machine: Machine {
            train: scene.machine.train(&s.problem.drive).unwrap(),
            ..Machine::default()
        },
    };
    simulate(&run, Model::Flexible)
        .unwrap()
        .force
        .rms_error
        .unwrap()
}

#[test]
fn the_end_of_a_soft_follower_gives_the_force_that_the_plain_cam_misses() {
    let plain = design_of(scene::DEFAULT, &SOFT);
    let changes = [SOFT[0], SOFT[1], "law.polydyne=true"];
    let s = design_of(scene::DEFAULT, &changes);
    let scene = gaitcam_test_support::scene(scene::DEFAULT, &changes).unwrap();
    assert!(s.checks.iter().all(|c| c.pass), "{:?}", s.checks);
    // The end's law, and with it the stated force, is the law that a stiff machine would have.
    assert!((s.force.rms_error_n - plain.force.rms_error_n).abs() < 1e-9);
    let stiffness = s.problem.drive.mass * (TAU * 12.0).powi(2);
    let damping = 2.0 * 0.05 * s.problem.drive.mass * TAU * 12.0;
    let (own, other) = (
        miss(&s, stiffness, damping),
        miss(&plain, stiffness, damping),
    );
    assert!(other > 10.0, "{other}");
    assert!(own < 0.02 * other, "{own} against {other}");
    // What the summary says of both is what the transfer says.
    let end = s.end.as_ref().unwrap();
    assert!((end.miss.unwrap().force_rms - own).abs() < 1e-3 * other);
    assert!((end.plain_miss.unwrap().force_rms - other).abs() < 1e-3 * other);
    // And the emitted profile, run, comes as near to the target as the law promises.
    let (promised, ran) = (s.force.rms_error_n, run(&s, &scene));
    assert!((ran - promised).abs() < 0.02 * promised, "{ran} {promised}");
    assert!(run(&plain, &scene) > 4.0 * promised);
}

#[test]
fn without_damping_nothing_is_missed() {
    let s = design_of(
        scene::DEFAULT,
        &[SOFT[0], "machine.damping_ratio=0", "law.polydyne=true"],
    );
    let stiffness = s.problem.drive.mass * (TAU * 12.0).powi(2);
    assert!(miss(&s, stiffness, 0.0) < 1e-3);
    assert!(s.end.unwrap().miss.unwrap().force_max < 1e-6);
}

#[test]
fn limits_are_those_of_the_cam_not_of_the_end() {
    let base = [
        SOFT[0],
        SOFT[1],
        "law.polydyne=true",
        "law.spans=12",
        "accuracy.rms=50 %",
    ];
    let free = design_of(scene::DEFAULT, &base);
    for (key, order, unit) in [
        ("stroke", 0, "m"),
        ("acceleration", 2, "m/s^2"),
        ("jerk", 3, "m/s^3"),
    ] {
        let (low, high) = free.cam.law.extremes(order);
        let most = match order {
            0 => high.value - low.value,
            _ => high.value.max(-low.value) * free.problem.drive.speed.powi(order as i32),
        };
        let change = format!("limits.{key}={} {unit}", 0.95 * most);
        let s = design_of(
            scene::DEFAULT,
            &[base.as_slice(), &[change.as_str()]].concat(),
        );
        let check = s.checks.iter().find(|c| c.name.name() == key).unwrap();
        assert!(check.pass, "{check:?}");
        assert!(check.worst > 0.999 * check.limit, "{check:?}");
        // The emitted law, sampled, keeps it; the end's differs from it.
        let per_time = s.problem.drive.speed.powi(order as i32);
        let values = (0..20_011).map(|i| {
            let at = s.cam.law.svaj(TAU * f64::from(i) / 20_011.0);
            [at.s, at.v, at.a, at.j][order] * per_time
        });
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| {
            (l.min(x), h.max(x))
        });
        let worst = if order == 0 {
            high - low
        } else {
            high.max(-low)
        };
        assert!(worst <= check.limit * (1.0 + 1e-6));
    }
}

const RISE: &str = r#"
name = "soft"
[drive]
kind = "fixed-axis"
mass = "2 kg"
spring_rate = "3 kN/m"
preload = "80 N"
speed = "300 rpm"
[machine]
stiffness = "60 kN/m"
damping_ratio = 0
[law]
polydyne = true
family = "program"
[[law.segment]]
angle = "60 deg"
[[law.segment]]
motion = "5-6-7-8-9"
lift = "12 mm"
angle = "120 deg"
[[law.segment]]
angle = "60 deg"
[[law.segment]]
motion = "5-6-7-8-9"
lift = "-12 mm"
angle = "120 deg"
[cam]
follower = "flat-translating"
base_radius = "60 mm"
"#;

#[test]
fn a_programme_reaches_the_end_and_its_dwells_stay_dwells() {
    let s = design_of(RISE, &[]);
    let end = s.end.as_ref().unwrap();
    assert!(end.miss.unwrap().lift.value < 1e-12, "{:?}", end.miss);
    assert!(end.plain_miss.unwrap().lift.value > 1e-4);
    // On the lower dwell the train gives by the preload, on the upper one by the spring as well.
    let give = |degrees: f64| {
        let theta = degrees.to_radians();
        s.cam.law.svaj(theta).s - end.law.svaj(theta).s
    };
    assert!((give(30.0) - 80.0 / 60e3).abs() < 1e-15);
    assert!((give(210.0) - (80.0 + 3000.0 * 0.012) / 60e3).abs() < 1e-15);
    let joints = s.cam.law.joints();
    let size = s.cam.law.extremes(2).1.value;
    assert!(joints.iter().all(|j| j.jump.a.abs() < 1e-9 * size));
}

#[test]
fn what_a_polydyne_cam_cannot_be_is_refused_in_words() {
    let fault = |change: &str| match gaitcam_test_support::scene(RISE, &[change]) {
        Err(e) => e.to_string(),
        Ok(scene) => synthesise(&scene, None).unwrap_err().to_string(),
    };
    let mut rough: toml::Table = RISE.parse().unwrap();
    rough["law"]["segment"][1]["motion"] = "cycloidal".into();
    let rough = synthesise(&scene::read(&rough).unwrap(), None)
        .unwrap_err()
        .to_string();
    assert!(
        rough.contains("law.polydyne") && rough.contains("jerk of the law is discontinuous at 60°"),
        "{rough}"
    );
    for (change, words) in [
        ("machine.natural_frequency=60 Hz", "remove one of the two"),
        ("machine.stiffness=0 N/m", "not positive"),
        ("law.family=double-harmonic", "four continuous derivatives"),
        ("law.polydyne=yes", "true or false"),
    ] {
        let got = fault(change);
        assert!(got.contains(words), "{change}: {got}");
    }
    let soft = ["law.polydyne=true"];
    let got = gaitcam_test_support::scene(scene::DEFAULT, &soft)
        .unwrap_err()
        .to_string();
    assert!(
        got.contains("machine.stiffness") && got.contains("9 kN/m"),
        "{got}"
    );
    let low = [
        "law.polydyne=true",
        "machine.stiffness=90 kN/m",
        "law.degree=4",
    ];
    let got = gaitcam_test_support::scene(scene::DEFAULT, &low)
        .unwrap_err()
        .to_string();
    assert!(
        got.contains("law.degree") && got.contains("degree 5"),
        "{got}"
    );
}

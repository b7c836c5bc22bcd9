//! Several logs together. A second speed separates mass and stiffness; copies and logs of another machine are rejected.

use std::f64::consts::TAU;

use gaitcam::identify::{Identified, Log, LogColumns, Parameter, identify, recut};
use gaitcam::scene::{self, Scene};
use gaitcam::synth::{Design, Search, synthesise};

use super::scatter;

/// Test bench with a spring of 20 N/mm that presses the follower on the cam.
fn bench() -> (Scene, Design) {
    let changes = [
        "drive.kind=fixed-axis",
        "drive.mass=5 kg",
        "drive.spring_rate=20 N/mm",
        "drive.preload=500 N",
        "drive.damping=20 N s/m",
        "drive.speed=111 rpm",
        "accuracy.rms=none",
        "law.spans=16",
        "law.family=spline",
    ];
    let text = scene::DEFAULT
        .replace("mass = \"auto\"\n", "")
        .replace("kind = \"moving-axis\"\n", "");
    let changes = changes.map(String::from);
    let scene = gaitcam_test_support::scene(&text, &changes).unwrap();
    let force = scene.model_force().unwrap();
    let design = synthesise(&scene, force.as_ref()).unwrap();
    (scene, design)
}

/// Simulated machine: its parameters, a force outside the model, and its recorder.
#[derive(Clone, Copy)]
struct Hidden {
    preload: f64,
    mass: f64,
    rate: f64,
    damping: f64,
    /// Amplitude of the force outside the model, N, in harmonic 3.
    extra: f64,
    /// Noise of the load cell, ±N.
    noise: f64,
    has_angle: bool,
    seed: usize,
}

const MACHINE: Hidden = Hidden {
    preload: 507.0,
    mass: 5.3,
    rate: 20_600.0,
    damping: 35.0,
    extra: 0.0,
    noise: 1.0,
    has_angle: true,
    seed: 0,
};

/// Log of 30 turns with 200 samples each, at a multiple of the design speed.
fn log(design: &Design, machine: Hidden, by: f64) -> Log {
    let speed = by * design.problem.drive.speed;
    let step = TAU / speed / 200.37;
    let time: Vec<f64> = (0..6000).map(|i| step * f64::from(i)).collect();
    let first = if machine.has_angle { 0.0 } else { 1.3 * by };
    let theta: Vec<f64> = time.iter().map(|t| first + speed * t).collect();
    let force = theta.iter().enumerate().map(|(i, x)| {
        let at = design.cam.law.svaj(*x);
        machine.preload
            + machine.rate * at.s
            + machine.mass * speed * speed * at.a
            + machine.damping * speed * at.v
            + machine.extra * (3.0 * x + 0.7 * machine.seed as f64).sin()
            + machine.noise * scatter(i + 10_007 * machine.seed + (1e6 * by) as usize)
    });
    let columns = LogColumns {
        force: force.collect(),
        theta: machine.has_angle.then_some(theta),
        time: Some(time),
        ..LogColumns::default()
    };
    Log::new(format!("at {by}.csv").as_ref(), columns).unwrap()
}

fn parameter(found: &Identified, key: &str) -> Parameter {
    *found.parameters.iter().find(|p| p.key == key).unwrap()
}

fn width(p: &Parameter) -> f64 {
    p.high
        .zip(p.low)
        .map_or(f64::INFINITY, |(high, low)| high - low)
}

#[test]
fn suggested_second_speed_separates_mass_and_stiffness() {
    let (scene, design) = bench();
    let truths = |m: &Hidden| [("drive.mass", m.mass), ("drive.spring_rate", m.rate)];
    let (mut kept, mut broken, mut covered, mut all) = (0, 0, 0, 0);
    for seed in 0..16 {
        let machine = Hidden {
            mass: 5.0 + 0.1 * seed as f64,
            rate: 20_000.0 + 150.0 * seed as f64,
            damping: 10.0 + 3.0 * seed as f64,
            extra: 1.0 + (seed % 4) as f64,
            has_angle: seed % 2 == 0,
            seed,
            ..MACHINE
        };
        let first = log(&design, machine, 1.0);
        let alone = identify(&design, &scene, std::slice::from_ref(&first)).unwrap();
        assert!(!parameter(&alone, "drive.mass").identifiable, "{seed}");
        let run = alone.next_run.clone().unwrap();
        assert!(run.identifies.contains(&"drive.mass"), "{seed}: {run:?}");
        let second = log(&design, machine, run.relative_speed);
        let both = identify(&design, &scene, &[first, second]).unwrap();
        for key in &run.identifies {
            match parameter(&both, key).identifiable {
                true => kept += 1,
                false => broken += 1,
            }
        }
        for (key, truth) in truths(&machine) {
            let [one, two] = [&alone, &both].map(|found| parameter(found, key));
            println!(
                "{seed} at {}: {key} {truth}: {:.3?} … {:.3?}, then {:.3?} … {:.3?}",
                run.relative_speed, one.low, one.high, two.low, two.high
            );
            assert!(width(&two) < 0.5 * width(&one), "{seed} {one:?} {two:?}");
            all += 1;
            covered += usize::from(two.low.unwrap() <= truth && truth <= two.high.unwrap());
        }
    }
    println!("{kept} kept, {broken} broken, {covered} of {all} intervals hold");
    assert_eq!(broken, 0);
    assert!(kept >= 32 && 10 * covered >= 9 * all);
}

#[test]
fn mass_and_spring_of_a_noiseless_machine_are_exact_from_two_speeds() {
    let (scene, design) = bench();
    for has_angle in [true, false] {
        let machine = Hidden {
            noise: 1e-6,
            has_angle,
            ..MACHINE
        };
        let logs = [1.0, 1.4].map(|by| log(&design, machine, by));
        let found = identify(&design, &scene, &logs).unwrap();
        for (key, truth) in [
            ("drive.preload", machine.preload),
            ("drive.mass", machine.mass),
            ("drive.spring_rate", machine.rate),
            ("drive.damping", machine.damping),
        ] {
            let p = parameter(&found, key);
            assert!((p.value / truth - 1.0).abs() < 2e-4, "{truth} {p:?}");
        }
        assert_eq!((found.logs.len(), found.cycles), (2, 58));
        let speeds = [0, 1].map(|i| found.logs[i].speed_rad_per_s);
        assert!((speeds[1] / speeds[0] - 1.4).abs() < 1e-6, "{speeds:?}");
    }
}

#[test]
fn order_of_logs_does_not_matter() {
    let (scene, design) = bench();
    let mut logs = [1.0, 1.2, 0.8].map(|by| log(&design, MACHINE, by)).to_vec();
    let first = identify(&design, &scene, &logs).unwrap();
    logs.reverse();
    let second = identify(&design, &scene, &logs).unwrap();
    for (a, b) in first.parameters.iter().zip(&second.parameters) {
        assert!(
            (a.value - b.value).abs() <= 1e-6 * a.value.abs(),
            "{a:?} {b:?}"
        );
    }
}

#[test]
fn copies_and_logs_of_another_machine_are_refused_with_numbers() {
    let (scene, design) = bench();
    let code = |logs: &[Log]| {
        let error = identify(&design, &scene, logs).unwrap_err();
        (error.code().to_string(), error.to_string())
    };
    let first = log(&design, MACHINE, 1.0);
    let (found, said) = code(&[first.clone(), first.clone()]);
    assert_eq!(found, "log-copy", "{said}");
    let softer = Hidden {
        rate: 14_000.0,
        ..MACHINE
    };
    for by in [1.0, 1.4] {
        let (found, said) = code(&[first.clone(), log(&design, softer, by)]);
        assert!(
            ["log-inconsistent", "log-other-machine"].contains(&found.as_str()),
            "{said}"
        );
        assert!(said.contains(&format!("at {by}.csv")), "{said}");
    }
    let preload = Hidden {
        preload: 560.0,
        ..MACHINE
    };
    let (found, said) = code(&[first.clone(), log(&design, preload, 1.3)]);
    println!("{found}: {said}");
    assert!(found.starts_with("log-"), "{said}");
    assert_eq!(code(&[]).0, "log-few-rows");
}

#[test]
fn next_cam_corrects_the_mean_error_of_the_logs_at_one_speed() {
    let (scene, design) = bench();
    let force = scene.model_force().unwrap();
    let machine = Hidden {
        extra: 6.0,
        ..MACHINE
    };
    let of = |by: f64, seed: usize| log(&design, Hidden { seed, ..machine }, by);
    let cut = |logs: &[Log]| recut(&design, &scene, force.as_ref(), logs, &Search::default());
    // The phase of the extra force is that of the seed: logs 0 and 9 are nearly alike (6.3 rad).
    let [one, two, fast] = [of(1.0, 0), of(1.001, 9), of(1.4, 0)];
    let alone = cut(std::slice::from_ref(&one)).unwrap();
    let together = cut(&[one.clone(), two]).unwrap();
    let other = cut(&[fast.clone(), one]).unwrap();
    println!("{:?} {:?} {:?}", alone.1, together.1, other.1);
    for figures in [together.1, other.1] {
        let ratio = figures.before_rms_n / alone.1.before_rms_n;
        assert!((ratio - 1.0).abs() < 0.03, "{figures:?} {:?}", alone.1);
    }
    assert_eq!(other.2.logs.len(), 2);
    assert_eq!(cut(&[fast]).unwrap_err().code(), "log-other-speed");
}

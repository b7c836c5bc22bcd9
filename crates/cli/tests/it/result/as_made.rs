//! A manufactured cam stays the same: `simulate` and `inspect` of a result change only the machine.

use std::f64::consts::PI;
use std::fs;

use serde_json::Value;

use crate::support::{gaitcam, object, stderr, stdout};

/// Scene with a force of two sines, so that the force of its cam is known at any speed: F = M g + (ω/ω₀)² f(θ).
const SCENE: &str = "name = \"shaker\"
[gait]
file = \"one.csv\"
feet = \"one\"
period = \"0.5 s\"
[drive]
kind = \"moving-axis\"
mass = \"auto\"
speed = \"120 rpm\"
";

/// Deviation of the force from its mean at a fraction of the turn, N.
fn swing(turn: f64) -> f64 {
    let theta = 2.0 * PI * turn;
    210.0 * theta.sin() + 60.0 * (2.0 * theta).sin()
}

/// Folder with the scene `scene.toml`, its recording, and the result `made`.
struct Shaker(tempfile::TempDir);

impl Shaker {
    fn new() -> Shaker {
        let shaker = Shaker(tempfile::tempdir().unwrap());
        let mut rows = String::from("time_s,force_n\n");
        for i in 0..=100 {
            let turn = f64::from(i) / 100.0;
            rows += &format!("{},{}\n", 0.5 * turn, 700.0 + swing(turn));
        }
        fs::write(shaker.path("one.csv"), rows).unwrap();
        let [scene, made] = ["scene.toml", "made"].map(|name| shaker.path(name));
        fs::write(&scene, SCENE).unwrap();
        let run = gaitcam(&["synth", &scene, "--out", &made, "--no-png"]);
        assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
        shaker
    }

    fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().unwrap().to_string()
    }
}

/// Largest deviation of the force from its mean, N.
fn largest_swing() -> f64 {
    (0..10_000)
        .map(|i| swing(f64::from(i) / 1e4))
        .fold(0.0, f64::max)
}

#[test]
fn a_result_runs_at_any_speed_with_the_cam_that_was_made() {
    let shaker = Shaker::new();
    let path = |name: &str| shaker.path(name);
    let made = path("made");
    let summary = path("made/summary.json");
    let most = largest_swing();
    let lift_off = 4.0 * PI * (700.0 / most).sqrt();
    for result in [&made, &summary] {
        for rpm in [60.0, 96.0, 150.0, 240.0] {
            let speed = format!("{rpm} rpm");
            let set = format!("drive.speed={rpm} rpm");
            for flags in [["--speed", &speed], ["--set", &set]] {
                let out = path("run");
                let run =
                    gaitcam(&[&["simulate", result, "--json", "--out", &out], &flags[..]].concat());
                let found = object(&run);
                let number = |at: &str| found.pointer(at).unwrap().as_f64().unwrap();
                let share = (rpm / 120.0_f64).powi(2);
                let lost = most * share > 700.0;
                assert_eq!(found["contact_lost"], lost, "{rpm} {flags:?}");
                if !lost {
                    let highest = 700.0 + most * share;
                    assert!(
                        (number("/force/max") - highest).abs() < 1.0,
                        "{rpm}: {highest}"
                    );
                }
                assert!((number("/speed_rad_per_s") - rpm * PI / 30.0).abs() < 1e-9);
                assert!((number("/liftoff_speed_rad_per_s") - lift_off).abs() < 0.05);
            }
        }
    }
}

#[test]
fn changes_that_would_be_another_cam_are_refused() {
    let shaker = Shaker::new();
    let path = |name: &str| shaker.path(name);
    let (made, summary) = (path("made"), path("made/summary.json"));
    for key in [
        "limits.stroke=10 mm",
        "cam.base_radius=40 mm",
        "gait.phase=10 deg",
        "law.spans=9",
    ] {
        for verb in [vec!["simulate", &made], vec!["inspect", &made, &summary]] {
            let run = gaitcam(&[verb, vec!["--set", key]].concat());
            assert_eq!(run.status.code(), Some(2), "{key}");
        }
        let said = stderr(&gaitcam(&["simulate", &made, "--set", key]));
        assert!(
            said.contains("finished") && said.contains(key.split('=').next().unwrap()),
            "{said}"
        );
    }
}

#[test]
fn a_scene_is_designed_anew_for_its_speed_and_run_at_that_of_the_flag() {
    let shaker = Shaker::new();
    let path = |name: &str| shaker.path(name);
    // A scene is designed anew for its speed, which is said; at --speed it is not.
    let scene = path("scene.toml");
    let anew = stdout(&gaitcam(&[
        "simulate",
        &scene,
        "--set",
        "drive.speed=96 rpm",
        "--out",
        &path("anew"),
    ]));
    assert!(anew.contains("use --speed to run it"), "{anew}");
    let same = object(&gaitcam(&[
        "simulate",
        &scene,
        "--speed",
        "96 rpm",
        "--json",
        "--out",
        &path("same"),
    ]));
    assert!((same["force"]["max"].as_f64().unwrap() - 700.0 - largest_swing() * 0.64).abs() < 1.0);
}

#[test]
fn measured_points_are_those_of_the_same_cam_at_every_speed() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let made = path("made");
    gaitcam(&[
        "synth",
        "scenes/heel_tester.toml",
        "--out",
        &made,
        "--no-png",
    ]);
    let profile = fs::read_to_string(path("made/profile.csv")).unwrap();
    let points = profile.lines().skip(1).map(|row| {
        let cells: Vec<&str> = row.split(',').collect();
        format!("{},{}\n", cells[1], cells[2])
    });
    fs::write(
        path("points.csv"),
        "x_m,y_m\n".to_string() + &points.collect::<String>(),
    )
    .unwrap();
    let at = |flags: &[&str]| {
        let arguments = ["inspect", &made, &path("points.csv"), "--json"].map(str::to_string);
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        object(&gaitcam(&[&arguments, flags].concat()))
    };
    let at = |speed: &str| at(&["--set", &format!("drive.speed={speed}")]);
    let (fast, slow) = (at("120 rpm"), at("60 rpm"));
    assert!(slow["deviation"]["rms_m"].as_f64().unwrap() < 1e-8);
    let peak = |run: &serde_json::Value| run["made"]["acceleration_max"].as_f64().unwrap();
    assert!((peak(&fast) / peak(&slow) - 4.0).abs() < 1e-6);
}

#[test]
fn a_table_of_speeds_has_the_load_factors_that_grow_with_the_square_of_the_speed() {
    let shaker = Shaker::new();
    let (made, out) = (shaker.path("made"), shaker.path("speeds"));
    let run = gaitcam(&["simulate", &made, "--speeds", "1:2:3 Hz", "--out", &out]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let table = fs::read_to_string(format!("{out}/speeds.csv")).unwrap();
    let rows: Vec<Vec<f64>> = (table.lines().skip(1))
        .map(|line| {
            line.split(',')
                .take(4)
                .map(|x| x.parse().unwrap())
                .collect()
        })
        .collect();
    assert_eq!(rows.len(), 3);
    for (row, turns) in rows.iter().zip([1.0, 1.5, 2.0_f64]) {
        assert!((row[0] - 2.0 * PI * turns).abs() < 1e-9);
        // F = M g + (ω/ω₀)² f(θ), ω₀ = 120 rpm; the target stays f(θ).
        let share = (turns / 2.0).powi(2);
        let [rms, first, second] = [row[1], row[2], row[3]];
        let own = 0.005 * 700.0;
        assert!((first - share * 210.0 / 700.0).abs() < 0.006, "{first}");
        assert!((second - share * 60.0 / 700.0).abs() < 0.006, "{second}");
        let swing = (210.0_f64.powi(2) / 2.0 + 60.0_f64.powi(2) / 2.0).sqrt();
        assert!((rms - (1.0 - share) * swing).abs() < 1.5 * own, "{rms}");
    }
    for faulty in ["1 Hz:2 Hz", "1 Hz:2 Hz:1", "1 mm:2 mm:3", "0 Hz:2 Hz:3"] {
        let run = gaitcam(&["simulate", &made, "--speeds", faulty, "--out", &out]);
        assert_eq!(run.status.code(), Some(2), "{faulty}");
        assert!(stderr(&run).contains("--speeds"), "{faulty}");
    }
}

/// The cells of `speeds.csv` without its header.
fn table_of_speeds(folder: &str) -> Vec<Vec<String>> {
    let table = fs::read_to_string(format!("{folder}/speeds.csv")).unwrap();
    let cells = |line: &str| line.split(',').map(str::to_string).collect();
    table.lines().skip(1).map(cells).collect()
}

#[test]
fn own_load_factors_at_other_speeds_grow_by_its_square_and_stay_wanted() {
    let shaker = Shaker::new();
    let (made, out) = (shaker.path("own"), shaker.path("own_speeds"));
    let factors = "gait.harmonics=[0.4, \"0.1 at -90 deg\", \"0.1 at -90 deg\"]";
    let family = "law.family=harmonic";
    let set = [
        "synth",
        "footbridge",
        "--set",
        factors,
        "--set",
        family,
        "--out",
        &made,
    ];
    assert_eq!(gaitcam(&set).status.code(), Some(0));
    let run = gaitcam(&["simulate", &made, "--speeds", "1.4:2.3:4 Hz", "--out", &out]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    // F = G + r² (f − G), r the part of the speed designed for; f keeps its factors at every step frequency.
    let swing = 700.0 * ((0.4_f64.powi(2) + 2.0 * 0.1_f64.powi(2)) / 2.0).sqrt();
    for (row, turns) in table_of_speeds(&out).iter().zip([1.4, 1.7, 2.0, 2.3]) {
        let share: f64 = (turns / 1.85_f64).powi(2);
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        assert!(
            (number(1) - (share - 1.0).abs() * swing).abs() < 1e-3,
            "{row:?}"
        );
        for (i, factor) in [(2, 0.4), (3, 0.1), (4, 0.1), (5, 0.0)] {
            assert!((number(i) - share * factor).abs() < 1e-6, "{row:?}");
        }
    }
    for picture in ["speeds.svg", "speeds.png"] {
        assert!(fs::metadata(format!("{out}/{picture}")).unwrap().len() > 1000);
    }
}

#[test]
fn a_row_of_a_table_of_speeds_is_the_run_at_that_speed_with_and_without_a_motor() {
    let shaker = Shaker::new();
    let (made, out) = (shaker.path("made"), shaker.path("out"));
    assert_eq!(
        gaitcam(&["synth", "footbridge", "--out", &made])
            .status
            .code(),
        Some(0)
    );
    let motor = [
        "--set",
        "machine.motor.slope=10 N m s/rad",
        "--set",
        "machine.inertia=0.5 kg m^2",
    ];
    for machine in [&[][..], &motor[..]] {
        let run = |what: &[&str], code: i32| {
            let run = gaitcam(&[&["simulate", &made, "--out", &out], what, machine].concat());
            assert_eq!(run.status.code(), Some(code), "{}", stderr(&run));
            run
        };
        run(&["--speeds", "84 rpm:108 rpm:3"], 0);
        let row = table_of_speeds(&out).remove(1);
        // At another speed the force misses the accuracy that the scene asks for.
        let one = stdout(&run(&["--speed", "96 rpm", "--json"], 3));
        let one: Value = serde_json::from_str(&one).unwrap();
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        let same = |a: f64, b: &Value| assert!((a - b.as_f64().unwrap()).abs() < 1e-9, "{a} {b}");
        same(number(1), &one["force"]["rms_error_n"]);
        let [low, high] = ["min", "max"].map(|end| one["torque"][end].as_f64().unwrap());
        assert!((number(6) - high.max(-low)).abs() < 1e-9);
        match machine.is_empty() {
            true => assert_eq!(number(8), 0.0),
            false => same(number(8), &one["shaft"]["ripple"]),
        }
    }
}

#[test]
fn a_speed_without_a_target_or_without_a_turning_shaft_is_a_row_that_says_so() {
    let shaker = Shaker::new();
    let (made, out) = (shaker.path("made"), shaker.path("out"));
    assert_eq!(
        gaitcam(&["synth", "footbridge", "--out", &made])
            .status
            .code(),
        Some(0)
    );
    let beyond = gaitcam(&["simulate", &made, "--speeds", "2:3:2 Hz", "--out", &out]);
    assert_eq!(beyond.status.code(), Some(0), "{}", stderr(&beyond));
    assert!(
        stdout(&beyond).contains("no target at this speed"),
        "{}",
        stdout(&beyond)
    );
    let rows = table_of_speeds(&out);
    assert!(
        !rows[0][1].is_empty() && rows[1][1].is_empty() && !rows[1][6].is_empty(),
        "{rows:?}"
    );
    let weak = [
        "machine.motor.stall_torque=14 N m",
        "machine.inertia=0.1 kg m^2",
    ];
    let set = [
        "--set",
        weak[0],
        "--set",
        weak[1],
        "--speeds",
        "0.2:1.8:2 Hz",
        "--out",
        &out,
    ];
    let weak = gaitcam(&[&["simulate", &made], &set[..]].concat());
    assert!(
        stdout(&weak).contains("the shaft stops"),
        "{}",
        stdout(&weak)
    );
    let rows = table_of_speeds(&out);
    assert!(rows[0][1..].iter().all(String::is_empty), "{rows:?}");
}

#[test]
fn the_report_at_another_speed_has_the_force_error_of_that_speed() {
    let folder = tempfile::tempdir().unwrap();
    let result = folder.path().join("footbridge");
    let slow = folder.path().join("slow");
    let [result, slow] = [&result, &slow].map(|path| path.to_str().unwrap());
    gaitcam(&["synth", "footbridge", "--out", result]);
    gaitcam(&["simulate", result, "--speed", "96 rpm", "--out", slow]);
    let read = |name: &str| std::fs::read_to_string(format!("{slow}/{name}")).unwrap();
    let run: serde_json::Value = serde_json::from_str(&read("simulation.json")).unwrap();
    let error = run["force"]["rms_error_n"].as_f64().unwrap();
    assert!(error > 10.0, "{run}");
    let shown = gaitcam::wording::rounded(gaitcam::wording::Language::En, error, 3);
    let report = read("report.html");
    assert!(
        report.contains(&format!("Force error {shown} N RMS")),
        "{shown}"
    );
    assert!(report.contains("young 1.6 Hz"));
}

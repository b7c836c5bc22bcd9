//! `gaitcam walk`, `simulate --speed-programme` and `ecam --strides`: what they print is what they write.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::support::{object, run_in, stderr, stdout};

fn recording() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let path: PathBuf = root.join("data/recordings/made_long_walk.csv");
    format!("gait.file={}", path.display())
}

fn designed(at: &Path) {
    let file = recording();
    let arguments = [
        "synth",
        "measured_walk",
        "--set",
        &file,
        "--no-png",
        "--out",
        "out",
    ];
    let answer = run_in(at, &arguments);
    assert!(answer.status.success(), "{}", stderr(&answer));
    let summary: Value =
        serde_json::from_str(&fs::read_to_string(at.join("out/summary.json")).unwrap()).unwrap();
    let ratio = summary["walker"]["resonance"][1]["ratio"].as_f64().unwrap();
    let printed = format!("0.5 % damping this cam at constant speed is {ratio:.2} times as severe");
    assert!(stdout(&answer).contains(&printed), "{}", stdout(&answer));
    let rows = fs::read_to_string(at.join("out/strides.csv"))
        .unwrap()
        .lines()
        .count();
    assert_eq!(rows, 1 + 128 * 48);
}

#[test]
fn a_programme_is_run_as_it_was_computed() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    designed(at);
    let computed = object(&run_in(at, &["walk", "out", "--json"]));
    let run = object(&run_in(
        at,
        &[
            "simulate",
            "out",
            "--speed-programme",
            "speed.csv",
            "--json",
        ],
    ));
    for k in 0..3 {
        for key in ["misfit", "peak_ratio"] {
            let [a, b] = [&computed, &run].map(|x| x["misfit"][k][key].as_f64().unwrap());
            assert!((a - b).abs() < 1e-6, "{key} {a} {b}");
        }
        assert!(
            computed["misfit"][k]["misfit"].as_f64()
                < computed["constant_speed"][k]["misfit"].as_f64()
        );
    }
    for key in ["min", "max", "rms_error_n"] {
        let [a, b] = [&computed, &run].map(|x| x["force"][key].as_f64().unwrap());
        assert!((a / b - 1.0).abs() < 1e-6, "{key} {a} {b}");
    }
    let text = stdout(&run_in(at, &["walk", "out"]));
    let list = |key: &str| {
        let all = (0..3).map(|k| format!("{:.3}", computed["misfit"][k][key].as_f64().unwrap()));
        all.collect::<Vec<_>>().join("  ")
    };
    assert!(
        text.contains(&list("misfit")) && text.contains(&list("peak_ratio")),
        "{text}"
    );
    let cv = |x: &Value| format!("± {:.1} %", 100.0 * x.as_f64().unwrap());
    for value in [
        &computed["amplitude_cv"],
        &computed["variability"]["amplitude_cv"],
        &computed["variability"]["step_time_cv"],
    ] {
        assert!(text.contains(&cv(value)), "{text}");
    }
    assert!(at.join("speed.svg").exists() && at.join("out/programme.csv").exists());
}

#[test]
fn faults_of_a_walk_are_named_with_what_would_do() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    designed(at);
    fs::write(at.join("short.csv"), short()).unwrap();
    fs::write(
        at.join("back.csv"),
        "time_s,speed_rad_per_s\n0,5\n1,-2\n2,5\n",
    )
    .unwrap();
    fs::write(at.join("none.csv"), "time_s,w\n0,5\n").unwrap();
    for (arguments, part) in [
        (
            vec!["walk", "out", "short.csv"],
            "3 consecutive strides of both feet; at least 8 are required",
        ),
        (
            vec!["walk", "footbridge"],
            "no recording with eight or more consecutive strides",
        ),
        (
            vec!["walk", "out", "--max-acceleration", "-1 rad/s^2"],
            "--max-acceleration",
        ),
        (
            vec!["simulate", "out", "--speed-programme", "back.csv"],
            "row 2 of the speed programme",
        ),
        (
            vec!["simulate", "out", "--speed-programme", "none.csv"],
            "no column speed_rad_per_s",
        ),
        (
            vec!["ecam", "out", "--dialect", "csv", "--strides", "60"],
            "60 strides are requested, but only 48",
        ),
    ] {
        let answer = run_in(at, &arguments);
        assert_eq!(answer.status.code(), Some(2), "{arguments:?}");
        assert!(stderr(&answer).contains(part), "{}", stderr(&answer));
    }
    fs::write(
        at.join("fast.csv"),
        "time_s,speed_rad_per_s\n0,5\n1,15\n2,25\n3,5\n",
    )
    .unwrap();
    let fast = run_in(at, &["simulate", "out", "--speed-programme", "fast.csv"]);
    assert_eq!(fast.status.code(), Some(3));
    assert!(stdout(&fast).contains("loses contact"));
}

/// The first seconds of the recording: three whole strides.
fn short() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text = fs::read_to_string(root.join("data/recordings/made_long_walk.csv")).unwrap();
    text.lines()
        .take(480)
        .map(|line| format!("{line}\n"))
        .collect()
}

#[test]
fn more_strides_of_a_servo_axis_come_closer_to_the_walk() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    designed(at);
    let misfit = |strides: &str| {
        let arguments = [
            "ecam",
            "out",
            "--dialect",
            "codesys",
            "--strides",
            strides,
            "--json",
        ];
        let answer = object(&run_in(at, &arguments));
        answer["strides"]["misfit"][1]["misfit"].as_f64().unwrap()
    };
    let [few, many] = ["2", "32"].map(misfit);
    assert!(many < 0.1 && many < 0.6 * few, "{few} {many}");
}

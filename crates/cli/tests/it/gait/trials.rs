//! `gaitcam gait` of a folder: table of all recordings, joint mean, and reasons for exclusion.

use std::fs;
use std::path::Path;
use std::process::Output;

use serde_json::Value;

use crate::support::{gaitcam, object, stderr, stdout, walk};

fn gait(arguments: &[&str]) -> Output {
    gaitcam(&[&["gait"], arguments].concat())
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

/// Writes two recordings of walking, one of standing, and a text file.
fn trials(folder: &Path) {
    walk(&folder.join("trial1.csv"));
    walk(&folder.join("trial2.csv"));
    let mut stands = "time,left fz,right fz\n".to_string();
    for i in 0..2400 {
        let t = f64::from(i) / 200.0;
        let sway = 4.0 * (1.3 * t).sin();
        stands += &format!("{t:.3},{:.2},{:.2}\n", 350.0 + sway, 350.0 - sway);
    }
    fs::write(folder.join("standing.csv"), stands).unwrap();
    fs::write(folder.join("readme.txt"), "three trials\n").unwrap();
}

#[test]
fn a_folder_gives_one_table_and_one_joint_mean() {
    let folder = tempfile::tempdir().unwrap();
    trials(folder.path());
    let out = folder.path().join("out").join("mean.csv");
    let run = gait(&[text(folder.path()), "--out", text(&out)]);
    let said = stdout(&run);
    assert_eq!(run.status.code(), Some(0), "{said}");
    let line = |name: &str| said.lines().find(|l| l.contains(name)).unwrap();
    assert!(line("trial1.csv").ends_with("used") && line("trial2.csv").ends_with("used"));
    assert!(line("standing.csv").contains("excluded"), "{said}");
    assert!(said.contains("joint mean of 2 recordings") && !said.contains("readme"));
    let curve = fs::read_to_string(&out).unwrap();
    assert!(curve.starts_with("# cycle, period_s = 1.1"), "{curve:.60}");
    assert!(curve.contains("trial2.csv") && !curve.contains("standing.csv"));
    for ending in ["svg", "png"] {
        assert!(out.with_extension(ending).exists());
    }
    // The mean is a target like any other.
    let set = format!("gait.file={}", text(&out));
    let synth = gaitcam(&["synth", "--json", "--set", &set]);
    let design: Value = object(&synth);
    let json: Value =
        serde_json::from_slice(&gait(&[text(folder.path()), "--json"]).stdout).unwrap();
    let mean = json["joint_mean"]["mean_n"].as_f64().unwrap();
    let target = design["force"]["target_mean_n"].as_f64().unwrap();
    assert!((mean / target - 1.0).abs() < 1e-6, "{mean} {target}");
    let of = |name: &str| {
        let all = json["recordings"].as_array().unwrap();
        let found = all
            .iter()
            .find(|r| r["file"].as_str().unwrap().ends_with(name));
        found.unwrap().clone()
    };
    assert_eq!(of("trial1.csv")["in_mean"], true);
    let standing = of("standing.csv");
    assert_eq!(standing["in_mean"], false);
    assert_eq!(standing["left_out"]["code"], "force-not-walking");
}

#[test]
fn a_folder_takes_the_cycle_of_each_and_is_read_again_without_them() {
    let folder = tempfile::tempdir().unwrap();
    trials(folder.path());
    let before = fs::read(folder.path().join("trial1.csv")).unwrap();
    for _ in 0..2 {
        let run = gait(&[text(folder.path()), "--out", text(folder.path())]);
        let said = stdout(&run);
        assert_eq!(run.status.code(), Some(0), "{said}");
        assert!(
            said.contains("joint mean of 2 recordings") && !said.contains("_cycle"),
            "{said}"
        );
    }
    for name in [
        "trial1_cycle.csv",
        "trial2_cycle.csv",
        "joint_mean.csv",
        "standing_cycle.png",
    ] {
        assert!(folder.path().join(name).exists(), "{name}");
    }
    assert!(!folder.path().join("standing_cycle.csv").exists());
    assert_eq!(fs::read(folder.path().join("trial1.csv")).unwrap(), before);
    // Elsewhere they are files like others, and no recordings.
    let run = gait(&[text(folder.path()), "--json"]);
    let json: Value = object(&run);
    let left_out = json["recordings"].as_array().unwrap().iter();
    let means = left_out.filter(|r| r["left_out"]["code"] == "mean-already");
    assert_eq!(means.count(), 3);
    assert_eq!(json["joint_mean"]["recordings"], 2);
}

#[test]
fn a_recording_that_was_named_has_to_give_a_cycle() {
    let folder = tempfile::tempdir().unwrap();
    trials(folder.path());
    let [one, other, stands] =
        ["trial1.csv", "trial2.csv", "standing.csv"].map(|n| folder.path().join(n));
    let run = gait(&[text(&one), text(&other)]);
    assert_eq!(run.status.code(), Some(0));
    let run = gait(&[text(&one), text(&stands)]);
    let fault = stderr(&run);
    assert_eq!(run.status.code(), Some(2));
    assert!(
        fault.contains("standing.csv") && fault.contains("as in standing"),
        "{fault}"
    );
    let empty = tempfile::tempdir().unwrap();
    let run = gait(&[text(empty.path())]);
    let fault = stderr(&run);
    assert_eq!(run.status.code(), Some(2));
    assert!(fault.contains("no file"), "{fault}");
}

#[test]
fn a_file_is_one_cycle_of_the_period_given() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("press.csv");
    let mut table = "time_s,force_n\n".to_string();
    for i in 0..100 {
        let t = f64::from(i) / 100.0;
        let force = 300.0 + 200.0 * (std::f64::consts::TAU * t).sin();
        table += &format!("{:.4},{force:.4}\n", 0.5 * t);
    }
    fs::write(&path, table).unwrap();
    let json = |more: &[&str]| -> Value {
        let run = gait(&[&[text(&path), "--json"], more].concat());
        assert_eq!(run.status.code(), Some(0), "{run:?}");
        object(&run)
    };
    let whole = json(&["--period", "0.5 s"]);
    assert_eq!(whole["cycle"]["period_s"], 0.5);
    assert!((whole["cycle"]["mean_n"].as_f64().unwrap() - 300.0).abs() < 0.1);
    // In 90° of a turn the mean is a quarter.
    let part = json(&["--period", "0.5 s", "--span", "90 deg"]);
    let mean = part["cycle"]["mean_n"].as_f64().unwrap();
    assert!((mean / 75.0 - 1.0).abs() < 0.02, "{mean}");
    let wrong = gait(&[text(&path), "--period", "0.5"]);
    let fault = stderr(&wrong);
    assert_eq!(wrong.status.code(), Some(2));
    assert!(fault.contains("--period"), "{fault}");
}

#[test]
fn an_option_that_is_wrong_is_named_before_a_folder_is_read() {
    let folder = tempfile::tempdir().unwrap();
    trials(folder.path());
    for (option, value) in [
        ("--period", "-1 s"),
        ("--period", "-1"),
        ("--rate", "0 Hz"),
        ("--mass", "-70 kg"),
        ("--span", "-3 deg"),
        ("--mass", "1.234,5 kg"),
        ("--unit", "mV"),
        ("--kind", "dance"),
    ] {
        let run = gait(&[text(folder.path()), &format!("{option}={value}")]);
        let said = stderr(&run);
        assert_eq!(run.status.code(), Some(2), "{option} {value}");
        assert!(said.contains(option) && stdout(&run).is_empty(), "{said}");
    }
}

#[test]
fn recordings_that_cannot_be_read_are_counted_too() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.csv", "b.csv"] {
        fs::write(folder.path().join(name), "time,Fz\n0,1\n").unwrap();
    }
    let said = stderr(&gait(&[text(folder.path())]));
    assert!(said.contains("none of the 2 recordings"), "{said}");
}

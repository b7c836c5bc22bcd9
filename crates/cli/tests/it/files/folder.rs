//! A result folder contains one design. The files of an earlier design are removed, other files are kept.

use std::fs;
use std::path::Path;
use std::process::Stdio;

use crate::support::{ROOT, command, gaitcam, stderr};

fn run(arguments: &[&str]) -> i32 {
    gaitcam(arguments).status.code().unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let mut all: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    all.sort();
    all
}

/// Rise of 10 mm with an acceleration limit below the required 16 h/T², so that no cam exists.
const IMPOSSIBLE: &str = r#"
name = "impossible"
drive = { kind = "moving-axis", mass = "1 kg", speed = "60 rpm" }
law = { spans = 24, minimise = "jerk", point = [
    { angle = "0 deg", lift = "0 mm" },
    { angle = "90 deg", lift = "10 mm" },
    { angle = "180 deg", lift = "0 mm" } ] }
cam = { base_radius = "20 mm" }
limits = { acceleration = "0.4 m/s^2" }
"#;
const OTHER: &str = "scenes/camdas_03_flat.toml";

#[test]
fn an_infeasible_design_leaves_no_law_of_an_earlier_one_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    assert_eq!(
        run(&["synth", "--out", out, "--solid", "--tool", "5 mm"]),
        0
    );
    assert!(names(folder.path()).contains(&"cutter.csv".to_string()));
    // Files of others stay, whatever they are called.
    fs::write(folder.path().join("notes.txt"), "mine").unwrap();
    fs::write(folder.path().join("law_of_mine.csv"), "mine").unwrap();
    // Half a result of a run that was killed; process numbers stay below 2²².
    let half = folder.path().join(".gaitcam.4194999.new");
    fs::create_dir(&half).unwrap();
    fs::write(half.join("law.csv"), "half").unwrap();
    fs::write(folder.path().join("mine.csv.4194999.partial"), "mine").unwrap();

    // Bad input costs nothing that is there.
    let mut before = names(folder.path());
    before.retain(|name| !name.starts_with(".gaitcam"));
    assert_eq!(
        run(&["synth", "--out", out, "--set", "limits.stroke=3 kg"]),
        2
    );
    let mut after = names(folder.path());
    after.retain(|name| !name.starts_with(".gaitcam"));
    assert_eq!(after, before);

    let beside = tempfile::tempdir().unwrap();
    let scene = beside.path().join("impossible.toml");
    fs::write(&scene, IMPOSSIBLE).unwrap();
    assert_eq!(run(&["synth", scene.to_str().unwrap(), "--out", out]), 3);
    let known = [
        "law_of_mine.csv",
        "mine.csv.4194999.partial",
        "notes.txt",
        "report.html",
        "scene.toml",
        "summary.json",
    ];
    assert_eq!(names(folder.path()), known);
}

#[test]
fn the_run_of_a_design_stays_beside_it_and_goes_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    assert_eq!(run(&["synth", "--out", out]), 0);
    assert_eq!(run(&["simulate", "--out", out]), 0);
    let ran = |folder: &Path| folder.join("dynamics.csv").exists();
    assert_eq!(run(&["synth", "--out", out]), 0);
    assert!(ran(folder.path()));
    assert_eq!(run(&["synth", OTHER, "--out", out]), 0);
    assert!(!ran(folder.path()) && !folder.path().join("simulation.json").exists());
}

#[test]
fn a_run_does_not_stand_beside_the_design_of_another_scene() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    assert_eq!(run(&["synth", OTHER, "--out", out]), 0);
    assert_eq!(run(&["simulate", "--out", out]), 0);
    let known = [
        "dynamics.csv",
        "dynamics.xlsx",
        "report.html",
        "scene.toml",
        "simulation.json",
    ];
    assert_eq!(names(folder.path()), known);
    let scene = fs::read_to_string(folder.path().join("scene.toml")).unwrap();
    assert!(scene.contains("footbridge"), "{scene}");
    // The summary of a design is no input that its run may take away.
    assert_eq!(run(&["synth", OTHER, "--out", out]), 0);
    let summary = folder.path().join("summary.json");
    let summary = summary.to_str().unwrap();
    let change = ["--set", "cam.base_radius=60 mm"];
    let changed = [&["simulate", summary, "--out", out][..], &change].concat();
    assert_eq!(run(&changed), 2);
    assert_eq!(run(&["simulate", summary, "--out", out]), 0);
    assert!(names(folder.path()).contains(&"law.csv".to_string()));
}

#[test]
fn a_folder_that_holds_no_result_loses_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    fs::write(folder.path().join("cam.png"), "a photograph").unwrap();
    fs::write(folder.path().join("dynamics.csv"), "a measurement").unwrap();
    fs::write(folder.path().join("scene.toml"), IMPOSSIBLE).unwrap();
    let scene = folder.path().join("scene.toml");
    assert_eq!(run(&["synth", scene.to_str().unwrap(), "--out", out]), 3);
    let names = names(folder.path());
    assert!(names.contains(&"cam.png".to_string()) && names.contains(&"dynamics.csv".to_string()));
}

#[cfg(target_os = "linux")]
#[test]
fn an_answer_that_cannot_be_written_is_no_success() {
    for arguments in [&["laws"][..], &["laws", "--json"], &["--help"]] {
        let full = fs::OpenOptions::new()
            .write(true)
            .open("/dev/full")
            .unwrap();
        let output = command(Path::new(ROOT))
            .args(arguments)
            .stdout(full)
            .stderr(Stdio::piped())
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        let words = stderr(&output);
        assert!(words.contains("standard output"), "{words}");
    }
}

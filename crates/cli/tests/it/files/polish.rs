//! Details of numbers, streams and files that have caused errors before.

use std::fs;
use std::process::Command;

use crate::support::{gaitcam, object, stderr, stdout, walk};

#[test]
fn numbers_of_the_console_say_what_is_known_and_no_more() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    for scene in [
        "footbridge",
        "scenes/camdas_02_oscillating_roller.toml",
        "scenes/mushroom.toml",
    ] {
        for family in [None, Some("law.family=harmonic")] {
            if family.is_some() && scene != "footbridge" {
                continue;
            }
            let change: Vec<&str> = family.iter().flat_map(|f| ["--set", f]).collect();
            for verb in ["synth", "simulate"] {
                let run = gaitcam(&[&[verb, scene, "--out", out][..], &change].concat());
                let said = stdout(&run);
                for odd in [
                    "degree 0",
                    " 1 pieces",
                    "0.000000",
                    "e0",
                    "-0.0 ",
                    "0.0000 kg",
                    "after 0 turns",
                    "mm (limit 6.0000e-5",
                ] {
                    assert!(!said.contains(odd), "{odd:?} of {verb} {scene} in {said}");
                }
            }
        }
    }
}

#[test]
fn a_wall_about_the_bore_that_is_thinner_than_a_hub_is_noted() {
    let notes = |change: &str| {
        let run = gaitcam(&["synth", "footbridge", "--json", "--set", change]);
        let json: serde_json::Value = object(&run);
        json["remarks"].to_string()
    };
    // The base circle of 7 mm leaves 1 mm around the bore of 12 mm.
    let thin = notes("cam.base_radius=7 mm");
    assert!(
        thin.contains("wall between bore") && thin.contains("1 mm") && thin.contains("3 mm"),
        "{thin}"
    );
    let thick = notes("cam.bore=12 mm");
    assert!(!thick.contains("wall between bore"), "{thick}");
}

#[test]
fn a_picture_is_no_place_for_a_cycle() {
    let folder = tempfile::tempdir().unwrap();
    let recording = folder.path().join("walk.csv");
    walk(&recording);
    let picture = folder.path().join("out.png");
    let run = gaitcam(&[
        "gait",
        recording.to_str().unwrap(),
        "--out",
        picture.to_str().unwrap(),
    ]);
    assert_eq!(run.status.code(), Some(2));
    let fault = stderr(&run);
    assert!(
        fault.contains("out.png") && fault.contains(".csv"),
        "{fault}"
    );
    assert!(!picture.exists());
}

#[test]
fn a_refused_recording_is_told_why_once() {
    let folder = tempfile::tempdir().unwrap();
    let recording = folder.path().join("stands.csv");
    let rows = (0..2000).map(|i| {
        let t = f64::from(i) / 200.0;
        format!("{t:.3},{:.1}\n", 700.0 + 6.0 * (1.3 * t).sin())
    });
    let text: String = std::iter::once("time_s,fz_n\n".to_string())
        .chain(rows)
        .collect();
    fs::write(&recording, text).unwrap();
    let told = |more: &[&str]| {
        let run = gaitcam(&[&["gait", recording.to_str().unwrap()], more].concat());
        assert_eq!(run.status.code(), Some(2));
        (stdout(&run), stderr(&run))
    };
    let (said, fault) = told(&[]);
    let reason = "as in standing";
    assert!(!said.contains(reason), "{said}");
    assert_eq!(fault.matches(reason).count(), 1, "{fault}");
    // What is open follows the line that says that there is no cycle.
    let (said, _) = told(&["--kind", "walking"]);
    assert!(said.lines().any(|line| line == "no mean cycle"), "{said}");
}

#[cfg(unix)]
#[test]
fn a_closed_standard_error_does_not_change_the_exit_code() {
    let program = env!("CARGO_BIN_EXE_gaitcam");
    let closed = format!("exec 2>&-; exec {program} synth --set gait.zzz=1");
    let run = Command::new("sh").args(["-c", &closed]).output().unwrap();
    assert_eq!(run.status.code(), Some(2));
}

//! `gaitcam synth --explain`: selected models, and reasons against others.

use assert_cmd::Command;
use serde_json::Value;

/// Field `explain` of summary.json, and the printed text.
fn explained(changes: &[&str]) -> (Vec<Value>, String) {
    let out = tempfile::tempdir().unwrap();
    let mut command = Command::cargo_bin("gaitcam").unwrap();
    command.args(["synth", "--no-png", "--explain", "--out"]);
    command.arg(out.path().join("d"));
    command.args(changes.iter().flat_map(|change| ["--set", change]));
    let run = command.assert().success();
    let text = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
    let summary = std::fs::read_to_string(out.path().join("d/summary.json")).unwrap();
    let json: Value = serde_json::from_str(&summary).unwrap();
    (json["explain"].as_array().unwrap().clone(), text)
}

#[test]
fn every_model_is_named_with_its_reason() {
    let (lines, text) = explained(&[]);
    let subjects: Vec<&str> = lines.iter().filter_map(|l| l["subject"].as_str()).collect();
    assert_eq!(subjects, ["family", "solver", "dynamics"]);
    for line in &lines {
        let because = line["because"].as_str().unwrap();
        assert!(!because.is_empty() && text.contains(because), "{text}");
    }
}

#[test]
fn the_closed_form_that_was_passed_over_is_named_with_the_limit_that_it_violates() {
    let (lines, _) = explained(&["law.family=auto", "limits.jerk=65 m/s^3"]);
    let because = lines[0]["because"].as_str().unwrap();
    assert!(
        because.contains("jerk") && because.contains("65 m/s³"),
        "{because}"
    );
}

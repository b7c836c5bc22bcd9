//! Recordings with an open question: exit code 3 with the correction until the user answers.

use std::f64::consts::PI;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::support::{changed, gaitcam, stderr};

const SCENE: &str = "scenes/measured_walk.toml";
const STRIDE: f64 = 1.1;

/// Exit code and summary of the cam for a recording, with further keys set.
fn synth(file: &str, changes: &[&str]) -> (i32, Value) {
    let recording = format!("gait.file={file}");
    let output = gaitcam(&changed(
        &["synth", SCENE, "--json", "--set", &recording],
        changes,
    ));
    let fault = stderr(&output);
    let json = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{fault}"));
    (output.status.code().unwrap(), json)
}

fn gait(file: &str, more: &[&str]) -> (i32, Value, String) {
    let output = gaitcam(&[&["gait", file, "--json"], more].concat());
    let json = serde_json::from_slice(&output.stdout).unwrap_or_default();
    let fault = stderr(&output);
    (output.status.code().unwrap(), json, fault)
}

fn has_reason(json: &Value, code: &str) -> bool {
    let reasons = json["reasons"].as_array().unwrap();
    reasons.iter().any(|r| r["code"] == code)
}

/// Force of one foot t s after heel strike, N: 70 kg, two peaks.
fn walking(t: f64) -> f64 {
    let x = t.rem_euclid(STRIDE) / 0.66;
    if x < 1.0 {
        820.0 * ((PI * x).sin() + 0.3 * (3.0 * PI * x).sin())
    } else {
        0.0
    }
}

/// Force of a runner of 70 kg t s after a foot strike, N: contacts of 0.25 s, every 0.7 s for each foot.
fn running(t: f64) -> f64 {
    let x = t.rem_euclid(0.7) / 0.25;
    // Over a step of 0.35 s the half sine carries the weight.
    let peak = 70.0 * 9.81 * 0.35 / (0.25 * 2.0 / PI);
    if x < 1.0 { peak * (PI * x).sin() } else { 0.0 }
}

/// Writes a file of 8 s at 1000 Hz. `row` makes the line of a sample from its number and time.
fn write(path: &Path, head: &str, row: impl Fn(usize, f64) -> String) -> String {
    let rows = (0..8000).map(|i| row(i, i as f64 / 1000.0));
    let text = rows.fold(format!("{head}\n"), |text, row| text + &row + "\n");
    fs::write(path, text).unwrap();
    path.display().to_string()
}

#[test]
fn a_clock_that_may_count_samples_is_refused_until_the_user_answers() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(
        &folder.path().join("counts.csv"),
        "Time,left fz,right fz",
        |i, t| format!("{i},{:.2},{:.2}", walking(t + 0.2), walking(t + 0.75)),
    );
    let (exit, json) = synth(&file, &[]);
    assert_eq!(exit, 3);
    assert!(
        has_reason(&json, "reason-recording-clock"),
        "{}",
        json["reasons"]
    );
    let cure = json["verdict_text"]["en"].as_str().unwrap();
    assert!(
        cure.contains("gait.rate") && cure.contains("gait.accept = \"clock\""),
        "{cure}"
    );
    let warnings = json["recording"]["warnings"].as_array().unwrap();
    assert!(
        warnings
            .iter()
            .any(|w| w["code"] == "count-or-milliseconds")
    );
    for answer in ["gait.accept=clock", "gait.rate=1000 Hz"] {
        let (exit, json) = synth(&file, &[answer]);
        assert!(!has_reason(&json, "reason-recording-clock"), "{answer}");
        assert_eq!(exit, 0, "{answer}: {}", json["reasons"]);
    }
    let (exit, _) = synth(&file, &["gait.accept=mass"]);
    assert_eq!(exit, 3, "the mass is not what is open");
    let wrong = gaitcam(&["synth", SCENE, "--set", "gait.accept=time"]);
    assert_eq!(wrong.status.code(), Some(2));
}

#[test]
fn a_single_stance_names_what_was_assumed_and_the_keys_that_settle_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("heel.csv");
    let rows = (0..680).map(|i| {
        let t = f64::from(i) / 1000.0 - 0.01;
        let force = if (0.0..0.66).contains(&t) {
            walking(t)
        } else {
            0.0
        };
        format!("{:.3},{force:.2}\n", f64::from(i) / 1000.0)
    });
    fs::write(
        &path,
        "time_s,force_N\n".to_string() + &rows.collect::<String>(),
    )
    .unwrap();
    let file = path.display().to_string();
    let (exit, json) = synth(&file, &["gait.feet=both"]);
    assert_eq!(exit, 3);
    let clock = json["reasons"].as_array().unwrap().iter();
    let clock = clock
        .clone()
        .find(|r| r["code"] == "reason-recording-clock");
    let clock = clock.unwrap_or_else(|| panic!("{}", json["reasons"]));
    assert!(clock["because"][0]["stride-assumed"].is_object(), "{clock}");
    assert_eq!(clock["keys"][0], "gait.mass");
    // The mass carried over one stride gives its duration: 1.1 s at 70 kg.
    let (_, json) = synth(&file, &["gait.feet=both", "gait.mass=70 kg"]);
    assert!(
        !has_reason(&json, "reason-recording-clock"),
        "{}",
        json["reasons"]
    );
    let period = json["recording"]["period_s"].as_f64().unwrap();
    let impulse = (0..66_000)
        .map(|i| walking(f64::from(i) * 1e-5) * 1e-5)
        .sum::<f64>();
    let expected = 2.0 * impulse / (70.0 * 9.80665);
    assert!(
        (period / expected - 1.0).abs() < 0.01,
        "{period} {expected}"
    );
}

#[test]
fn a_sweep_over_recordings_says_in_each_row_what_was_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    write(
        &folder.path().join("counts.csv"),
        "Time,left fz,right fz",
        |i, t| format!("{i},{:.2},{:.2}", walking(t + 0.2), walking(t + 0.75)),
    );
    write(
        &folder.path().join("sound.csv"),
        "time_s,left_fz_n,right_fz_n",
        |_, t| format!("{t:.3},{:.2},{:.2}", walking(t + 0.2), walking(t + 0.75)),
    );
    let table = tempfile::tempdir().unwrap();
    let table = table.path().join("walks.csv");
    let recordings = folder.path().to_str().unwrap();
    let out = table.to_str().unwrap();
    let run = gaitcam(&["sweep", SCENE, "--recordings", recordings, "--out", out]);
    assert_eq!(run.status.code(), Some(0), "{run:?}");
    let mut reader = csv::Reader::from_path(&table).unwrap();
    let names = reader.headers().unwrap().clone();
    let column = |name: &str| names.iter().position(|n| n == name).unwrap();
    let (file, warnings, verdict) = (column("gait.file"), column("warnings"), column("verdict"));
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 2);
    for row in rows {
        let counts = row[file].ends_with("counts.csv");
        let codes: Vec<&str> = row[warnings].split('+').filter(|c| !c.is_empty()).collect();
        assert_eq!(codes.contains(&"count-or-milliseconds"), counts, "{row:?}");
        assert_eq!(&row[verdict] == "unacceptable", counts, "{row:?}");
    }
}

#[test]
fn a_run_is_refused_by_name_and_read_when_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(
        &folder.path().join("run.csv"),
        "time_s,left_fz_n,right_fz_n",
        |_, t| format!("{t:.3},{:.2},{:.2}", running(t - 0.1), running(t - 0.45)),
    );
    let (exit, json, fault) = gait(&file, &[]);
    assert_eq!((exit, &json["kind"]), (2, &"running".into()));
    assert!(fault.contains("kind = \"running\""), "{fault}");
    let (exit, json, _) = gait(&file, &["--kind", "running"]);
    assert_eq!((exit, &json["kind"]), (0, &"running".into()));
    let of = |key: &str| json[key].as_f64().unwrap();
    assert!((of("period_s") - 0.7).abs() < 0.007 && (of("mass_kg") / 70.0 - 1.0).abs() < 0.03);
    let (_, json) = synth(&file, &["gait.kind=running"]);
    assert!(
        !has_reason(&json, "reason-recording-kind"),
        "{}",
        json["reasons"]
    );
    assert_eq!(json["recording"]["kind"], "running");
    // Walking that is said to be running is open.
    let walk = write(
        &folder.path().join("walk.csv"),
        "time_s,left_fz_n,right_fz_n",
        |_, t| format!("{t:.3},{:.2},{:.2}", walking(t + 0.2), walking(t + 0.75)),
    );
    let recording = format!("gait.file={walk}");
    let wrong = gaitcam(&[
        "synth",
        SCENE,
        "--set",
        &recording,
        "--set",
        "gait.kind=running",
    ]);
    assert!(matches!(wrong.status.code(), Some(2 | 3)), "{wrong:?}");
}

#[test]
fn the_total_of_both_feet_is_a_cycle_when_it_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(
        &folder.path().join("total.csv"),
        "time_s,force_n",
        |_, t| format!("{t:.3},{:.2}", walking(t + 0.2) + walking(t + 0.75)),
    );
    let (exit, json, fault) = gait(&file, &["--feet", "total"]);
    assert_eq!(exit, 0, "{fault}");
    assert_eq!(json["cycle"]["source"]["code"], "total-force");
    let period = json["period_s"].as_f64().unwrap();
    assert!((period / STRIDE - 1.0).abs() < 0.01, "{period}");
    let mean = json["cycle"]["mean_n"].as_f64().unwrap();
    let (_, json) = synth(&file, &["gait.feet=total"]);
    let target = json["force"]["target_mean_n"].as_f64().unwrap();
    assert!((target / mean - 1.0).abs() < 1e-6, "{target} {mean}");
    let (exit, _, fault) = gait(&file, &["--feet", "one"]);
    assert_eq!(exit, 2);
    assert!(fault.contains("total force of both feet"), "{fault}");
}

//! `gaitcam gait`: written files and their paths.

use std::fs;
use std::path::{Path, PathBuf};

use crate::support::{gaitcam, object, run_in, stderr, walk, wobbling_walk};

/// Empty folder for one test.
fn folder(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("gaitcam_gait_{name}_{}", std::process::id()));
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

fn is_picture(csv: &Path) {
    let svg = fs::read_to_string(csv.with_extension("svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    for word in ["mean of", "± 1 SD", "share of stance, %", "mean cycle"] {
        assert!(svg.contains(word), "{word} is not in the picture");
    }
    let png = fs::read(csv.with_extension("png")).unwrap();
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"));
}

#[test]
fn a_curve_file_gets_its_picture_beside_it_and_reads_back() {
    let folder = folder("curve");
    let (recording, out) = (folder.join("walk.csv"), folder.join("mean.csv"));
    walk(&recording);
    let (recording, curve) = (recording.to_str().unwrap(), out.to_str().unwrap());
    let output = gaitcam(&["gait", recording, "--out", curve]);
    assert!(output.status.success(), "{output:?}");
    is_picture(&out);
    let text = fs::read_to_string(&out).unwrap();
    assert!(text.starts_with("# cycle, period_s = 1.1"), "{text:.40}");
    let set = format!("gait.file={curve}");
    let design = folder.join("design");
    let output = gaitcam(&["synth", "--set", &set, "--out", design.to_str().unwrap()]);
    // The recording takes the place of the built-in scene's model; its own stride asks for another stroke.
    let said = stderr(&output);
    assert!(
        matches!(output.status.code(), Some(0 | 3)) && !said.contains("gait"),
        "{output:?}"
    );
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_folder_takes_one_curve_and_picture_per_recording() {
    let folder = folder("folder");
    let other = folder.join("other");
    fs::create_dir_all(&other).unwrap();
    let files = [
        folder.join("a.csv"),
        folder.join("b.csv"),
        other.join("a.csv"),
    ];
    for f in &files {
        walk(f);
    }
    let before = fs::read(&files[0]).unwrap();
    let mut arguments = vec!["gait"];
    arguments.extend(files.iter().map(|f| f.to_str().unwrap()));
    arguments.extend(["--out", folder.to_str().unwrap()]);
    let output = gaitcam(&arguments);
    assert!(output.status.success(), "{output:?}");
    for name in ["a_cycle.csv", "b_cycle.csv", "a_cycle_2.csv"] {
        is_picture(&folder.join(name));
    }
    assert_eq!(
        fs::read(&files[0]).unwrap(),
        before,
        "the recording is untouched"
    );
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_curve_never_replaces_the_recording_itself() {
    let folder = folder("refused");
    let recording = folder.join("walk.csv");
    walk(&recording);
    let path = recording.to_str().unwrap();
    let before = fs::read(&recording).unwrap();
    let output = gaitcam(&["gait", path, "--out", path]);
    assert_eq!(output.status.code(), Some(2));
    let message = stderr(&output);
    assert!(message.contains("walk.csv would be replaced"), "{message}");
    assert_eq!(fs::read(&recording).unwrap(), before);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_measured_walk_is_synthesised_no_finer_than_its_spread() {
    let folder = folder("measured");
    let recording = folder.join("walk.csv");
    wobbling_walk(&recording, 0.04);
    let scene = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenes/measured_walk.toml"
    );
    let refused = gaitcam(&["synth", scene]);
    assert_eq!(refused.status.code(), Some(2));
    let said = stderr(&refused);
    assert!(said.contains("gait.file"), "{said}");
    let set = format!("gait.file={}", recording.display());
    let out = folder.join("out");
    let run = |more: &[&str]| {
        let base = [
            "synth",
            scene,
            "--set",
            &set,
            "--json",
            "--out",
            out.to_str().unwrap(),
        ];
        let output = gaitcam(&[&base[..], more].concat());
        assert!(output.status.success(), "{output:?}");
        object(&output)
    };
    let coarse = run(&[]);
    let fine = run(&["--set", "accuracy.rms=0.3 %"]);
    let error = |v: &serde_json::Value| v["force"]["rms_error_n"].as_f64().unwrap();
    let pieces = |v: &serde_json::Value| v["law"]["pieces"].as_u64().unwrap();
    // The spread is about 4 % of either foot's force; a fifth of it is well above 0.5 % of the mean.
    let mean = coarse["force"]["target_mean_n"].as_f64().unwrap();
    assert!(
        error(&coarse) > 0.003 * mean && error(&coarse) < 0.01 * mean,
        "{coarse}"
    );
    assert!(error(&fine) <= 0.003 * mean && pieces(&fine) > pieces(&coarse));
    let report = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(report.contains("Step-to-step variability"));
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn the_table_of_subjects_is_found_from_any_folder() {
    let folder = tempfile::tempdir().unwrap();
    let names: Vec<String> = (1..=60).map(|i| format!("F_V_RAW_{i}")).collect();
    let row = |id: &str| -> String {
        let force = |i: u32| 600.0 * (std::f64::consts::PI * f64::from(i) / 61.0).sin();
        let samples: Vec<String> = (1..=60).map(|i| format!("{:.1}", force(i))).collect();
        format!("{id},1,{}\n", samples.join(","))
    };
    let head = format!("SUBJECT_ID,TRIAL_ID,{}\n", names.join(","));
    let table = folder.path().join("made_F_V_RAW_left.csv");
    fs::write(&table, head + &row("A") + &row("B")).unwrap();
    let subjects = "SUBJECT_ID,BODY_MASS\nA,40\nB,60\n";
    fs::write(folder.path().join("made_metadata.csv"), subjects).unwrap();
    let mass = |from: &Path, file: &Path| {
        let output = run_in(from, &["gait", "--json", file.to_str().unwrap()]);
        let json: serde_json::Value = object(&output);
        json["mass_kg"].as_f64()
    };
    assert_eq!(mass(&std::env::temp_dir(), &table), Some(50.0));
    assert_eq!(
        mass(folder.path(), Path::new("made_F_V_RAW_left.csv")),
        Some(50.0)
    );
}

#[test]
fn stances_become_a_table_that_replaces_only_an_earlier_one() {
    let folder = folder("stances");
    let recording = folder.join("walk.csv");
    walk(&recording);
    let before = fs::read(&recording).unwrap();
    let place = |name: &str| folder.join(name).to_str().unwrap().to_string();
    let (recording, table) = (place("walk.csv"), place("stances.csv"));
    for _ in 0..2 {
        let output = gaitcam(&["gait", &recording, "--stances", &table]);
        assert!(output.status.success(), "{output:?}");
    }
    let text = fs::read_to_string(&table).unwrap();
    let object = object(&gaitcam(&["gait", &recording, "--json"]));
    let contacts = object["contacts"].as_array().unwrap();
    let rows: Vec<Vec<&str>> = text
        .lines()
        .skip(1)
        .map(|l| l.split(',').collect())
        .collect();
    assert_eq!(rows.len(), contacts.len());
    for (row, contact) in rows.iter().zip(contacts) {
        let number = |text: &str| text.parse::<f64>().unwrap();
        assert!((number(row[2]) - contact["from_s"].as_f64().unwrap()).abs() < 1e-6);
        assert!((number(row[3]) - contact["to_s"].as_f64().unwrap()).abs() < 1e-6);
        assert_eq!(row[8], contact["used"].to_string());
        assert_eq!(row[9], contact["reason"].as_str().unwrap_or_default());
    }
    // A recording, another ending and a table of several recordings are refused.
    let other = place("other.csv");
    fs::copy(&recording, &other).unwrap();
    for arguments in [
        vec!["gait", &recording, "--stances", &recording],
        vec!["gait", &recording, "--stances", &other],
        vec!["gait", &recording, "--stances", "stances.txt"],
        vec!["gait", &recording, &other, "--stances", &table],
    ] {
        let output = gaitcam(&arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
    }
    assert!(fs::read(&recording).unwrap() == before && fs::read(&other).unwrap() == before);
    fs::remove_dir_all(folder).unwrap();
}

//! Rows of a sweep: order, faults and recordings.

use std::fs;
use std::path::Path;

use super::{rows, sweep};
use crate::support::{run_in, stderr, stdout, walk};

#[test]
fn rows_are_the_same_for_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    let (one, three) = (folder.path().join("1.csv"), folder.path().join("3.csv"));
    let short = [
        "--sample",
        "40",
        "--vary",
        "limits.stroke=35 mm:60 mm",
        "--vary",
        "law.family=spline,harmonic",
    ];
    sweep(&one, &[&short[..], &["--jobs", "1"]].concat());
    sweep(&three, &[&short[..], &["--jobs", "3"]].concat());
    assert_eq!(rows(&one).len(), 41);
    assert_eq!(rows(&one), rows(&three));
}

#[test]
fn unusable_recordings_and_impossible_scenes_are_rows_with_their_reason() {
    let folder = tempfile::tempdir().unwrap();
    let recordings = folder.path().join("recordings");
    fs::create_dir(&recordings).unwrap();
    let good = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .join("data/gait_curves/setra_2Hz_700N.csv");
    fs::copy(good, recordings.join("b.csv")).unwrap();
    fs::write(recordings.join("a.txt"), "no numbers here\n").unwrap();
    fs::write(recordings.join("c.csv"), "").unwrap();
    let out = folder.path().join("t.csv");
    let output = sweep(
        &out,
        &[
            "--recordings",
            recordings.to_str().unwrap(),
            "--vary",
            "law.family=spline,program",
        ],
    );
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let mut reader = csv::Reader::from_path(&out).unwrap();
    let header = reader.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|h| h == name).unwrap();
    let table: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let outcomes: Vec<&str> = table.iter().map(|r| &r[column("outcome")]).collect();
    assert_eq!(
        outcomes,
        ["error", "error", "built", "error", "error", "error"]
    );
    assert!(
        table[0][column("error")].contains("a.txt"),
        "{:?}",
        table[0]
    );
    assert!(
        table[3][column("error")].contains("segments"),
        "{:?}",
        table[3]
    );
}

#[test]
fn lists_and_several_scenes_give_their_rows_in_order() {
    let folder = tempfile::tempdir().unwrap();
    let list = folder.path().join("list.csv");
    fs::write(
        &list,
        "limits.stroke,law.family\n50 mm,spline\n55 mm,harmonic\n",
    )
    .unwrap();
    let out = folder.path().join("t.csv");
    let output = sweep(
        &out,
        &[
            "scenes/footbridge.toml",
            "scenes/footbridge_thesis_scale.toml",
            "--list",
            list.to_str().unwrap(),
            "--vary",
            "law.degree=4,5",
        ],
    );
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let rows = rows(&out);
    assert!(rows[0].starts_with("row,scene,limits.stroke_m,law.family,law.degree,"));
    let starts: Vec<String> = rows[1..]
        .iter()
        .map(|r| r.split(',').take(5).collect::<Vec<_>>().join(","))
        .collect();
    assert_eq!(starts[0], "0,scenes/footbridge.toml,0.05,spline,4");
    assert_eq!(starts[3], "3,scenes/footbridge.toml,0.055,harmonic,5");
    assert_eq!(
        starts[4],
        "4,scenes/footbridge_thesis_scale.toml,0.05,spline,4"
    );
    assert_eq!(starts.len(), 8);
}

#[test]
fn a_folder_of_recordings_fills_a_scene_that_names_none() {
    let folder = tempfile::tempdir().unwrap();
    let records = folder.path().join("records");
    fs::create_dir(&records).unwrap();
    for name in ["a.csv", "b.csv"] {
        fs::copy(
            concat!(
                env!("CARGO_MANIFEST_DIR"),
                "/../../data/gait_curves/young_1.85Hz_700N.csv"
            ),
            records.join(name),
        )
        .unwrap();
    }
    for name in ["README.md", "LICENSE", "LICENCE.txt", "people_metadata.csv"] {
        fs::write(records.join(name), "words about the recordings").unwrap();
    }
    let table = folder.path().join("t.csv");
    let output = sweep(
        &table,
        &[
            "scenes/measured_walk.toml",
            "--recordings",
            records.to_str().unwrap(),
        ],
    );
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(
        stderr(&output).contains("4 file(s) in the folder are not recordings"),
        "{}",
        stderr(&output)
    );
    assert_eq!(fs::read_to_string(&table).unwrap().lines().count(), 3);
    let about = records.join("README.md");
    fs::remove_file(records.join("a.csv")).unwrap();
    fs::remove_file(records.join("b.csv")).unwrap();
    let none = sweep(
        &folder.path().join("u.csv"),
        &[
            "scenes/measured_walk.toml",
            "--recordings",
            records.to_str().unwrap(),
        ],
    );
    assert_eq!(none.status.code(), Some(2));
    assert!(
        stderr(&none).contains("none of 4 files"),
        "{}",
        stderr(&none)
    );
    assert!(about.exists());
}

#[test]
fn values_that_do_not_go_with_another_key_cost_their_rows_only() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("t.csv");
    // The bore of 12 mm leaves no base circle of 5 mm.
    let output = sweep(&table, &["--vary", "cam.base_radius=5 mm:20 mm:4"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let text = fs::read_to_string(&table).unwrap();
    let faults = text.lines().filter(|l| l.contains("bore")).count();
    assert_eq!((text.lines().count(), faults), (5, 1), "{text}");
}

#[test]
fn a_name_that_is_a_formula_to_a_spreadsheet_stands_in_the_table_as_text() {
    let folder = tempfile::tempdir().unwrap();
    walk(&folder.path().join("=1+2.csv"));
    let run = |arguments: &[&str]| {
        let output = run_in(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        stdout(&output)
    };
    let sweep = [
        "sweep",
        "--recordings",
        "=1+2.csv",
        "--set",
        "law.family=harmonic",
    ];
    run(&[
        &sweep[..],
        &[
            "--set",
            "limits={}",
            "--set",
            "accuracy.rms=50 %",
            "--out",
            "t.csv",
        ],
    ]
    .concat());
    let table = fs::read_to_string(folder.path().join("t.csv")).unwrap();
    assert!(
        table.contains(",'=1+2.csv,") && !table.contains(",="),
        "{table}"
    );
    let front = run(&["front", "t.csv", "--out", "front"]);
    assert!(front.contains(" =1+2.csv"), "{front}");
    let front = fs::read_to_string(folder.path().join("front/front.csv")).unwrap();
    assert!(front.contains("'=1+2.csv"), "{front}");
}

#[test]
fn a_varied_key_counts_as_given_and_a_heavy_flywheel_halves_the_ripple_when_doubled() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("flywheel.csv");
    // The scene is complete only with the varied rated speed.
    let motor = [
        "--set",
        "machine.motor.rated_torque=2.5 N m",
        "--set",
        "machine.motor.gear=12.6",
    ];
    let vary = [
        "--vary",
        "machine.motor.rated_speed=1400 rpm",
        "--vary",
        "machine.inertia=200 kg m^2,400 kg m^2",
    ];
    let output = sweep(&out, &[motor, vary].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let mut reader = csv::Reader::from_path(&out).unwrap();
    let column = |name: &str, header: &csv::StringRecord| header.iter().position(|h| h == name);
    let ripple = column("shaft_ripple", reader.headers().unwrap()).unwrap();
    let values: Vec<f64> = (reader.records())
        .map(|row| row.unwrap()[ripple].parse().unwrap())
        .collect();
    assert_eq!(values.len(), 2);
    // The torque of the cam is the same, so the ripple is inverse to the inertia.
    assert!(values[0] > 1e-5, "{values:?}");
    assert!((values[1] / values[0] - 0.5).abs() < 0.01, "{values:?}");
    // Without the key the scene is refused.
    let refused = sweep(&out, &[&motor[..], &["--vary", vary[3]]].concat());
    assert!(
        stderr(&refused).contains("rated_speed"),
        "{}",
        stderr(&refused)
    );
}

#[test]
fn an_estimate_counts_the_rows_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("t.csv");
    let vary = ["--vary", "limits.stroke=20 mm:60 mm:5000", "--estimate"];
    let output = sweep(&out, &[&vary[..], &["--json", "--jobs", "2"]].concat());
    let estimate = crate::support::object(&output);
    assert_eq!(estimate["rows"], 5000);
    let number = |key: &str| estimate[key].as_f64().unwrap();
    assert!(number("computed") >= 100.0, "{estimate}");
    let both = 2.0 * number("estimate_s") * number("rows_per_core_s");
    assert!((both / 5000.0 - 1.0).abs() < 1e-9, "{estimate}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    let resumed = sweep(&out, &[&vary[..], &["--resume"]].concat());
    assert_eq!(resumed.status.code(), Some(2));
}

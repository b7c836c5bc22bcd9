//! Shares of a sweep in one folder of blocks.

use super::sweep;
use crate::support::{gaitcam, object, run_in, stderr, walk};

#[test]
fn shards_fill_one_folder_that_front_reads() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("blocks");
    let vary = [
        "--vary",
        "law.family=harmonic",
        "--vary",
        "gait.body_weight=600 N:800 N:10",
    ];
    let share = |which: &str| {
        let more = ["--shard", which, "--block-rows", "3"];
        sweep(&out, &[&vary[..], &more].concat())
    };
    for which in ["1/2", "2/2", "1/2"] {
        let output = share(which);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
    }
    let mut names: Vec<String> = std::fs::read_dir(&out)
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names.len(), 5, "{names:?}");
    assert_eq!(names[0], "_plan.json");
    let ending = if cfg!(feature = "parquet") {
        "parquet"
    } else {
        "csv"
    };
    assert_eq!(names[4], format!("rows-000000000009-000000000010.{ending}"));
    let other = [
        "--vary",
        "gait.body_weight=600 N:900 N:10",
        "--shard",
        "1/2",
        "--block-rows",
        "3",
    ];
    let refused = sweep(&out, &other);
    assert_eq!(refused.status.code(), Some(2));
    let front = gaitcam(&[
        "front",
        "--json",
        "--minimise",
        "stroke",
        "--out",
        folder.path().join("front").to_str().unwrap(),
        out.to_str().unwrap(),
    ]);
    let found: serde_json::Value = object(&front);
    assert_eq!(found["rows"], 10);
}

/// A folder, a list and a file are values of one axis. The shares of the sweep have the rows of the whole.
#[test]
fn walkers_of_folders_and_lists_are_an_axis_in_one_table_and_in_shares() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    std::fs::create_dir_all(at.join("people/slow")).unwrap();
    for name in ["people/a.csv", "people/slow/b.csv", "c.csv"] {
        walk(&at.join(name));
    }
    let vary = r#"gait.file=people, ["people/a.csv", "c.csv"], c.csv"#;
    let common = [
        "sweep",
        "--set",
        "law.spans=10",
        "--set",
        "accuracy.rms=none",
        "--vary",
        vary,
    ];
    let whole = run_in(at, &[&common[..], &["--out", "whole.csv"]].concat());
    assert_eq!(whole.status.code(), Some(0), "{}", stderr(&whole));
    let more = ["--shard", "1/1", "--block-rows", "3", "--out", "blocks"];
    let share = run_in(at, &[&common[..], &more].concat());
    assert_eq!(share.status.code(), Some(0), "{}", stderr(&share));
    let text = std::fs::read_to_string(at.join("whole.csv")).unwrap();
    let mut table = csv::Reader::from_reader(text.as_bytes());
    let names = table.headers().unwrap().clone();
    let place = |name: &str| names.iter().position(|n| n == name).unwrap();
    let rows: Vec<csv::StringRecord> = table.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 3);
    assert!(
        rows.iter().all(|r| &r[place("outcome")] == "built"),
        "{rows:?}"
    );
    assert_eq!(&rows[0][place("gait.file")], "people");
    let front = run_in(
        at,
        &[
            "front",
            "--json",
            "--minimise",
            "stroke",
            "--out",
            "front",
            "blocks",
        ],
    );
    let best = object(&front)["best"]["stroke_m"].as_f64().unwrap();
    let least = rows
        .iter()
        .map(|r| r[place("stroke_m")].parse::<f64>().unwrap());
    let least = least.fold(f64::INFINITY, f64::min);
    assert!((best / least - 1.0).abs() < 1e-12, "{best} {least}");
    // What travels holds the folder: the row is there without it.
    let plan = std::fs::read_to_string(at.join("blocks/_plan.json")).unwrap();
    assert!(plan.contains("people/slow/b.csv"), "{plan}");
}

//! Shares of a sweep in one folder of blocks.

use super::sweep;
use crate::support::{gaitcam, object};

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

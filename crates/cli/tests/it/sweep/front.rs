//! Best design from the table of a sweep.

use std::path::Path;
use std::process::Output;

use super::sweep;
use crate::support::{ROOT, gaitcam, object, run_in, stderr};

fn front(arguments: &[&str]) -> Output {
    gaitcam(&[&["front"], arguments].concat())
}

#[test]
fn the_best_of_a_sweep_opens_as_the_design_that_its_row_describes() {
    let folder = tempfile::tempdir().unwrap();
    let (table, out) = (folder.path().join("t.csv"), folder.path().join("front"));
    let vary = [
        "--set",
        "accuracy.rms=20 %",
        "--vary",
        "limits.stroke=42 mm:50 mm:5",
        "--vary",
        "law.spans=12,16",
        "--vary",
        "limits.curvature=5 mm:40 mm:3",
    ];
    assert_eq!(sweep(&table, &vary).status.code(), Some(0));
    let (file, dir) = (table.to_str().unwrap(), out.to_str().unwrap());
    let compared = front(&[
        file,
        "--minimise",
        "force_error,prime_radius,jerk",
        "--out",
        dir,
        "--json",
    ]);
    assert_eq!(compared.status.code(), Some(0), "{}", stderr(&compared));
    let json: serde_json::Value = object(&compared);
    for name in [
        "front.csv",
        "front.svg",
        "front.png",
        "parallel.png",
        "report.html",
    ] {
        assert!(out.join(name).metadata().unwrap().len() > 100, "{name}");
    }
    let best = front(&[
        file,
        "--minimise",
        "force_error,prime_radius,jerk",
        "--out",
        dir,
        "--best",
        "--json",
    ]);
    assert_eq!(best.status.code(), Some(0), "{}", stderr(&best));
    let summary: serde_json::Value = object(&best);
    let of_table = json["best"]["force_rms_error_percent"].as_f64().unwrap();
    let of_design = summary["force"]["rms_error_percent_of_mean"]
        .as_f64()
        .unwrap();
    assert!(
        (of_table / of_design - 1.0).abs() < 1e-9,
        "{of_table} {of_design}"
    );
    let radius = json["best"]["prime_radius_m"].as_f64().unwrap();
    assert!((radius / summary["cam"]["prime_radius_m"].as_f64().unwrap() - 1.0).abs() < 1e-9);
    assert!(out.join("best/profile.csv").exists() && out.join("best.toml").exists());
}

/// The scene of the best row refers to its recordings like the swept scene: relative to that scene, not to the working directory.
#[test]
fn the_best_of_a_sweep_finds_the_recordings_beside_its_scene() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    std::fs::create_dir(at.join("people")).unwrap();
    let recording = Path::new(ROOT).join("data/gait_curves/young_1.85Hz_700N.csv");
    for name in ["a.csv", "b.csv"] {
        std::fs::copy(&recording, at.join("people").join(name)).unwrap();
    }
    for (name, file) in [("one", "\"a.csv\""), ("walkers", "[\"a.csv\", \"b.csv\"]")] {
        let scene =
            format!("name = \"{name}\"\n[gait]\nfile = {file}\n[accuracy]\nrms = \"none\"\n");
        std::fs::write(at.join("people/scene.toml"), scene).unwrap();
        let table = format!("{name}.csv");
        let vary = "law.spans=10,12";
        let swept = run_in(
            at,
            &[
                "sweep",
                "people/scene.toml",
                "--vary",
                vary,
                "--out",
                &table,
            ],
        );
        assert_eq!(swept.status.code(), Some(0), "{}", stderr(&swept));
        let best = run_in(
            at,
            &[
                "front",
                &table,
                "--minimise",
                "stroke",
                "--best",
                "--out",
                name,
            ],
        );
        assert_eq!(best.status.code(), Some(0), "{}", stderr(&best));
    }
}

#[test]
fn front_refuses_what_is_no_sweep_and_unknown_objectives() {
    let folder = tempfile::tempdir().unwrap();
    let no_sweep = front(&["data/gait_curves/young_1.85Hz_700N.csv"]);
    assert_eq!(no_sweep.status.code(), Some(2));
    assert!(
        stderr(&no_sweep).contains("young_1.85Hz_700N.csv"),
        "{}",
        stderr(&no_sweep)
    );
    let table = folder.path().join("t.csv");
    sweep(
        &table,
        &[
            "--vary",
            "law.harmonics=2,3",
            "--set",
            "law.family=harmonic",
        ],
    );
    let unknown = front(&[table.to_str().unwrap(), "--minimise", "prime_radus"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert!(
        stderr(&unknown).contains("did you mean \"prime_radius\"?"),
        "{}",
        stderr(&unknown)
    );
    // Nothing passes: that is no fault of the input.
    sweep(&table, &["--vary", "limits.stroke=1 mm,2 mm"]);
    assert_eq!(front(&[table.to_str().unwrap()]).status.code(), Some(3));
}

/// Missing blocks of a sweep at any position are reported.
#[test]
fn rows_that_a_folder_of_blocks_lacks_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("t.csv");
    let vary = [
        "--vary",
        "law.family=harmonic",
        "--vary",
        "gait.body_weight=600 N:800 N:12",
    ];
    assert_eq!(sweep(&table, &vary).status.code(), Some(0));
    let text = std::fs::read_to_string(&table).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    for lost in [
        vec![],
        vec![0],
        vec![2],
        vec![5],
        vec![0, 2, 3],
        vec![1, 4, 5],
    ] {
        let blocks = folder.path().join(format!("blocks-{lost:?}"));
        std::fs::create_dir(&blocks).unwrap();
        std::fs::write(
            blocks.join("_plan.json"),
            "{\"rows\": 12, \"block_rows\": 2}",
        )
        .unwrap();
        for block in (0..6).filter(|block| !lost.contains(block)) {
            let (start, end) = (2 * block, 2 * block + 2);
            let rows = [&lines[..1], &lines[1 + start..1 + end]]
                .concat()
                .join("\n")
                + "\n";
            std::fs::write(blocks.join(format!("rows-{start:012}-{end:012}.csv")), rows).unwrap();
        }
        let out = folder.path().join("front");
        let arguments = [
            blocks.to_str().unwrap(),
            "--json",
            "--out",
            out.to_str().unwrap(),
        ];
        let output = front(&arguments);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        let json: serde_json::Value = object(&output);
        let ranges = json["missing_rows"].as_array().unwrap();
        let named: Vec<u64> = (ranges.iter())
            .flat_map(|range| range[0].as_u64().unwrap()..=range[1].as_u64().unwrap())
            .collect();
        let expected: Vec<u64> = lost
            .iter()
            .flat_map(|b| [2 * b, 2 * b + 1])
            .map(|r| r as u64)
            .collect();
        assert_eq!(named, expected);
        let said = stderr(&output);
        let count = format!("{} rows are missing in the folder", expected.len());
        assert_eq!(said.contains(&count), !lost.is_empty(), "{said}");
    }
}

//! Motions from the rows of a CSV file. The law equals that of the same rows in the scene; faults name file, line and column.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::support::{object, run_in, stderr};

/// Rows of a 3-4-5 rise of 10 mm over 120°: angle in degrees and lift in millimetres.
fn rise() -> Vec<(f64, f64)> {
    let row = |i: i32| {
        let x = f64::from(i) / 24.0;
        let s = 10.0 * x.powi(3) - 15.0 * x.powi(4) + 6.0 * x.powi(5);
        (120.0 * x, 10.0 * s)
    };
    (0..=24).map(row).collect()
}

fn csv(header: &str, rows: &[(f64, f64)]) -> String {
    rows.iter().fold(header.to_string(), |mut text, (x, s)| {
        let _ = write!(text, "\n{x},{s}");
        text
    })
}

/// Writes a scene whose first segment is `segment`. Two further segments return the follower.
fn scene(folder: &Path, segment: &str) {
    let text = format!(
        "name = \"lift\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"60 rpm\"\n[law]\nfamily = \"program\"\n\
         [[law.segment]]\n{segment}\n\
         [[law.segment]]\nmotion = \"dwell\"\nangle = \"60 deg\"\n\
         [[law.segment]]\nmotion = \"cycloidal\"\nlift = \"-10 mm\"\nangle = \"180 deg\"\n\
         [cam]\nfollower = \"roller-translating\"\nprime_radius = \"50 mm\"\nroller_radius = \"10 mm\"\n"
    );
    fs::write(folder.join("scene.toml"), text).unwrap();
}

/// Rows of the law, s to j, of a synthesis in the folder.
fn law(folder: &Path, arguments: &[&str]) -> Vec<Vec<f64>> {
    let all = [&["synth"], arguments, &["--out", "out", "--no-png"]].concat();
    let output = run_in(folder, &all);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let mut reader = csv::Reader::from_path(folder.join("out/law.csv")).unwrap();
    let numbers = |r: csv::StringRecord| r.iter().take(5).map(|x| x.parse().unwrap()).collect();
    reader.records().map(|r| numbers(r.unwrap())).collect()
}

/// Asserts that two laws are equal: the lift to 1e-14 of the stroke, each derivative to a tolerance 24 times larger. Rounding errors of rows at a
/// distance of 1/24 grow by this factor.
fn same(a: &[Vec<f64>], b: &[Vec<f64>]) {
    assert_eq!(a.len(), b.len());
    for (column, order) in [(0, 0), (1, 0), (2, 1), (3, 2), (4, 3)] {
        let largest = a.iter().map(|r| r[column].abs()).fold(0.0, f64::max);
        let near = 1e-14 * 24f64.powi(order) * largest;
        for (x, y) in a.iter().zip(b) {
            let off = (x[column] - y[column]).abs();
            assert!(off <= near, "column {column}: {off} of {largest}");
        }
    }
}

#[test]
fn a_file_of_rows_is_the_same_law_as_the_rows_written_out() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let written = rise().iter().fold("table".to_string(), |mut text, (x, s)| {
        let _ = write!(text, " {} {}", x / 120.0, s / 10.0);
        text
    });
    let sizes = "lift = \"10 mm\"\nangle = \"120 deg\"";
    scene(folder, &format!("motion = \"{written}\"\n{sizes}"));
    let inline = law(folder, &["scene.toml"]);
    // The rows are on the 3-4-5 curve, a polynomial of the spline's own degree.
    let middle = &inline[inline.len() / 6];
    assert!((middle[1] - 0.005).abs() < 1e-12, "{middle:?}");

    fs::write(
        folder.join("my lift.csv"),
        csv("angle_deg,lift_mm", &rise()),
    )
    .unwrap();
    for segment in ["", sizes] {
        scene(
            folder,
            &format!("motion = \"table my lift.csv\"\n{segment}"),
        );
        same(&inline, &law(folder, &["scene.toml"]));
    }
    let radians: Vec<(f64, f64)> = rise()
        .iter()
        .map(|r| (r.0.to_radians(), r.1 / 25.4))
        .collect();
    fs::write(
        folder.join("inch.csv"),
        csv("Theta [rad],Lift (in)", &radians),
    )
    .unwrap();
    let german = rise()
        .iter()
        .fold("lift_mm;angle_deg".to_string(), |mut text, (x, s)| {
            let _ = write!(text, "\n{s};{x}");
            text.replace('.', ",")
        });
    fs::write(folder.join("german.csv"), german).unwrap();
    for file in ["inch.csv", "german.csv"] {
        scene(folder, &format!("motion = \"table {file}\""));
        same(&inline, &law(folder, &["scene.toml"]));
    }
}

#[test]
fn paths_are_relative_to_the_scene_file_and_after_set_to_the_working_directory() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let inner = folder.join("inner");
    fs::create_dir(&inner).unwrap();
    fs::write(inner.join("lift.csv"), csv("angle_deg,lift_mm", &rise())).unwrap();
    scene(&inner, "motion = \"table lift.csv\"");
    let first = law(folder, &["inner/scene.toml"]);
    // The settled scene needs the file no more, from wherever it is read.
    fs::rename(inner.join("lift.csv"), folder.join("moved.csv")).unwrap();
    fs::rename(folder.join("out"), inner.join("kept")).unwrap();
    same(&first, &law(folder, &["inner/kept/scene.toml"]));
    let set = "law.segment.1.motion=table moved.csv";
    same(&first, &law(folder, &["inner/scene.toml", "--set", set]));
    // A sweep and a run of the cam take the scene with its file as well.
    let table = folder.join("t.csv");
    let radii = "cam.prime_radius=50 mm,60 mm";
    let sweep = [
        "sweep",
        "inner/scene.toml",
        "--set",
        set,
        "--vary",
        radii,
        "--out",
        "t.csv",
    ];
    let swept = run_in(folder, &sweep);
    assert_eq!(swept.status.code(), Some(0), "{}", stderr(&swept));
    let mut reader = csv::Reader::from_path(&table).unwrap();
    let names = reader.headers().unwrap().clone();
    let stroke = names.iter().position(|n| n == "stroke_m").unwrap();
    let strokes: Vec<f64> = reader
        .records()
        .map(|r| r.unwrap()[stroke].parse().unwrap())
        .collect();
    assert_eq!(strokes.len(), 2);
    assert!(
        strokes.iter().all(|s| (s - 0.01).abs() < 1e-12),
        "{strokes:?}"
    );
    let run = run_in(
        folder,
        &["simulate", "inner/scene.toml", "--set", set, "--json"],
    );
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
}

#[test]
fn a_motion_file_is_never_written_over() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("law.csv"), csv("angle_deg,lift_mm", &rise())).unwrap();
    scene(folder, "motion = \"table law.csv\"");
    let output = run_in(folder, &["synth", "scene.toml", "--out", "."]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        stderr(&output).contains("law.csv would be replaced"),
        "{}",
        stderr(&output)
    );
}

/// Exit code and error of a scene whose first segment is a table with this content.
fn refused(content: &str, segment: &str) -> (Option<i32>, Value) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("lift.csv"), content).unwrap();
    scene(folder.path(), segment);
    let output = run_in(folder.path(), &["synth", "scene.toml", "--json"]);
    (output.status.code(), object(&output))
}

/// File of `rise` with another text in one line.
fn line(number: usize, text: &str) -> String {
    let good = csv("angle_deg,lift_mm", &rise());
    let mut lines: Vec<&str> = good.lines().collect();
    lines[number - 1] = text;
    lines.join("\n")
}

const TABLE: &str = "motion = \"table lift.csv\"";

/// Asserts that a scene whose first segment is a table with this content is rejected, with this code, line and word in the error.
fn refuses(code: &str, content: &str, segment: &str, line: Option<usize>, named: &str) {
    let (exit, json) = refused(content, segment);
    let error = &json["error"];
    assert_eq!(
        (exit, error["code"].as_str()),
        (Some(2), Some(code)),
        "{json}"
    );
    let text = error.to_string();
    if !code.starts_with("law-uncovered") {
        assert!(text.contains(".csv"), "{text}");
    }
    if let Some(number) = line {
        let place = error["place"].as_str().unwrap();
        assert!(
            place.ends_with(&format!("lift.csv line {number}")),
            "{text}"
        );
    }
    assert!(text.contains(named), "{text}");
}

#[test]
fn faulty_files_are_refused_by_line_and_column() {
    let good = csv("angle_deg,lift_mm", &rise());
    refuses(
        "file-motion-value",
        &line(6, "20,NaN"),
        TABLE,
        Some(6),
        "lift_mm",
    );
    refuses(
        "file-motion-value",
        &line(7, "25"),
        TABLE,
        Some(7),
        "lift_mm",
    );
    refuses(
        "file-motion-value",
        &line(9, "35,high"),
        TABLE,
        Some(9),
        "lift_mm",
    );
    refuses(
        "file-motion-order",
        &line(8, "25,1"),
        TABLE,
        Some(8),
        "angle_deg",
    );
    refuses(
        "file-motion-unit",
        &line(1, "angle,lift_mm"),
        TABLE,
        Some(1),
        "angle",
    );
    refuses(
        "file-motion-unit",
        &line(1, "angle_deg,lift_s"),
        TABLE,
        Some(1),
        "lift_s",
    );
    refuses(
        "file-motion-column",
        &line(1, "phase_deg,lift_mm"),
        TABLE,
        Some(1),
        "angle",
    );
    refuses(
        "file-motion-column",
        &good.lines().skip(1).collect::<Vec<_>>().join("\n"),
        TABLE,
        Some(1),
        "lift",
    );
}

#[test]
fn rows_that_make_no_motion_are_refused() {
    let good = csv("angle_deg,lift_mm", &rise());
    let stated = |key: &str, value: &str| format!("{TABLE}\n{key} = \"{value}\"");
    let long: Vec<(f64, f64)> = (0..=10_000).map(|i| (f64::from(i), f64::from(i))).collect();
    refuses(
        "law-table-rows",
        &good.lines().take(2).collect::<Vec<_>>().join("\n"),
        TABLE,
        None,
        "",
    );
    refuses(
        "law-table-level",
        &csv(
            "angle_deg,lift_mm",
            &[(0.0, 1.0), (60.0, 9.0), (120.0, 1.0)],
        ),
        TABLE,
        None,
        "",
    );
    refuses(
        "file-motion-many-rows",
        &csv("angle_deg,lift_mm", &long),
        TABLE,
        Some(10_002),
        "",
    );
    refuses(
        "file-motion-differs",
        &good,
        &stated("angle", "90 deg"),
        None,
        "angle_deg",
    );
    refuses(
        "file-motion-differs",
        &good,
        &stated("lift", "-10 mm"),
        None,
        "lift_mm",
    );
    // The rows cover a third of the turn, the dwell and the fall two thirds; 110° leave 10° open.
    refuses(
        "law-uncovered",
        &csv("angle_deg,lift_mm", &[(0.0, 0.0), (110.0, 10.0)]),
        TABLE,
        None,
        "",
    );
}

#[test]
fn files_that_are_no_table_are_refused() {
    let good = csv("angle_deg,lift_mm", &rise());
    let large = format!("angle_deg,lift_mm\n0,0\n{}", " ".repeat(64 << 20));
    refuses(
        "file-cannot-read",
        &good,
        "motion = \"table none.csv\"",
        None,
        "",
    );
    refuses("read-empty", "", TABLE, None, "");
    refuses("file-no-table", "nothing but words", TABLE, None, "lift_mm");
    refuses("read-foreign", "PK\u{3}\u{4} a workbook", TABLE, None, "");
    refuses("file-too-large", &large, TABLE, None, "64 MiB");
}

#[test]
fn a_sweep_over_files_says_that_it_takes_rows() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(
        folder.path().join("lift.csv"),
        csv("angle_deg,lift_mm", &rise()),
    )
    .unwrap();
    scene(
        folder.path(),
        "motion = \"cycloidal\"\nlift = \"10 mm\"\nangle = \"120 deg\"",
    );
    let vary = "law.segment.1.motion=cycloidal,table lift.csv";
    let output = run_in(
        folder.path(),
        &["sweep", "scene.toml", "--vary", vary, "--out", "t.csv"],
    );
    assert_eq!(output.status.code(), Some(2));
    let said = stderr(&output);
    assert!(
        said.contains("lift.csv") && said.contains("the rows themselves"),
        "{said}"
    );
}

//! `gaitcam inspect`: a measured cam compared with its design, and rejected measurements.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use crate::support::{gaitcam, object, stderr, stdout};

/// Profile of a result, rotated by 40° about (12, −7) mm, every 4th point in reverse order. Polar coordinates in degrees and mm, with a further
/// column between them.
fn polar(folder: &Path) -> String {
    let profile = fs::read_to_string(folder.join("profile.csv")).unwrap();
    let rows: Vec<&str> = profile.lines().skip(1).collect();
    let mut out = String::from("angle_deg;quality;radius_mm\n");
    let (sin, cos) = 40.0_f64.to_radians().sin_cos();
    for row in rows.iter().rev().step_by(4) {
        let cells: Vec<f64> = row.split(',').take(3).map(|c| c.parse().unwrap()).collect();
        let (x, y) = (1e3 * cells[1], 1e3 * cells[2]);
        let (x, y) = (12.0 + cos * x - sin * y, -7.0 + sin * x + cos * y);
        writeln!(out, "{:?};good;{:?}", y.atan2(x).to_degrees(), x.hypot(y)).unwrap();
    }
    out
}

#[test]
fn a_cut_cam_is_found_where_it_lies_and_does_what_was_designed() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let design = path("design");
    let scene = "scenes/heel_tester.toml";
    gaitcam(&["synth", scene, "--out", &design, "--no-png"]);
    fs::write(path("measured.csv"), polar(Path::new(&design))).unwrap();
    let run = gaitcam(&[
        "inspect",
        &design,
        &path("measured.csv"),
        "--out",
        &path("out"),
        "--json",
    ]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let found: serde_json::Value = object(&run);
    let number = |at: &str| found.pointer(at).unwrap().as_f64().unwrap();
    assert_eq!(number("/points"), 360.0);
    assert!((number("/turn_rad").to_degrees() - 40.0).abs() < 1e-6);
    assert!((number("/centre_m/0") - 0.012).abs() < 1e-9);
    assert!((number("/centre_m/1") + 0.007).abs() < 1e-9);
    assert!(number("/deviation/rms_m") < 1e-9);
    let force = |of: &str| number(&format!("/{of}/force_rms_error_n"));
    assert!((force("made") / force("designed") - 1.0).abs() < 1e-6);
    let rows = fs::read_to_string(path("out/inspection.csv")).unwrap();
    assert_eq!(rows.lines().count(), 361);
    for name in [
        "deviation.svg",
        "deviation.png",
        "deviation_polar.svg",
        "inspection.json",
    ] {
        assert!(fs::metadata(path("out")).unwrap().is_dir());
        assert!(
            fs::metadata(Path::new(&path("out")).join(name))
                .unwrap()
                .len()
                > 200,
            "{name}"
        );
    }
    // In words, in the folder of the design, in Spanish.
    let run = gaitcam(&["inspect", &design, &path("measured.csv"), "--lang", "es"]);
    let said = stdout(&run);
    assert!(
        said.contains("girada 40°") && said.contains("x 12 mm"),
        "{said}"
    );
    assert!(Path::new(&design).join("deviation.svg").exists());
}

#[test]
fn measurements_that_cannot_be_used_are_refused_by_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let file = path("measured.csv");
    let refused = |content: &str| {
        fs::write(&file, content).unwrap();
        let run = gaitcam(&["inspect", "scenes/camdas_01_roller.toml", &file, "--json"]);
        assert_eq!(run.status.code(), Some(2), "{content}");
        stderr(&run)
    };
    let columns = refused("x,y\n1,2\n");
    assert!(
        columns.contains("line 1") && columns.contains("x_mm,y_mm"),
        "{columns}"
    );
    let nan = refused("x_mm,y_mm\n1,2\n3,nan\n");
    assert!(nan.contains("line 3") && nan.contains("\"nan\""), "{nan}");
    let few = refused("x_mm,y_mm\n1,2\n3,4\n");
    assert!(
        few.contains("2 measured points") && few.contains("12"),
        "{few}"
    );
    let mut other = String::from("x_mm,y_mm\n");
    for i in 0..40 {
        let angle = f64::from(i) * 0.157;
        writeln!(other, "{},{}", 10.0 * angle.cos(), 3.0 * angle.sin()).unwrap();
    }
    let other = refused(&other);
    assert!(other.contains("do not belong to this cam"), "{other}");
    fs::write(&file, "x_mm,y_mm\n").unwrap();
    let run = gaitcam(&["inspect", "no_such.toml", &file]);
    assert_eq!(run.status.code(), Some(2));
}

//! `gaitcam identify` and `gaitcam recut`: a log of the machine, rejected logs, and a cam with a smaller force error.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::support::{gaitcam, object, stderr, stdout};

/// Writes a log of the machine of a result at 111 rpm: its force with a repeatable error and ±3 N of scatter.
fn log(folder: &Path, repeats: f64) -> String {
    let law = fs::read_to_string(folder.join("law.csv")).unwrap();
    let force = |row: &str| row.split(',').nth(5).unwrap().parse::<f64>().unwrap();
    let forces: Vec<f64> = law.lines().skip(1).map(force).collect();
    let mut out = String::from("time_s,theta_rad,force_n\n");
    for i in 0..9000_u64 {
        let time = i as f64 / 900.0;
        let theta = TAU * 1.85 * time;
        let place = (theta / TAU).fract() * forces.len() as f64;
        let (at, part) = (place as usize, place.fract());
        let next = forces[(at + 1) % forces.len()];
        let scatter = (i * 7919 % 601) as f64 / 100.0 - 3.0;
        let extra = repeats * ((2.0 * theta).sin() + 0.5 * (5.0 * theta).cos());
        let force = forces[at] + part * (next - forces[at]) + extra + scatter;
        writeln!(out, "{time:.5},{:.6},{force:.3}", theta % TAU).unwrap();
    }
    out
}

#[test]
fn what_repeats_is_corrected_and_noise_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let design = path("design");
    gaitcam(&["synth", "footbridge", "--out", &design, "--no-png"]);
    fs::write(path("log.csv"), log(Path::new(&design), 9.0)).unwrap();
    fs::write(path("quiet.csv"), log(Path::new(&design), 0.0)).unwrap();

    let run = gaitcam(&[
        "identify",
        &design,
        &path("log.csv"),
        "--out",
        &path("found"),
        "--json",
    ]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let found = object(&run);
    let parameters = found["parameters"].as_array().unwrap();
    let parameter = |key: &str| parameters.iter().find(|p| p["key"] == key).unwrap();
    for name in ["key", "value", "low", "high", "identifiable"] {
        assert!(parameters.iter().all(|p| p.get(name).is_some()), "{name}");
    }
    assert!((parameter("drive.mass")["value"].as_f64().unwrap() / 71.36 - 1.0).abs() < 0.05);
    assert_eq!(parameter("log.delay")["identifiable"], false);
    assert!((found["noise_rms_n"].as_f64().unwrap() - 1.73).abs() < 0.1);
    let written = fs::read(path("found/identify.json")).unwrap();
    assert_eq!(serde_json::from_slice::<Value>(&written).unwrap(), found);
    // The scene is one that can be designed.
    let scene = path("found/identified.toml");
    let again = gaitcam(&["doctor", &scene]);
    assert!(again.status.code() != Some(2), "{}", stderr(&again));
    for name in ["identify.svg", "identify.png"] {
        assert!(
            fs::metadata(path("found")).is_ok_and(|f| f.is_dir()),
            "{name}"
        );
        assert!(
            fs::metadata(Path::new(&path("found")).join(name))
                .unwrap()
                .len()
                > 1000
        );
    }
    let said = stdout(&gaitcam(&[
        "identify",
        &design,
        &path("log.csv"),
        "--out",
        &path("es"),
        "--lang",
        "es",
    ]));
    assert!(
        said.contains("no identificado") && said.contains("célula"),
        "{said}"
    );

    let run = gaitcam(&[
        "recut",
        &design,
        &path("log.csv"),
        "--out",
        &path("cut"),
        "--json",
        "--no-png",
    ]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let cut = object(&run);
    let error = |name: &str| cut["recut"][name].as_f64().unwrap();
    // 9 N in harmonic 2, 4.5 N in harmonic 5, and 3.5 N that the design misses by.
    assert!((error("before_rms_n") - 7.9).abs() < 1.0, "{cut}");
    assert!(error("predicted_rms_n") < 3.6);
    assert!(fs::metadata(path("cut/profile.dxf")).is_ok());
    // The result stands for itself: run, it presses as it says.
    let run = object(&gaitcam(&["simulate", &path("cut"), "--json"]));
    let simulated = run["force"]["rms_error_n"].as_f64().unwrap();
    assert!((simulated - cut["force"]["rms_error_n"].as_f64().unwrap()).abs() < 0.05);

    let refused = gaitcam(&["recut", &design, &path("quiet.csv"), "--out", &path("none")]);
    assert_eq!(refused.status.code(), Some(3), "{}", stderr(&refused));
    assert!(
        stderr(&refused).contains("cannot be distinguished from the noise")
            && !Path::new(&path("none")).exists()
    );
}

#[test]
fn options_name_the_columns_of_a_log_and_several_logs_count_together() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let design = path("design");
    gaitcam(&["synth", "footbridge", "--out", &design, "--no-png"]);
    let plain = log(Path::new(&design), 9.0);
    fs::write(path("plain.csv"), &plain).unwrap();
    // The second log has twice the force that repeats, in the units of a controller.
    let other = log(Path::new(&design), 18.0);
    let rows = other.lines().skip(1).map(|row| {
        let cells: Vec<f64> = row.split(',').map(|c| c.parse().unwrap()).collect();
        let counts = (4096.0 * cells[1] / TAU).round();
        format!("{};{counts};{}", 1e3 * cells[0], 1e-3 * cells[2]).replace('.', ",")
    });
    let rows: Vec<String> = rows.collect();
    let controller = format!("t;Encoder;Cell\nms;counts;kN\n{}\n", rows.join("\n"));
    fs::write(path("plc.csv"), controller).unwrap();
    let run = |logs: &[&str], options: &[&str]| {
        let logs: Vec<String> = logs.iter().map(|name| path(name)).collect();
        let logs = logs.iter().map(String::as_str);
        let begin = ["identify", design.as_str()].into_iter();
        let all: Vec<&str> = begin
            .chain(logs)
            .chain(options.iter().copied())
            .chain(["--json"])
            .collect();
        gaitcam(&all)
    };
    let counts = ["--counts-per-turn", "4096"];
    let refused = run(&["plc.csv"], &[]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(
        stderr(&refused).contains("counts-per-turn"),
        "{}",
        stderr(&refused)
    );
    let one = object(&run(&["plc.csv"], &counts));
    let named = ["--time", "1", "--angle", "encoder", "--force", "Cell"];
    let named = [&counts[..], &named[..]].concat();
    assert_eq!(object(&run(&["plc.csv"], &named)), one);
    let copies = run(&["plain.csv", "plain.csv"], &[]);
    assert_eq!(copies.status.code(), Some(2));
    assert!(stderr(&copies).contains("copy of plain.csv"));
    fs::write(path("second.csv"), other).unwrap();
    let both = object(&run(&["plain.csv", "second.csv"], &[]));
    assert_eq!(both["logs"].as_array().unwrap().len(), 2, "{both}");
    assert_eq!(both["cycles"], 36, "{both}");
}

#[test]
fn bad_logs_end_with_code_2_and_write_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    for (name, text, says) in [
        ("rows.csv", "time_s,force_n\n0,1\n1,2\n2,3\n", "3 rows"),
        ("columns.csv", "time_s,weight\n0,1\n1,2\n", "force_n"),
        ("nan.csv", "time_s,force_n\n0,1\n1,nan\n", "line 3"),
        ("time.csv", "time_s,force_n\n1,1\n0,2\n", "line 3"),
    ] {
        fs::write(path(name), text).unwrap();
        for verb in ["identify", "recut"] {
            let out = path("out");
            let run = gaitcam(&[verb, "footbridge", &path(name), "--out", &out]);
            assert_eq!(run.status.code(), Some(2), "{verb} {name}");
            assert!(stderr(&run).contains(says), "{}", stderr(&run));
            assert!(!Path::new(&out).exists());
        }
    }
    let run = gaitcam(&["identify", "footbridge", &path("none.csv")]);
    assert_eq!(run.status.code(), Some(2));
}

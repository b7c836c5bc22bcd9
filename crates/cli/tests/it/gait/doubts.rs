//! Messages of `gaitcam gait` on misleading recordings, and on cycles that it has written.

use std::f64::consts::PI;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Output;

use serde_json::Value;

use crate::support::{gaitcam, object, stderr};

const WEIGHT: f64 = 70.0 * 9.81;
const STRIDE: f64 = 1.1;
const STANCE: f64 = 0.66;

/// Force of one foot t s after heel strike, N: two peaks, with a mean over a stride of half the weight.
fn foot(t: f64) -> f64 {
    let x = t.rem_euclid(STRIDE) / STANCE;
    if x >= 1.0 {
        return 0.0;
    }
    // ∫ over the stance of sin πx + 0.3 sin 3πx is (2/π)·1.1.
    let scale = 0.5 * STRIDE / (STANCE * 2.0 / PI * 1.1);
    WEIGHT * scale * ((PI * x).sin() + 0.3 * (3.0 * PI * x).sin())
}

/// Recording of both feet at 200 Hz for 8 s, after half a second beside the plates.
fn walk() -> Vec<[f64; 3]> {
    (0..1600)
        .map(|i| {
            let t = f64::from(i) / 200.0;
            let on = |from: f64| {
                if t > from && t < 7.4 {
                    foot(t - from)
                } else {
                    0.0
                }
            };
            [t, on(0.5), on(0.5 + 0.5 * STRIDE)]
        })
        .collect()
}

fn file(folder: &Path, name: &str, head: &str, row: impl Fn(&[f64; 3]) -> String) -> String {
    let mut text = format!("{head}\n");
    for r in walk() {
        writeln!(text, "{}", row(&r)).unwrap();
    }
    let path = folder.join(name);
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_string()
}

fn gait(arguments: &[&str]) -> Output {
    gaitcam(&[&["gait"], arguments].concat())
}

fn json(arguments: &[&str]) -> Value {
    let output = gait(&[arguments, &["--json"]].concat());
    let words = stderr(&output);
    assert_eq!(output.status.code(), Some(0), "{words}");
    object(&output)
}

/// Whether a recording has a warning with this code.
fn warns(found: &Value, code: &str) -> bool {
    let warnings = found["warnings"].as_array().unwrap();
    warnings.iter().any(|w| w["code"] == code)
}

fn plain(folder: &Path) -> String {
    file(folder, "walk.csv", "time_s,left_fz_n,right_fz_n", |r| {
        format!("{:.4},{:.3},{:.3}", r[0], r[1], r[2])
    })
}

#[test]
fn a_mass_that_is_not_the_walkers_is_doubted() {
    let folder = tempfile::tempdir().unwrap();
    let walk = plain(folder.path());
    let right = json(&[&walk, "--mass", "70 kg"]);
    assert_eq!(right["cycle"]["mass_fits"], true, "{}", right["notes"]);
    assert!((right["cycle"]["mean_of_weight"].as_f64().unwrap() - 1.0).abs() < 0.03);
    let half = json(&[&walk, "--mass", "35 kg"]);
    assert_eq!(half["cycle"]["mass_fits"], false);
    assert!(warns(&half, "mean-force-not-weight"), "{half}");
    // One foot carries half of the weight.
    let one = json(&[&walk, "--mass", "70 kg", "--feet", "left"]);
    assert_eq!(one["cycle"]["mass_fits"], true, "{}", one["notes"]);
    // Insoles that were never calibrated: no mass is given, and no such walker exists.
    let grams = file(
        folder.path(),
        "grams.csv",
        "time_s,left_fz_n,right_fz_n",
        |r| format!("{:.4},{:.3},{:.3}", r[0], 9.0 * r[1], 9.0 * r[2]),
    );
    assert_eq!(json(&[&grams])["cycle"]["mass_fits"], false);
    // A cam made from the walk says the same.
    let folder = folder.path().to_str().unwrap();
    let file = format!("gait.file={walk}");
    let changes = ["--set", &file, "--set", "gait.mass=35 kg"];
    let synth = gaitcam(&[&["synth", "--json", "--out", folder][..], &changes].concat());
    let summary: Value = object(&synth);
    let remarks = summary["remarks"].to_string();
    assert!(remarks.contains("mean force over a stride"), "{remarks}");
}

#[test]
fn a_rate_that_overrides_the_times_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let walk = plain(folder.path());
    let code = "rate-overrides-times";
    assert!(warns(&json(&[&walk, "--rate", "190 Hz"]), code));
    assert!(!warns(&json(&[&walk, "--rate", "200 Hz"]), code));
}

#[test]
fn dates_and_quoted_decimal_commas_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let expected = json(&[&plain(folder.path())])["cycle"]["mean_n"].clone();
    let near = |path: &str| {
        let mean = json(&[path])["cycle"]["mean_n"].as_f64().unwrap();
        assert!(
            (mean / expected.as_f64().unwrap() - 1.0).abs() < 1e-3,
            "{path}: {mean}"
        );
    };
    near(&file(
        folder.path(),
        "iso.csv",
        "timestamp,left_fz,right_fz",
        |r| {
            format!(
                "2024-05-01T10:05:{:06.3}Z,{:.3},{:.3}",
                7.0 + r[0],
                r[1],
                r[2]
            )
        },
    ));
    near(&file(folder.path(), "quoted.csv", "Time,Left,Right", |r| {
        format!("\"{:.4}\",\"{:.3}\",\"{:.3}\"", r[0], r[1], r[2]).replace('.', ",")
    }));
}

#[test]
fn a_header_without_rows_is_called_so() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("empty.csv");
    fs::write(&path, "Time (s),Left Fz (N),Right Fz (N)\n").unwrap();
    let output = gait(&[path.to_str().unwrap()]);
    let words = stderr(&output);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        words.contains("no rows of numbers") && words.contains("Left Fz (N)"),
        "{words}"
    );
}

#[test]
fn the_total_of_both_feet_is_walked_through_once_it_is_stepped_on() {
    let folder = tempfile::tempdir().unwrap();
    let total = file(folder.path(), "total.csv", "Time (s),Total Fz (N)", |r| {
        format!("{:.4},{:.3}", r[0], r[1] + r[2])
    });
    let found = json(&[&total, "--mass", "70 kg"]);
    let cycle = &found["cycle"];
    assert!(
        (cycle["period_s"].as_f64().unwrap() - STRIDE).abs() < 0.01,
        "{cycle}"
    );
    assert_eq!(cycle["mass_fits"], true, "{cycle}");
    let one = gait(&[&total, "--feet", "one"]);
    let words = stderr(&one);
    assert!(words.contains("total force of both feet"), "{words}");
}

#[test]
fn its_own_cycle_is_read_again_and_folders_are_made() {
    let folder = tempfile::tempdir().unwrap();
    let walk = plain(folder.path());
    let curve = folder.path().join("not/there/yet/curve.csv");
    let first = json(&[&walk, "--out", curve.to_str().unwrap()]);
    assert!(curve.exists());
    let again = json(&[curve.to_str().unwrap()]);
    assert_eq!(again["format"], "one cycle");
    for key in ["period_s", "mean_n"] {
        let of = |v: &Value| v["cycle"][key].as_f64().unwrap();
        assert!((of(&first) - of(&again)).abs() < 1e-9, "{key}");
    }
}

#[test]
fn a_missing_row_is_mentioned() {
    let folder = tempfile::tempdir().unwrap();
    let walk = plain(folder.path());
    let text = fs::read_to_string(&walk).unwrap();
    let lacking: Vec<&str> = text.lines().filter(|l| !l.starts_with("3.2000,")).collect();
    fs::write(&walk, lacking.join("\n")).unwrap();
    let found = json(&[&walk]);
    assert!(warns(&found, "samples-missing"), "{}", found["warnings"]);
    // (n − 1)/duration.
    assert!((found["rate_hz"].as_f64().unwrap() - 1598.0 / 7.995).abs() < 1e-6);
}

#[test]
fn stances_are_listed_one_by_one_where_asked_and_summed_up_by_foot_otherwise() {
    let folder = tempfile::tempdir().unwrap();
    // 40 stances of each foot; the record begins and ends in the middle of one.
    let row = |i: i32| {
        let t = f64::from(i) / 100.0;
        format!(
            "{t:.2},{:.2},{:.2}\n",
            foot(t + 0.3),
            foot(t + 0.3 - 0.5 * STRIDE)
        )
    };
    let text: String = (0..4450).map(row).collect();
    let path = folder.path().join("long.csv");
    fs::write(&path, format!("time_s,left Fz [N],right Fz [N]\n{text}")).unwrap();
    let path = path.to_str().unwrap();
    let read = json(&[path]);
    let used = read["stances"].as_array().unwrap().len();
    let channels = read["channels"].as_array().unwrap().iter();
    let rejected: usize = channels
        .map(|c| c["rejected"].as_array().unwrap().len())
        .sum();
    assert!(used > 60 && rejected > 1, "{used} {rejected}");
    let lines = |options: &[&str]| {
        let output = gait(&[&[path], options].concat());
        assert!(output.status.success(), "{output:?}");
        let text = String::from_utf8(output.stdout).unwrap();
        let of = |start: &str| {
            let after = text
                .lines()
                .skip_while(|line| !line.starts_with(start))
                .skip(1);
            after.take_while(|line| !line.is_empty()).count()
        };
        [of("foot       start"), of("rejected"), of("foot       n ")]
    };
    let [listed, refused, by_foot] = lines(&["--stances"]);
    assert_eq!([listed, refused], [used, rejected]);
    assert!(by_foot >= 2);
    let [listed, reasons, by_foot] = lines(&[]);
    assert!(listed == 0 && (1..=rejected).contains(&reasons) && by_foot >= 2);
    // Two columns, each cut at both ends at most.
    assert!(reasons <= 4, "{reasons}");
}

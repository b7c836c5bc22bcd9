//! Invalid input is reported with its place and a correction. Existing files stay unchanged.

use std::fs;

use crate::support::{changed, gaitcam, object, stderr, stdout};

/// Exit code and message of a synthesis with changes to the default scene.
fn with(changes: &[&str]) -> (i32, String) {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let output = gaitcam(&changed(
        &["synth", "--out", out.to_str().unwrap()],
        changes,
    ));
    (output.status.code().unwrap(), stderr(&output))
}

/// Asserts that changes to the default scene are rejected in one line, with this place and message.
#[track_caller]
fn refused(changes: &[&str], place: &str, code: &str) {
    let (status, message) = with(changes);
    assert_eq!(
        (status, message.trim().lines().count()),
        (2, 1),
        "{message}"
    );
    let output = gaitcam(&changed(&["synth", "--json"], changes));
    let error = &object(&output)["error"];
    assert_eq!(error["place"], place, "{message}");
    assert_eq!(error["code"], code, "{message}");
}

#[test]
fn scene_faults_name_their_key_and_what_is_wrong() {
    let cases = [
        ("limits.strok=60 mm", "limits.strok", "scene-no-such-key"),
        ("limits.stroke=60", "limits.stroke", "scene-not-quantity"),
        (
            "limits.stroke=60 parsec",
            "limits.stroke",
            "units-unknown-unit",
        ),
        (
            "limits.stroke=60 kg",
            "limits.stroke",
            "units-wrong-dimension",
        ),
        ("drive.mass=-3 kg", "drive.mass", "scene-not-positive"),
        ("drive.mass=0", "drive.mass", "scene-not-positive"),
        ("gait.model=yung", "gait.model", "scene-unknown-word"),
        ("law.family=splin", "law.family", "scene-unknown-word"),
        ("law.spans=0", "law.spans", "scene-not-spans"),
        ("law.degree=2", "law.degree", "scene-spline-degree"),
        (
            "limits.pressure_angle=95 deg",
            "limits.pressure_angle",
            "scene-not-acute",
        ),
        (
            "cam.follower=roller-translating",
            "cam.roller_radius",
            "scene-needed-by-follower",
        ),
        ("name=../evil", "name", "scene-output-name"),
        ("nonsense", "--set", "scene-no-assignment"),
        ("limits=3", "limits", "scene-not-table"),
        (
            "gait.body_weight=nan N",
            "gait.body_weight",
            "units-no-number",
        ),
    ];
    for (change, place, code) in cases {
        refused(&[change], place, code);
    }
}

#[test]
fn missing_and_broken_files_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_string()
    };
    let refused = |path: &str, words: &[&str]| {
        let output = gaitcam(&["gait", path]);
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{path}: {message}");
        for word in words {
            assert!(
                message.contains(word),
                "{path}: \"{word}\" is missing in: {message}"
            );
        }
    };
    refused("no_such.csv", &["no_such.csv"]);
    refused(&write("empty.csv", ""), &["empty.csv", "empty"]);
    refused(
        &write("columns.csv", "time,hip,knee\n0,1,2\n0.01,1,2\n0.02,1,2\n"),
        &["columns.csv", "hip"],
    );
    let stance = |t: f64| {
        if (0.2..0.8).contains(&(t % 1.1)) {
            700.0
        } else {
            0.0
        }
    };
    let mut back = "time,Fz\n".to_string();
    for i in 0..300 {
        let t = if i == 40 { 0.2 } else { f64::from(i) * 0.01 };
        back += &format!("{t:.3},{:.1}\n", stance(t));
    }
    refused(
        &write("backwards.csv", &back),
        &["backwards.csv line 42", "backwards"],
    );
    refused(&write("one.csv", "time,Fz\n0,700\n"), &["one.csv"]);
    let rows = (0..200).map(|i| format!("{:.2},0\n", f64::from(i) * 0.01));
    let flat = "time,Fz\n".to_string() + &rows.collect::<String>();
    refused(&write("flat.csv", &flat), &["flat.csv"]);
}

#[test]
fn a_key_twice_is_refused_by_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("scene.toml");
    let text = "name = \"x\"\n[gait]\nmodel = \"young\"\nmodel = \"setra\"\n";
    fs::write(&scene, text).unwrap();
    let output = gaitcam(&["synth", scene.to_str().unwrap()]);
    let message = stderr(&output);
    assert!(
        output.status.code() == Some(2) && message.contains("scene.toml line 4"),
        "{message}"
    );
}

#[test]
fn nan_in_a_cycle_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cycle.csv");
    fs::write(
        &path,
        "# cycle\ntime_s,force_n\n0.0,700\n0.1,nan\n0.2,650\n0.3,700\n0.4,710\n",
    )
    .unwrap();
    let scene = folder.path().join("s.toml");
    fs::write(&scene, "[gait]\nfile = \"cycle.csv\"\n").unwrap();
    let output = gaitcam(&[
        "synth",
        scene.to_str().unwrap(),
        "--out",
        folder.path().join("o").to_str().unwrap(),
    ]);
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("cycle.csv"), "{message}");
}

#[test]
fn an_output_folder_that_cannot_be_written_is_found_first() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "kept").unwrap();
    let output = gaitcam(&["synth", "--out", file.join("sub").to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("--out"));
    assert_eq!(fs::read_to_string(&file).unwrap(), "kept");
}

#[test]
fn limits_that_fight_are_named_with_the_smallest_relaxation_that_works() {
    // A jerk limit alone can always be met by standing still; a force floor above M·g cannot.
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let run = |changes: &[&str]| {
        let mut arguments = vec!["synth", "--json", "--out", out];
        for change in changes {
            arguments.extend(["--set", change]);
        }
        let output = gaitcam(&arguments);
        let summary: serde_json::Value = object(&output);
        (output.status.code().unwrap(), summary)
    };
    // The mean is 700 N, so a floor of 700 N (a constant force) is the most that any cam can give; within
    // 0.5 % of the force it is the force's own lowest value, or a little more.
    for (accuracy, most) in [("50 %", 700.0), ("0.5 %", 514.5)] {
        let accuracy = format!("accuracy.rms={accuracy}");
        let (code, summary) = run(&["limits.force_min=750 N", &accuracy]);
        assert_eq!(code, 3);
        assert_eq!(summary["outcome"], "infeasible");
        let relaxation = &summary["infeasible"]["relaxations"][0];
        assert_eq!(relaxation["limit"], "force_min");
        let to = relaxation["to"].as_f64().unwrap();
        assert!((to / most - 1.0).abs() < 1e-3, "{relaxation}");
        let (code, _) = run(&[&format!("limits.force_min={to} N"), &accuracy]);
        assert_eq!(code, 0, "the relaxation must work");
    }
    assert!(
        fs::read_to_string(folder.path().join("summary.json"))
            .unwrap()
            .contains("built")
    );
}

#[test]
fn a_bore_too_wide_for_the_prime_radius_is_named_with_what_would_do() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let run = |bore: &str, limit: &str| {
        let (bore, limit) = (
            format!("cam.bore={bore}"),
            format!("limits.prime_radius={limit}"),
        );
        let changes = ["--set", &bore, "--set", &limit];
        let output = gaitcam(&[&["synth", "--json", "--out", out], &changes[..]].concat());
        let summary: serde_json::Value = object(&output);
        (output.status.code().unwrap(), summary)
    };
    let (code, summary) = run("300 mm", "120 mm");
    assert_eq!((code, &summary["outcome"]), (3, &"infeasible".into()));
    let infeasible = &summary["infeasible"];
    assert_eq!(
        infeasible["conflict"],
        serde_json::json!(["bore", "prime_radius"])
    );
    // A millimetre of wall stands around the bore: 2·(120 − 1) mm, or 150 + 1 mm.
    let relaxations = infeasible["relaxations"].as_array().unwrap();
    for (key, right) in [("cam.bore", 0.238), ("limits.prime_radius", 0.151)] {
        let one = relaxations.iter().find(|r| r["key"] == key).unwrap();
        let to = one["to"].as_f64().unwrap();
        assert!((to - right).abs() < 1e-12, "{to}");
    }
    assert_eq!(run("238 mm", "120 mm").0, 0);
    // Inside the limit there is no room for the wall of a hub, which is a wish.
    assert_eq!(run("300 mm", "151 mm").0, 0);
}

#[test]
fn an_accuracy_that_the_limits_forbid_is_no_such_cam() {
    let folder = tempfile::tempdir().unwrap();
    let output = gaitcam(&[
        "synth",
        "--json",
        "--set",
        "limits.stroke=20 mm",
        "--out",
        folder.path().to_str().unwrap(),
    ]);
    assert_eq!(output.status.code(), Some(3));
    let summary: serde_json::Value = object(&output);
    let failed: Vec<&str> = summary["checks"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|c| c["pass"] == false)
        .map(|c| c["name"].as_str().unwrap())
        .collect();
    assert_eq!(failed, ["rms_error"]);
    assert!(
        summary["binding"]
            .as_array()
            .unwrap()
            .iter()
            .any(|b| b["limit"] == "stroke")
    );
}

#[test]
fn a_roller_larger_than_the_pitch_curve_allows_is_an_undercut() {
    let folder = tempfile::tempdir().unwrap();
    let output = gaitcam(&[
        "synth",
        "scenes/heel_tester.toml",
        "--json",
        "--set",
        "cam.roller_radius=2.5 in",
        "--out",
        folder.path().to_str().unwrap(),
    ]);
    assert_eq!(output.status.code(), Some(3));
    let summary: serde_json::Value = object(&output);
    assert_eq!(summary["verdict"], "unacceptable");
    // 2.3024 in is the smallest convex pitch radius (theory §2): undercut by 0.1976 in.
    let rho = summary["cam"]["rho_min_m"].as_f64().unwrap() / 0.0254;
    assert!((rho + 0.1976).abs() < 1e-4, "{rho}");
}

#[test]
fn bands_weights_and_phases_are_refused() {
    let weight = |to: &str, weight: &str| {
        format!("gait.weight=[{{from=\"0 deg\", to=\"{to}\", weight={weight}}}]")
    };
    refused(&["gait.band=spread"], "gait.band", "synth-no-spread");
    refused(&["gait.band=-5 N"], "gait.band", "scene-not-positive");
    refused(&["gait.phase=sideways"], "gait.phase", "units-no-number");
    refused(
        &[&weight("400 deg", "2.0")],
        "gait.weight.1.to",
        "scene-no-phases",
    );
    refused(
        &[&weight("360 deg", "0.0")],
        "gait.weight",
        "scene-nothing-weighed",
    );
    refused(
        &["law.family=harmonic", "gait.band=20 N"],
        "gait.band",
        "scene-only-splines",
    );
    let peak = [
        "law.family=double-harmonic",
        "law.minimise=peak-force-error",
    ];
    refused(&peak, "law.minimise", "scene-only-splines");
    refused(
        &["limits.prime_radius=-3 mm"],
        "limits.prime_radius",
        "scene-not-positive",
    );
}

#[test]
fn values_are_read_as_people_type_them_in_every_place() {
    let json = |arguments: &[&str]| object(&gaitcam(arguments));
    let speed = |typed: &str| {
        let set = format!("drive.speed={typed}");
        let design = json(&["synth", "thesis_iteration_4", "--set", &set, "--json"]);
        design["drive"]["speed_rad_per_s"].as_f64().unwrap()
    };
    assert!((speed("7,5 rad/s") - 7.5).abs() < 1e-12);
    assert!((speed("100 r/min") - speed("100 RPM")).abs() < 1e-12);
    let roller = |typed: &str| {
        let set = format!("cam.roller_radius={typed}");
        json(&["synth", "camdas_01_roller", "--set", &set, "--json"])["cam"]["prime_radius_m"]
            .as_f64()
            .unwrap()
    };
    for typed in ["3/8 in", "3/8\"", "9,525 mm", "0.375 inch"] {
        assert!((roller(typed) - 0.059_525).abs() < 1e-12, "{typed}");
    }
}

#[test]
fn a_negative_number_after_a_flag_is_its_value() {
    for (arguments, words) in [
        (
            &["synth", "--tool", "-3mm"][..],
            "--tool: -3mm is not positive",
        ),
        (
            &["synth", "--wire", "-.5mm"],
            "--wire: -.5mm is not positive",
        ),
        (
            &["synth", "--tool", "3mm", "--pass", "-1mm"],
            "--pass: -1mm is not positive",
        ),
        (
            &["synth", "--time-limit", "-1"],
            "--time-limit: invalid value \"-1\"",
        ),
        (&["synth", "--points", "-3"], "--points: invalid value -3"),
        (
            &["synth", "--set", "-3"],
            "--set: \"-3\" does not have the form KEY=VALUE",
        ),
        (
            &["sweep", "footbridge", "--jobs", "-1"],
            "--jobs: invalid value -1",
        ),
        (
            &["simulate", "footbridge", "--friction", "-0.1"],
            "--friction: -0.1 is negative",
        ),
        (&["studio", "--port", "-1"], "--port: invalid value -1"),
        // A flag after a flag is none.
        (
            &["simulate", "footbridge", "--friction", "--json"],
            "--friction",
        ),
    ] {
        let output = gaitcam(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let message = stderr(&output);
        assert!(message.contains(words), "{arguments:?}: {message}");
    }
    assert!(stderr(&gaitcam(&["synth", "-5"])).contains("-5: unknown option"));
}

#[test]
fn a_message_gives_an_example_that_is_accepted() {
    let (code, message) = with(&["limits.pressure_angle=0 deg"]);
    assert_eq!(code, 2);
    let example = message.split('"').nth(1).unwrap();
    let (code, message) = with(&[&format!("limits.pressure_angle={example}")]);
    assert_ne!(code, 2, "{example}: {message}");
}

#[test]
fn what_is_no_recording_and_no_law_is_told_so() {
    let message = stderr(&gaitcam(&["gait", "scenes/heel_tester.toml"]));
    assert!(message.contains("is a scene, not a recording") && message.contains("gaitcam synth"));
    let message = stderr(&gaitcam(&[
        "--lang",
        "es",
        "gait",
        "scenes/heel_tester.toml",
    ]));
    assert!(
        message.contains("es una escena, no un registro"),
        "{message}"
    );
    let message = stderr(&gaitcam(&["gait", "/etc/passwd"]));
    assert!(message.contains("a recording is a table"), "{message}");
    assert_eq!(message.trim().lines().count(), 1, "{message}");
    let message = stderr(&gaitcam(&["laws", "cycloydal"]));
    assert!(message.contains("unknown motion") && message.contains("cycloidal"));
    let one = stdout(&gaitcam(&["laws", "cycloidal"]));
    assert_eq!(
        one.lines()
            .filter(|l| l.trim_start().starts_with("cycloidal"))
            .count(),
        1
    );
    assert_eq!(one.lines().count(), 3, "{one}");
    let all = stdout(&gaitcam(&["laws"]));
    let ends = |l: &str| l.split_whitespace().next().map_or(0, |n| n.chars().count());
    let lines = || all.lines().skip(2).map(str::trim_start);
    let numbers = lines().map(|l| &l[ends(l)..]);
    let columns: std::collections::BTreeSet<usize> = lines()
        .zip(numbers)
        .map(|(l, rest)| {
            l.len()
                - rest
                    .trim_start()
                    .trim_start_matches(|c: char| c != ' ')
                    .len()
        })
        .collect();
    assert_eq!(columns.len(), 1, "Cv stands in one column: {all}");
}

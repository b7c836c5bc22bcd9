//! Verdicts that were wrong before: verdict, exit code and printed text.

use std::path::Path;

use serde_json::Value;

use crate::support::{changed, gaitcam, object, stderr, stdout};

/// Exit code and summary of a design.
fn summary(scene: &str, changes: &[&str]) -> (i32, Value) {
    let output = gaitcam(&changed(&["synth", scene, "--json"], changes));
    let fault = stderr(&output);
    let json = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{fault}"));
    (output.status.code().unwrap(), json)
}

fn code(json: &Value, k: usize) -> &str {
    json["reasons"][k]["code"].as_str().unwrap_or("")
}

/// Writes a scene of a parabolic rise, a dwell and a parabolic return with a roller follower.
fn parabolic(folder: &Path) -> String {
    let text = "name = \"parabolic\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"60 rpm\"\n[law]\nfamily = \"program\"\n\
        [[law.segment]]\nmotion = \"parabolic\"\nlift = \"20 mm\"\nangle = \"120 deg\"\n\
        [[law.segment]]\nmotion = \"dwell\"\nangle = \"60 deg\"\n\
        [[law.segment]]\nmotion = \"parabolic\"\nlift = \"-20 mm\"\nangle = \"180 deg\"\n\
        [cam]\nfollower = \"roller-translating\"\nbase_radius = \"50 mm\"\nroller_radius = \"10 mm\"\n";
    let path = folder.join("parabolic.toml");
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

#[test]
fn an_infinite_jerk_is_no_jerk_of_nought() {
    let folder = tempfile::tempdir().unwrap();
    let scene = parabolic(folder.path());
    let (exit, json) = summary(&scene, &["limits.jerk=1 m/s^3"]);
    assert_eq!((exit, &json["law"]["j_max_m_per_rad3"]), (3, &"inf".into()));
    let (exit, json) = summary(&scene, &[]);
    assert_eq!((exit, code(&json, 0)), (0, "reason-acceleration-jumps"));
    let table = folder.path().join("t.csv");
    let file = table.to_str().unwrap();
    let swept = gaitcam(&[
        "sweep",
        &scene,
        "--vary",
        "law.segment.1.motion=parabolic,3-4-5,cycloidal",
        "--vary",
        "law.segment.3.motion=parabolic,3-4-5,cycloidal",
        "--out",
        file,
    ]);
    assert_eq!(swept.status.code(), Some(0));
    let mut reader = csv::Reader::from_path(&table).unwrap();
    let names = reader.headers().unwrap().clone();
    let column = |name: &str| names.iter().position(|n| n == name).unwrap();
    let (jerk, verdict) = (column("jerk_max_m_per_s3"), column("verdict"));
    for record in reader.records() {
        let record = record.unwrap();
        let jumps = record.iter().any(|cell| cell == "parabolic");
        assert_eq!(&record[jerk] == "inf", jumps, "{record:?}");
        assert_eq!(&record[verdict] == "not-for-high-speed", jumps);
    }
    // Even where low speed will do, infinite is not the least.
    let out = folder.path().join("front");
    let front = gaitcam(&[
        "front",
        file,
        "--minimise",
        "jerk,acceleration",
        "--low-speed",
        "--json",
        "--out",
        out.to_str().unwrap(),
    ]);
    let json: Value = object(&front);
    let points = json["front"].as_array().unwrap();
    assert!(!points.is_empty());
    assert!(
        points
            .iter()
            .all(|p| p["jerk_max_m_per_s3"].as_f64().unwrap() > 1.0)
    );
}

#[test]
fn a_mean_force_that_is_not_the_weight_comes_first_on_the_console() {
    for mass in ["drive.mass=1 kg", "drive.mass=80 kg"] {
        let (exit, json) = summary("footbridge", &[mass]);
        assert_eq!((exit, code(&json, 0)), (3, "reason-mean-force"), "{mass}");
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().to_str().unwrap();
        let output = gaitcam(&changed(&["synth", "footbridge", "--out", out], &[mass]));
        let text = stdout(&output);
        assert!(text.lines().count() <= 25, "{text}");
        let second = text.lines().nth(1).unwrap();
        assert!(
            second.contains("drive.mass") && second.contains("gait.scale"),
            "{second}"
        );
    }
}

#[test]
fn a_recording_whose_force_is_missed_is_no_acceptable_cam() {
    let walk = "gait.file=data/recordings/made_walk.csv";
    let scene = "scenes/measured_walk.toml";
    let (exit, json) = summary(scene, &[walk, "drive.mass=1 kg"]);
    assert_eq!((exit, code(&json, 0)), (3, "reason-mean-force"));
    assert!(json["force"]["rms_error_percent_of_mean"].as_f64().unwrap() > 90.0);
    let (exit, json) = summary(scene, &[walk]);
    assert_eq!((exit, json["verdict"].as_str()), (0, Some("acceptable")));
}

#[test]
fn a_force_that_pulls_is_unacceptable_in_the_design_and_in_its_run() {
    let weak = [
        "drive.mass=0.5 kg",
        "drive.spring_rate=0.2 N/mm",
        "drive.preload=2 N",
    ];
    let (exit, json) = summary("scenes/mushroom.toml", &weak);
    assert_eq!((exit, code(&json, 0)), (3, "reason-contact-lost"));
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let run = gaitcam(&changed(
        &["simulate", "scenes/mushroom.toml", "--json", "--out", out],
        &weak,
    ));
    assert_eq!(run.status.code(), Some(3));
    let page = std::fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert!(page.to_lowercase().contains("unacceptable"));
    let json: Value = object(&run);
    assert_eq!(json["verdict"], "unacceptable");
}

#[test]
fn a_steep_roller_is_unacceptable_unless_it_is_not_judged() {
    let scene = "scenes/camdas_01_roller.toml";
    let (exit, json) = summary(scene, &["cam.base_radius=5 mm"]);
    assert_eq!((exit, code(&json, 0)), (3, "reason-pressure-angle"));
    let off = ["cam.base_radius=5 mm", "limits.pressure_angle=none"];
    assert_eq!(summary(scene, &off).0, 0);
}

#[test]
fn an_offset_is_chosen_only_where_the_scene_says_so_and_then_told() {
    let folder = tempfile::tempdir().unwrap();
    let scene = parabolic(folder.path());
    let sized = ["cam.base_radius=auto", "limits.pressure_angle=30 deg"];
    let (_, json) = summary(&scene, &sized);
    assert_eq!(json["cam"]["offset_m"], 0.0);
    let prime = json["cam"]["prime_radius_m"].as_f64().unwrap();
    let free = [&sized[..], &["cam.offset=auto"]].concat();
    let (_, json) = summary(&scene, &free);
    assert!(json["cam"]["offset_m"].as_f64().unwrap() > 1e-3);
    assert!(json["cam"]["prime_radius_m"].as_f64().unwrap() < 0.9 * prime);
    assert_eq!(json["scene"]["cam"]["offset"], "auto");
    let out = folder.path().join("out");
    let output = gaitcam(&changed(
        &["synth", &scene, "--out", out.to_str().unwrap()],
        &free,
    ));
    let text = stdout(&output);
    assert!(text.contains("offset 3.183 mm"), "{text}");
}

/// Writes a recording of one stance of one foot with two peaks, and rest before and after it.
fn one_stance(folder: &Path) -> String {
    let rows = (0..1300).map(|i| {
        let t = f64::from(i) * 1e-3;
        let u = (t - 0.3) / 0.65;
        let force = if (0.0..1.0).contains(&u) {
            let x = std::f64::consts::PI * u;
            760.0 * (x.sin() + 0.32 * (3.0 * x).sin())
        } else {
            0.0
        };
        format!("{t:.3},{force:.2}\n")
    });
    let text: String = std::iter::once("time_s,force_N\n".to_string())
        .chain(rows)
        .collect();
    let path = folder.join("stance.csv");
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

#[test]
fn a_recording_of_one_foot_says_that_it_is_doubled_and_how() {
    let folder = tempfile::tempdir().unwrap();
    let file = format!("gait.file={}", one_stance(folder.path()));
    let out = folder.path().join("out");
    let arguments = [
        "synth",
        "scenes/measured_walk.toml",
        "--out",
        out.to_str().unwrap(),
    ];
    let both = gaitcam(&changed(&arguments, &[&file]));
    let text = stdout(&both);
    assert!(
        text.contains("half a stride") && text.contains("gait.feet"),
        "{text}"
    );
    let one = gaitcam(&changed(&arguments, &[&file, "gait.feet=one"]));
    let text = stdout(&one);
    assert!(!text.contains("half a stride"), "{text}");
}

#[test]
fn the_fitted_heel_tester_keeps_its_contact_in_every_word() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let run = gaitcam(&[
        "simulate",
        "scenes/heel_tester_fitted.toml",
        "--json",
        "--out",
        out,
    ]);
    let json: Value = object(&run);
    assert_eq!(run.status.code(), Some(0));
    assert_eq!(json["contact_lost"], false);
    assert_eq!(json["liftoff_speed_rad_per_s"], Value::Null);
    let least = json["force"]["min"].as_f64().unwrap();
    let most = json["force"]["max"].as_f64().unwrap();
    assert!(least > -1e-6 * most, "{least}");
}

#[test]
fn a_run_leaves_with_the_design_that_it_was_of_even_where_no_design_was_written() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    assert_eq!(gaitcam(&["simulate", "--out", out]).status.code(), Some(0));
    let ran = folder.path().join("dynamics.csv");
    assert!(ran.exists());
    gaitcam(&["synth", "scenes/heel_tester.toml", "--out", out]);
    assert!(!ran.exists() && !folder.path().join("simulation.json").exists());
}

#[test]
fn messages_name_flags_keys_files_and_rows_as_they_were_typed() {
    let folder = tempfile::tempdir().unwrap();
    let list = folder.path().join("list.csv");
    std::fs::write(&list, "limits.stroke\n40 mm\n41 mm\nabc\n").unwrap();
    let table = folder.path().join("t.csv");
    let out = table.to_str().unwrap();
    let message = |arguments: &[&str]| {
        let output = gaitcam(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        stderr(&output)
    };
    let listed = message(&["sweep", "--list", list.to_str().unwrap(), "--out", out]);
    assert!(
        listed.contains("list.csv line 4") && listed.contains("limits.stroke"),
        "{listed}"
    );
    assert!(!listed.contains("--vary"), "{listed}");
    let friction = message(&["simulate", "scenes/mushroom.toml", "--friction=-0.1"]);
    assert!(friction.contains("--friction"), "{friction}");
    let pressure = "drive.pressure_per_volume=-30 psi/in^3";
    let typed = message(&["synth", "scenes/heel_tester.toml", "--set", pressure]);
    assert!(typed.contains("-30 psi/in^3 is not positive"), "{typed}");
    let unknown = message(&["synth", "--set", "gait.zzz=1"]);
    assert_eq!(unknown.matches("phase").count(), 1, "{unknown}");
    let name = message(&["synth", "--set", "name=-rf"]);
    assert!(name.contains("name:"), "{name}");
    let weight = message(&[
        "synth",
        "--set",
        "gait.weight=[{from=\"30 deg\",to=\"30 deg\",weight=2}]",
    ]);
    assert!(weight.contains("gait.weight.1.from"), "{weight}");
    // What would help is given by the keys that one types.
    let refused = gaitcam(&["synth", "--set", "limits.stroke=30 mm", "--out", out]);
    let text = stdout(&refused);
    assert!(
        text.contains("limits.stroke 48.19") && text.contains("accuracy.rms"),
        "{text}"
    );
}

/// Two written cycles of walkers; an open question in the second one.
fn walkers(folder: &std::path::Path) {
    for (name, open) in [("first", ""), ("second", "# open = mass\n")] {
        let mut text = format!("# cycle\n# period_s = 1.1\n{open}time_s,force_n\n");
        for i in 0..100 {
            let phase = std::f64::consts::TAU * f64::from(i) / 100.0;
            let force = 700.0 * (1.0 + 0.3 * (2.0 * phase).sin());
            text += &format!("{},{force}\n", 0.011 * f64::from(i));
        }
        std::fs::write(folder.join(format!("{name}.csv")), text).unwrap();
    }
}

#[test]
fn a_population_names_open_questions_and_unknown_exclusions() {
    let folder = tempfile::tempdir().unwrap();
    let people = folder.path().join("people");
    std::fs::create_dir(&people).unwrap();
    walkers(&people);
    let file = format!("gait.file={}", people.display());
    let out = folder.path().join("out");
    let run = |more: &[&str]| {
        let mut words = vec!["synth", "footbridge", "--set", &file];
        words.extend(["--set", "accuracy.rms=none", "--out", out.to_str().unwrap()]);
        more.iter()
            .for_each(|change| words.extend(["--set", change]));
        gaitcam(&words)
    };
    let open = run(&[]);
    assert_eq!(open.status.code(), Some(2));
    assert!(stderr(&open).contains("second (mass)"), "{}", stderr(&open));
    let unknown = run(&["gait.leave_out=[\"secnd\"]"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert!(
        stderr(&unknown).contains("did you mean \"second\""),
        "{}",
        stderr(&unknown)
    );
    for sufficient in [
        "gait.accept=mass",
        "gait.leave_out=[\"second\"]",
        "gait.leave_out=[\"second.csv\"]",
    ] {
        let designed = run(&[sufficient]);
        assert_eq!(
            designed.status.code(),
            Some(0),
            "{sufficient}: {}",
            stderr(&designed)
        );
    }
}

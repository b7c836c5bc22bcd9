//! `gaitcam front`, `gaitcam synth --front` and `gaitcam compare`: qualified designs, units, exit codes.

use std::path::Path;

use serde_json::Value;

use crate::support::{gaitcam, object, stderr, stdout};

const MACHINE: [&str; 6] = [
    "torque_max_n_m",
    "torque_rms_n_m",
    "power_max_w",
    "power_mean_w",
    "liftoff_speed_rad_per_s",
    "hertz_pressure_max_pa",
];

/// Rows of a table, by the names of its columns.
fn rows(table: &Path) -> Vec<std::collections::HashMap<String, String>> {
    let mut reader = csv::Reader::from_path(table).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

#[test]
fn a_sweep_says_of_the_machine_what_the_single_design_says() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("t.csv");
    let out = table.to_str().unwrap();
    let swept = gaitcam(&[
        "sweep",
        "--vary",
        "law.family=spline,harmonic",
        "--vary",
        "gait.step_frequency=1.7 Hz:2.1 Hz:3",
        "--out",
        out,
    ]);
    assert_eq!(swept.status.code(), Some(0));
    let rows = rows(&table);
    assert!(rows.iter().any(|row| row["tier"] == "spectral"));
    for row in &rows {
        let frequency = format!("gait.step_frequency={} Hz", row["gait.step_frequency_hz"]);
        let family = format!("law.family={}", row["law.family"]);
        let alone = gaitcam(&["synth", "--json", "--set", &frequency, "--set", &family]);
        let json: Value = object(&alone);
        for name in MACHINE {
            let (a, b): (f64, f64) = (
                row[name].parse().unwrap(),
                json["machine"][name].as_f64().unwrap(),
            );
            assert!((a - b).abs() <= 1e-9 * b.abs(), "{name}: {a} {b}");
        }
    }
    // Each of them is an objective, and the lift-off speed the larger the better.
    let front = folder.path().join("front");
    for name in &MACHINE[..3] {
        let run = gaitcam(&[
            "front",
            out,
            "--minimise",
            name,
            "--maximise",
            "liftoff_speed",
            "--json",
            "--out",
            front.to_str().unwrap(),
        ]);
        let json: Value = object(&run);
        let best = json["best"]["row"].as_u64().unwrap() as usize;
        let number = |row: usize, name: &str| rows[row][name].parse::<f64>().unwrap();
        let beaten = (0..rows.len()).any(|k| {
            rows[k]["verdict"] == "acceptable"
                && number(k, name) < number(best, name) * (1.0 - 1e-9)
                && number(k, "liftoff_speed_rad_per_s") > number(best, "liftoff_speed_rad_per_s")
        });
        assert!(!beaten, "{name}");
        assert_eq!(json["maximise"][0], "liftoff_speed_rad_per_s");
    }
}

/// Scene with a parabolic rise, which is for low speed only.
const PARABOLA: &str = "name = \"x\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"1 rad/s\"\n[law]\nfamily = \"program\"\n\
    [[law.segment]]\nmotion = \"parabolic\"\nlift = \"20 mm\"\nangle = \"120 deg\"\n\
    [[law.segment]]\nmotion = \"dwell\"\nangle = \"60 deg\"\n\
    [[law.segment]]\nmotion = \"3-4-5\"\nlift = \"-20 mm\"\nangle = \"180 deg\"\n\
    [cam]\nfollower = \"flat-translating\"\nbase_radius = \"80 mm\"\n";

#[test]
fn a_front_admits_acceptable_designs_and_says_how_many_are_for_low_speed() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("t.csv");
    let out = table.to_str().unwrap();
    let scene = folder.path().join("x.toml");
    std::fs::write(&scene, PARABOLA).unwrap();
    // The parabola is for low speed, and its stroke may be 19 mm to none of them.
    let swept = gaitcam(&[
        "sweep",
        scene.to_str().unwrap(),
        "--vary",
        "law.segment.1.motion=parabolic,3-4-5,cycloidal",
        "--vary",
        "limits.stroke=19 mm,21 mm",
        "--out",
        out,
    ]);
    let message = stderr(&swept);
    assert_eq!(swept.status.code(), Some(0), "{message}");
    let rows = rows(&table);
    let count = |verdict: &str| rows.iter().filter(|r| r["verdict"] == verdict).count() as u64;
    let (good, slow) = (count("acceptable"), count("not-for-high-speed"));
    assert!(
        good > 0 && slow > 0 && count("unacceptable") > 0,
        "{good} {slow}"
    );
    let front = folder.path().join("front");
    let run = |more: &[&str]| {
        let start = [
            "front",
            out,
            "--minimise",
            "prime_radius,acceleration",
            "--json",
            "--out",
            front.to_str().unwrap(),
        ];
        let run = gaitcam(&[&start[..], more].concat());
        assert_eq!(run.status.code(), Some(0));
        serde_json::from_slice::<Value>(&run.stdout).unwrap()
    };
    let usual = run(&[]);
    assert_eq!(usual["candidates"], good);
    assert_eq!(usual["not_for_high_speed_left_out"], slow);
    assert_eq!(run(&["--low-speed"])["candidates"], good + slow);
    assert_eq!(run(&["--all"])["candidates"], rows.len() as u64);
    let objectives = ["--minimise", "prime_radius,acceleration"];
    let to = ["--out", front.to_str().unwrap()];
    let told = gaitcam(&[&["front", out], &objectives[..], &to].concat());
    assert!(stderr(&told).contains("--low-speed"));
    // Lengths are read in millimetres, and named so.
    assert!(
        stdout(&told).contains("prime radius, mm"),
        "{}",
        stdout(&told)
    );
}

#[test]
fn a_sweep_of_unacceptable_cams_is_no_success() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("t.csv");
    let run = gaitcam(&[
        "sweep",
        "--vary",
        "limits.stroke=20 mm:30 mm:3",
        "--out",
        table.to_str().unwrap(),
    ]);
    assert_eq!(run.status.code(), Some(3));
    assert_eq!(rows(&table).len(), 3);
}

#[test]
fn the_force_error_is_traded_against_what_the_machine_is_asked() {
    for (against, column, rises) in [
        ("torque", "torque_max_n_m", false),
        ("power_max", "power_max_w", false),
        ("liftoff_speed", "liftoff_speed_rad_per_s", true),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().to_str().unwrap();
        let pair = format!("force_error:{against}");
        let run = gaitcam(&["synth", "--front", &pair, "--points", "4", "--out", out]);
        assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
        let rows = rows(&folder.path().join("front.csv"));
        assert_eq!(rows.len(), 4);
        let number = |k: usize, name: &str| rows[k][name].parse::<f64>().unwrap();
        for k in 1..4 {
            // Less is asked of the force as more is given by the machine.
            assert!(number(k, "rms_error_n") < number(k - 1, "rms_error_n"));
            assert_eq!(
                number(k, column) < number(k - 1, column),
                rises,
                "{against}"
            );
        }
        for k in 0..4 {
            let held = number(k, &format!("allowed_{column}"));
            let slack = 1e-6 * held;
            let value = number(k, column);
            assert!(if rises {
                value >= held - slack
            } else {
                value <= held + slack
            });
        }
    }
    let fixed = gaitcam(&[
        "synth",
        "scenes/heel_tester_fitted.toml",
        "--front",
        "force_error:liftoff_speed",
    ]);
    assert_eq!(fixed.status.code(), Some(2));
}

#[test]
fn compared_designs_are_told_in_their_units_and_a_bad_one_is_told_by_the_exit_code() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let built = |name: &str, scene: &str, changes: &[&str]| {
        let out = place(name);
        let mut arguments = vec!["synth", scene, "--no-png", "--out", &out];
        arguments.extend(changes.iter().flat_map(|change| ["--set", change]));
        gaitcam(&arguments).status.code().unwrap()
    };
    let small: &[&str] = &["cam.base_radius=5 mm"];
    for (name, scene, changes, code) in [
        (
            "arm",
            "scenes/camdas_02_oscillating_roller.toml",
            &[][..],
            0,
        ),
        ("slide", "scenes/translating_cam.toml", &[], 0),
        ("walk", "footbridge", &[], 0),
        ("steep", "scenes/camdas_01_roller.toml", small, 3),
    ] {
        assert_eq!(built(name, scene, changes), code, "{name}");
    }
    let compare = |names: &[&str]| {
        let out = place("compare");
        let folders: Vec<String> = names.iter().map(|name| place(name)).collect();
        let mut arguments = vec!["compare", "--out", &out];
        arguments.extend(folders.iter().map(String::as_str));
        gaitcam(&arguments)
    };
    let good = compare(&["arm", "slide", "walk"]);
    assert_eq!(good.status.code(), Some(0));
    let table = stdout(&good);
    let line = |heading: &str| {
        let mut lines = table.lines();
        let found = lines.find(|l| l.trim_start().starts_with(heading));
        found.unwrap_or_else(|| panic!("{heading}: {table}"))
    };
    assert!(line("stroke").contains("10°") && line("stroke").contains("20 mm"));
    assert!(line("speed").contains("m/s"));
    let peak = line("maximum acceleration");
    assert!(peak.contains("rad/s²") && peak.contains("m/s²"));
    assert!(line("RMS force error ").contains('—'));
    assert!(line("maximum torque").contains("N·m"));
    // The target stands beside the forces.
    let picture = std::fs::read_to_string(Path::new(&place("compare")).join("compare_force.svg"));
    assert!(picture.unwrap().contains("target of footbridge"));
    assert_eq!(compare(&["arm", "steep"]).status.code(), Some(3));
    // A result without a cam stands in the table too.
    let refused = [
        "law.spans=4",
        "limits.force_min=1200 N",
        "limits.force_max=1100 N",
    ];
    let exit = built("refused", "footbridge", &refused);
    if exit == 3 {
        let both = compare(&["walk", "refused"]);
        assert_eq!(both.status.code(), Some(3));
        assert!(stdout(&both).contains("infeasible"), "{}", stdout(&both));
    }
}

#[test]
fn the_largest_jerk_counts_by_its_magnitude() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("x.toml");
    // A rise over 240° and a return over 120°: the jerk of the return is eight times that of the rise, and negative.
    std::fs::write(
        &scene,
        "name = \"x\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"2 rad/s\"\n[law]\nfamily = \"program\"\n\
         [[law.segment]]\nmotion = \"cycloidal\"\nlift = \"10 mm\"\nangle = \"240 deg\"\n\
         [[law.segment]]\nmotion = \"4-5-6-7\"\nlift = \"-10 mm\"\nangle = \"120 deg\"\n\
         [cam]\nfollower = \"flat-translating\"\nbase_radius = \"80 mm\"\n",
    )
    .unwrap();
    let (a, b, out) = (
        folder.path().join("a"),
        folder.path().join("b"),
        folder.path().join("c"),
    );
    for place in [&a, &b] {
        let run = gaitcam(&[
            "synth",
            scene.to_str().unwrap(),
            "--no-png",
            "--out",
            place.to_str().unwrap(),
        ]);
        assert_eq!(run.status.code(), Some(0));
    }
    let run = gaitcam(&[
        "compare",
        a.to_str().unwrap(),
        b.to_str().unwrap(),
        "--json",
        "--out",
        out.to_str().unwrap(),
    ]);
    let json: Value = object(&run);
    let law = &json[0]["summary"]["law"];
    let number = |key: &str| law[key].as_f64().unwrap();
    let (low, high) = (number("j_min_m_per_rad3"), number("j_max_m_per_rad3"));
    // In time, at 2 rad/s.
    let largest = 8.0 * high.max(-low);
    assert!(-low > 1.2 * high || high > 1.2 * -low, "{low} {high}");
    let shown = gaitcam(&[
        "compare",
        a.to_str().unwrap(),
        b.to_str().unwrap(),
        "--out",
        out.to_str().unwrap(),
    ]);
    assert!(
        stdout(&shown).contains(&format!("{largest:.4} m/s³")),
        "{}",
        stdout(&shown)
    );
}

#[test]
fn a_front_of_a_folder_without_blocks_says_what_it_expects() {
    let folder = tempfile::tempdir().unwrap();
    let name = folder.path().to_str().unwrap();
    for (language, words) in [
        ("en", "no blocks of a sweep"),
        ("es", "no contiene bloques"),
    ] {
        let refused = gaitcam(&["front", name, "--lang", language]);
        assert_eq!(refused.status.code(), Some(2));
        assert!(stderr(&refused).contains(words), "{}", stderr(&refused));
    }
}

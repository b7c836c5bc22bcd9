//! Every quantity is shown in the unit of its follower, and all given values are reported.

use std::fs;

use crate::support::{changed, gaitcam, stderr, stdout};

struct Shown {
    code: i32,
    out: String,
    err: String,
    folder: tempfile::TempDir,
}

impl Shown {
    fn file(&self, name: &str) -> String {
        fs::read_to_string(self.folder.path().join(name)).unwrap()
    }

    fn summary(&self) -> serde_json::Value {
        serde_json::from_str(&self.file("summary.json")).unwrap()
    }
}

fn run(command: &str, scene: &str, set: &[&str]) -> Shown {
    run_with(command, scene, set, &[])
}

fn run_with(command: &str, scene: &str, set: &[&str], options: &[&str]) -> Shown {
    let folder = tempfile::tempdir().unwrap();
    let scene = format!("scenes/{scene}.toml");
    let to = folder.path().to_str().unwrap();
    let words = [&[command, scene.as_str(), "--out", to], options].concat();
    let output = gaitcam(&changed(&words, set));
    Shown {
        code: output.status.code().unwrap(),
        out: stdout(&output),
        err: stderr(&output),
        folder,
    }
}

/// The text of a page or picture without its tags.
fn text(page: &str) -> String {
    let mut out = String::new();
    for part in page.split('<').skip(1) {
        if let Some((_, words)) = part.split_once('>') {
            out.push_str(words);
            out.push('\n');
        }
    }
    out
}

const ARM: &str = "camdas_02_oscillating_roller";

#[test]
fn limits_of_an_arm_are_told_in_angles_and_moments() {
    let set = [
        "limits.stroke=8 deg",
        "limits.acceleration=3 rad/s^2",
        "limits.jerk=9 rad/s^3",
        "limits.force_min=5 N m",
        "drive.preload=3 Nm",
        "drive.spring_rate=50 N m/rad",
        "drive.inertia=0.02 kg m^2",
    ];
    let shown = run("synth", ARM, &set);
    assert_eq!(shown.code, 3, "{}", shown.err);
    // The verdict, the console's list and the page say the same.
    let reason = shown.summary()["reason"].as_str().unwrap().to_string();
    let page = text(&shown.file("report.html"));
    for words in [&reason, &shown.out, &page] {
        assert!(words.contains("10°"), "{words}");
        for alien in ["m/s²", "m/s³", " N/mm", "force at rest", "kg,"] {
            let at = words
                .find(alien)
                .map(|i| &words[i.saturating_sub(60)..i + 8]);
            // rad/s² has no m before its /.
            assert!(at.is_none(), "{alien} in {at:?}");
        }
    }
    assert!(reason.contains("10°") && !reason.contains("mm"), "{reason}");
    assert!(shown.out.contains("(limit 3 rad/s²)"), "{}", shown.out);
    assert!(shown.out.contains("(limit 5 N·m)"));
    assert!(shown.out.contains("moment of inertia 0.02 kg·m²"));
    assert!(
        page.contains("50 N·m/rad") && page.contains("3 N·m"),
        "{page}"
    );
    let force = text(&shown.file("force.svg"));
    assert!(force.contains("moment, N·m") && !force.contains("force, N"));
}

#[test]
fn a_sliding_cam_is_told_in_millimetres_of_travel() {
    let shown = run("synth", "translating_cam", &[]);
    assert_eq!(shown.code, 0, "{}", shown.err);
    let page = text(&shown.file("report.html"));
    for words in [&shown.out, &page, &text(&shown.file("svaj.svg"))] {
        for alien in ["rpm", "rad/s", "/rad", "one turn", "cam angle"] {
            assert!(!words.contains(alien), "{alien} in {words}");
        }
    }
    assert!(shown.out.contains("speed 0.5 m/s"), "{}", shown.out);
    assert!(
        page.contains("one pass\n0.32 s") || page.contains("one pass\n\n0.32 s"),
        "{page}"
    );
    let axis = text(&shown.file("svaj.svg"));
    assert!(
        axis.contains("travel, mm") && axis.contains("160"),
        "{axis}"
    );
    let load = ["drive.mass=1 kg", "drive.preload=20 N"];
    let ran = run("simulate", "translating_cam", &load);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(
        !ran.out.contains("rad/s") && ran.out.contains("m/s"),
        "{}",
        ran.out
    );
}

#[test]
fn a_programme_without_load_shows_inertia_and_speaks_of_no_percents() {
    let shown = run("synth", "camdas_01_roller", &[]);
    let picture = text(&shown.file("force.svg"));
    assert!(picture.contains("force of a 1 kg follower"), "{picture}");
    let ran = run("simulate", "camdas_01_roller", &[]);
    assert!(
        !ran.out.contains("NaN") && ran.out.contains("no force presses the follower"),
        "{}",
        ran.out
    );
}

#[test]
fn a_lift_of_nought_is_no_pull() {
    // The dwell of the emitted profile lies on the base circle to rounding.
    let ran = run("simulate", "heel_tester", &[]);
    let json: serde_json::Value = serde_json::from_str(&ran.file("simulation.json")).unwrap();
    assert_eq!(json["contact_lost"], false);
    assert!(json["liftoff_speed_rad_per_s"].is_null(), "{}", ran.out);
}

#[test]
fn a_profile_that_no_flat_face_can_touch_is_no_cam_to_run() {
    let ran = run("simulate", "camdas_03_flat", &["cam.base_radius=20 mm"]);
    assert_eq!(ran.code, 3, "{}", ran.err);
    assert!(ran.err.contains("undercut"), "{}", ran.err);
}

#[test]
fn the_steepest_pressure_angle_of_a_barrel_is_one_number() {
    let summary = run("synth", "thesis_barrel", &[]).summary();
    let worst = summary["checks"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|c| c["name"].as_str().unwrap().starts_with("pressure_angle"))
        .map(|c| c["worst"].as_f64().unwrap())
        .fold(0.0, f64::max);
    let told = summary["cam"]["pressure_angle_max_rad"].as_f64().unwrap();
    assert!((told - worst).abs() < 1e-12);
    // Bautista Morelos (2018) prints 28.745° (theory §4).
    assert!((told.to_degrees() - 28.745).abs() < 5e-4, "{told}");
}

#[test]
fn both_tables_stand_on_one_side_of_every_jump() {
    // ρ = Rb + s + a under a flat face; constant breadth makes the acceleration jump at half a turn.
    let shown = run("synth", "camdas_06_constant_breadth", &[]);
    let base = shown.summary()["cam"]["base_radius_m"].as_f64().unwrap();
    let rows = |name: &str| -> Vec<Vec<f64>> {
        let text = shown.file(name);
        let cell = |x: &str| x.parse().unwrap_or(f64::NAN);
        let row = |l: &str| l.split(',').map(cell).collect();
        text.lines().skip(1).map(row).collect()
    };
    for (law, profile) in rows("law.csv").iter().zip(rows("profile.csv")) {
        let rho = base + law[1] + law[3];
        assert!(
            (profile[5] - rho).abs() < 1e-9,
            "at {}°",
            law[0].to_degrees()
        );
    }
}

#[test]
fn what_changes_nothing_is_said() {
    let remarks =
        |scene: &str, set: &[&str]| run("synth", scene, set).summary()["remarks"].to_string();
    let set = [
        "law.family=spline",
        "law.harmonics=3",
        "cam.offset=9 mm",
        "law.segment=[{motion = \"cycloidal\", lift = \"1 mm\", angle = \"90 deg\"}]",
    ];
    let said = remarks("footbridge", &set);
    for key in ["law.harmonics", "cam.offset", "law.segment"] {
        assert!(said.contains(key), "{key} in {said}");
    }
    let said = remarks("footbridge", &["law.family=harmonic", "law.spans=8"]);
    assert!(said.contains("law.spans"), "{said}");
    let both = run(
        "synth",
        "footbridge",
        &["cam.base_radius=30 mm", "cam.prime_radius=55 mm"],
    );
    assert_eq!(both.code, 2);
    assert!(both.err.contains("cam.prime_radius"), "{}", both.err);
}

/// Scenes whose follower has no mass: every drive, with slides and arms.
const WEIGHTLESS: [(&str, &[&str]); 6] = [
    ("heel_tester", &[]),
    ("heel_tester_fitted", &["law.spans=16"]),
    ("camdas_01_roller", &[]),
    ("camdas_03_flat", &[]),
    ("camdas_02_oscillating_roller", &[]),
    (
        "camdas_04_oscillating_flat",
        &[
            "drive.kind=hydraulic",
            "drive.pressure_per_volume=30 psi/in^3",
            "drive.piston_radius=0.75 in",
        ],
    ),
];

#[test]
fn what_is_advised_for_a_natural_frequency_without_a_mass_can_be_followed() {
    let mut followed = 0;
    for (scene, changes) in WEIGHTLESS {
        let folder = tempfile::tempdir().unwrap();
        let run = |more: &[&str], flags: &[&str]| {
            let mut arguments = vec!["simulate", scene, "--out", folder.path().to_str().unwrap()];
            arguments.extend_from_slice(flags);
            for change in changes.iter().chain(more) {
                arguments.extend(["--set", change]);
            }
            gaitcam(&arguments)
        };
        let frequency = ["--natural-frequency", "30 Hz"];
        let refused = run(&[], &frequency);
        let said = stderr(&refused);
        assert_eq!(refused.status.code(), Some(2), "{scene}: {said}");
        let answers = [
            ("drive.mass=2 kg", &frequency[..]),
            ("drive.inertia=0.02 kg m^2", &frequency[..]),
            ("machine.stiffness=200 N/mm", &[]),
            ("machine.stiffness=2000 N m/rad", &[]),
        ];
        let named = answers
            .iter()
            .filter(|a| said.contains(a.0.split('=').next().unwrap()));
        let ran = named.filter(|(key, flags)| run(&[key], flags).status.code() != Some(2));
        let ran = ran.count();
        assert!(ran > 0, "{scene}: {said}");
        followed += ran;
    }
    println!(
        "{followed} answers followed for {} scenes",
        WEIGHTLESS.len()
    );
}

#[test]
fn a_flag_of_the_machine_without_effect_is_named() {
    for (scene, told) in [
        ("camdas_01_roller", true),
        ("mushroom", false),
        ("camdas_03_flat", false),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().to_str().unwrap();
        let run = gaitcam(&["simulate", scene, "--friction", "0.1", "--out", out]);
        let said = stdout(&run);
        assert_eq!(
            said.contains("machine.friction has no effect"),
            told,
            "{said}"
        );
    }
}

#[test]
fn a_share_needs_its_percent_and_zero_needs_nothing() {
    for (change, code) in [
        ("accuracy.rms=0.5", 2),
        ("accuracy.rms=\"50\"", 2),
        ("accuracy.rms=2", 2),
        ("accuracy.rms=0.5 %", 0),
        ("limits.force_min=0", 0),
        ("limits.force_min=0.0", 0),
    ] {
        let shown = run("synth", "footbridge", &[change]);
        assert_eq!(shown.code, code, "{change}: {}", shown.err);
        if code == 2 {
            assert!(
                shown.err.contains("accuracy.rms") && shown.err.contains('%'),
                "{}",
                shown.err
            );
        }
    }
}

#[test]
fn with_inches_no_report_picture_or_message_has_millimetres() {
    for scene in [
        "footbridge",
        "mushroom",
        "translating_cam",
        "thesis_barrel",
        "camdas_05_constant_diameter",
    ] {
        let shown = run_with("synth", scene, &[], &["--units", "inch"]);
        let summary = shown.summary();
        let stroke = summary["law"]["stroke_m"].as_f64().unwrap() / 0.0254;
        let written = gaitcam::wording::number(gaitcam::wording::Language::En, stroke);
        assert!(
            shown.out.contains(&format!("stroke {written} in")),
            "{scene}: {}",
            shown.out
        );
        let mut shown_texts = vec![("summary".to_string(), shown.out.clone())];
        for name in ["report.html", "svaj.svg", "cam.svg", "force.svg"] {
            shown_texts.push((name.to_string(), text(&shown.file(name))));
        }
        for (name, text) in shown_texts {
            let metric = text.lines().find(|line| {
                let words = |c: char| !c.is_alphabetic();
                !line.contains('{') && line.split(words).any(|word| word == "mm")
            });
            assert_eq!(metric, None, "{scene}: {name}");
        }
    }
}

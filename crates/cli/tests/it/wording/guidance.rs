//! Guidance for new users: `init`, `doctor`, help and errors of the command line.

use std::fs;

use crate::support::{both, gaitcam, object, run_in, stderr, stdout, walk};

#[test]
fn every_machine_of_init_becomes_an_acceptable_cam() {
    let folder = tempfile::tempdir().unwrap();
    let listed = both(&run_in(folder.path(), &["init"]));
    let machines: Vec<&str> = listed
        .lines()
        .filter_map(|l| l.split_whitespace().next())
        .collect();
    assert!(
        machines.contains(&"shaker") && machines.len() >= 5,
        "{listed}"
    );
    walk(&folder.path().join("walk.csv"));
    for machine in machines {
        let written = run_in(folder.path(), &["init", machine]);
        assert_eq!(written.status.code(), Some(0), "{}", both(&written));
        let scene = format!("{machine}.toml");
        let before = fs::read(folder.path().join(&scene)).unwrap();
        let mut arguments = vec!["synth", &scene, "--no-png"];
        if machine == "walk" {
            arguments.extend(["--set", "gait.file=walk.csv"]);
        }
        let designed = run_in(folder.path(), &arguments);
        assert_eq!(
            designed.status.code(),
            Some(0),
            "{machine}: {}",
            both(&designed)
        );
        // What is there stays.
        let again = run_in(folder.path(), &["init", machine]);
        assert_eq!(again.status.code(), Some(2), "{machine}");
        assert_eq!(fs::read(folder.path().join(&scene)).unwrap(), before);
    }
}

#[test]
fn the_doctor_names_every_fault_at_once_and_the_cure() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "name = \"a\"\n[drive]\nkind = \"fixed-axis\"\nsped = \"60 rpm\"\nspeed = 5\n\
        [law]\nfamily = \"program\"\n[[law.segment]]\nmotion = \"cycloidle\"\nlift = \"10 mm\"\nangle = \"180 deg\"\n\
        [[law.segment]]\nmotion = \"cycloidal\"\nlift = \"-10 mm\"\nangle = \"180 deg\"\n\
        [cam]\nfollower = \"flat-translating\"\n[limits]\nstroke = \"10 kg\"\n";
    fs::write(folder.path().join("a.toml"), scene).unwrap();
    let told = run_in(folder.path(), &["doctor", "a.toml"]);
    let told = (told.status.code(), both(&told));
    assert_eq!(told.0, Some(2), "{}", told.1);
    for word in ["sped", "drive.speed", "cycloidal", "limits.stroke"] {
        assert!(told.1.contains(word), "{word} in {}", told.1);
    }
    assert_eq!(
        told.1.lines().filter(|l| l.starts_with('✗')).count(),
        4,
        "{}",
        told.1
    );

    let none = run_in(folder.path(), &["doctor", "footbridge"]);
    assert_eq!(none.status.code(), Some(0), "{}", both(&none));
    assert!(!both(&none).contains('✗'));

    fs::write(folder.path().join("c.csv"), "time,Fz\n0,1\n0.1,x\n").unwrap();
    for (file, code) in [("c.csv", 2), ("no.toml", 2)] {
        let refused = run_in(folder.path(), &["doctor", file]);
        assert_eq!(
            refused.status.code(),
            Some(code),
            "{file}: {}",
            both(&refused)
        );
    }
    walk(&folder.path().join("walk.csv"));
    let walked = run_in(folder.path(), &["doctor", "walk.csv"]);
    assert_eq!(walked.status.code(), Some(0), "{}", both(&walked));
}

#[test]
fn a_wrong_command_line_is_said_like_every_other_fault_in_both_languages() {
    let folder = tempfile::tempdir().unwrap();
    let faults: [(&[&str], &str, &str); 9] = [
        (
            &["chart", "--quick"],
            "cargo run --release -p gaitcam-lab -- chart",
            "cargo run --release -p gaitcam-lab -- chart",
        ),
        (
            &["reproduce"],
            "cargo run --release -p gaitcam-lab -- reproduce",
            "cargo run --release -p gaitcam-lab -- reproduce",
        ),
        (
            &["synth", "--josn"],
            "did you mean --json?",
            "¿quería decir --json?",
        ),
        (&["snyth"], "did you mean synth?", "¿quería decir synth?"),
        (
            &["synth", "--points", "many"],
            "whole number",
            "número entero",
        ),
        (&["synth", "--points", "1"], "2 … 1000000", "2 … 1000000"),
        (
            &["sweep", "--vary", "a=1"],
            "missing: --out",
            "falta: --out",
        ),
        (
            &["ecam", "out"],
            "missing: --dialect <DIALECT>; write one of: codesys, twincat",
            "falta: --dialect <DIALECT>; escriba uno de: codesys, twincat",
        ),
        (
            &["synth", "a", "b"],
            "one argument too many",
            "sobra un argumento",
        ),
    ];
    for (arguments, english, spanish) in faults {
        for (language, wanted) in [("en", english), ("es", spanish)] {
            let said = run_in(folder.path(), &[&["--lang", language], arguments].concat());
            assert_eq!(said.status.code(), Some(2), "{arguments:?}");
            assert!(both(&said).contains(wanted), "{}", both(&said));
        }
    }
    let json = run_in(folder.path(), &["sweep", "--json"]);
    let error: serde_json::Value = object(&json);
    assert_eq!(error["error"]["code"], "cli-missing-arguments");
}

#[test]
fn a_law_is_found_by_its_name_in_the_language_and_a_mistyped_one_is_suggested() {
    let spanish = gaitcam(&["laws", "cicloidal", "--lang", "es"]);
    let shown = stdout(&spanish);
    assert!(
        shown.contains("cycloidal") && shown.contains("cicloidal"),
        "{shown}"
    );
    // Scenes take both names in any language, and so does the catalogue.
    let english = stdout(&gaitcam(&["laws", "cicloidal", "--lang", "en"]));
    assert_eq!(english, stdout(&gaitcam(&["laws", "cycloidal"])));
    let all = stdout(&gaitcam(&["laws", "--lang", "es"]));
    assert!(all.contains("sinusoidal modificada"), "{all}");
    for (typed, language, says) in [
        ("cycloydal", "en", "did you mean `cycloidal`?"),
        ("cicloydal", "es", "¿quiso decir `cycloidal`?"),
        ("senoidal modificada", "es", "¿quiso decir `modified-sine`?"),
    ] {
        let run = gaitcam(&["laws", typed, "--lang", language]);
        assert_eq!(run.status.code(), Some(2));
        assert!(stderr(&run).contains(says), "{}", stderr(&run));
    }
}

#[test]
fn the_check_of_a_bore_names_the_radius_that_it_judges() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let run = |language: &str| {
        stdout(&gaitcam(&[
            "synth",
            "footbridge",
            "--set",
            "cam.bore=40 mm",
            "--out",
            out,
            "--lang",
            language,
        ]))
    };
    let shown = run("en");
    assert!(
        shown.contains("base_outside_bore 30 mm (limit 20 mm)"),
        "{shown}"
    );
    let shown = run("es");
    assert!(
        shown.contains("radio base fuera del agujero 30 mm (límite 20 mm)"),
        "{shown}"
    );
}

#[test]
fn the_load_models_are_listed_with_their_key() {
    let keys = stdout(&gaitcam(&["keys", "gait.model"]));
    for model in ["young", "iso-22675", "sci-p354", "setra"] {
        assert!(keys.contains(model), "{model}: {keys}");
    }
}

#[test]
fn a_run_without_a_command_says_what_it_designs() {
    let folder = tempfile::tempdir().unwrap();
    let run = run_in(folder.path(), &[]);
    assert_eq!(run.status.code(), Some(0));
    assert!(stderr(&run).starts_with(
        "gaitcam: No command is given, so the cam of the built-in scene footbridge is designed."
    ));
}

#[test]
fn a_missing_recording_is_named_with_scene_and_key() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.toml"), "[gait]\nfile = \"nix.csv\"\n").unwrap();
    let run = run_in(folder.path(), &["synth", "a.toml"]);
    assert_eq!(
        stderr(&run),
        "gaitcam: a.toml: gait.file: the file \"nix.csv\" does not exist\n"
    );
}

#[test]
fn words_near_a_law_or_follower_of_either_language_are_suggested() {
    for (typed, meant) in [
        ("harmonica", "simple-harmonic"),
        ("trapecio", "modified-trapezoid"),
        ("trapezoidal", "modified-trapezoid"),
        ("repos", "dwell"),
        ("cycloidle", "cycloidal"),
    ] {
        let told = stderr(&gaitcam(&["laws", typed]));
        assert!(told.contains(&format!("did you mean `{meant}`?")), "{told}");
    }
    for (typed, meant) in [
        ("plano-traslante", "flat-translating"),
        ("rodilo", "roller-translating"),
        ("knife-translatng", "knife-translating"),
    ] {
        let change = format!("cam.follower={typed}");
        let told = stderr(&gaitcam(&["synth", "--set", &change]));
        assert!(
            told.contains(&format!("did you mean \"{meant}\"?")),
            "{told}"
        );
    }
}

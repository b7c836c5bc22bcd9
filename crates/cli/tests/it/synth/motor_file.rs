//! File of a motor's torque curve. Faults name the curve, the file and the line.

use std::fs;

use crate::support::{run_in, stderr, stdout};

const SCENE: &str = "[gait]\nmodel = \"young\"\nstep_frequency = \"1.85 Hz\"\nbody_weight = \"700 N\"\n\
                     [machine]\ninertia = \"0.5 kg m^2\"\n[machine.motor]\ncurve = \"motor.csv\"\n";

/// Error message for the file content in a language. The program must reject it as invalid input.
fn refusal(content: &str, language: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.toml"), SCENE).unwrap();
    fs::write(folder.path().join("motor.csv"), content).unwrap();
    let output = run_in(folder.path(), &["synth", "scene.toml", "--lang", language]);
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    stderr(&output)
}

#[test]
fn faults_of_a_motor_curve_speak_of_a_torque_curve() {
    let header = "speed_rad_per_s,torque_n_m";
    let one_row = format!("{header}\n0,10\n");
    let rising = format!("{header}\n0,10\n10,11\n");
    let word = format!("{header}\n0,10\n5,9\n10,much\n");
    for (content, named) in [
        (
            "hello world\n",
            ["starts with \"hello world\"", "torque curve"],
        ),
        (
            "a,b\n1,2\n2,1\n",
            ["motor.csv line 1: the torque curve", "columns: a, b"],
        ),
        (&one_row, ["machine.motor.curve", "at least two rows"]),
        (&rising, ["motor.csv line 3", "decreasing torques"]),
        (&word, ["motor.csv line 4", "\"much\" is not a number"]),
    ] {
        let said = refusal(content, "en");
        assert!(
            named.iter().all(|part| said.contains(part)),
            "{content}: {said}"
        );
        assert!(!said.contains("recording"), "{said}");
    }
    let said = refusal("a,b\n1,2\n2,1\n", "es");
    assert!(
        said.contains("motor.csv línea 1: la curva de par"),
        "{said}"
    );
    let said = refusal("hola\n", "es");
    assert!(said.contains("la curva de par de un motor"), "{said}");
}

#[test]
fn a_law_for_constant_speed_says_nothing_of_iterations() {
    let folder = tempfile::tempdir().unwrap();
    let scene = SCENE.replace("curve = \"motor.csv\"", "slope = \"10 N m s/rad\"");
    fs::write(folder.path().join("scene.toml"), scene).unwrap();
    for (language, error, iterations) in [
        ("en", "force error over time", " iterations"),
        ("es", "error de fuerza en el tiempo", " iteraciones"),
    ] {
        let said = |shaft: &str| {
            let arguments = ["synth", "scene.toml", "--set", shaft, "--lang", language];
            let said = stdout(&run_in(folder.path(), &arguments));
            assert!(said.contains(error), "{said}");
            said.contains(iterations)
        };
        assert!(said("law.shaft=motor"));
        assert!(!said("law.shaft=constant"));
    }
}

//! Infeasible cams of the command. Each message names the cause and a correction.

use std::fs;

use serde_json::Value;

use crate::support::{ROOT, both, changed, gaitcam};

/// Exit code and both outputs of a synthesis of `text` with changes.
fn synth(text: &str, changes: &[&str]) -> (i32, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    fs::write(&path, text).unwrap();
    let to = folder.path().join("out");
    let synth = [
        "synth",
        path.to_str().unwrap(),
        "--out",
        to.to_str().unwrap(),
    ];
    let output = gaitcam(&changed(&synth, changes));
    (output.status.code().unwrap(), both(&output))
}

fn scene(name: &str) -> String {
    fs::read_to_string(format!("{ROOT}/scenes/{name}.toml")).unwrap()
}

#[track_caller]
fn says(answer: (i32, String), code: i32, words: &[&str]) {
    assert_eq!(answer.0, code, "{}", answer.1);
    for word in words {
        assert!(
            answer.1.contains(word),
            "\"{word}\" is missing in: {}",
            answer.1
        );
    }
}

#[test]
fn an_arm_too_short_is_told_how_long_it_must_be() {
    // c 100, Rp 60: the arm must exceed 40 mm.
    let text = scene("camdas_11_oscillating_roller");
    says(
        synth(&text, &["cam.arm=35 mm"]),
        3,
        &["arm", "too short", "40 mm"],
    );
}

#[test]
fn a_pivot_inside_the_cam_is_told_how_far_out_it_belongs() {
    let text = scene("camdas_12_oscillating_flat");
    says(
        synth(&text, &["cam.pivot_beside=false"]),
        3,
        &["pivot", "inside the cam", "pivot distance"],
    );
}

#[test]
fn an_offset_beyond_the_prime_circle_is_refused() {
    let text = scene("camdas_01_roller");
    says(
        synth(&text, &["cam.offset=55 mm"]),
        2,
        &["cam.offset", "prime"],
    );
    let text = scene("mushroom");
    let changes = ["cam.base_radius=10 mm", "cam.offset=-70 mm"];
    says(synth(&text, &changes), 2, &["cam.offset", "prime"]);
}

#[test]
fn an_undercut_cam_is_told_the_smallest_base_radius_that_works() {
    // theory §6: 20 mm cycloidal in 90°, flat face: ρ_min = 7.14737 mm at Rb 40, so 32.85263 mm is the least.
    let text = "name = \"undercut\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"1 rad/s\"\n[law]\nfamily = \"program\"\n\
        [[law.segment]]\nmotion = \"cycloidal\"\nlift = \"20 mm\"\nangle = \"90 deg\"\n[[law.segment]]\nangle = \"90 deg\"\n\
        [[law.segment]]\nmotion = \"cycloidal\"\nlift = \"-20 mm\"\nangle = \"90 deg\"\n[[law.segment]]\nangle = \"90 deg\"\n\
        [cam]\nfollower = \"flat-translating\"\nbase_radius = \"30 mm\"\n";
    says(
        synth(text, &[]),
        3,
        &["unacceptable", "undercut", "−2.853 mm", "32.86 mm"],
    );
    says(
        synth(text, &["cam.base_radius=32.8527 mm"]),
        0,
        &["acceptable"],
    );
}

#[test]
fn angles_that_miss_the_turn_are_counted() {
    let text = scene("camdas_10_eccentric").replacen("180 deg", "175 deg", 1);
    says(
        synth(&text, &[]),
        2,
        &["law.segment", "355", "5° are missing"],
    );
}

#[test]
fn a_motion_that_cannot_join_its_neighbour_says_which_derivative_jumps() {
    let text = scene("camdas_01_roller").replacen("simple-harmonic", "constant-velocity", 1);
    says(synth(&text, &[]), 3, &["segment", "velocity", "jump"]);
}

#[test]
fn a_conjugate_that_cannot_exist_is_told_from_where_on_it_can() {
    // The first follower alone reaches 145 mm.
    let text = scene("camdas_08_conjugate_flat");
    let changes = ["cam.conjugate.distance=140 mm"];
    says(
        synth(&text, &changes),
        3,
        &["cam.conjugate", "145 mm", "at least"],
    );
}

#[test]
fn a_law_without_constant_breadth_is_refused_for_parallel_faces() {
    let text =
        scene("camdas_10_eccentric").replace("base_radius = \"30 mm\"", "breadth = \"80 mm\"");
    says(synth(&text, &[]), 0, &["acceptable"]);
    let text =
        scene("camdas_09_eight_motions").replace("base_radius = \"35 mm\"", "breadth = \"100 mm\"");
    says(
        synth(&text, &[]),
        3,
        &["cam.breadth", "does not have a constant breadth", "180°"],
    );
    let text = scene("camdas_06_constant_breadth");
    says(
        synth(&text, &["cam.breadth=20 mm"]),
        3,
        &["cam.breadth", "30 mm"],
    );
}

#[test]
fn keys_that_a_follower_does_not_have_are_refused() {
    let text = scene("camdas_01_roller");
    says(
        synth(&text, &["cam.arm=50 mm"]),
        2,
        &["cam.arm", "does not apply"],
    );
    let text = scene("camdas_04_oscillating_flat");
    says(
        synth(&text, &["drive.mass=3 kg"]),
        2,
        &["drive.mass", "oscillating", "inertia"],
    );
    says(
        synth(&text, &["cam.folower=barrel"]),
        2,
        &["cam.folower", "follower"],
    );
}

#[test]
fn a_polynomial_whose_velocity_jumps_is_told_its_cure_and_no_relaxation() {
    let text = "name = \"jump\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"60 rpm\"\n[law]\nfamily = \"polynomial\"\n\
        [[law.point]]\nangle = \"0 deg\"\nlift = \"0 mm\"\n[[law.point]]\nangle = \"90 deg\"\nlift = \"10 mm\"\n\
        [[law.point]]\nangle = \"360 deg\"\nlift = \"0 mm\"\n\
        [cam]\nfollower = \"roller-translating\"\nbase_radius = \"50 mm\"\nroller_radius = \"10 mm\"\n";
    let answer = synth(text, &["limits.jerk=100 m/s^3"]);
    assert!(!answer.1.contains("Relaxing"), "{}", answer.1);
    says(
        answer,
        3,
        &[
            "The velocity is discontinuous at 0°",
            "law.point.N.velocity",
        ],
    );
}

/// Readable scenes without a feasible cam: exit code 3, a summary that names the key and the reason, and no other file of an earlier design in the
/// folder. With a value that allows a cam, the same scene is designed.
#[test]
fn where_no_cam_fits_the_summary_is_written_and_names_the_key() {
    let demands = "name = \"demands\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"60 rpm\"\n[law]\nfamily = \"spline\"\n\
        degree = 5\nspans = 8\n[[law.point]]\nangle = \"0 deg\"\nlift = \"0 mm\"\n[[law.point]]\nangle = \"90 deg\"\n\
        lift = \"10 mm\"\n[cam]\nbase_radius = \"50 mm\"\n";
    let contradicting =
        format!("{demands}[[law.dwell]]\nfrom = \"80 deg\"\nto = \"100 deg\"\nlift = \"5 mm\"\n");
    let roller = scene("camdas_01_roller");
    let jump_of_v = roller.replacen("simple-harmonic", "constant-velocity", 1);
    let jump_of_s = roller.replacen("lift = \"-", "lift = \"-1", 1);
    let arm = scene("camdas_02_oscillating_roller");
    let swing = arm.replace("10 deg", "170 deg");
    let (pair, barrel) = (scene("camdas_08_conjugate_flat"), scene("thesis_barrel"));
    let members: [(&str, &str, &[&str], &str); 8] = [
        ("contradicting demands", &contradicting, &[], "law.dwell"),
        ("jump of the velocity", &jump_of_v, &[], "law.segment"),
        ("jump of the lift", &jump_of_s, &[], "law.segment"),
        (
            "beyond the dead centres",
            &swing,
            &["limits.pressure_angle=none"],
            "cam",
        ),
        ("arm too short", &arm, &["cam.arm=20 mm"], "cam"),
        (
            "no base radius",
            &arm,
            &["cam.base_radius=auto", "limits.curvature=10 m"],
            "cam.base_radius",
        ),
        ("no depth", &barrel, &["cam.depth=200 mm"], "cam.depth"),
        (
            "no second cam",
            &pair,
            &["cam.conjugate.distance=140 mm"],
            "cam.conjugate",
        ),
    ];
    for (member, text, changes, key) in members {
        let folder = tempfile::tempdir().unwrap();
        let (path, out) = (folder.path().join("scene.toml"), folder.path().join("out"));
        fs::write(&path, text).unwrap();
        let to = out.to_str().unwrap();
        gaitcam(&["synth", "footbridge", "--no-png", "--out", to]);
        let arguments = ["synth", path.to_str().unwrap(), "--json", "--out", to];
        let output = gaitcam(&changed(&arguments, changes));
        assert_eq!(output.status.code(), Some(3), "{member}: {}", both(&output));
        let printed: Value = serde_json::from_slice(&output.stdout).unwrap();
        let written = fs::read(out.join("summary.json")).unwrap();
        assert_eq!(printed, serde_json::from_slice::<Value>(&written).unwrap());
        assert_eq!(printed["outcome"], "infeasible", "{member}");
        assert_eq!(printed["verdict"], "unacceptable", "{member}");
        assert_eq!(printed["reasons"][0]["key"], key, "{member}");
        assert!(!out.join("law.csv").exists(), "{member}: of another scene");
        let again = gaitcam(&["compare", to, to]);
        assert_eq!(again.status.code(), Some(3), "{member}: {}", both(&again));
    }
}

//! Random readable scenes of every kind without a feasible cam. `synth` and `simulate` return exit code 3, a folder with the summary, and the
//! responsible key.

use std::fs;
use std::path::Path;

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use serde_json::Value;

use crate::support::{both, gaitcam};

/// Number of random scenes of each kind.
const CASES: u32 = 12;

/// Programme with a rise, a dwell and a return of given lifts over given parts of the turn.
fn programme(motion: &str, unit: &str, lifts: [f64; 2], parts: [f64; 3]) -> String {
    let turn: f64 = parts.iter().sum();
    let [up, down] = lifts.map(|lift| format!("{lift} {unit}"));
    let angles = parts.map(|part| 360.0 * part / turn);
    let still = format!("0 {unit}");
    let segments = [(motion, up), ("dwell", still), (motion, down)];
    let lines = segments.iter().zip(angles).map(|((motion, lift), angle)| {
        let lift = if *motion == "dwell" {
            String::new()
        } else {
            format!("lift = \"{lift}\"\n")
        };
        format!("[[law.segment]]\nmotion = \"{motion}\"\n{lift}angle = \"{angle} deg\"\n")
    });
    format!(
        "name = \"no_cam\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"1 rad/s\"\n[law]\nfamily = \"program\"\n{}[cam]\n",
        lines.collect::<String>()
    )
}

/// Strategy for the parts of the turn of the three segments.
fn parts() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(1.0..3.0_f64)
}

fn smooth() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![
        "cycloidal",
        "3-4-5",
        "4-5-6-7",
        "simple-harmonic",
        "modified-sine",
    ])
}

/// Requirements for a spline.
fn demands(rest: &str) -> String {
    format!(
        "name = \"no_cam\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"60 rpm\"\n[law]\nfamily = \"spline\"\ndegree = 5\n\
         spans = 12\n[[law.point]]\nangle = \"0 deg\"\nlift = \"0 mm\"\n{rest}[cam]\nbase_radius = \"50 mm\"\n"
    )
}

fn point(angle: f64, lift: f64) -> String {
    format!("[[law.point]]\nangle = \"{angle} deg\"\nlift = \"{lift} mm\"\n")
}

/// Runs the command on scenes of one kind and asserts the output of verdict.md with one of these keys.
fn no_cam_has_a_summary(scenes: impl Strategy<Value = String>, keys: &[&str]) {
    let mut runner = TestRunner::new(Config {
        cases: CASES,
        failure_persistence: None,
        ..Config::default()
    });
    let answers = runner.run(&scenes, |text| {
        let folder = tempfile::tempdir().unwrap();
        let scene = folder.path().join("scene.toml");
        fs::write(&scene, &text).unwrap();
        for command in ["synth", "simulate"] {
            let out = folder.path().join(command);
            let [scene, to] = [&scene, &out].map(|path| path.to_str().unwrap());
            let output = gaitcam(&[command, scene, "--json", "--out", to]);
            let said = format!("{command} of\n{text}{}", both(&output));
            prop_assert_eq!(output.status.code(), Some(3), "{}", said);
            let printed: Value = serde_json::from_slice(&output.stdout).unwrap();
            let written = summary(&out);
            prop_assert_eq!(&written["outcome"], "infeasible", "{}", said);
            prop_assert_eq!(&written["verdict"], "unacceptable", "{}", said);
            let key = written["reasons"][0]["key"].as_str();
            prop_assert!(key.is_some_and(|key| keys.contains(&key)), "{}", said);
            prop_assert_eq!(printed, written);
        }
        Ok(())
    });
    answers.unwrap();
}

fn summary(folder: &Path) -> Value {
    serde_json::from_slice(&fs::read(folder.join("summary.json")).unwrap()).unwrap()
}

#[test]
fn two_lifts_at_one_angle() {
    let scenes = (20.0..300.0_f64, 1.0..20.0_f64, 0.1..10.0_f64);
    let scenes =
        scenes.prop_map(|(at, lift, more)| demands(&(point(at, lift) + &point(at, lift + more))));
    no_cam_has_a_summary(scenes, &["law.point"]);
}

#[test]
fn a_point_inside_a_dwell_of_another_lift() {
    let scenes = (
        40.0..250.0_f64,
        10.0..80.0_f64,
        0.0..1.0_f64,
        0.0..20.0_f64,
        0.5..10.0_f64,
    );
    let scenes = scenes.prop_map(|(from, length, share, lift, more)| {
        let dwell = format!(
            "[[law.dwell]]\nfrom = \"{from} deg\"\nto = \"{} deg\"\nlift = \"{lift} mm\"\n",
            from + length
        );
        demands(&(point(from + share * length, lift + more) + &dwell))
    });
    // Either of the two could give way; the one at which the elimination finds the contradiction is named.
    no_cam_has_a_summary(scenes, &["law.dwell", "law.point"]);
}

#[test]
fn a_velocity_that_jumps() {
    let scenes = (1.0..40.0_f64, parts()).prop_map(|(lift, parts)| {
        programme("constant-velocity", "mm", [lift, -lift], parts)
            + "follower = \"roller-translating\"\nbase_radius = \"60 mm\"\nroller_radius = \"10 mm\"\n"
    });
    no_cam_has_a_summary(scenes, &["law.segment"]);
}

#[test]
fn a_lift_that_does_not_come_back() {
    let scenes = (smooth(), 5.0..40.0_f64, 0.05..3.0_f64, parts());
    let scenes = scenes.prop_map(|(motion, lift, more, parts)| {
        programme(motion, "mm", [lift, -lift - more], parts)
            + "follower = \"roller-translating\"\nbase_radius = \"60 mm\"\nroller_radius = \"10 mm\"\n"
    });
    no_cam_has_a_summary(scenes, &["law.segment"]);
}

/// Programme of an arm whose pivot is 100 mm from the camshaft. The roller's centre starts on a circle of 50 mm.
fn arm(motion: &str, swing: f64, parts: [f64; 3], arm: f64) -> String {
    programme(motion, "deg", [swing, -swing], parts)
        + &format!(
            "follower = \"roller-oscillating\"\nbase_radius = \"40 mm\"\nroller_radius = \"10 mm\"\n\
             pivot_distance = \"100 mm\"\narm = \"{arm} mm\"\n[limits]\npressure_angle = \"none\"\n"
        )
}

#[test]
fn an_arm_that_does_not_reach_the_cam() {
    // |c − Rp| = 50 mm.
    let scenes = (smooth(), 1.0..20.0_f64, parts(), 5.0..49.0_f64);
    let scenes =
        scenes.prop_map(|(motion, swing, parts, length)| arm(motion, swing, parts, length));
    no_cam_has_a_summary(scenes, &["cam"]);
}

#[test]
fn an_arm_that_swings_beyond_its_dead_centres() {
    // An arm of 60 to 140 mm starts at most 90° from the line of centres.
    let scenes = (smooth(), 155.0..175.0_f64, parts(), 60.0..140.0_f64);
    let scenes =
        scenes.prop_map(|(motion, swing, parts, length)| arm(motion, swing, parts, length));
    no_cam_has_a_summary(scenes, &["cam"]);
}

#[test]
fn a_base_radius_that_is_sought_and_does_not_exist() {
    // No arm of less than its pivot's distance carries a profile as flat as this everywhere.
    let scenes = (smooth(), 3.0..20.0_f64, parts(), 1.0..50.0_f64);
    let scenes = scenes.prop_map(|(motion, swing, parts, radius)| {
        let text = arm(motion, swing, parts, 80.0).replace("\"40 mm\"", "\"auto\"");
        text + &format!("curvature = \"{radius} m\"\n")
    });
    no_cam_has_a_summary(scenes, &["cam.base_radius"]);
}

#[test]
fn a_groove_deeper_than_its_barrel() {
    let scenes = (smooth(), 5.0..40.0_f64, parts(), 1.0..200.0_f64);
    let scenes = scenes.prop_map(|(motion, lift, parts, more)| {
        programme(motion, "mm", [lift, -lift], parts)
            + &format!(
                "follower = \"barrel\"\nbase_radius = \"30 mm\"\nroller_radius = \"5 mm\"\ndepth = \"{} mm\"\n",
                30.0 + more
            )
    });
    no_cam_has_a_summary(scenes, &["cam.depth"]);
}

#[test]
fn a_second_cam_that_lies_too_near() {
    // The first follower alone reaches base radius and lift.
    let scenes = (smooth(), 5.0..40.0_f64, parts(), 0.2..0.99_f64);
    let scenes = scenes.prop_map(|(motion, lift, parts, share)| {
        let reach = 100.0 + lift;
        programme(motion, "mm", [lift, -lift], parts)
            + &format!(
                "follower = \"flat-translating\"\nbase_radius = \"100 mm\"\n[cam.conjugate]\ndistance = \"{} mm\"\n",
                share * reach
            )
    });
    no_cam_has_a_summary(scenes, &["cam.conjugate"]);
}

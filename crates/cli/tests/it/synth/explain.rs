//! `gaitcam synth --explain`: the richer choice never moves the force by more than the accuracy stated.

use std::cell::Cell;

use assert_cmd::Command;
use gaitcam::force::{Feet, ForceCurve, model};
use gaitcam::scene::{self, Scene};
use gaitcam::synth::synthesise;
use gaitcam_cli::synth::explain::choices::{choices, chord_error, force_change, force_of_points};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// Scenes tried.
const CASES: u32 = 48;

fn read(changes: &[String]) -> Scene {
    let mut table: toml::Table = scene::DEFAULT.parse().unwrap();
    for change in changes {
        scene::set(&mut table, change).unwrap();
    }
    scene::read(&table).unwrap()
}

fn walker(frequency: f64) -> ForceCurve {
    model("young", Some(frequency), 700.0, Feet::Both).unwrap()
}

/// The law's own RMS error or the accuracy asked, whichever is larger: nested projections (see
/// `gaitcam_cli::synth::explain`) cannot differ by more.
fn allowed(scene: &Scene, target: &ForceCurve, own: f64) -> f64 {
    own.max(scene.rms.unwrap_or(0.0) * target.mean_n())
}

#[test]
fn richer_choices_move_the_force_by_less_than_the_stated_accuracy() {
    let scenes = (
        1.4..2.4_f64,
        prop::sample::select(vec!["spline", "harmonic"]),
        prop::option::of(0.4..1.2_f64),
        0.2..2.0_f64,
    );
    let mut runner = TestRunner::new(Config {
        cases: CASES,
        failure_persistence: None,
        ..Config::default()
    });
    let compared = Cell::new(0);
    runner
        .run(&scenes, |(frequency, family, jerk, percent)| {
            let target = walker(frequency);
            let mut changes = vec![
                format!("gait.step_frequency={frequency} Hz"),
                format!("law.family={family}"),
                format!("accuracy.rms={percent} %"),
                "limits.stroke=1 m".to_string(),
            ];
            // A typical jerk grows with the square of the walking speed: 150 m/s³ at 1.85 Hz.
            let most = jerk.map(|part| part * 150.0 * (frequency / 1.85).powi(2));
            changes.extend(most.map(|j| format!("limits.jerk={j} m/s^3")));
            let scene = read(&changes);
            let design = synthesise(&scene, Some(&target)).unwrap();
            if design.infeasible.is_some() {
                return Ok(());
            }
            let most = allowed(&scene, &target, design.force.rms_error_n);
            for choice in choices(&scene, &design) {
                let nested = matches!(choice.subject, "spans" | "harmonics");
                let Some(richer) = choice.richer.filter(|_| nested) else {
                    continue;
                };
                let other = synthesise(&richer, Some(&target)).unwrap();
                let change = force_change(&design, &other);
                prop_assert!(
                    change <= most * (1.0 + 1e-3),
                    "{changes:?}: {} moves by {change} N, {most} N stated",
                    choice.subject
                );
                compared.set(compared.get() + 1);
            }
            Ok(())
        })
        .unwrap();
    // A jerk limit alone leaves a law: most scenes are built, and each has a richer size.
    assert!(compared.get() >= CASES / 2, "{} compared", compared.get());
}

#[test]
fn twice_the_points_change_the_force_by_less_than_the_accuracy_and_quarter_the_chords() {
    let target = walker(1.85);
    let design = synthesise(&read(&[]), Some(&target)).unwrap();
    let (one, two) = (
        chord_error(&design.cam, 1440),
        chord_error(&design.cam, 2880),
    );
    assert!((one / two - 4.0).abs() < 0.05, "{one} {two}");
    let (coarse, fine) = (
        force_of_points(&design, 1440).unwrap(),
        force_of_points(&design, 2880).unwrap(),
    );
    assert!(fine < coarse && coarse < 0.005 * target.mean_n() / 100.0);
}

#[test]
fn the_command_names_every_choice_with_its_number_and_the_cost_of_the_next() {
    let out = tempfile::tempdir().unwrap();
    let run = Command::cargo_bin("gaitcam")
        .unwrap()
        .args(["synth", "--explain", "--out"])
        .arg(out.path().join("d"))
        .assert()
        .success();
    let text = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
    for subject in ["family", "spans", "solver", "dynamics", "points"] {
        assert!(
            text.contains(&format!("\n  {subject}")),
            "{subject}: {text}"
        );
    }
    assert!(text.contains("0.5000 % is allowed") && text.contains("N RMS"));
    let summary = std::fs::read_to_string(out.path().join("d/summary.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&summary).unwrap();
    assert_eq!(json["explain"].as_array().unwrap().len(), 5);
}

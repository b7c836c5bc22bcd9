//! Numbers of every size, and targets of every shape.

use std::f64::consts::TAU;

use gaitcam::force::ForceCurve;
use gaitcam::scene;
use gaitcam::synth::synthesise;

use super::{design, finite};

/// Very small and very large forces: the relative result does not change.
#[test]
fn units_may_be_tiny_or_huge() {
    let usual = design(&[]).unwrap();
    for weight in ["1e-6 N", "1e-3 N", "1e4 N", "1e9 N"] {
        let answer = design(&[&format!("gait.body_weight={weight}")]).unwrap();
        finite(&answer);
        let (a, b) = (
            answer.force.rms_error_percent_of_mean,
            usual.force.rms_error_percent_of_mean,
        );
        assert!((a - b).abs() < 1e-6 * b, "{weight}: {a} {b}");
        let (a, b) = (answer.cam.law.stroke(), usual.cam.law.stroke());
        assert!((a / b - 1.0).abs() < 1e-9, "{weight}: stroke {a} {b}");
    }
}

/// Subnormal numbers lead to finite numbers or to an error with its reason. Huge numbers are rejected.
#[test]
fn denormals_and_giants_are_answered_or_refused_by_name() {
    for (change, refusal) in [
        ("gait.body_weight=1e-310 N", Some("synth-no-law")),
        ("gait.body_weight=1e300 N", Some("units-out-of-range")),
        ("drive.mass=1e-310 kg", Some("synth-no-law")),
        ("drive.mass=1e300 kg", Some("units-out-of-range")),
        (
            "drive.speed=1e-310 rad/s",
            Some("synth-no-lift-changes-force"),
        ),
        ("drive.speed=1e200 rad/s", Some("units-out-of-range")),
        ("limits.stroke=1e-310 m", None),
        ("limits.jerk=1e-310 m/s^3", None),
        (
            "limits.acceleration=1e300 m/s^2",
            Some("units-out-of-range"),
        ),
        ("limits.curvature=1e-310 m", None),
        ("cam.base_radius=1e-310 m", Some("scene-base-in-bore")),
        ("accuracy.rms=1e-310 %", None),
    ] {
        let answer = design(&[change]);
        let code = answer.as_ref().err().map(|e| e.code());
        assert_eq!(code.as_deref(), refusal, "{change}");
        if let Ok(answer) = &answer {
            finite(answer);
        }
    }
}

/// A constant force with a spike of a nanonewton, and a force with jumps of a thousand times its mean.
#[test]
fn ill_scaled_targets_keep_their_mean() {
    let n = 512;
    let spike = |size: f64| {
        let force = (0..n)
            .map(|i| 700.0 + if i == 100 { size } else { 0.0 })
            .collect();
        ForceCurve::from_samples("spike", 1.0, force).unwrap()
    };
    let scene = scene::parse(scene::DEFAULT).unwrap();
    for size in [1e-9, 1e-3, 7e5] {
        let answer = synthesise(&scene, Some(&spike(size))).unwrap();
        finite(&answer);
        assert!((answer.force.mean_n / answer.force.target_mean_n - 1.0).abs() < 1e-9);
    }
}

/// Lift and derivatives are continuous across 2π, as at every other joint.
#[test]
fn laws_join_across_the_turn() {
    let answer = design(&["limits.jerk=150 m/s^3"]).unwrap();
    let law = &answer.cam.law;
    let last = law.breaks().len() - 2;
    let (a, b) = (law.svaj_on(last, 1.0), law.svaj_on(0, 0.0));
    let (low, high) = law.extremes(3);
    let scale = high.value.max(-low.value);
    for (x, y) in [(a.s, b.s), (a.v, b.v), (a.a, b.a), (a.j, b.j)] {
        assert!((x - y).abs() < 1e-11 * scale, "{x} {y}");
    }
    for k in [-3.0, -1.0, 1.0, 1e3] {
        let moved = law.svaj(1.0 + k * TAU);
        assert!((moved.s - law.svaj(1.0).s).abs() < 1e-12 * k.abs().max(1.0));
    }
    // A force with a step at the end of the turn is followed without overshoot above the size of the step.
    let step: Vec<f64> = (0..512)
        .map(|i| 600.0 + 200.0 * f64::from(i) / 512.0)
        .collect();
    let target = ForceCurve::from_samples("saw", 1.0, step).unwrap();
    let scene = scene::parse(scene::DEFAULT).unwrap();
    let answer = synthesise(&scene, Some(&target)).unwrap();
    finite(&answer);
    assert!(answer.force.max_error_n < 200.0);
}

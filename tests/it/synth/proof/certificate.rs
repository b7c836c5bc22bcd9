//! The proof that comes with a law says what a second solve confirms.

use gaitcam::scene;
use gaitcam::synth::Design;

fn solved(changes: &[&str]) -> Design {
    gaitcam_test_support::design(scene::DEFAULT, changes).unwrap()
}

#[test]
fn easing_a_limit_buys_what_the_multipliers_promise() {
    let cases = [
        ("limits.jerk", 60.0, "m/s^3", "jerk"),
        ("limits.acceleration", 3.5, "m/s^2", "acceleration"),
        ("limits.stroke", 40.0, "mm", "stroke"),
        ("limits.force_min", 560.0, "N", "force_min"),
        ("limits.force_max", 900.0, "N", "force_max"),
    ];
    for (key, value, unit, name) in cases {
        let base = ["law.spans=24", "law.family=spline"];
        let at = |value: f64| {
            let own = format!("{key}={value} {unit}");
            solved(&[base[0], base[1], own.as_str()])
        };
        let first = at(value);
        let easing = first
            .easing
            .iter()
            .find(|e| e.limit.name() == name)
            .unwrap_or_else(|| panic!("{name} binds: {:?}", first.binding));
        assert!(
            (easing.before - first.force.rms_error_n).abs() < 1e-4,
            "{name}: {} {}",
            easing.before,
            first.force.rms_error_n
        );
        // Half the mean square falls by λ·(easing) to first order; a hundredth of the easing is near it.
        let promised = 0.5 * (easing.before.powi(2) - easing.after.powi(2));
        let small = value * (easing.to / easing.from - 1.0) / 100.0;
        let second = at(value + small);
        let got = 0.5 * (first.force.rms_error_n.powi(2) - second.force.rms_error_n.powi(2));
        assert!(
            (100.0 * got / promised - 1.0).abs() < 0.02,
            "{name}: {got} against {promised}/100"
        );
        // The whole easing cannot buy more: the least error is convex in the limit.
        let third = at(value * easing.to / easing.from);
        let whole = 0.5 * (first.force.rms_error_n.powi(2) - third.force.rms_error_n.powi(2));
        assert!(
            whole > 0.5 * promised && whole < promised * (1.0 + 1e-6),
            "{name}: {whole} {promised}"
        );
    }
}

#[test]
fn a_certificate_closes_the_gap() {
    let design = solved(&["law.spans=32", "law.family=spline", "limits.jerk=60 m/s^3"]);
    let proof = design.solver.certificate.unwrap();
    // A part of the error's own half mean square, a millionth of the force's.
    assert!(proof.relative_gap < 1e-8, "{proof:?}");
    assert!(proof.stationarity < 1e-9, "{proof:?}");
    assert!(proof.violation <= 1e-9, "{proof:?}");
}

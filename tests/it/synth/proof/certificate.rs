//! The certificate of a law agrees with a second, independent solution.

use gaitcam::scene;
use gaitcam::synth::{Design, Doubt};

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

/// Law of open level under limits that depend on its lift. If every touching angle is bounded, the gap holds for all laws. If the angle was found by
/// a search, the gap is that of one angle. The gap of all laws is then unknown, with or without a sequence.
#[test]
fn a_gap_of_all_laws_is_stated_only_where_every_touching_angle_is_bounded() {
    let face = [
        "law.spans=12",
        "law.family=spline",
        "cam.follower=flat-translating",
        "cam.base_radius=20 mm",
        "limits.curvature=40 mm",
        "accuracy.rms=8 %",
    ];
    let mut counts = [0; 2];
    for (objective, torque) in [
        ("force-error", None),
        ("acceleration", None),
        ("jerk", None),
        ("peak-acceleration", None),
        ("peak-jerk", None),
        ("peak-force-error", None),
        ("force-error", Some("limits.torque=15 N m")),
        ("peak-force-error", Some("limits.torque=15 N m")),
    ] {
        let minimise = format!("law.minimise={objective}");
        let changes: Vec<&str> = face.into_iter().chain([&*minimise]).chain(torque).collect();
        let design = solved(&changes);
        let proof = design.solver.certificate.unwrap();
        let is_searched = objective.starts_with("peak");
        if torque.is_none() {
            let doubt = design.solver.doubt == Some(Doubt::TouchingAngle);
            assert_eq!(doubt, is_searched, "{changes:?}: {:?}", design.solver);
        }
        assert_eq!(
            proof.global_gap.is_none(),
            is_searched,
            "{changes:?}: {proof:?}"
        );
        let written = serde_json::to_value(proof).unwrap();
        assert_eq!(written["global_gap"].is_null(), is_searched, "{written}");
        counts[usize::from(is_searched)] += 1;
    }
    assert!(counts.iter().all(|n| *n > 2), "{counts:?}");
}

/// A limit on the size is used fully. No reserve of the program hides a better law.
#[test]
fn the_optimum_under_a_limit_on_the_size_is_that_of_the_limit_as_written() {
    const SCENE: &str = r#"
name = "size"
[drive]
kind = "fixed-axis"
speed = "9.989 rad/s"
mass = "2 kg"
preload = "80 N"
[cam]
follower = "roller-translating"
roller_radius = "2 mm"
[limits]
pressure_angle = "25.71 deg"
[law]
family = "spline"
degree = 7
spans = 32
minimise = "jerk"
[[law.point]]
angle = "0 deg"
lift = "0 mm"
velocity = "0 mm/rad"
[[law.point]]
angle = "270 deg"
lift = "16.035 mm"
velocity = "0 mm/rad"
[[law.point]]
angle = "315 deg"
lift = "19.049 mm"
"#;
    for (offset, limit) in [("3 mm", 59.61), ("0 mm", 61.0), ("-4 mm", 62.0)] {
        let of = |limit: f64| {
            let radius = format!("limits.prime_radius={limit} mm");
            let offset = format!("cam.offset={offset}");
            gaitcam_test_support::design_of(SCENE, &[&radius, &offset])
        };
        let (own, wider) = (of(limit), of(limit * (1.0 + 1e-5)));
        let radius = 1e3 * own.cam.follower.prime_radius();
        assert!(
            own.solver.certified && (radius / limit - 1.0).abs() < 1e-9,
            "{offset} {radius}"
        );
        // The law changes with the limit: it is active.
        let [own, wider] = [&own, &wider].map(|d| d.solver.certificate.unwrap().size);
        assert!(wider < own * (1.0 - 1e-6), "{offset} {own} {wider}");
    }
}

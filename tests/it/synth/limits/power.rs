//! Limit on the shaft power: a closed form, an active limit, and an infeasible one.

use gaitcam::cam::Check;
use gaitcam::scene::{self};
use gaitcam::synth::{Design, synthesise};
use gaitcam_test_support::{design_of, scene_of};

fn power(s: &Design) -> &Check {
    s.checks.iter().find(|c| c.name.name() == "power").unwrap()
}

/// Eccentric of e = 10 mm with a flat face: s = e(1 − cos θ), F = m(g + ω²e cos θ). Hence P = m ω e sin θ (g + ω²e cos θ), with its maximum where 2k
/// cos²θ + cos θ = k with k = ω²e/g.
#[test]
fn the_power_of_an_eccentric_is_its_closed_form() {
    let text = r#"
        name = "eccentric"
        [drive]
        kind = "moving-axis"
        mass = "3 kg"
        speed = "20 rad/s"
        [law]
        family = "program"
        [[law.segment]]
        motion = "simple-harmonic"
        lift = "20 mm"
        angle = "180 deg"
        [[law.segment]]
        motion = "simple-harmonic"
        lift = "-20 mm"
        angle = "180 deg"
        [cam]
        follower = "flat-translating"
        base_radius = "20 mm"
        [limits]
        power = "7 W"
    "#;
    let (m, g, w, e) = (3.0, 9.81, 20.0_f64, 0.01);
    let k = w * w * e / g;
    let cos = ((1.0 + 8.0 * k * k).sqrt() - 1.0) / (4.0 * k);
    let most = m * w * e * (1.0 - cos * cos).sqrt() * (g + w * w * e * cos);
    let s = design_of(text, &[]);
    let check = power(&s);
    assert!((check.worst / most - 1.0).abs() < 1e-9, "{check:?} {most}");
    assert!(
        (check.at - cos.acos()).abs() < 1e-6
            || (check.at + cos.acos() - std::f64::consts::TAU).abs() < 1e-5
    );
    assert_eq!(check.pass, most <= 7.0);
    assert!(power(&design_of(text, &["limits.power=6.8 W"])).pass == (most <= 6.8));
}

#[test]
fn a_power_limit_shapes_the_law_as_the_same_torque_does() {
    let open = ["accuracy.rms=50 %", "law.spans=12"];
    let free = design_of(
        scene::DEFAULT,
        &[&open[..], &["limits.power=1 kW"]].concat(),
    );
    let (most, speed) = (power(&free).worst, free.problem.drive.speed);
    let held = |limit: String| design_of(scene::DEFAULT, &[&open[..], &[limit.as_str()]].concat());
    let by_power = held(format!("limits.power={} W", 0.85 * most));
    let by_torque = held(format!("limits.torque={} N m", 0.85 * most / speed));
    let check = power(&by_power);
    assert!(by_power.infeasible.is_none() && check.pass, "{check:?}");
    assert!(check.worst > 0.999 * check.limit, "{check:?}");
    assert!(by_power.binding.iter().any(|b| b.limit.name() == "power"));
    let error = |s: &Design| s.force.rms_error_n;
    assert!(error(&by_power) > error(&free));
    assert!((error(&by_power) / error(&by_torque) - 1.0).abs() < 1e-6);
    let largest = by_torque
        .coefficients
        .iter()
        .fold(0.0_f64, |m, c| m.max(c.abs()));
    for (p, t) in by_power.coefficients.iter().zip(&by_torque.coefficients) {
        assert!((p - t).abs() < 1e-6 * largest, "{p} {t}");
    }
}

#[test]
fn a_power_that_leaves_no_law_is_named_with_its_relaxation() {
    // A band keeps the force, so the follower cannot rest.
    let changes = ["gait.band=15 N", "law.spans=12"];
    let force = gaitcam_test_support::young();
    let with = |limit: &str| {
        let scene = scene_of(scene::DEFAULT, &[&changes[..], &[limit]].concat());
        let design = synthesise(&scene, Some(&force)).unwrap();
        (scene, design)
    };
    let most = power(&with("limits.power=1 kW").1).worst;
    let (_, refused) = with(&format!("limits.power={} W", 0.5 * most));
    let s = refused.relaxed();
    let why = s.infeasible.unwrap();
    assert_eq!(why.names(), ["band", "power"], "{:?}", why.reasons);
    let one = why.relaxations.iter().find(|r| r.key == "limits.power");
    let to = one.and_then(|r| r.to).unwrap();
    assert!(to > 0.5 * most && to < 1.01 * most, "{to} {most}");
    let eased = with(&format!("limits.power={to} W")).1;
    assert!(eased.infeasible.is_none() && power(&eased).pass);
}

//! Every limit of the key table is checked on the finished design.

use gaitcam::cam::{Check, Verdict};
use gaitcam::criterion::Direction;
use gaitcam::criterion::LimitKind;
use gaitcam::force::ForceCurve;
use gaitcam::scene;
use gaitcam::scene::Scene;
use gaitcam::scene::keys;
use gaitcam::synth::{Design, synthesise};

const RISE_AND_FALL: &str = r#"
name = "rise and fall"
[drive]
kind = "fixed-axis"
mass = "1 kg"
preload = "50 N"
damping = "20 N s/m"
speed = "60 rpm"
[machine]
natural_frequency = "20 Hz"
[law]
family = "program"
[[law.segment]]
motion = "3-4-5"
lift = "20 mm"
angle = "60 deg"
[[law.segment]]
motion = "3-4-5"
lift = "-20 mm"
angle = "60 deg"
[[law.segment]]
motion = "dwell"
angle = "240 deg"
[cam]
follower = "roller-translating"
roller_radius = "5 mm"
prime_radius = "60 mm"
"#;

/// Scene with a flat face, the only follower with a face width.
fn with_flat_face() -> String {
    RISE_AND_FALL
        .replace("roller-translating", "flat-translating")
        .replace("roller_radius = \"5 mm\"\n", "")
        .replace("prime_radius = \"60 mm\"", "base_radius = \"100 mm\"")
}

/// Scene with a free law on which a limit may act.
fn with_free_law(kind: LimitKind) -> Scene {
    let changes: &[(&str, &str)] = match kind {
        LimitKind::PressureAngle
        | LimitKind::PressureAngleRise
        | LimitKind::PressureAngleFall
        | LimitKind::PrimeRadius => &[
            ("cam.follower", "roller-translating"),
            ("cam.roller_radius", "10 mm"),
        ],
        LimitKind::HertzPressure => &[("cam.base_radius", "60 mm")],
        _ => &[],
    };
    if matches!(kind, LimitKind::Residual | LimitKind::PowerMean) {
        return scene::parse(WITH_DWELLS).unwrap();
    }
    let start = scene::built_in("footbridge").unwrap().scene().unwrap();
    let mut table = start.to_table();
    for (key, text) in changes
        .iter()
        .chain(&[("accuracy.rms", "none"), ("law.spans", "12")])
    {
        scene::set(&mut table, &format!("{key}={text}")).unwrap();
    }
    scene::read(&table).unwrap()
}

const WITH_DWELLS: &str = r#"
name = "dwells"
[drive]
kind = "fixed-axis"
speed = "20 rad/s"
mass = "1 kg"
spring_rate = "2000 N/m"
damping = "20 N s/m"
preload = "400 N"
[machine]
natural_frequency = "30 Hz"
[law]
family = "spline"
spans = 24
minimise = "jerk"
[[law.dwell]]
from = "240 deg"
to = "360 deg"
lift = "0 mm"
[[law.dwell]]
from = "100 deg"
to = "150 deg"
lift = "12 mm"
[cam]
follower = "flat-translating"
base_radius = "200 mm"
"#;

/// Design with a bound on one limit.
fn bounded(scene: &Scene, force: Option<&ForceCurve>, kind: LimitKind, bound: f64) -> Design {
    let mut scene = scene.clone();
    scene.limits.set(kind, Some(bound));
    synthesise(&scene, force).unwrap()
}

/// Check of a limit with the smallest margin.
fn check(design: &Design, kind: LimitKind) -> &Check {
    let own = design.checks.iter().filter(|c| kind.is_measured_by(c.name));
    own.max_by(|a, b| a.excess().total_cmp(&b.excess()))
        .unwrap()
}

/// Bound without effect.
fn loose(kind: LimitKind) -> f64 {
    match (kind, kind.facts().direction) {
        (
            LimitKind::PressureAngle | LimitKind::PressureAngleRise | LimitKind::PressureAngleFall,
            _,
        ) => 1.55,
        (LimitKind::Curvature, _) => 0.0,
        (_, Direction::AtMost) => 1e12,
        (_, Direction::AtLeast) => -1e12,
    }
}

#[test]
fn every_limit_that_binds_is_reached_and_easing_it_helps() {
    for &kind in LimitKind::ALL {
        let scene = with_free_law(kind);
        let force = scene.model_force().unwrap();
        let free = bounded(&scene, force.as_ref(), kind, loose(kind));
        let own = check(&free, kind).worst;
        let inside = -0.03 * kind.facts().direction.sign();
        let bound = own + inside * own.abs();
        let design = bounded(&scene, force.as_ref(), kind, bound);
        assert_ne!(
            design.verdict,
            Verdict::Unacceptable,
            "{kind:?}: {:?}",
            design.reasons
        );
        let reached = check(&design, kind);
        let apart = reached.excess().abs();
        assert!(
            reached.pass && apart <= 1e-5 * bound.abs(),
            "{kind:?}: {reached:?}"
        );
        for easing in design
            .easing
            .iter()
            .filter(|e| kind.is_measured_by(e.limit))
        {
            let eased = kind.facts().direction.sign() * (easing.to - easing.from);
            assert!(
                eased > 0.0 && easing.after < easing.before,
                "{kind:?}: {easing:?}"
            );
        }
    }
}

#[test]
fn every_limit_that_is_too_tight_fails_and_its_relaxation_is_in_its_direction() {
    for &kind in LimitKind::ALL {
        let text = match kind {
            LimitKind::FaceWidth => with_flat_face(),
            _ => RISE_AND_FALL.to_string(),
        };
        let scene = scene::parse(&text).unwrap();
        let direction = kind.facts().direction;
        let own = check(&bounded(&scene, None, kind, loose(kind)), kind).worst;
        let tight = own - direction.sign() * 0.5 * own.abs();
        let design = bounded(&scene, None, kind, tight);
        let measured = design.checks.iter().filter(|c| kind.is_measured_by(c.name));
        let failed: Vec<bool> = measured.map(|c| c.pass).collect();
        assert!(!failed.is_empty(), "{kind:?} has no check");
        assert!(!failed.contains(&true), "{kind:?}: {:?}", design.checks);
        let relaxed = design.relaxed();
        let own = relaxed
            .relaxations
            .iter()
            .find(|r| kind.is_measured_by(r.limit) || r.limit == kind);
        let relaxation = own.unwrap_or_else(|| panic!("{kind:?}: {:?}", relaxed.reasons));
        let to = relaxation.to.unwrap();
        assert!(
            direction.sign() * (to - tight) > 0.0,
            "{kind:?}: {relaxation:?}"
        );
        let passing = bounded(&scene, None, kind, to);
        assert!(check(&passing, kind).pass, "{kind:?}: {to}");
        assert_eq!(keys::of_limit(kind).unwrap().name(), kind.name());
    }
}

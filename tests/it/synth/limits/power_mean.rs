//! Limit on the mean power of the shaft.

use gaitcam::cam::Check;
use gaitcam::criterion::LimitKind;
use gaitcam::scene::{self, Scene};
use gaitcam::synth::{Design, synthesise};

const DAMPING: f64 = 40.0;
const SPEED: f64 = 10.0;

/// Scene with a spring and a damper on a fixed axis.
fn damped(law: &str, limits: &str) -> Scene {
    let text = format!(
        r#"
name = "damped"
[drive]
kind = "fixed-axis"
mass = "2 kg"
spring_rate = "3000 N/m"
damping = "{DAMPING} N s/m"
preload = "200 N"
speed = "{SPEED} rad/s"
[cam]
follower = "flat-translating"
base_radius = "150 mm"
[limits]
{limits}
[law]
{law}
"#
    );
    scene::parse(&text).unwrap()
}

fn check(design: &Design) -> &Check {
    let own = design
        .checks
        .iter()
        .find(|c| c.name == LimitKind::PowerMean);
    own.unwrap()
}

/// Mean power of the damper, c·mean((ds/dt)²), from samples.
fn used_up(design: &Design) -> f64 {
    let samples = 20_000;
    let square = |i: usize| {
        let theta = (i as f64 + 0.5) / samples as f64 * std::f64::consts::TAU;
        (SPEED * design.cam.law.svaj(theta).v).powi(2)
    };
    DAMPING * (0..samples).map(square).sum::<f64>() / samples as f64
}

#[test]
fn an_eccentric_uses_up_half_the_square_of_its_speed() {
    let law = r#"
family = "program"
[[law.segment]]
motion = "simple-harmonic"
lift = "20 mm"
angle = "180 deg"
[[law.segment]]
motion = "simple-harmonic"
lift = "-20 mm"
angle = "180 deg"
"#;
    let design = synthesise(&damped(law, "power_mean = \"1 W\""), None).unwrap();
    let mean = 0.5 * DAMPING * (0.01 * SPEED).powi(2);
    assert!((check(&design).worst / mean - 1.0).abs() < 1e-9);
    assert!(check(&design).pass);
    assert!((design.machine().power_mean_w.unwrap() / mean - 1.0).abs() < 1e-9);
}

#[test]
fn a_limited_law_uses_up_as_much_as_allowed_and_its_objective_rises() {
    let law = r#"
family = "spline"
spans = 16
minimise = "jerk"
[[law.dwell]]
from = "240 deg"
to = "360 deg"
lift = "0 mm"
[[law.point]]
angle = "120 deg"
lift = "30 mm"
"#;
    let free = synthesise(&damped(law, ""), None).unwrap();
    let own = used_up(&free);
    for part in [0.96, 0.95] {
        let limit = part * own;
        let limits = format!("power_mean = \"{limit} W\"");
        let design = synthesise(&damped(law, &limits), None).unwrap();
        assert!(check(&design).pass, "{part}: {:?}", check(&design));
        let found = used_up(&design);
        assert!(
            (found / limit - 1.0).abs() < 1e-6,
            "{part}: {found} {limit}"
        );
        let easing = design
            .easing
            .iter()
            .find(|e| e.limit == LimitKind::PowerMean);
        let easing = easing.unwrap();
        let eased = format!("power_mean = \"{} W\"", easing.to);
        let next = synthesise(&damped(law, &eased), None).unwrap();
        let after = next.easing.iter().find(|e| e.limit == LimitKind::PowerMean);
        let after = after.unwrap().before;
        let told = (easing.before - easing.after) / (easing.before - after);
        assert!((told - 1.0).abs() < 0.2, "{part}: {easing:?} {after}");
    }
    let refused = synthesise(&damped(law, "power_mean = \"0.1 W\""), None).unwrap();
    let why = refused.infeasible.as_ref().unwrap();
    assert!(
        why.names().contains(&"power_mean".to_string()),
        "{:?}",
        why.names()
    );
}
